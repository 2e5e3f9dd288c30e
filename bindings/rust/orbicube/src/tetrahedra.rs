//! Closed surfaces filled with tetrahedra by TetGen, whose license, the AGPL 3, binds programs that use this feature.

use crate::call::{call, checked, pointer, Error, Host};
use crate::mesh::Surface;
use crate::sys::tetrahedra::*;

filled!(/// Options, with their defaults.
    Options, obc_tetrahedra_options, obc_tetrahedra_options_init);

/// Positions (the surface's first), tetrahedra, the boundary and where its triangles come from.
#[derive(Clone, Debug, Default)]
pub struct Solid {
    pub positions: Vec<f64>,
    pub tetrahedra: Vec<u32>,
    pub boundary: Vec<u32>,
    pub boundary_source: Vec<u32>,
    pub parts: usize,
    pub cavities: usize,
}

handle!(Handle, obc_tetrahedra, obc_tetrahedra_destroy);

pub fn fill(surface: Surface, options: &Options, host: &mut Host) -> Result<Solid, Error> {
    fill_sized(surface, options, &[], host)
}

/// With lengths of edges requested at places. The members of the options that say so in C are not used.
pub fn fill_sized(surface: Surface, options: &Options, sizes: &[([f64; 3], f64)], host: &mut Host) -> Result<Solid, Error> {
    let (places, lengths): (Vec<[f64; 3]>, Vec<f64>) = sizes.iter().copied().unzip();
    let options = obc_tetrahedra_options {
        size_positions: pointer(&places) as *const f64,
        size_lengths: pointer(&lengths),
        size_count: lengths.len(),
        ..options.0
    };
    let mut out = std::ptr::null_mut();
    call(host, |host, error| unsafe { obc_tetrahedra_fill(&surface.c, &options, host, &mut out, error) })?;
    let handle = Handle::own(out);
    let out = handle.as_ptr();
    let mut solid = Solid::default();
    unsafe {
        solid.positions.resize(3 * obc_tetrahedra_vertex_count(out), 0.0);
        solid.tetrahedra.resize(4 * obc_tetrahedra_count(out), 0);
        solid.boundary.resize(3 * obc_tetrahedra_boundary_count(out), 0);
        solid.boundary_source.resize(obc_tetrahedra_boundary_count(out), 0);
        solid.parts = obc_tetrahedra_part_count(out);
        solid.cavities = obc_tetrahedra_cavity_count(out);
        checked(|error| {
            obc_tetrahedra_copy(out, solid.positions.as_mut_ptr(), solid.tetrahedra.as_mut_ptr(), solid.boundary.as_mut_ptr(),
                                solid.boundary_source.as_mut_ptr(), error)
        })?;
    }
    Ok(solid)
}

/// An error, with kind and place, unless [`fill`] can work.
pub fn check_surface(surface: Surface, host: &mut Host) -> Result<(), Error> {
    let mut count = 0;
    call(host, |host, error| unsafe {
        obc_tetrahedra_check_surface(&surface.c, host, std::ptr::null_mut(), 0, &mut count, error)
    })
}
