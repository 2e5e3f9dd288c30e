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

from ._arrays import Doubles, Indices, address, doubles, indices
from ._call import HOST, Handle, KeptHost, Progress, call, filled, with_options
from ._checks import integer, public
from .mesh import Surface
from .raw import correspondence as raw
from .raw.mesh import obc_surface

__all__ = ["Correspondence", "version"]


class Correspondence:
    """Surfaces on one triangulation, whose vertex i is at corresponding points of all. Genus-0 surfaces with via="sphere", two to
    ten of one genus with via="polycube". landmarks: for each surface x y z of points that correspond."""

    @with_options("obc_correspondence_options")
    def __init__(self, surfaces: Sequence[Any], *,
                 # options of obc_correspondence_options, written by scripts/bindings.py
                 via: Literal["sphere", "polycube"] = "sphere", align: Literal["shape", "rotation", "none"] = "shape",
                 grid: Literal["both", "first", "icosphere", "cube", "latitude", "octahedron"] = "both",
                 placement: Literal["kept", "turned", "scaled"] = "kept", tolerance: float = 0.2, cells: int = 0,
                 corners: int = 0, seed: int = 0, resolution: int = 0,
                 # end of options
                 landmarks: Optional[Sequence[ArrayLike]] = None, progress: Progress = None, threads: int = 0) -> None:
        chosen = filled(raw.obc_correspondence_options, raw.obc_correspondence_options_init, locals())
        given = [Surface(surface) for surface in surfaces]
        kept = None
        if landmarks is not None:
            if len(landmarks) != len(given):
                raise ValueError(f"landmarks: one array for each of the {len(given)} surfaces is needed, not {len(landmarks)}")
            rows = [doubles(points, 3, name="landmarks") for points in landmarks]
            if any(len(points) != len(rows[0]) for points in rows):
                raise ValueError("landmarks: each surface must have as many")
            kept = np.ascontiguousarray(np.concatenate(rows))
            chosen.landmark_count, chosen.landmarks = len(rows[0]), address(kept)
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

    @property
    def domain(self) -> Doubles:
        """The positions of the vertices on the common sphere or polycube, where every triangle is positive."""
        result = np.empty((raw.obc_correspondence_vertex_count(self._handle), 3))
        call(raw.obc_correspondence_copy_domain, self._handle, address(result))
        return result

    @property
    def quads(self) -> Indices:
        """The quads of the polycube's grid, whose halves are the triangles 2 q and 2 q + 1; none for other triangulations."""
        result = np.empty((raw.obc_correspondence_quad_count(self._handle), 4), dtype=np.uint32)
        call(raw.obc_correspondence_copy_quads, self._handle, address(result))
        return result

    @public
    def map(self, source: int, target: int, triangles: Optional[ArrayLike] = None, weights: Optional[ArrayLike] = None, *,
            progress: Progress = None, threads: int = 0) -> tuple[Indices, Doubles]:
        """Where points of the source surface are on the target: triangles of the target and weights at their corners. The points are
        triangles of the source with weights, or all of its vertices; a vertex in no triangle gets 2**32 - 1 and weights of 0."""
        last = self.shape_count - 1
        source, target = integer(source, "source", 0, last), integer(target, "target", 0, last)
        if (triangles is None) != (weights is None):
            raise ValueError("triangles and weights go together")
        if triangles is None:
            count = int(raw.obc_correspondence_surface_vertex_count(self._handle, source))
            to, at = np.empty(count, dtype=np.uint32), np.empty((count, 3))
            call(raw.obc_correspondence_map_vertices, self._handle, source, target, HOST, address(to), address(at),
                 progress=progress, threads=threads)
            return to, at
        of = indices(triangles, name="triangles").ravel()
        given = doubles(weights, 3, len(of), "weights", each="of the triangles")
        to, at = np.empty(len(of), dtype=np.uint32), np.empty((len(of), 3))
        call(raw.obc_correspondence_map, self._handle, source, target, address(of), address(given), len(of), HOST, address(to),
             address(at), progress=progress, threads=threads)
        return to, at

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
