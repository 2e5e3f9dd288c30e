"""What <orbicube/volume_map.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

class obc_volume_map_tangle(Struct):
    struct_size: int
    reserved: int
    positions: Any
    vertex_count: int
    tetrahedra: Any
    tetrahedron_count: int
    rest: Any
    fixed: Any
    ties: Any
    def __init__(self, struct_size: int = ..., reserved: int = ..., positions: Any = ..., vertex_count: int = ..., tetrahedra: Any = ..., tetrahedron_count: int = ..., rest: Any = ..., fixed: Any = ..., ties: Any = ...) -> None: ...

class obc_volume_map_untangle_options(Struct):
    struct_size: int
    steps: int
    polish_steps: int
    reserved: int
    volume_weight: float
    def __init__(self, struct_size: int = ..., steps: int = ..., polish_steps: int = ..., reserved: int = ..., volume_weight: float = ...) -> None: ...

class obc_volume_map_untangle_report(Struct):
    struct_size: int
    first_inverted: int
    inverted_before: int
    inverted: int
    steps: int
    polish_steps: int
    least_determinant: float
    greatest_determinant: float
    energy: float
    def __init__(self, struct_size: int = ..., first_inverted: int = ..., inverted_before: int = ..., inverted: int = ..., steps: int = ..., polish_steps: int = ..., least_determinant: float = ..., greatest_determinant: float = ..., energy: float = ...) -> None: ...

def obc_volume_map_tangle_init(tangle: Pointer, struct_size: int) -> int:
    """A mesh of nothing; the defaults, which the members' comments give; zeros."""
    ...

def obc_volume_map_untangle_options_init(options: Pointer, struct_size: int) -> int:
    """A mesh of nothing; the defaults, which the members' comments give; zeros."""
    ...

def obc_volume_map_untangle_report_init(report: Pointer, struct_size: int) -> int:
    """A mesh of nothing; the defaults, which the members' comments give; zeros."""
    ...

def obc_volume_map_untangle(tangle: Pointer, options: Pointer, host: Pointer, result: Pointer, report: Pointer, error: Pointer) -> int:
    """Moves vertices until all tetrahedra are positive: result gets x y z a vertex, fixed coordinates to the bit, tied ones the
    same bits. A mesh without inverted tetrahedra is only polished. options, host and report may be NULL; result may be
    tangle->positions. About 500 bytes a tetrahedron; a step is O(n) but for its conjugate gradients, 150 at most.
    Errors: no valid result (some stay inverted: how many and the first; result and report then have the best that was found, on
    all other errors nothing); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
    malformed file (kind index-range), degenerate (kinds degenerate-cell and inverted-cell: a repeated vertex, a tetrahedron of
    rest that is not positive; degenerate-geometry: no volume at all), out of memory, cancelled."""
    ...

def obc_volume_map_version() -> int:
    """Version of this library, major * 10000 + minor * 100 + patch."""
    ...
