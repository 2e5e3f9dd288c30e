"""Smooth octahedral frame fields on tetrahedral meshes, and their singular curves.

A solid is (positions, tetrahedra), or an object with such attributes. Frames are quaternions w x y z, a row a tetrahedron.
"""

from __future__ import annotations

from ctypes import byref
from typing import Any, Literal, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import Doubles, Indices, address, doubles, indices
from ._call import HOST, Handle, Progress, call, call_init, filled, with_options
from ._checks import public
from ._foreign import solid_of
from ._records import Record
from .raw import frame_field as raw


class _Solid:
    def __init__(self, solid: Any) -> None:
        self.positions, self.tetrahedra = solid_of(solid)
        self.struct = raw.obc_frame_field_solid(address(self.positions), len(self.positions), address(self.tetrahedra),
                                                len(self.tetrahedra))
        self.pointer = byref(self.struct)

    def frames(self, frames: ArrayLike, name: str = "frames") -> Doubles:
        return doubles(frames, 4, len(self.tetrahedra), name, each="tetrahedron")


def _report() -> raw.obc_frame_field_report:
    report = raw.obc_frame_field_report()
    call_init(raw.obc_frame_field_report_init, report)
    return report


@with_options("obc_frame_field_options")
def compute(solid: Any, *,
            # options of obc_frame_field_options, written by scripts/bindings.py
            start: Literal["auto", "identity", "propagated", "harmonic", "diffusion", "given"] = "auto",
            method: Literal["smooth", "dissertation"] = "smooth", weighting: Literal["uniform", "geometric"] = "uniform",
            align_boundary: bool = True, rounds: int = 2, feature_angle: float = 0.0, relative_gain: float = 1e-06,
            repair: Literal["no-repair", "repair", "single-axis"] = "no-repair",
            # end of options
            start_frames: Optional[ArrayLike] = None, held_frames: Optional[tuple[Any, ...]] = None, held_axes: Optional[tuple[Any, ...]] = None, threads: int = 0, progress: Progress = None) -> tuple[Doubles, raw.obc_frame_field_report]:
    """A field of small energy, and its figures. start_frames: with start="given". held_frames: (tetrahedra, frames) or
    (tetrahedra, frames, weights); held_axes: the same with a direction each."""
    chosen = filled(raw.obc_frame_field_options, raw.obc_frame_field_options_init, locals())
    given = _Solid(solid)
    if (start == "given") != (start_frames is not None):
        raise ValueError('start_frames are needed with start="given", and with no other')
    constraints = raw.obc_frame_field_constraints()
    call_init(raw.obc_frame_field_constraints_init, constraints)
    kept = []
    for one, many, width, held in (("frame", "frames", 4, held_frames), ("axis", "axes", 3, held_axes)):
        if held is None:
            continue
        name = "held_" + many
        if not isinstance(held, (tuple, list)) or len(held) not in (2, 3):
            raise TypeError(f"{name}: (tetrahedra, {many}) or (tetrahedra, {many}, weights) are needed")
        where = indices(held[0], name=f"{name}: tetrahedra", below=len(given.tetrahedra), of="tetrahedra").ravel()
        what = doubles(held[1], width, len(where), f"{name}: {many}", each="tetrahedron")
        lengths = np.linalg.norm(what, axis=1)
        for i in np.flatnonzero(np.abs(lengths ** 2 - 1) >= 1e-6)[:1]:
            raise ValueError(f"{name}: {many}[{i}] has the length {lengths[i]:.6g}, not 1")
        kept += [where, what]
        setattr(constraints, one + "_tetrahedra", address(where))
        setattr(constraints, many, address(what))
        setattr(constraints, one + "_count", len(where))
        if len(held) > 2:
            kept.append(doubles(held[2], rows=len(where), name=f"{name}: weights"))
            setattr(constraints, one + "_weights", address(kept[-1]))
    frames = np.zeros((len(given.tetrahedra), 4))
    if start_frames is not None:
        frames[:] = given.frames(start_frames, "start_frames")
    report = _report()
    call(raw.obc_frame_field_compute, given.pointer, byref(chosen), byref(constraints), HOST, address(frames),
         byref(report), threads=threads, progress=progress)
    del kept
    return frames, report


@public
def measure(solid: Any, frames: ArrayLike, *, progress: Progress = None) -> raw.obc_frame_field_report:
    """Figures of any field."""
    given, report = _Solid(solid), _report()
    field = given.frames(frames)
    call(raw.obc_frame_field_measure, given.pointer, address(field), HOST, byref(report), progress=progress)
    return report


@public
def matchings(solid: Any, frames: ArrayLike, *, progress: Progress = None) -> NDArray[np.uint8]:
    """For each tetrahedron and corner, the rotation of the cube across the face opposite."""
    given = _Solid(solid)
    field = given.frames(frames)
    found = np.empty((len(given.tetrahedra), 4), dtype=np.uint8)
    call(raw.obc_frame_field_matchings, given.pointer, address(field), HOST, address(found), progress=progress)
    return found


class Singularities(Record):
    """Singular edges and the curves that they form: edges (two vertices each), rotations, turns, curves (edge numbers each, in
    order), nodes, and where no hexahedral mesh has such a field: unmeshable_edges, unmeshable_vertices."""

    @public
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
