//! What `<orbicube/volume_map.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};

/// A bijective map of a solid to a polycube.
#[repr(C)]
pub struct obc_volume_map_solid {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Options of a map of a solid. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_solid_options {
    pub struct_size: u32,
    pub reserved: i32,
    /// maximum number of polycube corners per boundary component, as in obc\_polycube\_options; 0: no limit. Default: 100.
    pub corners: usize,
    /// seed of random choices. Default: 0.
    pub seed: u64,
}

extern "C" {
    /// Fills options with the defaults.
    pub fn obc_volume_map_solid_options_init(options: *mut obc_volume_map_solid_options, struct_size: usize) -> i32;
    /// Computes a polycube of the boundary of a solid and a map of the solid to it. Every tetrahedron is positive on the polycube and in
    /// space, and the boundary covers the polycube once. positions: x y z a vertex; tetrahedra: four vertices each, positive, conforming.
    /// Tetrahedra are split where the map requires it. The polycube of a cavity lies within that of the outer boundary; polycubes of
    /// several pieces stand side by side along x. options and host may be NULL; the allocator of the host must remain valid until
    /// \_destroy. Takes minutes for a hundred thousand tetrahedra.
    /// Errors: invalid argument; malformed file (index-range); degenerate; not manifold; not closed; no valid result with the
    /// obstacle; out of memory; cancelled.
    pub fn obc_volume_map_solid_compute(positions: *const f64, vertex_count: usize, tetrahedra: *const u32, tetrahedron_count: usize, options: *const obc_volume_map_solid_options, host: *const obc_host, out: *mut *mut obc_volume_map_solid, error: *mut obc_error) -> i32;
    /// Destroys a map; NULL is allowed.
    pub fn obc_volume_map_solid_destroy(solid: *mut obc_volume_map_solid);
    /// Return the number of vertices and of tetrahedra after splits; 0 for NULL.
    pub fn obc_volume_map_solid_vertex_count(solid: *const obc_volume_map_solid) -> usize;
    /// Return the number of vertices and of tetrahedra after splits; 0 for NULL.
    pub fn obc_volume_map_solid_tetrahedron_count(solid: *const obc_volume_map_solid) -> usize;
    /// Copies positions in space and on the polycube (x y z a vertex) and tetrahedra (four vertices each); each may be NULL.
    /// Errors: invalid argument.
    pub fn obc_volume_map_solid_copy(solid: *const obc_volume_map_solid, positions: *mut f64, polycube: *mut f64, tetrahedra: *mut u32, error: *mut obc_error) -> i32;
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_volume_map_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_volume_map_solid_options>(), align_of::<obc_volume_map_solid_options>()), (24, 8));
        let it = MaybeUninit::<obc_volume_map_solid_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_volume_map_solid_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 4, "obc_volume_map_solid_options.reserved");
        assert_eq!(unsafe { addr_of!((*start).corners) } as usize - start as usize, 8, "obc_volume_map_solid_options.corners");
        assert_eq!(unsafe { addr_of!((*start).seed) } as usize - start as usize, 16, "obc_volume_map_solid_options.seed");
    }
}
