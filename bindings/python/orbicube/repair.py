"""Any triangles to a closed, oriented, manifold surface, with a certificate of what was reached.

    repaired = repair((positions, triangles))
    if repaired.report.closed and repaired.report.manifold: ...
    surface = surface_of_label(labels, affine, label=4)

Options are the members of `obc_repair_options`; docs/repair.md of the library describes the steps.
"""

from __future__ import annotations

from ctypes import byref
from typing import Any, Optional

import numpy as np

from ._arrays import Doubles, Indices, address, doubles, numbers
from ._call import HOST, Handle, Progress, call, call_init, filled, with_options
from ._records import Record
from .mesh import Surface
from .raw import repair as raw

__all__ = ["LabelSurface", "Repaired", "repair", "surface_of_label", "version"]


class Repaired(Record):
    """positions and triangles; vertex_source and triangle_source, their numbers in the input (2 ** 32 - 1: made by the repair); the
    report; and events, what was done where: (action, count, place, size) each, as the header describes them."""

    def __init__(self, positions: Doubles, triangles: Indices, vertex_source: Indices, triangle_source: Indices,
                 report: raw.obc_repair_report, events: list[tuple[str, int, tuple[float, ...], float]]) -> None:
        self.positions, self.triangles = positions, triangles
        self.vertex_source, self.triangle_source = vertex_source, triangle_source
        self.report, self.events = report, events


def _events(handle: Handle) -> list[tuple[str, int, tuple[float, ...], float]]:
    count = raw.obc_repair_event_count(handle)
    actions, counts = np.empty(count, dtype=np.int32), np.empty(count, dtype=np.uint32)
    places, sizes = np.empty((count, 3)), np.empty(count)
    call(raw.obc_repair_copy_events, handle, address(actions), address(counts), address(places), address(sizes))
    return [((raw.obc_repair_action_name(int(action)) or b"").decode(), int(number), tuple(map(float, place)), float(size))
            for action, number, place, size in zip(actions, counts, places, sizes)]


@with_options("obc_repair_options")
def repair(surface: Any, *,
           # options of obc_repair_options, written by scripts/bindings.py
           weld: bool = True, clean: bool = True, slivers: bool = True, t_junctions: bool = True, orient: bool = True,
           contacts: bool = True, drop_parts: bool = True, cavities: bool = False, fill_holes: bool = True,
           fair: bool = True, find_intersections: bool = True, max_genus: int = -1, weld_distance: float = 0.0,
           sliver_ratio: float = 1e-06, sliver_move: float = 0.0, t_junction_distance: float = 0.0, contact_gap: float = 0.0,
           min_area_percent: float = 0.0, keep_parts: int = 1, max_hole_edges: int = 0, max_handle_length: float = 0.0,
           wrap_offset: float = 0.0,
           # end of options
           threads: int = 0, progress: Progress = None) -> Repaired:
    """Repairs a surface. Whether a closed, oriented manifold was reached is in the report."""
    chosen = filled(raw.obc_repair_options, raw.obc_repair_options_init, locals())
    given, handle = Surface(surface), Handle(raw.obc_repair_destroy)
    call(raw.obc_repair_compute, given.pointer, byref(chosen), HOST, byref(handle), threads=threads, progress=progress)
    try:
        positions = np.empty((raw.obc_repair_vertex_count(handle), 3))
        triangles = np.empty((raw.obc_repair_triangle_count(handle), 3), dtype=np.uint32)
        vertices, faces = np.empty(len(positions), dtype=np.uint32), np.empty(len(triangles), dtype=np.uint32)
        call(raw.obc_repair_copy, handle, address(positions), address(triangles), address(vertices), address(faces))
        report = raw.obc_repair_report()
        call_init(raw.obc_repair_report_init, report)
        call(raw.obc_repair_get_report, handle, byref(report))
        return Repaired(positions, triangles, vertices, faces, report, _events(handle))
    finally:
        handle.close()


class LabelSurface(Record):
    """positions and triangles of the surface of a label; label_report, what was done; and report, with the certificate."""

    def __init__(self, positions: Doubles, triangles: Indices, label_report: raw.obc_repair_label_report,
                 report: raw.obc_repair_report) -> None:
        self.positions, self.triangles, self.label_report, self.report = positions, triangles, label_report, report


def _labels(values: Any) -> Any:
    array = numbers(values, "labels")
    if array.dtype.kind not in "biu":
        raise TypeError(f"labels: integers are needed, not {array.dtype}")
    if array.ndim != 3:
        raise ValueError(f"labels: an array with three axes x, y, z is needed, not shape {array.shape}")
    if array.size and (int(array.min()) < -2**31 or int(array.max()) >= 2**31):
        raise ValueError(f"labels: from {array.min()} to {array.max()}, not within -2^31 to 2^31 - 1")
    return np.asfortranarray(array, dtype=np.int32)


@with_options("obc_repair_label_options")
def surface_of_label(labels: Any, to_world: Any = None, *,
                     # options of obc_repair_label_options, written by scripts/bindings.py
                     label: int = 0, cavities: bool = False, handles: bool = False, keep_parts: int = 1,
                     smoothing: float = 1.0, max_slide: float = 0.45,
                     # end of options
                     threads: int = 0, progress: Progress = None) -> LabelSurface:
    """Extracts the closed surface of a label of an image: labels[x, y, z], integers, and to_world, the 4x4 matrix from voxel numbers to
    positions, as the `affine` of nibabel; None: positions are voxel numbers."""
    chosen = filled(raw.obc_repair_label_options, raw.obc_repair_label_options_init, locals())
    image, handle = _labels(labels), Handle(raw.obc_repair_destroy)
    matrix = None if to_world is None else doubles(to_world, 4, 4, "to_world")
    size = np.array(image.shape, dtype=np.uintp)
    call(raw.obc_repair_surface_of_label, image.ctypes.data, address(size), address(matrix), byref(chosen), HOST, byref(handle),
         threads=threads, progress=progress)
    try:
        positions = np.empty((raw.obc_repair_vertex_count(handle), 3))
        triangles = np.empty((raw.obc_repair_triangle_count(handle), 3), dtype=np.uint32)
        call(raw.obc_repair_copy, handle, address(positions), address(triangles), None, None)
        report, label_report = raw.obc_repair_report(), raw.obc_repair_label_report()
        call_init(raw.obc_repair_report_init, report)
        call_init(raw.obc_repair_label_report_init, label_report)
        call(raw.obc_repair_get_report, handle, byref(report))
        call(raw.obc_repair_get_label_report, handle, byref(label_report))
        return LabelSurface(positions, triangles, label_report, report)
    finally:
        handle.close()


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_repair_version()
