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
    """Fills options with the defaults."""
    ...

def obc_tetrahedra_fill(surface: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Fills a closed surface with tetrahedra. Its components may lie beside or within each other: points inside an odd number of them are
    solid, so that a component within a component bounds a cavity. The orientation of triangles has no effect. Vertices in no triangle remain
    without tetrahedra. Coordinates of any size and distance from the origin are allowed. options and host may be NULL; the
    allocator of the host must remain valid until _destroy. Takes about 10 us and 1 KB a tetrahedron; the checks are O(n log n).
    Errors, found by exact arithmetic before TetGen runs: invalid argument; not closed; not manifold (kinds non-manifold-edge,
    non-manifold-vertex, duplicate-face, non-orientable, and self-intersection with the number of pairs and the first);
    degenerate (kinds degenerate-face, degenerate-geometry); malformed file (kind empty-mesh: no triangles). Others: no valid
    result (TetGen failed, with its reason, or its mesh failed the checks), unsupported, out of memory, cancelled."""
    ...

def obc_tetrahedra_fill_mesh(surface: Pointer, max_volume: float, host: Pointer, out: Pointer, error: Pointer, user: Pointer) -> int:
    """Fills a closed surface as obc_tetrahedra_fill does with the options max_volume and else the defaults, into a mesh of <orbicube/mesh.h>: the
    function for options.fill of <orbicube/hexmesh.h>. user is unused and may be NULL; host may be NULL, its allocator must remain valid until
    obc_mesh_destroy. Errors: as obc_tetrahedra_fill."""
    ...

def obc_tetrahedra_destroy(solid: Pointer) -> None:
    """Destroys a mesh; NULL is allowed."""
    ...

def obc_tetrahedra_vertex_count(solid: Pointer) -> int:
    """Return the numbers of vertices (those of the surface, then inserted ones), tetrahedra, boundary triangles (those of the surface if
    it was preserved), parts (components that share no face) and cavities; 0 for NULL."""
    ...

def obc_tetrahedra_count(solid: Pointer) -> int:
    """Return the numbers of vertices (those of the surface, then inserted ones), tetrahedra, boundary triangles (those of the surface if
    it was preserved), parts (components that share no face) and cavities; 0 for NULL."""
    ...

def obc_tetrahedra_boundary_count(solid: Pointer) -> int:
    """Return the numbers of vertices (those of the surface, then inserted ones), tetrahedra, boundary triangles (those of the surface if
    it was preserved), parts (components that share no face) and cavities; 0 for NULL."""
    ...

def obc_tetrahedra_part_count(solid: Pointer) -> int:
    """Return the numbers of vertices (those of the surface, then inserted ones), tetrahedra, boundary triangles (those of the surface if
    it was preserved), parts (components that share no face) and cavities; 0 for NULL."""
    ...

def obc_tetrahedra_cavity_count(solid: Pointer) -> int:
    """Return the numbers of vertices (those of the surface, then inserted ones), tetrahedra, boundary triangles (those of the surface if
    it was preserved), parts (components that share no face) and cavities; 0 for NULL."""
    ...

def obc_tetrahedra_copy(solid: Pointer, positions: Pointer, tetrahedra: Pointer, boundary: Pointer, boundary_source: Pointer, error: Pointer) -> int:
    """Copies a mesh to arrays of the caller, each of which may be NULL: positions (x y z a vertex, bit-identical vertices of the surface
    first, in their order), tetrahedra (four vertices each, of positive volume by exact arithmetic), boundary (three vertices a
    triangle, outward-oriented; triangle i is triangle i of the surface, possibly reversed, if it was preserved) and
    boundary_source (for each boundary triangle the surface triangle that contains it). Errors: invalid argument."""
    ...

def obc_tetrahedra_check_surface(surface: Pointer, host: Pointer, pairs: Pointer, capacity: int, count: Pointer, error: Pointer) -> int:
    """Checks whether a surface can be filled, as obc_tetrahedra_fill does first. Writes the first `capacity` pairs of intersecting triangles to
    pairs, two entries each, the lower triangle first, in ascending order; *count is the number of all pairs, possibly more than
    capacity. pairs may be NULL for capacity 0, host may be NULL. Uses the threads of the host. O(n log n + pairs of overlapping
    boxes). Returns OBC_OK or the errors of obc_tetrahedra_fill about the surface; pairs and count are also valid for the kind
    self-intersection, and count is 0 for all others."""
    ...

def obc_tetrahedra_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
