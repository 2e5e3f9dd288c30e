"""What <orbicube/volume_map.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

class obc_volume_map_solid_options(Struct):
    struct_size: int
    reserved: int
    corners: int
    seed: int
    def __init__(self, struct_size: int = ..., reserved: int = ..., corners: int = ..., seed: int = ...) -> None: ...

class obc_volume_map_frame_map_options(Struct):
    struct_size: int
    integer: int
    cell_length: float
    feature_angle: float
    def __init__(self, struct_size: int = ..., integer: int = ..., cell_length: float = ..., feature_angle: float = ...) -> None: ...

class obc_volume_map_frame_map_report(Struct):
    struct_size: int
    integers_optimal: int
    energy: float
    integer_cost: float
    residual: float
    cell_length: float
    inverted: int
    integers: int
    patches: int
    cut_faces: int
    singular_edges: int
    solves: int
    def __init__(self, struct_size: int = ..., integers_optimal: int = ..., energy: float = ..., integer_cost: float = ..., residual: float = ..., cell_length: float = ..., inverted: int = ..., integers: int = ..., patches: int = ..., cut_faces: int = ..., singular_edges: int = ..., solves: int = ...) -> None: ...

def obc_volume_map_solid_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_volume_map_solid_compute(positions: Pointer, vertex_count: int, tetrahedra: Pointer, tetrahedron_count: int, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Computes a polycube of the boundary of a solid and a map of the solid to it. Every tetrahedron is positive on the polycube and in
    space, and the boundary covers the polycube once. positions: x y z a vertex; tetrahedra: four vertices each, positive, conforming.
    Tetrahedra are split where the map requires it. The polycube of a cavity lies within that of the outer boundary; polycubes of
    several pieces stand side by side along x. options and host may be NULL; the allocator of the host must remain valid until
    _destroy. Takes minutes for a hundred thousand tetrahedra.
    Errors: invalid argument; malformed file (index-range); degenerate; not manifold; not closed; no valid result with the
    obstacle; out of memory; cancelled."""
    ...

def obc_volume_map_solid_destroy(solid: Pointer) -> None:
    """Destroys a map; NULL is allowed."""
    ...

def obc_volume_map_solid_vertex_count(solid: Pointer) -> int:
    """Return the number of vertices and of tetrahedra after splits; 0 for NULL."""
    ...

def obc_volume_map_solid_tetrahedron_count(solid: Pointer) -> int:
    """Return the number of vertices and of tetrahedra after splits; 0 for NULL."""
    ...

def obc_volume_map_solid_copy(solid: Pointer, positions: Pointer, polycube: Pointer, tetrahedra: Pointer, error: Pointer) -> int:
    """Copies positions in space and on the polycube (x y z a vertex) and tetrahedra (four vertices each); each may be NULL.
    Errors: invalid argument."""
    ...

def obc_volume_map_frame_map_options_init(options: Pointer, struct_size: int) -> int:
    """Fill options with the defaults, and a report with zeros."""
    ...

def obc_volume_map_frame_map_report_init(report: Pointer, struct_size: int) -> int:
    """Fill options with the defaults, and a report with zeros."""
    ...

def obc_volume_map_frame_map_compute(positions: Pointer, vertex_count: int, tetrahedra: Pointer, tetrahedron_count: int, frames: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer) -> int:
    """Computes the parameterization of a solid as it is: nothing is split or untangled, so that tetrahedra may be inverted. positions:
    x y z a vertex; tetrahedra: four vertices each, positive, conforming; frames: w x y z a tetrahedron, units, or NULL for computed
    ones. options, host and report may be NULL; the allocator of the host must remain valid until _destroy. Takes the time of a sparse
    direct solver, about 10 s for a hundred thousand tetrahedra.
    Errors: no valid result (frames that no map follows, with the place); invalid argument; malformed file (index-range); degenerate;
    not manifold; out of memory; cancelled."""
    ...

def obc_volume_map_frame_map_destroy(map: Pointer) -> None:
    """Destroys a parameterization; NULL is allowed."""
    ...

def obc_volume_map_frame_map_tetrahedron_count(map: Pointer) -> int:
    """Return the number of tetrahedra and of singular edges; 0 for NULL."""
    ...

def obc_volume_map_frame_map_singular_edge_count(map: Pointer) -> int:
    """Return the number of tetrahedra and of singular edges; 0 for NULL."""
    ...

def obc_volume_map_frame_map_copy(map: Pointer, parameters: Pointer, rotations: Pointer, gaps: Pointer, cut: Pointer, labels: Pointer, singular_edges: Pointer, error: Pointer) -> int:
    """Copies, each unless NULL: parameters, the coordinates of the corners (12 a tetrahedron); of each face 4 t + k, opposite corner k of
    tetrahedron t: the number of the rotation M to the chart beyond (obc_quaternion_cube_element), the gap g (three), 1 where the face
    is cut and 0 elsewhere, and 2 axis + (1 where the axis is outward-oriented) of the constant coordinate on the boundary; singular
    edges, two vertices each.
    Errors: invalid argument."""
    ...

def obc_volume_map_locator_create(positions: Pointer, vertex_count: int, tetrahedra: Pointer, tetrahedron_count: int, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Creates a locator; it copies the mesh. The allocator of the host must remain valid until _destroy. host may be NULL.
    Errors: invalid argument; malformed file (index-range); out of memory; cancelled."""
    ...

def obc_volume_map_locator_destroy(locator: Pointer) -> None:
    """Destroys a locator; NULL is allowed."""
    ...

def obc_volume_map_locator_locate(locator: Pointer, points: Pointer, point_count: int, host: Pointer, tetrahedra: Pointer, weights: Pointer, error: Pointer) -> int:
    """Finds the tetrahedron of each point (x y z), UINT32_MAX where there is none, and the four weights of its corners, which add up to 1
    (zeros where there is none); each output may be NULL. Weights may be -1e-9 at the boundary. Where tetrahedra share a point, the one
    that holds it deepest is found, of equals the first. O(log n) a point; the same for any number of threads. host may be NULL. A locator
    may be used by several threads at once.
    Errors: invalid argument; out of memory; cancelled."""
    ...

def obc_volume_map_locator_interpolate(locator: Pointer, tetrahedra: Pointer, weights: Pointer, point_count: int, values: Pointer, components: int, host: Pointer, images: Pointer, error: Pointer) -> int:
    """Computes images of located points: the weighted sums of values at the corners, `components` numbers a vertex of the mesh. images
    receives `components` numbers a point, NaN where there is no tetrahedron. host may be NULL.
    Errors: invalid argument; out of memory; cancelled."""
    ...

def obc_volume_map_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
