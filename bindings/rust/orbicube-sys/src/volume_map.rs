//! What `<orbicube/volume_map.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};

/// A bijective map of a solid to a polycube.
#[repr(C)]
pub struct obc_volume_map_solid {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Coordinates f of a solid, a chart for each tetrahedron, that minimize sum of volume |grad f - X|^2 for frames X (eq. 5.3 of the
/// dissertation) subject to transitions f\_j = M f\_i + g across faces, M one of the 24 rotations of the cube.
#[repr(C)]
pub struct obc_volume_map_frame_map {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Finds points in a mesh of tetrahedra. With the positions in space the map f is a function of points, with those of the image its
/// inverse.
#[repr(C)]
pub struct obc_volume_map_locator {
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

/// Options of a parameterization. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_frame_map_options {
    pub struct_size: u32,
    /// 1: gaps, planes of the boundary and singular edges become integers; 0: real numbers. Default: 0.
    pub integer: i32,
    /// length in space of a step of 1 of the coordinates; 0: that of about 10000 cells. Default: 0.
    pub cell_length: f64,
    /// minimum dihedral angle, in degrees, of boundary edges that computed frames follow; 0: none. Default: 0.
    pub feature_angle: f64,
}

/// Figures of a parameterization.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_frame_map_report {
    pub struct_size: u32,
    /// 1: the integers are proven to be the best
    pub integers_optimal: i32,
    /// eq. 5.3 of cell\_length f, over the volume of the solid
    pub energy: f64,
    /// what rounding added to it
    pub integer_cost: f64,
    /// maximum violation of the transitions, and of the planes of the boundary, in steps of the coordinates
    pub residual: f64,
    /// as in the options, or what 0 became
    pub cell_length: f64,
    /// number of tetrahedra that are not positive, by exact arithmetic
    pub inverted: u64,
    /// number of independent gaps, planes and constants of singular edges
    pub integers: u64,
    /// number of planes of the boundary
    pub patches: u64,
    /// number of faces with a transition
    pub cut_faces: u64,
    /// number of edges around which the frames turn
    pub singular_edges: u64,
    /// number of linear systems solved
    pub solves: u64,
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
    /// Fill options with the defaults, and a report with zeros.
    pub fn obc_volume_map_frame_map_options_init(options: *mut obc_volume_map_frame_map_options, struct_size: usize) -> i32;
    /// Fill options with the defaults, and a report with zeros.
    pub fn obc_volume_map_frame_map_report_init(report: *mut obc_volume_map_frame_map_report, struct_size: usize) -> i32;
    /// Computes the parameterization of a solid as it is: nothing is split or untangled, so that tetrahedra may be inverted. positions:
    /// x y z a vertex; tetrahedra: four vertices each, positive, conforming; frames: w x y z a tetrahedron, units, or NULL for computed
    /// ones. options, host and report may be NULL; the allocator of the host must remain valid until \_destroy. Takes the time of a sparse
    /// direct solver, about 10 s for a hundred thousand tetrahedra.
    /// Errors: no valid result (frames that no map follows, with the place); invalid argument; malformed file (index-range); degenerate;
    /// not manifold; out of memory; cancelled.
    pub fn obc_volume_map_frame_map_compute(positions: *const f64, vertex_count: usize, tetrahedra: *const u32, tetrahedron_count: usize, frames: *const f64, options: *const obc_volume_map_frame_map_options, host: *const obc_host, report: *mut obc_volume_map_frame_map_report, out: *mut *mut obc_volume_map_frame_map, error: *mut obc_error) -> i32;
    /// Destroys a parameterization; NULL is allowed.
    pub fn obc_volume_map_frame_map_destroy(map: *mut obc_volume_map_frame_map);
    /// Return the number of tetrahedra and of singular edges; 0 for NULL.
    pub fn obc_volume_map_frame_map_tetrahedron_count(map: *const obc_volume_map_frame_map) -> usize;
    /// Return the number of tetrahedra and of singular edges; 0 for NULL.
    pub fn obc_volume_map_frame_map_singular_edge_count(map: *const obc_volume_map_frame_map) -> usize;
    /// Copies, each unless NULL: parameters, the coordinates of the corners (12 a tetrahedron); of each face 4 t + k, opposite corner k of
    /// tetrahedron t: the number of the rotation M to the chart beyond (obc\_quaternion\_cube\_element), the gap g (three), 1 where the face
    /// is cut and 0 elsewhere, and 2 axis + (1 where the axis is outward-oriented) of the constant coordinate on the boundary; singular
    /// edges, two vertices each.
    /// Errors: invalid argument.
    pub fn obc_volume_map_frame_map_copy(map: *const obc_volume_map_frame_map, parameters: *mut f64, rotations: *mut u8, gaps: *mut f64, cut: *mut u8, labels: *mut u8, singular_edges: *mut u32, error: *mut obc_error) -> i32;
    /// Creates a locator; it copies the mesh. The allocator of the host must remain valid until \_destroy. host may be NULL.
    /// Errors: invalid argument; malformed file (index-range); out of memory; cancelled.
    pub fn obc_volume_map_locator_create(positions: *const f64, vertex_count: usize, tetrahedra: *const u32, tetrahedron_count: usize, host: *const obc_host, out: *mut *mut obc_volume_map_locator, error: *mut obc_error) -> i32;
    /// Destroys a locator; NULL is allowed.
    pub fn obc_volume_map_locator_destroy(locator: *mut obc_volume_map_locator);
    /// Finds the tetrahedron of each point (x y z), UINT32\_MAX where there is none, and the four weights of its corners, which add up to 1
    /// (zeros where there is none); each output may be NULL. Weights may be -1e-9 at the boundary. Where tetrahedra share a point, the one
    /// that holds it deepest is found, of equals the first. O(log n) a point; the same for any number of threads. host may be NULL. A locator
    /// may be used by several threads at once.
    /// Errors: invalid argument; out of memory; cancelled.
    pub fn obc_volume_map_locator_locate(locator: *const obc_volume_map_locator, points: *const f64, point_count: usize, host: *const obc_host, tetrahedra: *mut u32, weights: *mut f64, error: *mut obc_error) -> i32;
    /// Computes images of located points: the weighted sums of values at the corners, \`components\` numbers a vertex of the mesh. images
    /// receives \`components\` numbers a point, NaN where there is no tetrahedron. host may be NULL.
    /// Errors: invalid argument; out of memory; cancelled.
    pub fn obc_volume_map_locator_interpolate(locator: *const obc_volume_map_locator, tetrahedra: *const u32, weights: *const f64, point_count: usize, values: *const f64, components: usize, host: *const obc_host, images: *mut f64, error: *mut obc_error) -> i32;
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
        assert_eq!((size_of::<obc_volume_map_frame_map_options>(), align_of::<obc_volume_map_frame_map_options>()), (24, 8));
        let it = MaybeUninit::<obc_volume_map_frame_map_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_volume_map_frame_map_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).integer) } as usize - start as usize, 4, "obc_volume_map_frame_map_options.integer");
        assert_eq!(unsafe { addr_of!((*start).cell_length) } as usize - start as usize, 8, "obc_volume_map_frame_map_options.cell_length");
        assert_eq!(unsafe { addr_of!((*start).feature_angle) } as usize - start as usize, 16, "obc_volume_map_frame_map_options.feature_angle");
        assert_eq!((size_of::<obc_volume_map_frame_map_report>(), align_of::<obc_volume_map_frame_map_report>()), (88, 8));
        let it = MaybeUninit::<obc_volume_map_frame_map_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_volume_map_frame_map_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).integers_optimal) } as usize - start as usize, 4, "obc_volume_map_frame_map_report.integers_optimal");
        assert_eq!(unsafe { addr_of!((*start).energy) } as usize - start as usize, 8, "obc_volume_map_frame_map_report.energy");
        assert_eq!(unsafe { addr_of!((*start).integer_cost) } as usize - start as usize, 16, "obc_volume_map_frame_map_report.integer_cost");
        assert_eq!(unsafe { addr_of!((*start).residual) } as usize - start as usize, 24, "obc_volume_map_frame_map_report.residual");
        assert_eq!(unsafe { addr_of!((*start).cell_length) } as usize - start as usize, 32, "obc_volume_map_frame_map_report.cell_length");
        assert_eq!(unsafe { addr_of!((*start).inverted) } as usize - start as usize, 40, "obc_volume_map_frame_map_report.inverted");
        assert_eq!(unsafe { addr_of!((*start).integers) } as usize - start as usize, 48, "obc_volume_map_frame_map_report.integers");
        assert_eq!(unsafe { addr_of!((*start).patches) } as usize - start as usize, 56, "obc_volume_map_frame_map_report.patches");
        assert_eq!(unsafe { addr_of!((*start).cut_faces) } as usize - start as usize, 64, "obc_volume_map_frame_map_report.cut_faces");
        assert_eq!(unsafe { addr_of!((*start).singular_edges) } as usize - start as usize, 72, "obc_volume_map_frame_map_report.singular_edges");
        assert_eq!(unsafe { addr_of!((*start).solves) } as usize - start as usize, 80, "obc_volume_map_frame_map_report.solves");
    }
}
