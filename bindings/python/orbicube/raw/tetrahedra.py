"""What <orbicube/tetrahedra.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct


class obc_tetrahedra_options(_Struct):
    """Quality and size of tetrahedra. TetGen inserts vertices until the bounds are satisfied, except where the surface prevents it; its last
    step, flips and moves for better angles, may exceed the bounds slightly at a few tetrahedra. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("keep_surface", _c.c_int32),
        ("quality", _c.c_double),
        ("max_volume", _c.c_double),
        ("edge_length", _c.c_double),
        ("size_positions", _c.c_void_p),
        ("size_lengths", _c.c_void_p),
        ("size_count", _c.c_size_t),
        ("size_growth", _c.c_double),
    ]


_functions = [
    ("obc_tetrahedra_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_tetrahedra_fill", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_tetrahedra_fill_mesh", _c.c_int32, [_c.c_void_p, _c.c_double, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_tetrahedra_destroy", None, [_c.c_void_p]),
    ("obc_tetrahedra_vertex_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_tetrahedra_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_tetrahedra_boundary_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_tetrahedra_part_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_tetrahedra_cavity_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_tetrahedra_copy", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_tetrahedra_check_surface", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p]),
    ("obc_tetrahedra_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("tetrahedra", ["base", "mesh"], _functions, globals(), name)
