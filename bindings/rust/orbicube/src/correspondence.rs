//! Closed surfaces on one triangulation, through spheres or a common polycube, and their blends.

use crate::call::{call, checked, expect_length, Error, Host};
use crate::mesh::Surface;
use crate::sys::correspondence::*;

filled!(/// Options, with their defaults.
    Options, obc_correspondence_options, obc_correspondence_options_init);

handle!(Handle, obc_correspondence, obc_correspondence_destroy);

/// Points of a surface: triangles, and weights at the corners of each.
#[derive(Clone, Debug, Default)]
pub struct Points {
    pub triangles: Vec<u32>,
    pub weights: Vec<[f64; 3]>,
}

/// Maps between the surfaces of a correspondence.
pub struct Maps(Handle);
// Used by any number of threads at once, as the header says.
unsafe impl Send for Maps {}
unsafe impl Sync for Maps {}

impl Maps {
    /// Where points of one surface are on another.
    pub fn map(&self, from: usize, to: usize, points: &Points, host: &mut Host) -> Result<Points, Error> {
        expect_length(points.weights.len(), points.triangles.len(), "weights")?;
        let mut result = points.clone();
        call(host, |host, error| unsafe {
            obc_correspondence_map(self.0.as_ptr(), from, to, points.triangles.as_ptr(), points.weights.as_ptr() as *const f64,
                                   points.triangles.len(), host, result.triangles.as_mut_ptr(),
                                   result.weights.as_mut_ptr() as *mut f64, error)
        })?;
        Ok(result)
    }
    /// Where the vertices of one surface are on another; u32::MAX for a vertex in no triangle.
    pub fn map_vertices(&self, from: usize, to: usize, host: &mut Host) -> Result<Points, Error> {
        let count = unsafe { obc_correspondence_surface_vertex_count(self.0.as_ptr(), from) };
        let mut result = Points { triangles: vec![0; count], weights: vec![[0.0; 3]; count] };
        call(host, |host, error| unsafe {
            obc_correspondence_map_vertices(self.0.as_ptr(), from, to, host, result.triangles.as_mut_ptr(),
                                            result.weights.as_mut_ptr() as *mut f64, error)
        })?;
        Ok(result)
    }
}

/// Surfaces whose vertex i is at corresponding points of all.
#[derive(Clone, Debug, Default)]
pub struct Correspondence {
    pub triangles: Vec<u32>,
    /// Positions on each surface.
    pub positions: Vec<Vec<f64>>,
    /// Positions on the common sphere or polycube.
    pub domain: Vec<f64>,
    /// Quads of a polycube's grid, four vertices each, whose halves are the triangles 2 q and 2 q + 1.
    pub quads: Vec<u32>,
}

impl Correspondence {
    /// The mesh of `orbicube morph`.
    pub fn new(surfaces: &[Surface], options: &Options, host: &mut Host) -> Result<Correspondence, Error> {
        Ok(Correspondence::with_maps(surfaces, options, host)?.0)
    }
    /// The same with the maps between the surfaces.
    pub fn with_maps(surfaces: &[Surface], options: &Options, host: &mut Host) -> Result<(Correspondence, Maps), Error> {
        let views: Vec<_> = surfaces.iter().map(|surface| surface.c).collect();
        let mut out = std::ptr::null_mut();
        call(host, |host, error| unsafe {
            obc_correspondence_create(views.as_ptr(), views.len(), &options.0, host, &mut out, error)
        })?;
        let handle = Handle::own(out);
        let out = handle.as_ptr();
        let mut made = Correspondence::default();
        unsafe {
            made.triangles.resize(3 * obc_correspondence_triangle_count(out), 0);
            for shape in 0..obc_correspondence_shape_count(out) {
                let mut positions = vec![0.0; 3 * obc_correspondence_vertex_count(out)];
                checked(|error| {
                    obc_correspondence_copy(out, shape, positions.as_mut_ptr(), made.triangles.as_mut_ptr(), error)
                })?;
                made.positions.push(positions);
            }
        }
        made.domain.resize(3 * unsafe { obc_correspondence_vertex_count(out) }, 0.0);
        made.quads.resize(4 * unsafe { obc_correspondence_quad_count(out) }, 0);
        checked(|error| unsafe { obc_correspondence_copy_domain(out, made.domain.as_mut_ptr(), error) })?;
        checked(|error| unsafe { obc_correspondence_copy_quads(out, made.quads.as_mut_ptr(), error) })?;
        Ok((made, Maps(handle)))
    }
}
