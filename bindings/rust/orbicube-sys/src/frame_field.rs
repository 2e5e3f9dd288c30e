//! What `<orbicube/frame_field.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};

/// several of these, with the best of their results in each region
pub const OBC_FRAME_FIELD_AUTO: i32 = 0;
/// the coordinate axes
pub const OBC_FRAME_FIELD_IDENTITY: i32 = 1;
/// the nearest boundary frame
pub const OBC_FRAME_FIELD_PROPAGATED: i32 = 2;
/// harmonics that satisfy Laplace's equation, projected
pub const OBC_FRAME_FIELD_HARMONIC: i32 = 3;
/// HARMONIC, then diffused and projected with decreasing times
pub const OBC_FRAME_FIELD_DIFFUSION: i32 = 4;
/// the field in \`frames\`
pub const OBC_FRAME_FIELD_GIVEN: i32 = 5;

/// as described at the top
pub const OBC_FRAME_FIELD_SMOOTH: i32 = 0;
/// chapter 6 of the dissertation: identity inside, fixed boundary frames; matchings rounded first, not last
pub const OBC_FRAME_FIELD_DISSERTATION: i32 = 1;

/// 1
pub const OBC_FRAME_FIELD_UNIFORM: i32 = 0;
/// area over the distance of the centers, scaled to mean 1
pub const OBC_FRAME_FIELD_GEOMETRIC: i32 = 1;

/// none
pub const OBC_FRAME_FIELD_NO_REPAIR: i32 = 0;
/// Third and half turns are split into quarter turns (Li et al. 2012), short loops and fragments collapse, and the frames
/// around them are smoothed; the result is accepted if fewer edges and vertices are unmeshable.
pub const OBC_FRAME_FIELD_REPAIR: i32 = 1;
/// The search starts from IDENTITY and is restricted to fields whose frames rotate about one axis along each curve.
pub const OBC_FRAME_FIELD_SINGLE_AXIS: i32 = 2;

/// Singular edges of a field and the curves they form.
#[repr(C)]
pub struct obc_frame_field_singularities {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// A tetrahedral mesh: a view of arrays of the caller.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_frame_field_solid {
    /// x y z a vertex
    pub positions: *const f64,
    /// number of vertices
    pub vertex_count: usize,
    /// four vertices each, with positive volume
    pub tetrahedra: *const u32,
    /// number of tetrahedra
    pub tetrahedron_count: usize,
}

/// Options of a field. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_frame_field_options {
    pub struct_size: u32,
    /// initial field, OBC\_FRAME\_FIELD\_AUTO or another; with DISSERTATION AUTO or IDENTITY. Default: AUTO.
    pub start: i32,
    /// OBC\_FRAME\_FIELD\_SMOOTH or DISSERTATION. Default: SMOOTH.
    pub method: i32,
    /// OBC\_FRAME\_FIELD\_UNIFORM or GEOMETRIC. Default: UNIFORM.
    pub weighting: i32,
    /// 1: an axis is exactly along the normal of each boundary face; 0: the boundary is free. Default: 1.
    pub align_boundary: i32,
    /// number of improvement rounds of AUTO. Default: 2.
    pub rounds: u32,
    /// minimum dihedral angle, in degrees, of boundary edges that an axis follows; 0: none. Default: 0.
    pub feature_angle: f64,
    /// smoothing ends with a step that gains less than this fraction of the energy. Default: 1e-6.
    pub relative_gain: f64,
    /// OBC\_FRAME\_FIELD\_NO\_REPAIR, REPAIR or SINGLE\_AXIS; not with DISSERTATION. Default: NO\_REPAIR.
    pub repair: i32,
    pub reserved: i32,
}

/// Constraints of a field. Frames and directions have length 1. A positive, possibly infinite weight may soften each constraint: a finite
/// weight w acts like w neighbors with the required frame, an infinite one fixes it. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_frame_field_constraints {
    pub struct_size: u32,
    pub reserved: i32,
    /// tetrahedra with a fixed frame. Default: NULL.
    pub frame_tetrahedra: *const u32,
    /// the frames, w x y z each. Default: NULL.
    pub frames: *const f64,
    /// number of fixed frames. Default: 0.
    pub frame_count: usize,
    /// tetrahedra with one axis fixed along a direction. Default: NULL.
    pub axis_tetrahedra: *const u32,
    /// the directions, x y z each. Default: NULL.
    pub axes: *const f64,
    /// number of fixed axes. Default: 0.
    pub axis_count: usize,
    /// weight of each frame; NULL: all infinite. Default: NULL.
    pub frame_weights: *const f64,
    /// weight of each axis; NULL: all infinite. Default: NULL.
    pub axis_weights: *const f64,
}

/// Figures of a field. Angles are in degrees, over inner faces: mean, standard deviation, median, 99th percentile, maximum.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_frame_field_report {
    pub struct_size: u32,
    /// initial field of most of the result; 0 for \_measure
    pub start: i32,
    /// energy of the field
    pub energy: f64,
    /// up to the 24 rotations, at most 62.80
    pub symmetric_mean: f64,
    /// up to the 24 rotations, at most 62.80
    pub symmetric_deviation: f64,
    /// up to the 24 rotations, at most 62.80
    pub symmetric_median: f64,
    /// up to the 24 rotations, at most 62.80
    pub symmetric_p99: f64,
    /// up to the 24 rotations, at most 62.80
    pub symmetric_max: f64,
    /// between the quaternions, at most 180
    pub plain_mean: f64,
    /// between the quaternions, at most 180
    pub plain_deviation: f64,
    /// between the quaternions, at most 180
    pub plain_median: f64,
    /// between the quaternions, at most 180
    pub plain_p99: f64,
    /// between the quaternions, at most 180
    pub plain_max: f64,
    /// numbers of faces; of inner faces with a symmetric angle above 30
    pub inner_faces: u64,
    /// numbers of faces; of inner faces with a symmetric angle above 30
    pub boundary_faces: u64,
    /// numbers of faces; of inner faces with a symmetric angle above 30
    pub above_30: u64,
    /// Maximum angle between a boundary normal and the nearest axis: over tetrahedra with one boundary face, and over those with several
    /// for the best and the worst of their faces (the best is not 0 for an axis between two normals).
    pub one_face_max: f64,
    /// Maximum angle between a boundary normal and the nearest axis: over tetrahedra with one boundary face, and over those with several
    /// for the best and the worst of their faces (the best is not 0 for an axis between two normals).
    pub several_best_max: f64,
    /// Maximum angle between a boundary normal and the nearest axis: over tetrahedra with one boundary face, and over those with several
    /// for the best and the worst of their faces (the best is not 0 for an axis between two normals).
    pub several_worst_max: f64,
    /// Numbers of singular edges, around which the frames turn by a rotation of the cube: all, quarter and half turns about an axis,
    /// third turns about a space diagonal and half turns about a face diagonal; no hexahedral mesh has the latter two.
    pub singular_edges: u64,
    /// Numbers of singular edges, around which the frames turn by a rotation of the cube: all, quarter and half turns about an axis,
    /// third turns about a space diagonal and half turns about a face diagonal; no hexahedral mesh has the latter two.
    pub singular_quarter: u64,
    /// Numbers of singular edges, around which the frames turn by a rotation of the cube: all, quarter and half turns about an axis,
    /// third turns about a space diagonal and half turns about a face diagonal; no hexahedral mesh has the latter two.
    pub singular_half: u64,
    /// Numbers of singular edges, around which the frames turn by a rotation of the cube: all, quarter and half turns about an axis,
    /// third turns about a space diagonal and half turns about a face diagonal; no hexahedral mesh has the latter two.
    pub singular_third: u64,
    /// Numbers of singular edges, around which the frames turn by a rotation of the cube: all, quarter and half turns about an axis,
    /// third turns about a space diagonal and half turns about a face diagonal; no hexahedral mesh has the latter two.
    pub singular_diagonal: u64,
    /// Numbers of curves (chains of singular edges through inner vertices with two of them), of closed ones, of nodes (inner vertices with
    /// three or more singular edges), of ends on the boundary, and of ends inside, which is 0 for every solid.
    pub curves: u64,
    /// Numbers of curves (chains of singular edges through inner vertices with two of them), of closed ones, of nodes (inner vertices with
    /// three or more singular edges), of ends on the boundary, and of ends inside, which is 0 for every solid.
    pub closed_curves: u64,
    /// Numbers of curves (chains of singular edges through inner vertices with two of them), of closed ones, of nodes (inner vertices with
    /// three or more singular edges), of ends on the boundary, and of ends inside, which is 0 for every solid.
    pub nodes: u64,
    /// Numbers of curves (chains of singular edges through inner vertices with two of them), of closed ones, of nodes (inner vertices with
    /// three or more singular edges), of ends on the boundary, and of ends inside, which is 0 for every solid.
    pub boundary_ends: u64,
    /// Numbers of curves (chains of singular edges through inner vertices with two of them), of closed ones, of nodes (inner vertices with
    /// three or more singular edges), of ends on the boundary, and of ends inside, which is 0 for every solid.
    pub dead_ends: u64,
    /// total length of singular edges and of all inner edges
    pub singular_length: f64,
    /// total length of singular edges and of all inner edges
    pub edge_length: f64,
    /// four times the index sum of the boundary cross field
    pub boundary_index_quarters: i64,
    /// of the boundary: a quarter of boundary\_index\_quarters
    pub euler_characteristic: i64,
    /// numbers of smoothing steps and of iterations of linear solvers
    pub smoothing_steps: u64,
    /// numbers of smoothing steps and of iterations of linear solvers
    pub solver_iterations: u64,
    /// 1 if a hexahedral mesh could have the field around every inner edge and vertex, otherwise 0; numbers of edges that are not
    /// quarter turns, of vertices at which a curve of valence 3 becomes one of valence 5, and of nodes that no hexahedral mesh has.
    pub locally_meshable: u64,
    /// 1 if a hexahedral mesh could have the field around every inner edge and vertex, otherwise 0; numbers of edges that are not
    /// quarter turns, of vertices at which a curve of valence 3 becomes one of valence 5, and of nodes that no hexahedral mesh has.
    pub improper_edges: u64,
    /// 1 if a hexahedral mesh could have the field around every inner edge and vertex, otherwise 0; numbers of edges that are not
    /// quarter turns, of vertices at which a curve of valence 3 becomes one of valence 5, and of nodes that no hexahedral mesh has.
    pub turning_points: u64,
    /// 1 if a hexahedral mesh could have the field around every inner edge and vertex, otherwise 0; numbers of edges that are not
    /// quarter turns, of vertices at which a curve of valence 3 becomes one of valence 5, and of nodes that no hexahedral mesh has.
    pub improper_nodes: u64,
    /// number of closed curves of up to six edges, and of curves of one edge
    pub fragments: u64,
    /// with repairs: number of rounds, and counts before them
    pub repair_rounds: u64,
    /// with repairs: number of rounds, and counts before them
    pub unmeshable_before: u64,
    /// with repairs: number of rounds, and counts before them
    pub fragments_before: u64,
    /// with repairs: energy before them
    pub energy_before_repair: f64,
}

extern "C" {
    /// Fill options with the defaults, constraints with none, and a report with zeros.
    pub fn obc_frame_field_options_init(options: *mut obc_frame_field_options, struct_size: usize) -> i32;
    /// Fill options with the defaults, constraints with none, and a report with zeros.
    pub fn obc_frame_field_constraints_init(constraints: *mut obc_frame_field_constraints, struct_size: usize) -> i32;
    /// Fill options with the defaults, constraints with none, and a report with zeros.
    pub fn obc_frame_field_report_init(report: *mut obc_frame_field_report, struct_size: usize) -> i32;
    /// Computes a field of low energy. frames: 4 \* tetrahedron\_count doubles, read for OBC\_FRAME\_FIELD\_GIVEN, and written on success only.
    /// options, constraints, host and report may be NULL. O(n), up to 1 KB a tetrahedron. Errors: invalid argument (NULL, NaN, index out
    /// of range, options), degenerate (a repeated vertex), not manifold (a face with three tetrahedra, neighbors on the same side of a
    /// face), out of memory, cancelled.
    pub fn obc_frame_field_compute(solid: *const obc_frame_field_solid, options: *const obc_frame_field_options, constraints: *const obc_frame_field_constraints, host: *const obc_host, frames: *mut f64, report: *mut obc_frame_field_report, error: *mut obc_error) -> i32;
    /// Measures any field: frames, 4 \* tetrahedron\_count doubles, normalized before use. host may be NULL. O(n). Errors: as \_compute.
    pub fn obc_frame_field_measure(solid: *const obc_frame_field_solid, frames: *const f64, host: *const obc_host, report: *mut obc_frame_field_report, error: *mut obc_error) -> i32;
    /// Computes the matching of each face: 4 \* tetrahedron\_count numbers, entry 4 t + k for the face of tetrahedron t opposite its vertex k. It
    /// is the rotation of the cube (numbered as in obc\_quaternion\_cube\_element) that, in its own axes, brings frame t nearest to that of the
    /// neighbor; 0 on the boundary. O(n). Errors: as \_compute.
    pub fn obc_frame_field_matchings(solid: *const obc_frame_field_solid, frames: *const f64, host: *const obc_host, matchings: *mut u8, error: *mut obc_error) -> i32;
    /// Finds the singular edges and curves of a field. host may be NULL; its allocator must remain valid until \_destroy. O(n). Errors: as
    /// \_compute.
    pub fn obc_frame_field_singularities_create(solid: *const obc_frame_field_solid, frames: *const f64, host: *const obc_host, out: *mut *mut obc_frame_field_singularities, error: *mut obc_error) -> i32;
    /// Destroys the singularities; NULL is allowed.
    pub fn obc_frame_field_singularities_destroy(singularities: *mut obc_frame_field_singularities);
    /// Return the numbers of singular edges, curves and nodes; 0 for NULL.
    pub fn obc_frame_field_singular_edge_count(singularities: *const obc_frame_field_singularities) -> usize;
    /// Return the numbers of singular edges, curves and nodes; 0 for NULL.
    pub fn obc_frame_field_singular_curve_count(singularities: *const obc_frame_field_singularities) -> usize;
    /// Return the numbers of singular edges, curves and nodes; 0 for NULL.
    pub fn obc_frame_field_singular_node_count(singularities: *const obc_frame_field_singularities) -> usize;
    /// Copies to arrays of the caller, each of which may be NULL: for each edge two vertices, the rotation of the cube around it, and its
    /// turn: 1 for valence 3 of a hexahedral mesh, -1 for valence 5, 2 for a half turn, 0 where no hexahedral mesh exists. curve\_begin (curve
    /// count + 1) are offsets of the curves into curve\_edges (edge count), the edges in order along each. nodes are vertices. Errors:
    /// invalid argument.
    pub fn obc_frame_field_singularities_copy(singularities: *const obc_frame_field_singularities, edge_vertices: *mut u32, edge_rotations: *mut u8, edge_turns: *mut i8, curve_begin: *mut usize, curve_edges: *mut u32, nodes: *mut u32, error: *mut obc_error) -> i32;
    /// Return the numbers of unmeshable elements: singular edges that are not quarter turns about an axis, and inner vertices whose
    /// singular edges no hexahedral mesh has (turning points and nodes). Both are 0 for a locally meshable field and for NULL.
    pub fn obc_frame_field_unmeshable_edge_count(singularities: *const obc_frame_field_singularities) -> usize;
    /// Return the numbers of unmeshable elements: singular edges that are not quarter turns about an axis, and inner vertices whose
    /// singular edges no hexahedral mesh has (turning points and nodes). Both are 0 for a locally meshable field and for NULL.
    pub fn obc_frame_field_unmeshable_vertex_count(singularities: *const obc_frame_field_singularities) -> usize;
    /// Copies the unmeshable elements to arrays of the caller, each of which may be NULL: edges as indices of singular edges, vertices as
    /// indices of the solid, both ascending. Errors: invalid argument.
    pub fn obc_frame_field_unmeshable_copy(singularities: *const obc_frame_field_singularities, edges: *mut u32, vertices: *mut u32, error: *mut obc_error) -> i32;
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_frame_field_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_frame_field_solid>(), align_of::<obc_frame_field_solid>()), (32, 8));
        let it = MaybeUninit::<obc_frame_field_solid>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).positions) } as usize - start as usize, 0, "obc_frame_field_solid.positions");
        assert_eq!(unsafe { addr_of!((*start).vertex_count) } as usize - start as usize, 8, "obc_frame_field_solid.vertex_count");
        assert_eq!(unsafe { addr_of!((*start).tetrahedra) } as usize - start as usize, 16, "obc_frame_field_solid.tetrahedra");
        assert_eq!(unsafe { addr_of!((*start).tetrahedron_count) } as usize - start as usize, 24, "obc_frame_field_solid.tetrahedron_count");
        assert_eq!((size_of::<obc_frame_field_options>(), align_of::<obc_frame_field_options>()), (48, 8));
        let it = MaybeUninit::<obc_frame_field_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_frame_field_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).start) } as usize - start as usize, 4, "obc_frame_field_options.start");
        assert_eq!(unsafe { addr_of!((*start).method) } as usize - start as usize, 8, "obc_frame_field_options.method");
        assert_eq!(unsafe { addr_of!((*start).weighting) } as usize - start as usize, 12, "obc_frame_field_options.weighting");
        assert_eq!(unsafe { addr_of!((*start).align_boundary) } as usize - start as usize, 16, "obc_frame_field_options.align_boundary");
        assert_eq!(unsafe { addr_of!((*start).rounds) } as usize - start as usize, 20, "obc_frame_field_options.rounds");
        assert_eq!(unsafe { addr_of!((*start).feature_angle) } as usize - start as usize, 24, "obc_frame_field_options.feature_angle");
        assert_eq!(unsafe { addr_of!((*start).relative_gain) } as usize - start as usize, 32, "obc_frame_field_options.relative_gain");
        assert_eq!(unsafe { addr_of!((*start).repair) } as usize - start as usize, 40, "obc_frame_field_options.repair");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 44, "obc_frame_field_options.reserved");
        assert_eq!((size_of::<obc_frame_field_constraints>(), align_of::<obc_frame_field_constraints>()), (72, 8));
        let it = MaybeUninit::<obc_frame_field_constraints>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_frame_field_constraints.struct_size");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 4, "obc_frame_field_constraints.reserved");
        assert_eq!(unsafe { addr_of!((*start).frame_tetrahedra) } as usize - start as usize, 8, "obc_frame_field_constraints.frame_tetrahedra");
        assert_eq!(unsafe { addr_of!((*start).frames) } as usize - start as usize, 16, "obc_frame_field_constraints.frames");
        assert_eq!(unsafe { addr_of!((*start).frame_count) } as usize - start as usize, 24, "obc_frame_field_constraints.frame_count");
        assert_eq!(unsafe { addr_of!((*start).axis_tetrahedra) } as usize - start as usize, 32, "obc_frame_field_constraints.axis_tetrahedra");
        assert_eq!(unsafe { addr_of!((*start).axes) } as usize - start as usize, 40, "obc_frame_field_constraints.axes");
        assert_eq!(unsafe { addr_of!((*start).axis_count) } as usize - start as usize, 48, "obc_frame_field_constraints.axis_count");
        assert_eq!(unsafe { addr_of!((*start).frame_weights) } as usize - start as usize, 56, "obc_frame_field_constraints.frame_weights");
        assert_eq!(unsafe { addr_of!((*start).axis_weights) } as usize - start as usize, 64, "obc_frame_field_constraints.axis_weights");
        assert_eq!((size_of::<obc_frame_field_report>(), align_of::<obc_frame_field_report>()), (344, 8));
        let it = MaybeUninit::<obc_frame_field_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_frame_field_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).start) } as usize - start as usize, 4, "obc_frame_field_report.start");
        assert_eq!(unsafe { addr_of!((*start).energy) } as usize - start as usize, 8, "obc_frame_field_report.energy");
        assert_eq!(unsafe { addr_of!((*start).symmetric_mean) } as usize - start as usize, 16, "obc_frame_field_report.symmetric_mean");
        assert_eq!(unsafe { addr_of!((*start).symmetric_deviation) } as usize - start as usize, 24, "obc_frame_field_report.symmetric_deviation");
        assert_eq!(unsafe { addr_of!((*start).symmetric_median) } as usize - start as usize, 32, "obc_frame_field_report.symmetric_median");
        assert_eq!(unsafe { addr_of!((*start).symmetric_p99) } as usize - start as usize, 40, "obc_frame_field_report.symmetric_p99");
        assert_eq!(unsafe { addr_of!((*start).symmetric_max) } as usize - start as usize, 48, "obc_frame_field_report.symmetric_max");
        assert_eq!(unsafe { addr_of!((*start).plain_mean) } as usize - start as usize, 56, "obc_frame_field_report.plain_mean");
        assert_eq!(unsafe { addr_of!((*start).plain_deviation) } as usize - start as usize, 64, "obc_frame_field_report.plain_deviation");
        assert_eq!(unsafe { addr_of!((*start).plain_median) } as usize - start as usize, 72, "obc_frame_field_report.plain_median");
        assert_eq!(unsafe { addr_of!((*start).plain_p99) } as usize - start as usize, 80, "obc_frame_field_report.plain_p99");
        assert_eq!(unsafe { addr_of!((*start).plain_max) } as usize - start as usize, 88, "obc_frame_field_report.plain_max");
        assert_eq!(unsafe { addr_of!((*start).inner_faces) } as usize - start as usize, 96, "obc_frame_field_report.inner_faces");
        assert_eq!(unsafe { addr_of!((*start).boundary_faces) } as usize - start as usize, 104, "obc_frame_field_report.boundary_faces");
        assert_eq!(unsafe { addr_of!((*start).above_30) } as usize - start as usize, 112, "obc_frame_field_report.above_30");
        assert_eq!(unsafe { addr_of!((*start).one_face_max) } as usize - start as usize, 120, "obc_frame_field_report.one_face_max");
        assert_eq!(unsafe { addr_of!((*start).several_best_max) } as usize - start as usize, 128, "obc_frame_field_report.several_best_max");
        assert_eq!(unsafe { addr_of!((*start).several_worst_max) } as usize - start as usize, 136, "obc_frame_field_report.several_worst_max");
        assert_eq!(unsafe { addr_of!((*start).singular_edges) } as usize - start as usize, 144, "obc_frame_field_report.singular_edges");
        assert_eq!(unsafe { addr_of!((*start).singular_quarter) } as usize - start as usize, 152, "obc_frame_field_report.singular_quarter");
        assert_eq!(unsafe { addr_of!((*start).singular_half) } as usize - start as usize, 160, "obc_frame_field_report.singular_half");
        assert_eq!(unsafe { addr_of!((*start).singular_third) } as usize - start as usize, 168, "obc_frame_field_report.singular_third");
        assert_eq!(unsafe { addr_of!((*start).singular_diagonal) } as usize - start as usize, 176, "obc_frame_field_report.singular_diagonal");
        assert_eq!(unsafe { addr_of!((*start).curves) } as usize - start as usize, 184, "obc_frame_field_report.curves");
        assert_eq!(unsafe { addr_of!((*start).closed_curves) } as usize - start as usize, 192, "obc_frame_field_report.closed_curves");
        assert_eq!(unsafe { addr_of!((*start).nodes) } as usize - start as usize, 200, "obc_frame_field_report.nodes");
        assert_eq!(unsafe { addr_of!((*start).boundary_ends) } as usize - start as usize, 208, "obc_frame_field_report.boundary_ends");
        assert_eq!(unsafe { addr_of!((*start).dead_ends) } as usize - start as usize, 216, "obc_frame_field_report.dead_ends");
        assert_eq!(unsafe { addr_of!((*start).singular_length) } as usize - start as usize, 224, "obc_frame_field_report.singular_length");
        assert_eq!(unsafe { addr_of!((*start).edge_length) } as usize - start as usize, 232, "obc_frame_field_report.edge_length");
        assert_eq!(unsafe { addr_of!((*start).boundary_index_quarters) } as usize - start as usize, 240, "obc_frame_field_report.boundary_index_quarters");
        assert_eq!(unsafe { addr_of!((*start).euler_characteristic) } as usize - start as usize, 248, "obc_frame_field_report.euler_characteristic");
        assert_eq!(unsafe { addr_of!((*start).smoothing_steps) } as usize - start as usize, 256, "obc_frame_field_report.smoothing_steps");
        assert_eq!(unsafe { addr_of!((*start).solver_iterations) } as usize - start as usize, 264, "obc_frame_field_report.solver_iterations");
        assert_eq!(unsafe { addr_of!((*start).locally_meshable) } as usize - start as usize, 272, "obc_frame_field_report.locally_meshable");
        assert_eq!(unsafe { addr_of!((*start).improper_edges) } as usize - start as usize, 280, "obc_frame_field_report.improper_edges");
        assert_eq!(unsafe { addr_of!((*start).turning_points) } as usize - start as usize, 288, "obc_frame_field_report.turning_points");
        assert_eq!(unsafe { addr_of!((*start).improper_nodes) } as usize - start as usize, 296, "obc_frame_field_report.improper_nodes");
        assert_eq!(unsafe { addr_of!((*start).fragments) } as usize - start as usize, 304, "obc_frame_field_report.fragments");
        assert_eq!(unsafe { addr_of!((*start).repair_rounds) } as usize - start as usize, 312, "obc_frame_field_report.repair_rounds");
        assert_eq!(unsafe { addr_of!((*start).unmeshable_before) } as usize - start as usize, 320, "obc_frame_field_report.unmeshable_before");
        assert_eq!(unsafe { addr_of!((*start).fragments_before) } as usize - start as usize, 328, "obc_frame_field_report.fragments_before");
        assert_eq!(unsafe { addr_of!((*start).energy_before_repair) } as usize - start as usize, 336, "obc_frame_field_report.energy_before_repair");
    }
}
