"""What <orbicube/projected_gradient.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct

OBC_PROJECTED_GRADIENT_FACE = 0
OBC_PROJECTED_GRADIENT_DISSERTATION = 1

OBC_PROJECTED_GRADIENT_MAX_OF_LAST = 0
OBC_PROJECTED_GRADIENT_AVERAGE = 1

OBC_PROJECTED_GRADIENT_NEED_FG = 1
OBC_PROJECTED_GRADIENT_ITERATION = 2
OBC_PROJECTED_GRADIENT_DONE = 3

OBC_PROJECTED_GRADIENT_RUNNING = 0
OBC_PROJECTED_GRADIENT_CONVERGED = 1
OBC_PROJECTED_GRADIENT_TARGET_REACHED = 2
OBC_PROJECTED_GRADIENT_EVALUATION_BUDGET = 3
OBC_PROJECTED_GRADIENT_ITERATION_BUDGET = 4
OBC_PROJECTED_GRADIENT_STALLED = 5
OBC_PROJECTED_GRADIENT_INFEASIBLE = 6
OBC_PROJECTED_GRADIENT_CANCELLED = 7
OBC_PROJECTED_GRADIENT_EVALUATION_FAILED = 8
OBC_PROJECTED_GRADIENT_PROJECTION_FAILED = 9
OBC_PROJECTED_GRADIENT_UNBOUNDED = 10

OBC_PROJECTED_GRADIENT_CONTINUE = 0
OBC_PROJECTED_GRADIENT_STOP = 1
OBC_PROJECTED_GRADIENT_FAILED = 2

obc_projected_gradient_function = _c.CFUNCTYPE(_c.c_int32, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p)

obc_projected_gradient_projection = _c.CFUNCTYPE(_c.c_int32, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p)


class obc_projected_gradient_problem(_Struct):
    """The feasible set: either bounds and rows, or a projection of the caller. Arrays are copied. Fill with _problem_init, or with zeros
    and struct_size, which is the same: in C99 {.struct_size = sizeof(obc_projected_gradient_problem), .n = 2}."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("n", _c.c_size_t),
        ("m", _c.c_size_t),
        ("lower", _c.c_void_p),
        ("upper", _c.c_void_p),
        ("row_start", _c.c_void_p),
        ("column", _c.c_void_p),
        ("value", _c.c_void_p),
        ("b", _c.c_void_p),
        ("project", obc_projected_gradient_projection),
        ("project_user", _c.c_void_p),
    ]


class obc_projected_gradient_options(_Struct):
    """Options of a run. Fill with _options_init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("method", _c.c_int32),
        ("line_search", _c.c_int32),
        ("memory", _c.c_uint32),
        ("history", _c.c_uint32),
        ("average_weight", _c.c_double),
        ("gradient_tolerance", _c.c_double),
        ("target", _c.c_double),
        ("max_evaluations", _c.c_uint64),
        ("max_iterations", _c.c_uint64),
    ]


class obc_projected_gradient_result(_Struct):
    """State of a run. The caller sets struct_size."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("stop", _c.c_int32),
        ("value", _c.c_double),
        ("projected_gradient", _c.c_double),
        ("equality_residual", _c.c_double),
        ("evaluations", _c.c_uint64),
        ("failed_evaluations", _c.c_uint64),
        ("iterations", _c.c_uint64),
        ("projection_passes", _c.c_uint64),
        ("certificate_gap", _c.c_double),
    ]


class obc_projected_gradient_check(_Struct):
    """Comparison of a gradient with finite differences. The caller sets struct_size."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("agrees", _c.c_int32),
        ("worst", _c.c_size_t),
        ("told", _c.c_double),
        ("difference", _c.c_double),
        ("error", _c.c_double),
        ("uncertainty", _c.c_double),
        ("compared", _c.c_size_t),
        ("evaluations", _c.c_uint64),
    ]


_functions = [
    ("obc_projected_gradient_problem_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_projected_gradient_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_projected_gradient_create", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_projected_gradient_step", _c.c_int32, [_c.c_void_p, _c.c_void_p]),
    ("obc_projected_gradient_tell", _c.c_int32, [_c.c_void_p, _c.c_double, _c.c_void_p, _c.c_void_p]),
    ("obc_projected_gradient_get_result", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_projected_gradient_multipliers", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_projected_gradient_certificate", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_projected_gradient_save_size", _c.c_size_t, [_c.c_void_p]),
    ("obc_projected_gradient_save", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p]),
    ("obc_projected_gradient_load", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_projected_gradient_destroy", None, [_c.c_void_p]),
    ("obc_projected_gradient_minimize", _c.c_int32, [_c.c_void_p, _c.c_void_p, obc_projected_gradient_function, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_projected_gradient_project", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_projected_gradient_check_gradient", _c.c_int32, [_c.c_void_p, obc_projected_gradient_function, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_projected_gradient_stop_name", _c.c_char_p, [_c.c_int32]),
    ("obc_projected_gradient_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("projected_gradient", ["base"], _functions, globals(), name)
