"""What <orbicube/volume_map.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

class obc_volume_map_untangle_problem(Struct):
    struct_size: int
    reserved: int
    positions: Any
    vertex_count: int
    tetrahedra: Any
    tetrahedron_count: int
    rest: Any
    fixed: Any
    ties: Any
    def __init__(self, struct_size: int = ..., reserved: int = ..., positions: Any = ..., vertex_count: int = ..., tetrahedra: Any = ..., tetrahedron_count: int = ..., rest: Any = ..., fixed: Any = ..., ties: Any = ...) -> None: ...

class obc_volume_map_untangle_options(Struct):
    struct_size: int
    steps: int
    polish_steps: int
    reserved: int
    volume_weight: float
    def __init__(self, struct_size: int = ..., steps: int = ..., polish_steps: int = ..., reserved: int = ..., volume_weight: float = ...) -> None: ...

class obc_volume_map_untangle_report(Struct):
    struct_size: int
    first_inverted: int
    inverted_before: int
    inverted: int
    steps: int
    polish_steps: int
    min_determinant: float
    max_determinant: float
    energy: float
    def __init__(self, struct_size: int = ..., first_inverted: int = ..., inverted_before: int = ..., inverted: int = ..., steps: int = ..., polish_steps: int = ..., min_determinant: float = ..., max_determinant: float = ..., energy: float = ...) -> None: ...

class obc_volume_map_solid_options(Struct):
    struct_size: int
    reserved: int
    corners: int
    seed: int
    def __init__(self, struct_size: int = ..., reserved: int = ..., corners: int = ..., seed: int = ...) -> None: ...

def obc_volume_map_untangle_problem_init(problem: Pointer, struct_size: int) -> int:
    """Fill a mesh with no vertices, options with the defaults, and a report with zeros."""
    ...

def obc_volume_map_untangle_options_init(options: Pointer, struct_size: int) -> int:
    """Fill a mesh with no vertices, options with the defaults, and a report with zeros."""
    ...

def obc_volume_map_untangle_report_init(report: Pointer, struct_size: int) -> int:
    """Fill a mesh with no vertices, options with the defaults, and a report with zeros."""
    ...

def obc_volume_map_untangle(problem: Pointer, options: Pointer, host: Pointer, result: Pointer, report: Pointer, error: Pointer) -> int:
    """Moves vertices until all tetrahedra are positive. result receives x y z a vertex and may be problem->positions; fixed coordinates are
    unchanged and tied ones have the same bits. A mesh without inverted tetrahedra is only polished. options, host and report may be
    NULL. Takes about 700 bytes a tetrahedron; a step is O(n) times up to 150 iterations of conjugate gradients.
    Errors: no valid result (some remain inverted: their number and the first; result and report then have the best mesh, for all other
    errors they are unchanged); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
    not manifold (kinds non-manifold-face and inconsistent-orientation: three tetrahedra at a face, or two on one side of it);
    malformed file (kind index-range); degenerate (kinds degenerate-cell and inverted-cell: a repeated vertex, a rest
    tetrahedron that is not positive; degenerate-geometry: zero volume); out of memory; cancelled."""
    ...

def obc_volume_map_solid_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_volume_map_solid_compute(positions: Pointer, vertex_count: int, tetrahedra: Pointer, tetrahedron_count: int, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Computes a polycube of the boundary of a solid and a map of the solid to it. Every tetrahedron is positive on the polycube and in
    space, and the boundary covers the polycube once. positions: x y z a vertex; tetrahedra: four vertices each, positive, conforming.
    Tetrahedra are split where the map requires it. The polycube of a cavity lies within that of the outer boundary; polycubes of
    several pieces stand side by side along x. options and host may be NULL; the allocator of the host must remain valid until
    _destroy. Takes minutes for a hundred thousand tetrahedra.
    Errors: invalid argument; malformed file (index-range); degenerate; not manifold; not closed; no valid result with the
    obstacle; out of memory; cancelled."""
    ...

def obc_volume_map_solid_destroy(solid: Pointer) -> None:
    """Destroys a map; NULL is allowed."""
    ...

def obc_volume_map_solid_vertex_count(solid: Pointer) -> int:
    """Return the number of vertices and of tetrahedra after splits; 0 for NULL."""
    ...

def obc_volume_map_solid_tetrahedron_count(solid: Pointer) -> int:
    """Return the number of vertices and of tetrahedra after splits; 0 for NULL."""
    ...

def obc_volume_map_solid_copy(solid: Pointer, positions: Pointer, polycube: Pointer, tetrahedra: Pointer, error: Pointer) -> int:
    """Copies positions in space and on the polycube (x y z a vertex) and tetrahedra (four vertices each); each may be NULL.
    Errors: invalid argument."""
    ...

def obc_volume_map_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
