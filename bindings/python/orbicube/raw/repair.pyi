"""What <orbicube/repair.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_REPAIR_WELDED_VERTEX: int
OBC_REPAIR_REMOVED_DEGENERATE: int
OBC_REPAIR_REMOVED_DUPLICATE: int
OBC_REPAIR_COLLAPSED_EDGE: int
OBC_REPAIR_FLIPPED_EDGE: int
OBC_REPAIR_LEFT_NEAR_DEGENERATE: int
OBC_REPAIR_SPLIT_EDGE: int
OBC_REPAIR_SPLIT_CONTACT_EDGE: int
OBC_REPAIR_SPLIT_CONTACT_VERTEX: int
OBC_REPAIR_DROPPED_PART: int
OBC_REPAIR_FILLED_HOLE: int
OBC_REPAIR_LEFT_HOLE: int
OBC_REPAIR_CUT_HANDLE: int

class obc_repair_options(Struct):
    struct_size: int
    weld: int
    clean: int
    slivers: int
    t_junctions: int
    orient: int
    contacts: int
    drop_parts: int
    cavities: int
    fill_holes: int
    fair: int
    find_intersections: int
    max_genus: int
    weld_distance: float
    sliver_ratio: float
    sliver_move: float
    t_junction_distance: float
    contact_gap: float
    min_area_percent: float
    keep_parts: int
    max_hole_edges: int
    max_handle_length: float
    wrap_offset: float
    def __init__(self, struct_size: int = ..., weld: int = ..., clean: int = ..., slivers: int = ..., t_junctions: int = ..., orient: int = ..., contacts: int = ..., drop_parts: int = ..., cavities: int = ..., fill_holes: int = ..., fair: int = ..., find_intersections: int = ..., max_genus: int = ..., weld_distance: float = ..., sliver_ratio: float = ..., sliver_move: float = ..., t_junction_distance: float = ..., contact_gap: float = ..., min_area_percent: float = ..., keep_parts: int = ..., max_hole_edges: int = ..., max_handle_length: float = ..., wrap_offset: float = ...) -> None: ...

class obc_repair_report(Struct):
    struct_size: int
    changed: int
    closed: int
    manifold: int
    oriented: int
    orientable: int
    welded_vertices: int
    weld_lost_triangles: int
    degenerate_faces: int
    duplicate_faces: int
    unused_vertices: int
    near_degenerate: int
    collapsed_edges: int
    flipped_edges: int
    left_near_degenerate: int
    t_junctions: int
    reversed_triangles: int
    contact_edges: int
    contact_vertices: int
    contact_added_vertices: int
    found_parts: int
    kept_parts: int
    cavity_parts: int
    dropped_triangles: int
    found_holes: int
    filled_holes: int
    patch_triangles: int
    patch_vertices: int
    cut_handles: int
    weld_move: float
    sliver_move: float
    t_junction_move: float
    handle_move: float
    longest_handle: float
    dropped_area_percent: float
    distance_from_input: float
    distance_from_result: float
    distance_of_patches: float
    parts: int
    genus: int
    boundary_loops: int
    self_intersections: int
    area: float
    volume: float
    def __init__(self, struct_size: int = ..., changed: int = ..., closed: int = ..., manifold: int = ..., oriented: int = ..., orientable: int = ..., welded_vertices: int = ..., weld_lost_triangles: int = ..., degenerate_faces: int = ..., duplicate_faces: int = ..., unused_vertices: int = ..., near_degenerate: int = ..., collapsed_edges: int = ..., flipped_edges: int = ..., left_near_degenerate: int = ..., t_junctions: int = ..., reversed_triangles: int = ..., contact_edges: int = ..., contact_vertices: int = ..., contact_added_vertices: int = ..., found_parts: int = ..., kept_parts: int = ..., cavity_parts: int = ..., dropped_triangles: int = ..., found_holes: int = ..., filled_holes: int = ..., patch_triangles: int = ..., patch_vertices: int = ..., cut_handles: int = ..., weld_move: float = ..., sliver_move: float = ..., t_junction_move: float = ..., handle_move: float = ..., longest_handle: float = ..., dropped_area_percent: float = ..., distance_from_input: float = ..., distance_from_result: float = ..., distance_of_patches: float = ..., parts: int = ..., genus: int = ..., boundary_loops: int = ..., self_intersections: int = ..., area: float = ..., volume: float = ...) -> None: ...

class obc_repair_label_options(Struct):
    struct_size: int
    label: int
    cavities: int
    handles: int
    keep_parts: int
    smoothing: float
    max_slide: float
    def __init__(self, struct_size: int = ..., label: int = ..., cavities: int = ..., handles: int = ..., keep_parts: int = ..., smoothing: float = ..., max_slide: float = ...) -> None: ...

class obc_repair_label_report(Struct):
    struct_size: int
    label: int
    voxels: int
    border_voxels: int
    found_parts: int
    kept_parts: int
    dropped_voxels: int
    cavities: int
    filled_voxels: int
    handles: int
    added_voxels: int
    removed_voxels: int
    centered_vertices: int
    largest_slide: float
    def __init__(self, struct_size: int = ..., label: int = ..., voxels: int = ..., border_voxels: int = ..., found_parts: int = ..., kept_parts: int = ..., dropped_voxels: int = ..., cavities: int = ..., filled_voxels: int = ..., handles: int = ..., added_voxels: int = ..., removed_voxels: int = ..., centered_vertices: int = ..., largest_slide: float = ...) -> None: ...

def obc_repair_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_repair_report_init(report: Pointer, struct_size: int) -> int:
    """Fills a report with zeros and its struct_size."""
    ...

def obc_repair_compute(surface: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Repairs a surface: any triangles, which need not be connected, closed, oriented or manifold. options and host may be NULL. Whether a
    closed, oriented, manifold surface was reached is in the report. *out is NULL after an error; the allocator of the host must
    remain valid until _destroy. Takes O(n log n) and, for each hole of k edges, O(k * 150^2); a wrap needs
    (size / wrap_offset)^3 bytes times five, at most 67 million nodes. Errors: OBC_INVALID_ARGUMENT,
    OBC_MALFORMED_FILE (kind empty-mesh: no triangles), OBC_DEGENERATE (no triangle is left), OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_repair_destroy(repaired: Pointer) -> None:
    """Destroys a repaired surface; NULL is allowed."""
    ...

def obc_repair_vertex_count(repaired: Pointer) -> int:
    """Return the numbers of vertices, triangles and events; 0 for NULL."""
    ...

def obc_repair_triangle_count(repaired: Pointer) -> int:
    """Return the numbers of vertices, triangles and events; 0 for NULL."""
    ...

def obc_repair_event_count(repaired: Pointer) -> int:
    """Return the numbers of vertices, triangles and events; 0 for NULL."""
    ...

def obc_repair_copy(repaired: Pointer, positions: Pointer, triangles: Pointer, vertex_source: Pointer, triangle_source: Pointer, error: Pointer) -> int:
    """Copies the surface to arrays of the caller, each of which may be NULL: positions (x y z a vertex), triangles (three vertices each), and
    for each vertex and triangle its number in the input, or UINT32_MAX where the repair made it. Errors: OBC_INVALID_ARGUMENT."""
    ...

def obc_repair_copy_events(repaired: Pointer, actions: Pointer, counts: Pointer, places: Pointer, sizes: Pointer, error: Pointer) -> int:
    """Copies what was done, in the order in which it was, to arrays of the caller with an entry an event, each of which may be NULL: actions
    (OBC_REPAIR_...), counts, places (x y z an event) and sizes. Errors: OBC_INVALID_ARGUMENT."""
    ...

def obc_repair_get_report(repaired: Pointer, report: Pointer, error: Pointer) -> int:
    """Fills a report. Errors: OBC_INVALID_ARGUMENT."""
    ...

def obc_repair_action_name(action: int) -> bytes | None:
    """Returns the name of an action, as "filled-hole", or "unknown"."""
    ...

def obc_repair_label_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_repair_label_report_init(report: Pointer, struct_size: int) -> int:
    """Fills a report with zeros and its struct_size."""
    ...

def obc_repair_surface_of_label(labels: Pointer, size: Pointer, to_world: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Extracts the closed surface of a label of an image: labels of size[0] * size[1] * size[2] voxels, x fastest, and to_world, a 4x4 matrix,
    row-major, from (x, y, z, 1) to positions, with voxel centers at whole numbers and the last row 0 0 0 1; NULL: positions are
    voxel numbers. It is outward-oriented, also where to_world mirrors. The largest parts are kept, cavities filled, handles and tunnels
    removed at their thinnest places by homotopic growth and shrinking; vertices lie between the centers of adjacent voxels where
    the smoothed object ends. No triangles intersect, the centers of the object's voxels are inside and all others outside, and the
    surface is within half a voxel of the sides of its voxels. options and host may be NULL. *out is NULL after an error; its
    certificate is in the report of obc_repair_get_report, its sources are all UINT32_MAX, it has no events. Takes O(n log n) of the
    voxels in the label's box and about 20 bytes for each of them. Errors: OBC_INVALID_ARGUMENT (sizes that overflow, a singular map, a
    label that is not there, several labels and none chosen; the message lists those that are there), OBC_NO_VALID_RESULT (large
    coordinates leave too few digits, so that triangles intersect), OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_repair_get_label_report(repaired: Pointer, report: Pointer, error: Pointer) -> int:
    """Fills a report of obc_repair_surface_of_label; zeros for other repairs. Errors: OBC_INVALID_ARGUMENT."""
    ...

def obc_repair_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
