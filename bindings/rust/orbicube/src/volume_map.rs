//! Maps of solids to polycubes without inverted tetrahedra.
//!
//! ```
//! use orbicube::{volume_map, Host};
//! let corners = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
//! let solid = volume_map::map_to_polycube(&corners, &[0, 1, 2, 3], &Default::default(), &mut Host::new())?;
//! assert!(solid.tetrahedra.len() >= 4);
//! # Ok::<(), orbicube::Error>(())
//! ```

use crate::call::{call, checked, expect_length, pointer, rows, Error, Host};
use crate::sys::volume_map::*;

filled!(/// Options of the map to a polycube, with their defaults.
    SolidOptions, obc_volume_map_solid_options, obc_volume_map_solid_options_init);
/// A solid, and the same on the polycube of its boundary.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Solid {
    pub positions: Vec<f64>,
    pub polycube: Vec<f64>,
    /// Of both: four vertices each, positive here and there.
    pub tetrahedra: Vec<u32>,
}

handle!(SolidHandle, obc_volume_map_solid, obc_volume_map_solid_destroy);

/// Maps positive tetrahedra one to one to a polycube, splitting them where that is needed.
pub fn map_to_polycube(positions: &[f64], tetrahedra: &[u32], options: &SolidOptions, host: &mut Host) -> Result<Solid, Error> {
    let (vertices, cells) = (rows(positions.len(), 3, "positions")?, rows(tetrahedra.len(), 4, "tetrahedra")?);
    let mut out = std::ptr::null_mut();
    call(host, |host, error| unsafe {
        obc_volume_map_solid_compute(pointer(positions), vertices, pointer(tetrahedra), cells, &options.0, host, &mut out, error)
    })?;
    let handle = SolidHandle::own(out);
    let out = handle.as_ptr();
    let mut solid = Solid::default();
    unsafe {
        solid.positions.resize(3 * obc_volume_map_solid_vertex_count(out), 0.0);
        solid.polycube.resize(solid.positions.len(), 0.0);
        solid.tetrahedra.resize(4 * obc_volume_map_solid_tetrahedron_count(out), 0);
        checked(|error| {
            obc_volume_map_solid_copy(out, solid.positions.as_mut_ptr(), solid.polycube.as_mut_ptr(),
                                      solid.tetrahedra.as_mut_ptr(), error)
        })?;
    }
    Ok(solid)
}

filled!(/// Options of a parameterization, with their defaults.
    FrameMapOptions, obc_volume_map_frame_map_options, obc_volume_map_frame_map_options_init);
filled!(/// Figures of a parameterization.
    FrameMapReport, obc_volume_map_frame_map_report, obc_volume_map_frame_map_report_init);
/// A parameterization along frames. Faces are 4 t + k, opposite corner k of tetrahedron t.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FrameMap {
    /// Coordinates of the corners, twelve a tetrahedron.
    pub parameters: Vec<f64>,
    /// Of each face the number of the rotation to the chart beyond.
    pub rotations: Vec<u8>,
    /// Three a face.
    pub gaps: Vec<f64>,
    /// Of each face 1 where it has a transition.
    pub cut: Vec<u8>,
    /// Of each face of the boundary 2 axis + (1 where outward-oriented).
    pub labels: Vec<u8>,
    /// Two vertices each.
    pub singular_edges: Vec<u32>,
}

handle!(FrameMapHandle, obc_volume_map_frame_map, obc_volume_map_frame_map_destroy);

/// Computes coordinates whose gradients are the axes of the frames, w x y z a tetrahedron; empty: computed ones.
pub fn parameterize(positions: &[f64], tetrahedra: &[u32], frames: &[f64], options: &FrameMapOptions,
                    host: &mut Host) -> Result<(FrameMap, FrameMapReport), Error> {
    let (vertices, cells) = (rows(positions.len(), 3, "positions")?, rows(tetrahedra.len(), 4, "tetrahedra")?);
    if !frames.is_empty() {
        expect_length(frames.len(), 4 * cells, "frames")?;
    }
    let (mut out, mut report) = (std::ptr::null_mut(), FrameMapReport::default());
    call(host, |host, error| unsafe {
        obc_volume_map_frame_map_compute(pointer(positions), vertices, pointer(tetrahedra), cells, pointer(frames), &options.0,
                                         host, &mut report.0, &mut out, error)
    })?;
    let handle = FrameMapHandle::own(out);
    let out = handle.as_ptr();
    let mut map = FrameMap {
        parameters: vec![0.0; 12 * cells],
        rotations: vec![0; 4 * cells],
        gaps: vec![0.0; 12 * cells],
        cut: vec![0; 4 * cells],
        labels: vec![0; 4 * cells],
        singular_edges: vec![0; 2 * unsafe { obc_volume_map_frame_map_singular_edge_count(out) }],
    };
    checked(|error| unsafe {
        obc_volume_map_frame_map_copy(out, map.parameters.as_mut_ptr(), map.rotations.as_mut_ptr(), map.gaps.as_mut_ptr(),
                                      map.cut.as_mut_ptr(), map.labels.as_mut_ptr(), map.singular_edges.as_mut_ptr(), error)
    })?;
    Ok((map, report))
}

handle!(LocatorHandle, obc_volume_map_locator, obc_volume_map_locator_destroy);

/// Finds points in a mesh of tetrahedra.
pub struct Locator {
    handle: LocatorHandle,
    vertex_count: usize,
}

// Used by any number of threads at once, as the header says.
unsafe impl Send for Locator {}
unsafe impl Sync for Locator {}

impl Locator {
    pub fn new(positions: &[f64], tetrahedra: &[u32], host: &mut Host) -> Result<Locator, Error> {
        let (vertices, cells) = (rows(positions.len(), 3, "positions")?, rows(tetrahedra.len(), 4, "tetrahedra")?);
        let mut out = std::ptr::null_mut();
        call(host, |host, error| unsafe {
            obc_volume_map_locator_create(pointer(positions), vertices, pointer(tetrahedra), cells, host, &mut out, error)
        })?;
        Ok(Locator { handle: LocatorHandle::own(out), vertex_count: vertices })
    }
    /// The tetrahedron of each point, `u32::MAX` where there is none, and the weights of its corners.
    pub fn locate(&self, points: &[[f64; 3]], host: &mut Host) -> Result<Vec<(u32, [f64; 4])>, Error> {
        let (tetrahedra, weights) = self.places(points, host)?;
        Ok(tetrahedra.into_iter().zip(weights).collect())
    }
    /// Values of the vertices, interpolated; NaN where no tetrahedron has the point. With the positions of the image as values it
    /// is the map, and for a locator of the image, with those in space, its inverse.
    pub fn sample(&self, points: &[[f64; 3]], values: &[f64], host: &mut Host) -> Result<Vec<f64>, Error> {
        let components = rows(values.len(), self.vertex_count.max(1), "values")?;
        let (tetrahedra, weights) = self.places(points, host)?;
        let mut sampled = vec![0.0; components * points.len()];
        call(host, |host, error| unsafe {
            obc_volume_map_locator_interpolate(self.handle.as_ptr(), tetrahedra.as_ptr(), weights.as_ptr() as *const f64,
                                               points.len(), pointer(values), components, host, sampled.as_mut_ptr(), error)
        })?;
        Ok(sampled)
    }
    fn places(&self, points: &[[f64; 3]], host: &mut Host) -> Result<(Vec<u32>, Vec<[f64; 4]>), Error> {
        let n = points.len();
        let (mut tetrahedra, mut weights) = (vec![0; n], vec![[0.0; 4]; n]);
        call(host, |host, error| unsafe {
            obc_volume_map_locator_locate(self.handle.as_ptr(), points.as_ptr() as *const f64, n, host, tetrahedra.as_mut_ptr(),
                                          weights.as_mut_ptr() as *mut f64, error)
        })?;
        Ok((tetrahedra, weights))
    }
}
