"""What <orbicube/polycube.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct

OBC_POLYCUBE_AUTO = 0
OBC_POLYCUBE_LABELS = 1
OBC_POLYCUBE_VOXELS = 2
OBC_POLYCUBE_DISSERTATION = 3

OBC_POLYCUBE_SURFACE_MEAN = 0
OBC_POLYCUBE_FACE_MEAN = 1
OBC_POLYCUBE_HARMONIC = 2

OBC_POLYCUBE_TRUST_REGION = 0
OBC_POLYCUBE_GRADIENT = 1


class obc_polycube_certificate(_Struct):
    """Findings of the certification. The caller sets struct_size."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("valid", _c.c_int32),
        ("genus", _c.c_int64),
        ("corners", _c.c_size_t),
        ("patches", _c.c_size_t),
        ("reason", _c.c_char * 256),
    ]


class obc_polycube_options(_Struct):
    """Options of the construction. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("construction", _c.c_int32),
        ("corners", _c.c_size_t),
        ("seed", _c.c_uint64),
        ("area_weight", _c.c_double),
        ("rounds", _c.c_uint32),
    ]


class obc_polycube_domain_options(_Struct):
    """Options of the optimization of proportions. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("measure", _c.c_int32),
        ("area_weight", _c.c_double),
    ]


class obc_polycube_domain_report(_Struct):
    """Figures of the optimization of proportions. Angle distortion is the harmonic energy over the area on the polycube, area distortion
    (r + 1/r) / 2 for the ratio r of areas at equal total areas; their means, without degenerate triangles (see
    obc_sphere_map_report), are 1 for an isometry. The caller sets struct_size."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("converged", _c.c_int32),
        ("energy_before", _c.c_double),
        ("energy", _c.c_double),
        ("evaluations", _c.c_uint64),
        ("layers", _c.c_size_t),
        ("cells", _c.c_size_t),
        ("crossing", _c.c_size_t),
        ("angle_mean", _c.c_double),
        ("area_mean", _c.c_double),
        ("angle_weighted_mean", _c.c_double),
        ("area_weighted_mean", _c.c_double),
    ]


class obc_polycube_corner_options(_Struct):
    """Options of the optimization of corners. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("method", _c.c_int32),
        ("area_weight", _c.c_double),
        ("domain", _c.c_int32),
        ("rounds", _c.c_int32),
    ]


class obc_polycube_corner_report(_Struct):
    """Figures of the optimization of corners. Energies are means over the surface of angle + area_weight * area distortion, as in the
    domain report. The caller sets struct_size."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("converged", _c.c_int32),
        ("energy_before", _c.c_double),
        ("energy", _c.c_double),
        ("evaluations", _c.c_uint64),
        ("map_evaluations", _c.c_double),
        ("moves", _c.c_size_t),
        ("movable", _c.c_size_t),
        ("angle_mean", _c.c_double),
        ("area_mean", _c.c_double),
        ("angle_weighted_mean", _c.c_double),
        ("area_weighted_mean", _c.c_double),
    ]


class obc_polycube_feature_options(_Struct):
    """Features: vertices and curves of the map with target positions on its polycube. A weight multiplies the squared distance, as a fraction of
    the polycube's area, next to a distortion that is 2 for an isometry; weight 0, or no weights, enforces the target exactly. Fill with
    _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("point_count", _c.c_size_t),
        ("points", _c.c_void_p),
        ("targets", _c.c_void_p),
        ("point_weights", _c.c_void_p),
        ("curve_count", _c.c_size_t),
        ("curve_starts", _c.c_void_p),
        ("curve_vertices", _c.c_void_p),
        ("curve_lines", _c.c_void_p),
        ("curve_weights", _c.c_void_p),
        ("feature_angle", _c.c_double),
    ]


class obc_polycube_feature_report(_Struct):
    """Figures of the alignment. Lengths of sharp edges are lengths on the surface. The caller sets struct_size."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("distance_before", _c.c_double),
        ("distance", _c.c_double),
        ("sharp_length", _c.c_double),
        ("sharp_before", _c.c_double),
        ("sharp", _c.c_double),
        ("angle_mean", _c.c_double),
        ("area_mean", _c.c_double),
        ("angle_weighted_mean", _c.c_double),
        ("area_weighted_mean", _c.c_double),
    ]


class obc_polycube_constraints(_Struct):
    """Positional constraints of corners, for obc_polycube_map_to_domain."""
    _fields_ = [
        ("corners", _c.c_void_p),
        ("vertices", _c.c_void_p),
        ("points", _c.c_void_p),
        ("count", _c.c_size_t),
    ]


class obc_polycube_quads_options(_Struct):
    """Resolution of a quad mesh. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("quads", _c.c_size_t),
        ("edge_length", _c.c_double),
    ]


class obc_polycube_atlas_options(_Struct):
    """Options of an atlas. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("size", _c.c_uint32),
        ("padding", _c.c_double),
    ]


_functions = [
    ("obc_polycube_create", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_polycube_compute", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_domain_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_polycube_optimize_domain", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_corner_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_polycube_optimize_corners", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_feature_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_polycube_align_features", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_energy_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_polycube_copy_energies", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_destroy", None, [_c.c_void_p]),
    ("obc_polycube_vertex_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_polycube_triangle_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_polycube_corner_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_polycube_patch_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_polycube_construction", _c.c_int32, [_c.c_void_p]),
    ("obc_polycube_corner_points", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_copy", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_copy_triangles", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_copy_sources", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_map_to_domain", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_compute_common", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_optimize_common_domain", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_graph_create", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_graph_destroy", None, [_c.c_void_p]),
    ("obc_polycube_graph_corner_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_polycube_graph_edge_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_polycube_graph_patch_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_polycube_graph_loop_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_polycube_graph_link_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_polycube_graph_copy_corners", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_graph_copy_edges", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_graph_copy_patches", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_graph_copy_loops", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_graph_copy_dual", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_quads_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_polycube_quads_create", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_quads_destroy", None, [_c.c_void_p]),
    ("obc_polycube_quads_vertex_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_polycube_quads_quad_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_polycube_quads_copy", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_quads_copy_sources", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_atlas_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_polycube_atlas_create", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_atlas_destroy", None, [_c.c_void_p]),
    ("obc_polycube_atlas_size", _c.c_uint32, [_c.c_void_p]),
    ("obc_polycube_atlas_triangle_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_polycube_atlas_copy", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_atlas_sample", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_polycube_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("polycube", ["base", "mesh"], _functions, globals(), name)
