//! What `<orbicube/mesh.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use std::os::raw::{c_char, c_void};

pub const OBC_MESH_OBJ: i32 = 0;
pub const OBC_MESH_OFF: i32 = 1;
/// ASCII and binary of either byte order, triangle strips
pub const OBC_MESH_PLY: i32 = 2;
/// ASCII and binary
pub const OBC_MESH_STL: i32 = 3;
pub const OBC_MESH_MEDIT: i32 = 4;
/// legacy, ASCII and binary
pub const OBC_MESH_VTK: i32 = 5;

/// A mesh in the library's memory.
#[repr(C)]
pub struct obc_mesh {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// A surface made ready for searching: trees of bounding boxes over its vertices and triangles.
#[repr(C)]
pub struct obc_mesh_search {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// A surface as the caller holds it: a view, kept by no function.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_surface {
    /// x y z a vertex
    pub positions: *const f64,
    pub vertex_count: usize,
    /// three vertex indices each, counter-clockwise seen from outside
    pub triangles: *const u32,
    pub triangle_count: usize,
}

/// Cells in the caller's arrays, for obc\_mesh\_create. Fill with \_init, then set what there is.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_mesh_cells {
    pub struct_size: u32,
    pub reserved: i32,
    pub positions: *const f64,
    pub vertex_count: usize,
    /// or NULL, as tetrahedra and hexahedra
    pub triangles: *const u32,
    pub triangle_count: usize,
    pub tetrahedra: *const u32,
    pub tetrahedron_count: usize,
    pub hexahedra: *const u32,
    pub hexahedron_count: usize,
}

/// How well shaped tetrahedra are. Ratios of inverted ones are negative, of flat ones 0; angles are in degrees.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_mesh_tetrahedron_quality_report {
    /// the first one of the smallest radius ratio; 2^32 - 1: there are none
    pub struct_size: u32,
    /// the first one of the smallest radius ratio; 2^32 - 1: there are none
    pub worst: u32,
    /// all, and those by their exact signs
    pub tetrahedra: u64,
    /// all, and those by their exact signs
    pub positive: u64,
    /// all, and those by their exact signs
    pub flat: u64,
    /// all, and those by their exact signs
    pub inverted: u64,
    /// of all together and of one; those of inverted ones negative
    pub volume: f64,
    /// of all together and of one; those of inverted ones negative
    pub smallest_volume: f64,
    /// of all together and of one; those of inverted ones negative
    pub largest_volume: f64,
    /// at the edges; the mean of each one's smallest
    pub smallest_dihedral: f64,
    /// at the edges; the mean of each one's smallest
    pub largest_dihedral: f64,
    /// at the edges; the mean of each one's smallest
    pub mean_smallest_dihedral: f64,
    /// 3 \* inradius / circumradius: 1 for a regular tetrahedron
    pub smallest_radius_ratio: f64,
    /// 3 \* inradius / circumradius: 1 for a regular tetrahedron
    pub mean_radius_ratio: f64,
    /// circumradius / shortest edge; infinite, and left out, for flat ones
    pub largest_radius_edge: f64,
    /// circumradius / shortest edge; infinite, and left out, for flat ones
    pub mean_radius_edge: f64,
    pub shortest_edge: f64,
    pub longest_edge: f64,
    /// six angles each, by 10 degrees; ratios by 0.05
    pub dihedral_histogram: [u64; 18],
    /// six angles each, by 10 degrees; ratios by 0.05
    pub radius_ratio_histogram: [u64; 20],
}

/// Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_mesh_read_options {
    pub struct_size: u32,
    /// 1: joins vertices at identical positions when the surface is not closed as it stands. STL, which
    /// has no shared vertices, is always joined. Default 0
    pub weld_identical: i32,
}

/// Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_mesh_write_options {
    pub struct_size: u32,
    /// 1: PLY, STL and VTK in binary; 0: as text. The other formats are text. Default 1
    pub binary: i32,
}

/// What kind of surface it is. The first place of a defect is given by vertices or faces, 2^32 - 1 where there is none.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_mesh_topology_report {
    pub struct_size: u32,
    /// 1: there are triangles and no boundary; else 0
    pub closed: i32,
    /// 1: no non-manifold, duplicate or degenerate places; else 0
    pub manifold: i32,
    /// 1: turning triangles round can make all edges consistent; else 0
    pub orientable: i32,
    pub vertices: u64,
    /// in no triangle; they take no part in the other figures
    pub unreferenced_vertices: u64,
    pub triangles: u64,
    pub edges: u64,
    /// connected through vertices
    pub components: u64,
    /// with one triangle
    pub boundary_edges: u64,
    /// connected parts of the boundary
    pub boundary_loops: u64,
    /// in edges
    pub longest_boundary_loop: u64,
    /// with three triangles or more
    pub non_manifold_edges: u64,
    /// whose triangles form more than one fan
    pub non_manifold_vertices: u64,
    /// that both of their triangles pass in the same direction
    pub inconsistent_edges: u64,
    /// with a repeated corner; they have no edges
    pub degenerate_faces: u64,
    /// with the corners of an earlier face, in any order
    pub duplicate_faces: u64,
    /// whose three different corners lie on one line, exactly
    pub zero_area_faces: u64,
    /// at the very position of an earlier vertex
    pub coincident_vertices: u64,
    /// vertices - edges + triangles
    pub euler_characteristic: i64,
    /// of a closed, connected, orientable manifold; -1 for others
    pub genus: i64,
    /// bounding box of the triangles
    pub low: [f64; 3],
    /// bounding box of the triangles
    pub high: [f64; 3],
    /// volume \< 0: looks inward. Infinite beyond the range of double
    pub area: f64,
    /// volume \< 0: looks inward. Infinite beyond the range of double
    pub volume: f64,
    pub first_boundary_edge: [u32; 2],
    pub first_non_manifold_edge: [u32; 2],
    pub first_inconsistent_edge: [u32; 2],
    pub first_duplicate_faces: [u32; 2],
    pub first_coincident_vertices: [u32; 2],
    pub first_non_manifold_vertex: u32,
    /// not connected with the first vertex
    pub first_vertex_apart: u32,
    pub first_degenerate_face: u32,
    pub first_zero_area_face: u32,
}

/// What obc\_mesh\_orient did.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_mesh_orient_report {
    pub struct_size: u32,
    /// 1: the closed surface looked inward, and all triangles were turned; else 0
    pub turned_outward: i32,
    /// before that, to agree with their neighbours
    pub triangles_turned: u64,
}

extern "C" {
    /// A mesh of nothing.
    pub fn obc_mesh_cells_init(cells: *mut obc_mesh_cells, struct_size: usize) -> i32;
    /// A mesh with copies of the arrays. host may be NULL; its allocator must stay valid until \_destroy. Errors: invalid argument,
    /// out of memory. O(n).
    pub fn obc_mesh_create(cells: *const obc_mesh_cells, host: *const obc_host, out: *mut *mut obc_mesh, error: *mut obc_error) -> i32;
    /// A closed surface by name ("creature", "torus", "cube", "sphere", "bracket", ...; obc\_mesh\_shape\_name lists them) of about
    /// \`triangle\_count\` triangles, two units in size; the seed varies it. Errors: invalid argument, out of memory, cancelled. O(n).
    pub fn obc_mesh_make(shape: *const c_char, triangle_count: usize, seed: u64, host: *const obc_host, out: *mut *mut obc_mesh, error: *mut obc_error) -> i32;
    /// Name of the index-th shape that obc\_mesh\_make knows, a static string; NULL beyond the last one.
    pub fn obc_mesh_shape_name(index: usize) -> *const c_char;
    /// Releases a mesh; NULL is fine.
    pub fn obc_mesh_destroy(mesh: *mut obc_mesh);
    /// Numbers of a mesh; 0 for NULL.
    pub fn obc_mesh_vertex_count(mesh: *const obc_mesh) -> usize;
    /// Numbers of a mesh; 0 for NULL.
    pub fn obc_mesh_triangle_count(mesh: *const obc_mesh) -> usize;
    /// Numbers of a mesh; 0 for NULL.
    pub fn obc_mesh_tetrahedron_count(mesh: *const obc_mesh) -> usize;
    /// Numbers of a mesh; 0 for NULL.
    pub fn obc_mesh_hexahedron_count(mesh: *const obc_mesh) -> usize;
    /// Copies to the caller's arrays, each of which may be NULL. Errors: invalid argument.
    pub fn obc_mesh_copy(mesh: *const obc_mesh, positions: *mut f64, triangles: *mut u32, tetrahedra: *mut u32, hexahedra: *mut u32, error: *mut obc_error) -> i32;
    /// A view of the mesh's own positions and triangles, valid until the mesh is destroyed. Errors: invalid argument.
    pub fn obc_mesh_surface(mesh: *const obc_mesh, surface: *mut obc_surface, error: *mut obc_error) -> i32;
    /// Whether the tetrahedra and hexahedra fill a solid: distinct, positive by exact predicates (hexahedra at each corner), meeting
    /// in whole faces, no face of three cells, no edge where parts only touch. OBC\_OK, also without cells; or degenerate or not
    /// manifold with the kind (inverted-cell, degenerate-cell, duplicate-cell, non-manifold-face, non-manifold-edge) and the
    /// first place; out of memory, cancelled. O(n log n).
    pub fn obc_mesh_check_cells(mesh: *const obc_mesh, host: *const obc_host, error: *mut obc_error) -> i32;
    /// The surface of the solid that the cells fill, looking outward, as a mesh of its own with the same vertices: the faces of one
    /// cell only, those of hexahedra cut in two. Errors: invalid argument, not manifold (a face of three cells), out of memory,
    /// cancelled. O(n log n).
    pub fn obc_mesh_boundary(mesh: *const obc_mesh, host: *const obc_host, out: *mut *mut obc_mesh, error: *mut obc_error) -> i32;
    /// An empty report that knows its size.
    pub fn obc_mesh_tetrahedron_quality_report_init(report: *mut obc_mesh_tetrahedron_quality_report, struct_size: usize) -> i32;
    /// Measures the tetrahedra of a mesh, whatever they are. Errors: invalid argument, cancelled. O(n).
    pub fn obc_mesh_tetrahedron_quality(mesh: *const obc_mesh, host: *const obc_host, report: *mut obc_mesh_tetrahedron_quality_report, error: *mut obc_error) -> i32;
    /// The defaults, which the members' comments give.
    pub fn obc_mesh_read_options_init(options: *mut obc_mesh_read_options, struct_size: usize) -> i32;
    /// Reads the file at \`path\` (bytes as the system takes them), its format by its ending: .obj .off .ply .stl .mesh .vtk.
    /// Vertices keep their order unless they are joined; faces of more corners are cut into triangles; cells are checked as by
    /// obc\_mesh\_check\_cells. options and host may be NULL; the host's allocator must stay valid until \_destroy. Nothing in a file
    /// is trusted; memory is bounded by a multiple of its size. Errors: io, malformed file (the kind says how: truncated, parse,
    /// index-range, non-finite, ...; the message where), the kinds of cells, unsupported, out of memory, cancelled. O(size).
    pub fn obc_mesh_read(path: *const c_char, options: *const obc_mesh_read_options, host: *const obc_host, out: *mut *mut obc_mesh, error: *mut obc_error) -> i32;
    /// The same from \`size\` bytes of a file of the format OBC\_MESH\_...; they are not kept.
    pub fn obc_mesh_read_memory(bytes: *const c_void, size: usize, format: i32, options: *const obc_mesh_read_options, host: *const obc_host, out: *mut *mut obc_mesh, error: *mut obc_error) -> i32;
    /// What was found in reading: the format, as "PLY, binary, big-endian"; polygons of more than three corners; vertices that were
    /// joined to others; and notes on what was changed or left out, one line each, the index-th one, NULL when there is none.
    /// Texts are UTF-8 and the mesh's. Empty and 0 for a mesh that was not read.
    pub fn obc_mesh_format(mesh: *const obc_mesh) -> *const c_char;
    /// What was found in reading: the format, as "PLY, binary, big-endian"; polygons of more than three corners; vertices that were
    /// joined to others; and notes on what was changed or left out, one line each, the index-th one, NULL when there is none.
    /// Texts are UTF-8 and the mesh's. Empty and 0 for a mesh that was not read.
    pub fn obc_mesh_polygon_count(mesh: *const obc_mesh) -> usize;
    /// What was found in reading: the format, as "PLY, binary, big-endian"; polygons of more than three corners; vertices that were
    /// joined to others; and notes on what was changed or left out, one line each, the index-th one, NULL when there is none.
    /// Texts are UTF-8 and the mesh's. Empty and 0 for a mesh that was not read.
    pub fn obc_mesh_welded_vertex_count(mesh: *const obc_mesh) -> usize;
    /// What was found in reading: the format, as "PLY, binary, big-endian"; polygons of more than three corners; vertices that were
    /// joined to others; and notes on what was changed or left out, one line each, the index-th one, NULL when there is none.
    /// Texts are UTF-8 and the mesh's. Empty and 0 for a mesh that was not read.
    pub fn obc_mesh_note(mesh: *const obc_mesh, index: usize) -> *const c_char;
    /// The defaults, which the members' comments give.
    pub fn obc_mesh_write_options_init(options: *mut obc_mesh_write_options, struct_size: usize) -> i32;
    /// Writes to \`path\`, the format by its ending: triangles to OBJ, OFF, PLY and STL, cells too to MEDIT and VTK. What is read
    /// again is the same mesh to the bit, but for STL, which has float32. The file appears once it is whole; after an error the
    /// old one is still there. options and host may be NULL. Errors: invalid argument, unsupported (the ending, or cells that the
    /// format cannot hold), io, out of memory, cancelled. O(n).
    pub fn obc_mesh_write(path: *const c_char, mesh: *const obc_mesh, options: *const obc_mesh_write_options, host: *const obc_host, error: *mut obc_error) -> i32;
    /// The same for a surface in the caller's arrays.
    pub fn obc_mesh_write_surface(path: *const c_char, surface: *const obc_surface, options: *const obc_mesh_write_options, host: *const obc_host, error: *mut obc_error) -> i32;
    /// An empty report that knows its size.
    pub fn obc_mesh_topology_report_init(report: *mut obc_mesh_topology_report, struct_size: usize) -> i32;
    /// Examines any set of triangles. host may be NULL. Errors: invalid argument, out of memory, cancelled. O(n log n) time, O(n)
    /// for bounded valence (0.1 s for a million triangles), up to 100 bytes a triangle.
    pub fn obc_mesh_topology(surface: *const obc_surface, host: *const obc_host, report: *mut obc_mesh_topology_report, error: *mut obc_error) -> i32;
    /// Whether the surface is what sphere maps need: closed, connected, manifold, consistently oriented, of genus 0. OBC\_OK, or not
    /// closed, not manifold, wrong genus or degenerate with the kind and the first place in \`error\`; invalid argument, out of
    /// memory, cancelled. Costs what obc\_mesh\_topology costs.
    pub fn obc_mesh_check_closed_genus_zero(surface: *const obc_surface, host: *const obc_host, error: *mut obc_error) -> i32;
    /// An empty report that knows its size.
    pub fn obc_mesh_orient_report_init(report: *mut obc_mesh_orient_report, struct_size: usize) -> i32;
    /// Turns triangles in place so that neighbours agree, the fewer of each part, and then all of them when the surface is closed
    /// and its volume negative. report may be NULL. Errors: invalid argument, not manifold (non-orientable; nothing is changed
    /// then), out of memory, cancelled. O(n).
    pub fn obc_mesh_orient(positions: *const f64, vertex_count: usize, triangles: *mut u32, triangle_count: usize, host: *const obc_host, report: *mut obc_mesh_orient_report, error: *mut obc_error) -> i32;
    /// For each vertex the lowest vertex at its very position (-0 is 0), vertex\_count entries. Errors: invalid argument, out of
    /// memory, cancelled. O(n).
    pub fn obc_mesh_first_at_same_position(positions: *const f64, vertex_count: usize, host: *const obc_host, first: *mut u32, error: *mut obc_error) -> i32;
    /// Pairs of triangles that have more in common than the vertices they share by number, decided by exact predicates: the first
    /// \`capacity\` pairs in ascending order, two entries each, the lower triangle first; \*count is how many were written. Triangles
    /// without area are left out. Works on the host's threads. Errors: invalid argument, out of memory, cancelled. O(n log n +
    /// pairs whose boxes overlap).
    pub fn obc_mesh_intersections(surface: *const obc_surface, host: *const obc_host, pairs: *mut u32, capacity: usize, count: *mut usize, error: *mut obc_error) -> i32;
    /// Copies the surface. host may be NULL; its allocator must stay valid until \_destroy. Errors: invalid argument (also: a coordinate
    /// beyond 1e150, here and in points), out of memory, cancelled. O(n log n), about 200 bytes a triangle.
    pub fn obc_mesh_search_create(surface: *const obc_surface, host: *const obc_host, out: *mut *mut obc_mesh_search, error: *mut obc_error) -> i32;
    /// Releases a search; NULL is fine.
    pub fn obc_mesh_search_destroy(search: *mut obc_mesh_search);
    /// For each of \`count\` points (3 \* count doubles) the nearest vertex, the lowest of equals. Errors: invalid argument (also: a
    /// point that is not finite, no vertices). O(log n) a point on average.
    pub fn obc_mesh_search_vertices(search: *const obc_mesh_search, points: *const f64, count: usize, vertices: *mut u32, error: *mut obc_error) -> i32;
    /// For each of \`count\` points the nearest point of the surface: its triangle (the lowest of equals), its weights at the
    /// triangle's corners (3 \* count, none negative, sum 1), its position (3 \* count) and its distance; each array may be NULL.
    /// Errors: invalid argument (also: a point that is not finite, no triangles). O(log n) a point on average.
    pub fn obc_mesh_search_surface(search: *const obc_mesh_search, points: *const f64, count: usize, triangles: *mut u32, weights: *mut f64, positions: *mut f64, distances: *mut f64, error: *mut obc_error) -> i32;
    /// Sign of (b - a) x (c - a): 1 when the triangle a, b, c of the plane is counter-clockwise.
    pub fn obc_mesh_orientation_2d(a: *const f64, b: *const f64, c: *const f64) -> i32;
    /// Sign of det\[b - a, c - a, d - a\]: 1 when the tetrahedron a, b, c, d has positive volume.
    pub fn obc_mesh_orientation_3d(a: *const f64, b: *const f64, c: *const f64, d: *const f64) -> i32;
    /// Sign of det\[p, q, r\]: 1 when p, q, r are counter-clockwise seen from outside a sphere around the origin.
    pub fn obc_mesh_orientation_from_origin(p: *const f64, q: *const f64, r: *const f64) -> i32;
    /// Version of this library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_mesh_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_surface>(), align_of::<obc_surface>()), (32, 8));
        let it = MaybeUninit::<obc_surface>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).positions) } as usize - start as usize, 0, "obc_surface.positions");
        assert_eq!(unsafe { addr_of!((*start).vertex_count) } as usize - start as usize, 8, "obc_surface.vertex_count");
        assert_eq!(unsafe { addr_of!((*start).triangles) } as usize - start as usize, 16, "obc_surface.triangles");
        assert_eq!(unsafe { addr_of!((*start).triangle_count) } as usize - start as usize, 24, "obc_surface.triangle_count");
        assert_eq!((size_of::<obc_mesh_cells>(), align_of::<obc_mesh_cells>()), (72, 8));
        let it = MaybeUninit::<obc_mesh_cells>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_mesh_cells.struct_size");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 4, "obc_mesh_cells.reserved");
        assert_eq!(unsafe { addr_of!((*start).positions) } as usize - start as usize, 8, "obc_mesh_cells.positions");
        assert_eq!(unsafe { addr_of!((*start).vertex_count) } as usize - start as usize, 16, "obc_mesh_cells.vertex_count");
        assert_eq!(unsafe { addr_of!((*start).triangles) } as usize - start as usize, 24, "obc_mesh_cells.triangles");
        assert_eq!(unsafe { addr_of!((*start).triangle_count) } as usize - start as usize, 32, "obc_mesh_cells.triangle_count");
        assert_eq!(unsafe { addr_of!((*start).tetrahedra) } as usize - start as usize, 40, "obc_mesh_cells.tetrahedra");
        assert_eq!(unsafe { addr_of!((*start).tetrahedron_count) } as usize - start as usize, 48, "obc_mesh_cells.tetrahedron_count");
        assert_eq!(unsafe { addr_of!((*start).hexahedra) } as usize - start as usize, 56, "obc_mesh_cells.hexahedra");
        assert_eq!(unsafe { addr_of!((*start).hexahedron_count) } as usize - start as usize, 64, "obc_mesh_cells.hexahedron_count");
        assert_eq!((size_of::<obc_mesh_tetrahedron_quality_report>(), align_of::<obc_mesh_tetrahedron_quality_report>()), (440, 8));
        let it = MaybeUninit::<obc_mesh_tetrahedron_quality_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_mesh_tetrahedron_quality_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).worst) } as usize - start as usize, 4, "obc_mesh_tetrahedron_quality_report.worst");
        assert_eq!(unsafe { addr_of!((*start).tetrahedra) } as usize - start as usize, 8, "obc_mesh_tetrahedron_quality_report.tetrahedra");
        assert_eq!(unsafe { addr_of!((*start).positive) } as usize - start as usize, 16, "obc_mesh_tetrahedron_quality_report.positive");
        assert_eq!(unsafe { addr_of!((*start).flat) } as usize - start as usize, 24, "obc_mesh_tetrahedron_quality_report.flat");
        assert_eq!(unsafe { addr_of!((*start).inverted) } as usize - start as usize, 32, "obc_mesh_tetrahedron_quality_report.inverted");
        assert_eq!(unsafe { addr_of!((*start).volume) } as usize - start as usize, 40, "obc_mesh_tetrahedron_quality_report.volume");
        assert_eq!(unsafe { addr_of!((*start).smallest_volume) } as usize - start as usize, 48, "obc_mesh_tetrahedron_quality_report.smallest_volume");
        assert_eq!(unsafe { addr_of!((*start).largest_volume) } as usize - start as usize, 56, "obc_mesh_tetrahedron_quality_report.largest_volume");
        assert_eq!(unsafe { addr_of!((*start).smallest_dihedral) } as usize - start as usize, 64, "obc_mesh_tetrahedron_quality_report.smallest_dihedral");
        assert_eq!(unsafe { addr_of!((*start).largest_dihedral) } as usize - start as usize, 72, "obc_mesh_tetrahedron_quality_report.largest_dihedral");
        assert_eq!(unsafe { addr_of!((*start).mean_smallest_dihedral) } as usize - start as usize, 80, "obc_mesh_tetrahedron_quality_report.mean_smallest_dihedral");
        assert_eq!(unsafe { addr_of!((*start).smallest_radius_ratio) } as usize - start as usize, 88, "obc_mesh_tetrahedron_quality_report.smallest_radius_ratio");
        assert_eq!(unsafe { addr_of!((*start).mean_radius_ratio) } as usize - start as usize, 96, "obc_mesh_tetrahedron_quality_report.mean_radius_ratio");
        assert_eq!(unsafe { addr_of!((*start).largest_radius_edge) } as usize - start as usize, 104, "obc_mesh_tetrahedron_quality_report.largest_radius_edge");
        assert_eq!(unsafe { addr_of!((*start).mean_radius_edge) } as usize - start as usize, 112, "obc_mesh_tetrahedron_quality_report.mean_radius_edge");
        assert_eq!(unsafe { addr_of!((*start).shortest_edge) } as usize - start as usize, 120, "obc_mesh_tetrahedron_quality_report.shortest_edge");
        assert_eq!(unsafe { addr_of!((*start).longest_edge) } as usize - start as usize, 128, "obc_mesh_tetrahedron_quality_report.longest_edge");
        assert_eq!(unsafe { addr_of!((*start).dihedral_histogram) } as usize - start as usize, 136, "obc_mesh_tetrahedron_quality_report.dihedral_histogram");
        assert_eq!(unsafe { addr_of!((*start).radius_ratio_histogram) } as usize - start as usize, 280, "obc_mesh_tetrahedron_quality_report.radius_ratio_histogram");
        assert_eq!((size_of::<obc_mesh_read_options>(), align_of::<obc_mesh_read_options>()), (8, 4));
        let it = MaybeUninit::<obc_mesh_read_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_mesh_read_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).weld_identical) } as usize - start as usize, 4, "obc_mesh_read_options.weld_identical");
        assert_eq!((size_of::<obc_mesh_write_options>(), align_of::<obc_mesh_write_options>()), (8, 4));
        let it = MaybeUninit::<obc_mesh_write_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_mesh_write_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).binary) } as usize - start as usize, 4, "obc_mesh_write_options.binary");
        assert_eq!((size_of::<obc_mesh_topology_report>(), align_of::<obc_mesh_topology_report>()), (272, 8));
        let it = MaybeUninit::<obc_mesh_topology_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_mesh_topology_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).closed) } as usize - start as usize, 4, "obc_mesh_topology_report.closed");
        assert_eq!(unsafe { addr_of!((*start).manifold) } as usize - start as usize, 8, "obc_mesh_topology_report.manifold");
        assert_eq!(unsafe { addr_of!((*start).orientable) } as usize - start as usize, 12, "obc_mesh_topology_report.orientable");
        assert_eq!(unsafe { addr_of!((*start).vertices) } as usize - start as usize, 16, "obc_mesh_topology_report.vertices");
        assert_eq!(unsafe { addr_of!((*start).unreferenced_vertices) } as usize - start as usize, 24, "obc_mesh_topology_report.unreferenced_vertices");
        assert_eq!(unsafe { addr_of!((*start).triangles) } as usize - start as usize, 32, "obc_mesh_topology_report.triangles");
        assert_eq!(unsafe { addr_of!((*start).edges) } as usize - start as usize, 40, "obc_mesh_topology_report.edges");
        assert_eq!(unsafe { addr_of!((*start).components) } as usize - start as usize, 48, "obc_mesh_topology_report.components");
        assert_eq!(unsafe { addr_of!((*start).boundary_edges) } as usize - start as usize, 56, "obc_mesh_topology_report.boundary_edges");
        assert_eq!(unsafe { addr_of!((*start).boundary_loops) } as usize - start as usize, 64, "obc_mesh_topology_report.boundary_loops");
        assert_eq!(unsafe { addr_of!((*start).longest_boundary_loop) } as usize - start as usize, 72, "obc_mesh_topology_report.longest_boundary_loop");
        assert_eq!(unsafe { addr_of!((*start).non_manifold_edges) } as usize - start as usize, 80, "obc_mesh_topology_report.non_manifold_edges");
        assert_eq!(unsafe { addr_of!((*start).non_manifold_vertices) } as usize - start as usize, 88, "obc_mesh_topology_report.non_manifold_vertices");
        assert_eq!(unsafe { addr_of!((*start).inconsistent_edges) } as usize - start as usize, 96, "obc_mesh_topology_report.inconsistent_edges");
        assert_eq!(unsafe { addr_of!((*start).degenerate_faces) } as usize - start as usize, 104, "obc_mesh_topology_report.degenerate_faces");
        assert_eq!(unsafe { addr_of!((*start).duplicate_faces) } as usize - start as usize, 112, "obc_mesh_topology_report.duplicate_faces");
        assert_eq!(unsafe { addr_of!((*start).zero_area_faces) } as usize - start as usize, 120, "obc_mesh_topology_report.zero_area_faces");
        assert_eq!(unsafe { addr_of!((*start).coincident_vertices) } as usize - start as usize, 128, "obc_mesh_topology_report.coincident_vertices");
        assert_eq!(unsafe { addr_of!((*start).euler_characteristic) } as usize - start as usize, 136, "obc_mesh_topology_report.euler_characteristic");
        assert_eq!(unsafe { addr_of!((*start).genus) } as usize - start as usize, 144, "obc_mesh_topology_report.genus");
        assert_eq!(unsafe { addr_of!((*start).low) } as usize - start as usize, 152, "obc_mesh_topology_report.low");
        assert_eq!(unsafe { addr_of!((*start).high) } as usize - start as usize, 176, "obc_mesh_topology_report.high");
        assert_eq!(unsafe { addr_of!((*start).area) } as usize - start as usize, 200, "obc_mesh_topology_report.area");
        assert_eq!(unsafe { addr_of!((*start).volume) } as usize - start as usize, 208, "obc_mesh_topology_report.volume");
        assert_eq!(unsafe { addr_of!((*start).first_boundary_edge) } as usize - start as usize, 216, "obc_mesh_topology_report.first_boundary_edge");
        assert_eq!(unsafe { addr_of!((*start).first_non_manifold_edge) } as usize - start as usize, 224, "obc_mesh_topology_report.first_non_manifold_edge");
        assert_eq!(unsafe { addr_of!((*start).first_inconsistent_edge) } as usize - start as usize, 232, "obc_mesh_topology_report.first_inconsistent_edge");
        assert_eq!(unsafe { addr_of!((*start).first_duplicate_faces) } as usize - start as usize, 240, "obc_mesh_topology_report.first_duplicate_faces");
        assert_eq!(unsafe { addr_of!((*start).first_coincident_vertices) } as usize - start as usize, 248, "obc_mesh_topology_report.first_coincident_vertices");
        assert_eq!(unsafe { addr_of!((*start).first_non_manifold_vertex) } as usize - start as usize, 256, "obc_mesh_topology_report.first_non_manifold_vertex");
        assert_eq!(unsafe { addr_of!((*start).first_vertex_apart) } as usize - start as usize, 260, "obc_mesh_topology_report.first_vertex_apart");
        assert_eq!(unsafe { addr_of!((*start).first_degenerate_face) } as usize - start as usize, 264, "obc_mesh_topology_report.first_degenerate_face");
        assert_eq!(unsafe { addr_of!((*start).first_zero_area_face) } as usize - start as usize, 268, "obc_mesh_topology_report.first_zero_area_face");
        assert_eq!((size_of::<obc_mesh_orient_report>(), align_of::<obc_mesh_orient_report>()), (16, 8));
        let it = MaybeUninit::<obc_mesh_orient_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_mesh_orient_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).turned_outward) } as usize - start as usize, 4, "obc_mesh_orient_report.turned_outward");
        assert_eq!(unsafe { addr_of!((*start).triangles_turned) } as usize - start as usize, 8, "obc_mesh_orient_report.triangles_turned");
    }
}
