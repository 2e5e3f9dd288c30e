"""What <orbicube/sphere_map.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_SPHERE_MAP_BALANCED: int
OBC_SPHERE_MAP_ANGLE_AREA: int
OBC_SPHERE_MAP_ISOMETRIC: int
OBC_SPHERE_MAP_STRETCH: int
OBC_SPHERE_MAP_CONFORMAL: int
OBC_SPHERE_MAP_SEED: int

OBC_SPHERE_MAP_ICOSPHERE: int
OBC_SPHERE_MAP_CUBE: int
OBC_SPHERE_MAP_LATITUDE: int
OBC_SPHERE_MAP_OCTAHEDRON: int

obc_sphere_map_trace_function: Any

class obc_sphere_map_options(Struct):
    struct_size: int
    method: int
    angle_weight: float
    area_weight: float
    seed: int
    trace: Any
    trace_user: Any
    def __init__(self, struct_size: int = ..., method: int = ..., angle_weight: float = ..., area_weight: float = ..., seed: int = ..., trace: Any = ..., trace_user: Any = ...) -> None: ...

class obc_sphere_map_report(Struct):
    struct_size: int
    bijective: int
    mirrored: int
    reserved: int
    flipped: int
    degenerate: int
    zero_area_faces: int
    degree: float
    energy_angle: float
    energy_area: float
    energy: float
    dilatation_largest: float
    dilatation_mean: float
    area_ratio_smallest: float
    area_ratio_largest: float
    stretch_efficiency: float
    isometric_mean: float
    def __init__(self, struct_size: int = ..., bijective: int = ..., mirrored: int = ..., reserved: int = ..., flipped: int = ..., degenerate: int = ..., zero_area_faces: int = ..., degree: float = ..., energy_angle: float = ..., energy_area: float = ..., energy: float = ..., dilatation_largest: float = ..., dilatation_mean: float = ..., area_ratio_smallest: float = ..., area_ratio_largest: float = ..., stretch_efficiency: float = ..., isometric_mean: float = ...) -> None: ...

class obc_sphere_map_distance(Struct):
    struct_size: int
    reserved: int
    first_mean: float
    first_root_mean_square: float
    first_largest: float
    second_mean: float
    second_root_mean_square: float
    second_largest: float
    def __init__(self, struct_size: int = ..., reserved: int = ..., first_mean: float = ..., first_root_mean_square: float = ..., first_largest: float = ..., second_mean: float = ..., second_root_mean_square: float = ..., second_largest: float = ...) -> None: ...

def obc_sphere_map_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_sphere_map_report_init(report: Pointer, struct_size: int) -> int:
    """Fills a report with zeros and its size, which obc_sphere_map_compute and _measure need."""
    ...

def obc_sphere_map_compute(surface: Pointer, options: Pointer, host: Pointer, directions: Pointer, report: Pointer, error: Pointer) -> int:
    """Maps a closed, connected, oriented genus-0 surface to unit vectors, one a vertex in the same order. A surface that looks
    inward is mapped as seen from outside: its triangles are then clockwise on the sphere. Vertices in no triangle get some
    unit vector.
    options, report and host may be NULL. directions: 3 * vertex_count doubles, written on success only.
    O(n log n) time, at most 1 KB a vertex.
    Errors: OBC_INVALID_ARGUMENT (NULL, NaN, index out of range, options), OBC_NOT_CLOSED, OBC_NOT_MANIFOLD,
    OBC_WRONG_GENUS, OBC_DEGENERATE, OBC_NO_VALID_RESULT, OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_compute_partial(surface: Pointer, options: Pointer, host: Pointer, directions: Pointer, placed: Pointer, report: Pointer, error: Pointer) -> int:
    """As obc_sphere_map_compute, and when that ends with OBC_NO_VALID_RESULT or OBC_CANCELLED, directions get what there is of the
    map that came furthest: *placed vertices have places of their own, and their triangles are positive by exact arithmetic
    (clockwise for a surface that looks inward); each other vertex is where the one is that it was merged into, so that its
    triangles have no area. With *placed as many as there are vertices in triangles it is a bijection that is not optimised to
    the end. *placed is 0, and directions are untouched, when the work did not come so far and for other errors. report is
    written on success only; obc_sphere_map_measure measures partial maps.
    Errors: as obc_sphere_map_compute."""
    ...

def obc_sphere_map_measure(surface: Pointer, directions: Pointer, options: Pointer, host: Pointer, report: Pointer, error: Pointer) -> int:
    """Measures a map: directions (3 * vertex_count doubles, normalised before use) of the surface. Only the weights of
    options are used; options and host may be NULL. O(n).
    Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. A bad map is no error: see report->bijective."""
    ...

def obc_sphere_map_face_distortion(surface: Pointer, directions: Pointer, host: Pointer, dilatation: Pointer, area_ratio: Pointer, error: Pointer) -> int:
    """Distortion of each triangle, for colouring: dilatation and area_ratio as in the report, triangle_count doubles each;
    either may be NULL. Triangles without surface area have an infinite dilatation and the ratio 0. O(n).
    Errors: as obc_sphere_map_measure."""
    ...

def obc_sphere_map_round_to_float(surface: Pointer, directions: Pointer, host: Pointer, rounded: Pointer, error: Pointer) -> int:
    """Rounds a map to float32, the precision of engines and of GLB, and repairs the triangles that this turns over by moving
    their vertices to nearby points. rounded: 3 * vertex_count floats, positive by exact arithmetic on success.
    Errors: OBC_INVALID_ARGUMENT, OBC_NO_VALID_RESULT (the map cannot be held in float32), OBC_CANCELLED,
    OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_locator_create(surface: Pointer, directions: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """From a map that is a bijection (every triangle positive by exact arithmetic, or every triangle negative), with directions
    of length 0.5 to 2. Only triangles and counts of the surface are used; its positions may be NULL. host may be NULL; its
    allocator is kept until obc_sphere_map_locator_destroy. O(n) time, about 100 bytes a vertex.
    Errors: OBC_INVALID_ARGUMENT (also for what is no bijection), OBC_NOT_CLOSED, OBC_NOT_MANIFOLD, OBC_DEGENERATE,
    OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_locator_destroy(locator: Pointer) -> None:
    """NULL is fine."""
    ...

def obc_sphere_map_locate(locator: Pointer, directions: Pointer, count: int, host: Pointer, triangles: Pointer, weights: Pointer, error: Pointer) -> int:
    """For each direction the triangle that it lies in, exactly; on an edge or a vertex, the lowest of the triangles there. weights:
    where the ray along the direction meets the flat triangle of the map, as shares of its three corners, not negative, with
    the sum 1; exactly 0 where the direction lies on the opposite edge. triangles: count indices, or NULL; weights: 3 * count
    doubles, or NULL. On the threads of the host (or NULL). On failure what is written is of no use.
    Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_sample(locator: Pointer, directions: Pointer, count: int, values: Pointer, components: int, unit: int, host: Pointer, sampled: Pointer, error: Pointer) -> int:
    """Positions, normals, colours or other values of the vertices, interpolated where each direction lies. values: components *
    vertex_count doubles; sampled: components * count. With unit 1 each result is scaled to length 1 (for normals), with 0
    not. The direction of a vertex gives the vertex's own values.
    Errors: as obc_sphere_map_locate."""
    ...

def obc_sphere_map_vertex_normals(surface: Pointer, host: Pointer, normals: Pointer, error: Pointer) -> int:
    """Unit normals of the vertices, 3 * vertex_count doubles: the triangles' normals weighted by their angles (Thuermer and
    Wuethrich 1998). O(n).
    Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_grid(grid: int, resolution: int, host: Pointer, out: Pointer, error: Pointer) -> int:
    """The triangulation alone, positions being unit vectors. *out is released with obc_mesh_destroy; host's allocator is kept until
    then. O(size). Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_remesh(locator: Pointer, positions: Pointer, grid: int, resolution: int, host: Pointer, out: Pointer, error: Pointer) -> int:
    """The surface resampled on a triangulation: positions (3 * vertex_count doubles) at its directions. Else as
    obc_sphere_map_grid."""
    ...

def obc_sphere_map_distance_init(distance: Pointer, struct_size: int) -> int:
    """Fills a result with zeros and its size."""
    ...

def obc_sphere_map_surface_distance(first: Pointer, second: Pointer, host: Pointer, distance: Pointer, error: Pointer) -> int:
    """On the threads of the host. O(n log n). Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_image_size(layout: int, resolution: int, width: Pointer, height: Pointer, error: Pointer) -> int:
    """Geometry images (Gu, Gortler and Hoppe 2002; Praun and Hoppe 2003): the surface as pixels x y z, 3 * width * height doubles,
    row by row from the top. OBC_SPHERE_MAP_OCTAHEDRON is a square of (resolution + 1)^2 pixels, OBC_SPHERE_MAP_CUBE six tiles
    of as many, 3 by 2: +x -x +y, below -y +z -z. Pixels that the cut tears apart are the same. resolution: at most 4096."""
    ...

def obc_sphere_map_image(locator: Pointer, positions: Pointer, layout: int, resolution: int, host: Pointer, pixels: Pointer, error: Pointer) -> int:
    """positions: 3 * vertex_count doubles (or other vectors of the vertices). pixels: written on success only.
    Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_image_surface(pixels: Pointer, layout: int, resolution: int, host: Pointer, out: Pointer, seam_gap: Pointer, error: Pointer) -> int:
    """The closed surface back. seam_gap, or NULL: the greatest distance between pixels that are one vertex, which becomes their
    mean. Errors: OBC_INVALID_ARGUMENT (also a pixel that is not finite), OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_image_write(path: bytes | None, pixels: Pointer, layout: int, resolution: int, host: Pointer, error: Pointer) -> int:
    """Files by the ending: .pfm (float32) or .png (16 bits a channel between the corners of the bounding box, which a text chunk
    holds). Written whole or not at all. Errors: OBC_INVALID_ARGUMENT, OBC_UNSUPPORTED, OBC_IO, OBC_CANCELLED,
    OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_image_read(path: bytes | None, host: Pointer, layout: Pointer, resolution: Pointer, pixels: Pointer, capacity: int, error: Pointer) -> int:
    """Says what is in a file; with pixels not NULL, of `capacity` doubles, reads it too. PNG files without the chunk fill the cube
    from 0 to 1. Errors: as for writing, and OBC_MALFORMED_FILE."""
    ...

def obc_sphere_map_best_rotation(from_: Pointer, to: Pointer, count: int, rotation: Pointer, error: Pointer) -> int:
    """The rotation, row by row, that takes `from` nearest to `to` (least squares; Kabsch 1976): 3 * count doubles each, scaled
    to length 1. What the pairs leave open is turned as little as can be. Errors: OBC_INVALID_ARGUMENT."""
    ...

def obc_sphere_map_warp_create(from_: Pointer, to: Pointer, count: int, host: Pointer, out: Pointer, error: Pointer) -> int:
    """from[i] goes to to[i]: 3 * count doubles each, of any length, no two of them nearer than 0.01. host's allocator is kept.
    Errors: OBC_INVALID_ARGUMENT, OBC_NO_VALID_RESULT (the ways of two landmarks meet), OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_warp_destroy(warp: Pointer) -> None:
    """NULL is fine."""
    ...

def obc_sphere_map_warp_apply(warp: Pointer, directions: Pointer, count: int, backward: int, host: Pointer, moved: Pointer, error: Pointer) -> int:
    """Where each direction goes (backward 0) or comes from (backward 1): 3 * count doubles; moved may be directions itself.
    Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_overlay(first: Pointer, first_directions: Pointer, second: Pointer, second_directions: Pointer, host: Pointer, out: Pointer, second_vertex: Pointer, error: Pointer) -> int:
    """One triangulation of the sphere with the vertices of two maps: the second's are inserted into the triangles of the first,
    whose edges stay; vertices at the same direction become one. Only triangles and counts of the surfaces are used. The first
    vertices of *out (positions: unit vectors) are those of the first map, in its order; second_vertex, second's vertex_count
    indices or NULL, says where those of the second are (UINT32_MAX: in no triangle). Every triangle is positive.
    Errors: as obc_sphere_map_locator_create, for the first map."""
    ...

def obc_sphere_map_version() -> int:
    """Version of the library, major * 10000 + minor * 100 + patch."""
    ...
