"""What <orbicube/repair.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct

OBC_REPAIR_WELDED_VERTEX = 0
OBC_REPAIR_REMOVED_DEGENERATE = 1
OBC_REPAIR_REMOVED_DUPLICATE = 2
OBC_REPAIR_COLLAPSED_EDGE = 3
OBC_REPAIR_FLIPPED_EDGE = 4
OBC_REPAIR_LEFT_NEAR_DEGENERATE = 5
OBC_REPAIR_SPLIT_EDGE = 6
OBC_REPAIR_SPLIT_CONTACT_EDGE = 7
OBC_REPAIR_SPLIT_CONTACT_VERTEX = 8
OBC_REPAIR_DROPPED_PART = 9
OBC_REPAIR_FILLED_HOLE = 10
OBC_REPAIR_LEFT_HOLE = 11
OBC_REPAIR_CUT_HANDLE = 12


class obc_repair_options(_Struct):
    """Options of a repair. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("weld", _c.c_int32),
        ("clean", _c.c_int32),
        ("slivers", _c.c_int32),
        ("t_junctions", _c.c_int32),
        ("orient", _c.c_int32),
        ("contacts", _c.c_int32),
        ("drop_parts", _c.c_int32),
        ("cavities", _c.c_int32),
        ("fill_holes", _c.c_int32),
        ("fair", _c.c_int32),
        ("find_intersections", _c.c_int32),
        ("max_genus", _c.c_int32),
        ("weld_distance", _c.c_double),
        ("sliver_ratio", _c.c_double),
        ("sliver_move", _c.c_double),
        ("t_junction_distance", _c.c_double),
        ("contact_gap", _c.c_double),
        ("min_area_percent", _c.c_double),
        ("keep_parts", _c.c_size_t),
        ("max_hole_edges", _c.c_size_t),
        ("max_handle_length", _c.c_double),
        ("wrap_offset", _c.c_double),
    ]


class obc_repair_report(_Struct):
    """Figures of a repair and the certificate of its result. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("changed", _c.c_int32),
        ("closed", _c.c_int32),
        ("manifold", _c.c_int32),
        ("oriented", _c.c_int32),
        ("orientable", _c.c_int32),
        ("welded_vertices", _c.c_size_t),
        ("weld_lost_triangles", _c.c_size_t),
        ("degenerate_faces", _c.c_size_t),
        ("duplicate_faces", _c.c_size_t),
        ("unused_vertices", _c.c_size_t),
        ("near_degenerate", _c.c_size_t),
        ("collapsed_edges", _c.c_size_t),
        ("flipped_edges", _c.c_size_t),
        ("left_near_degenerate", _c.c_size_t),
        ("t_junctions", _c.c_size_t),
        ("reversed_triangles", _c.c_size_t),
        ("contact_edges", _c.c_size_t),
        ("contact_vertices", _c.c_size_t),
        ("contact_added_vertices", _c.c_size_t),
        ("found_parts", _c.c_size_t),
        ("kept_parts", _c.c_size_t),
        ("cavity_parts", _c.c_size_t),
        ("dropped_triangles", _c.c_size_t),
        ("found_holes", _c.c_size_t),
        ("filled_holes", _c.c_size_t),
        ("patch_triangles", _c.c_size_t),
        ("patch_vertices", _c.c_size_t),
        ("cut_handles", _c.c_size_t),
        ("weld_move", _c.c_double),
        ("sliver_move", _c.c_double),
        ("t_junction_move", _c.c_double),
        ("handle_move", _c.c_double),
        ("longest_handle", _c.c_double),
        ("dropped_area_percent", _c.c_double),
        ("distance_from_input", _c.c_double),
        ("distance_from_result", _c.c_double),
        ("distance_of_patches", _c.c_double),
        ("parts", _c.c_size_t),
        ("genus", _c.c_int64),
        ("boundary_loops", _c.c_size_t),
        ("self_intersections", _c.c_size_t),
        ("area", _c.c_double),
        ("volume", _c.c_double),
    ]


class obc_repair_label_options(_Struct):
    """Options of the surface of a label. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("label", _c.c_int32),
        ("cavities", _c.c_int32),
        ("handles", _c.c_int32),
        ("keep_parts", _c.c_size_t),
        ("smoothing", _c.c_double),
        ("max_slide", _c.c_double),
    ]


class obc_repair_label_report(_Struct):
    """Figures of the surface of a label. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("label", _c.c_int32),
        ("voxels", _c.c_size_t),
        ("border_voxels", _c.c_size_t),
        ("found_parts", _c.c_size_t),
        ("kept_parts", _c.c_size_t),
        ("dropped_voxels", _c.c_size_t),
        ("cavities", _c.c_size_t),
        ("filled_voxels", _c.c_size_t),
        ("handles", _c.c_size_t),
        ("added_voxels", _c.c_size_t),
        ("removed_voxels", _c.c_size_t),
        ("centered_vertices", _c.c_size_t),
        ("largest_slide", _c.c_double),
    ]


_functions = [
    ("obc_repair_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_repair_report_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_repair_compute", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_repair_destroy", None, [_c.c_void_p]),
    ("obc_repair_vertex_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_repair_triangle_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_repair_event_count", _c.c_size_t, [_c.c_void_p]),
    ("obc_repair_copy", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_repair_copy_events", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_repair_get_report", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_repair_action_name", _c.c_char_p, [_c.c_int32]),
    ("obc_repair_label_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_repair_label_report_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_repair_surface_of_label", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_repair_get_label_report", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_repair_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("repair", ["base", "mesh"], _functions, globals(), name)
