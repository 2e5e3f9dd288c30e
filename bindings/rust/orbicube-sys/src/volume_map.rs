//! What `<orbicube/volume_map.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};

/// A mesh to untangle: a view, kept by no function. Fill with \_init, then set what there is. Coordinates are numbered
/// 3 \* vertex + axis.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_tangle {
    pub struct_size: u32,
    pub reserved: i32,
    /// x y z a vertex: where they are
    pub positions: *const f64,
    pub vertex_count: usize,
    /// four vertices each; those of negative volume are inverted
    pub tetrahedra: *const u32,
    pub tetrahedron_count: usize,
    /// x y z a vertex, where each tetrahedron is positive and has the shape that it should have, of
    /// any size; NULL: all should be regular and of one size
    pub rest: *const f64,
    /// one a coordinate, not 0 where it stays as it is; NULL: all are free
    pub fixed: *const u8,
    /// one a coordinate: its group, a number below 3 \* vertex\_count, all of which are to be equal, or
    /// UINT32\_MAX; NULL: none. A group with a fixed coordinate is fixed, any other starts at its mean
    pub ties: *const u32,
}

/// Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_untangle_options {
    pub struct_size: u32,
    /// of Newton's method at most, in each of three attempts, until no tetrahedron is inverted. Default 500
    pub steps: i32,
    /// then at most so many that lower the distortion and keep all positive. Default 20
    pub polish_steps: i32,
    pub reserved: i32,
    /// how much changes of volume count beside those of angles, above 0. Default 1
    pub volume_weight: f64,
}

/// Figures of a run. Determinants are those of the map from the wanted shapes, scaled so that 1 keeps the volume.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_untangle_report {
    pub struct_size: u32,
    /// UINT32\_MAX when there is none
    pub first_inverted: u32,
    /// tetrahedra that are not positive, by exact arithmetic
    pub inverted_before: u64,
    /// tetrahedra that are not positive, by exact arithmetic
    pub inverted: u64,
    /// taken
    pub steps: u64,
    /// taken
    pub polish_steps: u64,
    pub least_determinant: f64,
    pub greatest_determinant: f64,
    /// mean of |J|^2 / D^(2/3) + volume\_weight (1 + D^2) / D; 5 at least with weight 1
    pub energy: f64,
}

extern "C" {
    /// A mesh of nothing; the defaults, which the members' comments give; zeros.
    pub fn obc_volume_map_tangle_init(tangle: *mut obc_volume_map_tangle, struct_size: usize) -> i32;
    /// A mesh of nothing; the defaults, which the members' comments give; zeros.
    pub fn obc_volume_map_untangle_options_init(options: *mut obc_volume_map_untangle_options, struct_size: usize) -> i32;
    /// A mesh of nothing; the defaults, which the members' comments give; zeros.
    pub fn obc_volume_map_untangle_report_init(report: *mut obc_volume_map_untangle_report, struct_size: usize) -> i32;
    /// Moves vertices until all tetrahedra are positive: result gets x y z a vertex, fixed coordinates to the bit, tied ones the
    /// same bits. A mesh without inverted tetrahedra is only polished. options, host and report may be NULL; result may be
    /// tangle-\>positions. About 500 bytes a tetrahedron; a step is O(n) but for its conjugate gradients, 150 at most.
    /// Errors: no valid result (some stay inverted: how many and the first; result and report then have the best that was found, on
    /// all other errors nothing); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
    /// malformed file (kind index-range), degenerate (kinds degenerate-cell and inverted-cell: a repeated vertex, a tetrahedron of
    /// rest that is not positive; degenerate-geometry: no volume at all), out of memory, cancelled.
    pub fn obc_volume_map_untangle(tangle: *const obc_volume_map_tangle, options: *const obc_volume_map_untangle_options, host: *const obc_host, result: *mut f64, report: *mut obc_volume_map_untangle_report, error: *mut obc_error) -> i32;
    /// Version of this library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_volume_map_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_volume_map_tangle>(), align_of::<obc_volume_map_tangle>()), (64, 8));
        let it = MaybeUninit::<obc_volume_map_tangle>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_volume_map_tangle.struct_size");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 4, "obc_volume_map_tangle.reserved");
        assert_eq!(unsafe { addr_of!((*start).positions) } as usize - start as usize, 8, "obc_volume_map_tangle.positions");
        assert_eq!(unsafe { addr_of!((*start).vertex_count) } as usize - start as usize, 16, "obc_volume_map_tangle.vertex_count");
        assert_eq!(unsafe { addr_of!((*start).tetrahedra) } as usize - start as usize, 24, "obc_volume_map_tangle.tetrahedra");
        assert_eq!(unsafe { addr_of!((*start).tetrahedron_count) } as usize - start as usize, 32, "obc_volume_map_tangle.tetrahedron_count");
        assert_eq!(unsafe { addr_of!((*start).rest) } as usize - start as usize, 40, "obc_volume_map_tangle.rest");
        assert_eq!(unsafe { addr_of!((*start).fixed) } as usize - start as usize, 48, "obc_volume_map_tangle.fixed");
        assert_eq!(unsafe { addr_of!((*start).ties) } as usize - start as usize, 56, "obc_volume_map_tangle.ties");
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
        assert_eq!(unsafe { addr_of!((*start).least_determinant) } as usize - start as usize, 40, "obc_volume_map_untangle_report.least_determinant");
        assert_eq!(unsafe { addr_of!((*start).greatest_determinant) } as usize - start as usize, 48, "obc_volume_map_untangle_report.greatest_determinant");
        assert_eq!(unsafe { addr_of!((*start).energy) } as usize - start as usize, 56, "obc_volume_map_untangle_report.energy");
    }
}
