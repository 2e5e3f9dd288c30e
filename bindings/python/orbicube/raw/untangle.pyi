"""What <orbicube/untangle.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

class obc_untangle_options(Struct):
    struct_size: int
    max_steps: int
    max_polish_steps: int
    free_boundary: int
    volume_weight: float
    tolerance: float
    def __init__(self, struct_size: int = ..., max_steps: int = ..., max_polish_steps: int = ..., free_boundary: int = ..., volume_weight: float = ..., tolerance: float = ...) -> None: ...

class obc_untangle_report(Struct):
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

class obc_untangle_tetrahedra_problem(Struct):
    struct_size: int
    reserved: int
    positions: Any
    vertex_count: int
    tetrahedra: Any
    tetrahedron_count: int
    rest: Any
    fixed: Any
    fixed_coordinates: Any
    ties: Any
    def __init__(self, struct_size: int = ..., reserved: int = ..., positions: Any = ..., vertex_count: int = ..., tetrahedra: Any = ..., tetrahedron_count: int = ..., rest: Any = ..., fixed: Any = ..., fixed_coordinates: Any = ..., ties: Any = ...) -> None: ...

class obc_untangle_triangles_problem(Struct):
    struct_size: int
    reserved: int
    positions: Any
    vertex_count: int
    triangles: Any
    triangle_count: int
    rest: Any
    fixed: Any
    fixed_coordinates: Any
    ties: Any
    def __init__(self, struct_size: int = ..., reserved: int = ..., positions: Any = ..., vertex_count: int = ..., triangles: Any = ..., triangle_count: int = ..., rest: Any = ..., fixed: Any = ..., fixed_coordinates: Any = ..., ties: Any = ...) -> None: ...

def obc_untangle_options_init(options: Pointer, struct_size: int) -> int:
    """Fill options with the defaults, and a report with zeros."""
    ...

def obc_untangle_report_init(report: Pointer, struct_size: int) -> int:
    """Fill options with the defaults, and a report with zeros."""
    ...

def obc_untangle_tetrahedra_problem_init(problem: Pointer, struct_size: int) -> int:
    """Fills a problem with no vertices."""
    ...

def obc_untangle_tetrahedra(problem: Pointer, options: Pointer, host: Pointer, result: Pointer, report: Pointer, error: Pointer) -> int:
    """Moves vertices until all tetrahedra are positive. result receives x y z a vertex and may be problem->positions; fixed coordinates are
    unchanged and tied ones have the same bits. A mesh without inverted tetrahedra is only polished. options, host and report may be
    NULL. Takes about 700 bytes a tetrahedron; a step is O(n) times up to 150 iterations of conjugate gradients; up to six attempts.
    Errors: no valid result (some remain inverted: their number and the first; result and report then have the best mesh, for all other
    errors they are unchanged); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
    not manifold (kinds non-manifold-face and inconsistent-orientation: three tetrahedra at a face, or two on one side of it);
    malformed file (kind index-range); degenerate (kinds degenerate-cell and inverted-cell: a repeated vertex, a rest
    tetrahedron that is not positive; degenerate-geometry: zero volume); out of memory; cancelled."""
    ...

def obc_untangle_triangles_problem_init(problem: Pointer, struct_size: int) -> int:
    """Fills a problem with no vertices."""
    ...

def obc_untangle_triangles(problem: Pointer, options: Pointer, host: Pointer, result: Pointer, report: Pointer, error: Pointer) -> int:
    """Moves vertices in the plane until all triangles are positive, counter-clockwise. result receives x y a vertex and may be
    problem->positions; fixed coordinates are unchanged and tied ones have the same bits. A mesh without inverted triangles is only polished.
    Where the boundary is a polygon without self-intersections and is fixed, the triangles of the result cover it without overlap. options,
    host and report may be NULL. Takes about 1 KB a triangle, and a sparse factor a step; up to six attempts.
    Errors: no valid result (some remain inverted: their number and the first; result and report then have the best mesh, for all other
    errors they are unchanged); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
    not manifold (kinds non-manifold-edge and inconsistent-orientation: three triangles at an edge, or two on one side of it);
    malformed file (kind index-range); degenerate (kind degenerate-face: a repeated vertex, a target shape without area;
    degenerate-geometry: zero area); out of memory; cancelled."""
    ...

def obc_untangle_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
