"""What <orbicube/correspondence.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_CORRESPONDENCE_SPHERE: int
OBC_CORRESPONDENCE_POLYCUBE: int

OBC_CORRESPONDENCE_ALIGN_SHAPE: int
OBC_CORRESPONDENCE_ALIGN_ROTATION: int
OBC_CORRESPONDENCE_ALIGN_NONE: int

OBC_CORRESPONDENCE_GRID_BOTH: int
OBC_CORRESPONDENCE_GRID_FIRST: int
OBC_CORRESPONDENCE_GRID_ICOSPHERE: int
OBC_CORRESPONDENCE_GRID_CUBE: int
OBC_CORRESPONDENCE_GRID_LATITUDE: int
OBC_CORRESPONDENCE_GRID_OCTAHEDRON: int

OBC_CORRESPONDENCE_KEPT: int
OBC_CORRESPONDENCE_TURNED: int
OBC_CORRESPONDENCE_SCALED: int

class obc_correspondence_options(Struct):
    struct_size: int
    via: int
    align: int
    grid: int
    placement: int
    reserved: int
    tolerance: float
    cells: int
    corners: int
    seed: int
    resolution: int
    landmark_count: int
    landmarks: Any
    def __init__(self, struct_size: int = ..., via: int = ..., align: int = ..., grid: int = ..., placement: int = ..., reserved: int = ..., tolerance: float = ..., cells: int = ..., corners: int = ..., seed: int = ..., resolution: int = ..., landmark_count: int = ..., landmarks: Any = ...) -> None: ...

def obc_correspondence_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_correspondence_create(surfaces: Pointer, count: int, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Brings closed surfaces onto one triangulation, whose vertex i is at corresponding points of all. Triangles are oriented consistently
    and outward first. options and host may be NULL. *out is NULL after an error; the allocator of the host is used until the handle is
    destroyed. Errors: OBC_INVALID_ARGUMENT, OBC_NOT_CLOSED, OBC_NOT_MANIFOLD, OBC_WRONG_GENUS, OBC_DEGENERATE, OBC_MALFORMED_FILE (kind
    empty-mesh: no triangles), OBC_NO_VALID_RESULT, OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_correspondence_destroy(correspondence: Pointer) -> None:
    """Destroys a correspondence; NULL is allowed."""
    ...

def obc_correspondence_shape_count(correspondence: Pointer) -> int:
    """Return the number of surfaces, and of vertices and triangles of the triangulation; 0 for NULL."""
    ...

def obc_correspondence_vertex_count(correspondence: Pointer) -> int:
    """Return the number of surfaces, and of vertices and triangles of the triangulation; 0 for NULL."""
    ...

def obc_correspondence_triangle_count(correspondence: Pointer) -> int:
    """Return the number of surfaces, and of vertices and triangles of the triangulation; 0 for NULL."""
    ...

def obc_correspondence_copy(correspondence: Pointer, shape: int, positions: Pointer, triangles: Pointer, error: Pointer) -> int:
    """Copies the triangulation to arrays of the caller, each of which may be NULL: positions on surface number `shape` (3 * vertex count),
    and triangles (3 * triangle count). Errors: OBC_INVALID_ARGUMENT."""
    ...

def obc_correspondence_blend(correspondence: Pointer, weights: Pointer, count: int, positions: Pointer, error: Pointer) -> int:
    """Blends the surfaces: writes the sum of their positions times weights (`count` finite numbers, one a surface) to positions (3 * vertex
    count). A weight of 1 for one surface and 0 for all others returns its positions. Errors: OBC_INVALID_ARGUMENT, OBC_OUT_OF_MEMORY."""
    ...

def obc_correspondence_copy_domain(correspondence: Pointer, positions: Pointer, error: Pointer) -> int:
    """Copies the positions of the vertices on the common sphere (unit vectors) or polycube (3 * vertex count). Every triangle is positive
    there, by exact signs. Errors: OBC_INVALID_ARGUMENT."""
    ...

def obc_correspondence_quad_count(correspondence: Pointer) -> int:
    """Returns the number of quads of the polycube's grid, of which triangles 2 q and 2 q + 1 are the halves; 0 for other triangulations
    and for NULL."""
    ...

def obc_correspondence_copy_quads(correspondence: Pointer, quads: Pointer, error: Pointer) -> int:
    """Copies the quads (four vertex indices each, counter-clockwise seen from outside). Errors: OBC_INVALID_ARGUMENT."""
    ...

def obc_correspondence_surface_vertex_count(correspondence: Pointer, shape: int) -> int:
    """Returns the number of vertices of surface number `shape` as it was given; 0 if there is none."""
    ...

def obc_correspondence_map(correspondence: Pointer, from_: int, to: int, triangles: Pointer, weights: Pointer, count: int, host: Pointer, mapped_triangles: Pointer, mapped_weights: Pointer, error: Pointer) -> int:
    """Maps `count` points of surface `from` to surface `to`: the inverse of the map of `to` after the map of `from`, one to one. A point
    is a triangle of the surface as it was given and three weights at its corners, nonnegative with sum 1; results may overwrite the
    points. Options of placement do not matter. host may be NULL. Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_correspondence_map_vertices(correspondence: Pointer, from_: int, to: int, host: Pointer, mapped_triangles: Pointer, mapped_weights: Pointer, error: Pointer) -> int:
    """The same for all vertices of surface `from` (obc_correspondence_surface_vertex_count); a vertex in no triangle gets UINT32_MAX and
    weights of 0. Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_correspondence_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
