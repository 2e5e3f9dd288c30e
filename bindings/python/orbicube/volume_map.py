"""Maps of tetrahedral meshes without inverted tetrahedra.

    positions, report = untangle((positions, tetrahedra), rest=rest_positions, fixed=fixed)
    solid = map_to_polycube((positions, tetrahedra))
"""

from __future__ import annotations

from ctypes import byref
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, Indices, address, doubles, indices, numbers
from ._call import HOST, Handle, NoValidResult, Progress, call, call_init, filled, with_options
from ._foreign import solid_of
from ._records import Record
from .raw import volume_map as raw

__all__ = ["Solid", "map_to_polycube", "untangle", "version"]


@with_options("obc_volume_map_untangle_options")
def untangle(solid: Any, *,
             # options of obc_volume_map_untangle_options, written by scripts/bindings.py
             steps: int = 500, polish_steps: int = 20, volume_weight: float = 1.0,
             # end of options
             rest: Optional[ArrayLike] = None, fixed: Optional[ArrayLike] = None, ties: Optional[ArrayLike] = None, threads: int = 0, progress: Progress = None) -> tuple[Doubles, raw.obc_volume_map_untangle_report]:
    """Moves vertices until every tetrahedron is positive: positions, and a report. rest: positions where each has the shape
    that it should have. fixed: a flag a coordinate, shape (n, 3), or a vertex, shape (n,). ties: a group a coordinate, of which
    all are to be equal, or 2^32 - 1. When some stay inverted, the NoValidResult has the
    best that was found, positions and report, as its member `best`."""
    chosen = filled(raw.obc_volume_map_untangle_options, raw.obc_volume_map_untangle_options_init, locals())
    positions, tetrahedra = solid_of(solid)
    problem = raw.obc_volume_map_untangle_problem()
    call_init(raw.obc_volume_map_untangle_problem_init, problem)
    problem.positions, problem.vertex_count = address(positions), len(positions)
    problem.tetrahedra, problem.tetrahedron_count = address(tetrahedra), len(tetrahedra)
    kept: list[Any] = []
    if rest is not None:
        kept.append(doubles(rest, 3, len(positions), "rest", each="vertex"))
        problem.rest = address(kept[-1])
    if fixed is not None:
        flags = numbers(fixed, "fixed")
        if flags.shape not in (positions.shape, (len(positions),)) or not np.all((flags == 0) | (flags == 1)):
            raise ValueError(f"fixed: a flag for each coordinate, shape {positions.shape}, or for each vertex, shape "
                             f"({len(positions)},), is needed, not shape {flags.shape}")
        flags = flags[:, None] if flags.ndim == 1 else flags
        kept.append(np.ascontiguousarray(np.broadcast_to(flags, positions.shape), dtype=np.uint8))
        problem.fixed = address(kept[-1])
    if ties is not None:
        kept.append(indices(ties, 3, len(positions), "ties", each="vertex"))
        problem.ties = address(kept[-1])
    report = raw.obc_volume_map_untangle_report()
    call_init(raw.obc_volume_map_untangle_report_init, report)
    result = np.empty_like(positions)
    try:
        call(raw.obc_volume_map_untangle, byref(problem), byref(chosen), HOST, address(result), byref(report),
             threads=threads, progress=progress)
    except NoValidResult as error:
        error.best = (result, report)
        raise
    return result, report


class Solid(Record):
    """A solid and the same on the polycube of its boundary: positions, polycube, and the tetrahedra of both."""

    def __init__(self, positions: Doubles, polycube: Doubles, tetrahedra: Indices) -> None:
        self.positions, self.polycube, self.tetrahedra = positions, polycube, tetrahedra


@with_options("obc_volume_map_solid_options")
def map_to_polycube(solid: Any, *,
                    # options of obc_volume_map_solid_options, written by scripts/bindings.py
                    corners: int = 100, seed: int = 0,
                    # end of options
                    threads: int = 0, progress: Progress = None) -> Solid:
    """Maps positive tetrahedra one to one to a polycube, splitting them where that is needed."""
    chosen = filled(raw.obc_volume_map_solid_options, raw.obc_volume_map_solid_options_init, locals())
    positions, tetrahedra = solid_of(solid)
    handle = Handle(raw.obc_volume_map_solid_destroy)
    call(raw.obc_volume_map_solid_compute, address(positions), len(positions), address(tetrahedra), len(tetrahedra),
         byref(chosen), HOST, byref(handle), threads=threads, progress=progress)
    try:
        places = np.empty((raw.obc_volume_map_solid_vertex_count(handle), 3))
        on_polycube = np.empty_like(places)
        cells = np.empty((raw.obc_volume_map_solid_tetrahedron_count(handle), 4), dtype=np.uint32)
        call(raw.obc_volume_map_solid_copy, handle, address(places), address(on_polycube), address(cells))
        return Solid(places, on_polycube, cells)
    finally:
        handle.close()


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_volume_map_version()
