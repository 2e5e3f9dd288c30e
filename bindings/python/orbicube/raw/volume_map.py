"""What <orbicube/volume_map.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct


class obc_volume_map_solid_options(_Struct):
    """Options of a map of a solid. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("reserved", _c.c_int32),
        ("corners", _c.c_size_t),
        ("seed", _c.c_uint64),
    ]


class obc_volume_map_frame_map_options(_Struct):
    """Options of a parameterization. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("integer", _c.c_int32),
        ("cell_length", _c.c_double),
        ("feature_angle", _c.c_double),
    ]


class obc_volume_map_frame_map_report(_Struct):
    """Figures of a parameterization."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("integers_optimal", _c.c_int32),
        ("energy", _c.c_double),
        ("integer_cost", _c.c_double),
        ("residual", _c.c_double),
        ("cell_length", _c.c_double),
        ("inverted", _c.c_uint64),
        ("integers", _c.c_uint64),
        ("patches", _c.c_uint64),
        ("cut_faces", _c.c_uint64),
        ("singular_edges", _c.c_uint64),
        ("solves", _c.c_uint64),
    ]


_functions = [
    ("obc_volume_map_solid_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_volume_map_solid_compute", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_volume_map_solid_destroy", None, [_c.c_void_p]),
    ("obc_volume_map_solid_vertex_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_volume_map_solid_tetrahedron_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_volume_map_solid_copy", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_volume_map_frame_map_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_volume_map_frame_map_report_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_volume_map_frame_map_compute", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_volume_map_frame_map_destroy", None, [_c.c_void_p]),
    ("obc_volume_map_frame_map_tetrahedron_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_volume_map_frame_map_singular_edge_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_volume_map_frame_map_copy", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_volume_map_locator_create", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_volume_map_locator_destroy", None, [_c.c_void_p]),
    ("obc_volume_map_locator_locate", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_volume_map_locator_interpolate", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_volume_map_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("volume_map", ["base", "mesh"], _functions, globals(), name)
