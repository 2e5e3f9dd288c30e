"""What <orbicube/hexmesh.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct

OBC_HEXMESH_PADDING_AUTO = 0
OBC_HEXMESH_PADDING_WITH = 1
OBC_HEXMESH_PADDING_WITHOUT = 2

OBC_HEXMESH_METHOD_AUTO = 0
OBC_HEXMESH_METHOD_POLYCUBE = 1
OBC_HEXMESH_METHOD_GRID = 2
OBC_HEXMESH_METHOD_FRAMES = 3

OBC_HEXMESH_FEATURES_OFF = 0
OBC_HEXMESH_FEATURES_AUTO = 1
OBC_HEXMESH_FEATURES_TAGS = 2
OBC_HEXMESH_FEATURES_ANGLES = 3
OBC_HEXMESH_FEATURES_MACHINED = 4

obc_hexmesh_fill_function = _c.CFUNCTYPE(_c.c_int32, _c.c_void_p, _c.c_double, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p)


class obc_hexmesh_options(_Struct):
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
        ("features", _c.c_int32),
        ("tagged_edges", _c.c_void_p),
        ("tagged_edge_count", _c.c_size_t),
        ("tagged_vertices", _c.c_void_p),
        ("tagged_vertex_count", _c.c_size_t),
        ("fill", obc_hexmesh_fill_function),
        ("fill_user", _c.c_void_p),
        ("regions", _c.c_void_p),
        ("region_count", _c.c_size_t),
    ]


class obc_hexmesh_report(_Struct):
    """Figures of a hexahedral mesh. The scaled Jacobian of a hexahedron is the minimum over its corners of the determinant of the
    three edges there over the product of their lengths: 1 for a box. Members from integers_optimal to fields are about frames and 0 for other
    methods; those after them are about features and 0 where none are kept. The caller sets struct_size."""
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
        ("method", _c.c_int32),
        ("integers_optimal", _c.c_int32),
        ("singular_edges", _c.c_size_t),
        ("irregular_edges", _c.c_size_t),
        ("integers", _c.c_size_t),
        ("tetrahedra", _c.c_size_t),
        ("inverted_at_start", _c.c_size_t),
        ("steps", _c.c_size_t),
        ("fields", _c.c_size_t),
        ("feature_curves", _c.c_size_t),
        ("feature_corners", _c.c_size_t),
        ("missing_features", _c.c_size_t),
        ("captured", _c.c_double),
        ("scaled_jacobian_bound", _c.c_double),
        ("embedded", _c.c_int32),
        ("conforming", _c.c_int32),
        ("region_quads", _c.c_size_t),
        ("region_hausdorff_percent", _c.c_double),
    ]


class obc_hexmesh_missing(_Struct):
    """A feature that the mesh lacks: a corner, or a curve with less than 95 % of its length captured. The caller sets struct_size."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("corner", _c.c_int32),
        ("first", _c.c_double * 3),
        ("last", _c.c_double * 3),
        ("captured", _c.c_double),
    ]


_functions = [
    ("obc_hexmesh_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_hexmesh_compute", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_hexmesh_compute_solid", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_hexmesh_destroy", None, [_c.c_void_p]),
    ("obc_hexmesh_vertex_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_hexmesh_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_hexmesh_quad_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_hexmesh_copy", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_hexmesh_copy_regions", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_hexmesh_missing_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_hexmesh_get_missing", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p]),
    ("obc_hexmesh_missing_reason", _c.c_char_p, [_c.c_void_p, _c.c_size_t]),
    ("obc_hexmesh_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("hexmesh", ["base", "mesh"], _functions, globals(), name)
