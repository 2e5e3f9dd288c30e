//! Closed surfaces on one triangulation, through spheres or a common polycube, and their blends.

use crate::call::{call, checked, Error, Host};
use crate::mesh::Surface;
use crate::sys::correspondence::*;

filled!(/// Options, with their defaults.
    Options, obc_correspondence_options, obc_correspondence_options_init);

handle!(Handle, obc_correspondence, obc_correspondence_destroy);

/// Surfaces whose vertex i is at corresponding points of all.
#[derive(Clone, Debug, Default)]
pub struct Correspondence {
    pub triangles: Vec<u32>,
    /// Positions on each surface.
    pub positions: Vec<Vec<f64>>,
}

impl Correspondence {
    /// The mesh of `orbicube morph`.
    pub fn new(surfaces: &[Surface], options: &Options, host: &mut Host) -> Result<Correspondence, Error> {
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
        Ok(made)
    }
}
