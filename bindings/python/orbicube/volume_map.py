"""Maps of solids to polycubes without inverted tetrahedra.

    solid = map_to_polycube((positions, tetrahedra))
    f = PiecewiseLinearMap(solid.positions, solid.polycube, solid.tetrahedra)    # f(points), f.inverse(points)
    map = parameterize((positions, tetrahedra))                                  # coordinates along frames
"""

from __future__ import annotations

from ctypes import byref
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, Indices, address, doubles, indices
from ._call import HOST, Handle, Progress, call, filled, sized, with_options
from ._checks import public
from ._foreign import solid_of
from ._records import Record
from .raw import volume_map as raw

__all__ = ["FrameMap", "Locator", "PiecewiseLinearMap", "Solid", "map_to_polycube", "parameterize", "version"]


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


class FrameMap(Record):
    """A parameterization along frames. parameters: coordinates of the corners, (m, 4, 3). Of each face, opposite its corner:
    rotations, the number of the rotation to the chart beyond, and gaps, (m, 4) and (m, 4, 3); cut, whether it has a transition;
    labels, 2 axis + (1 where outward-oriented) on the boundary. singular_edges: pairs of vertices. report: figures."""

    def __init__(self, parameters: Doubles, rotations: Any, gaps: Doubles, cut: Any, labels: Any, singular_edges: Indices,
                 report: raw.obc_volume_map_frame_map_report) -> None:
        self.parameters, self.rotations, self.gaps, self.cut = parameters, rotations, gaps, cut
        self.labels, self.singular_edges, self.report = labels, singular_edges, report


@with_options("obc_volume_map_frame_map_options")
def parameterize(solid: Any, frames: Optional[ArrayLike] = None, *,
                 # options of obc_volume_map_frame_map_options, written by scripts/bindings.py
                 integer: bool = False, cell_length: float = 0.0, feature_angle: float = 0.0,
                 # end of options
                 threads: int = 0, progress: Progress = None) -> FrameMap:
    """Computes coordinates whose gradients are the axes of the frames (w x y z a tetrahedron; None: computed ones). Nothing is split
    or untangled: report.inverted counts inverted tetrahedra."""
    chosen = filled(raw.obc_volume_map_frame_map_options, raw.obc_volume_map_frame_map_options_init, locals())
    positions, tetrahedra = solid_of(solid)
    count = len(tetrahedra)
    quaternions = None if frames is None else doubles(frames, 4, count, "frames", each="tetrahedron")
    report = sized(raw.obc_volume_map_frame_map_report)
    handle = Handle(raw.obc_volume_map_frame_map_destroy)
    call(raw.obc_volume_map_frame_map_compute, address(positions), len(positions), address(tetrahedra), count,
         None if quaternions is None else address(quaternions), byref(chosen), HOST, byref(report), byref(handle),
         threads=threads, progress=progress)
    try:
        parameters, gaps = np.empty((count, 4, 3)), np.empty((count, 4, 3))
        rotations, cut, labels = (np.empty((count, 4), dtype=np.uint8) for _ in range(3))
        edges = np.empty((raw.obc_volume_map_frame_map_singular_edge_count(handle), 2), dtype=np.uint32)
        call(raw.obc_volume_map_frame_map_copy, handle, address(parameters), address(rotations), address(gaps), address(cut),
             address(labels), address(edges))
        return FrameMap(parameters, rotations, gaps, cut.astype(bool), labels, edges, report)
    finally:
        handle.close()


class Locator:
    """Finds points in a mesh of tetrahedra."""

    @public
    def __init__(self, solid: Any, *, threads: int = 0, progress: Progress = None) -> None:
        positions, tetrahedra = solid_of(solid)
        self._sizes = len(positions), len(tetrahedra)
        self._handle = Handle(raw.obc_volume_map_locator_destroy)
        call(raw.obc_volume_map_locator_create, address(positions), len(positions), address(tetrahedra), len(tetrahedra),
             HOST, byref(self._handle), threads=threads, progress=progress)

    @public
    def locate(self, points: ArrayLike, *, threads: int = 0, progress: Progress = None) -> tuple[Indices, Doubles]:
        """The tetrahedron of each point, 2^32 - 1 for none, and the weights of its four corners."""
        asked = doubles(points, 3, name="points")
        tetrahedra, weights = np.empty(len(asked), dtype=np.uint32), np.empty((len(asked), 4))
        call(raw.obc_volume_map_locator_locate, self._handle, address(asked), len(asked), HOST, address(tetrahedra),
             address(weights), threads=threads, progress=progress)
        return tetrahedra, weights

    @public
    def sample(self, points: ArrayLike, values: ArrayLike, *, threads: int = 0, progress: Progress = None) -> Doubles:
        """Values of the vertices, interpolated at points; NaN where there is no tetrahedron."""
        given = doubles(values, rows=self._sizes[0], name="values", each="vertex")
        tetrahedra, weights = self.locate(points, threads=threads, progress=progress)
        sampled = np.empty((len(tetrahedra),) + given.shape[1:])
        call(raw.obc_volume_map_locator_interpolate, self._handle, address(tetrahedra), address(weights), len(tetrahedra),
             address(given), given.size // max(1, len(given)), HOST, address(sampled), threads=threads, progress=progress)
        return sampled


class PiecewiseLinearMap:
    """A map of a solid as a function of points, and its inverse: positions and image of the same tetrahedra."""

    @public
    def __init__(self, positions: ArrayLike, image: ArrayLike, tetrahedra: ArrayLike, *, threads: int = 0,
                 progress: Progress = None) -> None:
        self._positions = doubles(positions, 3, name="positions")
        self._image = doubles(image, 3, len(self._positions), "image", each="vertex")
        cells = indices(tetrahedra, 4, name="tetrahedra", below=len(self._positions), of="vertices")
        self._forward = Locator((self._positions, cells), threads=threads, progress=progress)
        self._backward = Locator((self._image, cells), threads=threads, progress=progress)

    @public
    def __call__(self, points: ArrayLike, *, threads: int = 0, progress: Progress = None) -> Doubles:
        """The images of points; NaN outside."""
        return self._forward.sample(points, self._image, threads=threads, progress=progress)

    @public
    def inverse(self, points: ArrayLike, *, threads: int = 0, progress: Progress = None) -> Doubles:
        """The points with these images; NaN outside."""
        return self._backward.sample(points, self._positions, threads=threads, progress=progress)


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_volume_map_version()
