"""What <orbicube/gltf.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct


class obc_gltf_read_options(_Struct):
    """Options of reading. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("weld_identical", _c.c_int32),
        ("morph_target", _c.c_char_p),
        ("keep", _c.c_int32),
        ("reserved", _c.c_int32),
    ]


class obc_gltf_morph_target(_Struct):
    """Another shape of the same surface, for obc_gltf_scene."""
    _fields_ = [
        ("name", _c.c_char_p),
        ("positions", _c.c_void_p),
    ]


class obc_gltf_scene(_Struct):
    """Contents of a file. Arrays are not kept after the call. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("smooth_normals", _c.c_int32),
        ("positions", _c.c_void_p),
        ("vertex_count", _c.c_size_t),
        ("triangles", _c.c_void_p),
        ("triangle_count", _c.c_size_t),
        ("normals", _c.c_void_p),
        ("texture_coordinates", _c.c_void_p),
        ("colors", _c.c_void_p),
        ("morph_targets", _c.c_void_p),
        ("morph_target_count", _c.c_size_t),
        ("edges", _c.c_void_p),
        ("edge_count", _c.c_size_t),
        ("translation", _c.c_double * 3),
        ("scale", _c.c_double),
        ("base_color", _c.c_double * 4),
        ("texture", _c.c_void_p),
        ("texture_size", _c.c_size_t),
        ("checker_texture", _c.c_int32),
        ("morph_normals", _c.c_int32),
        ("name", _c.c_char_p),
        ("extras", _c.c_char_p),
        ("morph_seconds", _c.c_double),
        ("kept", _c.c_void_p),
        ("kept_positions", _c.c_void_p),
    ]


_functions = [
    ("obc_gltf_read_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_gltf_read", _c.c_int32, [_c.c_char_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_gltf_read_memory", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_char_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_gltf_surface_vertex_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_gltf_surface_triangle_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_gltf_surface_welded_vertex_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_gltf_surface_note_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_gltf_surface_note", _c.c_char_p, [_c.c_void_p, _c.c_size_t]),
    ("obc_gltf_surface_keeps", _c.c_int32, [_c.c_void_p]),
    ("obc_gltf_surface_copy", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_gltf_surface_destroy", None, [_c.c_void_p]),
    ("obc_gltf_scene_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_gltf_write", _c.c_int32, [_c.c_char_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_gltf_write_kept", _c.c_int32, [_c.c_char_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_gltf_write_surface", _c.c_int32, [_c.c_char_p, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p]),
    ("obc_gltf_delta", _c.c_float, [_c.c_float, _c.c_float]),
    ("obc_gltf_reconstructed", _c.c_float, [_c.c_float, _c.c_float]),
    ("obc_gltf_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("gltf", ["base"], _functions, globals(), name)
