"""What <orbicube/volume_map.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_VOLUME_MAP_PADDING_AUTO: int
OBC_VOLUME_MAP_PADDING_WITH: int
OBC_VOLUME_MAP_PADDING_WITHOUT: int

OBC_VOLUME_MAP_METHOD_AUTO: int
OBC_VOLUME_MAP_METHOD_POLYCUBE: int
OBC_VOLUME_MAP_METHOD_VOXELS: int

class obc_volume_map_tangle(Struct):
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
    least_determinant: float
    greatest_determinant: float
    energy: float
    def __init__(self, struct_size: int = ..., first_inverted: int = ..., inverted_before: int = ..., inverted: int = ..., steps: int = ..., polish_steps: int = ..., least_determinant: float = ..., greatest_determinant: float = ..., energy: float = ...) -> None: ...

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
    distance: float
    most_cells: int
    sharp_angle: float
    def __init__(self, struct_size: int = ..., padding: int = ..., cells: int = ..., corners: int = ..., triangles: int = ..., seed: int = ..., rounds: int = ..., method: int = ..., distance: float = ..., most_cells: int = ..., sharp_angle: float = ...) -> None: ...

class obc_volume_map_hexes_report(Struct):
    struct_size: int
    padded: int
    least_scaled_jacobian: float
    mean_scaled_jacobian: float
    volume: float
    polycube_corners: int
    off_surface: int
    distance: float
    volume_error: float
    follows_sharp_edges: int
    by_voxels: int
    def __init__(self, struct_size: int = ..., padded: int = ..., least_scaled_jacobian: float = ..., mean_scaled_jacobian: float = ..., volume: float = ..., polycube_corners: int = ..., off_surface: int = ..., distance: float = ..., volume_error: float = ..., follows_sharp_edges: int = ..., by_voxels: int = ...) -> None: ...

class obc_volume_map_frame_options(Struct):
    struct_size: int
    rounds: int
    cells: int
    feature_angle: float
    distance: float
    most_cells: int
    def __init__(self, struct_size: int = ..., rounds: int = ..., cells: int = ..., feature_angle: float = ..., distance: float = ..., most_cells: int = ...) -> None: ...

class obc_volume_map_frame_report(Struct):
    struct_size: int
    integers_optimal: int
    least_scaled_jacobian: float
    mean_scaled_jacobian: float
    volume: float
    off_surface: int
    singular_edges: int
    irregular_edges: int
    integers: int
    tetrahedra: int
    inverted_at_start: int
    steps: int
    distance: float
    volume_error: float
    def __init__(self, struct_size: int = ..., integers_optimal: int = ..., least_scaled_jacobian: float = ..., mean_scaled_jacobian: float = ..., volume: float = ..., off_surface: int = ..., singular_edges: int = ..., irregular_edges: int = ..., integers: int = ..., tetrahedra: int = ..., inverted_at_start: int = ..., steps: int = ..., distance: float = ..., volume_error: float = ...) -> None: ...

def obc_volume_map_tangle_init(tangle: Pointer, struct_size: int) -> int:
    """A mesh of nothing; the defaults, which the members' comments give; zeros."""
    ...

def obc_volume_map_untangle_options_init(options: Pointer, struct_size: int) -> int:
    """A mesh of nothing; the defaults, which the members' comments give; zeros."""
    ...

def obc_volume_map_untangle_report_init(report: Pointer, struct_size: int) -> int:
    """A mesh of nothing; the defaults, which the members' comments give; zeros."""
    ...

def obc_volume_map_untangle(tangle: Pointer, options: Pointer, host: Pointer, result: Pointer, report: Pointer, error: Pointer) -> int:
    """Moves vertices until all tetrahedra are positive: result gets x y z a vertex, fixed coordinates to the bit, tied ones the
    same bits. A mesh without inverted tetrahedra is only polished. options, host and report may be NULL; result may be
    tangle->positions. About 700 bytes a tetrahedron; a step is O(n) but for its conjugate gradients, 150 at most.
    Errors: no valid result (some stay inverted: how many and the first; result and report then have the best that was found, on
    all other errors nothing); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
    not manifold (kinds non-manifold-face and inconsistent-orientation: three tetrahedra at a face, or two on one side of it);
    malformed file (kind index-range), degenerate (kinds degenerate-cell and inverted-cell: a repeated vertex, a tetrahedron of
    rest that is not positive; degenerate-geometry: no volume at all), out of memory, cancelled."""
    ...

def obc_volume_map_solid_options_init(options: Pointer, struct_size: int) -> int:
    """The defaults, which the members' comments give."""
    ...

def obc_volume_map_solid_compute(positions: Pointer, vertex_count: int, tetrahedra: Pointer, tetrahedron_count: int, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Finds a polycube of the boundary of a solid and a map of the solid to it: every tetrahedron is positive, on the polycube and
    in space, and the boundary covers the polycube once. positions: x y z a vertex; tetrahedra: four vertices each, positive,
    meeting in whole faces. Tetrahedra are split where the map needs that. options and host may be NULL; the allocator of the
    host must stay valid until _destroy. Minutes for a hundred thousand tetrahedra.
    A cavity gets a polycube within that of the outer wall; the polycubes of pieces stand side by side along x.
    Errors: invalid argument; malformed file (index-range), degenerate, not manifold, not closed; no valid result with what stood
    in the way; out of memory, cancelled."""
    ...

def obc_volume_map_solid_destroy(solid: Pointer) -> None:
    """NULL is fine, here and in the functions that count (0)."""
    ...

def obc_volume_map_solid_vertex_count(solid: Pointer) -> int:
    """NULL is fine, here and in the functions that count (0)."""
    ...

def obc_volume_map_solid_tetrahedron_count(solid: Pointer) -> int:
    """NULL is fine, here and in the functions that count (0)."""
    ...

def obc_volume_map_solid_copy(solid: Pointer, positions: Pointer, polycube: Pointer, tetrahedra: Pointer, error: Pointer) -> int:
    """x y z a vertex in space, and on the polycube; four vertices a tetrahedron. Each may be NULL. Errors: invalid argument."""
    ...

def obc_volume_map_hexes_options_init(options: Pointer, struct_size: int) -> int:
    """The defaults, which the members' comments give."""
    ...

def obc_volume_map_hexes_compute(surface: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer) -> int:
    """Fills a closed surface with hexahedra: oriented, looking outward, of any genus, in one piece or in several that lie apart,
    which get their parts of the cells by their volumes. Parts within a piece that look inward are the walls of cavities, which
    stay empty. Hexahedra meet in whole faces, the boundary has the parts and the genus of the surface, each hexahedron has
    positive corners by exact signs and a trilinear map that is certainly positive. In the report of several pieces, corners and
    vertices are all of them, distance and volume_error the largest, in percent of its own piece. options, host and report may be
    NULL; the allocator of the host must stay valid until _destroy.
    Errors: invalid argument; not closed; not manifold (kinds self-intersection: parts that meet, inconsistent-orientation: parts
    that look into the solid); degenerate; malformed file; no valid result with what stood in the way; out of memory, cancelled."""
    ...

def obc_volume_map_hexes_destroy(hexes: Pointer) -> None:
    """NULL is fine, here and in the functions that count (0)."""
    ...

def obc_volume_map_hexes_vertex_count(hexes: Pointer) -> int:
    """NULL is fine, here and in the functions that count (0)."""
    ...

def obc_volume_map_hexes_count(hexes: Pointer) -> int:
    """NULL is fine, here and in the functions that count (0)."""
    ...

def obc_volume_map_hexes_quad_count(hexes: Pointer) -> int:
    """NULL is fine, here and in the functions that count (0)."""
    ...

def obc_volume_map_hexes_copy(hexes: Pointer, positions: Pointer, hexahedra: Pointer, quads: Pointer, quad_faces: Pointer, error: Pointer) -> int:
    """x y z a vertex; eight vertices a hexahedron, in the order of MEDIT and VTK; four vertices a quad of the boundary,
    counter-clockwise seen from outside, and the face of the polycube that it lies on (0 by voxels). Each may be NULL. Errors: invalid
    argument."""
    ...

def obc_volume_map_frame_options_init(options: Pointer, struct_size: int) -> int:
    """The defaults, which the members' comments give."""
    ...

def obc_volume_map_frame_hexes_compute(positions: Pointer, vertex_count: int, tetrahedra: Pointer, tetrahedron_count: int, frames: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer) -> int:
    """Fills a solid with hexahedra that follow a frame field, with its singular edges inside (CubeCover: Nieser, Reitebuch and
    Polthier 2011). positions: x y z a vertex; tetrahedra: four vertices each, positive, meeting in whole faces; frames: w x y z a
    tetrahedron as in <orbicube/frame_field.h>, with an axis along the normal at the boundary, or NULL: several smooth fields are
    made and repaired, until a map follows one. The faces of the result (obc_volume_map_hexes_copy) are the parts of the boundary
    that lie in one plane of the map. Where their boundary is farther from that of the solid than asked for, it is held there, then
    there are more cells, as in obc_volume_map_hexes_compute. options, host and report may be NULL; the allocator of the host must stay valid until _destroy.
    Errors: invalid argument; malformed file (index-range), degenerate, not manifold; no valid result for a field that no such map
    has, with the singular edge and its curve or the layer that would collapse, and for maps that stay inverted, with the place;
    out of memory, cancelled."""
    ...

def obc_volume_map_version() -> int:
    """Version of this library, major * 10000 + minor * 100 + patch."""
    ...
