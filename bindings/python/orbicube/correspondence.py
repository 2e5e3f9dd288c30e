"""Closed surfaces on one triangulation, through spheres or a common polycube, and their blends.

    both = Correspondence([a, b], via="polycube")
    halfway = both.blend([0.5, 0.5])

Options are the members of `obc_correspondence_options`; docs/correspondence.md of the library describes the methods.
"""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import Any, Literal, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, Indices, address, doubles
from ._call import Handle, KeptHost, Progress, call, filled, with_options
from ._checks import integer, public
from .mesh import Surface
from .raw import correspondence as raw
from .raw.mesh import obc_surface

__all__ = ["Correspondence", "version"]


class Correspondence:
    """Surfaces on one triangulation, whose vertex i is at corresponding points of all. Genus-0 surfaces with via="sphere", two to
    ten of one genus with via="polycube"."""

    @with_options("obc_correspondence_options")
    def __init__(self, surfaces: Sequence[Any], *,
                 # options of obc_correspondence_options, written by scripts/bindings.py
                 via: Literal["sphere", "polycube"] = "sphere", align: Literal["shape", "rotation", "none"] = "shape",
                 grid: Literal["both", "first"] = "both", placement: Literal["kept", "turned", "scaled"] = "kept",
                 tolerance: float = 0.2, cells: int = 0, corners: int = 0, seed: int = 0,
                 # end of options
                 progress: Progress = None, threads: int = 0) -> None:
        chosen = filled(raw.obc_correspondence_options, raw.obc_correspondence_options_init, locals())
        given = [Surface(surface) for surface in surfaces]
        views = (obc_surface * len(given))(*(surface.struct for surface in given))
        handle = ctypes.c_void_p()
        self._host = KeptHost(threads)
        self._host.call(raw.obc_correspondence_create, views, len(given), byref(chosen), byref(self._host.host), byref(handle),
                        progress=progress)
        self._handle = Handle(raw.obc_correspondence_destroy, handle.value)

    @property
    def shape_count(self) -> int:
        """The number of surfaces."""
        return int(raw.obc_correspondence_shape_count(self._handle))

    @property
    def triangles(self) -> Indices:
        """The triangulation of all surfaces."""
        result = np.empty((raw.obc_correspondence_triangle_count(self._handle), 3), dtype=np.uint32)
        call(raw.obc_correspondence_copy, self._handle, 0, None, address(result))
        return result

    @public
    def positions(self, shape: int) -> Doubles:
        """The positions of the vertices on one of the surfaces."""
        result = np.empty((raw.obc_correspondence_vertex_count(self._handle), 3))
        call(raw.obc_correspondence_copy, self._handle, integer(shape, "shape", 0, self.shape_count - 1), address(result), None)
        return result

    @public
    def blend(self, weights: ArrayLike) -> Doubles:
        """The sum of the positions on all surfaces times weights, one each."""
        chosen = doubles(weights, name="weights")
        if chosen.shape != (self.shape_count,):
            raise ValueError(f"weights: {self.shape_count} numbers are needed, not shape {chosen.shape}")
        result = np.empty((raw.obc_correspondence_vertex_count(self._handle), 3))
        call(raw.obc_correspondence_blend, self._handle, address(chosen), chosen.size, address(result))
        return result


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_correspondence_version()
