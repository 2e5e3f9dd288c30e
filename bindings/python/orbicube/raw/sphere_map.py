"""What <orbicube/sphere_map.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct

OBC_SPHERE_MAP_BALANCED = 0
OBC_SPHERE_MAP_ANGLE_AREA = 1
OBC_SPHERE_MAP_ISOMETRIC = 2
OBC_SPHERE_MAP_STRETCH = 3
OBC_SPHERE_MAP_CONFORMAL = 4
OBC_SPHERE_MAP_DISSERTATION = 5

OBC_SPHERE_MAP_ICOSPHERE = 0
OBC_SPHERE_MAP_CUBE = 1
OBC_SPHERE_MAP_LATITUDE = 2
OBC_SPHERE_MAP_OCTAHEDRON = 3

obc_sphere_map_trace_function = _c.CFUNCTYPE(None, _c.c_uint64, _c.c_uint64, _c.c_double, _c.c_void_p)


class obc_sphere_map_options(_Struct):
    """Options of a map. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("method", _c.c_int32),
        ("angle_weight", _c.c_double),
        ("area_weight", _c.c_double),
        ("seed", _c.c_uint64),
        ("trace", obc_sphere_map_trace_function),
        ("trace_user", _c.c_void_p),
        ("level_splits", _c.c_uint64),
        ("level_tolerance", _c.c_double),
        ("final_tolerance", _c.c_double),
        ("max_level_iterations", _c.c_uint64),
        ("max_final_iterations", _c.c_uint64),
    ]


class obc_sphere_map_report(_Struct):
    """Figures of a map, for a surface scaled to the area of the unit sphere, 4 pi. sigma_1 >= sigma_2 are the singular values of the affine
    map from a surface triangle T to its flat spherical triangle t, d is the distance of t from the origin. Vertices in no
    triangle do not count. Energies, distortions, ratios and means leave out degenerate triangles, whose angles are rounding errors:
    those with a height of at most 1e-6 of the longest side, or at most 4 rounding units of the largest coordinate (2^-24 of it where
    all coordinates of the surface are float32 values, otherwise 2^-53)."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("bijective", _c.c_int32),
        ("mirrored", _c.c_int32),
        ("reserved", _c.c_int32),
        ("flipped", _c.c_uint64),
        ("degenerate", _c.c_uint64),
        ("zero_area_faces", _c.c_uint64),
        ("degree", _c.c_double),
        ("energy_angle", _c.c_double),
        ("energy_area", _c.c_double),
        ("energy", _c.c_double),
        ("max_quasi_conformal", _c.c_double),
        ("mean_quasi_conformal", _c.c_double),
        ("min_area_ratio", _c.c_double),
        ("max_area_ratio", _c.c_double),
        ("stretch_efficiency", _c.c_double),
        ("isometric_mean", _c.c_double),
        ("equation_3_1", _c.c_double),
        ("equation_3_2", _c.c_double),
        ("equation_3_3", _c.c_double),
        ("equation_3_4", _c.c_double),
    ]


_functions = [
    ("obc_sphere_map_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_sphere_map_report_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_sphere_map_compute", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_compute_partial", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_measure", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_face_distortion", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_round_to_float", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_locator_create", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_locator_destroy", None, [_c.c_void_p]),
    ("obc_sphere_map_locate", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_sample", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_size_t, _c.c_int32, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_grid", _c.c_int32, [_c.c_int32, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_remesh", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_int32, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_image_size", _c.c_int32, [_c.c_int32, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_image", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_int32, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_image_surface", _c.c_int32, [_c.c_void_p, _c.c_int32, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_image_write", _c.c_int32, [_c.c_char_p, _c.c_void_p, _c.c_int32, _c.c_size_t, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_image_read", _c.c_int32, [_c.c_char_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p]),
    ("obc_sphere_map_best_rotation", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_warp_create", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_warp_destroy", None, [_c.c_void_p]),
    ("obc_sphere_map_warp_apply", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_int32, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_overlay", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_sphere_map_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("sphere_map", ["base", "mesh"], _functions, globals(), name)
