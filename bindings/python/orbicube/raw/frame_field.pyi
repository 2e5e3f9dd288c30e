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
OBC_FRAME_FIELD_DISSERTATION: int

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
    """Fill options with the defaults, constraints with none, and a report with zeros."""
    ...

def obc_frame_field_constraints_init(constraints: Pointer, struct_size: int) -> int:
    """Fill options with the defaults, constraints with none, and a report with zeros."""
    ...

def obc_frame_field_report_init(report: Pointer, struct_size: int) -> int:
    """Fill options with the defaults, constraints with none, and a report with zeros."""
    ...

def obc_frame_field_compute(solid: Pointer, options: Pointer, constraints: Pointer, host: Pointer, frames: Pointer, report: Pointer, error: Pointer) -> int:
    """Computes a field of low energy. frames: 4 * tetrahedron_count doubles, read for OBC_FRAME_FIELD_GIVEN, and written on success only.
    options, constraints, host and report may be NULL. O(n), up to 1 KB a tetrahedron. Errors: invalid argument (NULL, NaN, index out
    of range, options), degenerate (a repeated vertex), not manifold (a face with three tetrahedra, neighbors on the same side of a
    face), out of memory, cancelled."""
    ...

def obc_frame_field_measure(solid: Pointer, frames: Pointer, host: Pointer, report: Pointer, error: Pointer) -> int:
    """Measures any field: frames, 4 * tetrahedron_count doubles, normalized before use. host may be NULL. O(n). Errors: as _compute."""
    ...

def obc_frame_field_matchings(solid: Pointer, frames: Pointer, host: Pointer, matchings: Pointer, error: Pointer) -> int:
    """Computes the matching of each face: 4 * tetrahedron_count numbers, entry 4 t + k for the face of tetrahedron t opposite its vertex k. It
    is the rotation of the cube (numbered as in obc_quaternion_cube_element) that, in its own axes, brings frame t nearest to that of the
    neighbor; 0 on the boundary. O(n). Errors: as _compute."""
    ...

def obc_frame_field_singularities_create(solid: Pointer, frames: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Finds the singular edges and curves of a field. host may be NULL; its allocator must remain valid until _destroy. O(n). Errors: as
    _compute."""
    ...

def obc_frame_field_singularities_destroy(singularities: Pointer) -> None:
    """Destroys the singularities; NULL is allowed."""
    ...

def obc_frame_field_singular_edge_count(singularities: Pointer) -> int:
    """Return the numbers of singular edges, curves and nodes; 0 for NULL."""
    ...

def obc_frame_field_singular_curve_count(singularities: Pointer) -> int:
    """Return the numbers of singular edges, curves and nodes; 0 for NULL."""
    ...

def obc_frame_field_singular_node_count(singularities: Pointer) -> int:
    """Return the numbers of singular edges, curves and nodes; 0 for NULL."""
    ...

def obc_frame_field_singularities_copy(singularities: Pointer, edge_vertices: Pointer, edge_rotations: Pointer, edge_turns: Pointer, curve_begin: Pointer, curve_edges: Pointer, nodes: Pointer, error: Pointer) -> int:
    """Copies to arrays of the caller, each of which may be NULL: for each edge two vertices, the rotation of the cube around it, and its
    turn: 1 for valence 3 of a hexahedral mesh, -1 for valence 5, 2 for a half turn, 0 where no hexahedral mesh exists. curve_begin (curve
    count + 1) are offsets of the curves into curve_edges (edge count), the edges in order along each. nodes are vertices. Errors:
    invalid argument."""
    ...

def obc_frame_field_unmeshable_edge_count(singularities: Pointer) -> int:
    """Return the numbers of unmeshable elements: singular edges that are not quarter turns about an axis, and inner vertices whose
    singular edges no hexahedral mesh has (turning points and nodes). Both are 0 for a locally meshable field and for NULL."""
    ...

def obc_frame_field_unmeshable_vertex_count(singularities: Pointer) -> int:
    """Return the numbers of unmeshable elements: singular edges that are not quarter turns about an axis, and inner vertices whose
    singular edges no hexahedral mesh has (turning points and nodes). Both are 0 for a locally meshable field and for NULL."""
    ...

def obc_frame_field_unmeshable_copy(singularities: Pointer, edges: Pointer, vertices: Pointer, error: Pointer) -> int:
    """Copies the unmeshable elements to arrays of the caller, each of which may be NULL: edges as indices of singular edges, vertices as
    indices of the solid, both ascending. Errors: invalid argument."""
    ...

def obc_frame_field_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
