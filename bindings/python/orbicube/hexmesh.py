"""Hexahedral meshes of closed surfaces and of tetrahedral solids.

    mesh.write("shape.vtk", fill_with_hexahedra(shape, cells=5000))
    fill_with_hexahedra(part, fill=orbicube.tetrahedra.fill)  # machined parts along frames, as `orbicube hex` fills them
"""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import Any, Literal, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import Doubles, Indices, address, doubles, indices, numbers
from ._call import HOST, Handle, Progress, call, filled, sized, with_options
from ._foreign import parts_of, solid_of
from ._records import Record
from .mesh import Surface
from .raw import hexmesh as raw

__all__ = ["Hexes", "fill_with_hexahedra", "version"]


class MissingFeature(Record):
    """A feature that a mesh lacks: kind ("corner" or "curve"), first and last (the ends; the same for a corner), captured (fraction of the
    length of the curve), why (what was in the way)."""

    def __init__(self, handle: Handle, index: int) -> None:
        found = sized(raw.obc_hexmesh_missing)
        call(raw.obc_hexmesh_get_missing, handle, index, byref(found))
        self.kind: str = "corner" if found.corner else "curve"
        self.first: Doubles = np.array(found.first)
        self.last: Doubles = np.array(found.last)
        self.captured: float = found.captured
        self.why: str = (raw.obc_hexmesh_missing_reason(handle, index) or b"").decode()


class Hexes(Record):
    """A certified mesh of hexahedra: positions, hexahedra (eight vertices each, as MEDIT and VTK order them), quads of the
    boundary, counter-clockwise seen from outside, quad_patches (the patch that each lies on: of the polycube, or of the features where they
    are embedded), regions (the number of the region that each hexahedron is in, or 0), missing (a MissingFeature each), and the report."""

    def __init__(self, handle: Handle, report: Any) -> None:
        self.positions: Doubles = np.empty((raw.obc_hexmesh_vertex_count(handle), 3))
        self.hexahedra: Indices = np.empty((raw.obc_hexmesh_count(handle), 8), dtype=np.uint32)
        self.quads: Indices = np.empty((raw.obc_hexmesh_quad_count(handle), 4), dtype=np.uint32)
        self.quad_patches: Indices = np.empty(len(self.quads), dtype=np.uint32)
        self.regions: NDArray[np.int32] = np.zeros(len(self.hexahedra), dtype=np.int32)
        self.report = report
        call(raw.obc_hexmesh_copy, handle, address(self.positions), address(self.hexahedra), address(self.quads),
             address(self.quad_patches))
        call(raw.obc_hexmesh_copy_regions, handle, address(self.regions))
        self.missing = [MissingFeature(handle, i) for i in range(raw.obc_hexmesh_missing_count(handle))]


def _is_solid(shape: Any) -> bool:
    """Whether it has tetrahedra."""
    if isinstance(shape, (tuple, list)) and len(shape) == 2:
        return np.shape(shape[1])[1:] == (4,)
    parts = parts_of(shape, "shape")
    return parts is not None and parts.count("tetrahedra") > 0


def _set_tags(chosen: raw.obc_hexmesh_options, edges: Optional[ArrayLike], vertices: Optional[ArrayLike], count: int) -> list[Indices]:
    """Sets the tags of the options, and returns what must be kept until the call."""
    kept = []
    if edges is not None:
        kept.append(indices(edges, 2, name="tagged_edges", below=count, of="vertices", each="edge"))
        chosen.tagged_edges, chosen.tagged_edge_count = address(kept[-1]), len(kept[-1])
    if vertices is not None:
        kept.append(indices(vertices, name="tagged_vertices", below=count, of="vertices").ravel())
        chosen.tagged_vertices, chosen.tagged_vertex_count = address(kept[-1]), len(kept[-1])
    return kept


def _region_numbers(regions: ArrayLike, count: int) -> NDArray[np.int32]:
    given = numbers(regions, "regions")
    if given.shape != (count,) or given.dtype.kind not in "iu":
        raise ValueError(f"regions: an integer for each of the {count} tetrahedra is needed")
    if given.size and (given.min() < -2**31 or given.max() >= 2**31):
        raise ValueError("regions: 32 bits do not hold a number")
    return np.ascontiguousarray(given, dtype=np.int32)


def _set_fill(chosen: raw.obc_hexmesh_options, fill: Any) -> None:
    if fill is None:
        return
    from . import tetrahedra
    from .raw import tetrahedra as raw_tetrahedra

    if fill is not tetrahedra.fill:
        raise TypeError("fill: orbicube.tetrahedra.fill is needed, or None")
    function: Any = raw_tetrahedra.obc_tetrahedra_fill_mesh
    chosen.fill = ctypes.cast(function, raw.obc_hexmesh_fill_function)


@with_options("obc_hexmesh_options")
def fill_with_hexahedra(shape: Any, frames: Optional[ArrayLike] = None, *,
                        # options of obc_hexmesh_options, written by scripts/bindings.py
                        padding: Literal["auto", "with", "without"] = "auto", cells: int = 10000, corners: int = 100,
                        triangles: int = 6000, seed: int = 0, rounds: int = 40,
                        method: Literal["auto", "polycube", "grid", "frames"] = "auto", max_hausdorff_percent: float = 1.0,
                        max_cells: int = 100000, feature_angle: float = -1.0,
                        features: Literal["off", "auto", "tags", "angles", "machined"] = "machined",
                        # end of options
                        tagged_edges: Optional[ArrayLike] = None, tagged_vertices: Optional[ArrayLike] = None, fill: Any = None,
                        regions: Optional[ArrayLike] = None, threads: int = 0, progress: Progress = None) -> Hexes:
    """Fills a closed surface, or a solid of tetrahedra, with the bits of `orbicube hex`. frames: of a solid, w x y z a tetrahedron as of
    frame_field.compute, which the hexahedra follow. fill: None, or orbicube.tetrahedra.fill (TetGen, AGPL), by which surfaces go along
    frames too. features: which sharp edges and corners the mesh should have; tagged_edges (two vertices each) and tagged_vertices: those that
    "auto" and "tags" consider. regions: a number for each tetrahedron of a solid; faces of hexahedra follow where they meet. The report has min_scaled_jacobian, mean_scaled_jacobian, volume, hausdorff_percent, method, captured, ..."""
    chosen = filled(raw.obc_hexmesh_options, raw.obc_hexmesh_options_init, locals())
    _set_fill(chosen, fill)
    report, handle = sized(raw.obc_hexmesh_report), Handle(raw.obc_hexmesh_destroy)
    if frames is not None or _is_solid(shape):
        positions, tetrahedra = solid_of(shape, "shape")
        kept = _set_tags(chosen, tagged_edges, tagged_vertices, len(positions))
        of_cells = None if regions is None else _region_numbers(regions, len(tetrahedra))
        if of_cells is not None:
            chosen.regions, chosen.region_count = address(of_cells), len(of_cells)
        field = None if frames is None else doubles(frames, 4, len(tetrahedra), "frames", each="tetrahedron")
        call(raw.obc_hexmesh_compute_solid, address(positions), len(positions), address(tetrahedra), len(tetrahedra),
             address(field), byref(chosen), HOST, byref(report), byref(handle), threads=threads, progress=progress)
    else:
        if regions is not None:
            raise ValueError("regions: those of tetrahedra, and the shape has none")
        given = Surface(shape, "shape")
        kept = _set_tags(chosen, tagged_edges, tagged_vertices, len(given.positions))
        call(raw.obc_hexmesh_compute, given.pointer, byref(chosen), HOST, byref(report), byref(handle), threads=threads,
             progress=progress)
    del kept
    try:
        return Hexes(handle, report)
    finally:
        handle.close()


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_hexmesh_version()
