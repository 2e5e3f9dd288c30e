"""What <orbicube/polycube.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_POLYCUBE_AUTO: int
OBC_POLYCUBE_LABELS: int
OBC_POLYCUBE_VOXELS: int
OBC_POLYCUBE_DISSERTATION: int

OBC_POLYCUBE_SURFACE_MEAN: int
OBC_POLYCUBE_FACE_MEAN: int
OBC_POLYCUBE_HARMONIC: int

OBC_POLYCUBE_TRUST_REGION: int
OBC_POLYCUBE_GRADIENT: int

class obc_polycube_certificate(Struct):
    struct_size: int
    valid: int
    genus: int
    corners: int
    patches: int
    reason: bytes
    def __init__(self, struct_size: int = ..., valid: int = ..., genus: int = ..., corners: int = ..., patches: int = ..., reason: bytes = ...) -> None: ...

class obc_polycube_options(Struct):
    struct_size: int
    construction: int
    corners: int
    seed: int
    area_weight: float
    rounds: int
    def __init__(self, struct_size: int = ..., construction: int = ..., corners: int = ..., seed: int = ..., area_weight: float = ..., rounds: int = ...) -> None: ...

class obc_polycube_domain_options(Struct):
    struct_size: int
    measure: int
    area_weight: float
    def __init__(self, struct_size: int = ..., measure: int = ..., area_weight: float = ...) -> None: ...

class obc_polycube_domain_report(Struct):
    struct_size: int
    converged: int
    energy_before: float
    energy: float
    evaluations: int
    layers: int
    cells: int
    crossing: int
    angle_mean: float
    area_mean: float
    angle_weighted_mean: float
    area_weighted_mean: float
    def __init__(self, struct_size: int = ..., converged: int = ..., energy_before: float = ..., energy: float = ..., evaluations: int = ..., layers: int = ..., cells: int = ..., crossing: int = ..., angle_mean: float = ..., area_mean: float = ..., angle_weighted_mean: float = ..., area_weighted_mean: float = ...) -> None: ...

class obc_polycube_corner_options(Struct):
    struct_size: int
    method: int
    area_weight: float
    domain: int
    rounds: int
    def __init__(self, struct_size: int = ..., method: int = ..., area_weight: float = ..., domain: int = ..., rounds: int = ...) -> None: ...

class obc_polycube_corner_report(Struct):
    struct_size: int
    converged: int
    energy_before: float
    energy: float
    evaluations: int
    map_evaluations: float
    moves: int
    movable: int
    angle_mean: float
    area_mean: float
    angle_weighted_mean: float
    area_weighted_mean: float
    def __init__(self, struct_size: int = ..., converged: int = ..., energy_before: float = ..., energy: float = ..., evaluations: int = ..., map_evaluations: float = ..., moves: int = ..., movable: int = ..., angle_mean: float = ..., area_mean: float = ..., angle_weighted_mean: float = ..., area_weighted_mean: float = ...) -> None: ...

class obc_polycube_feature_options(Struct):
    struct_size: int
    point_count: int
    points: Any
    targets: Any
    point_weights: Any
    curve_count: int
    curve_starts: Any
    curve_vertices: Any
    curve_lines: Any
    curve_weights: Any
    feature_angle: float
    def __init__(self, struct_size: int = ..., point_count: int = ..., points: Any = ..., targets: Any = ..., point_weights: Any = ..., curve_count: int = ..., curve_starts: Any = ..., curve_vertices: Any = ..., curve_lines: Any = ..., curve_weights: Any = ..., feature_angle: float = ...) -> None: ...

class obc_polycube_feature_report(Struct):
    struct_size: int
    distance_before: float
    distance: float
    sharp_length: float
    sharp_before: float
    sharp: float
    angle_mean: float
    area_mean: float
    angle_weighted_mean: float
    area_weighted_mean: float
    def __init__(self, struct_size: int = ..., distance_before: float = ..., distance: float = ..., sharp_length: float = ..., sharp_before: float = ..., sharp: float = ..., angle_mean: float = ..., area_mean: float = ..., angle_weighted_mean: float = ..., area_weighted_mean: float = ...) -> None: ...

class obc_polycube_constraints(Struct):
    corners: Any
    vertices: Any
    points: Any
    count: int
    def __init__(self, corners: Any = ..., vertices: Any = ..., points: Any = ..., count: int = ...) -> None: ...

class obc_polycube_quads_options(Struct):
    struct_size: int
    quads: int
    edge_length: float
    def __init__(self, struct_size: int = ..., quads: int = ..., edge_length: float = ...) -> None: ...

class obc_polycube_atlas_options(Struct):
    struct_size: int
    size: int
    padding: float
    def __init__(self, struct_size: int = ..., size: int = ..., padding: float = ...) -> None: ...

def obc_polycube_create(surface: Pointer, polycube: Pointer, host: Pointer, certificate: Pointer, out: Pointer, error: Pointer) -> int:
    """Certifies a map of other origin: `surface` in space, `polycube` the positions of its vertices on the polycube (x y z a vertex).
    certificate may be NULL; it is filled for valid and invalid maps. O(n log n) except for thousands of corners. Errors: invalid
    argument (an index out of range, a position that is not finite), no valid result (the message is the reason), out of memory,
    cancelled."""
    ...

def obc_polycube_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_polycube_compute(surface: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Computes a polycube of a closed surface of any genus and a map to it. Edges are split where required; the vertices of the surface
    come first. The polycube has about the size of the surface. The attempts depend on the surface and the options
    alone, never on time. Errors: invalid argument; not closed; not manifold; degenerate; malformed file (kind empty-mesh: no
    triangles); no valid result with the outcome of each attempt; out of memory; cancelled."""
    ...

def obc_polycube_domain_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_polycube_optimize_domain(map: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer) -> int:
    """Optimizes the proportions of the polycube: distances between the planes of its patches that minimize the distortion of the map, with
    vertices interpolated between the planes (the dissertation's section 4.3, by a projected gradient method over the logarithms of
    the distances). Combinatorics, order of the planes and total area are preserved. The result is certified; without
    improvement it is a bit-identical copy of `map`. O(n log n). Errors: invalid argument, out of memory, cancelled."""
    ...

def obc_polycube_corner_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_polycube_optimize_corners(map: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer) -> int:
    """Lowers the distortion of a map to the same polycube: the preimages of its corners move on the surface, in the unfolding of the map
    around each, and with them the edges of the polycube on the surface and the vertices between (the dissertation's section 4.4).
    Triangle edges are split along polycube edges; inserted vertices that are no longer required may go. The result is
    certified; without improvement it is a bit-identical copy of `map`. Errors: invalid argument, out of memory, cancelled."""
    ...

def obc_polycube_feature_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_polycube_align_features(map: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer) -> int:
    """Aligns features of a map to their targets on the same polycube, with minimum distortion otherwise. The result is certified. Errors:
    invalid argument (a target that is not on the polycube, a vertex with two targets); no valid result with the conflicting
    features; out of memory; cancelled."""
    ...

def obc_polycube_energy_count(map: Pointer) -> int:
    """Returns the number of energies of the optimization that computed a map: one before it and one after each iteration; 0 for NULL and
    for maps of other origin."""
    ...

def obc_polycube_copy_energies(map: Pointer, energies: Pointer, error: Pointer) -> int:
    """Copies these energies to an array of the caller, which may be NULL. Errors: invalid argument."""
    ...

def obc_polycube_destroy(map: Pointer) -> None:
    """Destroys a map; NULL is allowed."""
    ...

def obc_polycube_vertex_count(map: Pointer) -> int:
    """Return the numbers of vertices (those of the surface, then inserted ones), triangles, corners and patches of a map; 0 for NULL."""
    ...

def obc_polycube_triangle_count(map: Pointer) -> int:
    """Return the numbers of vertices (those of the surface, then inserted ones), triangles, corners and patches of a map; 0 for NULL."""
    ...

def obc_polycube_corner_count(map: Pointer) -> int:
    """Return the numbers of vertices (those of the surface, then inserted ones), triangles, corners and patches of a map; 0 for NULL."""
    ...

def obc_polycube_patch_count(map: Pointer) -> int:
    """Return the numbers of vertices (those of the surface, then inserted ones), triangles, corners and patches of a map; 0 for NULL."""
    ...

def obc_polycube_construction(map: Pointer) -> int:
    """Returns the construction of a map: OBC_POLYCUBE_LABELS, VOXELS or DISSERTATION; -1 for a map of other origin and for NULL."""
    ...

def obc_polycube_corner_points(map: Pointer, host: Pointer, count: Pointer, error: Pointer) -> int:
    """Counts the corner points of a polycube in the dissertation's sense: vertices of the rectangles that its patches are cut into, at
    least as many as its corners. O(c^3) for c corners in the worst case. Errors: invalid argument, out of memory, cancelled."""
    ...

def obc_polycube_copy(map: Pointer, positions: Pointer, polycube: Pointer, triangles: Pointer, error: Pointer) -> int:
    """Copies a map to arrays of the caller, each of which may be NULL: positions in space (x y z a vertex, bit-identical vertices of the
    surface first), positions on the polycube, and triangles (three vertices each). Errors: invalid argument."""
    ...

def obc_polycube_copy_triangles(map: Pointer, labels: Pointer, patches: Pointer, sources: Pointer, error: Pointer) -> int:
    """Copies data of each triangle, each array may be NULL: the direction of its normal on the polycube (0 to 5 for +x, -x, +y, -y, +z,
    -z), its patch, and the surface triangle that contains it. Errors: invalid argument."""
    ...

def obc_polycube_copy_sources(map: Pointer, corners: Pointer, weights: Pointer, error: Pointer) -> int:
    """Copies the origin of each vertex, three entries a vertex, each array may be NULL: vertices of one surface triangle (UINT32_MAX
    where fewer than three are needed) and their barycentric weights, positive (0 where not needed) with sum 1. Errors: invalid
    argument."""
    ...

def obc_polycube_map_to_domain(surface: Pointer, polycube: Pointer, constraints: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Maps a surface to a supplied polycube, whose triangles lie in axis-aligned planes. It is traced on the surface as with
    OBC_POLYCUBE_VOXELS: at its position, with its bounding box stretched to that of the surface, or as the constraints require. The
    polycube of the handle has the same coordinates; the map is smoothed across its edges. constraints may be NULL. Errors: those of
    obc_polycube_compute; invalid argument for constraints that do not exist or occur twice; unsupported if the second surface is not a
    polycube, with the reason; wrong genus if the genera differ."""
    ...

def obc_polycube_compute_common(surfaces: Pointer, count: int, options: Pointer, domain: Pointer, host: Pointer, constructed_from: Pointer, out: Pointer, error: Pointer) -> int:
    """Computes one polycube for several shapes of one genus and kind (the dissertation's section 4.5). Several polycubes of each shape are traced on
    all others; proportions and maps are optimized for the sum of energies, and the polycube with the minimum sum is returned. Maps between
    shapes are compositions: points with the same image on the polycube correspond. options are for the polycubes of single shapes, domain
    for the energy. out is an array of `count` handles, 1 to 65536, in the order of the surfaces, all NULL after an error. constructed_from
    (or NULL) receives the index of the shape from which the polycube was constructed. obc_polycube_copy_energies of each handle copies
    the sums, which never increase. Errors: those of obc_polycube_compute, and wrong genus."""
    ...

def obc_polycube_optimize_common_domain(maps: Pointer, count: int, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Optimizes the proportions of one polycube for several maps to it: minimizes the sum of their energies, otherwise as
    obc_polycube_optimize_domain. out is an array of `count` handles, all NULL after an error. Errors: invalid argument (also: maps
    to different polycubes), out of memory, cancelled."""
    ...

def obc_polycube_graph_create(map: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Creates the graph of a map, which may be destroyed afterwards. Errors: invalid argument, out of memory, cancelled."""
    ...

def obc_polycube_graph_destroy(graph: Pointer) -> None:
    """Destroys a graph; NULL is allowed."""
    ...

def obc_polycube_graph_corner_count(graph: Pointer) -> int:
    """Return the numbers of corners, edges, patches, loops, and links of the dual graph (each counted from both ends; patches that share
    several edges have one link); 0 for NULL."""
    ...

def obc_polycube_graph_edge_count(graph: Pointer) -> int:
    """Return the numbers of corners, edges, patches, loops, and links of the dual graph (each counted from both ends; patches that share
    several edges have one link); 0 for NULL."""
    ...

def obc_polycube_graph_patch_count(graph: Pointer) -> int:
    """Return the numbers of corners, edges, patches, loops, and links of the dual graph (each counted from both ends; patches that share
    several edges have one link); 0 for NULL."""
    ...

def obc_polycube_graph_loop_count(graph: Pointer) -> int:
    """Return the numbers of corners, edges, patches, loops, and links of the dual graph (each counted from both ends; patches that share
    several edges have one link); 0 for NULL."""
    ...

def obc_polycube_graph_link_count(graph: Pointer) -> int:
    """Return the numbers of corners, edges, patches, loops, and links of the dual graph (each counted from both ends; patches that share
    several edges have one link); 0 for NULL."""
    ...

def obc_polycube_graph_copy_corners(graph: Pointer, positions: Pointer, vertices: Pointer, error: Pointer) -> int:
    """Copies for each corner its position (x y z) and its vertex of the map. Each array may be NULL, here and in the functions below.
    Errors: invalid argument."""
    ...

def obc_polycube_graph_copy_edges(graph: Pointer, corners: Pointer, patches: Pointer, convex: Pointer, error: Pointer) -> int:
    """Copies for each edge its two corners, the patches on its left and right (from the first corner to the second, seen from outside),
    and its convexity: 1 for an interior angle of 90 degrees, 0 for 270 degrees. Errors: invalid argument."""
    ...

def obc_polycube_graph_copy_patches(graph: Pointer, labels: Pointer, coordinates: Pointer, loop_starts: Pointer, error: Pointer) -> int:
    """Copies for each patch (numbered as in obc_polycube_copy_triangles) the direction of its normal (0 to 5 for +x, -x, +y, -y, +z,
    -z), the coordinate of its plane, and the offset of its loops: the outer loop, then those around holes; loop_starts has
    one entry more than there are patches. Errors: invalid argument."""
    ...

def obc_polycube_graph_copy_loops(graph: Pointer, starts: Pointer, darts: Pointer, error: Pointer) -> int:
    """Copies for each loop the offset of its darts, with one entry more than there are loops, and its darts, counter-clockwise around
    the patch: dart 2 e is edge e from its first to its second corner, dart 2 e + 1 its reverse. Each dart is in one loop.
    Errors: invalid argument."""
    ...

def obc_polycube_graph_copy_dual(graph: Pointer, starts: Pointer, neighbors: Pointer, error: Pointer) -> int:
    """Copies the dual graph: the offset of the neighbors of each patch, with one entry more than there are patches, and the patches
    that share an edge with it, ascending. Errors: invalid argument."""
    ...

def obc_polycube_quads_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_polycube_quads_create(map: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Creates a grid with integer numbers of cells between neighboring planes and maps its vertices to the surface, each in the triangle
    that contains it by exact arithmetic. Connectivity depends on the polycube alone: maps to one polycube return the same quads.
    Errors: invalid argument (also: more than 10^7 quads), out of memory, cancelled."""
    ...

def obc_polycube_quads_destroy(quads: Pointer) -> None:
    """Destroys a quad mesh; NULL is allowed."""
    ...

def obc_polycube_quads_vertex_count(quads: Pointer) -> int:
    """Return the numbers of vertices and quads; 0 for NULL."""
    ...

def obc_polycube_quads_quad_count(quads: Pointer) -> int:
    """Return the numbers of vertices and quads; 0 for NULL."""
    ...

def obc_polycube_quads_copy(quads: Pointer, positions: Pointer, polycube: Pointer, corners: Pointer, patches: Pointer, error: Pointer) -> int:
    """Copies to arrays of the caller, each of which may be NULL: for each vertex its positions on the surface and on the polycube (x y z),
    for each quad its four vertices, counter-clockwise seen from outside, and its patch. Errors: invalid argument."""
    ...

def obc_polycube_quads_copy_sources(quads: Pointer, triangles: Pointer, weights: Pointer, error: Pointer) -> int:
    """Copies for each vertex the triangle of the map that contains it and its barycentric weights, nonnegative with sum 1. Errors:
    invalid argument."""
    ...

def obc_polycube_atlas_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_polycube_atlas_create(map: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Packs the patches of a map, which may be destroyed afterwards, at the largest scale that is found. The layout depends on the polycube
    alone. Errors: invalid argument; unsupported (the square is too small for all patches with their padding); out of memory; cancelled."""
    ...

def obc_polycube_atlas_destroy(atlas: Pointer) -> None:
    """Destroys an atlas; NULL is allowed."""
    ...

def obc_polycube_atlas_size(atlas: Pointer) -> int:
    """Return the number of texels along each side, and the number of triangles, which is that of the map; 0 for NULL."""
    ...

def obc_polycube_atlas_triangle_count(atlas: Pointer) -> int:
    """Return the number of texels along each side, and the number of triangles, which is that of the map; 0 for NULL."""
    ...

def obc_polycube_atlas_copy(atlas: Pointer, coordinates: Pointer, texels_per_unit: Pointer, coverage: Pointer, error: Pointer) -> int:
    """Copies an atlas, each output may be NULL: texture coordinates of the corners of each triangle (u v of each of the three corners; 0 to
    1, u from the left and v from the top, as in glTF), the number of texels along a unit of the polycube, and the fraction of the square
    that the patches cover (0 to 1). A vertex on an edge of the polycube has other coordinates in each of its patches. Errors: invalid
    argument."""
    ...

def obc_polycube_atlas_sample(atlas: Pointer, host: Pointer, triangles: Pointer, weights: Pointer, covered: Pointer, error: Pointer) -> int:
    """Samples an atlas: what each of its size * size texels shows, row by row from the top, so that any data of vertices becomes a texture.
    Each array may be NULL: the triangle of the map, the barycentric weights of its three corners (nonnegative, sum 1), and whether the
    middle of the texel is in that triangle (1). Beside the patches (0) texels show the point of the nearest texel in a patch, so that
    filters and smaller copies of a texture mix nothing else into its patches; where no patch has the middle of any texel, all have triangle
    UINT32_MAX and weights 0. O(texels + triangles). Errors: invalid argument, out of memory, cancelled."""
    ...

def obc_polycube_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
