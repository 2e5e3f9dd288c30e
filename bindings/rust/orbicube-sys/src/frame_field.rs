//! What `<orbicube/frame_field.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};

/// several of these; of what they end in the best, region by region
pub const OBC_FRAME_FIELD_AUTO: i32 = 0;
/// the axes of space
pub const OBC_FRAME_FIELD_IDENTITY: i32 = 1;
/// the nearest boundary frame
pub const OBC_FRAME_FIELD_PROPAGATED: i32 = 2;
/// harmonics that satisfy Laplace's equation, projected
pub const OBC_FRAME_FIELD_HARMONIC: i32 = 3;
/// harmonic, then diffused and projected with falling times
pub const OBC_FRAME_FIELD_DIFFUSION: i32 = 4;
/// the field in \`frames\`
pub const OBC_FRAME_FIELD_GIVEN: i32 = 5;

pub const OBC_FRAME_FIELD_SMOOTH: i32 = 0;
/// identity inside, boundary frames held, matchings frozen: chapter 6 of the dissertation as printed
pub const OBC_FRAME_FIELD_SEED: i32 = 1;

/// every inner face counts alike
pub const OBC_FRAME_FIELD_UNIFORM: i32 = 0;
/// by area over the distance of the centres, scaled to mean 1
pub const OBC_FRAME_FIELD_GEOMETRIC: i32 = 1;

pub const OBC_FRAME_FIELD_NO_REPAIR: i32 = 0;
/// Third and half turns are zipped apart into quarter turns (Li et al. 2012), short loops and fragments collapse, and the
/// frames around are smoothed to fit; kept where fewer edges and vertices are unmeshable.
pub const OBC_FRAME_FIELD_REPAIR: i32 = 1;
/// The search starts from identity and stays among fields whose frames turn about one axis along each curve.
pub const OBC_FRAME_FIELD_SINGLE_AXIS: i32 = 2;

#[repr(C)]
pub struct obc_frame_field_singularities {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// A solid of tetrahedra: a view, kept by no function.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_frame_field_solid {
    pub positions: *const f64,
    pub vertex_count: usize,
    pub tetrahedra: *const u32,
    pub tetrahedron_count: usize,
}

/// Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_frame_field_options {
    pub struct_size: u32,
    /// OBC\_FRAME\_FIELD\_AUTO, ...; auto by default
    pub start: i32,
    /// OBC\_FRAME\_FIELD\_SMOOTH by default
    pub method: i32,
    /// OBC\_FRAME\_FIELD\_UNIFORM by default
    pub weighting: i32,
    /// 1: an axis along the normal of a boundary face, exactly; default 1
    pub align_boundary: i32,
    /// of improvement by the start auto; default 2
    pub rounds: u32,
    /// boundary edges that turn by more (radians) are followed by an axis; 0, the default: none
    pub feature_angle: f64,
    /// smoothing ends with a step that gains less than this part of the energy; default 1e-6
    pub relative_gain: f64,
    /// OBC\_FRAME\_FIELD\_NO\_REPAIR, ...; none by default; not with the method seed
    pub repair: i32,
    pub reserved: i32,
}

/// What the caller asks for. Fill with \_init, then set what there is. Frames and directions must be of length 1. With weights,
/// which are positive and may be infinite, those with a finite one are not held but pulled at, like by so many neighbours that
/// have what is wanted.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_frame_field_constraints {
    pub struct_size: u32,
    pub reserved: i32,
    /// tetrahedra whose frame is held
    pub frame_tetrahedra: *const u32,
    /// w x y z each
    pub frames: *const f64,
    pub frame_count: usize,
    /// tetrahedra of whose frame one axis is held along a direction
    pub axis_tetrahedra: *const u32,
    /// x y z each
    pub axes: *const f64,
    pub axis_count: usize,
    /// one each, or NULL: all are held
    pub frame_weights: *const f64,
    pub axis_weights: *const f64,
}

/// Figures of a field. Angles in degrees; symmetric ones are up to the 24 rotations, at most 62.80; plain ones between the
/// quaternions as they stand, at most 180. Over inner faces: mean, standard deviation, median, value at 99 per cent, largest.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_frame_field_report {
    pub struct_size: u32,
    /// that most of the field comes from; of \_measure 0
    pub start: i32,
    pub energy: f64,
    pub symmetric_mean: f64,
    pub symmetric_deviation: f64,
    pub symmetric_median: f64,
    pub symmetric_p99: f64,
    pub symmetric_max: f64,
    pub plain_mean: f64,
    pub plain_deviation: f64,
    pub plain_median: f64,
    pub plain_p99: f64,
    pub plain_max: f64,
    /// above\_30: inner faces with a greater symmetric angle
    pub inner_faces: u64,
    /// above\_30: inner faces with a greater symmetric angle
    pub boundary_faces: u64,
    /// above\_30: inner faces with a greater symmetric angle
    pub above_30: u64,
    /// Between boundary normals and the axes nearest to them: over tetrahedra with one boundary face, and over those with
    /// several, for the best and for the worst of their faces (the best is not 0 where an axis lies between two normals).
    pub one_face_max: f64,
    /// Between boundary normals and the axes nearest to them: over tetrahedra with one boundary face, and over those with
    /// several, for the best and for the worst of their faces (the best is not 0 where an axis lies between two normals).
    pub several_best_max: f64,
    /// Between boundary normals and the axes nearest to them: over tetrahedra with one boundary face, and over those with
    /// several, for the best and for the worst of their faces (the best is not 0 where an axis lies between two normals).
    pub several_worst_max: f64,
    /// Edges around which the frames turn by a rotation of the cube: quarter and half turns about an axis, third turns about a
    /// corner and half turns about an edge's middle, which no hexahedral mesh can have. Curves are chains of such edges through
    /// inner vertices with two of them, nodes inner vertices with three or more; dead\_ends is 0 for every solid.
    pub singular_edges: u64,
    /// Edges around which the frames turn by a rotation of the cube: quarter and half turns about an axis, third turns about a
    /// corner and half turns about an edge's middle, which no hexahedral mesh can have. Curves are chains of such edges through
    /// inner vertices with two of them, nodes inner vertices with three or more; dead\_ends is 0 for every solid.
    pub singular_quarter: u64,
    /// Edges around which the frames turn by a rotation of the cube: quarter and half turns about an axis, third turns about a
    /// corner and half turns about an edge's middle, which no hexahedral mesh can have. Curves are chains of such edges through
    /// inner vertices with two of them, nodes inner vertices with three or more; dead\_ends is 0 for every solid.
    pub singular_half: u64,
    /// Edges around which the frames turn by a rotation of the cube: quarter and half turns about an axis, third turns about a
    /// corner and half turns about an edge's middle, which no hexahedral mesh can have. Curves are chains of such edges through
    /// inner vertices with two of them, nodes inner vertices with three or more; dead\_ends is 0 for every solid.
    pub singular_third: u64,
    /// Edges around which the frames turn by a rotation of the cube: quarter and half turns about an axis, third turns about a
    /// corner and half turns about an edge's middle, which no hexahedral mesh can have. Curves are chains of such edges through
    /// inner vertices with two of them, nodes inner vertices with three or more; dead\_ends is 0 for every solid.
    pub singular_diagonal: u64,
    pub curves: u64,
    pub closed_curves: u64,
    pub nodes: u64,
    pub boundary_ends: u64,
    pub dead_ends: u64,
    /// of singular and of all inner edges
    pub singular_length: f64,
    /// of singular and of all inner edges
    pub edge_length: f64,
    /// four times the sum of the boundary cross field's indices
    pub boundary_index_quarters: i64,
    /// of the boundary: equal to a quarter of that
    pub euler_characteristic: i64,
    pub smoothing_steps: u64,
    pub solver_iterations: u64,
    /// Whether the field is that of a hexahedral mesh around every inner edge and vertex, and if not, why: edges that are no
    /// quarter turns, vertices where a curve of threes becomes one of fives, nodes that no hexahedral mesh has.
    pub locally_meshable: u64,
    /// Whether the field is that of a hexahedral mesh around every inner edge and vertex, and if not, why: edges that are no
    /// quarter turns, vertices where a curve of threes becomes one of fives, nodes that no hexahedral mesh has.
    pub improper_edges: u64,
    /// Whether the field is that of a hexahedral mesh around every inner edge and vertex, and if not, why: edges that are no
    /// quarter turns, vertices where a curve of threes becomes one of fives, nodes that no hexahedral mesh has.
    pub turning_points: u64,
    /// Whether the field is that of a hexahedral mesh around every inner edge and vertex, and if not, why: edges that are no
    /// quarter turns, vertices where a curve of threes becomes one of fives, nodes that no hexahedral mesh has.
    pub improper_nodes: u64,
    /// closed curves of at most six edges, and curves of one edge
    pub fragments: u64,
    /// With repairs: rounds, and what was there before them. The energy after them is \`energy\`.
    pub repair_rounds: u64,
    /// With repairs: rounds, and what was there before them. The energy after them is \`energy\`.
    pub unmeshable_before: u64,
    /// With repairs: rounds, and what was there before them. The energy after them is \`energy\`.
    pub fragments_before: u64,
    pub energy_before_repair: f64,
}

extern "C" {
    /// Fill options, constraints and reports with the defaults, no constraints, and zeros.
    pub fn obc_frame_field_options_init(options: *mut obc_frame_field_options, struct_size: usize) -> i32;
    /// Fill options, constraints and reports with the defaults, no constraints, and zeros.
    pub fn obc_frame_field_constraints_init(constraints: *mut obc_frame_field_constraints, struct_size: usize) -> i32;
    /// Fill options, constraints and reports with the defaults, no constraints, and zeros.
    pub fn obc_frame_field_report_init(report: *mut obc_frame_field_report, struct_size: usize) -> i32;
    /// Computes a field of small energy. frames: 4 \* tetrahedron\_count doubles, read with the start given, and written on success
    /// only. options, constraints, host and report may be NULL. O(n), at most 1 KB a tetrahedron.
    /// Errors: invalid argument (NULL, NaN, index out of range, options), degenerate (a repeated vertex), not manifold (a face of
    /// three tetrahedra, neighbours on the same side of a face), out of memory, cancelled.
    pub fn obc_frame_field_compute(solid: *const obc_frame_field_solid, options: *const obc_frame_field_options, constraints: *const obc_frame_field_constraints, host: *const obc_host, frames: *mut f64, report: *mut obc_frame_field_report, error: *mut obc_error) -> i32;
    /// Figures of any field: frames, 4 \* tetrahedron\_count doubles, normalised before use. host may be NULL. O(n).
    /// Errors: as \_compute.
    pub fn obc_frame_field_measure(solid: *const obc_frame_field_solid, frames: *const f64, host: *const obc_host, report: *mut obc_frame_field_report, error: *mut obc_error) -> i32;
    /// How the frames on both sides of the faces match: 4 \* tetrahedron\_count numbers, that at 4 t + k for the face of
    /// tetrahedron t opposite its corner k: the rotation of the cube (its number in obc\_quaternion\_cube\_element) that, in its own
    /// axes, brings frame t next to that of the neighbour; 0 on the boundary. Errors: as \_compute. O(n).
    pub fn obc_frame_field_matchings(solid: *const obc_frame_field_solid, frames: *const f64, host: *const obc_host, matchings: *mut u8, error: *mut obc_error) -> i32;
    /// The singular edges of a field and the curves that they form, in a handle. host may be NULL; its allocator must stay valid
    /// until \_destroy. Errors: as \_compute. O(n).
    pub fn obc_frame_field_singularities_create(solid: *const obc_frame_field_solid, frames: *const f64, host: *const obc_host, out: *mut *mut obc_frame_field_singularities, error: *mut obc_error) -> i32;
    /// The singular edges of a field and the curves that they form, in a handle. host may be NULL; its allocator must stay valid
    /// until \_destroy. Errors: as \_compute. O(n).
    pub fn obc_frame_field_singularities_destroy(singularities: *mut obc_frame_field_singularities);
    /// Numbers; 0 for NULL.
    pub fn obc_frame_field_singular_edge_count(singularities: *const obc_frame_field_singularities) -> usize;
    /// Numbers; 0 for NULL.
    pub fn obc_frame_field_singular_curve_count(singularities: *const obc_frame_field_singularities) -> usize;
    /// Numbers; 0 for NULL.
    pub fn obc_frame_field_singular_node_count(singularities: *const obc_frame_field_singularities) -> usize;
    /// Copies to the caller's arrays, each of which may be NULL. Edges: two vertices each; their rotation of the cube around the
    /// edge; their turn, 1 where hexahedra would meet in threes, -1 in fives, 2 for half turns, 0 where they cannot. Curves:
    /// curve\_begin (curve count + 1) says where each begins in curve\_edges (edge count), the edges in order along it. Nodes: their
    /// vertices. Errors: invalid argument.
    pub fn obc_frame_field_singularities_copy(singularities: *const obc_frame_field_singularities, edge_vertices: *mut u32, edge_rotations: *mut u8, edge_turns: *mut i8, curve_begin: *mut usize, curve_edges: *mut u32, nodes: *mut u32, error: *mut obc_error) -> i32;
    /// Where the field cannot be that of a hexahedral mesh: singular edges that are no quarter turns about an axis, and inner
    /// vertices whose edges of threes and fives no hexahedral mesh has (turning points and nodes). Both counts are 0 when the field
    /// is locally meshable, and for NULL.
    pub fn obc_frame_field_unmeshable_edge_count(singularities: *const obc_frame_field_singularities) -> usize;
    /// Where the field cannot be that of a hexahedral mesh: singular edges that are no quarter turns about an axis, and inner
    /// vertices whose edges of threes and fives no hexahedral mesh has (turning points and nodes). Both counts are 0 when the field
    /// is locally meshable, and for NULL.
    pub fn obc_frame_field_unmeshable_vertex_count(singularities: *const obc_frame_field_singularities) -> usize;
    /// Copies them to the caller's arrays, each of which may be NULL: the edges as numbers of singular edges, the vertices as
    /// indices of the solid's, both ascending. Errors: invalid argument.
    pub fn obc_frame_field_unmeshable_copy(singularities: *const obc_frame_field_singularities, edges: *mut u32, vertices: *mut u32, error: *mut obc_error) -> i32;
    /// Version of the library, major \* 10000 + minor \* 100 + patch.
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
