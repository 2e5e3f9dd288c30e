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
    turned_triangles: int
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
    def __init__(self, struct_size: int = ..., changed: int = ..., closed: int = ..., manifold: int = ..., oriented: int = ..., orientable: int = ..., welded_vertices: int = ..., weld_lost_triangles: int = ..., degenerate_faces: int = ..., duplicate_faces: int = ..., unused_vertices: int = ..., near_degenerate: int = ..., collapsed_edges: int = ..., flipped_edges: int = ..., left_near_degenerate: int = ..., t_junctions: int = ..., turned_triangles: int = ..., contact_edges: int = ..., contact_vertices: int = ..., contact_added_vertices: int = ..., found_parts: int = ..., kept_parts: int = ..., cavity_parts: int = ..., dropped_triangles: int = ..., found_holes: int = ..., filled_holes: int = ..., patch_triangles: int = ..., patch_vertices: int = ..., cut_handles: int = ..., weld_move: float = ..., sliver_move: float = ..., t_junction_move: float = ..., handle_move: float = ..., longest_handle: float = ..., dropped_area_percent: float = ..., distance_from_input: float = ..., distance_from_result: float = ..., distance_of_patches: float = ..., parts: int = ..., genus: int = ..., boundary_loops: int = ..., self_intersections: int = ..., area: float = ..., volume: float = ...) -> None: ...

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

def obc_repair_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
