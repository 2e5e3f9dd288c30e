"""Maps of solids to polycubes without inverted tetrahedra.

    solid = map_to_polycube((positions, tetrahedra))
"""

from __future__ import annotations

from ctypes import byref
from typing import Any

import numpy as np

from ._arrays import Doubles, Indices, address
from ._call import HOST, Handle, Progress, call, filled, with_options
from ._foreign import solid_of
from ._records import Record
from .raw import volume_map as raw

__all__ = ["Solid", "map_to_polycube", "version"]


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
