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
    Errors: no valid result (some remain inverted: their number and the first; result and report then have the best mesh, all other
    errors leave result unchanged); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
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
    Errors: no valid result (some remain inverted: their number and the first; result and report then have the best mesh, all other
    errors leave result unchanged); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
    not manifold (kinds non-manifold-edge and inconsistent-orientation: three triangles at an edge, or two on one side of it);
    malformed file (kind index-range); degenerate (kind degenerate-face: a repeated vertex, a target shape without area;
    degenerate-geometry: zero area); out of memory; cancelled."""
    ...

def obc_untangle_refine_tetrahedra(problem: Pointer, options: Pointer, host: Pointer, out: Pointer, report: Pointer, error: Pointer) -> int:
    """Untangle as obc_untangle_tetrahedra and obc_untangle_triangles do and, where the mesh as it is has no solution or none is found, split
    elements: first all edges, faces and elements that join fixed vertices and are not in the boundary, then edges of elements that
    remain inverted. New vertices are free, also between fixed ones inside; the boundary is not split, nor is a mesh without inverted elements.
    A disk of triangles whose fixed boundary is a star-shaped polygon, all else being free and without ties, is always untangled, within the
    precision of coordinates. Elements that become positive by rounding alone, with determinants below 1e-9, are split too. options,
    host and report may be NULL; the allocator of the host must remain valid until _destroy. The report counts elements after splits, but
    for inverted_before. Takes the time and memory of those functions for up to ten meshes, of up to about eight times the elements.
    *out is NULL after an error. Errors: as those functions; after no valid result the report has the figures of the best mesh found."""
    ...

def obc_untangle_refine_triangles(problem: Pointer, options: Pointer, host: Pointer, out: Pointer, report: Pointer, error: Pointer) -> int:
    """Untangle as obc_untangle_tetrahedra and obc_untangle_triangles do and, where the mesh as it is has no solution or none is found, split
    elements: first all edges, faces and elements that join fixed vertices and are not in the boundary, then edges of elements that
    remain inverted. New vertices are free, also between fixed ones inside; the boundary is not split, nor is a mesh without inverted elements.
    A disk of triangles whose fixed boundary is a star-shaped polygon, all else being free and without ties, is always untangled, within the
    precision of coordinates. Elements that become positive by rounding alone, with determinants below 1e-9, are split too. options,
    host and report may be NULL; the allocator of the host must remain valid until _destroy. The report counts elements after splits, but
    for inverted_before. Takes the time and memory of those functions for up to ten meshes, of up to about eight times the elements.
    *out is NULL after an error. Errors: as those functions; after no valid result the report has the figures of the best mesh found."""
    ...

def obc_untangle_refined_destroy(refined: Pointer) -> None:
    """Destroys a mesh; NULL is allowed."""
    ...

def obc_untangle_refined_vertex_count(refined: Pointer) -> int:
    """Return the number of vertices, of which those of the problem are the first, and of elements; 0 for NULL."""
    ...

def obc_untangle_refined_element_count(refined: Pointer) -> int:
    """Return the number of vertices, of which those of the problem are the first, and of elements; 0 for NULL."""
    ...

def obc_untangle_refined_copy(refined: Pointer, positions: Pointer, elements: Pointer, parents: Pointer, origins: Pointer, weights: Pointer, error: Pointer) -> int:
    """Copies the mesh to arrays of the caller, each of which may be NULL. d is 3 for tetrahedra and 2 for triangles. positions: d a vertex;
    elements: d + 1 vertices each; parents: for each element the one of the problem that it is part of; origins and weights: d + 1 a
    vertex, the vertices of the problem whose mean it is there, and their weights, which add up to 1 but for rounding; UINT32_MAX with
    weight 0 for the rest. Errors: invalid argument."""
    ...

def obc_untangle_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
