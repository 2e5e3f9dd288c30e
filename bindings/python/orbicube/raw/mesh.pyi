"""What <orbicube/mesh.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_MESH_TRIANGLE_REGIONS: int
OBC_MESH_TETRAHEDRON_REGIONS: int
OBC_MESH_HEXAHEDRON_REGIONS: int

OBC_MESH_OBJ: int
OBC_MESH_OFF: int
OBC_MESH_PLY: int
OBC_MESH_STL: int
OBC_MESH_MEDIT: int
OBC_MESH_VTK: int
OBC_MESH_MSH: int
OBC_MESH_FREESURFER: int
OBC_MESH_INP: int
OBC_MESH_VTP: int
OBC_MESH_VTU: int
OBC_MESH_GIFTI: int

OBC_MESH_HOLDS_SURFACES: int
OBC_MESH_HOLDS_POLYGONS: int
OBC_MESH_HOLDS_CELLS: int
OBC_MESH_HOLDS_BINARY: int
OBC_MESH_HOLDS_REGIONS: int

class obc_surface(Struct):
    positions: Any
    vertex_count: int
    triangles: Any
    triangle_count: int
    def __init__(self, positions: Any = ..., vertex_count: int = ..., triangles: Any = ..., triangle_count: int = ...) -> None: ...

class obc_mesh_cells(Struct):
    struct_size: int
    reserved: int
    positions: Any
    vertex_count: int
    triangles: Any
    triangle_count: int
    tetrahedra: Any
    tetrahedron_count: int
    hexahedra: Any
    hexahedron_count: int
    triangle_regions: Any
    tetrahedron_regions: Any
    hexahedron_regions: Any
    def __init__(self, struct_size: int = ..., reserved: int = ..., positions: Any = ..., vertex_count: int = ..., triangles: Any = ..., triangle_count: int = ..., tetrahedra: Any = ..., tetrahedron_count: int = ..., hexahedra: Any = ..., hexahedron_count: int = ..., triangle_regions: Any = ..., tetrahedron_regions: Any = ..., hexahedron_regions: Any = ...) -> None: ...

class obc_mesh_tetrahedron_quality_report(Struct):
    struct_size: int
    worst: int
    tetrahedra: int
    positive: int
    flat: int
    inverted: int
    volume: float
    min_volume: float
    max_volume: float
    min_dihedral: float
    max_dihedral: float
    mean_min_dihedral: float
    min_radius_ratio: float
    mean_radius_ratio: float
    max_radius_edge: float
    mean_radius_edge: float
    min_edge_length: float
    max_edge_length: float
    dihedral_histogram: Any
    radius_ratio_histogram: Any
    def __init__(self, struct_size: int = ..., worst: int = ..., tetrahedra: int = ..., positive: int = ..., flat: int = ..., inverted: int = ..., volume: float = ..., min_volume: float = ..., max_volume: float = ..., min_dihedral: float = ..., max_dihedral: float = ..., mean_min_dihedral: float = ..., min_radius_ratio: float = ..., mean_radius_ratio: float = ..., max_radius_edge: float = ..., mean_radius_edge: float = ..., min_edge_length: float = ..., max_edge_length: float = ..., dihedral_histogram: Any = ..., radius_ratio_histogram: Any = ...) -> None: ...

class obc_mesh_read_options(Struct):
    struct_size: int
    weld_identical: int
    def __init__(self, struct_size: int = ..., weld_identical: int = ...) -> None: ...

class obc_mesh_write_options(Struct):
    struct_size: int
    binary: int
    def __init__(self, struct_size: int = ..., binary: int = ...) -> None: ...

class obc_mesh_topology_report(Struct):
    struct_size: int
    closed: int
    manifold: int
    orientable: int
    vertices: int
    unreferenced_vertices: int
    triangles: int
    edges: int
    components: int
    boundary_edges: int
    boundary_loops: int
    longest_boundary_loop: int
    non_manifold_edges: int
    non_manifold_vertices: int
    inconsistent_edges: int
    degenerate_faces: int
    duplicate_faces: int
    zero_area_faces: int
    coincident_vertices: int
    euler_characteristic: int
    genus: int
    low: Any
    high: Any
    area: float
    volume: float
    first_boundary_edge: Any
    first_non_manifold_edge: Any
    first_inconsistent_edge: Any
    first_duplicate_faces: Any
    first_coincident_vertices: Any
    first_non_manifold_vertex: int
    first_vertex_apart: int
    first_degenerate_face: int
    first_zero_area_face: int
    def __init__(self, struct_size: int = ..., closed: int = ..., manifold: int = ..., orientable: int = ..., vertices: int = ..., unreferenced_vertices: int = ..., triangles: int = ..., edges: int = ..., components: int = ..., boundary_edges: int = ..., boundary_loops: int = ..., longest_boundary_loop: int = ..., non_manifold_edges: int = ..., non_manifold_vertices: int = ..., inconsistent_edges: int = ..., degenerate_faces: int = ..., duplicate_faces: int = ..., zero_area_faces: int = ..., coincident_vertices: int = ..., euler_characteristic: int = ..., genus: int = ..., low: Any = ..., high: Any = ..., area: float = ..., volume: float = ..., first_boundary_edge: Any = ..., first_non_manifold_edge: Any = ..., first_inconsistent_edge: Any = ..., first_duplicate_faces: Any = ..., first_coincident_vertices: Any = ..., first_non_manifold_vertex: int = ..., first_vertex_apart: int = ..., first_degenerate_face: int = ..., first_zero_area_face: int = ...) -> None: ...

class obc_mesh_orient_report(Struct):
    struct_size: int
    inward_oriented: int
    reversed_triangles: int
    def __init__(self, struct_size: int = ..., inward_oriented: int = ..., reversed_triangles: int = ...) -> None: ...

class obc_mesh_distance(Struct):
    struct_size: int
    reserved: int
    first_mean: float
    first_root_mean_square: float
    first_max: float
    second_mean: float
    second_root_mean_square: float
    second_max: float
    def __init__(self, struct_size: int = ..., reserved: int = ..., first_mean: float = ..., first_root_mean_square: float = ..., first_max: float = ..., second_mean: float = ..., second_root_mean_square: float = ..., second_max: float = ...) -> None: ...

def obc_mesh_cells_init(cells: Pointer, struct_size: int) -> int:
    """Fills cells with an empty mesh."""
    ...

def obc_mesh_create(cells: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Creates a mesh with copies of the arrays. host may be NULL; its allocator must remain valid until _destroy. O(n). Errors: invalid
    argument, out of memory."""
    ...

def obc_mesh_make(shape: bytes | None, triangle_count: int, seed: int, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Generates a closed surface by name ("creature", "torus", "cube", "sphere", "bracket", ...; obc_mesh_shape_name lists the names) of about
    `triangle_count` triangles, two units in size; the seed varies its shape. O(n). Errors: invalid argument, out of memory,
    cancelled."""
    ...

def obc_mesh_shape_name(index: int) -> bytes | None:
    """Returns the name of the index-th shape of obc_mesh_make, a static string; NULL from the number of shapes on."""
    ...

def obc_mesh_destroy(mesh: Pointer) -> None:
    """Destroys a mesh; NULL is allowed."""
    ...

def obc_mesh_vertex_count(mesh: Pointer) -> int:
    """Return the numbers of vertices and cells of a mesh; 0 for NULL."""
    ...

def obc_mesh_triangle_count(mesh: Pointer) -> int:
    """Return the numbers of vertices and cells of a mesh; 0 for NULL."""
    ...

def obc_mesh_tetrahedron_count(mesh: Pointer) -> int:
    """Return the numbers of vertices and cells of a mesh; 0 for NULL."""
    ...

def obc_mesh_hexahedron_count(mesh: Pointer) -> int:
    """Return the numbers of vertices and cells of a mesh; 0 for NULL."""
    ...

def obc_mesh_copy(mesh: Pointer, positions: Pointer, triangles: Pointer, tetrahedra: Pointer, hexahedra: Pointer, error: Pointer) -> int:
    """Copies a mesh to arrays of the caller, each of which may be NULL. Errors: invalid argument."""
    ...

def obc_mesh_region_kinds(mesh: Pointer) -> int:
    """Returns what has region numbers, bits OBC_MESH_..._REGIONS; 0 for NULL."""
    ...

def obc_mesh_copy_regions(mesh: Pointer, triangles: Pointer, tetrahedra: Pointer, hexahedra: Pointer, error: Pointer) -> int:
    """Copies the region number of each triangle and cell, 0 where it has none, to arrays of the caller, each of which may be NULL. Errors:
    invalid argument."""
    ...

def obc_mesh_surface(mesh: Pointer, surface: Pointer, error: Pointer) -> int:
    """Returns a view of the positions and triangles of a mesh, valid until the mesh is destroyed. Errors: invalid argument."""
    ...

def obc_mesh_check_cells(mesh: Pointer, host: Pointer, error: Pointer) -> int:
    """Checks that the tetrahedra and hexahedra form a solid: distinct, positive by exact predicates (hexahedra at each corner),
    conforming, no face with three cells, no edge at which parts touch. Returns OBC_OK, also without cells, or degenerate or not
    manifold with the kind (inverted-cell, degenerate-cell, duplicate-cell, non-manifold-face, non-manifold-edge) and the
    first location. O(n log n). Errors: those, out of memory, cancelled."""
    ...

def obc_mesh_boundary(mesh: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Computes the outward-oriented boundary surface of the solid, a new mesh with the same vertices: the faces of exactly one cell, those of
    hexahedra split in two. O(n log n). Errors: invalid argument, not manifold (a face with three cells), out of memory, cancelled."""
    ...

def obc_mesh_tetrahedron_quality_report_init(report: Pointer, struct_size: int) -> int:
    """Fills a report with zeros and its size."""
    ...

def obc_mesh_tetrahedron_quality(mesh: Pointer, host: Pointer, report: Pointer, error: Pointer) -> int:
    """Measures the tetrahedra of a mesh, valid or not. O(n). Errors: invalid argument, cancelled."""
    ...

def obc_mesh_format_ending(format: int) -> bytes | None:
    """Return the ending of files of the format OBC_MESH_... in lower case, with its dot; the name of the format, such as "PLY"; and what its files
    can hold, bits OBC_MESH_HOLDS_.... The texts are static. Formats are numbered from 0; NULL and 0 from the number of formats on."""
    ...

def obc_mesh_format_name(format: int) -> bytes | None:
    """Return the ending of files of the format OBC_MESH_... in lower case, with its dot; the name of the format, such as "PLY"; and what its files
    can hold, bits OBC_MESH_HOLDS_.... The texts are static. Formats are numbered from 0; NULL and 0 from the number of formats on."""
    ...

def obc_mesh_format_contents(format: int) -> int:
    """Return the ending of files of the format OBC_MESH_... in lower case, with its dot; the name of the format, such as "PLY"; and what its files
    can hold, bits OBC_MESH_HOLDS_.... The texts are static. Formats are numbered from 0; NULL and 0 from the number of formats on."""
    ...

def obc_mesh_read_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_mesh_read(path: bytes | None, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Reads the file at `path` (bytes in the encoding of the system) in the format of its ending, in upper or lower case.
    Vertices keep their order unless they are welded; polygons are split into triangles; cells are checked as by
    obc_mesh_check_cells. options and host may be NULL; the allocator of the host must remain valid until _destroy. All contents are
    checked; memory is bounded by a multiple of the file size. O(size). Errors: io; malformed file (the kind says how:
    truncated, parse, index-range, non-finite, ...; the message where); the kinds of cells; unsupported; out of memory; cancelled."""
    ...

def obc_mesh_read_memory(bytes: Pointer, size: int, format: int, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Reads a file of the format OBC_MESH_... from `size` bytes in memory, which are not kept; otherwise as obc_mesh_read."""
    ...

def obc_mesh_format(mesh: Pointer) -> bytes | None:
    """Return facts about the file that a mesh was read from: its format, such as "PLY, binary, big-endian"; the number of polygons with more than
    three corners; the number of welded vertices; and the index-th note on changed or omitted contents, one line each, NULL from
    the number of notes on. Texts are UTF-8 and valid until the mesh is destroyed. Empty and 0 for a mesh that was not read."""
    ...

def obc_mesh_polygon_count(mesh: Pointer) -> int:
    """Return facts about the file that a mesh was read from: its format, such as "PLY, binary, big-endian"; the number of polygons with more than
    three corners; the number of welded vertices; and the index-th note on changed or omitted contents, one line each, NULL from
    the number of notes on. Texts are UTF-8 and valid until the mesh is destroyed. Empty and 0 for a mesh that was not read."""
    ...

def obc_mesh_welded_vertex_count(mesh: Pointer) -> int:
    """Return facts about the file that a mesh was read from: its format, such as "PLY, binary, big-endian"; the number of polygons with more than
    three corners; the number of welded vertices; and the index-th note on changed or omitted contents, one line each, NULL from
    the number of notes on. Texts are UTF-8 and valid until the mesh is destroyed. Empty and 0 for a mesh that was not read."""
    ...

def obc_mesh_note(mesh: Pointer, index: int) -> bytes | None:
    """Return facts about the file that a mesh was read from: its format, such as "PLY, binary, big-endian"; the number of polygons with more than
    three corners; the number of welded vertices; and the index-th note on changed or omitted contents, one line each, NULL from
    the number of notes on. Texts are UTF-8 and valid until the mesh is destroyed. Empty and 0 for a mesh that was not read."""
    ...

def obc_mesh_write_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_mesh_write(path: bytes | None, mesh: Pointer, options: Pointer, host: Pointer, error: Pointer) -> int:
    """Writes to `path` in the format of its ending: triangles, and cells and region numbers in formats that hold them. Reading the file returns a
    bit-identical mesh, except for STL, FreeSurfer and GIFTI, which have float32. The file appears when it is complete; after an error the
    previous file remains. options and host may be NULL. O(n). Errors: invalid argument, unsupported (the ending, or cells that the
    format does not have), io, out of memory, cancelled."""
    ...

def obc_mesh_write_surface(path: bytes | None, surface: Pointer, options: Pointer, host: Pointer, error: Pointer) -> int:
    """Writes a surface in arrays of the caller; otherwise as obc_mesh_write."""
    ...

def obc_mesh_topology_report_init(report: Pointer, struct_size: int) -> int:
    """Fills a report with zeros and its size."""
    ...

def obc_mesh_topology(surface: Pointer, host: Pointer, report: Pointer, error: Pointer) -> int:
    """Analyzes any set of triangles. host may be NULL. O(n log n) time, O(n) for bounded valence (0.1 s for a million triangles), up to
    100 bytes a triangle. Errors: invalid argument, out of memory, cancelled."""
    ...

def obc_mesh_check_closed_genus_zero(surface: Pointer, host: Pointer, error: Pointer) -> int:
    """Checks the requirements of sphere maps: closed, connected, manifold, consistently oriented, genus 0. Returns OBC_OK, or not
    closed, not manifold, wrong genus or degenerate with the kind and the first location in `error`. Costs as much as
    obc_mesh_topology. Errors: those, invalid argument, out of memory, cancelled."""
    ...

def obc_mesh_orient_report_init(report: Pointer, struct_size: int) -> int:
    """Fills a report with zeros and its size."""
    ...

def obc_mesh_orient(positions: Pointer, vertex_count: int, triangles: Pointer, triangle_count: int, host: Pointer, report: Pointer, error: Pointer) -> int:
    """Reverses triangles in place until neighbors are consistently oriented, the minority of each component, and then all of them if the
    surface is closed with negative volume. report may be NULL. O(n). Errors: invalid argument, not manifold (non-orientable;
    nothing is changed), out of memory, cancelled."""
    ...

def obc_mesh_first_at_same_position(positions: Pointer, vertex_count: int, host: Pointer, first: Pointer, error: Pointer) -> int:
    """Computes for each vertex the lowest vertex at exactly its position (-0 equals 0), vertex_count entries. O(n). Errors: invalid argument,
    out of memory, cancelled."""
    ...

def obc_mesh_intersections(surface: Pointer, host: Pointer, pairs: Pointer, capacity: int, count: Pointer, error: Pointer) -> int:
    """Finds pairs of triangles that intersect in more than their shared vertices, by exact predicates: the first `capacity` pairs in
    ascending order, two entries each, the lower triangle first. *count receives the number of pairs written. Triangles of zero area
    are left out. Uses the threads of the host. O(n log n + pairs of overlapping boxes). Errors: invalid argument, out of memory,
    cancelled."""
    ...

def obc_mesh_vertex_normals(surface: Pointer, host: Pointer, normals: Pointer, error: Pointer) -> int:
    """Computes unit vertex normals, 3 * vertex_count doubles: triangle normals weighted by angles (Thuermer and Wuethrich 1998); 0 0 1 where
    they cancel and for vertices of no triangle. O(n). Errors: invalid argument, out of memory, cancelled."""
    ...

def obc_mesh_vertex_areas(surface: Pointer, host: Pointer, areas: Pointer, error: Pointer) -> int:
    """Computes a third of the area of the adjacent triangles for each vertex: areas, vertex_count doubles, in the square of the surface's unit.
    They sum up to the area. O(n). Errors: invalid argument (also: an area beyond the range of double), out of memory,
    cancelled."""
    ...

def obc_mesh_distance_init(distance: Pointer, struct_size: int) -> int:
    """Fills a result with zeros and its size."""
    ...

def obc_mesh_surface_distance(first: Pointer, second: Pointer, host: Pointer, distance: Pointer, error: Pointer) -> int:
    """Measures the distances between two surfaces (as Metro: Cignoni, Rocchini and Scopigno 1998). Uses the threads of the host.
    O(n log n). Errors: invalid argument (also: no triangles), out of memory, cancelled."""
    ...

def obc_mesh_mean_distance(a: Pointer, a_count: int, b: Pointer, b_count: int, host: Pointer, distance: Pointer, error: Pointer) -> int:
    """Computes the distance of two point sets (3 * a_count and 3 * b_count doubles), e(A, B) = max(d(A, B), d(B, A)), d(A, B) the mean over the
    points of A of the distance to the nearest point of B: the reconstruction error of the dissertation's section 3.3.2. Uses the
    threads of the host. O(n log n). Errors: invalid argument (also: no points, a coordinate beyond 1e150), out of memory,
    cancelled."""
    ...

def obc_mesh_search_create(surface: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Creates a search structure from a copy of the surface. host may be NULL; its allocator must remain valid until _destroy.
    O(n log n), about 200 bytes a triangle. Errors: invalid argument (also: a coordinate beyond 1e150, here and in points),
    out of memory, cancelled."""
    ...

def obc_mesh_search_destroy(search: Pointer) -> None:
    """Destroys a search structure; NULL is allowed."""
    ...

def obc_mesh_search_vertices(search: Pointer, points: Pointer, count: int, vertices: Pointer, error: Pointer) -> int:
    """Finds the nearest vertex of each of `count` points (3 * count doubles), the lowest of equally near ones. O(log n) a point on
    average. Errors: invalid argument (also: a point that is not finite, no vertices)."""
    ...

def obc_mesh_search_surface(search: Pointer, points: Pointer, count: int, triangles: Pointer, weights: Pointer, positions: Pointer, distances: Pointer, error: Pointer) -> int:
    """Finds the nearest point of the surface to each of `count` points: its triangle (the lowest of equally near ones), its barycentric
    coordinates (3 * count, nonnegative, sum 1), its position (3 * count) and its distance; each array may be NULL. O(log n) a
    point on average. Errors: invalid argument (also: a point that is not finite, no triangles)."""
    ...

def obc_mesh_orientation_2d(a: Pointer, b: Pointer, c: Pointer) -> int:
    """Returns the sign of (b - a) x (c - a): 1 if the triangle a, b, c in the plane is counter-clockwise."""
    ...

def obc_mesh_orientation_3d(a: Pointer, b: Pointer, c: Pointer, d: Pointer) -> int:
    """Returns the sign of det[b - a, c - a, d - a]: 1 if the tetrahedron a, b, c, d has positive volume."""
    ...

def obc_mesh_orientation_from_origin(p: Pointer, q: Pointer, r: Pointer) -> int:
    """Returns the sign of det[p, q, r]: 1 if p, q, r are counter-clockwise seen from outside a sphere around the origin."""
    ...

def obc_mesh_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
