"""What <orbicube/untangle.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct


class obc_untangle_options(_Struct):
    """Options. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("max_steps", _c.c_int32),
        ("max_polish_steps", _c.c_int32),
        ("free_boundary", _c.c_int32),
        ("volume_weight", _c.c_double),
        ("tolerance", _c.c_double),
    ]


class obc_untangle_report(_Struct):
    """Figures of a run. Determinants are those of the maps from the target shapes, scaled so that 1 preserves volume or area."""
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


class obc_untangle_tetrahedra_problem(_Struct):
    """A tetrahedral mesh to untangle, with its constraints: a view of arrays of the caller. Coordinate 3 * vertex + axis is that of an axis
    of a vertex. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("reserved", _c.c_int32),
        ("positions", _c.c_void_p),
        ("vertex_count", _c.c_size_t),
        ("tetrahedra", _c.c_void_p),
        ("tetrahedron_count", _c.c_size_t),
        ("rest", _c.c_void_p),
        ("fixed", _c.c_void_p),
        ("fixed_coordinates", _c.c_void_p),
        ("ties", _c.c_void_p),
    ]


class obc_untangle_triangles_problem(_Struct):
    """A flat mesh of triangles to untangle, such as a map of a surface to the plane, with its constraints: a view of arrays of the caller.
    Coordinate 2 * vertex + axis is that of an axis of a vertex. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("reserved", _c.c_int32),
        ("positions", _c.c_void_p),
        ("vertex_count", _c.c_size_t),
        ("triangles", _c.c_void_p),
        ("triangle_count", _c.c_size_t),
        ("rest", _c.c_void_p),
        ("fixed", _c.c_void_p),
        ("fixed_coordinates", _c.c_void_p),
        ("ties", _c.c_void_p),
    ]


_functions = [
    ("obc_untangle_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_untangle_report_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_untangle_tetrahedra_problem_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_untangle_tetrahedra", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_untangle_triangles_problem_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_untangle_triangles", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_untangle_refine_tetrahedra", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_untangle_refine_triangles", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_untangle_refined_destroy", None, [_c.c_void_p]),
    ("obc_untangle_refined_vertex_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_untangle_refined_element_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_untangle_refined_copy", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_untangle_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("untangle", ["base"], _functions, globals(), name)
