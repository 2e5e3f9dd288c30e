"""What <orbicube/mesh.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_MESH_OBJ: int
OBC_MESH_OFF: int
OBC_MESH_PLY: int
OBC_MESH_STL: int
OBC_MESH_MEDIT: int
OBC_MESH_VTK: int

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
    def __init__(self, struct_size: int = ..., reserved: int = ..., positions: Any = ..., vertex_count: int = ..., triangles: Any = ..., triangle_count: int = ..., tetrahedra: Any = ..., tetrahedron_count: int = ..., hexahedra: Any = ..., hexahedron_count: int = ...) -> None: ...

class obc_mesh_tetrahedron_quality_report(Struct):
    struct_size: int
    worst: int
    tetrahedra: int
    positive: int
    flat: int
    inverted: int
    volume: float
    smallest_volume: float
    largest_volume: float
    smallest_dihedral: float
    largest_dihedral: float
    mean_smallest_dihedral: float
    smallest_radius_ratio: float
    mean_radius_ratio: float
    largest_radius_edge: float
    mean_radius_edge: float
    shortest_edge: float
    longest_edge: float
    dihedral_histogram: Any
    radius_ratio_histogram: Any
    def __init__(self, struct_size: int = ..., worst: int = ..., tetrahedra: int = ..., positive: int = ..., flat: int = ..., inverted: int = ..., volume: float = ..., smallest_volume: float = ..., largest_volume: float = ..., smallest_dihedral: float = ..., largest_dihedral: float = ..., mean_smallest_dihedral: float = ..., smallest_radius_ratio: float = ..., mean_radius_ratio: float = ..., largest_radius_edge: float = ..., mean_radius_edge: float = ..., shortest_edge: float = ..., longest_edge: float = ..., dihedral_histogram: Any = ..., radius_ratio_histogram: Any = ...) -> None: ...

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
    turned_outward: int
    triangles_turned: int
    def __init__(self, struct_size: int = ..., turned_outward: int = ..., triangles_turned: int = ...) -> None: ...

def obc_mesh_cells_init(cells: Pointer, struct_size: int) -> int:
    """A mesh of nothing."""
    ...

def obc_mesh_create(cells: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """A mesh with copies of the arrays. host may be NULL; its allocator must stay valid until _destroy. Errors: invalid argument,
    out of memory. O(n)."""
    ...

def obc_mesh_make(shape: bytes | None, triangle_count: int, seed: int, host: Pointer, out: Pointer, error: Pointer) -> int:
    """A closed surface by name ("creature", "torus", "cube", "sphere", "bracket", ...; obc_mesh_shape_name lists them) of about
    `triangle_count` triangles, two units in size; the seed varies it. Errors: invalid argument, out of memory, cancelled. O(n)."""
    ...

def obc_mesh_shape_name(index: int) -> bytes | None:
    """Name of the index-th shape that obc_mesh_make knows, a static string; NULL beyond the last one."""
    ...

def obc_mesh_destroy(mesh: Pointer) -> None:
    """Releases a mesh; NULL is fine."""
    ...

def obc_mesh_vertex_count(mesh: Pointer) -> int:
    """Numbers of a mesh; 0 for NULL."""
    ...

def obc_mesh_triangle_count(mesh: Pointer) -> int:
    """Numbers of a mesh; 0 for NULL."""
    ...

def obc_mesh_tetrahedron_count(mesh: Pointer) -> int:
    """Numbers of a mesh; 0 for NULL."""
    ...

def obc_mesh_hexahedron_count(mesh: Pointer) -> int:
    """Numbers of a mesh; 0 for NULL."""
    ...

def obc_mesh_copy(mesh: Pointer, positions: Pointer, triangles: Pointer, tetrahedra: Pointer, hexahedra: Pointer, error: Pointer) -> int:
    """Copies to the caller's arrays, each of which may be NULL. Errors: invalid argument."""
    ...

def obc_mesh_surface(mesh: Pointer, surface: Pointer, error: Pointer) -> int:
    """A view of the mesh's own positions and triangles, valid until the mesh is destroyed. Errors: invalid argument."""
    ...

def obc_mesh_check_cells(mesh: Pointer, host: Pointer, error: Pointer) -> int:
    """Whether the tetrahedra and hexahedra fill a solid: distinct, positive by exact predicates (hexahedra at each corner), meeting
    in whole faces, no face of three cells, no edge where parts only touch. OBC_OK, also without cells; or degenerate or not
    manifold with the kind (inverted-cell, degenerate-cell, duplicate-cell, non-manifold-face, non-manifold-edge) and the
    first place; out of memory, cancelled. O(n log n)."""
    ...

def obc_mesh_boundary(mesh: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """The surface of the solid that the cells fill, looking outward, as a mesh of its own with the same vertices: the faces of one
    cell only, those of hexahedra cut in two. Errors: invalid argument, not manifold (a face of three cells), out of memory,
    cancelled. O(n log n)."""
    ...

def obc_mesh_tetrahedron_quality_report_init(report: Pointer, struct_size: int) -> int:
    """An empty report that knows its size."""
    ...

def obc_mesh_tetrahedron_quality(mesh: Pointer, host: Pointer, report: Pointer, error: Pointer) -> int:
    """Measures the tetrahedra of a mesh, whatever they are. Errors: invalid argument, cancelled. O(n)."""
    ...

def obc_mesh_read_options_init(options: Pointer, struct_size: int) -> int:
    """The defaults, which the members' comments give."""
    ...

def obc_mesh_read(path: bytes | None, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Reads the file at `path` (bytes as the system takes them), its format by its ending: .obj .off .ply .stl .mesh .vtk.
    Vertices keep their order unless they are joined; faces of more corners are cut into triangles; cells are checked as by
    obc_mesh_check_cells. options and host may be NULL; the host's allocator must stay valid until _destroy. Nothing in a file
    is trusted; memory is bounded by a multiple of its size. Errors: io, malformed file (the kind says how: truncated, parse,
    index-range, non-finite, ...; the message where), the kinds of cells, unsupported, out of memory, cancelled. O(size)."""
    ...

def obc_mesh_read_memory(bytes: Pointer, size: int, format: int, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """The same from `size` bytes of a file of the format OBC_MESH_...; they are not kept."""
    ...

def obc_mesh_format(mesh: Pointer) -> bytes | None:
    """What was found in reading: the format, as "PLY, binary, big-endian"; polygons of more than three corners; vertices that were
    joined to others; and notes on what was changed or left out, one line each, the index-th one, NULL when there is none.
    Texts are UTF-8 and the mesh's. Empty and 0 for a mesh that was not read."""
    ...

def obc_mesh_polygon_count(mesh: Pointer) -> int:
    """What was found in reading: the format, as "PLY, binary, big-endian"; polygons of more than three corners; vertices that were
    joined to others; and notes on what was changed or left out, one line each, the index-th one, NULL when there is none.
    Texts are UTF-8 and the mesh's. Empty and 0 for a mesh that was not read."""
    ...

def obc_mesh_welded_vertex_count(mesh: Pointer) -> int:
    """What was found in reading: the format, as "PLY, binary, big-endian"; polygons of more than three corners; vertices that were
    joined to others; and notes on what was changed or left out, one line each, the index-th one, NULL when there is none.
    Texts are UTF-8 and the mesh's. Empty and 0 for a mesh that was not read."""
    ...

def obc_mesh_note(mesh: Pointer, index: int) -> bytes | None:
    """What was found in reading: the format, as "PLY, binary, big-endian"; polygons of more than three corners; vertices that were
    joined to others; and notes on what was changed or left out, one line each, the index-th one, NULL when there is none.
    Texts are UTF-8 and the mesh's. Empty and 0 for a mesh that was not read."""
    ...

def obc_mesh_write_options_init(options: Pointer, struct_size: int) -> int:
    """The defaults, which the members' comments give."""
    ...

def obc_mesh_write(path: bytes | None, mesh: Pointer, options: Pointer, host: Pointer, error: Pointer) -> int:
    """Writes to `path`, the format by its ending: triangles to OBJ, OFF, PLY and STL, cells too to MEDIT and VTK. What is read
    again is the same mesh to the bit, but for STL, which has float32. The file appears once it is whole; after an error the
    old one is still there. options and host may be NULL. Errors: invalid argument, unsupported (the ending, or cells that the
    format cannot hold), io, out of memory, cancelled. O(n)."""
    ...

def obc_mesh_write_surface(path: bytes | None, surface: Pointer, options: Pointer, host: Pointer, error: Pointer) -> int:
    """The same for a surface in the caller's arrays."""
    ...

def obc_mesh_topology_report_init(report: Pointer, struct_size: int) -> int:
    """An empty report that knows its size."""
    ...

def obc_mesh_topology(surface: Pointer, host: Pointer, report: Pointer, error: Pointer) -> int:
    """Examines any set of triangles. host may be NULL. Errors: invalid argument, out of memory, cancelled. O(n log n) time, O(n)
    for bounded valence (0.1 s for a million triangles), up to 100 bytes a triangle."""
    ...

def obc_mesh_check_closed_genus_zero(surface: Pointer, host: Pointer, error: Pointer) -> int:
    """Whether the surface is what sphere maps need: closed, connected, manifold, consistently oriented, of genus 0. OBC_OK, or not
    closed, not manifold, wrong genus or degenerate with the kind and the first place in `error`; invalid argument, out of
    memory, cancelled. Costs what obc_mesh_topology costs."""
    ...

def obc_mesh_orient_report_init(report: Pointer, struct_size: int) -> int:
    """An empty report that knows its size."""
    ...

def obc_mesh_orient(positions: Pointer, vertex_count: int, triangles: Pointer, triangle_count: int, host: Pointer, report: Pointer, error: Pointer) -> int:
    """Turns triangles in place so that neighbours agree, the fewer of each part, and then all of them when the surface is closed
    and its volume negative. report may be NULL. Errors: invalid argument, not manifold (non-orientable; nothing is changed
    then), out of memory, cancelled. O(n)."""
    ...

def obc_mesh_first_at_same_position(positions: Pointer, vertex_count: int, host: Pointer, first: Pointer, error: Pointer) -> int:
    """For each vertex the lowest vertex at its very position (-0 is 0), vertex_count entries. Errors: invalid argument, out of
    memory, cancelled. O(n)."""
    ...

def obc_mesh_intersections(surface: Pointer, host: Pointer, pairs: Pointer, capacity: int, count: Pointer, error: Pointer) -> int:
    """Pairs of triangles that have more in common than the vertices they share by number, decided by exact predicates: the first
    `capacity` pairs in ascending order, two entries each, the lower triangle first; *count is how many were written. Triangles
    without area are left out. Works on the host's threads. Errors: invalid argument, out of memory, cancelled. O(n log n +
    pairs whose boxes overlap)."""
    ...

def obc_mesh_search_create(surface: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Copies the surface. host may be NULL; its allocator must stay valid until _destroy. Errors: invalid argument (also: a coordinate
    beyond 1e150, here and in points), out of memory, cancelled. O(n log n), about 200 bytes a triangle."""
    ...

def obc_mesh_search_destroy(search: Pointer) -> None:
    """Releases a search; NULL is fine."""
    ...

def obc_mesh_search_vertices(search: Pointer, points: Pointer, count: int, vertices: Pointer, error: Pointer) -> int:
    """For each of `count` points (3 * count doubles) the nearest vertex, the lowest of equals. Errors: invalid argument (also: a
    point that is not finite, no vertices). O(log n) a point on average."""
    ...

def obc_mesh_search_surface(search: Pointer, points: Pointer, count: int, triangles: Pointer, weights: Pointer, positions: Pointer, distances: Pointer, error: Pointer) -> int:
    """For each of `count` points the nearest point of the surface: its triangle (the lowest of equals), its weights at the
    triangle's corners (3 * count, none negative, sum 1), its position (3 * count) and its distance; each array may be NULL.
    Errors: invalid argument (also: a point that is not finite, no triangles). O(log n) a point on average."""
    ...

def obc_mesh_orientation_2d(a: Pointer, b: Pointer, c: Pointer) -> int:
    """Sign of (b - a) x (c - a): 1 when the triangle a, b, c of the plane is counter-clockwise."""
    ...

def obc_mesh_orientation_3d(a: Pointer, b: Pointer, c: Pointer, d: Pointer) -> int:
    """Sign of det[b - a, c - a, d - a]: 1 when the tetrahedron a, b, c, d has positive volume."""
    ...

def obc_mesh_orientation_from_origin(p: Pointer, q: Pointer, r: Pointer) -> int:
    """Sign of det[p, q, r]: 1 when p, q, r are counter-clockwise seen from outside a sphere around the origin."""
    ...

def obc_mesh_version() -> int:
    """Version of this library, major * 10000 + minor * 100 + patch."""
    ...
