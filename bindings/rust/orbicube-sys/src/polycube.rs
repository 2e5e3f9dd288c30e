//! What `<orbicube/polycube.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use crate::mesh::obc_surface;
use std::os::raw::{c_char};

/// by labels, and by voxels unless the first map is nearly an isometry; the one of the valid maps with
/// the least sum of both distortions (means over triangles), fewer corners if about equal
pub const OBC_POLYCUBE_AUTO: i32 = 0;
/// axis labels of triangles (Livesu, Vining, Sheffer, Gregson and Scateni 2013, "PolyCut"; Garanzha
/// et al. 2021, "Foldover-free maps in 50 lines of code")
pub const OBC_POLYCUBE_LABELS: i32 = 1;
/// voxels of the surface's genus, simplified to the corners allowed, drawn on the surface
pub const OBC_POLYCUBE_VOXELS: i32 = 2;

/// mean over the surface of angle + area\_weight \* area
pub const OBC_POLYCUBE_SURFACE_MEAN: i32 = 0;
/// mean over triangles of the same
pub const OBC_POLYCUBE_FACE_MEAN: i32 = 1;
/// harmonic energy + area\_weight \* area stretching, over the area
pub const OBC_POLYCUBE_HARMONIC: i32 = 2;

/// How the best place of a corner is looked for: by values alone (the dissertation's section 4.4.2), or by gradients, in
/// fewer evaluations.
pub const OBC_POLYCUBE_TRUST_REGION: i32 = 0;
/// How the best place of a corner is looked for: by values alone (the dissertation's section 4.4.2), or by gradients, in
/// fewer evaluations.
pub const OBC_POLYCUBE_GRADIENT: i32 = 1;

/// A certified polycube map.
#[repr(C)]
pub struct obc_polycube {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// The polycube of a map without its triangles: corners, the straight edges between them, and patches (its faces), as a graph
/// whose dual has a node a patch and a link an edge. Copies all; the map may be destroyed.
#[repr(C)]
pub struct obc_polycube_graph {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// A mesh of quads on the surface, from a regular grid on the polycube: every vertex inside a patch, or inside an edge, has four.
#[repr(C)]
pub struct obc_polycube_quads {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// What certification finds. Fill struct\_size.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_certificate {
    pub struct_size: u32,
    /// 1 or 0
    pub valid: i32,
    /// of the polycube; 0 when its triangles are no closed surface
    pub genus: i64,
    /// vertices where three faces of the polycube or more meet
    pub corners: usize,
    /// faces of the polycube: connected triangles in one plane
    pub patches: usize,
    /// what is wrong and where, UTF-8, ends with 0; empty when valid
    pub reason: [c_char; 256],
}

/// How a polycube is looked for. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_options {
    pub struct_size: u32,
    /// OBC\_POLYCUBE\_...; auto by default
    pub construction: i32,
    /// of the polycube at most, or 8 + 8 g for g handles if that is more; 0: any number. Default 0
    pub corners: usize,
    /// of what labels choose at random. Default 0
    pub seed: u64,
}

/// Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_domain_options {
    pub struct_size: u32,
    /// OBC\_POLYCUBE\_SURFACE\_MEAN or another. Default OBC\_POLYCUBE\_SURFACE\_MEAN
    pub measure: i32,
    /// of areas beside angles, not negative. Default 1
    pub area_weight: f64,
}

/// What was found. Fill struct\_size. The means are those of the result, each 1 for an isometry: \`angle\` the harmonic energy of a
/// triangle over its area on the polycube, \`area\` (r + 1/r) / 2 for the ratio r of areas, at equal areas of the whole.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_domain_report {
    pub struct_size: u32,
    /// 1: to the tolerance, or as far as rounding allows
    pub converged: i32,
    /// of the map that was given; of the result, not more
    pub energy_before: f64,
    /// of the map that was given; of the result, not more
    pub energy: f64,
    /// of the energy with its gradient
    pub evaluations: u64,
    /// planes of faces, along all three axes
    pub layers: usize,
    /// rectangles between neighbouring layers, each evaluated at once
    pub cells: usize,
    /// triangles across layers, each evaluated for itself
    pub crossing: usize,
    /// over triangles; over the surface
    pub angle_mean: f64,
    /// over triangles; over the surface
    pub area_mean: f64,
    /// over triangles; over the surface
    pub angle_weighted_mean: f64,
    /// over triangles; over the surface
    pub area_weighted_mean: f64,
}

/// Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_corner_options {
    pub struct_size: u32,
    /// OBC\_POLYCUBE\_TRUST\_REGION or OBC\_POLYCUBE\_GRADIENT. Default OBC\_POLYCUBE\_TRUST\_REGION
    pub method: i32,
    /// of areas beside angles, not negative. Default 1
    pub area_weight: f64,
    /// 1: the best proportions in turn (the dissertation's Algorithm 3); 0: the polycube stays. Default 0
    pub domain: i32,
    /// at most, 1 or more. Default 6
    pub rounds: i32,
}

/// What was found. Fill struct\_size. Energies are means over the surface of angle + area\_weight \* area, as in the domain report.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_corner_report {
    pub struct_size: u32,
    /// 1: another round gains next to nothing; 0: the rounds were used up
    pub converged: i32,
    /// of the map that was given; of the result, not more
    pub energy_before: f64,
    /// of the map that was given; of the result, not more
    pub energy: f64,
    /// of a corner's surroundings, each time solved for the least distortion
    pub evaluations: u64,
    /// the same in maps: triangles that were solved, over those of the map
    pub map_evaluations: f64,
    /// of corners, over all rounds; corners with room to move, in the first round
    pub moves: usize,
    /// of corners, over all rounds; corners with room to move, in the first round
    pub movable: usize,
    /// over triangles; over the surface
    pub angle_mean: f64,
    /// over triangles; over the surface
    pub area_mean: f64,
    /// over triangles; over the surface
    pub angle_weighted_mean: f64,
    /// over triangles; over the surface
    pub area_weighted_mean: f64,
}

/// What must be mapped where. Weights are those of squared distances in parts of the polycube's area, beside a distortion that is 2
/// for an isometry; 0, or no weights, is for what must be met exactly. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_feature_options {
    pub struct_size: u32,
    /// points: vertices of the map and their places on its polycube (x y z). Default 0
    pub point_count: usize,
    pub points: *const u32,
    pub places: *const f64,
    pub point_weights: *const f64,
    /// curves: of each where its vertices, two or more, begin (an entry more than curves), and a line
    /// along an axis in a face or an edge (x y z twice) for the first to the last. Default 0
    pub curve_count: usize,
    pub curve_starts: *const u32,
    pub curve_vertices: *const u32,
    pub curve_lines: *const f64,
    pub curve_weights: *const f64,
    /// where the surface bends by so many degrees, edges go to edges of the polycube nearby; 0: none. Default 0
    pub sharp_angle: f64,
}

/// What was reached. Fill struct\_size. Distances on the polycube, the largest of all features; the length of sharp edges on the
/// surface, and what of it lay and lies on edges of the polycube.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_feature_report {
    pub struct_size: u32,
    pub distance_before: f64,
    pub distance: f64,
    pub sharp_length: f64,
    pub sharp_before: f64,
    pub sharp: f64,
    /// over triangles; over the surface
    pub angle_mean: f64,
    /// over triangles; over the surface
    pub area_mean: f64,
    /// over triangles; over the surface
    pub angle_weighted_mean: f64,
    /// over triangles; over the surface
    pub area_weighted_mean: f64,
}

/// Places of corners, for obc\_polycube\_compute\_on: corner i is vertex corners\[i\] of the polycube; it is to be at vertex
/// vertices\[i\] of the surface or, where that is UINT32\_MAX or vertices is NULL, at the point of the surface that is nearest to
/// points\[3 i\], \[3 i + 1\], \[3 i + 2\].
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_places {
    pub corners: *const u32,
    /// or NULL
    pub vertices: *const u32,
    /// or NULL, when all have vertices
    pub points: *const f64,
    pub count: usize,
}

/// How fine. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_polycube_quads_options {
    pub struct_size: u32,
    /// about so many; each rectangle between neighbouring planes of patches has one at least. Default 10000
    pub quads: usize,
    /// of cells on the polycube, rather than their number, unless it is 0. Default 0
    pub edge_length: f64,
}

extern "C" {
    /// Certifies a map made elsewhere: \`surface\` in space, \`polycube\` where its vertices are to be on the polycube (x y z a vertex).
    /// certificate may be NULL; it is filled whether the map is valid or not. Errors: invalid argument (an index out of range, a
    /// position that is not finite), no valid result (the message is the reason), out of memory, cancelled. O(n log n) unless there
    /// are thousands of corners.
    pub fn obc_polycube_create(surface: *const obc_surface, polycube: *const f64, host: *const obc_host, certificate: *mut obc_polycube_certificate, out: *mut *mut obc_polycube, error: *mut obc_error) -> i32;
    /// The defaults, which the members' comments give.
    pub fn obc_polycube_options_init(options: *mut obc_polycube_options, struct_size: usize) -> i32;
    /// Finds a polycube of a closed surface of any genus, and a map to it. Edges are split where that is needed; the vertices of
    /// the surface come first. The polycube has about the size of the surface. What is tried depends on the surface and the options
    /// alone, never on time.
    /// Errors: invalid argument; not closed, not manifold, degenerate, malformed file (kind empty-mesh: no triangles); no valid
    /// result with what became of each attempt; out of memory, cancelled.
    pub fn obc_polycube_compute(surface: *const obc_surface, options: *const obc_polycube_options, host: *const obc_host, out: *mut *mut obc_polycube, error: *mut obc_error) -> i32;
    /// The defaults, which the members' comments give.
    pub fn obc_polycube_domain_options_init(options: *mut obc_polycube_domain_options, struct_size: usize) -> i32;
    /// The polycube with the best proportions: distances between the planes of its faces that minimise the map's distortion, vertices
    /// going with the planes beside them (the dissertation's section 4.3, by a projected gradient method over the logarithms of the
    /// distances). Combinatorics, order of the planes and total area stay. The result is certified again; it is a copy of \`map\` to
    /// the bit when nothing better is found. report may be NULL, here and below. Errors: invalid argument, out of memory, cancelled.
    /// O(n log n).
    pub fn obc_polycube_optimize_domain(map: *const obc_polycube, options: *const obc_polycube_domain_options, host: *const obc_host, report: *mut obc_polycube_domain_report, out: *mut *mut obc_polycube, error: *mut obc_error) -> i32;
    /// The defaults, which the members' comments give.
    pub fn obc_polycube_corner_options_init(options: *mut obc_polycube_corner_options, struct_size: usize) -> i32;
    /// A less distorted map to the same polycube: what of the surface goes to its corners moves, in the map's own unfolding around
    /// each, and with it the polycube's edges on the surface and all between (the dissertation's section 4.4). Edges of triangles
    /// are split where the polycube's are drawn; added vertices that serve none any more may go. Certified again; a copy of \`map\`
    /// to the bit when nothing better is found. Errors: invalid argument, out of memory, cancelled.
    pub fn obc_polycube_optimize_corners(map: *const obc_polycube, options: *const obc_polycube_corner_options, host: *const obc_host, report: *mut obc_polycube_corner_report, out: *mut *mut obc_polycube, error: *mut obc_error) -> i32;
    /// The defaults, which the members' comments give.
    pub fn obc_polycube_feature_options_init(options: *mut obc_polycube_feature_options, struct_size: usize) -> i32;
    /// A map to the same polycube with features in their places, and all else as little distorted as that allows. Certified again.
    /// Errors: invalid argument (a place that is not on the polycube, a vertex with two); no valid result, with what cannot be met;
    /// out of memory, cancelled.
    pub fn obc_polycube_meet_features(map: *const obc_polycube, options: *const obc_polycube_feature_options, host: *const obc_host, report: *mut obc_polycube_feature_report, out: *mut *mut obc_polycube, error: *mut obc_error) -> i32;
    /// The energies of the optimisation that a map comes from: before it, then after each iteration; 0 for NULL and maps that come from
    /// none.
    pub fn obc_polycube_energy_count(map: *const obc_polycube) -> usize;
    /// Copies them to the caller's array, which may be NULL. Errors: invalid argument.
    pub fn obc_polycube_copy_energies(map: *const obc_polycube, energies: *mut f64, error: *mut obc_error) -> i32;
    /// Releases a map; NULL is fine.
    pub fn obc_polycube_destroy(map: *mut obc_polycube);
    /// Numbers of a map; 0 for NULL. Vertices: those of the surface, then those added.
    pub fn obc_polycube_vertex_count(map: *const obc_polycube) -> usize;
    /// Numbers of a map; 0 for NULL. Vertices: those of the surface, then those added.
    pub fn obc_polycube_triangle_count(map: *const obc_polycube) -> usize;
    /// Numbers of a map; 0 for NULL. Vertices: those of the surface, then those added.
    pub fn obc_polycube_corner_count(map: *const obc_polycube) -> usize;
    /// Numbers of a map; 0 for NULL. Vertices: those of the surface, then those added.
    pub fn obc_polycube_patch_count(map: *const obc_polycube) -> usize;
    /// What found the map: OBC\_POLYCUBE\_LABELS or OBC\_POLYCUBE\_VOXELS; -1 for a map made elsewhere, and for NULL.
    pub fn obc_polycube_construction(map: *const obc_polycube) -> i32;
    /// Copies to the caller's arrays, each of which may be NULL: positions in space (x y z a vertex; the surface's vertices first, to
    /// the bit), polycube positions, triangles (three vertices each). Errors: invalid argument.
    pub fn obc_polycube_copy(map: *const obc_polycube, positions: *mut f64, polycube: *mut f64, triangles: *mut u32, error: *mut obc_error) -> i32;
    /// Copies what is known of each triangle, each array may be NULL: the direction it looks in on the polycube (0 to 5 for +x, -x, +y,
    /// -y, +z, -z), its face of the polycube, and the surface's triangle that it lies in. Errors: invalid argument.
    pub fn obc_polycube_copy_triangles(map: *const obc_polycube, labels: *mut u8, patches: *mut u32, sources: *mut u32, error: *mut obc_error) -> i32;
    /// Copies where each vertex comes from, three entries a vertex, each array may be NULL: vertices of one triangle of the surface
    /// (UINT32\_MAX where fewer than three are needed) and their weights, positive (0 where not needed) with the sum 1. Errors:
    /// invalid argument.
    pub fn obc_polycube_copy_sources(map: *const obc_polycube, corners: *mut u32, weights: *mut f64, error: *mut obc_error) -> i32;
    /// Maps a surface to a polycube that is given by its triangles, each in an axis-aligned plane. It is drawn on the surface, as
    /// OBC\_POLYCUBE\_VOXELS does with its own: where it stands, its box stretched to that of the surface, or where the places say.
    /// The handle's polycube has the very coordinates of the one given; the map is smoothed across its edges. places may be NULL.
    /// Errors: those of obc\_polycube\_compute; invalid argument for places that do not exist or are given twice; unsupported when the
    /// polycube is none, with the reason; wrong genus when the surface has another.
    pub fn obc_polycube_compute_on(surface: *const obc_surface, polycube: *const obc_surface, places: *const obc_polycube_places, host: *const obc_host, out: *mut *mut obc_polycube, error: *mut obc_error) -> i32;
    /// One polycube for several shapes of one genus and kind (the dissertation's section 4.5): several polycubes of each are drawn on
    /// all others, proportions and maps are optimised for the sum of energies, and the one with the least sum is kept. Maps between
    /// shapes are compositions: what is at one point of the polycube corresponds. options are for each shape's own polycube, domain
    /// for the energy. out is an array of \`count\` handles, in the order of the surfaces, all NULL after an error; made\_for may be NULL
    /// or gets the number of the shape that the polycube was made for. obc\_polycube\_copy\_energies of each handle gives the sums,
    /// which never rise. Errors: those of obc\_polycube\_compute, and wrong genus.
    pub fn obc_polycube_compute_common(surfaces: *const obc_surface, count: usize, options: *const obc_polycube_options, domain: *const obc_polycube_domain_options, host: *const obc_host, made_for: *mut usize, out: *mut *mut obc_polycube, error: *mut obc_error) -> i32;
    /// obc\_polycube\_optimize\_domain for several maps to one and the same polycube: the proportions with the least sum of energies.
    /// out is an array of \`count\` handles, all NULL after an error. Errors: invalid argument (among them maps to different
    /// polycubes), out of memory, cancelled.
    pub fn obc_polycube_optimize_common_domain(maps: *const *const obc_polycube, count: usize, options: *const obc_polycube_domain_options, host: *const obc_host, out: *mut *mut obc_polycube, error: *mut obc_error) -> i32;
    /// Errors: invalid argument, out of memory, cancelled.
    pub fn obc_polycube_graph_create(map: *const obc_polycube, host: *const obc_host, out: *mut *mut obc_polycube_graph, error: *mut obc_error) -> i32;
    /// Releases a graph; NULL is fine.
    pub fn obc_polycube_graph_destroy(graph: *mut obc_polycube_graph);
    /// Numbers; 0 for NULL. Links: of the dual graph, where patches that share several edges are neighbours once, each link counted
    /// from both ends.
    pub fn obc_polycube_graph_corner_count(graph: *const obc_polycube_graph) -> usize;
    /// Numbers; 0 for NULL. Links: of the dual graph, where patches that share several edges are neighbours once, each link counted
    /// from both ends.
    pub fn obc_polycube_graph_edge_count(graph: *const obc_polycube_graph) -> usize;
    /// Numbers; 0 for NULL. Links: of the dual graph, where patches that share several edges are neighbours once, each link counted
    /// from both ends.
    pub fn obc_polycube_graph_patch_count(graph: *const obc_polycube_graph) -> usize;
    /// Numbers; 0 for NULL. Links: of the dual graph, where patches that share several edges are neighbours once, each link counted
    /// from both ends.
    pub fn obc_polycube_graph_loop_count(graph: *const obc_polycube_graph) -> usize;
    /// Numbers; 0 for NULL. Links: of the dual graph, where patches that share several edges are neighbours once, each link counted
    /// from both ends.
    pub fn obc_polycube_graph_link_count(graph: *const obc_polycube_graph) -> usize;
    /// Copies to the caller's arrays, each of which may be NULL, as in all these functions. Of each corner its position (x y z) and
    /// its vertex of the map. Errors: invalid argument.
    pub fn obc_polycube_graph_copy_corners(graph: *const obc_polycube_graph, positions: *mut f64, vertices: *mut u32, error: *mut obc_error) -> i32;
    /// Of each edge: its two corners, the patches on the left and on the right of the way from the first to the second, seen from
    /// outside, and whether the solid has one right angle there (1, convex) or three (0, concave).
    pub fn obc_polycube_graph_copy_edges(graph: *const obc_polycube_graph, corners: *mut u32, patches: *mut u32, convex: *mut u8, error: *mut obc_error) -> i32;
    /// Of each patch, which has the number that obc\_polycube\_copy\_triangles gives: the direction it looks in (0 to 5 for +x, -x, +y,
    /// -y, +z, -z), the coordinate of its plane, and where its loops begin among all loops: first the one around it, then those
    /// around its holes; loop\_starts has an entry more than there are patches.
    pub fn obc_polycube_graph_copy_patches(graph: *const obc_polycube_graph, labels: *mut u8, coordinates: *mut f64, loop_starts: *mut u32, error: *mut obc_error) -> i32;
    /// Of each loop where it begins among all darts, with an entry more than there are loops, and its darts, counter-clockwise around
    /// the patch: dart 2 e is edge e from its first corner to its second, dart 2 e + 1 the way back. Each dart is in one loop.
    pub fn obc_polycube_graph_copy_loops(graph: *const obc_polycube_graph, starts: *mut u32, darts: *mut u32, error: *mut obc_error) -> i32;
    /// The dual graph: where the neighbours of each patch begin, with an entry more than there are patches, and the patches that
    /// share an edge with it, ascending.
    pub fn obc_polycube_graph_copy_dual(graph: *const obc_polycube_graph, starts: *mut u32, neighbours: *mut u32, error: *mut obc_error) -> i32;
    /// The defaults, which the members' comments give.
    pub fn obc_polycube_quads_options_init(options: *mut obc_polycube_quads_options, struct_size: usize) -> i32;
    /// Makes the grid, with integer numbers of cells between neighbouring planes, and takes its vertices to the surface, each
    /// in the triangle that has it by exact arithmetic. Depends on the polycube alone, but for positions: maps to one polycube give
    /// the same quads. Errors: invalid argument (among them more than 10^8 quads), out of memory, cancelled.
    pub fn obc_polycube_quads_create(map: *const obc_polycube, options: *const obc_polycube_quads_options, host: *const obc_host, out: *mut *mut obc_polycube_quads, error: *mut obc_error) -> i32;
    /// Releases quads; NULL is fine.
    pub fn obc_polycube_quads_destroy(quads: *mut obc_polycube_quads);
    /// Numbers; 0 for NULL.
    pub fn obc_polycube_quads_vertex_count(quads: *const obc_polycube_quads) -> usize;
    /// Numbers; 0 for NULL.
    pub fn obc_polycube_quads_quad_count(quads: *const obc_polycube_quads) -> usize;
    /// Copies to the caller's arrays, each of which may be NULL: of each vertex its position on the surface and on the polycube (x y
    /// z), of each quad its four vertices, counter-clockwise seen from outside, and its patch. Errors: invalid argument.
    pub fn obc_polycube_quads_copy(quads: *const obc_polycube_quads, positions: *mut f64, polycube: *mut f64, corners: *mut u32, patches: *mut u32, error: *mut obc_error) -> i32;
    /// Of each vertex the triangle of the map that it is in and its weights at the three corners, none negative, with the sum 1.
    pub fn obc_polycube_quads_copy_sources(quads: *const obc_polycube_quads, triangles: *mut u32, weights: *mut f64, error: *mut obc_error) -> i32;
    /// Version of this library, major \* 10000 + minor \* 100 + patch.
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
        assert_eq!((size_of::<obc_polycube_options>(), align_of::<obc_polycube_options>()), (24, 8));
        let it = MaybeUninit::<obc_polycube_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_polycube_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).construction) } as usize - start as usize, 4, "obc_polycube_options.construction");
        assert_eq!(unsafe { addr_of!((*start).corners) } as usize - start as usize, 8, "obc_polycube_options.corners");
        assert_eq!(unsafe { addr_of!((*start).seed) } as usize - start as usize, 16, "obc_polycube_options.seed");
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
        assert_eq!(unsafe { addr_of!((*start).places) } as usize - start as usize, 24, "obc_polycube_feature_options.places");
        assert_eq!(unsafe { addr_of!((*start).point_weights) } as usize - start as usize, 32, "obc_polycube_feature_options.point_weights");
        assert_eq!(unsafe { addr_of!((*start).curve_count) } as usize - start as usize, 40, "obc_polycube_feature_options.curve_count");
        assert_eq!(unsafe { addr_of!((*start).curve_starts) } as usize - start as usize, 48, "obc_polycube_feature_options.curve_starts");
        assert_eq!(unsafe { addr_of!((*start).curve_vertices) } as usize - start as usize, 56, "obc_polycube_feature_options.curve_vertices");
        assert_eq!(unsafe { addr_of!((*start).curve_lines) } as usize - start as usize, 64, "obc_polycube_feature_options.curve_lines");
        assert_eq!(unsafe { addr_of!((*start).curve_weights) } as usize - start as usize, 72, "obc_polycube_feature_options.curve_weights");
        assert_eq!(unsafe { addr_of!((*start).sharp_angle) } as usize - start as usize, 80, "obc_polycube_feature_options.sharp_angle");
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
        assert_eq!((size_of::<obc_polycube_places>(), align_of::<obc_polycube_places>()), (32, 8));
        let it = MaybeUninit::<obc_polycube_places>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).corners) } as usize - start as usize, 0, "obc_polycube_places.corners");
        assert_eq!(unsafe { addr_of!((*start).vertices) } as usize - start as usize, 8, "obc_polycube_places.vertices");
        assert_eq!(unsafe { addr_of!((*start).points) } as usize - start as usize, 16, "obc_polycube_places.points");
        assert_eq!(unsafe { addr_of!((*start).count) } as usize - start as usize, 24, "obc_polycube_places.count");
        assert_eq!((size_of::<obc_polycube_quads_options>(), align_of::<obc_polycube_quads_options>()), (24, 8));
        let it = MaybeUninit::<obc_polycube_quads_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_polycube_quads_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).quads) } as usize - start as usize, 8, "obc_polycube_quads_options.quads");
        assert_eq!(unsafe { addr_of!((*start).edge_length) } as usize - start as usize, 16, "obc_polycube_quads_options.edge_length");
    }
}
