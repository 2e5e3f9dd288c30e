"""What <orbicube/sphere_map.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_SPHERE_MAP_BALANCED: int
OBC_SPHERE_MAP_ANGLE_AREA: int
OBC_SPHERE_MAP_ISOMETRIC: int
OBC_SPHERE_MAP_STRETCH: int
OBC_SPHERE_MAP_CONFORMAL: int
OBC_SPHERE_MAP_DISSERTATION: int

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
    level_splits: int
    level_tolerance: float
    final_tolerance: float
    max_level_iterations: int
    max_final_iterations: int
    def __init__(self, struct_size: int = ..., method: int = ..., angle_weight: float = ..., area_weight: float = ..., seed: int = ..., trace: Any = ..., trace_user: Any = ..., level_splits: int = ..., level_tolerance: float = ..., final_tolerance: float = ..., max_level_iterations: int = ..., max_final_iterations: int = ...) -> None: ...

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
    max_quasi_conformal: float
    mean_quasi_conformal: float
    min_area_ratio: float
    max_area_ratio: float
    stretch_efficiency: float
    isometric_mean: float
    equation_3_1: float
    equation_3_2: float
    equation_3_3: float
    equation_3_4: float
    def __init__(self, struct_size: int = ..., bijective: int = ..., mirrored: int = ..., reserved: int = ..., flipped: int = ..., degenerate: int = ..., zero_area_faces: int = ..., degree: float = ..., energy_angle: float = ..., energy_area: float = ..., energy: float = ..., max_quasi_conformal: float = ..., mean_quasi_conformal: float = ..., min_area_ratio: float = ..., max_area_ratio: float = ..., stretch_efficiency: float = ..., isometric_mean: float = ..., equation_3_1: float = ..., equation_3_2: float = ..., equation_3_3: float = ..., equation_3_4: float = ...) -> None: ...

def obc_sphere_map_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_sphere_map_report_init(report: Pointer, struct_size: int) -> int:
    """Fills a report with zeros and its size, which obc_sphere_map_compute and _measure require."""
    ...

def obc_sphere_map_compute(surface: Pointer, options: Pointer, host: Pointer, directions: Pointer, report: Pointer, error: Pointer) -> int:
    """Maps a closed, connected, oriented genus-0 surface to unit vectors, one a vertex in the same order. An inward-oriented surface is
    mapped as seen from outside, with triangles clockwise on the sphere. Vertices in no triangle receive some unit vector. options,
    report and host may be NULL. directions: 3 * vertex_count doubles, written on success only. O(n log n) time, up to 1 KB a
    vertex. Errors: OBC_INVALID_ARGUMENT (NULL, NaN, index out of range, options), OBC_NOT_CLOSED, OBC_NOT_MANIFOLD,
    OBC_WRONG_GENUS, OBC_DEGENERATE, OBC_NO_VALID_RESULT, OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_compute_partial(surface: Pointer, options: Pointer, host: Pointer, directions: Pointer, placed: Pointer, report: Pointer, error: Pointer) -> int:
    """Maps a surface as obc_sphere_map_compute does, and keeps a partial map after OBC_NO_VALID_RESULT or OBC_CANCELLED: *placed is the
    number of vertices with directions of their own, whose triangles are positive by exact arithmetic (clockwise for an
    inward-oriented surface). Every other vertex has the direction of the vertex it was merged into, so that its triangles have zero area. If
    *placed is the number of vertices in triangles, the map is a bijection whose optimization is incomplete. After other errors, and
    if the work ended early, *placed is 0 and directions are unchanged. report is written on success only;
    obc_sphere_map_measure measures partial maps. Errors: as obc_sphere_map_compute."""
    ...

def obc_sphere_map_measure(surface: Pointer, directions: Pointer, options: Pointer, host: Pointer, report: Pointer, error: Pointer) -> int:
    """Measures a map, valid or not: directions (3 * vertex_count doubles, normalized before use) of the surface. Of options only the weights
    are used; options and host may be NULL. O(n). Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. An invalid map is not
    an error: see report->bijective."""
    ...

def obc_sphere_map_face_distortion(surface: Pointer, directions: Pointer, host: Pointer, quasi_conformal: Pointer, area_ratio: Pointer, error: Pointer) -> int:
    """Computes the distortion of each triangle: quasi-conformal distortion and area ratio as in the report, triangle_count
    doubles each; either array may be NULL. Degenerate triangles (see obc_sphere_map_report) have an infinite distortion and the ratio
    0. O(n). Errors: as obc_sphere_map_measure."""
    ...

def obc_sphere_map_round_to_float(surface: Pointer, directions: Pointer, host: Pointer, rounded: Pointer, error: Pointer) -> int:
    """Rounds a map to float32, the precision of GLB and of engines, and moves vertices of triangles that rounding flips to nearby points.
    rounded: 3 * vertex_count floats; all triangles are positive by exact arithmetic on success. Errors: OBC_INVALID_ARGUMENT,
    OBC_NO_VALID_RESULT (float32 cannot represent the map), OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_locator_create(surface: Pointer, directions: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Creates a locator from a bijective map (every triangle positive by exact arithmetic, or every triangle negative), with directions of
    length 0.5 to 2. Only triangles and counts of the surface are used; its positions may be NULL. host may be NULL; its allocator is
    used until obc_sphere_map_locator_destroy. O(n) time, about 100 bytes a vertex. Errors: OBC_INVALID_ARGUMENT (also for a map
    that is not bijective), OBC_NOT_CLOSED, OBC_NOT_MANIFOLD, OBC_DEGENERATE, OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_locator_destroy(locator: Pointer) -> None:
    """Destroys a locator; NULL is allowed."""
    ...

def obc_sphere_map_locate(locator: Pointer, directions: Pointer, count: int, host: Pointer, triangles: Pointer, weights: Pointer, error: Pointer) -> int:
    """Finds for each direction the triangle that contains it, exactly; on an edge or a vertex the lowest adjacent triangle. weights are the
    barycentric coordinates of the intersection of the ray with the flat triangle of the map, nonnegative with sum 1, and
    exactly 0 for a direction on the opposite edge. triangles: count indices, or NULL; weights: 3 * count doubles, or NULL. Uses the
    threads of the host (or NULL). After a failure the arrays are undefined. Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED,
    OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_sample(locator: Pointer, directions: Pointer, count: int, values: Pointer, components: int, unit: int, host: Pointer, sampled: Pointer, error: Pointer) -> int:
    """Interpolates values of the vertices, such as positions, normals or colors, at each direction. values: components * vertex_count
    doubles; sampled: components * count. unit 1 scales each result to length 1 (for normals), 0 does not. The direction of a vertex
    returns the values of the vertex. Errors: as obc_sphere_map_locate."""
    ...

def obc_sphere_map_grid(grid: int, resolution: int, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Creates a regular triangulation with unit vectors for positions. *out is destroyed with obc_mesh_destroy; the allocator of the host is
    used until then. O(size). Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_remesh(locator: Pointer, positions: Pointer, grid: int, resolution: int, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Resamples a surface on a regular triangulation: positions (3 * vertex_count doubles) interpolated at its directions. Otherwise as
    obc_sphere_map_grid."""
    ...

def obc_sphere_map_image_size(layout: int, resolution: int, width: Pointer, height: Pointer, error: Pointer) -> int:
    """Computes the size of a geometry image (Gu, Gortler and Hoppe 2002; Praun and Hoppe 2003): the surface as pixels x y z, 3 * width *
    height doubles, row by row from the top. OBC_SPHERE_MAP_OCTAHEDRON is a square of (resolution + 1)^2 pixels, OBC_SPHERE_MAP_CUBE
    six tiles of that size, 3 by 2: +x -x +y, below -y +z -z. Pixels on both sides of a cut are equal. resolution: up to
    4096. Errors: OBC_INVALID_ARGUMENT."""
    ...

def obc_sphere_map_image(locator: Pointer, positions: Pointer, layout: int, resolution: int, host: Pointer, pixels: Pointer, error: Pointer) -> int:
    """Computes a geometry image of positions (3 * vertex_count doubles) or other vectors of the vertices. pixels is written on success
    only. Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_image_surface(pixels: Pointer, layout: int, resolution: int, host: Pointer, out: Pointer, seam_gap: Pointer, error: Pointer) -> int:
    """Reconstructs the closed surface of a geometry image. seam_gap (or NULL) receives the maximum distance between pixels of one vertex, whose
    position is their mean. Errors: OBC_INVALID_ARGUMENT (also a pixel that is not finite), OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_image_write(path: bytes | None, pixels: Pointer, layout: int, resolution: int, host: Pointer, error: Pointer) -> int:
    """Writes a geometry image in the format of the file ending: .pfm (float32) or .png (16 bits a channel, relative to the bounding box,
    which a text chunk stores). The file is complete or does not appear. Errors: OBC_INVALID_ARGUMENT, OBC_UNSUPPORTED, OBC_IO, OBC_CANCELLED,
    OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_image_read(path: bytes | None, host: Pointer, layout: Pointer, resolution: Pointer, pixels: Pointer, capacity: int, error: Pointer) -> int:
    """Reads layout and resolution of a geometry image, and its pixels into an array of `capacity` doubles unless pixels is NULL. A PNG file
    without the text chunk has the unit cube for bounding box. Errors: as obc_sphere_map_image_write, and OBC_MALFORMED_FILE."""
    ...

def obc_sphere_map_best_rotation(from_: Pointer, to: Pointer, count: int, rotation: Pointer, error: Pointer) -> int:
    """Computes the rotation, row by row, that maps `from` nearest to `to` in the least-squares sense (Kabsch 1976): 3 * count doubles each,
    scaled to length 1. Where the pairs do not determine it, the rotation of minimum angle. Errors: OBC_INVALID_ARGUMENT."""
    ...

def obc_sphere_map_warp_create(from_: Pointer, to: Pointer, count: int, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Creates a warp that maps from[i] to to[i]: 3 * count doubles each, of any length, with a distance of at least 0.01 between landmarks.
    The allocator of the host is used until the warp is destroyed. Errors: OBC_INVALID_ARGUMENT, OBC_NO_VALID_RESULT (the paths of
    two landmarks cross), OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_warp_destroy(warp: Pointer) -> None:
    """Destroys a warp; NULL is allowed."""
    ...

def obc_sphere_map_warp_apply(warp: Pointer, directions: Pointer, count: int, backward: int, host: Pointer, moved: Pointer, error: Pointer) -> int:
    """Maps directions (3 * count doubles) by a warp (backward 0) or its inverse (backward 1); moved may be directions itself. Errors:
    OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_sphere_map_overlay(first: Pointer, first_directions: Pointer, second: Pointer, second_directions: Pointer, host: Pointer, out: Pointer, second_vertex: Pointer, error: Pointer) -> int:
    """Computes one triangulation of the sphere with the vertices of two maps: those of the second are inserted into the triangles of the
    first, whose edges are preserved; vertices at the same direction are merged. Only triangles and counts of the surfaces are used. *out
    (positions: unit vectors) begins with the vertices of the first map, in its order. second_vertex (vertex_count of the second surface, or
    NULL) receives the vertex of *out of each vertex of the second map (UINT32_MAX: in no triangle). Every triangle is positive. Errors: as
    obc_sphere_map_locator_create, for the first map."""
    ...

def obc_sphere_map_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
