//! What `<orbicube/polycube.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use crate::mesh::obc_surface;
use std::os::raw::{c_char};

/// LABELS, and VOXELS unless the first map is nearly isometric; the valid map with the minimum sum of both
/// distortions (means over triangles), or with fewer corners if about equal
pub const OBC_POLYCUBE_AUTO: i32 = 0;
/// axis labels of triangles (Livesu, Vining, Sheffer, Gregson and Scateni 2013, "PolyCut"; Garanzha
/// et al. 2021, "Foldover-free maps in 50 lines of code")
pub const OBC_POLYCUBE_LABELS: i32 = 1;
/// grid-based: voxels of the genus of the surface, simplified to the allowed corners, traced on the surface
pub const OBC_POLYCUBE_VOXELS: i32 = 2;
/// the dissertation's chapter 4 as printed: octree, shortest paths, harmonic maps, Algorithm 3; never
/// chosen by AUTO. May have no valid result where paths cross or patches fold over.
/// Not for obc\_polycube\_compute\_common.
pub const OBC_POLYCUBE_DISSERTATION: i32 = 3;

/// mean over the surface of angle + area\_weight \* area distortion
pub const OBC_POLYCUBE_SURFACE_MEAN: i32 = 0;
/// mean over triangles of the same
pub const OBC_POLYCUBE_FACE_MEAN: i32 = 1;
/// harmonic energy + area\_weight \* area stretch, over the area
pub const OBC_POLYCUBE_HARMONIC: i32 = 2;

/// Corner search: derivative-free (the dissertation's section 4.4.2), or gradient-based, which needs fewer evaluations.
pub const OBC_POLYCUBE_TRUST_REGION: i32 = 0;
/// Corner search: derivative-free (the dissertation's section 4.4.2), or gradient-based, which needs fewer evaluations.
pub const OBC_POLYCUBE_GRADIENT: i32 = 1;

/// A certified polycube map.
#[repr(C)]
pub struct obc_polycube {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// The polycube of a map without its triangles, as a graph: corners, the straight edges between them, and patches. Its dual has a node
/// for each patch and a link for each pair of neighboring patches.
#[repr(C)]
pub struct obc_polycube_graph {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// A quad mesh of the surface from a regular grid on the polycube: vertices inside a patch or an edge have four quads.
#[repr(C)]
pub struct obc_polycube_quads {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// A texture atlas: the patches of a polycube packed into a square without overlap (in the manner of Levy, Petitjean, Ray and Maillot
/// 2002, "Least squares conformal maps for automatic texture atlas generation"). All patches have one scale, are upright or turned by a
/// quarter, and none is mirrored.
#[repr(C)]
pub struct obc_polycube_atlas {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Findings of the certification. The caller sets struct\_size.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_certificate {
    pub struct_size: u32,
    /// 1: the map is certified; 0: it is not
    pub valid: i32,
    /// genus of the polycube; 0 if its triangles are not a closed surface
    pub genus: i64,
    /// number of vertices with three or more patches
    pub corners: usize,
    /// number of patches: maximal connected sets of triangles in one plane
    pub patches: usize,
    /// defect and its location, UTF-8, terminated; empty for a valid map
    pub reason: [c_char; 256],
}

/// Options of the construction. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_options {
    pub struct_size: u32,
    /// OBC\_POLYCUBE\_AUTO, LABELS, VOXELS or DISSERTATION. Default: AUTO.
    pub construction: i32,
    /// maximum number of corners, or 8 + 8 g for genus g if that is larger; 0: no limit. Of DISSERTATION the
    /// maximum number of corner points (obc\_polycube\_corner\_points); 0: 60. Default: 0.
    pub corners: usize,
    /// seed of random choices of LABELS. Default: 0.
    pub seed: u64,
    /// of DISSERTATION: weight of area relative to angle distortion (alpha of eq. 4.4), nonnegative. Default: 1.
    pub area_weight: f64,
    /// of DISSERTATION: maximum number of rounds of Algorithm 3, each of which optimizes proportions and corner
    /// points; 0: the initial map. Default: 40.
    pub rounds: u32,
}

/// Options of the optimization of proportions. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_domain_options {
    pub struct_size: u32,
    /// OBC\_POLYCUBE\_SURFACE\_MEAN, FACE\_MEAN or HARMONIC. Default: SURFACE\_MEAN.
    pub measure: i32,
    /// weight of area relative to angle distortion, nonnegative. Default: 1.
    pub area_weight: f64,
}

/// Figures of the optimization of proportions. Angle distortion is the harmonic energy over the area on the polycube, area distortion
/// (r + 1/r) / 2 for the ratio r of areas at equal total areas; their means, without degenerate triangles (see
/// obc\_sphere\_map\_report), are 1 for an isometry. The caller sets struct\_size.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_domain_report {
    pub struct_size: u32,
    /// 1: to the tolerance or the limit of rounding; 0: ended before
    pub converged: i32,
    /// of the input map and of the result, which is not larger
    pub energy_before: f64,
    /// of the input map and of the result, which is not larger
    pub energy: f64,
    /// number of evaluations of the energy with its gradient
    pub evaluations: u64,
    /// number of planes of patches along all three axes
    pub layers: usize,
    /// number of rectangles between neighboring planes, each evaluated as one
    pub cells: usize,
    /// number of triangles across planes, each evaluated alone
    pub crossing: usize,
    /// means over triangles, and over the surface
    pub angle_mean: f64,
    /// means over triangles, and over the surface
    pub area_mean: f64,
    /// means over triangles, and over the surface
    pub angle_weighted_mean: f64,
    /// means over triangles, and over the surface
    pub area_weighted_mean: f64,
}

/// Options of the optimization of corners. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_corner_options {
    pub struct_size: u32,
    /// OBC\_POLYCUBE\_TRUST\_REGION or OBC\_POLYCUBE\_GRADIENT. Default: OBC\_POLYCUBE\_TRUST\_REGION.
    pub method: i32,
    /// weight of area relative to angle distortion, nonnegative. Default: 1.
    pub area_weight: f64,
    /// 1: alternates with the optimization of proportions (the dissertation's Algorithm 3); 0: the polycube is fixed. Default: 0.
    pub domain: i32,
    /// maximum number of rounds, at least 1. Default: 6.
    pub rounds: i32,
}

/// Figures of the optimization of corners. Energies are means over the surface of angle + area\_weight \* area distortion, as in the
/// domain report. The caller sets struct\_size.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_corner_report {
    pub struct_size: u32,
    /// 1: a further round gains almost nothing; 0: \`rounds\` was reached
    pub converged: i32,
    /// of the input map and of the result, which is not larger
    pub energy_before: f64,
    /// of the input map and of the result, which is not larger
    pub energy: f64,
    /// number of local solves around a corner
    pub evaluations: u64,
    /// triangles in all of them over triangles of the map
    pub map_evaluations: f64,
    /// number of moves of corners in all rounds; number of corners that can move in the first round
    pub moves: usize,
    /// number of moves of corners in all rounds; number of corners that can move in the first round
    pub movable: usize,
    /// means over triangles, and over the surface
    pub angle_mean: f64,
    /// means over triangles, and over the surface
    pub area_mean: f64,
    /// means over triangles, and over the surface
    pub angle_weighted_mean: f64,
    /// means over triangles, and over the surface
    pub area_weighted_mean: f64,
}

/// Features: vertices and curves of the map with target positions on its polycube. A weight multiplies the squared distance, as a fraction of
/// the polycube's area, next to a distortion that is 2 for an isometry; weight 0, or no weights, enforces the target exactly. Fill with
/// \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_feature_options {
    pub struct_size: u32,
    /// number of points. Default: 0.
    pub point_count: usize,
    /// vertex of the map of each point. Default: NULL.
    pub points: *const u32,
    /// target position of each point (x y z); weight of each point, or NULL. Default: NULL.
    pub targets: *const f64,
    /// target position of each point (x y z); weight of each point, or NULL. Default: NULL.
    pub point_weights: *const f64,
    /// number of curves. Default: 0.
    pub curve_count: usize,
    /// curve\_count + 1 offsets; the two or more vertices of each curve. Default: NULL.
    pub curve_starts: *const u32,
    /// curve\_count + 1 offsets; the two or more vertices of each curve. Default: NULL.
    pub curve_vertices: *const u32,
    /// target of each curve, an axis-aligned segment in a patch or an edge (x y z
    /// of both ends); weight of each curve, or NULL. Default: NULL.
    pub curve_lines: *const f64,
    /// target of each curve, an axis-aligned segment in a patch or an edge (x y z
    /// of both ends); weight of each curve, or NULL. Default: NULL.
    pub curve_weights: *const f64,
    /// minimum dihedral angle, in degrees, of surface edges that are aligned to nearby polycube edges; 0: none. Default: 0.
    pub feature_angle: f64,
}

/// Figures of the alignment. Lengths of sharp edges are lengths on the surface. The caller sets struct\_size.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_feature_report {
    pub struct_size: u32,
    /// maximum distance to the targets on the polycube before and after;
    /// length of sharp edges, and of those on polycube edges before and after
    pub distance_before: f64,
    /// maximum distance to the targets on the polycube before and after;
    /// length of sharp edges, and of those on polycube edges before and after
    pub distance: f64,
    /// maximum distance to the targets on the polycube before and after;
    /// length of sharp edges, and of those on polycube edges before and after
    pub sharp_length: f64,
    /// maximum distance to the targets on the polycube before and after;
    /// length of sharp edges, and of those on polycube edges before and after
    pub sharp_before: f64,
    /// maximum distance to the targets on the polycube before and after;
    /// length of sharp edges, and of those on polycube edges before and after
    pub sharp: f64,
    /// means over triangles, and over the surface
    pub angle_mean: f64,
    /// means over triangles, and over the surface
    pub area_mean: f64,
    /// means over triangles, and over the surface
    pub angle_weighted_mean: f64,
    /// means over triangles, and over the surface
    pub area_weighted_mean: f64,
}

/// Positional constraints of corners, for obc\_polycube\_map\_to\_domain.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_constraints {
    /// vertex of the polycube of each constrained corner
    pub corners: *const u32,
    /// target vertex of the surface of each corner, UINT32\_MAX for a target point; NULL: all have target points
    pub vertices: *const u32,
    /// target point of each corner (x y z), of which the nearest point of the surface counts; NULL: all have vertices
    pub points: *const f64,
    /// number of constrained corners
    pub count: usize,
}

/// Resolution of a quad mesh. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_quads_options {
    pub struct_size: u32,
    /// approximate number of quads, up to 10^7, at least one a rectangle between neighboring planes. Default: 10000.
    pub quads: usize,
    /// edge length on the polycube, in place of \`quads\`; 0: by \`quads\`. Default: 0.
    pub edge_length: f64,
}

/// Options of an atlas. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_atlas_options {
    pub struct_size: u32,
    /// number of texels along each side, 1 to 16384. Default: 1024.
    pub size: u32,
    /// minimum distance of two patches in texels, nonnegative; half of it is left at the border. Default: 4.
    pub padding: f64,
}

extern "C" {
    /// Certifies a map of other origin: \`surface\` in space, \`polycube\` the positions of its vertices on the polycube (x y z a vertex).
    /// certificate may be NULL; it is filled for valid and invalid maps. O(n log n) except for thousands of corners. Errors: invalid
    /// argument (an index out of range, a position that is not finite), no valid result (the message is the reason), out of memory,
    /// cancelled.
    pub fn obc_polycube_create(surface: *const obc_surface, polycube: *const f64, host: *const obc_host, certificate: *mut obc_polycube_certificate, out: *mut *mut obc_polycube, error: *mut obc_error) -> i32;
    /// Fills options with the defaults.
    pub fn obc_polycube_options_init(options: *mut obc_polycube_options, struct_size: usize) -> i32;
    /// Computes a polycube of a closed surface of any genus and a map to it. Edges are split where required; the vertices of the surface
    /// come first. The polycube has about the size of the surface. The attempts depend on the surface and the options
    /// alone, never on time. Errors: invalid argument; not closed; not manifold; degenerate; malformed file (kind empty-mesh: no
    /// triangles); no valid result with the outcome of each attempt; out of memory; cancelled.
    pub fn obc_polycube_compute(surface: *const obc_surface, options: *const obc_polycube_options, host: *const obc_host, out: *mut *mut obc_polycube, error: *mut obc_error) -> i32;
    /// Fills options with the defaults.
    pub fn obc_polycube_domain_options_init(options: *mut obc_polycube_domain_options, struct_size: usize) -> i32;
    /// Optimizes the proportions of the polycube: distances between the planes of its patches that minimize the distortion of the map, with
    /// vertices interpolated between the planes (the dissertation's section 4.3, by a projected gradient method over the logarithms of
    /// the distances). Combinatorics, order of the planes and total area are preserved. The result is certified; without
    /// improvement it is a bit-identical copy of \`map\`. O(n log n). Errors: invalid argument, out of memory, cancelled.
    pub fn obc_polycube_optimize_domain(map: *const obc_polycube, options: *const obc_polycube_domain_options, host: *const obc_host, report: *mut obc_polycube_domain_report, out: *mut *mut obc_polycube, error: *mut obc_error) -> i32;
    /// Fills options with the defaults.
    pub fn obc_polycube_corner_options_init(options: *mut obc_polycube_corner_options, struct_size: usize) -> i32;
    /// Lowers the distortion of a map to the same polycube: the preimages of its corners move on the surface, in the unfolding of the map
    /// around each, and with them the edges of the polycube on the surface and the vertices between (the dissertation's section 4.4).
    /// Triangle edges are split along polycube edges; inserted vertices that are no longer required may go. The result is
    /// certified; without improvement it is a bit-identical copy of \`map\`. Errors: invalid argument, out of memory, cancelled.
    pub fn obc_polycube_optimize_corners(map: *const obc_polycube, options: *const obc_polycube_corner_options, host: *const obc_host, report: *mut obc_polycube_corner_report, out: *mut *mut obc_polycube, error: *mut obc_error) -> i32;
    /// Fills options with the defaults.
    pub fn obc_polycube_feature_options_init(options: *mut obc_polycube_feature_options, struct_size: usize) -> i32;
    /// Aligns features of a map to their targets on the same polycube, with minimum distortion otherwise. The result is certified. Errors:
    /// invalid argument (a target that is not on the polycube, a vertex with two targets); no valid result with the conflicting
    /// features; out of memory; cancelled.
    pub fn obc_polycube_align_features(map: *const obc_polycube, options: *const obc_polycube_feature_options, host: *const obc_host, report: *mut obc_polycube_feature_report, out: *mut *mut obc_polycube, error: *mut obc_error) -> i32;
    /// Returns the number of energies of the optimization that computed a map: one before it and one after each iteration; 0 for NULL and
    /// for maps of other origin.
    pub fn obc_polycube_energy_count(map: *const obc_polycube) -> usize;
    /// Copies these energies to an array of the caller, which may be NULL. Errors: invalid argument.
    pub fn obc_polycube_copy_energies(map: *const obc_polycube, energies: *mut f64, error: *mut obc_error) -> i32;
    /// Destroys a map; NULL is allowed.
    pub fn obc_polycube_destroy(map: *mut obc_polycube);
    /// Return the numbers of vertices (those of the surface, then inserted ones), triangles, corners and patches of a map; 0 for NULL.
    pub fn obc_polycube_vertex_count(map: *const obc_polycube) -> usize;
    /// Return the numbers of vertices (those of the surface, then inserted ones), triangles, corners and patches of a map; 0 for NULL.
    pub fn obc_polycube_triangle_count(map: *const obc_polycube) -> usize;
    /// Return the numbers of vertices (those of the surface, then inserted ones), triangles, corners and patches of a map; 0 for NULL.
    pub fn obc_polycube_corner_count(map: *const obc_polycube) -> usize;
    /// Return the numbers of vertices (those of the surface, then inserted ones), triangles, corners and patches of a map; 0 for NULL.
    pub fn obc_polycube_patch_count(map: *const obc_polycube) -> usize;
    /// Returns the construction of a map: OBC\_POLYCUBE\_LABELS, VOXELS or DISSERTATION; -1 for a map of other origin and for NULL.
    pub fn obc_polycube_construction(map: *const obc_polycube) -> i32;
    /// Counts the corner points of a polycube in the dissertation's sense: vertices of the rectangles that its patches are cut into, at
    /// least as many as its corners. O(c^3) for c corners in the worst case. Errors: invalid argument, out of memory, cancelled.
    pub fn obc_polycube_corner_points(map: *const obc_polycube, host: *const obc_host, count: *mut usize, error: *mut obc_error) -> i32;
    /// Copies a map to arrays of the caller, each of which may be NULL: positions in space (x y z a vertex, bit-identical vertices of the
    /// surface first), positions on the polycube, and triangles (three vertices each). Errors: invalid argument.
    pub fn obc_polycube_copy(map: *const obc_polycube, positions: *mut f64, polycube: *mut f64, triangles: *mut u32, error: *mut obc_error) -> i32;
    /// Copies data of each triangle, each array may be NULL: the direction of its normal on the polycube (0 to 5 for +x, -x, +y, -y, +z,
    /// -z), its patch, and the surface triangle that contains it. Errors: invalid argument.
    pub fn obc_polycube_copy_triangles(map: *const obc_polycube, labels: *mut u8, patches: *mut u32, sources: *mut u32, error: *mut obc_error) -> i32;
    /// Copies the origin of each vertex, three entries a vertex, each array may be NULL: vertices of one surface triangle (UINT32\_MAX
    /// where fewer than three are needed) and their barycentric weights, positive (0 where not needed) with sum 1. Errors: invalid
    /// argument.
    pub fn obc_polycube_copy_sources(map: *const obc_polycube, corners: *mut u32, weights: *mut f64, error: *mut obc_error) -> i32;
    /// Maps a surface to a supplied polycube, whose triangles lie in axis-aligned planes. It is traced on the surface as with
    /// OBC\_POLYCUBE\_VOXELS: at its position, with its bounding box stretched to that of the surface, or as the constraints require. The
    /// polycube of the handle has the same coordinates; the map is smoothed across its edges. constraints may be NULL. Errors: those of
    /// obc\_polycube\_compute; invalid argument for constraints that do not exist or occur twice; unsupported if the second surface is not a
    /// polycube, with the reason; wrong genus if the genera differ.
    pub fn obc_polycube_map_to_domain(surface: *const obc_surface, polycube: *const obc_surface, constraints: *const obc_polycube_constraints, host: *const obc_host, out: *mut *mut obc_polycube, error: *mut obc_error) -> i32;
    /// Computes one polycube for several shapes of one genus and kind (the dissertation's section 4.5). Several polycubes of each shape are traced on
    /// all others; proportions and maps are optimized for the sum of energies, and the polycube with the minimum sum is returned. Maps between
    /// shapes are compositions: points with the same image on the polycube correspond. options are for the polycubes of single shapes, domain
    /// for the energy. out is an array of \`count\` handles, 1 to 65536, in the order of the surfaces, all NULL after an error. constructed\_from
    /// (or NULL) receives the index of the shape from which the polycube was constructed. obc\_polycube\_copy\_energies of each handle copies
    /// the sums, which never increase. Errors: those of obc\_polycube\_compute, and wrong genus.
    pub fn obc_polycube_compute_common(surfaces: *const obc_surface, count: usize, options: *const obc_polycube_options, domain: *const obc_polycube_domain_options, host: *const obc_host, constructed_from: *mut usize, out: *mut *mut obc_polycube, error: *mut obc_error) -> i32;
    /// Optimizes the proportions of one polycube for several maps to it: minimizes the sum of their energies, otherwise as
    /// obc\_polycube\_optimize\_domain. out is an array of \`count\` handles, all NULL after an error. Errors: invalid argument (also: maps
    /// to different polycubes), out of memory, cancelled.
    pub fn obc_polycube_optimize_common_domain(maps: *const *const obc_polycube, count: usize, options: *const obc_polycube_domain_options, host: *const obc_host, out: *mut *mut obc_polycube, error: *mut obc_error) -> i32;
    /// Creates the graph of a map, which may be destroyed afterwards. Errors: invalid argument, out of memory, cancelled.
    pub fn obc_polycube_graph_create(map: *const obc_polycube, host: *const obc_host, out: *mut *mut obc_polycube_graph, error: *mut obc_error) -> i32;
    /// Destroys a graph; NULL is allowed.
    pub fn obc_polycube_graph_destroy(graph: *mut obc_polycube_graph);
    /// Return the numbers of corners, edges, patches, loops, and links of the dual graph (each counted from both ends; patches that share
    /// several edges have one link); 0 for NULL.
    pub fn obc_polycube_graph_corner_count(graph: *const obc_polycube_graph) -> usize;
    /// Return the numbers of corners, edges, patches, loops, and links of the dual graph (each counted from both ends; patches that share
    /// several edges have one link); 0 for NULL.
    pub fn obc_polycube_graph_edge_count(graph: *const obc_polycube_graph) -> usize;
    /// Return the numbers of corners, edges, patches, loops, and links of the dual graph (each counted from both ends; patches that share
    /// several edges have one link); 0 for NULL.
    pub fn obc_polycube_graph_patch_count(graph: *const obc_polycube_graph) -> usize;
    /// Return the numbers of corners, edges, patches, loops, and links of the dual graph (each counted from both ends; patches that share
    /// several edges have one link); 0 for NULL.
    pub fn obc_polycube_graph_loop_count(graph: *const obc_polycube_graph) -> usize;
    /// Return the numbers of corners, edges, patches, loops, and links of the dual graph (each counted from both ends; patches that share
    /// several edges have one link); 0 for NULL.
    pub fn obc_polycube_graph_link_count(graph: *const obc_polycube_graph) -> usize;
    /// Copies for each corner its position (x y z) and its vertex of the map. Each array may be NULL, here and in the functions below.
    /// Errors: invalid argument.
    pub fn obc_polycube_graph_copy_corners(graph: *const obc_polycube_graph, positions: *mut f64, vertices: *mut u32, error: *mut obc_error) -> i32;
    /// Copies for each edge its two corners, the patches on its left and right (from the first corner to the second, seen from outside),
    /// and its convexity: 1 for an interior angle of 90 degrees, 0 for 270 degrees. Errors: invalid argument.
    pub fn obc_polycube_graph_copy_edges(graph: *const obc_polycube_graph, corners: *mut u32, patches: *mut u32, convex: *mut u8, error: *mut obc_error) -> i32;
    /// Copies for each patch (numbered as in obc\_polycube\_copy\_triangles) the direction of its normal (0 to 5 for +x, -x, +y, -y, +z,
    /// -z), the coordinate of its plane, and the offset of its loops: the outer loop, then those around holes; loop\_starts has
    /// one entry more than there are patches. Errors: invalid argument.
    pub fn obc_polycube_graph_copy_patches(graph: *const obc_polycube_graph, labels: *mut u8, coordinates: *mut f64, loop_starts: *mut u32, error: *mut obc_error) -> i32;
    /// Copies for each loop the offset of its darts, with one entry more than there are loops, and its darts, counter-clockwise around
    /// the patch: dart 2 e is edge e from its first to its second corner, dart 2 e + 1 its reverse. Each dart is in one loop.
    /// Errors: invalid argument.
    pub fn obc_polycube_graph_copy_loops(graph: *const obc_polycube_graph, starts: *mut u32, darts: *mut u32, error: *mut obc_error) -> i32;
    /// Copies the dual graph: the offset of the neighbors of each patch, with one entry more than there are patches, and the patches
    /// that share an edge with it, ascending. Errors: invalid argument.
    pub fn obc_polycube_graph_copy_dual(graph: *const obc_polycube_graph, starts: *mut u32, neighbors: *mut u32, error: *mut obc_error) -> i32;
    /// Fills options with the defaults.
    pub fn obc_polycube_quads_options_init(options: *mut obc_polycube_quads_options, struct_size: usize) -> i32;
    /// Creates a grid with integer numbers of cells between neighboring planes and maps its vertices to the surface, each in the triangle
    /// that contains it by exact arithmetic. Connectivity depends on the polycube alone: maps to one polycube return the same quads.
    /// Errors: invalid argument (also: more than 10^7 quads), out of memory, cancelled.
    pub fn obc_polycube_quads_create(map: *const obc_polycube, options: *const obc_polycube_quads_options, host: *const obc_host, out: *mut *mut obc_polycube_quads, error: *mut obc_error) -> i32;
    /// Destroys a quad mesh; NULL is allowed.
    pub fn obc_polycube_quads_destroy(quads: *mut obc_polycube_quads);
    /// Return the numbers of vertices and quads; 0 for NULL.
    pub fn obc_polycube_quads_vertex_count(quads: *const obc_polycube_quads) -> usize;
    /// Return the numbers of vertices and quads; 0 for NULL.
    pub fn obc_polycube_quads_quad_count(quads: *const obc_polycube_quads) -> usize;
    /// Copies to arrays of the caller, each of which may be NULL: for each vertex its positions on the surface and on the polycube (x y z),
    /// for each quad its four vertices, counter-clockwise seen from outside, and its patch. Errors: invalid argument.
    pub fn obc_polycube_quads_copy(quads: *const obc_polycube_quads, positions: *mut f64, polycube: *mut f64, corners: *mut u32, patches: *mut u32, error: *mut obc_error) -> i32;
    /// Copies for each vertex the triangle of the map that contains it and its barycentric weights, nonnegative with sum 1. Errors:
    /// invalid argument.
    pub fn obc_polycube_quads_copy_sources(quads: *const obc_polycube_quads, triangles: *mut u32, weights: *mut f64, error: *mut obc_error) -> i32;
    /// Fills options with the defaults.
    pub fn obc_polycube_atlas_options_init(options: *mut obc_polycube_atlas_options, struct_size: usize) -> i32;
    /// Packs the patches of a map, which may be destroyed afterwards, at the largest scale that is found. The layout depends on the polycube
    /// alone. Errors: invalid argument; unsupported (the square is too small for all patches with their padding); out of memory; cancelled.
    pub fn obc_polycube_atlas_create(map: *const obc_polycube, options: *const obc_polycube_atlas_options, host: *const obc_host, out: *mut *mut obc_polycube_atlas, error: *mut obc_error) -> i32;
    /// Destroys an atlas; NULL is allowed.
    pub fn obc_polycube_atlas_destroy(atlas: *mut obc_polycube_atlas);
    /// Return the number of texels along each side, and the number of triangles, which is that of the map; 0 for NULL.
    pub fn obc_polycube_atlas_size(atlas: *const obc_polycube_atlas) -> u32;
    /// Return the number of texels along each side, and the number of triangles, which is that of the map; 0 for NULL.
    pub fn obc_polycube_atlas_triangle_count(atlas: *const obc_polycube_atlas) -> usize;
    /// Copies an atlas, each output may be NULL: texture coordinates of the corners of each triangle (u v of each of the three corners; 0 to
    /// 1, u from the left and v from the top, as in glTF), the number of texels along a unit of the polycube, and the fraction of the square
    /// that the patches cover (0 to 1). A vertex on an edge of the polycube has other coordinates in each of its patches. Errors: invalid
    /// argument.
    pub fn obc_polycube_atlas_copy(atlas: *const obc_polycube_atlas, coordinates: *mut f64, texels_per_unit: *mut f64, coverage: *mut f64, error: *mut obc_error) -> i32;
    /// Samples an atlas: what each of its size \* size texels shows, row by row from the top, so that any data of vertices becomes a texture.
    /// Each array may be NULL: the triangle of the map, the barycentric weights of its three corners (nonnegative, sum 1), and whether the
    /// middle of the texel is in that triangle (1). Beside the patches (0) texels show the point of the nearest texel in a patch, so that
    /// filters and smaller copies of a texture mix nothing else into its patches; where no patch has the middle of any texel, all have triangle
    /// UINT32\_MAX and weights 0. O(texels + triangles). Errors: invalid argument, out of memory, cancelled.
    pub fn obc_polycube_atlas_sample(atlas: *const obc_polycube_atlas, host: *const obc_host, triangles: *mut u32, weights: *mut f64, covered: *mut u8, error: *mut obc_error) -> i32;
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_polycube_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_polycube_certificate>(), align_of::<obc_polycube_certificate>()), (288, 8));
        let it = MaybeUninit::<obc_polycube_certificate>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_polycube_certificate.struct_size");
        assert_eq!(unsafe { addr_of!((*start).valid) } as usize - start as usize, 4, "obc_polycube_certificate.valid");
        assert_eq!(unsafe { addr_of!((*start).genus) } as usize - start as usize, 8, "obc_polycube_certificate.genus");
        assert_eq!(unsafe { addr_of!((*start).corners) } as usize - start as usize, 16, "obc_polycube_certificate.corners");
        assert_eq!(unsafe { addr_of!((*start).patches) } as usize - start as usize, 24, "obc_polycube_certificate.patches");
        assert_eq!(unsafe { addr_of!((*start).reason) } as usize - start as usize, 32, "obc_polycube_certificate.reason");
        assert_eq!((size_of::<obc_polycube_options>(), align_of::<obc_polycube_options>()), (40, 8));
        let it = MaybeUninit::<obc_polycube_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_polycube_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).construction) } as usize - start as usize, 4, "obc_polycube_options.construction");
        assert_eq!(unsafe { addr_of!((*start).corners) } as usize - start as usize, 8, "obc_polycube_options.corners");
        assert_eq!(unsafe { addr_of!((*start).seed) } as usize - start as usize, 16, "obc_polycube_options.seed");
        assert_eq!(unsafe { addr_of!((*start).area_weight) } as usize - start as usize, 24, "obc_polycube_options.area_weight");
        assert_eq!(unsafe { addr_of!((*start).rounds) } as usize - start as usize, 32, "obc_polycube_options.rounds");
        assert_eq!((size_of::<obc_polycube_domain_options>(), align_of::<obc_polycube_domain_options>()), (16, 8));
        let it = MaybeUninit::<obc_polycube_domain_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_polycube_domain_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).measure) } as usize - start as usize, 4, "obc_polycube_domain_options.measure");
        assert_eq!(unsafe { addr_of!((*start).area_weight) } as usize - start as usize, 8, "obc_polycube_domain_options.area_weight");
        assert_eq!((size_of::<obc_polycube_domain_report>(), align_of::<obc_polycube_domain_report>()), (88, 8));
        let it = MaybeUninit::<obc_polycube_domain_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_polycube_domain_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).converged) } as usize - start as usize, 4, "obc_polycube_domain_report.converged");
        assert_eq!(unsafe { addr_of!((*start).energy_before) } as usize - start as usize, 8, "obc_polycube_domain_report.energy_before");
        assert_eq!(unsafe { addr_of!((*start).energy) } as usize - start as usize, 16, "obc_polycube_domain_report.energy");
        assert_eq!(unsafe { addr_of!((*start).evaluations) } as usize - start as usize, 24, "obc_polycube_domain_report.evaluations");
        assert_eq!(unsafe { addr_of!((*start).layers) } as usize - start as usize, 32, "obc_polycube_domain_report.layers");
        assert_eq!(unsafe { addr_of!((*start).cells) } as usize - start as usize, 40, "obc_polycube_domain_report.cells");
        assert_eq!(unsafe { addr_of!((*start).crossing) } as usize - start as usize, 48, "obc_polycube_domain_report.crossing");
        assert_eq!(unsafe { addr_of!((*start).angle_mean) } as usize - start as usize, 56, "obc_polycube_domain_report.angle_mean");
        assert_eq!(unsafe { addr_of!((*start).area_mean) } as usize - start as usize, 64, "obc_polycube_domain_report.area_mean");
        assert_eq!(unsafe { addr_of!((*start).angle_weighted_mean) } as usize - start as usize, 72, "obc_polycube_domain_report.angle_weighted_mean");
        assert_eq!(unsafe { addr_of!((*start).area_weighted_mean) } as usize - start as usize, 80, "obc_polycube_domain_report.area_weighted_mean");
        assert_eq!((size_of::<obc_polycube_corner_options>(), align_of::<obc_polycube_corner_options>()), (24, 8));
        let it = MaybeUninit::<obc_polycube_corner_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_polycube_corner_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).method) } as usize - start as usize, 4, "obc_polycube_corner_options.method");
        assert_eq!(unsafe { addr_of!((*start).area_weight) } as usize - start as usize, 8, "obc_polycube_corner_options.area_weight");
        assert_eq!(unsafe { addr_of!((*start).domain) } as usize - start as usize, 16, "obc_polycube_corner_options.domain");
        assert_eq!(unsafe { addr_of!((*start).rounds) } as usize - start as usize, 20, "obc_polycube_corner_options.rounds");
        assert_eq!((size_of::<obc_polycube_corner_report>(), align_of::<obc_polycube_corner_report>()), (88, 8));
        let it = MaybeUninit::<obc_polycube_corner_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_polycube_corner_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).converged) } as usize - start as usize, 4, "obc_polycube_corner_report.converged");
        assert_eq!(unsafe { addr_of!((*start).energy_before) } as usize - start as usize, 8, "obc_polycube_corner_report.energy_before");
        assert_eq!(unsafe { addr_of!((*start).energy) } as usize - start as usize, 16, "obc_polycube_corner_report.energy");
        assert_eq!(unsafe { addr_of!((*start).evaluations) } as usize - start as usize, 24, "obc_polycube_corner_report.evaluations");
        assert_eq!(unsafe { addr_of!((*start).map_evaluations) } as usize - start as usize, 32, "obc_polycube_corner_report.map_evaluations");
        assert_eq!(unsafe { addr_of!((*start).moves) } as usize - start as usize, 40, "obc_polycube_corner_report.moves");
        assert_eq!(unsafe { addr_of!((*start).movable) } as usize - start as usize, 48, "obc_polycube_corner_report.movable");
        assert_eq!(unsafe { addr_of!((*start).angle_mean) } as usize - start as usize, 56, "obc_polycube_corner_report.angle_mean");
        assert_eq!(unsafe { addr_of!((*start).area_mean) } as usize - start as usize, 64, "obc_polycube_corner_report.area_mean");
        assert_eq!(unsafe { addr_of!((*start).angle_weighted_mean) } as usize - start as usize, 72, "obc_polycube_corner_report.angle_weighted_mean");
        assert_eq!(unsafe { addr_of!((*start).area_weighted_mean) } as usize - start as usize, 80, "obc_polycube_corner_report.area_weighted_mean");
        assert_eq!((size_of::<obc_polycube_feature_options>(), align_of::<obc_polycube_feature_options>()), (88, 8));
        let it = MaybeUninit::<obc_polycube_feature_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_polycube_feature_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).point_count) } as usize - start as usize, 8, "obc_polycube_feature_options.point_count");
        assert_eq!(unsafe { addr_of!((*start).points) } as usize - start as usize, 16, "obc_polycube_feature_options.points");
        assert_eq!(unsafe { addr_of!((*start).targets) } as usize - start as usize, 24, "obc_polycube_feature_options.targets");
        assert_eq!(unsafe { addr_of!((*start).point_weights) } as usize - start as usize, 32, "obc_polycube_feature_options.point_weights");
        assert_eq!(unsafe { addr_of!((*start).curve_count) } as usize - start as usize, 40, "obc_polycube_feature_options.curve_count");
        assert_eq!(unsafe { addr_of!((*start).curve_starts) } as usize - start as usize, 48, "obc_polycube_feature_options.curve_starts");
        assert_eq!(unsafe { addr_of!((*start).curve_vertices) } as usize - start as usize, 56, "obc_polycube_feature_options.curve_vertices");
        assert_eq!(unsafe { addr_of!((*start).curve_lines) } as usize - start as usize, 64, "obc_polycube_feature_options.curve_lines");
        assert_eq!(unsafe { addr_of!((*start).curve_weights) } as usize - start as usize, 72, "obc_polycube_feature_options.curve_weights");
        assert_eq!(unsafe { addr_of!((*start).feature_angle) } as usize - start as usize, 80, "obc_polycube_feature_options.feature_angle");
        assert_eq!((size_of::<obc_polycube_feature_report>(), align_of::<obc_polycube_feature_report>()), (80, 8));
        let it = MaybeUninit::<obc_polycube_feature_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_polycube_feature_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).distance_before) } as usize - start as usize, 8, "obc_polycube_feature_report.distance_before");
        assert_eq!(unsafe { addr_of!((*start).distance) } as usize - start as usize, 16, "obc_polycube_feature_report.distance");
        assert_eq!(unsafe { addr_of!((*start).sharp_length) } as usize - start as usize, 24, "obc_polycube_feature_report.sharp_length");
        assert_eq!(unsafe { addr_of!((*start).sharp_before) } as usize - start as usize, 32, "obc_polycube_feature_report.sharp_before");
        assert_eq!(unsafe { addr_of!((*start).sharp) } as usize - start as usize, 40, "obc_polycube_feature_report.sharp");
        assert_eq!(unsafe { addr_of!((*start).angle_mean) } as usize - start as usize, 48, "obc_polycube_feature_report.angle_mean");
        assert_eq!(unsafe { addr_of!((*start).area_mean) } as usize - start as usize, 56, "obc_polycube_feature_report.area_mean");
        assert_eq!(unsafe { addr_of!((*start).angle_weighted_mean) } as usize - start as usize, 64, "obc_polycube_feature_report.angle_weighted_mean");
        assert_eq!(unsafe { addr_of!((*start).area_weighted_mean) } as usize - start as usize, 72, "obc_polycube_feature_report.area_weighted_mean");
        assert_eq!((size_of::<obc_polycube_constraints>(), align_of::<obc_polycube_constraints>()), (32, 8));
        let it = MaybeUninit::<obc_polycube_constraints>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).corners) } as usize - start as usize, 0, "obc_polycube_constraints.corners");
        assert_eq!(unsafe { addr_of!((*start).vertices) } as usize - start as usize, 8, "obc_polycube_constraints.vertices");
        assert_eq!(unsafe { addr_of!((*start).points) } as usize - start as usize, 16, "obc_polycube_constraints.points");
        assert_eq!(unsafe { addr_of!((*start).count) } as usize - start as usize, 24, "obc_polycube_constraints.count");
        assert_eq!((size_of::<obc_polycube_quads_options>(), align_of::<obc_polycube_quads_options>()), (24, 8));
        let it = MaybeUninit::<obc_polycube_quads_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_polycube_quads_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).quads) } as usize - start as usize, 8, "obc_polycube_quads_options.quads");
        assert_eq!(unsafe { addr_of!((*start).edge_length) } as usize - start as usize, 16, "obc_polycube_quads_options.edge_length");
        assert_eq!((size_of::<obc_polycube_atlas_options>(), align_of::<obc_polycube_atlas_options>()), (16, 8));
        let it = MaybeUninit::<obc_polycube_atlas_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_polycube_atlas_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).size) } as usize - start as usize, 4, "obc_polycube_atlas_options.size");
        assert_eq!(unsafe { addr_of!((*start).padding) } as usize - start as usize, 8, "obc_polycube_atlas_options.padding");
    }
}
