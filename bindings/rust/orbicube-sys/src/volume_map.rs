//! What `<orbicube/volume_map.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};

/// A bijective map of a solid to a polycube.
#[repr(C)]
pub struct obc_volume_map_solid {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// A mesh to untangle, with its constraints: a view of arrays of the caller. Coordinate 3 \* vertex + axis is that of an axis of a vertex. Fill with
/// \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_untangle_problem {
    pub struct_size: u32,
    pub reserved: i32,
    /// initial positions, x y z a vertex. Default: NULL, which must be set.
    pub positions: *const f64,
    /// number of vertices. Default: 0.
    pub vertex_count: usize,
    /// four vertices a tetrahedron; inverted ones have negative volume. Default: NULL, which must be set.
    pub tetrahedra: *const u32,
    /// number of tetrahedra. Default: 0.
    pub tetrahedron_count: usize,
    /// Rest positions, x y z a vertex, in which each tetrahedron is positive and has its target shape, of any size; NULL: the target
    /// shapes are regular tetrahedra of equal size. Default: NULL.
    pub rest: *const f64,
    /// one entry a coordinate, nonzero for a fixed one; NULL: all are free. Default: NULL.
    pub fixed: *const u8,
    /// Groups of equal coordinates: one entry a coordinate, the number of its group, below 3 \* vertex\_count, or UINT32\_MAX for none;
    /// NULL: no groups. A group with a fixed coordinate is fixed; any other group starts at its mean. Default: NULL.
    pub ties: *const u32,
}

/// Options of untangling. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_untangle_options {
    pub struct_size: u32,
    /// maximum number of Newton steps in each of three attempts, while tetrahedra are inverted. Default: 500.
    pub steps: i32,
    /// maximum number of further steps that lower the distortion and keep all tetrahedra positive. Default: 20.
    pub polish_steps: i32,
    pub reserved: i32,
    /// weight of volume distortion relative to angle distortion, positive. Default: 1.
    pub volume_weight: f64,
}

/// Figures of untangling. Determinants are those of the maps from the target shapes, scaled so that 1 preserves the volume.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_untangle_report {
    pub struct_size: u32,
    /// first tetrahedron that is not positive; UINT32\_MAX: none
    pub first_inverted: u32,
    /// number of tetrahedra that are not positive before and after, by exact arithmetic
    pub inverted_before: u64,
    /// number of tetrahedra that are not positive before and after, by exact arithmetic
    pub inverted: u64,
    /// number of steps taken
    pub steps: u64,
    /// number of steps taken
    pub polish_steps: u64,
    /// minimum and maximum determinant after
    pub min_determinant: f64,
    /// minimum and maximum determinant after
    pub max_determinant: f64,
    /// mean of |J|^2 / D^(2/3) + volume\_weight (1 + D^2) / D; at least 5 with weight 1
    pub energy: f64,
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
    /// Fill a mesh with no vertices, options with the defaults, and a report with zeros.
    pub fn obc_volume_map_untangle_problem_init(problem: *mut obc_volume_map_untangle_problem, struct_size: usize) -> i32;
    /// Fill a mesh with no vertices, options with the defaults, and a report with zeros.
    pub fn obc_volume_map_untangle_options_init(options: *mut obc_volume_map_untangle_options, struct_size: usize) -> i32;
    /// Fill a mesh with no vertices, options with the defaults, and a report with zeros.
    pub fn obc_volume_map_untangle_report_init(report: *mut obc_volume_map_untangle_report, struct_size: usize) -> i32;
    /// Moves vertices until all tetrahedra are positive. result receives x y z a vertex and may be problem-\>positions; fixed coordinates are
    /// unchanged and tied ones have the same bits. A mesh without inverted tetrahedra is only polished. options, host and report may be
    /// NULL. Takes about 700 bytes a tetrahedron; a step is O(n) times up to 150 iterations of conjugate gradients.
    /// Errors: no valid result (some remain inverted: their number and the first; result and report then have the best mesh, for all other
    /// errors they are unchanged); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
    /// not manifold (kinds non-manifold-face and inconsistent-orientation: three tetrahedra at a face, or two on one side of it);
    /// malformed file (kind index-range); degenerate (kinds degenerate-cell and inverted-cell: a repeated vertex, a rest
    /// tetrahedron that is not positive; degenerate-geometry: zero volume); out of memory; cancelled.
    pub fn obc_volume_map_untangle(problem: *const obc_volume_map_untangle_problem, options: *const obc_volume_map_untangle_options, host: *const obc_host, result: *mut f64, report: *mut obc_volume_map_untangle_report, error: *mut obc_error) -> i32;
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
        assert_eq!((size_of::<obc_volume_map_untangle_problem>(), align_of::<obc_volume_map_untangle_problem>()), (64, 8));
        let it = MaybeUninit::<obc_volume_map_untangle_problem>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_volume_map_untangle_problem.struct_size");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 4, "obc_volume_map_untangle_problem.reserved");
        assert_eq!(unsafe { addr_of!((*start).positions) } as usize - start as usize, 8, "obc_volume_map_untangle_problem.positions");
        assert_eq!(unsafe { addr_of!((*start).vertex_count) } as usize - start as usize, 16, "obc_volume_map_untangle_problem.vertex_count");
        assert_eq!(unsafe { addr_of!((*start).tetrahedra) } as usize - start as usize, 24, "obc_volume_map_untangle_problem.tetrahedra");
        assert_eq!(unsafe { addr_of!((*start).tetrahedron_count) } as usize - start as usize, 32, "obc_volume_map_untangle_problem.tetrahedron_count");
        assert_eq!(unsafe { addr_of!((*start).rest) } as usize - start as usize, 40, "obc_volume_map_untangle_problem.rest");
        assert_eq!(unsafe { addr_of!((*start).fixed) } as usize - start as usize, 48, "obc_volume_map_untangle_problem.fixed");
        assert_eq!(unsafe { addr_of!((*start).ties) } as usize - start as usize, 56, "obc_volume_map_untangle_problem.ties");
        assert_eq!((size_of::<obc_volume_map_untangle_options>(), align_of::<obc_volume_map_untangle_options>()), (24, 8));
        let it = MaybeUninit::<obc_volume_map_untangle_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_volume_map_untangle_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).steps) } as usize - start as usize, 4, "obc_volume_map_untangle_options.steps");
        assert_eq!(unsafe { addr_of!((*start).polish_steps) } as usize - start as usize, 8, "obc_volume_map_untangle_options.polish_steps");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 12, "obc_volume_map_untangle_options.reserved");
        assert_eq!(unsafe { addr_of!((*start).volume_weight) } as usize - start as usize, 16, "obc_volume_map_untangle_options.volume_weight");
        assert_eq!((size_of::<obc_volume_map_untangle_report>(), align_of::<obc_volume_map_untangle_report>()), (64, 8));
        let it = MaybeUninit::<obc_volume_map_untangle_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_volume_map_untangle_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).first_inverted) } as usize - start as usize, 4, "obc_volume_map_untangle_report.first_inverted");
        assert_eq!(unsafe { addr_of!((*start).inverted_before) } as usize - start as usize, 8, "obc_volume_map_untangle_report.inverted_before");
        assert_eq!(unsafe { addr_of!((*start).inverted) } as usize - start as usize, 16, "obc_volume_map_untangle_report.inverted");
        assert_eq!(unsafe { addr_of!((*start).steps) } as usize - start as usize, 24, "obc_volume_map_untangle_report.steps");
        assert_eq!(unsafe { addr_of!((*start).polish_steps) } as usize - start as usize, 32, "obc_volume_map_untangle_report.polish_steps");
        assert_eq!(unsafe { addr_of!((*start).min_determinant) } as usize - start as usize, 40, "obc_volume_map_untangle_report.min_determinant");
        assert_eq!(unsafe { addr_of!((*start).max_determinant) } as usize - start as usize, 48, "obc_volume_map_untangle_report.max_determinant");
        assert_eq!(unsafe { addr_of!((*start).energy) } as usize - start as usize, 56, "obc_volume_map_untangle_report.energy");
        assert_eq!((size_of::<obc_volume_map_solid_options>(), align_of::<obc_volume_map_solid_options>()), (24, 8));
        let it = MaybeUninit::<obc_volume_map_solid_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_volume_map_solid_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 4, "obc_volume_map_solid_options.reserved");
        assert_eq!(unsafe { addr_of!((*start).corners) } as usize - start as usize, 8, "obc_volume_map_solid_options.corners");
        assert_eq!(unsafe { addr_of!((*start).seed) } as usize - start as usize, 16, "obc_volume_map_solid_options.seed");
    }
}
