"""What <orbicube/quaternion.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct

OBC_QUATERNION_CUBE_ORDER = 24
OBC_QUATERNION_CUBE_NONE = 255

OBC_QUATERNION_IDENTITY = 0
OBC_QUATERNION_FACE_HALF = 1
OBC_QUATERNION_FACE_QUARTER = 2
OBC_QUATERNION_EDGE_HALF = 3
OBC_QUATERNION_CORNER_THIRD = 4


_functions = [
    ("obc_quaternion_multiply", None, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_inverse", None, [_c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_normalize", None, [_c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_exponential", None, [_c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_logarithm", None, [_c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_slerp", None, [_c.c_void_p, _c.c_void_p, _c.c_double, _c.c_void_p]),
    ("obc_quaternion_average", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_rotate", None, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_from_axis_angle", _c.c_int32, [_c.c_void_p, _c.c_double, _c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_to_axis_angle", None, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_from_rotation_vector", None, [_c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_to_rotation_vector", None, [_c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_to_matrix", None, [_c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_from_matrix", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_nearest_to_matrix", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_cube_element", _c.c_int32, [_c.c_uint32, _c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_cube_matrix", _c.c_int32, [_c.c_uint32, _c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_cube_product", _c.c_uint32, [_c.c_uint32, _c.c_uint32]),
    ("obc_quaternion_cube_inverse", _c.c_uint32, [_c.c_uint32]),
    ("obc_quaternion_cube_class", _c.c_int32, [_c.c_uint32]),
    ("obc_quaternion_cube_nearest", _c.c_uint32, [_c.c_void_p]),
    ("obc_quaternion_symmetric_distance", _c.c_double, [_c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_symmetric_sine_square", _c.c_double, [_c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_symmetric_matching", _c.c_uint32, [_c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_multiply_array", None, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p]),
    ("obc_quaternion_normalize_array", None, [_c.c_void_p, _c.c_size_t, _c.c_void_p]),
    ("obc_quaternion_rotate_array", None, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p]),
    ("obc_quaternion_slerp_array", None, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p]),
    ("obc_quaternion_to_matrix_array", None, [_c.c_void_p, _c.c_size_t, _c.c_void_p]),
    ("obc_quaternion_from_matrix_array", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p]),
    ("obc_quaternion_symmetric_distance_array", None, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p]),
    ("obc_quaternion_symmetric_sine_square_array", None, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p]),
    ("obc_quaternion_symmetric_matching_array", None, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p]),
    ("obc_quaternion_cube_nearest_array", None, [_c.c_void_p, _c.c_size_t, _c.c_void_p]),
    ("obc_quaternion_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("quaternion", ["base"], _functions, globals(), name)
