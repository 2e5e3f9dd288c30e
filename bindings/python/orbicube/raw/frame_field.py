"""What <orbicube/frame_field.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct

OBC_FRAME_FIELD_AUTO = 0
OBC_FRAME_FIELD_IDENTITY = 1
OBC_FRAME_FIELD_PROPAGATED = 2
OBC_FRAME_FIELD_HARMONIC = 3
OBC_FRAME_FIELD_DIFFUSION = 4
OBC_FRAME_FIELD_GIVEN = 5

OBC_FRAME_FIELD_SMOOTH = 0
OBC_FRAME_FIELD_DISSERTATION = 1

OBC_FRAME_FIELD_UNIFORM = 0
OBC_FRAME_FIELD_GEOMETRIC = 1

OBC_FRAME_FIELD_NO_REPAIR = 0
OBC_FRAME_FIELD_REPAIR = 1
OBC_FRAME_FIELD_SINGLE_AXIS = 2


class obc_frame_field_solid(_Struct):
    """A tetrahedral mesh: a view of arrays of the caller."""
    _fields_ = [
        ("positions", _c.c_void_p),
        ("vertex_count", _c.c_size_t),
        ("tetrahedra", _c.c_void_p),
        ("tetrahedron_count", _c.c_size_t),
    ]


class obc_frame_field_options(_Struct):
    """Options of a field. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("start", _c.c_int32),
        ("method", _c.c_int32),
        ("weighting", _c.c_int32),
        ("align_boundary", _c.c_int32),
        ("rounds", _c.c_uint32),
        ("feature_angle", _c.c_double),
        ("relative_gain", _c.c_double),
        ("repair", _c.c_int32),
        ("reserved", _c.c_int32),
    ]


class obc_frame_field_constraints(_Struct):
    """Constraints of a field. Frames and directions have length 1. A positive, possibly infinite weight may soften each constraint: a finite
    weight w acts like w neighbors with the required frame, an infinite one fixes it. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("reserved", _c.c_int32),
        ("frame_tetrahedra", _c.c_void_p),
        ("frames", _c.c_void_p),
        ("frame_count", _c.c_size_t),
        ("axis_tetrahedra", _c.c_void_p),
        ("axes", _c.c_void_p),
        ("axis_count", _c.c_size_t),
        ("frame_weights", _c.c_void_p),
        ("axis_weights", _c.c_void_p),
    ]


class obc_frame_field_report(_Struct):
    """Figures of a field. Angles are in degrees, over inner faces: mean, standard deviation, median, 99th percentile, maximum."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("start", _c.c_int32),
        ("energy", _c.c_double),
        ("symmetric_mean", _c.c_double),
        ("symmetric_deviation", _c.c_double),
        ("symmetric_median", _c.c_double),
        ("symmetric_p99", _c.c_double),
        ("symmetric_max", _c.c_double),
        ("plain_mean", _c.c_double),
        ("plain_deviation", _c.c_double),
        ("plain_median", _c.c_double),
        ("plain_p99", _c.c_double),
        ("plain_max", _c.c_double),
        ("inner_faces", _c.c_uint64),
        ("boundary_faces", _c.c_uint64),
        ("above_30", _c.c_uint64),
        ("one_face_max", _c.c_double),
        ("several_best_max", _c.c_double),
        ("several_worst_max", _c.c_double),
        ("singular_edges", _c.c_uint64),
        ("singular_quarter", _c.c_uint64),
        ("singular_half", _c.c_uint64),
        ("singular_third", _c.c_uint64),
        ("singular_diagonal", _c.c_uint64),
        ("curves", _c.c_uint64),
        ("closed_curves", _c.c_uint64),
        ("nodes", _c.c_uint64),
        ("boundary_ends", _c.c_uint64),
        ("dead_ends", _c.c_uint64),
        ("singular_length", _c.c_double),
        ("edge_length", _c.c_double),
        ("boundary_index_quarters", _c.c_int64),
        ("euler_characteristic", _c.c_int64),
        ("smoothing_steps", _c.c_uint64),
        ("solver_iterations", _c.c_uint64),
        ("locally_meshable", _c.c_uint64),
        ("improper_edges", _c.c_uint64),
        ("turning_points", _c.c_uint64),
        ("improper_nodes", _c.c_uint64),
        ("fragments", _c.c_uint64),
        ("repair_rounds", _c.c_uint64),
        ("unmeshable_before", _c.c_uint64),
        ("fragments_before", _c.c_uint64),
        ("energy_before_repair", _c.c_double),
    ]


_functions = [
    ("obc_frame_field_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_frame_field_constraints_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_frame_field_report_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_frame_field_compute", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_frame_field_measure", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_frame_field_matchings", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_frame_field_singularities_create", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_frame_field_singularities_destroy", None, [_c.c_void_p]),
    ("obc_frame_field_singular_edge_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_frame_field_singular_curve_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_frame_field_singular_node_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_frame_field_singularities_copy", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_frame_field_unmeshable_edge_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_frame_field_unmeshable_vertex_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_frame_field_unmeshable_copy", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_frame_field_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("frame_field", ["base"], _functions, globals(), name)
