//! What `<orbicube/hexmesh.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use crate::mesh::{obc_mesh, obc_surface};
use std::os::raw::{c_char, c_void};

/// Layers of hexahedra along the boundary. AUTO decides by the angles at the edges of the polycube: on all, some or none of its patches;
/// where the result is bad, it also tries none and all. With WITH and WITHOUT, method AUTO is POLYCUBE.
pub const OBC_HEXMESH_PADDING_AUTO: i32 = 0;
/// Layers of hexahedra along the boundary. AUTO decides by the angles at the edges of the polycube: on all, some or none of its patches;
/// where the result is bad, it also tries none and all. With WITH and WITHOUT, method AUTO is POLYCUBE.
pub const OBC_HEXMESH_PADDING_WITH: i32 = 1;
/// Layers of hexahedra along the boundary. AUTO decides by the angles at the edges of the polycube: on all, some or none of its patches;
/// where the result is bad, it also tries none and all. With WITH and WITHOUT, method AUTO is POLYCUBE.
pub const OBC_HEXMESH_PADDING_WITHOUT: i32 = 2;

pub const OBC_HEXMESH_METHOD_AUTO: i32 = 0;
pub const OBC_HEXMESH_METHOD_POLYCUBE: i32 = 1;
pub const OBC_HEXMESH_METHOD_GRID: i32 = 2;
pub const OBC_HEXMESH_METHOD_FRAMES: i32 = 3;

pub const OBC_HEXMESH_FEATURES_OFF: i32 = 0;
pub const OBC_HEXMESH_FEATURES_AUTO: i32 = 1;
pub const OBC_HEXMESH_FEATURES_TAGS: i32 = 2;
pub const OBC_HEXMESH_FEATURES_ANGLES: i32 = 3;
pub const OBC_HEXMESH_FEATURES_MACHINED: i32 = 4;

/// A certified hexahedral mesh.
#[repr(C)]
pub struct obc_hexmesh {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Fills a closed surface with tetrahedra of at most max\_volume, into a mesh whose first vertices are those of the surface, bit-identical and
/// in their order. Returns a status and fills \*error as functions of Orbicube do; the caller destroys \*out with obc\_mesh\_destroy. Called
/// by the thread that called Orbicube.
pub type obc_hexmesh_fill_function = Option<unsafe extern "C" fn(surface: *const obc_surface, max_volume: f64, host: *const obc_host, out: *mut *mut obc_mesh, error: *mut obc_error, user: *mut c_void) -> i32>;

/// Options of a hexahedral mesh. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_hexmesh_options {
    pub struct_size: u32,
    /// OBC\_HEXMESH\_PADDING\_AUTO, WITH or WITHOUT. Default: AUTO.
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
    /// OBC\_HEXMESH\_METHOD\_AUTO, POLYCUBE, GRID or FRAMES. Default: AUTO.
    pub method: i32,
    /// Maximum two-sided distance to the surface, in percent of the bounding-box diagonal, and maximum volume error, in percent, 0 to
    /// 100. While it is exceeded, the cell count is doubled, up to max\_cells; the closest mesh is returned. 0 disables the check.
    /// Default: 1.
    pub max_hausdorff_percent: f64,
    /// approximate maximum cell count of doubling, up to 10 million; below \`cells\`: no doubling. Default: 100000.
    pub max_cells: usize,
    /// Minimum dihedral angle, in degrees, 0 to below 180, of surface edges that the mesh follows: those near an edge of the polycube, unless
    /// hexahedra there would be bad, or those along which an axis of computed frames lies. 0: none. -1: 35 with
    /// \`features\` other than OFF, where there are some; else 40, but 0 for method FRAMES and for frames of the caller. Default: -1.
    pub feature_angle: f64,
    /// OBC\_HEXMESH\_FEATURES\_OFF, AUTO, TAGS, ANGLES or MACHINED. Default: MACHINED.
    pub features: i32,
    /// Edges, two vertices of the input each, and vertices that \`features\` AUTO and TAGS consider. Default: NULL.
    pub tagged_edges: *const u32,
    /// number of tagged edges. Default: 0.
    pub tagged_edge_count: usize,
    /// tagged vertices. Default: NULL.
    pub tagged_vertices: *const u32,
    /// number of tagged vertices. Default: 0.
    pub tagged_vertex_count: usize,
    /// Fills surfaces for frames: obc\_tetrahedra\_fill\_mesh of \<orbicube/tetrahedra.h\> (TetGen, under the AGPL), or a function of the caller.
    /// NULL: surfaces go by polycubes and grids only; method FRAMES then requires a tetrahedral solid. Default: NULL.
    pub fill: obc_hexmesh_fill_function,
    /// passed to fill as user. Default: NULL.
    pub fill_user: *mut c_void,
    /// Numbers of the regions of the tetrahedra of obc\_hexmesh\_compute\_solid, one each, as of materials. Faces of the mesh are moved onto the
    /// faces between regions, and each hexahedron gets the number of its region. NULL: no regions. Default: NULL.
    pub regions: *const i32,
    /// number of entries of regions: that of the tetrahedra, or 0. Default: 0.
    pub region_count: usize,
}

/// Figures of a hexahedral mesh. The scaled Jacobian of a hexahedron is the minimum over its corners of the determinant of the
/// three edges there over the product of their lengths: 1 for a box. Members from integers\_optimal to fields are about frames and 0 for other
/// methods; those after them are about features and 0 where none are kept. The caller sets struct\_size.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_hexmesh_report {
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
    /// OBC\_HEXMESH\_METHOD\_POLYCUBE, GRID (at least one piece) or FRAMES
    pub method: i32,
    /// 1: the search proved the integers optimal; 0: it ended before
    pub integers_optimal: i32,
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
    /// number of fields that were computed, the last being that of the mesh; 0 for frames of the caller
    pub fields: usize,
    /// number of feature curves between corners
    pub feature_curves: usize,
    /// number of vertices where feature curves end, branch or bend
    pub feature_corners: usize,
    /// number of these curves and corners that the mesh lacks
    pub missing_features: usize,
    /// fraction of the length of the curves with a mesh edge along it: within a tenth of the mean boundary edge,
    /// turned by at most 25 degrees; 1 without curves
    pub captured: f64,
    /// largest minimum scaled Jacobian that hexahedra at the features can have, two in each sector between curves
    pub scaled_jacobian_bound: f64,
    /// 1: the cells of a grid with the features embedded; 0: the mesh of the method
    pub embedded: i32,
    /// 1: faces of hexahedra are where regions of the solid meet; 0: they are not, or there are no regions
    pub conforming: i32,
    /// number of faces between hexahedra of different regions, where conforming is 1
    pub region_quads: usize,
    /// Hausdorff distance of these and the faces between regions of the solid, by their vertices and
    /// centers, in percent of the bounding-box diagonal
    pub region_hausdorff_percent: f64,
}

/// A feature that the mesh lacks: a corner, or a curve with less than 95 % of its length captured. The caller sets struct\_size.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_hexmesh_missing {
    pub struct_size: u32,
    /// 1: a corner; 0: a curve
    pub corner: i32,
    /// ends of the curve; the position of the corner, twice
    pub first: [f64; 3],
    /// ends of the curve; the position of the corner, twice
    pub last: [f64; 3],
    /// captured fraction of the length of the curve; 0 for a corner
    pub captured: f64,
}

extern "C" {
    /// Fills options with the defaults.
    pub fn obc_hexmesh_options_init(options: *mut obc_hexmesh_options, struct_size: usize) -> i32;
    /// Fills a closed surface of any genus with hexahedra. The surface may have several disjoint pieces, among which the cells are divided by
    /// volume; components within a piece bound cavities. Triangles are reversed where neighbors disagree and where components are oriented
    /// into their solid; the log of the host says so. A few triangles may intersect others of their component, up to a twentieth of them. The
    /// volume of the result is infinite or 0 where the unit of the surface takes it out of the range of double. options, host and report
    /// may be NULL; the allocator of the host must remain valid until \_destroy. Takes from a second to many minutes.
    /// Errors: invalid argument (also: more pieces than cells); not closed; not manifold (kinds self-intersection: components intersect;
    /// non-orientable); degenerate; malformed file; not connected (method FRAMES: several pieces); unsupported (method FRAMES without
    /// \`fill\`); no valid result with the obstacle; those of \`fill\`; out of memory; cancelled.
    pub fn obc_hexmesh_compute(surface: *const obc_surface, options: *const obc_hexmesh_options, host: *const obc_host, report: *mut obc_hexmesh_report, out: *mut *mut obc_hexmesh, error: *mut obc_error) -> i32;
    /// Fills a solid of tetrahedra with hexahedra. positions: x y z a vertex; tetrahedra: four vertices each, positive, conforming; frames: NULL,
    /// or for the methods AUTO, which then is FRAMES, and FRAMES w x y z a tetrahedron as in \<orbicube/frame\_field.h\>, with an axis along the
    /// normal at the boundary. For method FRAMES without frames several smooth fields are computed and repaired until a map
    /// follows one. The patch numbers of obc\_hexmesh\_copy are then those of connected boundary regions in one plane of the map. options, host
    /// and report may be NULL; the allocator of the host must remain valid until \_destroy.
    /// Errors: as obc\_hexmesh\_compute for the boundary; malformed file (index-range); degenerate; not manifold; no valid result for a field
    /// that no such map follows, with the singular edge and its curve or the layer that would collapse, and for maps that remain inverted,
    /// with the location.
    pub fn obc_hexmesh_compute_solid(positions: *const f64, vertex_count: usize, tetrahedra: *const u32, tetrahedron_count: usize, frames: *const f64, options: *const obc_hexmesh_options, host: *const obc_host, report: *mut obc_hexmesh_report, out: *mut *mut obc_hexmesh, error: *mut obc_error) -> i32;
    /// Destroys a mesh; NULL is allowed.
    pub fn obc_hexmesh_destroy(hexes: *mut obc_hexmesh);
    /// Return the number of vertices, hexahedra and boundary quads; 0 for NULL.
    pub fn obc_hexmesh_vertex_count(hexes: *const obc_hexmesh) -> usize;
    /// Return the number of vertices, hexahedra and boundary quads; 0 for NULL.
    pub fn obc_hexmesh_count(hexes: *const obc_hexmesh) -> usize;
    /// Return the number of vertices, hexahedra and boundary quads; 0 for NULL.
    pub fn obc_hexmesh_quad_count(hexes: *const obc_hexmesh) -> usize;
    /// Copies positions (x y z a vertex), hexahedra (eight vertices each, in the order of MEDIT and VTK), boundary quads (four vertices each,
    /// counter-clockwise seen from outside) and the patch of each quad: of the polycube, of the feature curves where they are embedded, or 0;
    /// each may be NULL. Errors: invalid argument.
    pub fn obc_hexmesh_copy(hexes: *const obc_hexmesh, positions: *mut f64, hexahedra: *mut u32, quads: *mut u32, quad_patches: *mut u32, error: *mut obc_error) -> i32;
    /// Copies the number of the region of each hexahedron, 0 where the solid had none. Errors: invalid argument.
    pub fn obc_hexmesh_copy_regions(hexes: *const obc_hexmesh, regions: *mut i32, error: *mut obc_error) -> i32;
    /// Returns the number of missing features; 0 for NULL.
    pub fn obc_hexmesh_missing_count(hexes: *const obc_hexmesh) -> usize;
    /// Copies missing feature \`index\`, from 0. Errors: invalid argument.
    pub fn obc_hexmesh_get_missing(hexes: *const obc_hexmesh, index: usize, missing: *mut obc_hexmesh_missing, error: *mut obc_error) -> i32;
    /// Returns what was in the way of missing feature \`index\`, in words, until the mesh is destroyed; NULL for an index out of range and for
    /// NULL.
    pub fn obc_hexmesh_missing_reason(hexes: *const obc_hexmesh, index: usize) -> *const c_char;
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_hexmesh_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_hexmesh_options>(), align_of::<obc_hexmesh_options>()), (144, 8));
        let it = MaybeUninit::<obc_hexmesh_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_hexmesh_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).padding) } as usize - start as usize, 4, "obc_hexmesh_options.padding");
        assert_eq!(unsafe { addr_of!((*start).cells) } as usize - start as usize, 8, "obc_hexmesh_options.cells");
        assert_eq!(unsafe { addr_of!((*start).corners) } as usize - start as usize, 16, "obc_hexmesh_options.corners");
        assert_eq!(unsafe { addr_of!((*start).triangles) } as usize - start as usize, 24, "obc_hexmesh_options.triangles");
        assert_eq!(unsafe { addr_of!((*start).seed) } as usize - start as usize, 32, "obc_hexmesh_options.seed");
        assert_eq!(unsafe { addr_of!((*start).rounds) } as usize - start as usize, 40, "obc_hexmesh_options.rounds");
        assert_eq!(unsafe { addr_of!((*start).method) } as usize - start as usize, 44, "obc_hexmesh_options.method");
        assert_eq!(unsafe { addr_of!((*start).max_hausdorff_percent) } as usize - start as usize, 48, "obc_hexmesh_options.max_hausdorff_percent");
        assert_eq!(unsafe { addr_of!((*start).max_cells) } as usize - start as usize, 56, "obc_hexmesh_options.max_cells");
        assert_eq!(unsafe { addr_of!((*start).feature_angle) } as usize - start as usize, 64, "obc_hexmesh_options.feature_angle");
        assert_eq!(unsafe { addr_of!((*start).features) } as usize - start as usize, 72, "obc_hexmesh_options.features");
        assert_eq!(unsafe { addr_of!((*start).tagged_edges) } as usize - start as usize, 80, "obc_hexmesh_options.tagged_edges");
        assert_eq!(unsafe { addr_of!((*start).tagged_edge_count) } as usize - start as usize, 88, "obc_hexmesh_options.tagged_edge_count");
        assert_eq!(unsafe { addr_of!((*start).tagged_vertices) } as usize - start as usize, 96, "obc_hexmesh_options.tagged_vertices");
        assert_eq!(unsafe { addr_of!((*start).tagged_vertex_count) } as usize - start as usize, 104, "obc_hexmesh_options.tagged_vertex_count");
        assert_eq!(unsafe { addr_of!((*start).fill) } as usize - start as usize, 112, "obc_hexmesh_options.fill");
        assert_eq!(unsafe { addr_of!((*start).fill_user) } as usize - start as usize, 120, "obc_hexmesh_options.fill_user");
        assert_eq!(unsafe { addr_of!((*start).regions) } as usize - start as usize, 128, "obc_hexmesh_options.regions");
        assert_eq!(unsafe { addr_of!((*start).region_count) } as usize - start as usize, 136, "obc_hexmesh_options.region_count");
        assert_eq!((size_of::<obc_hexmesh_report>(), align_of::<obc_hexmesh_report>()), (200, 8));
        let it = MaybeUninit::<obc_hexmesh_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_hexmesh_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).padded) } as usize - start as usize, 4, "obc_hexmesh_report.padded");
        assert_eq!(unsafe { addr_of!((*start).min_scaled_jacobian) } as usize - start as usize, 8, "obc_hexmesh_report.min_scaled_jacobian");
        assert_eq!(unsafe { addr_of!((*start).mean_scaled_jacobian) } as usize - start as usize, 16, "obc_hexmesh_report.mean_scaled_jacobian");
        assert_eq!(unsafe { addr_of!((*start).volume) } as usize - start as usize, 24, "obc_hexmesh_report.volume");
        assert_eq!(unsafe { addr_of!((*start).polycube_corners) } as usize - start as usize, 32, "obc_hexmesh_report.polycube_corners");
        assert_eq!(unsafe { addr_of!((*start).off_surface) } as usize - start as usize, 40, "obc_hexmesh_report.off_surface");
        assert_eq!(unsafe { addr_of!((*start).hausdorff_percent) } as usize - start as usize, 48, "obc_hexmesh_report.hausdorff_percent");
        assert_eq!(unsafe { addr_of!((*start).volume_error_percent) } as usize - start as usize, 56, "obc_hexmesh_report.volume_error_percent");
        assert_eq!(unsafe { addr_of!((*start).follows_sharp_edges) } as usize - start as usize, 64, "obc_hexmesh_report.follows_sharp_edges");
        assert_eq!(unsafe { addr_of!((*start).grid_based) } as usize - start as usize, 68, "obc_hexmesh_report.grid_based");
        assert_eq!(unsafe { addr_of!((*start).method) } as usize - start as usize, 72, "obc_hexmesh_report.method");
        assert_eq!(unsafe { addr_of!((*start).integers_optimal) } as usize - start as usize, 76, "obc_hexmesh_report.integers_optimal");
        assert_eq!(unsafe { addr_of!((*start).singular_edges) } as usize - start as usize, 80, "obc_hexmesh_report.singular_edges");
        assert_eq!(unsafe { addr_of!((*start).irregular_edges) } as usize - start as usize, 88, "obc_hexmesh_report.irregular_edges");
        assert_eq!(unsafe { addr_of!((*start).integers) } as usize - start as usize, 96, "obc_hexmesh_report.integers");
        assert_eq!(unsafe { addr_of!((*start).tetrahedra) } as usize - start as usize, 104, "obc_hexmesh_report.tetrahedra");
        assert_eq!(unsafe { addr_of!((*start).inverted_at_start) } as usize - start as usize, 112, "obc_hexmesh_report.inverted_at_start");
        assert_eq!(unsafe { addr_of!((*start).steps) } as usize - start as usize, 120, "obc_hexmesh_report.steps");
        assert_eq!(unsafe { addr_of!((*start).fields) } as usize - start as usize, 128, "obc_hexmesh_report.fields");
        assert_eq!(unsafe { addr_of!((*start).feature_curves) } as usize - start as usize, 136, "obc_hexmesh_report.feature_curves");
        assert_eq!(unsafe { addr_of!((*start).feature_corners) } as usize - start as usize, 144, "obc_hexmesh_report.feature_corners");
        assert_eq!(unsafe { addr_of!((*start).missing_features) } as usize - start as usize, 152, "obc_hexmesh_report.missing_features");
        assert_eq!(unsafe { addr_of!((*start).captured) } as usize - start as usize, 160, "obc_hexmesh_report.captured");
        assert_eq!(unsafe { addr_of!((*start).scaled_jacobian_bound) } as usize - start as usize, 168, "obc_hexmesh_report.scaled_jacobian_bound");
        assert_eq!(unsafe { addr_of!((*start).embedded) } as usize - start as usize, 176, "obc_hexmesh_report.embedded");
        assert_eq!(unsafe { addr_of!((*start).conforming) } as usize - start as usize, 180, "obc_hexmesh_report.conforming");
        assert_eq!(unsafe { addr_of!((*start).region_quads) } as usize - start as usize, 184, "obc_hexmesh_report.region_quads");
        assert_eq!(unsafe { addr_of!((*start).region_hausdorff_percent) } as usize - start as usize, 192, "obc_hexmesh_report.region_hausdorff_percent");
        assert_eq!((size_of::<obc_hexmesh_missing>(), align_of::<obc_hexmesh_missing>()), (64, 8));
        let it = MaybeUninit::<obc_hexmesh_missing>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_hexmesh_missing.struct_size");
        assert_eq!(unsafe { addr_of!((*start).corner) } as usize - start as usize, 4, "obc_hexmesh_missing.corner");
        assert_eq!(unsafe { addr_of!((*start).first) } as usize - start as usize, 8, "obc_hexmesh_missing.first");
        assert_eq!(unsafe { addr_of!((*start).last) } as usize - start as usize, 32, "obc_hexmesh_missing.last");
        assert_eq!(unsafe { addr_of!((*start).captured) } as usize - start as usize, 56, "obc_hexmesh_missing.captured");
    }
}
