"""What <orbicube/hexmesh.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_HEXMESH_PADDING_AUTO: int
OBC_HEXMESH_PADDING_WITH: int
OBC_HEXMESH_PADDING_WITHOUT: int

OBC_HEXMESH_METHOD_AUTO: int
OBC_HEXMESH_METHOD_POLYCUBE: int
OBC_HEXMESH_METHOD_GRID: int
OBC_HEXMESH_METHOD_FRAMES: int

OBC_HEXMESH_FEATURES_OFF: int
OBC_HEXMESH_FEATURES_AUTO: int
OBC_HEXMESH_FEATURES_TAGS: int
OBC_HEXMESH_FEATURES_ANGLES: int
OBC_HEXMESH_FEATURES_MACHINED: int

obc_hexmesh_fill_function: Any

class obc_hexmesh_options(Struct):
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
    features: int
    tagged_edges: Any
    tagged_edge_count: int
    tagged_vertices: Any
    tagged_vertex_count: int
    fill: Any
    fill_user: Any
    regions: Any
    region_count: int
    def __init__(self, struct_size: int = ..., padding: int = ..., cells: int = ..., corners: int = ..., triangles: int = ..., seed: int = ..., rounds: int = ..., method: int = ..., max_hausdorff_percent: float = ..., max_cells: int = ..., feature_angle: float = ..., features: int = ..., tagged_edges: Any = ..., tagged_edge_count: int = ..., tagged_vertices: Any = ..., tagged_vertex_count: int = ..., fill: Any = ..., fill_user: Any = ..., regions: Any = ..., region_count: int = ...) -> None: ...

class obc_hexmesh_report(Struct):
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
    method: int
    integers_optimal: int
    singular_edges: int
    irregular_edges: int
    integers: int
    tetrahedra: int
    inverted_at_start: int
    steps: int
    fields: int
    feature_curves: int
    feature_corners: int
    missing_features: int
    captured: float
    scaled_jacobian_bound: float
    embedded: int
    conforming: int
    region_quads: int
    region_hausdorff_percent: float
    def __init__(self, struct_size: int = ..., padded: int = ..., min_scaled_jacobian: float = ..., mean_scaled_jacobian: float = ..., volume: float = ..., polycube_corners: int = ..., off_surface: int = ..., hausdorff_percent: float = ..., volume_error_percent: float = ..., follows_sharp_edges: int = ..., grid_based: int = ..., method: int = ..., integers_optimal: int = ..., singular_edges: int = ..., irregular_edges: int = ..., integers: int = ..., tetrahedra: int = ..., inverted_at_start: int = ..., steps: int = ..., fields: int = ..., feature_curves: int = ..., feature_corners: int = ..., missing_features: int = ..., captured: float = ..., scaled_jacobian_bound: float = ..., embedded: int = ..., conforming: int = ..., region_quads: int = ..., region_hausdorff_percent: float = ...) -> None: ...

class obc_hexmesh_missing(Struct):
    struct_size: int
    corner: int
    first: Any
    last: Any
    captured: float
    def __init__(self, struct_size: int = ..., corner: int = ..., first: Any = ..., last: Any = ..., captured: float = ...) -> None: ...

def obc_hexmesh_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_hexmesh_compute(surface: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer) -> int:
    """Fills a closed surface of any genus with hexahedra. The surface may have several disjoint pieces, among which the cells are divided by
    volume; components within a piece bound cavities. Triangles are reversed where neighbors disagree and where components are oriented
    into their solid; the log of the host says so. A few triangles may intersect others of their component, up to a twentieth of them. The
    volume of the result is infinite or 0 where the unit of the surface takes it out of the range of double. options, host and report
    may be NULL; the allocator of the host must remain valid until _destroy. Takes from a second to many minutes.
    Errors: invalid argument (also: more pieces than cells); not closed; not manifold (kinds self-intersection: components intersect;
    non-orientable); degenerate; malformed file; not connected (method FRAMES: several pieces); unsupported (method FRAMES without
    `fill`); no valid result with the obstacle; those of `fill`; out of memory; cancelled."""
    ...

def obc_hexmesh_compute_solid(positions: Pointer, vertex_count: int, tetrahedra: Pointer, tetrahedron_count: int, frames: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer) -> int:
    """Fills a solid of tetrahedra with hexahedra. positions: x y z a vertex; tetrahedra: four vertices each, positive, conforming; frames: NULL,
    or for the methods AUTO, which then is FRAMES, and FRAMES w x y z a tetrahedron as in <orbicube/frame_field.h>, with an axis along the
    normal at the boundary. For method FRAMES without frames several smooth fields are computed and repaired until a map
    follows one. The patch numbers of obc_hexmesh_copy are then those of connected boundary regions in one plane of the map. options, host
    and report may be NULL; the allocator of the host must remain valid until _destroy.
    Errors: as obc_hexmesh_compute for the boundary; malformed file (index-range); degenerate; not manifold; no valid result for a field
    that no such map follows, with the singular edge and its curve or the layer that would collapse, and for maps that remain inverted,
    with the location."""
    ...

def obc_hexmesh_destroy(hexes: Pointer) -> None:
    """Destroys a mesh; NULL is allowed."""
    ...

def obc_hexmesh_vertex_count(hexes: Pointer) -> int:
    """Return the number of vertices, hexahedra and boundary quads; 0 for NULL."""
    ...

def obc_hexmesh_count(hexes: Pointer) -> int:
    """Return the number of vertices, hexahedra and boundary quads; 0 for NULL."""
    ...

def obc_hexmesh_quad_count(hexes: Pointer) -> int:
    """Return the number of vertices, hexahedra and boundary quads; 0 for NULL."""
    ...

def obc_hexmesh_copy(hexes: Pointer, positions: Pointer, hexahedra: Pointer, quads: Pointer, quad_patches: Pointer, error: Pointer) -> int:
    """Copies positions (x y z a vertex), hexahedra (eight vertices each, in the order of MEDIT and VTK), boundary quads (four vertices each,
    counter-clockwise seen from outside) and the patch of each quad: of the polycube, of the feature curves where they are embedded, or 0;
    each may be NULL. Errors: invalid argument."""
    ...

def obc_hexmesh_copy_regions(hexes: Pointer, regions: Pointer, error: Pointer) -> int:
    """Copies the number of the region of each hexahedron, 0 where the solid had none. Errors: invalid argument."""
    ...

def obc_hexmesh_missing_count(hexes: Pointer) -> int:
    """Returns the number of missing features; 0 for NULL."""
    ...

def obc_hexmesh_get_missing(hexes: Pointer, index: int, missing: Pointer, error: Pointer) -> int:
    """Copies missing feature `index`, from 0. Errors: invalid argument."""
    ...

def obc_hexmesh_missing_reason(hexes: Pointer, index: int) -> bytes | None:
    """Returns what was in the way of missing feature `index`, in words, until the mesh is destroyed; NULL for an index out of range and for
    NULL."""
    ...

def obc_hexmesh_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
