"""What <orbicube/sphere_optimizer.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct

OBC_SPHERE_OPTIMIZER_LIMITED_MEMORY = 0
OBC_SPHERE_OPTIMIZER_BARZILAI_BORWEIN = 1
OBC_SPHERE_OPTIMIZER_GREAT_CIRCLE = 2
OBC_SPHERE_OPTIMIZER_DISSERTATION = 3
OBC_SPHERE_OPTIMIZER_TRUNCATED_NEWTON = 4

OBC_SPHERE_OPTIMIZER_NEED_FG = 1
OBC_SPHERE_OPTIMIZER_ITERATION = 2
OBC_SPHERE_OPTIMIZER_DONE = 3
OBC_SPHERE_OPTIMIZER_NEED_PRODUCT = 4

OBC_SPHERE_OPTIMIZER_RUNNING = 0
OBC_SPHERE_OPTIMIZER_CONVERGED = 1
OBC_SPHERE_OPTIMIZER_TARGET_REACHED = 2
OBC_SPHERE_OPTIMIZER_EVALUATION_BUDGET = 3
OBC_SPHERE_OPTIMIZER_ITERATION_BUDGET = 4
OBC_SPHERE_OPTIMIZER_STALLED = 5
OBC_SPHERE_OPTIMIZER_CANCELLED = 6
OBC_SPHERE_OPTIMIZER_EVALUATION_FAILED = 7

OBC_SPHERE_OPTIMIZER_CONTINUE = 0
OBC_SPHERE_OPTIMIZER_STOP = 1
OBC_SPHERE_OPTIMIZER_FAILED = 2

OBC_SPHERE_OPTIMIZER_AUTOMATIC = 0
OBC_SPHERE_OPTIMIZER_QUEUE = 1
OBC_SPHERE_OPTIMIZER_SWEEPS = 2

obc_sphere_optimizer_function = _c.CFUNCTYPE(_c.c_int32, _c.c_void_p, _c.c_size_t, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p)

obc_sphere_optimizer_product_function = _c.CFUNCTYPE(_c.c_int32, _c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_size_t, _c.c_void_p, _c.c_void_p)

obc_sphere_optimizer_block_function = _c.CFUNCTYPE(_c.c_int32, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p)


class obc_sphere_optimizer_options(_Struct):
    """Options of an all-at-once run. Fill with _options_init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("method", _c.c_int32),
        ("memory", _c.c_uint32),
        ("history", _c.c_uint32),
        ("gradient_tolerance", _c.c_double),
        ("target", _c.c_double),
        ("max_evaluations", _c.c_uint64),
        ("max_iterations", _c.c_uint64),
        ("starts", _c.c_uint64),
        ("seed", _c.c_uint64),
        ("hessian_products", _c.c_int32),
    ]


class obc_sphere_optimizer_result(_Struct):
    """State of a run. The caller sets struct_size."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("stop", _c.c_int32),
        ("value", _c.c_double),
        ("gradient_norm", _c.c_double),
        ("evaluations", _c.c_uint64),
        ("failed_evaluations", _c.c_uint64),
        ("iterations", _c.c_uint64),
        ("starts", _c.c_uint64),
        ("best_start", _c.c_uint64),
        ("products", _c.c_uint64),
    ]


class obc_sphere_optimizer_blocks(_Struct):
    """The spheres and their adjacency. Fill with _blocks_init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("dimension", _c.c_uint32),
        ("count", _c.c_size_t),
        ("neighbor_start", _c.c_void_p),
        ("neighbor", _c.c_void_p),
    ]


class obc_sphere_optimizer_relaxation_options(_Struct):
    """Options of a relaxation. Fill with _relaxation_options_init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("method", _c.c_int32),
        ("second_order", _c.c_int32),
        ("order", _c.c_int32),
        ("gradient_tolerance", _c.c_double),
        ("relative_gain", _c.c_double),
        ("over_relaxation", _c.c_double),
        ("max_passes", _c.c_uint64),
    ]


class obc_sphere_optimizer_relaxation_result(_Struct):
    """State of a relaxation. The caller sets struct_size."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("stop", _c.c_int32),
        ("gain", _c.c_double),
        ("gradient_norm", _c.c_double),
        ("steps", _c.c_uint64),
        ("evaluations", _c.c_uint64),
        ("failed_steps", _c.c_uint64),
        ("over_relaxation", _c.c_double),
    ]


_functions = [
    ("obc_sphere_optimizer_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_sphere_optimizer_create", _c.c_int32, [_c.c_size_t, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_optimizer_step", _c.c_int32, [_c.c_void_p, _c.c_void_p]),
    ("obc_sphere_optimizer_tell", _c.c_int32, [_c.c_void_p, _c.c_double, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_optimizer_get_direction", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_optimizer_tell_product", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_optimizer_get_result", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_optimizer_get_shape", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_optimizer_save_size", _c.c_size_t, [_c.c_void_p]),
    ("obc_sphere_optimizer_save", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p]),
    ("obc_sphere_optimizer_load", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_optimizer_destroy", None, [_c.c_void_p]),
    ("obc_sphere_optimizer_minimize", _c.c_int32, [_c.c_size_t, _c.c_size_t, _c.c_void_p, obc_sphere_optimizer_function, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_optimizer_minimize_second_order", _c.c_int32, [_c.c_size_t, _c.c_size_t, _c.c_void_p, obc_sphere_optimizer_function, obc_sphere_optimizer_product_function, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_optimizer_blocks_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_sphere_optimizer_relaxation_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_sphere_optimizer_relax", _c.c_int32, [_c.c_void_p, _c.c_void_p, obc_sphere_optimizer_block_function, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_optimizer_relaxation_create", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_optimizer_relaxation_run", _c.c_int32, [_c.c_void_p, obc_sphere_optimizer_block_function, _c.c_void_p, _c.c_uint64, _c.c_void_p]),
    ("obc_sphere_optimizer_relaxation_get_result", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_optimizer_relaxation_save_size", _c.c_size_t, [_c.c_void_p]),
    ("obc_sphere_optimizer_relaxation_save", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p]),
    ("obc_sphere_optimizer_relaxation_load", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_optimizer_relaxation_destroy", None, [_c.c_void_p]),
    ("obc_sphere_optimizer_stop_name", _c.c_char_p, [_c.c_int32]),
    ("obc_sphere_optimizer_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("sphere_optimizer", ["base"], _functions, globals(), name)
