"""What <orbicube/volume_map.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_VOLUME_MAP_PADDING_AUTO: int
OBC_VOLUME_MAP_PADDING_WITH: int
OBC_VOLUME_MAP_PADDING_WITHOUT: int

OBC_VOLUME_MAP_METHOD_AUTO: int
OBC_VOLUME_MAP_METHOD_POLYCUBE: int
OBC_VOLUME_MAP_METHOD_GRID: int

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

class obc_volume_map_hexes_options(Struct):
    struct_size: int
    padding: int
    cells: int
    corners: int
    triangles: int
    seed: int
    rounds: int
    method: int
    max_hausdorff_percent: float
    max_cells: int
    feature_angle: float
    def __init__(self, struct_size: int = ..., padding: int = ..., cells: int = ..., corners: int = ..., triangles: int = ..., seed: int = ..., rounds: int = ..., method: int = ..., max_hausdorff_percent: float = ..., max_cells: int = ..., feature_angle: float = ...) -> None: ...

class obc_volume_map_hexes_report(Struct):
    struct_size: int
    padded: int
    min_scaled_jacobian: float
    mean_scaled_jacobian: float
    volume: float
    polycube_corners: int
    off_surface: int
    hausdorff_percent: float
    volume_error_percent: float
    follows_sharp_edges: int
    grid_based: int
    def __init__(self, struct_size: int = ..., padded: int = ..., min_scaled_jacobian: float = ..., mean_scaled_jacobian: float = ..., volume: float = ..., polycube_corners: int = ..., off_surface: int = ..., hausdorff_percent: float = ..., volume_error_percent: float = ..., follows_sharp_edges: int = ..., grid_based: int = ...) -> None: ...

class obc_volume_map_frame_options(Struct):
    struct_size: int
    rounds: int
    cells: int
    feature_angle: float
    max_hausdorff_percent: float
    max_cells: int
    def __init__(self, struct_size: int = ..., rounds: int = ..., cells: int = ..., feature_angle: float = ..., max_hausdorff_percent: float = ..., max_cells: int = ...) -> None: ...

class obc_volume_map_frame_report(Struct):
    struct_size: int
    integers_optimal: int
    min_scaled_jacobian: float
    mean_scaled_jacobian: float
    volume: float
    off_surface: int
    singular_edges: int
    irregular_edges: int
    integers: int
    tetrahedra: int
    inverted_at_start: int
    steps: int
    hausdorff_percent: float
    volume_error_percent: float
    def __init__(self, struct_size: int = ..., integers_optimal: int = ..., min_scaled_jacobian: float = ..., mean_scaled_jacobian: float = ..., volume: float = ..., off_surface: int = ..., singular_edges: int = ..., irregular_edges: int = ..., integers: int = ..., tetrahedra: int = ..., inverted_at_start: int = ..., steps: int = ..., hausdorff_percent: float = ..., volume_error_percent: float = ...) -> None: ...

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

def obc_volume_map_hexes_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_volume_map_hexes_compute(surface: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer) -> int:
    """Fills a closed, outward-oriented surface of any genus with hexahedra. The surface may have several disjoint pieces, among which the
    cells are divided by volume; inward-oriented components within a piece bound cavities. Hexahedra are conforming, the
    boundary has the components and the genus of the surface, each hexahedron has positive corners by exact signs and a
    trilinear map with proven positive determinant. options, host and report may be NULL; the allocator of the host must remain valid
    until _destroy.
    Errors: invalid argument (also: more pieces than cells); not closed; not manifold (kinds self-intersection: components
    intersect; inconsistent-orientation: components oriented into the solid); degenerate; malformed file; no valid result with the
    obstacle; out of memory; cancelled."""
    ...

def obc_volume_map_hexes_destroy(hexes: Pointer) -> None:
    """Destroys a mesh; NULL is allowed."""
    ...

def obc_volume_map_hexes_vertex_count(hexes: Pointer) -> int:
    """Return the number of vertices, hexahedra and boundary quads; 0 for NULL."""
    ...

def obc_volume_map_hexes_count(hexes: Pointer) -> int:
    """Return the number of vertices, hexahedra and boundary quads; 0 for NULL."""
    ...

def obc_volume_map_hexes_quad_count(hexes: Pointer) -> int:
    """Return the number of vertices, hexahedra and boundary quads; 0 for NULL."""
    ...

def obc_volume_map_hexes_copy(hexes: Pointer, positions: Pointer, hexahedra: Pointer, quads: Pointer, quad_patches: Pointer, error: Pointer) -> int:
    """Copies positions (x y z a vertex), hexahedra (eight vertices each, in the order of MEDIT and VTK), boundary quads (four vertices each,
    counter-clockwise seen from outside) and the polycube patch of each quad (0 for grid-based ones); each may be NULL.
    Errors: invalid argument."""
    ...

def obc_volume_map_frame_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_volume_map_frame_hexes_compute(positions: Pointer, vertex_count: int, tetrahedra: Pointer, tetrahedron_count: int, frames: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer) -> int:
    """Fills a solid with hexahedra that follow a frame field, with its singular edges inside (CubeCover: Nieser, Reitebuch and
    Polthier 2011). positions: x y z a vertex; tetrahedra: four vertices each, positive, conforming; frames: w x y z a tetrahedron as in
    <orbicube/frame_field.h>, with an axis along the normal at the boundary, or NULL: several smooth fields are computed and repaired
    until a map follows one. The patch numbers of obc_volume_map_hexes_copy are those of connected boundary regions in one
    plane of the map. Where the boundary exceeds `max_hausdorff_percent`, it is fixed to the map's surface, then cells are added as in
    obc_volume_map_hexes_compute. options, host and report may be NULL; the allocator of the host must remain valid until _destroy.
    Errors: invalid argument; malformed file (index-range); degenerate; not manifold; no valid result for a field that no such map
    follows, with the singular edge and its curve or the layer that would collapse, and for maps that remain inverted, with
    the location; out of memory; cancelled."""
    ...

def obc_volume_map_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
