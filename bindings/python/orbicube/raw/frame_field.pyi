"""What <orbicube/frame_field.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_FRAME_FIELD_AUTO: int
OBC_FRAME_FIELD_IDENTITY: int
OBC_FRAME_FIELD_PROPAGATED: int
OBC_FRAME_FIELD_HARMONIC: int
OBC_FRAME_FIELD_DIFFUSION: int
OBC_FRAME_FIELD_GIVEN: int

OBC_FRAME_FIELD_SMOOTH: int
OBC_FRAME_FIELD_SEED: int

OBC_FRAME_FIELD_UNIFORM: int
OBC_FRAME_FIELD_GEOMETRIC: int

OBC_FRAME_FIELD_NO_REPAIR: int
OBC_FRAME_FIELD_REPAIR: int
OBC_FRAME_FIELD_SINGLE_AXIS: int

class obc_frame_field_solid(Struct):
    positions: Any
    vertex_count: int
    tetrahedra: Any
    tetrahedron_count: int
    def __init__(self, positions: Any = ..., vertex_count: int = ..., tetrahedra: Any = ..., tetrahedron_count: int = ...) -> None: ...

class obc_frame_field_options(Struct):
    struct_size: int
    start: int
    method: int
    weighting: int
    align_boundary: int
    rounds: int
    feature_angle: float
    relative_gain: float
    repair: int
    reserved: int
    def __init__(self, struct_size: int = ..., start: int = ..., method: int = ..., weighting: int = ..., align_boundary: int = ..., rounds: int = ..., feature_angle: float = ..., relative_gain: float = ..., repair: int = ..., reserved: int = ...) -> None: ...

class obc_frame_field_constraints(Struct):
    struct_size: int
    reserved: int
    frame_tetrahedra: Any
    frames: Any
    frame_count: int
    axis_tetrahedra: Any
    axes: Any
    axis_count: int
    frame_weights: Any
    axis_weights: Any
    def __init__(self, struct_size: int = ..., reserved: int = ..., frame_tetrahedra: Any = ..., frames: Any = ..., frame_count: int = ..., axis_tetrahedra: Any = ..., axes: Any = ..., axis_count: int = ..., frame_weights: Any = ..., axis_weights: Any = ...) -> None: ...

class obc_frame_field_report(Struct):
    struct_size: int
    start: int
    energy: float
    symmetric_mean: float
    symmetric_deviation: float
    symmetric_median: float
    symmetric_p99: float
    symmetric_max: float
    plain_mean: float
    plain_deviation: float
    plain_median: float
    plain_p99: float
    plain_max: float
    inner_faces: int
    boundary_faces: int
    above_30: int
    one_face_max: float
    several_best_max: float
    several_worst_max: float
    singular_edges: int
    singular_quarter: int
    singular_half: int
    singular_third: int
    singular_diagonal: int
    curves: int
    closed_curves: int
    nodes: int
    boundary_ends: int
    dead_ends: int
    singular_length: float
    edge_length: float
    boundary_index_quarters: int
    euler_characteristic: int
    smoothing_steps: int
    solver_iterations: int
    locally_meshable: int
    improper_edges: int
    turning_points: int
    improper_nodes: int
    fragments: int
    repair_rounds: int
    unmeshable_before: int
    fragments_before: int
    energy_before_repair: float
    def __init__(self, struct_size: int = ..., start: int = ..., energy: float = ..., symmetric_mean: float = ..., symmetric_deviation: float = ..., symmetric_median: float = ..., symmetric_p99: float = ..., symmetric_max: float = ..., plain_mean: float = ..., plain_deviation: float = ..., plain_median: float = ..., plain_p99: float = ..., plain_max: float = ..., inner_faces: int = ..., boundary_faces: int = ..., above_30: int = ..., one_face_max: float = ..., several_best_max: float = ..., several_worst_max: float = ..., singular_edges: int = ..., singular_quarter: int = ..., singular_half: int = ..., singular_third: int = ..., singular_diagonal: int = ..., curves: int = ..., closed_curves: int = ..., nodes: int = ..., boundary_ends: int = ..., dead_ends: int = ..., singular_length: float = ..., edge_length: float = ..., boundary_index_quarters: int = ..., euler_characteristic: int = ..., smoothing_steps: int = ..., solver_iterations: int = ..., locally_meshable: int = ..., improper_edges: int = ..., turning_points: int = ..., improper_nodes: int = ..., fragments: int = ..., repair_rounds: int = ..., unmeshable_before: int = ..., fragments_before: int = ..., energy_before_repair: float = ...) -> None: ...

def obc_frame_field_options_init(options: Pointer, struct_size: int) -> int:
    """Fill options, constraints and reports with the defaults, no constraints, and zeros."""
    ...

def obc_frame_field_constraints_init(constraints: Pointer, struct_size: int) -> int:
    """Fill options, constraints and reports with the defaults, no constraints, and zeros."""
    ...

def obc_frame_field_report_init(report: Pointer, struct_size: int) -> int:
    """Fill options, constraints and reports with the defaults, no constraints, and zeros."""
    ...

def obc_frame_field_compute(solid: Pointer, options: Pointer, constraints: Pointer, host: Pointer, frames: Pointer, report: Pointer, error: Pointer) -> int:
    """Computes a field of small energy. frames: 4 * tetrahedron_count doubles, read with the start given, and written on success
    only. options, constraints, host and report may be NULL. O(n), at most 1 KB a tetrahedron.
    Errors: invalid argument (NULL, NaN, index out of range, options), degenerate (a repeated vertex), not manifold (a face of
    three tetrahedra, neighbours on the same side of a face), out of memory, cancelled."""
    ...

def obc_frame_field_measure(solid: Pointer, frames: Pointer, host: Pointer, report: Pointer, error: Pointer) -> int:
    """Figures of any field: frames, 4 * tetrahedron_count doubles, normalised before use. host may be NULL. O(n).
    Errors: as _compute."""
    ...

def obc_frame_field_matchings(solid: Pointer, frames: Pointer, host: Pointer, matchings: Pointer, error: Pointer) -> int:
    """How the frames on both sides of the faces match: 4 * tetrahedron_count numbers, that at 4 t + k for the face of
    tetrahedron t opposite its corner k: the rotation of the cube (its number in obc_quaternion_cube_element) that, in its own
    axes, brings frame t next to that of the neighbour; 0 on the boundary. Errors: as _compute. O(n)."""
    ...

def obc_frame_field_singularities_create(solid: Pointer, frames: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """The singular edges of a field and the curves that they form, in a handle. host may be NULL; its allocator must stay valid
    until _destroy. Errors: as _compute. O(n)."""
    ...

def obc_frame_field_singularities_destroy(singularities: Pointer) -> None:
    """The singular edges of a field and the curves that they form, in a handle. host may be NULL; its allocator must stay valid
    until _destroy. Errors: as _compute. O(n)."""
    ...

def obc_frame_field_singular_edge_count(singularities: Pointer) -> int:
    """Numbers; 0 for NULL."""
    ...

def obc_frame_field_singular_curve_count(singularities: Pointer) -> int:
    """Numbers; 0 for NULL."""
    ...

def obc_frame_field_singular_node_count(singularities: Pointer) -> int:
    """Numbers; 0 for NULL."""
    ...

def obc_frame_field_singularities_copy(singularities: Pointer, edge_vertices: Pointer, edge_rotations: Pointer, edge_turns: Pointer, curve_begin: Pointer, curve_edges: Pointer, nodes: Pointer, error: Pointer) -> int:
    """Copies to the caller's arrays, each of which may be NULL. Edges: two vertices each; their rotation of the cube around the
    edge; their turn, 1 where hexahedra would meet in threes, -1 in fives, 2 for half turns, 0 where they cannot. Curves:
    curve_begin (curve count + 1) says where each begins in curve_edges (edge count), the edges in order along it. Nodes: their
    vertices. Errors: invalid argument."""
    ...

def obc_frame_field_unmeshable_edge_count(singularities: Pointer) -> int:
    """Where the field cannot be that of a hexahedral mesh: singular edges that are no quarter turns about an axis, and inner
    vertices whose edges of threes and fives no hexahedral mesh has (turning points and nodes). Both counts are 0 when the field
    is locally meshable, and for NULL."""
    ...

def obc_frame_field_unmeshable_vertex_count(singularities: Pointer) -> int:
    """Where the field cannot be that of a hexahedral mesh: singular edges that are no quarter turns about an axis, and inner
    vertices whose edges of threes and fives no hexahedral mesh has (turning points and nodes). Both counts are 0 when the field
    is locally meshable, and for NULL."""
    ...

def obc_frame_field_unmeshable_copy(singularities: Pointer, edges: Pointer, vertices: Pointer, error: Pointer) -> int:
    """Copies them to the caller's arrays, each of which may be NULL: the edges as numbers of singular edges, the vertices as
    indices of the solid's, both ascending. Errors: invalid argument."""
    ...

def obc_frame_field_version() -> int:
    """Version of the library, major * 10000 + minor * 100 + patch."""
    ...
