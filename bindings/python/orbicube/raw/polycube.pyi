"""What <orbicube/polycube.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_POLYCUBE_AUTO: int
OBC_POLYCUBE_LABELS: int
OBC_POLYCUBE_VOXELS: int

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
    def __init__(self, struct_size: int = ..., construction: int = ..., corners: int = ..., seed: int = ...) -> None: ...

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
    places: Any
    point_weights: Any
    curve_count: int
    curve_starts: Any
    curve_vertices: Any
    curve_lines: Any
    curve_weights: Any
    sharp_angle: float
    def __init__(self, struct_size: int = ..., point_count: int = ..., points: Any = ..., places: Any = ..., point_weights: Any = ..., curve_count: int = ..., curve_starts: Any = ..., curve_vertices: Any = ..., curve_lines: Any = ..., curve_weights: Any = ..., sharp_angle: float = ...) -> None: ...

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

class obc_polycube_places(Struct):
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

def obc_polycube_create(surface: Pointer, polycube: Pointer, host: Pointer, certificate: Pointer, out: Pointer, error: Pointer) -> int:
    """Certifies a map made elsewhere: `surface` in space, `polycube` where its vertices are to be on the polycube (x y z a vertex).
    certificate may be NULL; it is filled whether the map is valid or not. Errors: invalid argument (an index out of range, a
    position that is not finite), no valid result (the message is the reason), out of memory, cancelled. O(n log n) unless there
    are thousands of corners."""
    ...

def obc_polycube_options_init(options: Pointer, struct_size: int) -> int:
    """The defaults, which the members' comments give."""
    ...

def obc_polycube_compute(surface: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Finds a polycube of a closed surface of any genus, and a map to it. Edges are split where that is needed; the vertices of
    the surface come first. The polycube has about the size of the surface. What is tried depends on the surface and the options
    alone, never on time.
    Errors: invalid argument; not closed, not manifold, degenerate, malformed file (kind empty-mesh: no triangles); no valid
    result with what became of each attempt; out of memory, cancelled."""
    ...

def obc_polycube_domain_options_init(options: Pointer, struct_size: int) -> int:
    """The defaults, which the members' comments give."""
    ...

def obc_polycube_optimize_domain(map: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer) -> int:
    """The polycube with the best proportions: distances between the planes of its faces that minimise the map's distortion, vertices
    going with the planes beside them (the dissertation's section 4.3, by a projected gradient method over the logarithms of the
    distances). Combinatorics, order of the planes and total area stay. The result is certified again; it is a copy of `map` to
    the bit when nothing better is found. report may be NULL, here and below. Errors: invalid argument, out of memory, cancelled.
    O(n log n)."""
    ...

def obc_polycube_corner_options_init(options: Pointer, struct_size: int) -> int:
    """The defaults, which the members' comments give."""
    ...

def obc_polycube_optimize_corners(map: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer) -> int:
    """A less distorted map to the same polycube: what of the surface goes to its corners moves, in the map's own unfolding around
    each, and with it the polycube's edges on the surface and all between (the dissertation's section 4.4). Edges of triangles
    are split where the polycube's are drawn; added vertices that serve none any more may go. Certified again; a copy of `map`
    to the bit when nothing better is found. Errors: invalid argument, out of memory, cancelled."""
    ...

def obc_polycube_feature_options_init(options: Pointer, struct_size: int) -> int:
    """The defaults, which the members' comments give."""
    ...

def obc_polycube_meet_features(map: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer) -> int:
    """A map to the same polycube with features in their places, and all else as little distorted as that allows. Certified again.
    Errors: invalid argument (a place that is not on the polycube, a vertex with two); no valid result, with what cannot be met;
    out of memory, cancelled."""
    ...

def obc_polycube_energy_count(map: Pointer) -> int:
    """The energies of the optimisation that a map comes from: before it, then after each iteration; 0 for NULL and maps that come from
    none."""
    ...

def obc_polycube_copy_energies(map: Pointer, energies: Pointer, error: Pointer) -> int:
    """Copies them to the caller's array, which may be NULL. Errors: invalid argument."""
    ...

def obc_polycube_destroy(map: Pointer) -> None:
    """Releases a map; NULL is fine."""
    ...

def obc_polycube_vertex_count(map: Pointer) -> int:
    """Numbers of a map; 0 for NULL. Vertices: those of the surface, then those added."""
    ...

def obc_polycube_triangle_count(map: Pointer) -> int:
    """Numbers of a map; 0 for NULL. Vertices: those of the surface, then those added."""
    ...

def obc_polycube_corner_count(map: Pointer) -> int:
    """Numbers of a map; 0 for NULL. Vertices: those of the surface, then those added."""
    ...

def obc_polycube_patch_count(map: Pointer) -> int:
    """Numbers of a map; 0 for NULL. Vertices: those of the surface, then those added."""
    ...

def obc_polycube_construction(map: Pointer) -> int:
    """What found the map: OBC_POLYCUBE_LABELS or OBC_POLYCUBE_VOXELS; -1 for a map made elsewhere, and for NULL."""
    ...

def obc_polycube_copy(map: Pointer, positions: Pointer, polycube: Pointer, triangles: Pointer, error: Pointer) -> int:
    """Copies to the caller's arrays, each of which may be NULL: positions in space (x y z a vertex; the surface's vertices first, to
    the bit), polycube positions, triangles (three vertices each). Errors: invalid argument."""
    ...

def obc_polycube_copy_triangles(map: Pointer, labels: Pointer, patches: Pointer, sources: Pointer, error: Pointer) -> int:
    """Copies what is known of each triangle, each array may be NULL: the direction it looks in on the polycube (0 to 5 for +x, -x, +y,
    -y, +z, -z), its face of the polycube, and the surface's triangle that it lies in. Errors: invalid argument."""
    ...

def obc_polycube_copy_sources(map: Pointer, corners: Pointer, weights: Pointer, error: Pointer) -> int:
    """Copies where each vertex comes from, three entries a vertex, each array may be NULL: vertices of one triangle of the surface
    (UINT32_MAX where fewer than three are needed) and their weights, positive (0 where not needed) with the sum 1. Errors:
    invalid argument."""
    ...

def obc_polycube_compute_on(surface: Pointer, polycube: Pointer, places: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Maps a surface to a polycube that is given by its triangles, each in an axis-aligned plane. It is drawn on the surface, as
    OBC_POLYCUBE_VOXELS does with its own: where it stands, its box stretched to that of the surface, or where the places say.
    The handle's polycube has the very coordinates of the one given; the map is smoothed across its edges. places may be NULL.
    Errors: those of obc_polycube_compute; invalid argument for places that do not exist or are given twice; unsupported when the
    polycube is none, with the reason; wrong genus when the surface has another."""
    ...

def obc_polycube_compute_common(surfaces: Pointer, count: int, options: Pointer, domain: Pointer, host: Pointer, made_for: Pointer, out: Pointer, error: Pointer) -> int:
    """One polycube for several shapes of one genus and kind (the dissertation's section 4.5): several polycubes of each are drawn on
    all others, proportions and maps are optimised for the sum of energies, and the one with the least sum is kept. Maps between
    shapes are compositions: what is at one point of the polycube corresponds. options are for each shape's own polycube, domain
    for the energy. out is an array of `count` handles, in the order of the surfaces, all NULL after an error; made_for may be NULL
    or gets the number of the shape that the polycube was made for. obc_polycube_copy_energies of each handle gives the sums,
    which never rise. Errors: those of obc_polycube_compute, and wrong genus."""
    ...

def obc_polycube_optimize_common_domain(maps: Pointer, count: int, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """obc_polycube_optimize_domain for several maps to one and the same polycube: the proportions with the least sum of energies.
    out is an array of `count` handles, all NULL after an error. Errors: invalid argument (among them maps to different
    polycubes), out of memory, cancelled."""
    ...

def obc_polycube_graph_create(map: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Errors: invalid argument, out of memory, cancelled."""
    ...

def obc_polycube_graph_destroy(graph: Pointer) -> None:
    """Releases a graph; NULL is fine."""
    ...

def obc_polycube_graph_corner_count(graph: Pointer) -> int:
    """Numbers; 0 for NULL. Links: of the dual graph, where patches that share several edges are neighbours once, each link counted
    from both ends."""
    ...

def obc_polycube_graph_edge_count(graph: Pointer) -> int:
    """Numbers; 0 for NULL. Links: of the dual graph, where patches that share several edges are neighbours once, each link counted
    from both ends."""
    ...

def obc_polycube_graph_patch_count(graph: Pointer) -> int:
    """Numbers; 0 for NULL. Links: of the dual graph, where patches that share several edges are neighbours once, each link counted
    from both ends."""
    ...

def obc_polycube_graph_loop_count(graph: Pointer) -> int:
    """Numbers; 0 for NULL. Links: of the dual graph, where patches that share several edges are neighbours once, each link counted
    from both ends."""
    ...

def obc_polycube_graph_link_count(graph: Pointer) -> int:
    """Numbers; 0 for NULL. Links: of the dual graph, where patches that share several edges are neighbours once, each link counted
    from both ends."""
    ...

def obc_polycube_graph_copy_corners(graph: Pointer, positions: Pointer, vertices: Pointer, error: Pointer) -> int:
    """Copies to the caller's arrays, each of which may be NULL, as in all these functions. Of each corner its position (x y z) and
    its vertex of the map. Errors: invalid argument."""
    ...

def obc_polycube_graph_copy_edges(graph: Pointer, corners: Pointer, patches: Pointer, convex: Pointer, error: Pointer) -> int:
    """Of each edge: its two corners, the patches on the left and on the right of the way from the first to the second, seen from
    outside, and whether the solid has one right angle there (1, convex) or three (0, concave)."""
    ...

def obc_polycube_graph_copy_patches(graph: Pointer, labels: Pointer, coordinates: Pointer, loop_starts: Pointer, error: Pointer) -> int:
    """Of each patch, which has the number that obc_polycube_copy_triangles gives: the direction it looks in (0 to 5 for +x, -x, +y,
    -y, +z, -z), the coordinate of its plane, and where its loops begin among all loops: first the one around it, then those
    around its holes; loop_starts has an entry more than there are patches."""
    ...

def obc_polycube_graph_copy_loops(graph: Pointer, starts: Pointer, darts: Pointer, error: Pointer) -> int:
    """Of each loop where it begins among all darts, with an entry more than there are loops, and its darts, counter-clockwise around
    the patch: dart 2 e is edge e from its first corner to its second, dart 2 e + 1 the way back. Each dart is in one loop."""
    ...

def obc_polycube_graph_copy_dual(graph: Pointer, starts: Pointer, neighbours: Pointer, error: Pointer) -> int:
    """The dual graph: where the neighbours of each patch begin, with an entry more than there are patches, and the patches that
    share an edge with it, ascending."""
    ...

def obc_polycube_quads_options_init(options: Pointer, struct_size: int) -> int:
    """The defaults, which the members' comments give."""
    ...

def obc_polycube_quads_create(map: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Makes the grid, with integer numbers of cells between neighbouring planes, and takes its vertices to the surface, each
    in the triangle that has it by exact arithmetic. Depends on the polycube alone, but for positions: maps to one polycube give
    the same quads. Errors: invalid argument (among them more than 10^8 quads), out of memory, cancelled."""
    ...

def obc_polycube_quads_destroy(quads: Pointer) -> None:
    """Releases quads; NULL is fine."""
    ...

def obc_polycube_quads_vertex_count(quads: Pointer) -> int:
    """Numbers; 0 for NULL."""
    ...

def obc_polycube_quads_quad_count(quads: Pointer) -> int:
    """Numbers; 0 for NULL."""
    ...

def obc_polycube_quads_copy(quads: Pointer, positions: Pointer, polycube: Pointer, corners: Pointer, patches: Pointer, error: Pointer) -> int:
    """Copies to the caller's arrays, each of which may be NULL: of each vertex its position on the surface and on the polycube (x y
    z), of each quad its four vertices, counter-clockwise seen from outside, and its patch. Errors: invalid argument."""
    ...

def obc_polycube_quads_copy_sources(quads: Pointer, triangles: Pointer, weights: Pointer, error: Pointer) -> int:
    """Of each vertex the triangle of the map that it is in and its weights at the three corners, none negative, with the sum 1."""
    ...

def obc_polycube_version() -> int:
    """Version of this library, major * 10000 + minor * 100 + patch."""
    ...
