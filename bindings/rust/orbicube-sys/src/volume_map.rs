//! What `<orbicube/volume_map.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use crate::mesh::obc_surface;

/// A layer of hexahedra along the boundary: where it serves, by the angles at the edges of the polycube (on all its faces, on some
/// or on none; where that turns out bad, none or all are tried, too); everywhere; nowhere.
pub const OBC_VOLUME_MAP_PADDING_AUTO: i32 = 0;
/// A layer of hexahedra along the boundary: where it serves, by the angles at the edges of the polycube (on all its faces, on some
/// or on none; where that turns out bad, none or all are tried, too); everywhere; nowhere.
pub const OBC_VOLUME_MAP_PADDING_WITH: i32 = 1;
/// A layer of hexahedra along the boundary: where it serves, by the angles at the edges of the polycube (on all its faces, on some
/// or on none; where that turns out bad, none or all are tried, too); everywhere; nowhere.
pub const OBC_VOLUME_MAP_PADDING_WITHOUT: i32 = 2;

/// What is filled with cells: a polycube of the surface; the box of the surface, of which the cells inside are taken, with a layer
/// around, which serves any shape but has more irregular edges; or the polycube, and the box where its hexahedra are not near to
/// the surface (distance, below), even twice as many, or poor (0.3 in scaled Jacobians), or where there is no polycube or one that
/// changes angles twofold. The box needs a layer: with padding without, auto is polycube, and voxels are an invalid argument.
pub const OBC_VOLUME_MAP_METHOD_AUTO: i32 = 0;
/// What is filled with cells: a polycube of the surface; the box of the surface, of which the cells inside are taken, with a layer
/// around, which serves any shape but has more irregular edges; or the polycube, and the box where its hexahedra are not near to
/// the surface (distance, below), even twice as many, or poor (0.3 in scaled Jacobians), or where there is no polycube or one that
/// changes angles twofold. The box needs a layer: with padding without, auto is polycube, and voxels are an invalid argument.
pub const OBC_VOLUME_MAP_METHOD_POLYCUBE: i32 = 1;
/// What is filled with cells: a polycube of the surface; the box of the surface, of which the cells inside are taken, with a layer
/// around, which serves any shape but has more irregular edges; or the polycube, and the box where its hexahedra are not near to
/// the surface (distance, below), even twice as many, or poor (0.3 in scaled Jacobians), or where there is no polycube or one that
/// changes angles twofold. The box needs a layer: with padding without, auto is polycube, and voxels are an invalid argument.
pub const OBC_VOLUME_MAP_METHOD_VOXELS: i32 = 2;

/// A map of a solid to a polycube, one to one.
#[repr(C)]
pub struct obc_volume_map_solid {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// A mesh of hexahedra, certified.
#[repr(C)]
pub struct obc_volume_map_hexes {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

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

/// Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_solid_options {
    pub struct_size: u32,
    pub reserved: i32,
    /// of the polycube of a wall at most, as in obc\_polycube\_options. Default 100
    pub corners: usize,
    /// of what is chosen at random. Default 0
    pub seed: u64,
}

/// Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_hexes_options {
    pub struct_size: u32,
    /// OBC\_VOLUME\_MAP\_PADDING\_...; auto by default
    pub padding: i32,
    /// about so many hexahedra, 1 to 10 million. Default 10000
    pub cells: usize,
    /// of the polycube of a wall at most, as in obc\_polycube\_options. Default 100
    pub corners: usize,
    /// a surface of more than twice as many is mapped by a coarser one of about so many; 0: never. Default 6000
    pub triangles: usize,
    /// of what the polycube chooses at random. Default 0
    pub seed: u64,
    /// of smoothing. Default 40
    pub rounds: i32,
    /// OBC\_VOLUME\_MAP\_METHOD\_...; auto by default
    pub method: i32,
    /// In percent, 0 to 100: so far the boundary may be from the surface and the surface from the boundary, of the diagonal of its
    /// box, and so much the volume may differ. Where that is not so, there are twice as many cells, and again, up to most\_cells;
    /// the nearest is answered. 0: nothing is asked for. Default 1
    pub distance: f64,
    /// about, 10 million at most; where less than cells, these are not changed. Default 100000
    pub most_cells: usize,
    /// Edges where the surface bends by so many degrees or more, 0 to below 180, are edges of hexahedra, where the polycube has edges
    /// nearby, unless hexahedra there would be bad; 0: none. Default 40
    pub sharp_angle: f64,
}

/// What was made. Fill struct\_size. The scaled Jacobian of a hexahedron is the least, over its corners, of the determinant of the
/// three edges there over the product of their lengths: 1 for a box.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_hexes_report {
    pub struct_size: u32,
    /// 1: with a layer along the boundary or parts of it
    pub padded: i32,
    pub least_scaled_jacobian: f64,
    pub mean_scaled_jacobian: f64,
    /// of the trilinear hexahedra
    pub volume: f64,
    /// of the polycubes of all walls; 0 where there is none
    pub polycube_corners: usize,
    /// vertices of the boundary that could not be put where they belong
    pub off_surface: usize,
    /// In percent, the farther of both ways, of points 1/400 of the diagonal apart at most, and of the volume of the surface.
    pub distance: f64,
    /// In percent, the farther of both ways, of points 1/400 of the diagonal apart at most, and of the volume of the surface.
    pub volume_error: f64,
    /// 1: those that the polycube has edges for
    pub follows_sharp_edges: i32,
    /// 1: cells of the box, of one piece at least
    pub by_voxels: i32,
}

/// Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_frame_options {
    pub struct_size: u32,
    /// of smoothing. Default 40
    pub rounds: i32,
    /// about so many hexahedra, 1 to 10 million. Default 10000
    pub cells: usize,
    /// where frames are not given: an axis follows edges of the boundary that turn by more (radians);
    /// 0: none. Default 0
    pub feature_angle: f64,
    /// As in obc\_volume\_map\_hexes\_options, of the boundary of the solid. Defaults 1 and 100000
    pub distance: f64,
    pub most_cells: usize,
}

/// What was made. Fill struct\_size. Scaled Jacobians as in obc\_volume\_map\_hexes\_report.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_frame_report {
    pub struct_size: u32,
    /// 1: the search for the best integers came to its end
    pub integers_optimal: i32,
    pub least_scaled_jacobian: f64,
    pub mean_scaled_jacobian: f64,
    /// of the trilinear hexahedra
    pub volume: f64,
    /// vertices of the boundary that could not be put where they belong
    pub off_surface: usize,
    /// of the tetrahedra, inside
    pub singular_edges: usize,
    /// of the hexahedra, inside: with other than four around
    pub irregular_edges: usize,
    /// unknown ones of the map
    pub integers: usize,
    /// of the map, after splits
    pub tetrahedra: usize,
    /// of these, when integers were chosen; none are in the end
    pub inverted_at_start: usize,
    /// of Newton's method until there were none and the map was better
    pub steps: usize,
    /// as in obc\_volume\_map\_hexes\_report
    pub distance: f64,
    /// as in obc\_volume\_map\_hexes\_report
    pub volume_error: f64,
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
    /// tangle-\>positions. About 700 bytes a tetrahedron; a step is O(n) but for its conjugate gradients, 150 at most.
    /// Errors: no valid result (some stay inverted: how many and the first; result and report then have the best that was found, on
    /// all other errors nothing); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
    /// not manifold (kinds non-manifold-face and inconsistent-orientation: three tetrahedra at a face, or two on one side of it);
    /// malformed file (kind index-range), degenerate (kinds degenerate-cell and inverted-cell: a repeated vertex, a tetrahedron of
    /// rest that is not positive; degenerate-geometry: no volume at all), out of memory, cancelled.
    pub fn obc_volume_map_untangle(tangle: *const obc_volume_map_tangle, options: *const obc_volume_map_untangle_options, host: *const obc_host, result: *mut f64, report: *mut obc_volume_map_untangle_report, error: *mut obc_error) -> i32;
    /// The defaults, which the members' comments give.
    pub fn obc_volume_map_solid_options_init(options: *mut obc_volume_map_solid_options, struct_size: usize) -> i32;
    /// Finds a polycube of the boundary of a solid and a map of the solid to it: every tetrahedron is positive, on the polycube and
    /// in space, and the boundary covers the polycube once. positions: x y z a vertex; tetrahedra: four vertices each, positive,
    /// meeting in whole faces. Tetrahedra are split where the map needs that. options and host may be NULL; the allocator of the
    /// host must stay valid until \_destroy. Minutes for a hundred thousand tetrahedra.
    /// A cavity gets a polycube within that of the outer wall; the polycubes of pieces stand side by side along x.
    /// Errors: invalid argument; malformed file (index-range), degenerate, not manifold, not closed; no valid result with what stood
    /// in the way; out of memory, cancelled.
    pub fn obc_volume_map_solid_compute(positions: *const f64, vertex_count: usize, tetrahedra: *const u32, tetrahedron_count: usize, options: *const obc_volume_map_solid_options, host: *const obc_host, out: *mut *mut obc_volume_map_solid, error: *mut obc_error) -> i32;
    /// NULL is fine, here and in the functions that count (0).
    pub fn obc_volume_map_solid_destroy(solid: *mut obc_volume_map_solid);
    /// NULL is fine, here and in the functions that count (0).
    pub fn obc_volume_map_solid_vertex_count(solid: *const obc_volume_map_solid) -> usize;
    /// NULL is fine, here and in the functions that count (0).
    pub fn obc_volume_map_solid_tetrahedron_count(solid: *const obc_volume_map_solid) -> usize;
    /// x y z a vertex in space, and on the polycube; four vertices a tetrahedron. Each may be NULL. Errors: invalid argument.
    pub fn obc_volume_map_solid_copy(solid: *const obc_volume_map_solid, positions: *mut f64, polycube: *mut f64, tetrahedra: *mut u32, error: *mut obc_error) -> i32;
    /// The defaults, which the members' comments give.
    pub fn obc_volume_map_hexes_options_init(options: *mut obc_volume_map_hexes_options, struct_size: usize) -> i32;
    /// Fills a closed surface with hexahedra: oriented, looking outward, of any genus, in one piece or in several that lie apart,
    /// which get their parts of the cells by their volumes. Parts within a piece that look inward are the walls of cavities, which
    /// stay empty. Hexahedra meet in whole faces, the boundary has the parts and the genus of the surface, each hexahedron has
    /// positive corners by exact signs and a trilinear map that is certainly positive. In the report of several pieces, corners and
    /// vertices are all of them, distance and volume\_error the largest, in percent of its own piece. options, host and report may be
    /// NULL; the allocator of the host must stay valid until \_destroy.
    /// Errors: invalid argument; not closed; not manifold (kinds self-intersection: parts that meet, inconsistent-orientation: parts
    /// that look into the solid); degenerate; malformed file; no valid result with what stood in the way; out of memory, cancelled.
    pub fn obc_volume_map_hexes_compute(surface: *const obc_surface, options: *const obc_volume_map_hexes_options, host: *const obc_host, report: *mut obc_volume_map_hexes_report, out: *mut *mut obc_volume_map_hexes, error: *mut obc_error) -> i32;
    /// NULL is fine, here and in the functions that count (0).
    pub fn obc_volume_map_hexes_destroy(hexes: *mut obc_volume_map_hexes);
    /// NULL is fine, here and in the functions that count (0).
    pub fn obc_volume_map_hexes_vertex_count(hexes: *const obc_volume_map_hexes) -> usize;
    /// NULL is fine, here and in the functions that count (0).
    pub fn obc_volume_map_hexes_count(hexes: *const obc_volume_map_hexes) -> usize;
    /// NULL is fine, here and in the functions that count (0).
    pub fn obc_volume_map_hexes_quad_count(hexes: *const obc_volume_map_hexes) -> usize;
    /// x y z a vertex; eight vertices a hexahedron, in the order of MEDIT and VTK; four vertices a quad of the boundary,
    /// counter-clockwise seen from outside, and the face of the polycube that it lies on (0 by voxels). Each may be NULL. Errors: invalid
    /// argument.
    pub fn obc_volume_map_hexes_copy(hexes: *const obc_volume_map_hexes, positions: *mut f64, hexahedra: *mut u32, quads: *mut u32, quad_faces: *mut u32, error: *mut obc_error) -> i32;
    /// The defaults, which the members' comments give.
    pub fn obc_volume_map_frame_options_init(options: *mut obc_volume_map_frame_options, struct_size: usize) -> i32;
    /// Fills a solid with hexahedra that follow a frame field, with its singular edges inside (CubeCover: Nieser, Reitebuch and
    /// Polthier 2011). positions: x y z a vertex; tetrahedra: four vertices each, positive, meeting in whole faces; frames: w x y z a
    /// tetrahedron as in \<orbicube/frame\_field.h\>, with an axis along the normal at the boundary, or NULL: several smooth fields are
    /// made and repaired, until a map follows one. The faces of the result (obc\_volume\_map\_hexes\_copy) are the parts of the boundary
    /// that lie in one plane of the map. Where their boundary is farther from that of the solid than asked for, it is held there, then
    /// there are more cells, as in obc\_volume\_map\_hexes\_compute. options, host and report may be NULL; the allocator of the host must stay valid until \_destroy.
    /// Errors: invalid argument; malformed file (index-range), degenerate, not manifold; no valid result for a field that no such map
    /// has, with the singular edge and its curve or the layer that would collapse, and for maps that stay inverted, with the place;
    /// out of memory, cancelled.
    pub fn obc_volume_map_frame_hexes_compute(positions: *const f64, vertex_count: usize, tetrahedra: *const u32, tetrahedron_count: usize, frames: *const f64, options: *const obc_volume_map_frame_options, host: *const obc_host, report: *mut obc_volume_map_frame_report, out: *mut *mut obc_volume_map_hexes, error: *mut obc_error) -> i32;
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
        assert_eq!((size_of::<obc_volume_map_solid_options>(), align_of::<obc_volume_map_solid_options>()), (24, 8));
        let it = MaybeUninit::<obc_volume_map_solid_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_volume_map_solid_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 4, "obc_volume_map_solid_options.reserved");
        assert_eq!(unsafe { addr_of!((*start).corners) } as usize - start as usize, 8, "obc_volume_map_solid_options.corners");
        assert_eq!(unsafe { addr_of!((*start).seed) } as usize - start as usize, 16, "obc_volume_map_solid_options.seed");
        assert_eq!((size_of::<obc_volume_map_hexes_options>(), align_of::<obc_volume_map_hexes_options>()), (72, 8));
        let it = MaybeUninit::<obc_volume_map_hexes_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_volume_map_hexes_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).padding) } as usize - start as usize, 4, "obc_volume_map_hexes_options.padding");
        assert_eq!(unsafe { addr_of!((*start).cells) } as usize - start as usize, 8, "obc_volume_map_hexes_options.cells");
        assert_eq!(unsafe { addr_of!((*start).corners) } as usize - start as usize, 16, "obc_volume_map_hexes_options.corners");
        assert_eq!(unsafe { addr_of!((*start).triangles) } as usize - start as usize, 24, "obc_volume_map_hexes_options.triangles");
        assert_eq!(unsafe { addr_of!((*start).seed) } as usize - start as usize, 32, "obc_volume_map_hexes_options.seed");
        assert_eq!(unsafe { addr_of!((*start).rounds) } as usize - start as usize, 40, "obc_volume_map_hexes_options.rounds");
        assert_eq!(unsafe { addr_of!((*start).method) } as usize - start as usize, 44, "obc_volume_map_hexes_options.method");
        assert_eq!(unsafe { addr_of!((*start).distance) } as usize - start as usize, 48, "obc_volume_map_hexes_options.distance");
        assert_eq!(unsafe { addr_of!((*start).most_cells) } as usize - start as usize, 56, "obc_volume_map_hexes_options.most_cells");
        assert_eq!(unsafe { addr_of!((*start).sharp_angle) } as usize - start as usize, 64, "obc_volume_map_hexes_options.sharp_angle");
        assert_eq!((size_of::<obc_volume_map_hexes_report>(), align_of::<obc_volume_map_hexes_report>()), (72, 8));
        let it = MaybeUninit::<obc_volume_map_hexes_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_volume_map_hexes_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).padded) } as usize - start as usize, 4, "obc_volume_map_hexes_report.padded");
        assert_eq!(unsafe { addr_of!((*start).least_scaled_jacobian) } as usize - start as usize, 8, "obc_volume_map_hexes_report.least_scaled_jacobian");
        assert_eq!(unsafe { addr_of!((*start).mean_scaled_jacobian) } as usize - start as usize, 16, "obc_volume_map_hexes_report.mean_scaled_jacobian");
        assert_eq!(unsafe { addr_of!((*start).volume) } as usize - start as usize, 24, "obc_volume_map_hexes_report.volume");
        assert_eq!(unsafe { addr_of!((*start).polycube_corners) } as usize - start as usize, 32, "obc_volume_map_hexes_report.polycube_corners");
        assert_eq!(unsafe { addr_of!((*start).off_surface) } as usize - start as usize, 40, "obc_volume_map_hexes_report.off_surface");
        assert_eq!(unsafe { addr_of!((*start).distance) } as usize - start as usize, 48, "obc_volume_map_hexes_report.distance");
        assert_eq!(unsafe { addr_of!((*start).volume_error) } as usize - start as usize, 56, "obc_volume_map_hexes_report.volume_error");
        assert_eq!(unsafe { addr_of!((*start).follows_sharp_edges) } as usize - start as usize, 64, "obc_volume_map_hexes_report.follows_sharp_edges");
        assert_eq!(unsafe { addr_of!((*start).by_voxels) } as usize - start as usize, 68, "obc_volume_map_hexes_report.by_voxels");
        assert_eq!((size_of::<obc_volume_map_frame_options>(), align_of::<obc_volume_map_frame_options>()), (40, 8));
        let it = MaybeUninit::<obc_volume_map_frame_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_volume_map_frame_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).rounds) } as usize - start as usize, 4, "obc_volume_map_frame_options.rounds");
        assert_eq!(unsafe { addr_of!((*start).cells) } as usize - start as usize, 8, "obc_volume_map_frame_options.cells");
        assert_eq!(unsafe { addr_of!((*start).feature_angle) } as usize - start as usize, 16, "obc_volume_map_frame_options.feature_angle");
        assert_eq!(unsafe { addr_of!((*start).distance) } as usize - start as usize, 24, "obc_volume_map_frame_options.distance");
        assert_eq!(unsafe { addr_of!((*start).most_cells) } as usize - start as usize, 32, "obc_volume_map_frame_options.most_cells");
        assert_eq!((size_of::<obc_volume_map_frame_report>(), align_of::<obc_volume_map_frame_report>()), (104, 8));
        let it = MaybeUninit::<obc_volume_map_frame_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_volume_map_frame_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).integers_optimal) } as usize - start as usize, 4, "obc_volume_map_frame_report.integers_optimal");
        assert_eq!(unsafe { addr_of!((*start).least_scaled_jacobian) } as usize - start as usize, 8, "obc_volume_map_frame_report.least_scaled_jacobian");
        assert_eq!(unsafe { addr_of!((*start).mean_scaled_jacobian) } as usize - start as usize, 16, "obc_volume_map_frame_report.mean_scaled_jacobian");
        assert_eq!(unsafe { addr_of!((*start).volume) } as usize - start as usize, 24, "obc_volume_map_frame_report.volume");
        assert_eq!(unsafe { addr_of!((*start).off_surface) } as usize - start as usize, 32, "obc_volume_map_frame_report.off_surface");
        assert_eq!(unsafe { addr_of!((*start).singular_edges) } as usize - start as usize, 40, "obc_volume_map_frame_report.singular_edges");
        assert_eq!(unsafe { addr_of!((*start).irregular_edges) } as usize - start as usize, 48, "obc_volume_map_frame_report.irregular_edges");
        assert_eq!(unsafe { addr_of!((*start).integers) } as usize - start as usize, 56, "obc_volume_map_frame_report.integers");
        assert_eq!(unsafe { addr_of!((*start).tetrahedra) } as usize - start as usize, 64, "obc_volume_map_frame_report.tetrahedra");
        assert_eq!(unsafe { addr_of!((*start).inverted_at_start) } as usize - start as usize, 72, "obc_volume_map_frame_report.inverted_at_start");
        assert_eq!(unsafe { addr_of!((*start).steps) } as usize - start as usize, 80, "obc_volume_map_frame_report.steps");
        assert_eq!(unsafe { addr_of!((*start).distance) } as usize - start as usize, 88, "obc_volume_map_frame_report.distance");
        assert_eq!(unsafe { addr_of!((*start).volume_error) } as usize - start as usize, 96, "obc_volume_map_frame_report.volume_error");
    }
}
