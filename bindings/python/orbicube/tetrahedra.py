"""Closed surfaces filled with tetrahedra by TetGen, whose licence, the AGPL 3, binds programs that use this module. It is
not in the wheel: it works where the library orbicube-tetrahedra is installed."""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, Indices, address, doubles
from ._call import HOST, Handle, Progress, call, filled
from .mesh import Surface
from .raw import tetrahedra as raw


class Solid:
    """positions (the surface's first), tetrahedra, triangles (the boundary), boundary_source, parts and cavities."""

    def __init__(self, positions: Doubles, tetrahedra: Indices, triangles: Indices, boundary_source: Indices, parts: int,
                 cavities: int) -> None:
        self.positions, self.tetrahedra, self.triangles = positions, tetrahedra, triangles
        self.boundary_source, self.parts, self.cavities = boundary_source, parts, cavities


def fill(surface: Any, *, size_positions: Optional[ArrayLike] = None, size_lengths: Optional[ArrayLike] = None,
         progress: Progress = None, **options: Any) -> Solid:
    """Fills a closed surface. Options: keep_surface, quality, max_volume, edge_length, size_growth."""
    given, handle = Surface(surface), Handle(raw.obc_tetrahedra_destroy)
    chosen = filled(raw.obc_tetrahedra_options, raw.obc_tetrahedra_options_init, options)
    places = lengths = None
    if size_positions is not None:
        places = doubles(size_positions, 3, name="size_positions")
        lengths = doubles(size_lengths, rows=len(places), name="size_lengths")
        chosen.size_positions, chosen.size_lengths, chosen.size_count = address(places), address(lengths), len(places)
    call(raw.obc_tetrahedra_fill, given.pointer, byref(chosen), HOST, byref(handle), progress=progress)
    try:
        positions = np.empty((raw.obc_tetrahedra_vertex_count(handle), 3))
        tetrahedra = np.empty((raw.obc_tetrahedra_count(handle), 4), dtype=np.uint32)
        boundary = np.empty((raw.obc_tetrahedra_boundary_count(handle), 3), dtype=np.uint32)
        source = np.empty(len(boundary), dtype=np.uint32)
        call(raw.obc_tetrahedra_copy, handle, address(positions), address(tetrahedra), address(boundary), address(source))
        return Solid(positions, tetrahedra, boundary, source, raw.obc_tetrahedra_part_count(handle),
                     raw.obc_tetrahedra_cavity_count(handle))
    finally:
        handle.close()


def check_surface(surface: Any, *, threads: int = 0, progress: Progress = None) -> None:
    """Raises, with kind and place, unless `fill` can work."""
    given, count = Surface(surface), ctypes.c_size_t()
    call(raw.obc_tetrahedra_check_surface, given.pointer, HOST, None, 0, byref(count), threads=threads, progress=progress)


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_tetrahedra_version()
