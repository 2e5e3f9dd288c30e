"""What <orbicube/correspondence.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct

OBC_CORRESPONDENCE_SPHERE = 0
OBC_CORRESPONDENCE_POLYCUBE = 1

OBC_CORRESPONDENCE_ALIGN_SHAPE = 0
OBC_CORRESPONDENCE_ALIGN_ROTATION = 1
OBC_CORRESPONDENCE_ALIGN_NONE = 2

OBC_CORRESPONDENCE_GRID_BOTH = 0
OBC_CORRESPONDENCE_GRID_FIRST = 1
OBC_CORRESPONDENCE_GRID_ICOSPHERE = 2
OBC_CORRESPONDENCE_GRID_CUBE = 3
OBC_CORRESPONDENCE_GRID_LATITUDE = 4
OBC_CORRESPONDENCE_GRID_OCTAHEDRON = 5

OBC_CORRESPONDENCE_KEPT = 0
OBC_CORRESPONDENCE_TURNED = 1
OBC_CORRESPONDENCE_SCALED = 2


class obc_correspondence_options(_Struct):
    """Options of a correspondence. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("via", _c.c_int32),
        ("align", _c.c_int32),
        ("grid", _c.c_int32),
        ("placement", _c.c_int32),
        ("reserved", _c.c_int32),
        ("tolerance", _c.c_double),
        ("cells", _c.c_size_t),
        ("corners", _c.c_size_t),
        ("seed", _c.c_uint64),
        ("resolution", _c.c_size_t),
        ("landmark_count", _c.c_size_t),
        ("landmarks", _c.c_void_p),
    ]


_functions = [
    ("obc_correspondence_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_correspondence_create", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_correspondence_destroy", None, [_c.c_void_p]),
    ("obc_correspondence_shape_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_correspondence_vertex_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_correspondence_triangle_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_correspondence_copy", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_correspondence_blend", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p]),
    ("obc_correspondence_copy_domain", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_correspondence_quad_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_correspondence_copy_quads", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_correspondence_surface_vertex_count", _c.c_size_t, [_c.c_void_p, _c.c_size_t]),
    ("obc_correspondence_map", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_correspondence_map_vertices", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_correspondence_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("correspondence", ["base", "mesh"], _functions, globals(), name)
