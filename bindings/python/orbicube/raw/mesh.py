"""What <orbicube/mesh.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct

OBC_MESH_TRIANGLE_REGIONS = 1
OBC_MESH_TETRAHEDRON_REGIONS = 2
OBC_MESH_HEXAHEDRON_REGIONS = 4

OBC_MESH_OBJ = 0
OBC_MESH_OFF = 1
OBC_MESH_PLY = 2
OBC_MESH_STL = 3
OBC_MESH_MEDIT = 4
OBC_MESH_VTK = 5
OBC_MESH_MSH = 6
OBC_MESH_FREESURFER = 7
OBC_MESH_INP = 8
OBC_MESH_VTP = 9
OBC_MESH_VTU = 10
OBC_MESH_GIFTI = 11

OBC_MESH_HOLDS_SURFACES = 1
OBC_MESH_HOLDS_POLYGONS = 2
OBC_MESH_HOLDS_CELLS = 4
OBC_MESH_HOLDS_BINARY = 8
OBC_MESH_HOLDS_REGIONS = 16


class obc_surface(_Struct):
    """A triangle surface: a view of arrays of the caller."""
    _fields_ = [
        ("positions", _c.c_void_p),
        ("vertex_count", _c.c_size_t),
        ("triangles", _c.c_void_p),
        ("triangle_count", _c.c_size_t),
    ]


class obc_mesh_cells(_Struct):
    """Vertices and cells in arrays of the caller, for obc_mesh_create. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("reserved", _c.c_int32),
        ("positions", _c.c_void_p),
        ("vertex_count", _c.c_size_t),
        ("triangles", _c.c_void_p),
        ("triangle_count", _c.c_size_t),
        ("tetrahedra", _c.c_void_p),
        ("tetrahedron_count", _c.c_size_t),
        ("hexahedra", _c.c_void_p),
        ("hexahedron_count", _c.c_size_t),
        ("triangle_regions", _c.c_void_p),
        ("tetrahedron_regions", _c.c_void_p),
        ("hexahedron_regions", _c.c_void_p),
    ]


class obc_mesh_tetrahedron_quality_report(_Struct):
    """Quality of tetrahedra. Ratios are negative for inverted tetrahedra and 0 for flat ones; angles are in degrees."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("worst", _c.c_uint32),
        ("tetrahedra", _c.c_uint64),
        ("positive", _c.c_uint64),
        ("flat", _c.c_uint64),
        ("inverted", _c.c_uint64),
        ("volume", _c.c_double),
        ("min_volume", _c.c_double),
        ("max_volume", _c.c_double),
        ("min_dihedral", _c.c_double),
        ("max_dihedral", _c.c_double),
        ("mean_min_dihedral", _c.c_double),
        ("min_radius_ratio", _c.c_double),
        ("mean_radius_ratio", _c.c_double),
        ("max_radius_edge", _c.c_double),
        ("mean_radius_edge", _c.c_double),
        ("min_edge_length", _c.c_double),
        ("max_edge_length", _c.c_double),
        ("dihedral_histogram", _c.c_uint64 * 18),
        ("radius_ratio_histogram", _c.c_uint64 * 20),
    ]


class obc_mesh_read_options(_Struct):
    """Options of readers. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("weld_identical", _c.c_int32),
    ]


class obc_mesh_write_options(_Struct):
    """Options of writers. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("binary", _c.c_int32),
    ]


class obc_mesh_topology_report(_Struct):
    """Topology of a surface. Defects have the indices of the first occurrence, 2^32 - 1 where there is none."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("closed", _c.c_int32),
        ("manifold", _c.c_int32),
        ("orientable", _c.c_int32),
        ("vertices", _c.c_uint64),
        ("unreferenced_vertices", _c.c_uint64),
        ("triangles", _c.c_uint64),
        ("edges", _c.c_uint64),
        ("components", _c.c_uint64),
        ("boundary_edges", _c.c_uint64),
        ("boundary_loops", _c.c_uint64),
        ("longest_boundary_loop", _c.c_uint64),
        ("non_manifold_edges", _c.c_uint64),
        ("non_manifold_vertices", _c.c_uint64),
        ("inconsistent_edges", _c.c_uint64),
        ("degenerate_faces", _c.c_uint64),
        ("duplicate_faces", _c.c_uint64),
        ("zero_area_faces", _c.c_uint64),
        ("coincident_vertices", _c.c_uint64),
        ("euler_characteristic", _c.c_int64),
        ("genus", _c.c_int64),
        ("low", _c.c_double * 3),
        ("high", _c.c_double * 3),
        ("area", _c.c_double),
        ("volume", _c.c_double),
        ("first_boundary_edge", _c.c_uint32 * 2),
        ("first_non_manifold_edge", _c.c_uint32 * 2),
        ("first_inconsistent_edge", _c.c_uint32 * 2),
        ("first_duplicate_faces", _c.c_uint32 * 2),
        ("first_coincident_vertices", _c.c_uint32 * 2),
        ("first_non_manifold_vertex", _c.c_uint32),
        ("first_vertex_apart", _c.c_uint32),
        ("first_degenerate_face", _c.c_uint32),
        ("first_zero_area_face", _c.c_uint32),
    ]


class obc_mesh_orient_report(_Struct):
    """Changes by obc_mesh_orient."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("inward_oriented", _c.c_int32),
        ("reversed_triangles", _c.c_uint64),
    ]


class obc_mesh_distance(_Struct):
    """Distances from sample points of one surface (vertices and centroids) to the nearest point of the other, in both directions, in the
    unit of the surfaces."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("reserved", _c.c_uint32),
        ("first_mean", _c.c_double),
        ("first_root_mean_square", _c.c_double),
        ("first_max", _c.c_double),
        ("second_mean", _c.c_double),
        ("second_root_mean_square", _c.c_double),
        ("second_max", _c.c_double),
    ]


_functions = [
    ("obc_mesh_cells_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_mesh_create", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_make", _c.c_int32, [_c.c_char_p, _c.c_size_t, _c.c_uint64, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_shape_name", _c.c_char_p, [_c.c_size_t]),
    ("obc_mesh_destroy", None, [_c.c_void_p]),
    ("obc_mesh_vertex_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_mesh_triangle_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_mesh_tetrahedron_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_mesh_hexahedron_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_mesh_copy", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_region_kinds", _c.c_uint32, [_c.c_void_p]),
    ("obc_mesh_copy_regions", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_surface", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_check_cells", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_boundary", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_tetrahedron_quality_report_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_mesh_tetrahedron_quality", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_format_ending", _c.c_char_p, [_c.c_int32]),
    ("obc_mesh_format_name", _c.c_char_p, [_c.c_int32]),
    ("obc_mesh_format_contents", _c.c_uint32, [_c.c_int32]),
    ("obc_mesh_read_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_mesh_read", _c.c_int32, [_c.c_char_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_read_memory", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_int32, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_format", _c.c_char_p, [_c.c_void_p]),
    ("obc_mesh_polygon_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_mesh_welded_vertex_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_mesh_note", _c.c_char_p, [_c.c_void_p, _c.c_size_t]),
    ("obc_mesh_write_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_mesh_write", _c.c_int32, [_c.c_char_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_write_surface", _c.c_int32, [_c.c_char_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_topology_report_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_mesh_topology", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_check_closed_genus_zero", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_orient_report_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_mesh_orient", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_first_at_same_position", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_intersections", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_vertex_normals", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_vertex_areas", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_distance_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_mesh_surface_distance", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_mean_distance", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_search_create", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_search_destroy", None, [_c.c_void_p]),
    ("obc_mesh_search_vertices", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_search_surface", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_orientation_2d", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_orientation_3d", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_orientation_from_origin", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_mesh_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("mesh", ["base"], _functions, globals(), name)
