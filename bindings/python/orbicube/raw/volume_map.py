"""What <orbicube/volume_map.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct

OBC_VOLUME_MAP_PADDING_AUTO = 0
OBC_VOLUME_MAP_PADDING_WITH = 1
OBC_VOLUME_MAP_PADDING_WITHOUT = 2

OBC_VOLUME_MAP_METHOD_AUTO = 0
OBC_VOLUME_MAP_METHOD_POLYCUBE = 1
OBC_VOLUME_MAP_METHOD_GRID = 2


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


class obc_volume_map_hexes_options(_Struct):
    """Options of a hexahedral mesh. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("padding", _c.c_int32),
        ("cells", _c.c_size_t),
        ("corners", _c.c_size_t),
        ("triangles", _c.c_size_t),
        ("seed", _c.c_uint64),
        ("rounds", _c.c_int32),
        ("method", _c.c_int32),
        ("max_hausdorff_percent", _c.c_double),
        ("max_cells", _c.c_size_t),
        ("feature_angle", _c.c_double),
    ]


class obc_volume_map_hexes_report(_Struct):
    """Figures of a hexahedral mesh. The scaled Jacobian of a hexahedron is the minimum over its corners of the determinant of the
    three edges there over the product of their lengths: 1 for a box. The caller sets struct_size."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("padded", _c.c_int32),
        ("min_scaled_jacobian", _c.c_double),
        ("mean_scaled_jacobian", _c.c_double),
        ("volume", _c.c_double),
        ("polycube_corners", _c.c_size_t),
        ("off_surface", _c.c_size_t),
        ("hausdorff_percent", _c.c_double),
        ("volume_error_percent", _c.c_double),
        ("follows_sharp_edges", _c.c_int32),
        ("grid_based", _c.c_int32),
    ]


class obc_volume_map_frame_options(_Struct):
    """Options of a frame-guided hexahedral mesh. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("rounds", _c.c_int32),
        ("cells", _c.c_size_t),
        ("feature_angle", _c.c_double),
        ("max_hausdorff_percent", _c.c_double),
        ("max_cells", _c.c_size_t),
    ]


class obc_volume_map_frame_report(_Struct):
    """Figures of a frame-guided hexahedral mesh. The caller sets struct_size."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("integers_optimal", _c.c_int32),
        ("min_scaled_jacobian", _c.c_double),
        ("mean_scaled_jacobian", _c.c_double),
        ("volume", _c.c_double),
        ("off_surface", _c.c_size_t),
        ("singular_edges", _c.c_size_t),
        ("irregular_edges", _c.c_size_t),
        ("integers", _c.c_size_t),
        ("tetrahedra", _c.c_size_t),
        ("inverted_at_start", _c.c_size_t),
        ("steps", _c.c_size_t),
        ("hausdorff_percent", _c.c_double),
        ("volume_error_percent", _c.c_double),
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
    ("obc_volume_map_hexes_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_volume_map_hexes_compute", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_volume_map_hexes_destroy", None, [_c.c_void_p]),
    ("obc_volume_map_hexes_vertex_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_volume_map_hexes_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_volume_map_hexes_quad_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_volume_map_hexes_copy", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_volume_map_frame_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_volume_map_frame_hexes_compute", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_volume_map_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("volume_map", ["base", "mesh"], _functions, globals(), name)
