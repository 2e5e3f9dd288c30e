"""What <orbicube/tetrahedra.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

class obc_tetrahedra_options(Struct):
    struct_size: int
    keep_surface: int
    quality: float
    max_volume: float
    edge_length: float
    size_positions: Any
    size_lengths: Any
    size_count: int
    size_growth: float
    def __init__(self, struct_size: int = ..., keep_surface: int = ..., quality: float = ..., max_volume: float = ..., edge_length: float = ..., size_positions: Any = ..., size_lengths: Any = ..., size_count: int = ..., size_growth: float = ...) -> None: ...

def obc_tetrahedra_options_init(options: Pointer, struct_size: int) -> int:
    """The defaults, which the members' comments give."""
    ...

def obc_tetrahedra_fill(surface: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Fills a surface. Its components may lie beside or within each other: what an odd number of them surrounds is solid, what an
    even number does is not, so a shell within a shell is a cavity. It does not matter which way triangles look. Vertices in no
    triangle stay, in no tetrahedron. Coordinates of any size and at any distance from the origin are fine.
    options and host may be NULL; the host's allocator must stay valid until _destroy.
    Time and memory are TetGen's, about 10 us and 1 KB a tetrahedron; the checks are O(n log n).
    Errors: invalid argument; not closed, not manifold (kinds non-manifold-edge, non-manifold-vertex, duplicate-face,
    non-orientable, and self-intersection with the number of pairs of faces and the first), degenerate (kinds degenerate-face,
    degenerate-geometry), malformed file (kind empty-mesh: no triangles), each found by exact arithmetic before TetGen runs; no
    valid result (TetGen failed, the message says how, or what it made did not stand the checks), unsupported, out of memory,
    cancelled."""
    ...

def obc_tetrahedra_destroy(solid: Pointer) -> None:
    """Releases a solid; NULL is fine."""
    ...

def obc_tetrahedra_vertex_count(solid: Pointer) -> int:
    """Numbers of a solid; 0 for NULL. Vertices: those of the surface, then those added. Boundary triangles: those of the surface
    when it was kept. Parts: of the solid, that share no face. Cavities: empty regions within."""
    ...

def obc_tetrahedra_count(solid: Pointer) -> int:
    """Numbers of a solid; 0 for NULL. Vertices: those of the surface, then those added. Boundary triangles: those of the surface
    when it was kept. Parts: of the solid, that share no face. Cavities: empty regions within."""
    ...

def obc_tetrahedra_boundary_count(solid: Pointer) -> int:
    """Numbers of a solid; 0 for NULL. Vertices: those of the surface, then those added. Boundary triangles: those of the surface
    when it was kept. Parts: of the solid, that share no face. Cavities: empty regions within."""
    ...

def obc_tetrahedra_part_count(solid: Pointer) -> int:
    """Numbers of a solid; 0 for NULL. Vertices: those of the surface, then those added. Boundary triangles: those of the surface
    when it was kept. Parts: of the solid, that share no face. Cavities: empty regions within."""
    ...

def obc_tetrahedra_cavity_count(solid: Pointer) -> int:
    """Numbers of a solid; 0 for NULL. Vertices: those of the surface, then those added. Boundary triangles: those of the surface
    when it was kept. Parts: of the solid, that share no face. Cavities: empty regions within."""
    ...

def obc_tetrahedra_copy(solid: Pointer, positions: Pointer, tetrahedra: Pointer, boundary: Pointer, boundary_source: Pointer, error: Pointer) -> int:
    """Copies to the caller's arrays, each of which may be NULL: positions (x y z a vertex; the surface's vertices come first, to
    the bit and in its order), tetrahedra (four vertices each, of positive volume by exact arithmetic), boundary (three
    vertices a triangle, looking outward; triangle i is the surface's triangle i, perhaps turned round, when it was kept) and
    boundary_source (for each boundary triangle the surface's triangle that it lies in). Errors: invalid argument."""
    ...

def obc_tetrahedra_check_surface(surface: Pointer, host: Pointer, pairs: Pointer, capacity: int, count: Pointer, error: Pointer) -> int:
    """Whether a surface can be filled, as obc_tetrahedra_fill asks it first. The first `capacity` pairs of triangles that meet where
    they should not are written to pairs, two entries each, the lower triangle first, in ascending order; *count is how many there
    are, which may be more. pairs may be NULL when capacity is 0. Runs on the host's threads; host may be NULL.
    OBC_OK, or the errors of obc_tetrahedra_fill about the surface; pairs and count are also valid with the kind
    self-intersection, and count is 0 with all others. O(n log n + pairs whose boxes overlap)."""
    ...

def obc_tetrahedra_version() -> int:
    """Version of this library, major * 10000 + minor * 100 + patch."""
    ...
