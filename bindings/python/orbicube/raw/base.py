"""What <orbicube/base.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct

OBC_OK = 0
OBC_INVALID_ARGUMENT = -1
OBC_MALFORMED_FILE = -2
OBC_NOT_CLOSED = -3
OBC_NOT_MANIFOLD = -4
OBC_WRONG_GENUS = -5
OBC_DEGENERATE = -6
OBC_OUT_OF_MEMORY = -7
OBC_CANCELLED = -8
OBC_IO = -9
OBC_UNSUPPORTED = -10
OBC_NO_VALID_RESULT = -11
OBC_INTERNAL = -12

obc_progress_function = _c.CFUNCTYPE(_c.c_int32, _c.c_char_p, _c.c_uint64, _c.c_uint64, _c.c_double, _c.c_void_p)

obc_log_function = _c.CFUNCTYPE(None, _c.c_char_p, _c.c_void_p)

obc_parallel_for_function = _c.CFUNCTYPE(None, _c.c_size_t, _c.CFUNCTYPE(None, _c.c_size_t, _c.c_void_p), _c.c_void_p, _c.c_void_p)


class obc_error(_Struct):
    """Description of a failure, in memory of the caller. A failing function fills it; a successful one clears it."""
    _fields_ = [
        ("status", _c.c_int32),
        ("kind", _c.c_char * 28),
        ("message", _c.c_char * 480),
    ]


class obc_allocator(_Struct):
    """Memory of the program for the allocations of the libraries. Both functions must be thread-safe."""
    _fields_ = [
        ("allocate", _c.CFUNCTYPE(_c.c_void_p, _c.c_size_t, _c.c_size_t, _c.c_void_p)),
        ("release", _c.CFUNCTYPE(None, _c.c_void_p, _c.c_size_t, _c.c_size_t, _c.c_void_p)),
        ("user", _c.c_void_p),
    ]


class obc_host(_Struct):
    """Resources of the program that a computation uses. Fill with obc_host_init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("thread_count", _c.c_uint32),
        ("progress", obc_progress_function),
        ("progress_user", _c.c_void_p),
        ("log", obc_log_function),
        ("log_user", _c.c_void_p),
        ("parallel_for", obc_parallel_for_function),
        ("parallel_for_user", _c.c_void_p),
        ("allocator", _c.c_void_p),
        ("fraction", _c.c_void_p),
    ]


_functions = [
    ("obc_host_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_status_name", _c.c_char_p, [_c.c_int32]),
    ("obc_base_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("base", [], _functions, globals(), name)
