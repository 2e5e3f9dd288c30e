//! Maps of solids to polycubes without inverted tetrahedra.
//!
//! ```
//! use orbicube::{volume_map, Host};
//! let corners = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
//! let solid = volume_map::map_to_polycube(&corners, &[0, 1, 2, 3], &Default::default(), &mut Host::new())?;
//! assert!(solid.tetrahedra.len() >= 4);
//! # Ok::<(), orbicube::Error>(())
//! ```

use crate::call::{call, checked, pointer, rows, Error, Host};
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
