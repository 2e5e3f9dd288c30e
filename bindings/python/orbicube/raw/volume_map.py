"""What <orbicube/volume_map.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct


class obc_volume_map_untangle_problem(_Struct):
    """A mesh to untangle, with its constraints: a view of arrays of the caller. Coordinate 3 * vertex + axis is that of an axis of a vertex. Fill with
    _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("reserved", _c.c_int32),
        ("positions", _c.c_void_p),
        ("vertex_count", _c.c_size_t),
        ("tetrahedra", _c.c_void_p),
        ("tetrahedron_count", _c.c_size_t),
        ("rest", _c.c_void_p),
        ("fixed", _c.c_void_p),
        ("ties", _c.c_void_p),
    ]


class obc_volume_map_untangle_options(_Struct):
    """Options of untangling. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("steps", _c.c_int32),
        ("polish_steps", _c.c_int32),
        ("reserved", _c.c_int32),
        ("volume_weight", _c.c_double),
    ]


class obc_volume_map_untangle_report(_Struct):
    """Figures of untangling. Determinants are those of the maps from the target shapes, scaled so that 1 preserves the volume."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("first_inverted", _c.c_uint32),
        ("inverted_before", _c.c_uint64),
        ("inverted", _c.c_uint64),
        ("steps", _c.c_uint64),
        ("polish_steps", _c.c_uint64),
        ("min_determinant", _c.c_double),
        ("max_determinant", _c.c_double),
        ("energy", _c.c_double),
    ]


class obc_volume_map_solid_options(_Struct):
    """Options of a map of a solid. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("reserved", _c.c_int32),
        ("corners", _c.c_size_t),
        ("seed", _c.c_uint64),
    ]


_functions = [
    ("obc_volume_map_untangle_problem_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_volume_map_untangle_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_volume_map_untangle_report_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_volume_map_untangle", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_volume_map_solid_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_volume_map_solid_compute", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_volume_map_solid_destroy", None, [_c.c_void_p]),
    ("obc_volume_map_solid_vertex_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_volume_map_solid_tetrahedron_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_volume_map_solid_copy", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_volume_map_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("volume_map", ["base", "mesh"], _functions, globals(), name)
