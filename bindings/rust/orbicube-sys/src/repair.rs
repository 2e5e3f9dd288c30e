//! What `<orbicube/repair.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use crate::mesh::obc_surface;
use std::os::raw::{c_char};

/// size: distance from the vertex that it was welded to
pub const OBC_REPAIR_WELDED_VERTEX: i32 = 0;
/// a face with a repeated corner
pub const OBC_REPAIR_REMOVED_DEGENERATE: i32 = 1;
/// a face on the corners of another
pub const OBC_REPAIR_REMOVED_DUPLICATE: i32 = 2;
/// of a near-degenerate triangle; size: length of the edge
pub const OBC_REPAIR_COLLAPSED_EDGE: i32 = 3;
/// the longest of a near-degenerate triangle; size: height of the triangle
pub const OBC_REPAIR_FLIPPED_EDGE: i32 = 4;
/// a near-degenerate triangle that stays; size: its height
pub const OBC_REPAIR_LEFT_NEAR_DEGENERATE: i32 = 5;
/// an edge split at a vertex on it; size: distance of the vertex from the edge
pub const OBC_REPAIR_SPLIT_EDGE: i32 = 6;
/// count: faces at the edge; size: its length
pub const OBC_REPAIR_SPLIT_CONTACT_EDGE: i32 = 7;
/// count: fans of faces at the vertex
pub const OBC_REPAIR_SPLIT_CONTACT_VERTEX: i32 = 8;
/// count: triangles; size: area
pub const OBC_REPAIR_DROPPED_PART: i32 = 9;
/// count: edges of the boundary loop; size: its length
pub const OBC_REPAIR_FILLED_HOLE: i32 = 10;
/// the same of a hole that stays open
pub const OBC_REPAIR_LEFT_HOLE: i32 = 11;
/// count: edges of the loop; size: its length
pub const OBC_REPAIR_CUT_HANDLE: i32 = 12;

/// A repaired surface.
#[repr(C)]
pub struct obc_repair {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Options of a repair. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_repair_options {
    pub struct_size: u32,
    /// 1: vertices of open edges are welded; 0: not. Default: 1.
    pub weld: i32,
    /// 1: degenerate and repeated faces and unused vertices are removed; 0: not. Default: 1.
    pub clean: i32,
    /// 1: near-degenerate triangles are collapsed or flipped, if clean is 1; 0: not. Default: 1.
    pub slivers: i32,
    /// 1: open edges are split at vertices on them; 0: not. Default: 1.
    pub t_junctions: i32,
    /// 1: faces are oriented consistently and outward; 0: not. Default: 1.
    pub orient: i32,
    /// 1: edges of more than two faces and vertices of more than one fan are split; 0: not. Default: 1.
    pub contacts: i32,
    /// 1: parts are dropped by the members below; 0: not. Default: 1.
    pub drop_parts: i32,
    /// 1: parts inside an odd number of others are kept and bound cavities; 0: they are dropped. Default: 0.
    pub cavities: i32,
    /// 1: boundary loops are filled; 0: not. Default: 1.
    pub fill_holes: i32,
    /// 1: patches of holes are refined and bent to continue the surface; 0: not. Default: 1.
    pub fair: i32,
    /// 1: the result is searched for intersecting triangles; 0: not. Default: 1.
    pub find_intersections: i32,
    /// handles and tunnels are cut, the shortest loops first, down to this genus, summed over the parts; negative: no
    /// limit. Default: -1.
    pub max_genus: i32,
    /// maximum distance of welded vertices; 0: the same position and, while edges are open, 1e-6 of the diagonal of the
    /// bounding box. Default: 0.
    pub weld_distance: f64,
    /// maximum height of near-degenerate triangles over their longest side, below 0.5. Default: 1e-6.
    pub sliver_ratio: f64,
    /// bound of the movement of the surface by their removal; 0: 1e-5 of the diagonal. Default: 0.
    pub sliver_move: f64,
    /// maximum distance of a vertex from the edge that it splits; 0: 1e-6 of the diagonal. Default: 0.
    pub t_junction_distance: f64,
    /// distance by which vertices of split contacts move into their own sheet's inner side. Default: 0.
    pub contact_gap: f64,
    /// minimum area of a part, in percent of that of all; the largest stays. Default: 0.
    pub min_area_percent: f64,
    /// number of parts to keep, the largest by area; 0: no limit. Default: 1.
    pub keep_parts: usize,
    /// maximum number of edges of a hole to fill; 0: no limit. Default: 0.
    pub max_hole_edges: usize,
    /// maximum length of the loop of a handle or tunnel to cut; 0: no limit, and none is cut unless max\_genus is set.
    /// Default: 0.
    pub max_handle_length: f64,
    /// distance of a surface around all parts that replaces them, free of self-intersections; 0: none. Default: 0.
    pub wrap_offset: f64,
}

/// Figures of a repair and the certificate of its result. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_repair_report {
    pub struct_size: u32,
    /// 0: the surface is the input, bit for bit
    pub changed: i32,
    /// certificate: no boundary
    pub closed: i32,
    /// certificate: no edge of more than two faces, no vertex that joins parts, no degenerate or repeated face
    pub manifold: i32,
    /// certificate: each edge is passed once in each direction
    pub oriented: i32,
    /// 0: faces cannot be oriented consistently
    pub orientable: i32,
    pub welded_vertices: usize,
    pub weld_lost_triangles: usize,
    /// removed; unused vertices include those that steps left without faces
    pub degenerate_faces: usize,
    /// removed; unused vertices include those that steps left without faces
    pub duplicate_faces: usize,
    /// removed; unused vertices include those that steps left without faces
    pub unused_vertices: usize,
    pub near_degenerate: usize,
    pub collapsed_edges: usize,
    pub flipped_edges: usize,
    pub left_near_degenerate: usize,
    /// splits of an edge at a vertex
    pub t_junctions: usize,
    pub reversed_triangles: usize,
    pub contact_edges: usize,
    pub contact_vertices: usize,
    pub contact_added_vertices: usize,
    pub found_parts: usize,
    pub kept_parts: usize,
    pub cavity_parts: usize,
    pub dropped_triangles: usize,
    pub found_holes: usize,
    pub filled_holes: usize,
    pub patch_triangles: usize,
    pub patch_vertices: usize,
    pub cut_handles: usize,
    /// largest movement by these steps
    pub weld_move: f64,
    /// largest movement by these steps
    pub sliver_move: f64,
    /// largest movement by these steps
    pub t_junction_move: f64,
    /// largest movement by these steps
    pub handle_move: f64,
    /// length of the longest loop that was cut
    pub longest_handle: f64,
    /// of the area of all parts
    pub dropped_area_percent: f64,
    /// largest distance of changed triangles of the input from the result, without dropped parts
    pub distance_from_input: f64,
    /// largest distance of changed triangles of the result from the input, without patches
    pub distance_from_result: f64,
    /// largest distance of patches of holes from the input
    pub distance_of_patches: f64,
    /// certificate: of the result
    pub parts: usize,
    /// certificate: sum over the parts of a closed, oriented manifold; else 0
    pub genus: i64,
    /// certificate
    pub boundary_loops: usize,
    /// certificate: pairs of triangles that intersect, by exact arithmetic; at most 10000 are counted
    pub self_intersections: usize,
    /// of the result; volume 0 unless it is a closed, oriented manifold
    pub area: f64,
    /// of the result; volume 0 unless it is a closed, oriented manifold
    pub volume: f64,
}

/// Options of the surface of a label. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_repair_label_options {
    pub struct_size: u32,
    /// label whose voxels are the object; 0: the only one besides 0. Default: 0.
    pub label: i32,
    /// 1: cavities are kept, as surfaces inside, if handles is 1; 0: they are filled. Default: 0.
    pub cavities: i32,
    /// 1: handles and tunnels are kept; 0: they are removed, so that each part has genus 0. Default: 0.
    pub handles: i32,
    /// number of parts to keep, those with the largest number of voxels; 0: all. Default: 1.
    pub keep_parts: usize,
    /// standard deviation of the Gaussian that smooths the object, in voxels, 0 to 10; 0: none. Default: 1.
    pub smoothing: f64,
    /// maximum distance of a vertex from the middle between two voxel centers, as a fraction of their distance, below 0.5.
    /// Default: 0.45.
    pub max_slide: f64,
}

/// Figures of the surface of a label. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_repair_label_report {
    pub struct_size: u32,
    /// whose surface it is
    pub label: i32,
    /// of the label
    pub voxels: usize,
    /// of these at the border of the image, where the surface is closed
    pub border_voxels: usize,
    /// connected through faces of voxels
    pub found_parts: usize,
    /// of these; parts inside others are part of them where cavities are filled
    pub kept_parts: usize,
    /// of the other parts
    pub dropped_voxels: usize,
    /// filled
    pub cavities: usize,
    /// of cavities
    pub filled_voxels: usize,
    /// handles and tunnels that were removed
    pub handles: usize,
    /// to close tunnels
    pub added_voxels: usize,
    /// to cut handles
    pub removed_voxels: usize,
    /// moved back to the middle between two voxel centers, because triangles intersected
    pub centered_vertices: usize,
    /// distance of a vertex from this middle, as a fraction of the distance of the centers
    pub largest_slide: f64,
}

extern "C" {
    /// Fills options with the defaults.
    pub fn obc_repair_options_init(options: *mut obc_repair_options, struct_size: usize) -> i32;
    /// Fills a report with zeros and its struct\_size.
    pub fn obc_repair_report_init(report: *mut obc_repair_report, struct_size: usize) -> i32;
    /// Repairs a surface: any triangles, which need not be connected, closed, oriented or manifold. options and host may be NULL. Whether a
    /// closed, oriented, manifold surface was reached is in the report. \*out is NULL after an error; the allocator of the host must
    /// remain valid until \_destroy. Takes O(n log n) and, for each hole of k edges, O(k \* 150^2); a wrap needs
    /// (size / wrap\_offset)^3 bytes times five, at most 67 million nodes. Errors: OBC\_INVALID\_ARGUMENT,
    /// OBC\_MALFORMED\_FILE (kind empty-mesh: no triangles), OBC\_DEGENERATE (no triangle is left), OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_repair_compute(surface: *const obc_surface, options: *const obc_repair_options, host: *const obc_host, out: *mut *mut obc_repair, error: *mut obc_error) -> i32;
    /// Destroys a repaired surface; NULL is allowed.
    pub fn obc_repair_destroy(repaired: *mut obc_repair);
    /// Return the numbers of vertices, triangles and events; 0 for NULL.
    pub fn obc_repair_vertex_count(repaired: *const obc_repair) -> usize;
    /// Return the numbers of vertices, triangles and events; 0 for NULL.
    pub fn obc_repair_triangle_count(repaired: *const obc_repair) -> usize;
    /// Return the numbers of vertices, triangles and events; 0 for NULL.
    pub fn obc_repair_event_count(repaired: *const obc_repair) -> usize;
    /// Copies the surface to arrays of the caller, each of which may be NULL: positions (x y z a vertex), triangles (three vertices each), and
    /// for each vertex and triangle its number in the input, or UINT32\_MAX where the repair made it. Errors: OBC\_INVALID\_ARGUMENT.
    pub fn obc_repair_copy(repaired: *const obc_repair, positions: *mut f64, triangles: *mut u32, vertex_source: *mut u32, triangle_source: *mut u32, error: *mut obc_error) -> i32;
    /// Copies what was done, in the order in which it was, to arrays of the caller with an entry an event, each of which may be NULL: actions
    /// (OBC\_REPAIR\_...), counts, places (x y z an event) and sizes. Errors: OBC\_INVALID\_ARGUMENT.
    pub fn obc_repair_copy_events(repaired: *const obc_repair, actions: *mut i32, counts: *mut u32, places: *mut f64, sizes: *mut f64, error: *mut obc_error) -> i32;
    /// Fills a report. Errors: OBC\_INVALID\_ARGUMENT.
    pub fn obc_repair_get_report(repaired: *const obc_repair, report: *mut obc_repair_report, error: *mut obc_error) -> i32;
    /// Returns the name of an action, as "filled-hole", or "unknown".
    pub fn obc_repair_action_name(action: i32) -> *const c_char;
    /// Fills options with the defaults.
    pub fn obc_repair_label_options_init(options: *mut obc_repair_label_options, struct_size: usize) -> i32;
    /// Fills a report with zeros and its struct\_size.
    pub fn obc_repair_label_report_init(report: *mut obc_repair_label_report, struct_size: usize) -> i32;
    /// Extracts the closed surface of a label of an image: labels of size\[0\] \* size\[1\] \* size\[2\] voxels, x fastest, and to\_world, a 4x4 matrix,
    /// row-major, from (x, y, z, 1) to positions, with voxel centers at whole numbers and the last row 0 0 0 1; NULL: positions are
    /// voxel numbers. It is outward-oriented, also where to\_world mirrors. The largest parts are kept, cavities filled, handles and tunnels
    /// removed at their thinnest places by homotopic growth and shrinking; vertices lie between the centers of adjacent voxels where
    /// the smoothed object ends. No triangles intersect, the centers of the object's voxels are inside and all others outside, and the
    /// surface is within half a voxel of the sides of its voxels. options and host may be NULL. \*out is NULL after an error; its
    /// certificate is in the report of obc\_repair\_get\_report, its sources are all UINT32\_MAX, it has no events. Takes O(n log n) of the
    /// voxels in the label's box and about 20 bytes for each of them. Errors: OBC\_INVALID\_ARGUMENT (sizes that overflow, a singular map, a
    /// label that is not there, several labels and none chosen; the message lists those that are there), OBC\_NO\_VALID\_RESULT (large
    /// coordinates leave too few digits, so that triangles intersect), OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_repair_surface_of_label(labels: *const i32, size: *const usize, to_world: *const f64, options: *const obc_repair_label_options, host: *const obc_host, out: *mut *mut obc_repair, error: *mut obc_error) -> i32;
    /// Fills a report of obc\_repair\_surface\_of\_label; zeros for other repairs. Errors: OBC\_INVALID\_ARGUMENT.
    pub fn obc_repair_get_label_report(repaired: *const obc_repair, report: *mut obc_repair_label_report, error: *mut obc_error) -> i32;
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_repair_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_repair_options>(), align_of::<obc_repair_options>()), (136, 8));
        let it = MaybeUninit::<obc_repair_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_repair_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).weld) } as usize - start as usize, 4, "obc_repair_options.weld");
        assert_eq!(unsafe { addr_of!((*start).clean) } as usize - start as usize, 8, "obc_repair_options.clean");
        assert_eq!(unsafe { addr_of!((*start).slivers) } as usize - start as usize, 12, "obc_repair_options.slivers");
        assert_eq!(unsafe { addr_of!((*start).t_junctions) } as usize - start as usize, 16, "obc_repair_options.t_junctions");
        assert_eq!(unsafe { addr_of!((*start).orient) } as usize - start as usize, 20, "obc_repair_options.orient");
        assert_eq!(unsafe { addr_of!((*start).contacts) } as usize - start as usize, 24, "obc_repair_options.contacts");
        assert_eq!(unsafe { addr_of!((*start).drop_parts) } as usize - start as usize, 28, "obc_repair_options.drop_parts");
        assert_eq!(unsafe { addr_of!((*start).cavities) } as usize - start as usize, 32, "obc_repair_options.cavities");
        assert_eq!(unsafe { addr_of!((*start).fill_holes) } as usize - start as usize, 36, "obc_repair_options.fill_holes");
        assert_eq!(unsafe { addr_of!((*start).fair) } as usize - start as usize, 40, "obc_repair_options.fair");
        assert_eq!(unsafe { addr_of!((*start).find_intersections) } as usize - start as usize, 44, "obc_repair_options.find_intersections");
        assert_eq!(unsafe { addr_of!((*start).max_genus) } as usize - start as usize, 48, "obc_repair_options.max_genus");
        assert_eq!(unsafe { addr_of!((*start).weld_distance) } as usize - start as usize, 56, "obc_repair_options.weld_distance");
        assert_eq!(unsafe { addr_of!((*start).sliver_ratio) } as usize - start as usize, 64, "obc_repair_options.sliver_ratio");
        assert_eq!(unsafe { addr_of!((*start).sliver_move) } as usize - start as usize, 72, "obc_repair_options.sliver_move");
        assert_eq!(unsafe { addr_of!((*start).t_junction_distance) } as usize - start as usize, 80, "obc_repair_options.t_junction_distance");
        assert_eq!(unsafe { addr_of!((*start).contact_gap) } as usize - start as usize, 88, "obc_repair_options.contact_gap");
        assert_eq!(unsafe { addr_of!((*start).min_area_percent) } as usize - start as usize, 96, "obc_repair_options.min_area_percent");
        assert_eq!(unsafe { addr_of!((*start).keep_parts) } as usize - start as usize, 104, "obc_repair_options.keep_parts");
        assert_eq!(unsafe { addr_of!((*start).max_hole_edges) } as usize - start as usize, 112, "obc_repair_options.max_hole_edges");
        assert_eq!(unsafe { addr_of!((*start).max_handle_length) } as usize - start as usize, 120, "obc_repair_options.max_handle_length");
        assert_eq!(unsafe { addr_of!((*start).wrap_offset) } as usize - start as usize, 128, "obc_repair_options.wrap_offset");
        assert_eq!((size_of::<obc_repair_report>(), align_of::<obc_repair_report>()), (328, 8));
        let it = MaybeUninit::<obc_repair_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_repair_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).changed) } as usize - start as usize, 4, "obc_repair_report.changed");
        assert_eq!(unsafe { addr_of!((*start).closed) } as usize - start as usize, 8, "obc_repair_report.closed");
        assert_eq!(unsafe { addr_of!((*start).manifold) } as usize - start as usize, 12, "obc_repair_report.manifold");
        assert_eq!(unsafe { addr_of!((*start).oriented) } as usize - start as usize, 16, "obc_repair_report.oriented");
        assert_eq!(unsafe { addr_of!((*start).orientable) } as usize - start as usize, 20, "obc_repair_report.orientable");
        assert_eq!(unsafe { addr_of!((*start).welded_vertices) } as usize - start as usize, 24, "obc_repair_report.welded_vertices");
        assert_eq!(unsafe { addr_of!((*start).weld_lost_triangles) } as usize - start as usize, 32, "obc_repair_report.weld_lost_triangles");
        assert_eq!(unsafe { addr_of!((*start).degenerate_faces) } as usize - start as usize, 40, "obc_repair_report.degenerate_faces");
        assert_eq!(unsafe { addr_of!((*start).duplicate_faces) } as usize - start as usize, 48, "obc_repair_report.duplicate_faces");
        assert_eq!(unsafe { addr_of!((*start).unused_vertices) } as usize - start as usize, 56, "obc_repair_report.unused_vertices");
        assert_eq!(unsafe { addr_of!((*start).near_degenerate) } as usize - start as usize, 64, "obc_repair_report.near_degenerate");
        assert_eq!(unsafe { addr_of!((*start).collapsed_edges) } as usize - start as usize, 72, "obc_repair_report.collapsed_edges");
        assert_eq!(unsafe { addr_of!((*start).flipped_edges) } as usize - start as usize, 80, "obc_repair_report.flipped_edges");
        assert_eq!(unsafe { addr_of!((*start).left_near_degenerate) } as usize - start as usize, 88, "obc_repair_report.left_near_degenerate");
        assert_eq!(unsafe { addr_of!((*start).t_junctions) } as usize - start as usize, 96, "obc_repair_report.t_junctions");
        assert_eq!(unsafe { addr_of!((*start).reversed_triangles) } as usize - start as usize, 104, "obc_repair_report.reversed_triangles");
        assert_eq!(unsafe { addr_of!((*start).contact_edges) } as usize - start as usize, 112, "obc_repair_report.contact_edges");
        assert_eq!(unsafe { addr_of!((*start).contact_vertices) } as usize - start as usize, 120, "obc_repair_report.contact_vertices");
        assert_eq!(unsafe { addr_of!((*start).contact_added_vertices) } as usize - start as usize, 128, "obc_repair_report.contact_added_vertices");
        assert_eq!(unsafe { addr_of!((*start).found_parts) } as usize - start as usize, 136, "obc_repair_report.found_parts");
        assert_eq!(unsafe { addr_of!((*start).kept_parts) } as usize - start as usize, 144, "obc_repair_report.kept_parts");
        assert_eq!(unsafe { addr_of!((*start).cavity_parts) } as usize - start as usize, 152, "obc_repair_report.cavity_parts");
        assert_eq!(unsafe { addr_of!((*start).dropped_triangles) } as usize - start as usize, 160, "obc_repair_report.dropped_triangles");
        assert_eq!(unsafe { addr_of!((*start).found_holes) } as usize - start as usize, 168, "obc_repair_report.found_holes");
        assert_eq!(unsafe { addr_of!((*start).filled_holes) } as usize - start as usize, 176, "obc_repair_report.filled_holes");
        assert_eq!(unsafe { addr_of!((*start).patch_triangles) } as usize - start as usize, 184, "obc_repair_report.patch_triangles");
        assert_eq!(unsafe { addr_of!((*start).patch_vertices) } as usize - start as usize, 192, "obc_repair_report.patch_vertices");
        assert_eq!(unsafe { addr_of!((*start).cut_handles) } as usize - start as usize, 200, "obc_repair_report.cut_handles");
        assert_eq!(unsafe { addr_of!((*start).weld_move) } as usize - start as usize, 208, "obc_repair_report.weld_move");
        assert_eq!(unsafe { addr_of!((*start).sliver_move) } as usize - start as usize, 216, "obc_repair_report.sliver_move");
        assert_eq!(unsafe { addr_of!((*start).t_junction_move) } as usize - start as usize, 224, "obc_repair_report.t_junction_move");
        assert_eq!(unsafe { addr_of!((*start).handle_move) } as usize - start as usize, 232, "obc_repair_report.handle_move");
        assert_eq!(unsafe { addr_of!((*start).longest_handle) } as usize - start as usize, 240, "obc_repair_report.longest_handle");
        assert_eq!(unsafe { addr_of!((*start).dropped_area_percent) } as usize - start as usize, 248, "obc_repair_report.dropped_area_percent");
        assert_eq!(unsafe { addr_of!((*start).distance_from_input) } as usize - start as usize, 256, "obc_repair_report.distance_from_input");
        assert_eq!(unsafe { addr_of!((*start).distance_from_result) } as usize - start as usize, 264, "obc_repair_report.distance_from_result");
        assert_eq!(unsafe { addr_of!((*start).distance_of_patches) } as usize - start as usize, 272, "obc_repair_report.distance_of_patches");
        assert_eq!(unsafe { addr_of!((*start).parts) } as usize - start as usize, 280, "obc_repair_report.parts");
        assert_eq!(unsafe { addr_of!((*start).genus) } as usize - start as usize, 288, "obc_repair_report.genus");
        assert_eq!(unsafe { addr_of!((*start).boundary_loops) } as usize - start as usize, 296, "obc_repair_report.boundary_loops");
        assert_eq!(unsafe { addr_of!((*start).self_intersections) } as usize - start as usize, 304, "obc_repair_report.self_intersections");
        assert_eq!(unsafe { addr_of!((*start).area) } as usize - start as usize, 312, "obc_repair_report.area");
        assert_eq!(unsafe { addr_of!((*start).volume) } as usize - start as usize, 320, "obc_repair_report.volume");
        assert_eq!((size_of::<obc_repair_label_options>(), align_of::<obc_repair_label_options>()), (40, 8));
        let it = MaybeUninit::<obc_repair_label_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_repair_label_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).label) } as usize - start as usize, 4, "obc_repair_label_options.label");
        assert_eq!(unsafe { addr_of!((*start).cavities) } as usize - start as usize, 8, "obc_repair_label_options.cavities");
        assert_eq!(unsafe { addr_of!((*start).handles) } as usize - start as usize, 12, "obc_repair_label_options.handles");
        assert_eq!(unsafe { addr_of!((*start).keep_parts) } as usize - start as usize, 16, "obc_repair_label_options.keep_parts");
        assert_eq!(unsafe { addr_of!((*start).smoothing) } as usize - start as usize, 24, "obc_repair_label_options.smoothing");
        assert_eq!(unsafe { addr_of!((*start).max_slide) } as usize - start as usize, 32, "obc_repair_label_options.max_slide");
        assert_eq!((size_of::<obc_repair_label_report>(), align_of::<obc_repair_label_report>()), (104, 8));
        let it = MaybeUninit::<obc_repair_label_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_repair_label_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).label) } as usize - start as usize, 4, "obc_repair_label_report.label");
        assert_eq!(unsafe { addr_of!((*start).voxels) } as usize - start as usize, 8, "obc_repair_label_report.voxels");
        assert_eq!(unsafe { addr_of!((*start).border_voxels) } as usize - start as usize, 16, "obc_repair_label_report.border_voxels");
        assert_eq!(unsafe { addr_of!((*start).found_parts) } as usize - start as usize, 24, "obc_repair_label_report.found_parts");
        assert_eq!(unsafe { addr_of!((*start).kept_parts) } as usize - start as usize, 32, "obc_repair_label_report.kept_parts");
        assert_eq!(unsafe { addr_of!((*start).dropped_voxels) } as usize - start as usize, 40, "obc_repair_label_report.dropped_voxels");
        assert_eq!(unsafe { addr_of!((*start).cavities) } as usize - start as usize, 48, "obc_repair_label_report.cavities");
        assert_eq!(unsafe { addr_of!((*start).filled_voxels) } as usize - start as usize, 56, "obc_repair_label_report.filled_voxels");
        assert_eq!(unsafe { addr_of!((*start).handles) } as usize - start as usize, 64, "obc_repair_label_report.handles");
        assert_eq!(unsafe { addr_of!((*start).added_voxels) } as usize - start as usize, 72, "obc_repair_label_report.added_voxels");
        assert_eq!(unsafe { addr_of!((*start).removed_voxels) } as usize - start as usize, 80, "obc_repair_label_report.removed_voxels");
        assert_eq!(unsafe { addr_of!((*start).centered_vertices) } as usize - start as usize, 88, "obc_repair_label_report.centered_vertices");
        assert_eq!(unsafe { addr_of!((*start).largest_slide) } as usize - start as usize, 96, "obc_repair_label_report.largest_slide");
    }
}
