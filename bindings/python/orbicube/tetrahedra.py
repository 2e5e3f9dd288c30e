"""Closed surfaces filled with tetrahedra by TetGen, whose license, the AGPL 3, binds programs that use this module. It is
not in the wheel: it works where the library orbicube-tetrahedra is installed."""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, Indices, address, doubles
from ._call import HOST, Handle, Progress, call, filled, with_options
from ._checks import public
from ._records import Record
from .mesh import Surface
from .raw import tetrahedra as raw


class Solid(Record):
    """positions (the surface's first), tetrahedra, triangles (the boundary), boundary_source, parts and cavities."""

    def __init__(self, positions: Doubles, tetrahedra: Indices, triangles: Indices, boundary_source: Indices, parts: int,
                 cavities: int) -> None:
        self.positions, self.tetrahedra, self.triangles = positions, tetrahedra, triangles
        self.boundary_source, self.parts, self.cavities = boundary_source, parts, cavities


@with_options("obc_tetrahedra_options")
def fill(surface: Any, *,
         # options of obc_tetrahedra_options, written by scripts/bindings.py
         keep_surface: bool = True, quality: float = 1.4, max_volume: float = 0.0, edge_length: float = 0.0,
         size_growth: float = 0.3,
         # end of options
         size_positions: Optional[ArrayLike] = None, size_lengths: Optional[ArrayLike] = None, progress: Progress = None) -> Solid:
    """Fills a closed surface. size_lengths: of edges near size_positions."""
    chosen = filled(raw.obc_tetrahedra_options, raw.obc_tetrahedra_options_init, locals())
    given, handle = Surface(surface), Handle(raw.obc_tetrahedra_destroy)
    places = lengths = None
    if (size_positions is None) != (size_lengths is None):
        raise TypeError("size_positions and size_lengths are needed together")
    if size_positions is not None:
        places = doubles(size_positions, 3, name="size_positions")
        lengths = doubles(size_lengths, rows=len(places), name="size_lengths", each="position")
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


@public
def check_surface(surface: Any, *, threads: int = 0, progress: Progress = None) -> None:
    """Raises, with kind and place, unless `fill` can work."""
    given, count = Surface(surface), ctypes.c_size_t()
    call(raw.obc_tetrahedra_check_surface, given.pointer, HOST, None, 0, byref(count), threads=threads, progress=progress)


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_tetrahedra_version()
