//! What `<orbicube/volume_map.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use crate::mesh::obc_surface;

/// Layers of hexahedra along the boundary. AUTO decides by the angles at the edges of the polycube: on all, some or none of its patches; where
/// the result is bad, it also tries none and all.
pub const OBC_VOLUME_MAP_PADDING_AUTO: i32 = 0;
/// Layers of hexahedra along the boundary. AUTO decides by the angles at the edges of the polycube: on all, some or none of its patches; where
/// the result is bad, it also tries none and all.
pub const OBC_VOLUME_MAP_PADDING_WITH: i32 = 1;
/// Layers of hexahedra along the boundary. AUTO decides by the angles at the edges of the polycube: on all, some or none of its patches; where
/// the result is bad, it also tries none and all.
pub const OBC_VOLUME_MAP_PADDING_WITHOUT: i32 = 2;

/// Methods. POLYCUBE: cells of a polycube of the surface. GRID (grid-based): inner cells of a grid over the bounding box with a layer
/// around them, which suits any shape but has more irregular edges; requires a layer, so that padding WITHOUT is an invalid
/// argument. AUTO: POLYCUBE, and GRID where the hexahedra of the polycube exceed \`max\_hausdorff\_percent\` with up to twice as many cells or have a
/// scaled Jacobian of 0.3 or less, or where there is no polycube or one with twofold angle distortion; with padding WITHOUT it is
/// POLYCUBE.
pub const OBC_VOLUME_MAP_METHOD_AUTO: i32 = 0;
/// Methods. POLYCUBE: cells of a polycube of the surface. GRID (grid-based): inner cells of a grid over the bounding box with a layer
/// around them, which suits any shape but has more irregular edges; requires a layer, so that padding WITHOUT is an invalid
/// argument. AUTO: POLYCUBE, and GRID where the hexahedra of the polycube exceed \`max\_hausdorff\_percent\` with up to twice as many cells or have a
/// scaled Jacobian of 0.3 or less, or where there is no polycube or one with twofold angle distortion; with padding WITHOUT it is
/// POLYCUBE.
pub const OBC_VOLUME_MAP_METHOD_POLYCUBE: i32 = 1;
/// Methods. POLYCUBE: cells of a polycube of the surface. GRID (grid-based): inner cells of a grid over the bounding box with a layer
/// around them, which suits any shape but has more irregular edges; requires a layer, so that padding WITHOUT is an invalid
/// argument. AUTO: POLYCUBE, and GRID where the hexahedra of the polycube exceed \`max\_hausdorff\_percent\` with up to twice as many cells or have a
/// scaled Jacobian of 0.3 or less, or where there is no polycube or one with twofold angle distortion; with padding WITHOUT it is
/// POLYCUBE.
pub const OBC_VOLUME_MAP_METHOD_GRID: i32 = 2;

/// A bijective map of a solid to a polycube.
#[repr(C)]
pub struct obc_volume_map_solid {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// A certified hexahedral mesh.
#[repr(C)]
pub struct obc_volume_map_hexes {
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

/// Options of a hexahedral mesh. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_hexes_options {
    pub struct_size: u32,
    /// OBC\_VOLUME\_MAP\_PADDING\_AUTO, WITH or WITHOUT. Default: AUTO.
    pub padding: i32,
    /// approximate number of hexahedra, 1 to 10 million. Default: 10000.
    pub cells: usize,
    /// maximum number of polycube corners per boundary component, as in obc\_polycube\_options; 0: no limit. Default: 100.
    pub corners: usize,
    /// a surface of more than twice as many triangles is mapped through a coarse one of about that many; 0: never. Default: 6000.
    pub triangles: usize,
    /// seed of random choices of the polycube. Default: 0.
    pub seed: u64,
    /// number of smoothing rounds, 0 to 1000. Default: 40.
    pub rounds: i32,
    /// OBC\_VOLUME\_MAP\_METHOD\_AUTO, POLYCUBE or GRID. Default: AUTO.
    pub method: i32,
    /// Maximum two-sided distance to the surface, in percent of the bounding-box diagonal, and maximum volume error, in percent, 0 to
    /// 100. While it is exceeded, the cell count is doubled, up to max\_cells; the closest mesh is returned. 0 disables the check.
    /// Default: 1.
    pub max_hausdorff_percent: f64,
    /// approximate maximum cell count of doubling, up to 10 million; below \`cells\`: no doubling. Default: 100000.
    pub max_cells: usize,
    /// Minimum dihedral angle of a sharp edge of the surface, in degrees, 0 to below 180. The mesh follows sharp edges near an edge of
    /// the polycube, unless hexahedra there would be bad. 0: none. Default: 40.
    pub feature_angle: f64,
}

/// Figures of a hexahedral mesh. The scaled Jacobian of a hexahedron is the minimum over its corners of the determinant of the
/// three edges there over the product of their lengths: 1 for a box. The caller sets struct\_size.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_hexes_report {
    pub struct_size: u32,
    /// 1: with a layer along the boundary or parts of it; 0: without
    pub padded: i32,
    /// minimum and mean over the hexahedra
    pub min_scaled_jacobian: f64,
    /// minimum and mean over the hexahedra
    pub mean_scaled_jacobian: f64,
    /// total volume of the trilinear hexahedra
    pub volume: f64,
    /// number of corners of the polycubes of all boundary components; 0: no polycube
    pub polycube_corners: usize,
    /// number of boundary vertices that could not be placed on the surface
    pub off_surface: usize,
    /// Hausdorff distance of the boundary (quads split at their first vertex) and the surface, in percent of the bounding-box diagonal,
    /// accurate to half a percent of itself, and volume error in percent, both of the whole solid.
    pub hausdorff_percent: f64,
    /// Hausdorff distance of the boundary (quads split at their first vertex) and the surface, in percent of the bounding-box diagonal,
    /// accurate to half a percent of itself, and volume error in percent, both of the whole solid.
    pub volume_error_percent: f64,
    /// 1: the mesh follows the sharp edges for which the polycube has edges; 0: it does not
    pub follows_sharp_edges: i32,
    /// 1: at least one piece is grid-based; 0: none
    pub grid_based: i32,
}

/// Options of a frame-guided hexahedral mesh. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_frame_options {
    pub struct_size: u32,
    /// number of smoothing rounds, 0 to 1000. Default: 40.
    pub rounds: i32,
    /// approximate number of hexahedra, 1 to 10 million. Default: 10000.
    pub cells: usize,
    /// Minimum dihedral angle, in degrees, of boundary edges that an axis of the computed frames follows; unused for frames of the
    /// caller. 0: none. Default: 0.
    pub feature_angle: f64,
    /// as in obc\_volume\_map\_hexes\_options, relative to the boundary of the solid. Default: 1.
    pub max_hausdorff_percent: f64,
    /// as in obc\_volume\_map\_hexes\_options. Default: 100000.
    pub max_cells: usize,
}

/// Figures of a frame-guided hexahedral mesh. The caller sets struct\_size.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_volume_map_frame_report {
    pub struct_size: u32,
    /// 1: the search proved the integers optimal; 0: it ended before
    pub integers_optimal: i32,
    /// as in obc\_volume\_map\_hexes\_report
    pub min_scaled_jacobian: f64,
    /// as in obc\_volume\_map\_hexes\_report
    pub mean_scaled_jacobian: f64,
    /// total volume of the trilinear hexahedra
    pub volume: f64,
    /// number of boundary vertices that could not be placed on the surface
    pub off_surface: usize,
    /// number of singular inner edges of the tetrahedra
    pub singular_edges: usize,
    /// number of inner edges of the mesh with other than four hexahedra
    pub irregular_edges: usize,
    /// number of integer unknowns of the map
    pub integers: usize,
    /// number of tetrahedra of the map, after splits
    pub tetrahedra: usize,
    /// number of inverted tetrahedra after the choice of integers; the final map has none
    pub inverted_at_start: usize,
    /// number of Newton steps of untangling and optimization
    pub steps: usize,
    /// as in obc\_volume\_map\_hexes\_report
    pub hausdorff_percent: f64,
    /// as in obc\_volume\_map\_hexes\_report
    pub volume_error_percent: f64,
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
    /// Fills options with the defaults.
    pub fn obc_volume_map_hexes_options_init(options: *mut obc_volume_map_hexes_options, struct_size: usize) -> i32;
    /// Fills a closed, outward-oriented surface of any genus with hexahedra. The surface may have several disjoint pieces, among which the
    /// cells are divided by volume; inward-oriented components within a piece bound cavities. Hexahedra are conforming, the
    /// boundary has the components and the genus of the surface, each hexahedron has positive corners by exact signs and a
    /// trilinear map with proven positive determinant. options, host and report may be NULL; the allocator of the host must remain valid
    /// until \_destroy.
    /// Errors: invalid argument (also: more pieces than cells); not closed; not manifold (kinds self-intersection: components
    /// intersect; inconsistent-orientation: components oriented into the solid); degenerate; malformed file; no valid result with the
    /// obstacle; out of memory; cancelled.
    pub fn obc_volume_map_hexes_compute(surface: *const obc_surface, options: *const obc_volume_map_hexes_options, host: *const obc_host, report: *mut obc_volume_map_hexes_report, out: *mut *mut obc_volume_map_hexes, error: *mut obc_error) -> i32;
    /// Destroys a mesh; NULL is allowed.
    pub fn obc_volume_map_hexes_destroy(hexes: *mut obc_volume_map_hexes);
    /// Return the number of vertices, hexahedra and boundary quads; 0 for NULL.
    pub fn obc_volume_map_hexes_vertex_count(hexes: *const obc_volume_map_hexes) -> usize;
    /// Return the number of vertices, hexahedra and boundary quads; 0 for NULL.
    pub fn obc_volume_map_hexes_count(hexes: *const obc_volume_map_hexes) -> usize;
    /// Return the number of vertices, hexahedra and boundary quads; 0 for NULL.
    pub fn obc_volume_map_hexes_quad_count(hexes: *const obc_volume_map_hexes) -> usize;
    /// Copies positions (x y z a vertex), hexahedra (eight vertices each, in the order of MEDIT and VTK), boundary quads (four vertices each,
    /// counter-clockwise seen from outside) and the polycube patch of each quad (0 for grid-based ones); each may be NULL.
    /// Errors: invalid argument.
    pub fn obc_volume_map_hexes_copy(hexes: *const obc_volume_map_hexes, positions: *mut f64, hexahedra: *mut u32, quads: *mut u32, quad_patches: *mut u32, error: *mut obc_error) -> i32;
    /// Fills options with the defaults.
    pub fn obc_volume_map_frame_options_init(options: *mut obc_volume_map_frame_options, struct_size: usize) -> i32;
    /// Fills a solid with hexahedra that follow a frame field, with its singular edges inside (CubeCover: Nieser, Reitebuch and
    /// Polthier 2011). positions: x y z a vertex; tetrahedra: four vertices each, positive, conforming; frames: w x y z a tetrahedron as in
    /// \<orbicube/frame\_field.h\>, with an axis along the normal at the boundary, or NULL: several smooth fields are computed and repaired
    /// until a map follows one. The patch numbers of obc\_volume\_map\_hexes\_copy are those of connected boundary regions in one
    /// plane of the map. Where the boundary exceeds \`max\_hausdorff\_percent\`, it is fixed to the map's surface, then cells are added as in
    /// obc\_volume\_map\_hexes\_compute. options, host and report may be NULL; the allocator of the host must remain valid until \_destroy.
    /// Errors: invalid argument; malformed file (index-range); degenerate; not manifold; no valid result for a field that no such map
    /// follows, with the singular edge and its curve or the layer that would collapse, and for maps that remain inverted, with
    /// the location; out of memory; cancelled.
    pub fn obc_volume_map_frame_hexes_compute(positions: *const f64, vertex_count: usize, tetrahedra: *const u32, tetrahedron_count: usize, frames: *const f64, options: *const obc_volume_map_frame_options, host: *const obc_host, report: *mut obc_volume_map_frame_report, out: *mut *mut obc_volume_map_hexes, error: *mut obc_error) -> i32;
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
        assert_eq!(unsafe { addr_of!((*start).max_hausdorff_percent) } as usize - start as usize, 48, "obc_volume_map_hexes_options.max_hausdorff_percent");
        assert_eq!(unsafe { addr_of!((*start).max_cells) } as usize - start as usize, 56, "obc_volume_map_hexes_options.max_cells");
        assert_eq!(unsafe { addr_of!((*start).feature_angle) } as usize - start as usize, 64, "obc_volume_map_hexes_options.feature_angle");
        assert_eq!((size_of::<obc_volume_map_hexes_report>(), align_of::<obc_volume_map_hexes_report>()), (72, 8));
        let it = MaybeUninit::<obc_volume_map_hexes_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_volume_map_hexes_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).padded) } as usize - start as usize, 4, "obc_volume_map_hexes_report.padded");
        assert_eq!(unsafe { addr_of!((*start).min_scaled_jacobian) } as usize - start as usize, 8, "obc_volume_map_hexes_report.min_scaled_jacobian");
        assert_eq!(unsafe { addr_of!((*start).mean_scaled_jacobian) } as usize - start as usize, 16, "obc_volume_map_hexes_report.mean_scaled_jacobian");
        assert_eq!(unsafe { addr_of!((*start).volume) } as usize - start as usize, 24, "obc_volume_map_hexes_report.volume");
        assert_eq!(unsafe { addr_of!((*start).polycube_corners) } as usize - start as usize, 32, "obc_volume_map_hexes_report.polycube_corners");
        assert_eq!(unsafe { addr_of!((*start).off_surface) } as usize - start as usize, 40, "obc_volume_map_hexes_report.off_surface");
        assert_eq!(unsafe { addr_of!((*start).hausdorff_percent) } as usize - start as usize, 48, "obc_volume_map_hexes_report.hausdorff_percent");
        assert_eq!(unsafe { addr_of!((*start).volume_error_percent) } as usize - start as usize, 56, "obc_volume_map_hexes_report.volume_error_percent");
        assert_eq!(unsafe { addr_of!((*start).follows_sharp_edges) } as usize - start as usize, 64, "obc_volume_map_hexes_report.follows_sharp_edges");
        assert_eq!(unsafe { addr_of!((*start).grid_based) } as usize - start as usize, 68, "obc_volume_map_hexes_report.grid_based");
        assert_eq!((size_of::<obc_volume_map_frame_options>(), align_of::<obc_volume_map_frame_options>()), (40, 8));
        let it = MaybeUninit::<obc_volume_map_frame_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_volume_map_frame_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).rounds) } as usize - start as usize, 4, "obc_volume_map_frame_options.rounds");
        assert_eq!(unsafe { addr_of!((*start).cells) } as usize - start as usize, 8, "obc_volume_map_frame_options.cells");
        assert_eq!(unsafe { addr_of!((*start).feature_angle) } as usize - start as usize, 16, "obc_volume_map_frame_options.feature_angle");
        assert_eq!(unsafe { addr_of!((*start).max_hausdorff_percent) } as usize - start as usize, 24, "obc_volume_map_frame_options.max_hausdorff_percent");
        assert_eq!(unsafe { addr_of!((*start).max_cells) } as usize - start as usize, 32, "obc_volume_map_frame_options.max_cells");
        assert_eq!((size_of::<obc_volume_map_frame_report>(), align_of::<obc_volume_map_frame_report>()), (104, 8));
        let it = MaybeUninit::<obc_volume_map_frame_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_volume_map_frame_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).integers_optimal) } as usize - start as usize, 4, "obc_volume_map_frame_report.integers_optimal");
        assert_eq!(unsafe { addr_of!((*start).min_scaled_jacobian) } as usize - start as usize, 8, "obc_volume_map_frame_report.min_scaled_jacobian");
        assert_eq!(unsafe { addr_of!((*start).mean_scaled_jacobian) } as usize - start as usize, 16, "obc_volume_map_frame_report.mean_scaled_jacobian");
        assert_eq!(unsafe { addr_of!((*start).volume) } as usize - start as usize, 24, "obc_volume_map_frame_report.volume");
        assert_eq!(unsafe { addr_of!((*start).off_surface) } as usize - start as usize, 32, "obc_volume_map_frame_report.off_surface");
        assert_eq!(unsafe { addr_of!((*start).singular_edges) } as usize - start as usize, 40, "obc_volume_map_frame_report.singular_edges");
        assert_eq!(unsafe { addr_of!((*start).irregular_edges) } as usize - start as usize, 48, "obc_volume_map_frame_report.irregular_edges");
        assert_eq!(unsafe { addr_of!((*start).integers) } as usize - start as usize, 56, "obc_volume_map_frame_report.integers");
        assert_eq!(unsafe { addr_of!((*start).tetrahedra) } as usize - start as usize, 64, "obc_volume_map_frame_report.tetrahedra");
        assert_eq!(unsafe { addr_of!((*start).inverted_at_start) } as usize - start as usize, 72, "obc_volume_map_frame_report.inverted_at_start");
        assert_eq!(unsafe { addr_of!((*start).steps) } as usize - start as usize, 80, "obc_volume_map_frame_report.steps");
        assert_eq!(unsafe { addr_of!((*start).hausdorff_percent) } as usize - start as usize, 88, "obc_volume_map_frame_report.hausdorff_percent");
        assert_eq!(unsafe { addr_of!((*start).volume_error_percent) } as usize - start as usize, 96, "obc_volume_map_frame_report.volume_error_percent");
    }
}
