"""Smooth octahedral frame fields on tetrahedral meshes, and their singular curves.

A solid is (positions, tetrahedra), or an object with such attributes. Frames are quaternions w x y z, a row a tetrahedron.
"""

from __future__ import annotations

from ctypes import byref
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import Doubles, Indices, address, doubles, indices, solid_of
from ._call import HOST, Handle, Progress, call, call_init, filled
from .raw import frame_field as raw


class _Solid:
    def __init__(self, solid: Any) -> None:
        self.positions, self.tetrahedra = solid_of(solid)
        self.struct = raw.obc_frame_field_solid(address(self.positions), len(self.positions), address(self.tetrahedra),
                                                len(self.tetrahedra))
        self.pointer = byref(self.struct)

    def frames(self, frames: ArrayLike) -> Doubles:
        return doubles(frames, 4, len(self.tetrahedra), "frames")


def _report() -> raw.obc_frame_field_report:
    report = raw.obc_frame_field_report()
    call_init(raw.obc_frame_field_report_init, report)
    return report


def compute(solid: Any, *, start_frames: Optional[ArrayLike] = None,
            held_frames: Optional[tuple[Any, ...]] = None, held_axes: Optional[tuple[Any, ...]] = None, threads: int = 0,
            progress: Progress = None, **options: Any) -> tuple[Doubles, raw.obc_frame_field_report]:
    """A field of small energy, and its figures. start_frames: with start="given". held_frames: (tetrahedra, frames) or
    (tetrahedra, frames, weights); held_axes: the same with a direction each. Options: start, method, weighting,
    align_boundary, rounds, feature_angle, relative_gain, repair ("no-repair", "repair", "single-axis")."""
    given = _Solid(solid)
    chosen = filled(raw.obc_frame_field_options, raw.obc_frame_field_options_init, options, raw, "OBC_FRAME_FIELD_")
    constraints = raw.obc_frame_field_constraints()
    call_init(raw.obc_frame_field_constraints_init, constraints)
    kept = []
    for one, many, width, held in (("frame", "frames", 4, held_frames), ("axis", "axes", 3, held_axes)):
        if held is None:
            continue
        where = indices(held[0], name="tetrahedra")
        what = doubles(held[1], width, len(where), many)
        kept += [where, what]
        setattr(constraints, one + "_tetrahedra", address(where))
        setattr(constraints, many, address(what))
        setattr(constraints, one + "_count", len(where))
        if len(held) > 2:
            kept.append(doubles(held[2], rows=len(where), name="weights"))
            setattr(constraints, one + "_weights", address(kept[-1]))
    frames = np.zeros((len(given.tetrahedra), 4))
    if start_frames is not None:
        frames[:] = given.frames(start_frames)
    report = _report()
    call(raw.obc_frame_field_compute, given.pointer, byref(chosen), byref(constraints), HOST, address(frames),
         byref(report), threads=threads, progress=progress)
    del kept
    return frames, report


def measure(solid: Any, frames: ArrayLike, *, progress: Progress = None) -> raw.obc_frame_field_report:
    """Figures of any field."""
    given, report = _Solid(solid), _report()
    field = given.frames(frames)
    call(raw.obc_frame_field_measure, given.pointer, address(field), HOST, byref(report), progress=progress)
    return report


def matchings(solid: Any, frames: ArrayLike, *, progress: Progress = None) -> NDArray[np.uint8]:
    """For each tetrahedron and corner, the rotation of the cube across the face opposite."""
    given = _Solid(solid)
    field = given.frames(frames)
    found = np.empty((len(given.tetrahedra), 4), dtype=np.uint8)
    call(raw.obc_frame_field_matchings, given.pointer, address(field), HOST, address(found), progress=progress)
    return found


class Singularities:
    """Singular edges and the curves that they form: edges (two vertices each), rotations, turns, curves (edge numbers each, in
    order), nodes, and where no hexahedral mesh has such a field: unmeshable_edges, unmeshable_vertices."""

    def __init__(self, solid: Any, frames: ArrayLike, *, progress: Progress = None) -> None:
        given, handle = _Solid(solid), Handle(raw.obc_frame_field_singularities_destroy)
        field = given.frames(frames)
        call(raw.obc_frame_field_singularities_create, given.pointer, address(field), HOST, byref(handle), progress=progress)
        edges = raw.obc_frame_field_singular_edge_count(handle)
        curves = raw.obc_frame_field_singular_curve_count(handle)
        self.edges: Indices = np.empty((edges, 2), dtype=np.uint32)
        self.rotations = np.empty(edges, dtype=np.uint8)
        self.turns = np.empty(edges, dtype=np.int8)
        begin, along = np.zeros(curves + 1, dtype=np.uintp), np.empty(edges, dtype=np.uint32)
        self.nodes: Indices = np.empty(raw.obc_frame_field_singular_node_count(handle), dtype=np.uint32)
        call(raw.obc_frame_field_singularities_copy, handle, address(self.edges), address(self.rotations),
             address(self.turns), address(begin), address(along), address(self.nodes))
        self.curves: list[Indices] = [along[begin[i]:begin[i + 1]] for i in range(curves)]
        self.unmeshable_edges: Indices = np.empty(raw.obc_frame_field_unmeshable_edge_count(handle), dtype=np.uint32)
        self.unmeshable_vertices: Indices = np.empty(raw.obc_frame_field_unmeshable_vertex_count(handle), dtype=np.uint32)
        call(raw.obc_frame_field_unmeshable_copy, handle, address(self.unmeshable_edges), address(self.unmeshable_vertices))
        handle.close()


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_frame_field_version()
