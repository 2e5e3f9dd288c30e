//! What `<orbicube/mesh.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use std::os::raw::{c_char, c_void};

/// of triangles, such as the patches of a CAD model
pub const OBC_MESH_TRIANGLE_REGIONS: i32 = 1;
/// of tetrahedra, such as materials
pub const OBC_MESH_TETRAHEDRON_REGIONS: i32 = 2;
/// of hexahedra
pub const OBC_MESH_HEXAHEDRON_REGIONS: i32 = 4;

/// text
pub const OBC_MESH_OBJ: i32 = 0;
/// text
pub const OBC_MESH_OFF: i32 = 1;
/// text and binary of either byte order, triangle strips
pub const OBC_MESH_PLY: i32 = 2;
/// text and binary
pub const OBC_MESH_STL: i32 = 3;
/// text
pub const OBC_MESH_MEDIT: i32 = 4;
/// legacy, text and binary
pub const OBC_MESH_VTK: i32 = 5;
/// Gmsh, versions 2.2 and 4.1, text and binary; written as text of version 2.2
pub const OBC_MESH_MSH: i32 = 6;
/// surfaces of FreeSurfer, binary (with float32) and text; also read and written as lh.pial and the like
pub const OBC_MESH_FREESURFER: i32 = 7;
/// Abaqus and CalculiX, linear elements; text
pub const OBC_MESH_INP: i32 = 8;
/// VTK XML, surfaces: text and binary, compressed in builds with zlib
pub const OBC_MESH_VTP: i32 = 9;
/// VTK XML, unstructured grids; the same
pub const OBC_MESH_VTU: i32 = 10;
/// GIFTI surfaces: text and binary (with float32), compressed in builds with zlib
pub const OBC_MESH_GIFTI: i32 = 11;

/// triangles; all formats do
pub const OBC_MESH_HOLDS_SURFACES: i32 = 1;
/// polygons of shared vertices, whose coordinates read back bit-identically
pub const OBC_MESH_HOLDS_POLYGONS: i32 = 2;
/// tetrahedra and hexahedra
pub const OBC_MESH_HOLDS_CELLS: i32 = 4;
/// binary contents; all formats may be text
pub const OBC_MESH_HOLDS_BINARY: i32 = 8;
/// region numbers of triangles, and of cells where it holds them
pub const OBC_MESH_HOLDS_REGIONS: i32 = 16;

/// A mesh in memory of the library.
#[repr(C)]
pub struct obc_mesh {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Trees of bounding boxes over the vertices and triangles of a surface.
#[repr(C)]
pub struct obc_mesh_search {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// A triangle surface: a view of arrays of the caller.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_surface {
    /// x y z a vertex
    pub positions: *const f64,
    /// number of vertices
    pub vertex_count: usize,
    /// three vertex indices each, counter-clockwise seen from outside
    pub triangles: *const u32,
    /// number of triangles
    pub triangle_count: usize,
}

/// Vertices and cells in arrays of the caller, for obc\_mesh\_create. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_mesh_cells {
    pub struct_size: u32,
    pub reserved: i32,
    /// x y z a vertex. Default: NULL.
    pub positions: *const f64,
    /// number of vertices. Default: 0.
    pub vertex_count: usize,
    /// three vertices each, or NULL. Default: NULL.
    pub triangles: *const u32,
    /// number of triangles. Default: 0.
    pub triangle_count: usize,
    /// four vertices each, or NULL. Default: NULL.
    pub tetrahedra: *const u32,
    /// number of tetrahedra. Default: 0.
    pub tetrahedron_count: usize,
    /// eight vertices each, or NULL. Default: NULL.
    pub hexahedra: *const u32,
    /// number of hexahedra. Default: 0.
    pub hexahedron_count: usize,
    /// region number of each triangle (0: none), or NULL. Default: NULL.
    pub triangle_regions: *const i32,
    /// region number of each tetrahedron, or NULL. Default: NULL.
    pub tetrahedron_regions: *const i32,
    /// region number of each hexahedron, or NULL. Default: NULL.
    pub hexahedron_regions: *const i32,
}

/// Quality of tetrahedra. Ratios are negative for inverted tetrahedra and 0 for flat ones; angles are in degrees.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_mesh_tetrahedron_quality_report {
    /// worst: first tetrahedron with the minimum radius ratio; 2^32 - 1: none
    pub struct_size: u32,
    /// worst: first tetrahedron with the minimum radius ratio; 2^32 - 1: none
    pub worst: u32,
    /// numbers of all tetrahedra and of those with each exact sign
    pub tetrahedra: u64,
    /// numbers of all tetrahedra and of those with each exact sign
    pub positive: u64,
    /// numbers of all tetrahedra and of those with each exact sign
    pub flat: u64,
    /// numbers of all tetrahedra and of those with each exact sign
    pub inverted: u64,
    /// total, minimum and maximum signed volume
    pub volume: f64,
    /// total, minimum and maximum signed volume
    pub min_volume: f64,
    /// total, minimum and maximum signed volume
    pub max_volume: f64,
    /// dihedral angles; the mean is that of each tetrahedron's minimum
    pub min_dihedral: f64,
    /// dihedral angles; the mean is that of each tetrahedron's minimum
    pub max_dihedral: f64,
    /// dihedral angles; the mean is that of each tetrahedron's minimum
    pub mean_min_dihedral: f64,
    /// 3 \* inradius / circumradius: 1 for a regular tetrahedron
    pub min_radius_ratio: f64,
    /// 3 \* inradius / circumradius: 1 for a regular tetrahedron
    pub mean_radius_ratio: f64,
    /// circumradius / shortest edge; infinite for flat tetrahedra, which the mean leaves out
    pub max_radius_edge: f64,
    /// circumradius / shortest edge; infinite for flat tetrahedra, which the mean leaves out
    pub mean_radius_edge: f64,
    /// edge lengths
    pub min_edge_length: f64,
    /// edge lengths
    pub max_edge_length: f64,
    /// six angles a tetrahedron in bins of 10 degrees; ratios in bins of 0.05
    pub dihedral_histogram: [u64; 18],
    /// six angles a tetrahedron in bins of 10 degrees; ratios in bins of 0.05
    pub radius_ratio_histogram: [u64; 20],
}

/// Options of readers. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_mesh_read_options {
    pub struct_size: u32,
    /// 1: welds vertices at identical positions if the surface is not closed as read; 0: does not. STL has no shared vertices and is
    /// always welded. Default: 0.
    pub weld_identical: i32,
}

/// Options of writers. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_mesh_write_options {
    pub struct_size: u32,
    /// 1: PLY, STL, VTK, VTP, VTU, FreeSurfer and GIFTI in binary; 0: as text. The other formats are text. Default: 1.
    pub binary: i32,
}

/// Topology of a surface. Defects have the indices of the first occurrence, 2^32 - 1 where there is none.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_mesh_topology_report {
    pub struct_size: u32,
    /// 1: there are triangles and no boundary; 0: otherwise
    pub closed: i32,
    /// 1: no non-manifold, duplicate or degenerate elements; 0: otherwise
    pub manifold: i32,
    /// 1: reversing triangles can make all edges consistent; 0: otherwise
    pub orientable: i32,
    /// number of vertices
    pub vertices: u64,
    /// number of vertices in no triangle, which the other figures leave out
    pub unreferenced_vertices: u64,
    /// number of triangles
    pub triangles: u64,
    /// number of edges
    pub edges: u64,
    /// number of components connected through vertices
    pub components: u64,
    /// number of edges with one triangle
    pub boundary_edges: u64,
    /// number of connected components of the boundary
    pub boundary_loops: u64,
    /// maximum number of edges of one of them
    pub longest_boundary_loop: u64,
    /// number of edges with three or more triangles
    pub non_manifold_edges: u64,
    /// number of vertices whose triangles form more than one fan
    pub non_manifold_vertices: u64,
    /// number of edges that both triangles traverse in the same direction
    pub inconsistent_edges: u64,
    /// number of triangles with a repeated vertex, which have no edges
    pub degenerate_faces: u64,
    /// number of triangles with the vertices of an earlier one, in any order
    pub duplicate_faces: u64,
    /// number of triangles whose three distinct vertices are exactly collinear
    pub zero_area_faces: u64,
    /// number of vertices at exactly the position of an earlier one
    pub coincident_vertices: u64,
    /// vertices - edges + triangles
    pub euler_characteristic: i64,
    /// genus of a closed, connected, orientable manifold; -1 for other surfaces
    pub genus: i64,
    /// bounding box of the triangles
    pub low: [f64; 3],
    /// bounding box of the triangles
    pub high: [f64; 3],
    /// volume is negative if inward-oriented. Out of range of double: infinite, or the smallest number of the sign
    pub area: f64,
    /// volume is negative if inward-oriented. Out of range of double: infinite, or the smallest number of the sign
    pub volume: f64,
    /// two vertices
    pub first_boundary_edge: [u32; 2],
    /// two vertices
    pub first_non_manifold_edge: [u32; 2],
    /// two vertices
    pub first_inconsistent_edge: [u32; 2],
    /// two triangles
    pub first_duplicate_faces: [u32; 2],
    /// two vertices
    pub first_coincident_vertices: [u32; 2],
    /// a vertex
    pub first_non_manifold_vertex: u32,
    /// a vertex that is not connected to the first one
    pub first_vertex_apart: u32,
    /// a triangle
    pub first_degenerate_face: u32,
    /// a triangle
    pub first_zero_area_face: u32,
}

/// Changes by obc\_mesh\_orient.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_mesh_orient_report {
    pub struct_size: u32,
    /// 1: the closed surface was inward-oriented, and all triangles were reversed; 0: otherwise
    pub inward_oriented: i32,
    /// number of triangles reversed before that to agree with their neighbors
    pub reversed_triangles: u64,
}

/// Distances from sample points of one surface (vertices and centroids) to the nearest point of the other, in both directions, in the
/// unit of the surfaces.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_mesh_distance {
    pub struct_size: u32,
    pub reserved: u32,
    /// from the first surface: mean, root mean square, maximum
    pub first_mean: f64,
    /// from the first surface: mean, root mean square, maximum
    pub first_root_mean_square: f64,
    /// from the first surface: mean, root mean square, maximum
    pub first_max: f64,
    /// from the second surface
    pub second_mean: f64,
    /// from the second surface
    pub second_root_mean_square: f64,
    /// from the second surface
    pub second_max: f64,
}

extern "C" {
    /// Fills cells with an empty mesh.
    pub fn obc_mesh_cells_init(cells: *mut obc_mesh_cells, struct_size: usize) -> i32;
    /// Creates a mesh with copies of the arrays. host may be NULL; its allocator must remain valid until \_destroy. O(n). Errors: invalid
    /// argument, out of memory.
    pub fn obc_mesh_create(cells: *const obc_mesh_cells, host: *const obc_host, out: *mut *mut obc_mesh, error: *mut obc_error) -> i32;
    /// Generates a closed surface by name ("creature", "torus", "cube", "sphere", "bracket", ...; obc\_mesh\_shape\_name lists the names) of about
    /// \`triangle\_count\` triangles, two units in size; the seed varies its shape. O(n). Errors: invalid argument, out of memory,
    /// cancelled.
    pub fn obc_mesh_make(shape: *const c_char, triangle_count: usize, seed: u64, host: *const obc_host, out: *mut *mut obc_mesh, error: *mut obc_error) -> i32;
    /// Returns the name of the index-th shape of obc\_mesh\_make, a static string; NULL from the number of shapes on.
    pub fn obc_mesh_shape_name(index: usize) -> *const c_char;
    /// Destroys a mesh; NULL is allowed.
    pub fn obc_mesh_destroy(mesh: *mut obc_mesh);
    /// Return the numbers of vertices and cells of a mesh; 0 for NULL.
    pub fn obc_mesh_vertex_count(mesh: *const obc_mesh) -> usize;
    /// Return the numbers of vertices and cells of a mesh; 0 for NULL.
    pub fn obc_mesh_triangle_count(mesh: *const obc_mesh) -> usize;
    /// Return the numbers of vertices and cells of a mesh; 0 for NULL.
    pub fn obc_mesh_tetrahedron_count(mesh: *const obc_mesh) -> usize;
    /// Return the numbers of vertices and cells of a mesh; 0 for NULL.
    pub fn obc_mesh_hexahedron_count(mesh: *const obc_mesh) -> usize;
    /// Copies a mesh to arrays of the caller, each of which may be NULL. Errors: invalid argument.
    pub fn obc_mesh_copy(mesh: *const obc_mesh, positions: *mut f64, triangles: *mut u32, tetrahedra: *mut u32, hexahedra: *mut u32, error: *mut obc_error) -> i32;
    /// Returns what has region numbers, bits OBC\_MESH\_...\_REGIONS; 0 for NULL.
    pub fn obc_mesh_region_kinds(mesh: *const obc_mesh) -> u32;
    /// Copies the region number of each triangle and cell, 0 where it has none, to arrays of the caller, each of which may be NULL. Errors:
    /// invalid argument.
    pub fn obc_mesh_copy_regions(mesh: *const obc_mesh, triangles: *mut i32, tetrahedra: *mut i32, hexahedra: *mut i32, error: *mut obc_error) -> i32;
    /// Returns a view of the positions and triangles of a mesh, valid until the mesh is destroyed. Errors: invalid argument.
    pub fn obc_mesh_surface(mesh: *const obc_mesh, surface: *mut obc_surface, error: *mut obc_error) -> i32;
    /// Checks that the tetrahedra and hexahedra form a solid: distinct, positive by exact predicates (hexahedra at each corner),
    /// conforming, no face with three cells, no edge at which parts touch. Returns OBC\_OK, also without cells, or degenerate or not
    /// manifold with the kind (inverted-cell, degenerate-cell, duplicate-cell, non-manifold-face, non-manifold-edge) and the
    /// first location. O(n log n). Errors: those, out of memory, cancelled.
    pub fn obc_mesh_check_cells(mesh: *const obc_mesh, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Computes the outward-oriented boundary surface of the solid, a new mesh with the same vertices: the faces of exactly one cell, those of
    /// hexahedra split in two. O(n log n). Errors: invalid argument, not manifold (a face with three cells), out of memory, cancelled.
    pub fn obc_mesh_boundary(mesh: *const obc_mesh, host: *const obc_host, out: *mut *mut obc_mesh, error: *mut obc_error) -> i32;
    /// Fills a report with zeros and its size.
    pub fn obc_mesh_tetrahedron_quality_report_init(report: *mut obc_mesh_tetrahedron_quality_report, struct_size: usize) -> i32;
    /// Measures the tetrahedra of a mesh, valid or not. O(n). Errors: invalid argument, cancelled.
    pub fn obc_mesh_tetrahedron_quality(mesh: *const obc_mesh, host: *const obc_host, report: *mut obc_mesh_tetrahedron_quality_report, error: *mut obc_error) -> i32;
    /// Return the ending of files of the format OBC\_MESH\_... in lower case, with its dot; the name of the format, such as "PLY"; and what its files
    /// can hold, bits OBC\_MESH\_HOLDS\_.... The texts are static. Formats are numbered from 0; NULL and 0 from the number of formats on.
    pub fn obc_mesh_format_ending(format: i32) -> *const c_char;
    /// Return the ending of files of the format OBC\_MESH\_... in lower case, with its dot; the name of the format, such as "PLY"; and what its files
    /// can hold, bits OBC\_MESH\_HOLDS\_.... The texts are static. Formats are numbered from 0; NULL and 0 from the number of formats on.
    pub fn obc_mesh_format_name(format: i32) -> *const c_char;
    /// Return the ending of files of the format OBC\_MESH\_... in lower case, with its dot; the name of the format, such as "PLY"; and what its files
    /// can hold, bits OBC\_MESH\_HOLDS\_.... The texts are static. Formats are numbered from 0; NULL and 0 from the number of formats on.
    pub fn obc_mesh_format_contents(format: i32) -> u32;
    /// Fills options with the defaults.
    pub fn obc_mesh_read_options_init(options: *mut obc_mesh_read_options, struct_size: usize) -> i32;
    /// Reads the file at \`path\` (bytes in the encoding of the system) in the format of its ending, in upper or lower case.
    /// Vertices keep their order unless they are welded; polygons are split into triangles; cells are checked as by
    /// obc\_mesh\_check\_cells. options and host may be NULL; the allocator of the host must remain valid until \_destroy. All contents are
    /// checked; memory is bounded by a multiple of the file size. O(size). Errors: io; malformed file (the kind says how:
    /// truncated, parse, index-range, non-finite, ...; the message where); the kinds of cells; unsupported; out of memory; cancelled.
    pub fn obc_mesh_read(path: *const c_char, options: *const obc_mesh_read_options, host: *const obc_host, out: *mut *mut obc_mesh, error: *mut obc_error) -> i32;
    /// Reads a file of the format OBC\_MESH\_... from \`size\` bytes in memory, which are not kept; otherwise as obc\_mesh\_read.
    pub fn obc_mesh_read_memory(bytes: *const c_void, size: usize, format: i32, options: *const obc_mesh_read_options, host: *const obc_host, out: *mut *mut obc_mesh, error: *mut obc_error) -> i32;
    /// Return facts about the file that a mesh was read from: its format, such as "PLY, binary, big-endian"; the number of polygons with more than
    /// three corners; the number of welded vertices; and the index-th note on changed or omitted contents, one line each, NULL from
    /// the number of notes on. Texts are UTF-8 and valid until the mesh is destroyed. Empty and 0 for a mesh that was not read.
    pub fn obc_mesh_format(mesh: *const obc_mesh) -> *const c_char;
    /// Return facts about the file that a mesh was read from: its format, such as "PLY, binary, big-endian"; the number of polygons with more than
    /// three corners; the number of welded vertices; and the index-th note on changed or omitted contents, one line each, NULL from
    /// the number of notes on. Texts are UTF-8 and valid until the mesh is destroyed. Empty and 0 for a mesh that was not read.
    pub fn obc_mesh_polygon_count(mesh: *const obc_mesh) -> usize;
    /// Return facts about the file that a mesh was read from: its format, such as "PLY, binary, big-endian"; the number of polygons with more than
    /// three corners; the number of welded vertices; and the index-th note on changed or omitted contents, one line each, NULL from
    /// the number of notes on. Texts are UTF-8 and valid until the mesh is destroyed. Empty and 0 for a mesh that was not read.
    pub fn obc_mesh_welded_vertex_count(mesh: *const obc_mesh) -> usize;
    /// Return facts about the file that a mesh was read from: its format, such as "PLY, binary, big-endian"; the number of polygons with more than
    /// three corners; the number of welded vertices; and the index-th note on changed or omitted contents, one line each, NULL from
    /// the number of notes on. Texts are UTF-8 and valid until the mesh is destroyed. Empty and 0 for a mesh that was not read.
    pub fn obc_mesh_note(mesh: *const obc_mesh, index: usize) -> *const c_char;
    /// Fills options with the defaults.
    pub fn obc_mesh_write_options_init(options: *mut obc_mesh_write_options, struct_size: usize) -> i32;
    /// Writes to \`path\` in the format of its ending: triangles, and cells and region numbers in formats that hold them. Reading the file returns a
    /// bit-identical mesh, except for STL, FreeSurfer and GIFTI, which have float32. The file appears when it is complete; after an error the
    /// previous file remains. options and host may be NULL. O(n). Errors: invalid argument, unsupported (the ending, or cells that the
    /// format does not have), io, out of memory, cancelled.
    pub fn obc_mesh_write(path: *const c_char, mesh: *const obc_mesh, options: *const obc_mesh_write_options, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Writes a surface in arrays of the caller; otherwise as obc\_mesh\_write.
    pub fn obc_mesh_write_surface(path: *const c_char, surface: *const obc_surface, options: *const obc_mesh_write_options, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Fills a report with zeros and its size.
    pub fn obc_mesh_topology_report_init(report: *mut obc_mesh_topology_report, struct_size: usize) -> i32;
    /// Analyzes any set of triangles. host may be NULL. O(n log n) time, O(n) for bounded valence (0.1 s for a million triangles), up to
    /// 100 bytes a triangle. Errors: invalid argument, out of memory, cancelled.
    pub fn obc_mesh_topology(surface: *const obc_surface, host: *const obc_host, report: *mut obc_mesh_topology_report, error: *mut obc_error) -> i32;
    /// Checks the requirements of sphere maps: closed, connected, manifold, consistently oriented, genus 0. Returns OBC\_OK, or not
    /// closed, not manifold, wrong genus or degenerate with the kind and the first location in \`error\`. Costs as much as
    /// obc\_mesh\_topology. Errors: those, invalid argument, out of memory, cancelled.
    pub fn obc_mesh_check_closed_genus_zero(surface: *const obc_surface, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Fills a report with zeros and its size.
    pub fn obc_mesh_orient_report_init(report: *mut obc_mesh_orient_report, struct_size: usize) -> i32;
    /// Reverses triangles in place until neighbors are consistently oriented, the minority of each component, and then all of them if the
    /// surface is closed with negative volume. report may be NULL. O(n). Errors: invalid argument, not manifold (non-orientable;
    /// nothing is changed), out of memory, cancelled.
    pub fn obc_mesh_orient(positions: *const f64, vertex_count: usize, triangles: *mut u32, triangle_count: usize, host: *const obc_host, report: *mut obc_mesh_orient_report, error: *mut obc_error) -> i32;
    /// Computes for each vertex the lowest vertex at exactly its position (-0 equals 0), vertex\_count entries. O(n). Errors: invalid argument,
    /// out of memory, cancelled.
    pub fn obc_mesh_first_at_same_position(positions: *const f64, vertex_count: usize, host: *const obc_host, first: *mut u32, error: *mut obc_error) -> i32;
    /// Finds pairs of triangles that intersect in more than their shared vertices, by exact predicates: the first \`capacity\` pairs in
    /// ascending order, two entries each, the lower triangle first. \*count receives the number of pairs written. Triangles of zero area
    /// are left out. Uses the threads of the host. O(n log n + pairs of overlapping boxes). Errors: invalid argument, out of memory,
    /// cancelled.
    pub fn obc_mesh_intersections(surface: *const obc_surface, host: *const obc_host, pairs: *mut u32, capacity: usize, count: *mut usize, error: *mut obc_error) -> i32;
    /// Computes unit vertex normals, 3 \* vertex\_count doubles: triangle normals weighted by angles (Thuermer and Wuethrich 1998); 0 0 1 where
    /// they cancel and for vertices of no triangle. O(n). Errors: invalid argument, out of memory, cancelled.
    pub fn obc_mesh_vertex_normals(surface: *const obc_surface, host: *const obc_host, normals: *mut f64, error: *mut obc_error) -> i32;
    /// Computes a third of the area of the adjacent triangles for each vertex: areas, vertex\_count doubles, in the square of the surface's unit.
    /// They sum up to the area. O(n). Errors: invalid argument (also: an area beyond the range of double), out of memory,
    /// cancelled.
    pub fn obc_mesh_vertex_areas(surface: *const obc_surface, host: *const obc_host, areas: *mut f64, error: *mut obc_error) -> i32;
    /// Fills a result with zeros and its size.
    pub fn obc_mesh_distance_init(distance: *mut obc_mesh_distance, struct_size: usize) -> i32;
    /// Measures the distances between two surfaces (as Metro: Cignoni, Rocchini and Scopigno 1998). Uses the threads of the host.
    /// O(n log n). Errors: invalid argument (also: no triangles), out of memory, cancelled.
    pub fn obc_mesh_surface_distance(first: *const obc_surface, second: *const obc_surface, host: *const obc_host, distance: *mut obc_mesh_distance, error: *mut obc_error) -> i32;
    /// Computes the distance of two point sets (3 \* a\_count and 3 \* b\_count doubles), e(A, B) = max(d(A, B), d(B, A)), d(A, B) the mean over the
    /// points of A of the distance to the nearest point of B: the reconstruction error of the dissertation's section 3.3.2. Uses the
    /// threads of the host. O(n log n). Errors: invalid argument (also: no points, a coordinate beyond 1e150), out of memory,
    /// cancelled.
    pub fn obc_mesh_mean_distance(a: *const f64, a_count: usize, b: *const f64, b_count: usize, host: *const obc_host, distance: *mut f64, error: *mut obc_error) -> i32;
    /// Creates a search structure from a copy of the surface. host may be NULL; its allocator must remain valid until \_destroy.
    /// O(n log n), about 200 bytes a triangle. Errors: invalid argument (also: a coordinate beyond 1e150, here and in points),
    /// out of memory, cancelled.
    pub fn obc_mesh_search_create(surface: *const obc_surface, host: *const obc_host, out: *mut *mut obc_mesh_search, error: *mut obc_error) -> i32;
    /// Destroys a search structure; NULL is allowed.
    pub fn obc_mesh_search_destroy(search: *mut obc_mesh_search);
    /// Finds the nearest vertex of each of \`count\` points (3 \* count doubles), the lowest of equally near ones. O(log n) a point on
    /// average. Errors: invalid argument (also: a point that is not finite, no vertices).
    pub fn obc_mesh_search_vertices(search: *const obc_mesh_search, points: *const f64, count: usize, vertices: *mut u32, error: *mut obc_error) -> i32;
    /// Finds the nearest point of the surface to each of \`count\` points: its triangle (the lowest of equally near ones), its barycentric
    /// coordinates (3 \* count, nonnegative, sum 1), its position (3 \* count) and its distance; each array may be NULL. O(log n) a
    /// point on average. Errors: invalid argument (also: a point that is not finite, no triangles).
    pub fn obc_mesh_search_surface(search: *const obc_mesh_search, points: *const f64, count: usize, triangles: *mut u32, weights: *mut f64, positions: *mut f64, distances: *mut f64, error: *mut obc_error) -> i32;
    /// Returns the sign of (b - a) x (c - a): 1 if the triangle a, b, c in the plane is counter-clockwise.
    pub fn obc_mesh_orientation_2d(a: *const f64, b: *const f64, c: *const f64) -> i32;
    /// Returns the sign of det\[b - a, c - a, d - a\]: 1 if the tetrahedron a, b, c, d has positive volume.
    pub fn obc_mesh_orientation_3d(a: *const f64, b: *const f64, c: *const f64, d: *const f64) -> i32;
    /// Returns the sign of det\[p, q, r\]: 1 if p, q, r are counter-clockwise seen from outside a sphere around the origin.
    pub fn obc_mesh_orientation_from_origin(p: *const f64, q: *const f64, r: *const f64) -> i32;
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
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
        assert_eq!((size_of::<obc_mesh_cells>(), align_of::<obc_mesh_cells>()), (96, 8));
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
        assert_eq!(unsafe { addr_of!((*start).triangle_regions) } as usize - start as usize, 72, "obc_mesh_cells.triangle_regions");
        assert_eq!(unsafe { addr_of!((*start).tetrahedron_regions) } as usize - start as usize, 80, "obc_mesh_cells.tetrahedron_regions");
        assert_eq!(unsafe { addr_of!((*start).hexahedron_regions) } as usize - start as usize, 88, "obc_mesh_cells.hexahedron_regions");
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
        assert_eq!(unsafe { addr_of!((*start).min_volume) } as usize - start as usize, 48, "obc_mesh_tetrahedron_quality_report.min_volume");
        assert_eq!(unsafe { addr_of!((*start).max_volume) } as usize - start as usize, 56, "obc_mesh_tetrahedron_quality_report.max_volume");
        assert_eq!(unsafe { addr_of!((*start).min_dihedral) } as usize - start as usize, 64, "obc_mesh_tetrahedron_quality_report.min_dihedral");
        assert_eq!(unsafe { addr_of!((*start).max_dihedral) } as usize - start as usize, 72, "obc_mesh_tetrahedron_quality_report.max_dihedral");
        assert_eq!(unsafe { addr_of!((*start).mean_min_dihedral) } as usize - start as usize, 80, "obc_mesh_tetrahedron_quality_report.mean_min_dihedral");
        assert_eq!(unsafe { addr_of!((*start).min_radius_ratio) } as usize - start as usize, 88, "obc_mesh_tetrahedron_quality_report.min_radius_ratio");
        assert_eq!(unsafe { addr_of!((*start).mean_radius_ratio) } as usize - start as usize, 96, "obc_mesh_tetrahedron_quality_report.mean_radius_ratio");
        assert_eq!(unsafe { addr_of!((*start).max_radius_edge) } as usize - start as usize, 104, "obc_mesh_tetrahedron_quality_report.max_radius_edge");
        assert_eq!(unsafe { addr_of!((*start).mean_radius_edge) } as usize - start as usize, 112, "obc_mesh_tetrahedron_quality_report.mean_radius_edge");
        assert_eq!(unsafe { addr_of!((*start).min_edge_length) } as usize - start as usize, 120, "obc_mesh_tetrahedron_quality_report.min_edge_length");
        assert_eq!(unsafe { addr_of!((*start).max_edge_length) } as usize - start as usize, 128, "obc_mesh_tetrahedron_quality_report.max_edge_length");
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
        assert_eq!(unsafe { addr_of!((*start).inward_oriented) } as usize - start as usize, 4, "obc_mesh_orient_report.inward_oriented");
        assert_eq!(unsafe { addr_of!((*start).reversed_triangles) } as usize - start as usize, 8, "obc_mesh_orient_report.reversed_triangles");
        assert_eq!((size_of::<obc_mesh_distance>(), align_of::<obc_mesh_distance>()), (56, 8));
        let it = MaybeUninit::<obc_mesh_distance>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_mesh_distance.struct_size");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 4, "obc_mesh_distance.reserved");
        assert_eq!(unsafe { addr_of!((*start).first_mean) } as usize - start as usize, 8, "obc_mesh_distance.first_mean");
        assert_eq!(unsafe { addr_of!((*start).first_root_mean_square) } as usize - start as usize, 16, "obc_mesh_distance.first_root_mean_square");
        assert_eq!(unsafe { addr_of!((*start).first_max) } as usize - start as usize, 24, "obc_mesh_distance.first_max");
        assert_eq!(unsafe { addr_of!((*start).second_mean) } as usize - start as usize, 32, "obc_mesh_distance.second_mean");
        assert_eq!(unsafe { addr_of!((*start).second_root_mean_square) } as usize - start as usize, 40, "obc_mesh_distance.second_root_mean_square");
        assert_eq!(unsafe { addr_of!((*start).second_max) } as usize - start as usize, 48, "obc_mesh_distance.second_max");
    }
}
