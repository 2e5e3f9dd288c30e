"""What <orbicube/volume_map.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

class obc_volume_map_solid_options(Struct):
    struct_size: int
    reserved: int
    corners: int
    seed: int
    def __init__(self, struct_size: int = ..., reserved: int = ..., corners: int = ..., seed: int = ...) -> None: ...

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

def obc_volume_map_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
