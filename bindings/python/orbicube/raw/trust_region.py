"""What <orbicube/trust_region.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct

OBC_TRUST_REGION_TWO_RADII = 0
OBC_TRUST_REGION_DISSERTATION = 1

OBC_TRUST_REGION_AUTOMATIC = 0
OBC_TRUST_REGION_CHAIN = 1
OBC_TRUST_REGION_CROSS = 2

OBC_TRUST_REGION_SUM_OF_SQUARES = 0
OBC_TRUST_REGION_SUM_OF_MAGNITUDES = 1
OBC_TRUST_REGION_MAX_MAGNITUDE = 2
OBC_TRUST_REGION_MAX_VALUE = 3

OBC_TRUST_REGION_NEED_VALUES = 1
OBC_TRUST_REGION_ITERATION = 2
OBC_TRUST_REGION_DONE = 3

OBC_TRUST_REGION_RUNNING = 0
OBC_TRUST_REGION_CONVERGED = 1
OBC_TRUST_REGION_TARGET_REACHED = 2
OBC_TRUST_REGION_EVALUATION_BUDGET = 3
OBC_TRUST_REGION_NOISE_LIMIT = 4
OBC_TRUST_REGION_STALLED = 5
OBC_TRUST_REGION_CANCELLED = 6
OBC_TRUST_REGION_EVALUATION_FAILED = 7
OBC_TRUST_REGION_RESOLUTION_LIMIT = 8

OBC_TRUST_REGION_CONTINUE = 0
OBC_TRUST_REGION_STOP = 1
OBC_TRUST_REGION_FAILED = 2

obc_trust_region_function = _c.CFUNCTYPE(_c.c_int32, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p)


class obc_trust_region_problem(_Struct):
    """The problem. Arrays are copied. Fill with _problem_init, or with zeros and struct_size, which is the same: in C99
    {.struct_size = sizeof(obc_trust_region_problem), .n = 2}."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("n", _c.c_size_t),
        ("residuals", _c.c_size_t),
        ("lower", _c.c_void_p),
        ("upper", _c.c_void_p),
        ("scale", _c.c_void_p),
        ("sign", _c.c_void_p),
        ("objective", _c.c_int32),
    ]


class obc_trust_region_options(_Struct):
    """Options of a run. Fill with _options_init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("method", _c.c_int32),
        ("start", _c.c_int32),
        ("points", _c.c_uint64),
        ("radius_begin", _c.c_double),
        ("radius_end", _c.c_double),
        ("target", _c.c_double),
        ("noise_absolute", _c.c_double),
        ("noise_relative", _c.c_double),
        ("restarts", _c.c_uint64),
        ("max_evaluations", _c.c_uint64),
    ]


class obc_trust_region_result(_Struct):
    """State of a run. The caller sets struct_size."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("stop", _c.c_int32),
        ("value", _c.c_double),
        ("radius", _c.c_double),
        ("resolution", _c.c_double),
        ("evaluations", _c.c_uint64),
        ("failed_evaluations", _c.c_uint64),
        ("iterations", _c.c_uint64),
        ("restarts", _c.c_uint64),
        ("points", _c.c_uint64),
        ("rebuilds", _c.c_uint64),
    ]


_functions = [
    ("obc_trust_region_problem_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_trust_region_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_trust_region_create", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_trust_region_give", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p]),
    ("obc_trust_region_step", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_trust_region_tell", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_trust_region_get_result", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_trust_region_save_size", _c.c_size_t, [_c.c_void_p]),
    ("obc_trust_region_save", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p]),
    ("obc_trust_region_load", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_trust_region_destroy", None, [_c.c_void_p]),
    ("obc_trust_region_minimize", _c.c_int32, [_c.c_void_p, _c.c_void_p, obc_trust_region_function, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_trust_region_stop_name", _c.c_char_p, [_c.c_int32]),
    ("obc_trust_region_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("trust_region", ["base"], _functions, globals(), name)
