"""What <orbicube/linear.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct

OBC_LINEAR_AUTO = 0
OBC_LINEAR_EIGEN = 1
OBC_LINEAR_CHOLMOD_SIMPLICIAL = 2
OBC_LINEAR_CHOLMOD_SUPERNODAL = 3

OBC_LINEAR_ITERATIVE_AUTO = 0
OBC_LINEAR_GAUSS_SEIDEL = 1
OBC_LINEAR_MULTIGRID = 2


class obc_linear_matrix(_Struct):
    """The lower triangle of a symmetric matrix in compressed rows: a view, which functions copy if they need it after they return.
    Row i has the entries row_begin[i] to row_begin[i + 1] - 1. Its columns ascend; the last one is i, the diagonal."""
    _fields_ = [
        ("size", _c.c_size_t),
        ("row_begin", _c.c_void_p),
        ("columns", _c.c_void_p),
        ("values", _c.c_void_p),
    ]


class obc_linear_direct_options(_Struct):
    """Options of a factor. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("method", _c.c_int32),
    ]


class obc_linear_iterative_options(_Struct):
    """Options of an iterative solver. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("method", _c.c_int32),
        ("block_size", _c.c_int32),
        ("max_iterations", _c.c_uint32),
        ("tolerance", _c.c_double),
    ]


class obc_linear_iterative_report(_Struct):
    """Result of an iterative solution. Set struct_size, or fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("converged", _c.c_int32),
        ("iterations", _c.c_uint64),
        ("residual", _c.c_double),
    ]


_functions = [
    ("obc_linear_direct_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_linear_direct_create", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_linear_direct_destroy", None, [_c.c_void_p]),
    ("obc_linear_direct_refactor", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p]),
    ("obc_linear_direct_solve", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_linear_direct_remove_row", _c.c_int32, [_c.c_void_p, _c.c_uint32, _c.c_void_p]),
    ("obc_linear_direct_update", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_int32, _c.c_void_p]),
    ("obc_linear_direct_entry_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_linear_iterative_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_linear_iterative_report_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_linear_iterative_create", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_linear_iterative_destroy", None, [_c.c_void_p]),
    ("obc_linear_iterative_solve", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_linear_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("linear", ["base"], _functions, globals(), name)
