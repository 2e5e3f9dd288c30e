"""Polycubes of closed surfaces, and certified maps to them.

    cube = compute(mesh.make("bracket", 5000))
    better = cube.optimize_domain()
    better.positions, better.polycube, better.triangles
"""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import Any, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import Doubles, Indices, address, doubles, indices
from ._call import HOST, Handle, Progress, call, filled, sized
from .mesh import Surface
from .raw import mesh as raw_mesh
from .raw import polycube as raw


class Polycube:
    """A certified map. `report` is that of the optimisation that it comes from, if it comes from one."""

    def __init__(self, handle: Handle, report: Any = None) -> None:
        self._handle, self.report = handle, report

    def __repr__(self) -> str:
        return f"Polycube({self.corner_count} corners, {self.patch_count} patches, {self.vertex_count} vertices)"

    @property
    def vertex_count(self) -> int:
        return raw.obc_polycube_vertex_count(self._handle)

    @property
    def triangle_count(self) -> int:
        return raw.obc_polycube_triangle_count(self._handle)

    @property
    def corner_count(self) -> int:
        return raw.obc_polycube_corner_count(self._handle)

    @property
    def patch_count(self) -> int:
        return raw.obc_polycube_patch_count(self._handle)

    @property
    def construction(self) -> Optional[str]:
        """What found it: "labels", "voxels", or None for a map made elsewhere."""
        return {raw.OBC_POLYCUBE_LABELS: "labels", raw.OBC_POLYCUBE_VOXELS: "voxels"}.get(
            raw.obc_polycube_construction(self._handle))

    @property
    def positions(self) -> Doubles:
        """In space, the surface's vertices first."""
        out = np.empty((self.vertex_count, 3))
        call(raw.obc_polycube_copy, self._handle, address(out), None, None)
        return out

    @property
    def polycube(self) -> Doubles:
        """The same vertices on the polycube."""
        out = np.empty((self.vertex_count, 3))
        call(raw.obc_polycube_copy, self._handle, None, address(out), None)
        return out

    @property
    def triangles(self) -> Indices:
        out = np.empty((self.triangle_count, 3), dtype=np.uint32)
        call(raw.obc_polycube_copy, self._handle, None, None, address(out))
        return out

    def of_triangles(self) -> tuple[NDArray[np.uint8], Indices, Indices]:
        """Of each triangle: its direction (0 to 5 for +x, -x, +y, -y, +z, -z), its patch, the surface's triangle."""
        n = self.triangle_count
        labels, patches, sources = np.empty(n, np.uint8), np.empty(n, np.uint32), np.empty(n, np.uint32)
        call(raw.obc_polycube_copy_triangles, self._handle, address(labels), address(patches), address(sources))
        return labels, patches, sources

    def sources(self) -> tuple[Indices, Doubles]:
        """Where each vertex comes from: vertices of a triangle of the surface, and their weights."""
        corners, weights = np.empty((self.vertex_count, 3), np.uint32), np.empty((self.vertex_count, 3))
        call(raw.obc_polycube_copy_sources, self._handle, address(corners), address(weights))
        return corners, weights

    @property
    def energies(self) -> Doubles:
        """Of the optimisation that it comes from; they never rise."""
        out = np.empty(raw.obc_polycube_energy_count(self._handle))
        call(raw.obc_polycube_copy_energies, self._handle, address(out))
        return out

    def optimize_domain(self, *, progress: Progress = None, threads: int = 0, **options: Any) -> Polycube:
        """The best distances between the planes. Options: measure ("surface-mean", "face-mean", "harmonic"), area_weight."""
        chosen, report, handle = _domain(options), sized(raw.obc_polycube_domain_report), Handle(raw.obc_polycube_destroy)
        call(raw.obc_polycube_optimize_domain, self._handle, byref(chosen), HOST, byref(report), byref(handle),
             progress=progress, threads=threads)
        return Polycube(handle, report)

    def optimize_corners(self, *, progress: Progress = None, threads: int = 0, **options: Any) -> Polycube:
        """Better places of the corners on the surface. Options: method ("trust-region", "gradient"), area_weight, domain,
        rounds."""
        chosen = filled(raw.obc_polycube_corner_options, raw.obc_polycube_corner_options_init, options, raw, "OBC_POLYCUBE_")
        report, handle = sized(raw.obc_polycube_corner_report), Handle(raw.obc_polycube_destroy)
        call(raw.obc_polycube_optimize_corners, self._handle, byref(chosen), HOST, byref(report), byref(handle),
             progress=progress, threads=threads)
        return Polycube(handle, report)

    def meet_features(self, vertices: ArrayLike = (), places: ArrayLike = (), *, weights: Optional[ArrayLike] = None,
                      curves: Sequence[tuple[Any, ...]] = (), sharp_angle: float = 0, progress: Progress = None,
                      threads: int = 0) -> Polycube:
        """The same polycube with vertices in places on it, each curve (vertices, from, to and perhaps a weight) along a
        line, and sharp edges on its edges. Without weights all of that is met exactly."""
        chosen = filled(raw.obc_polycube_feature_options, raw.obc_polycube_feature_options_init,
                        {"sharp_angle": sharp_angle})
        report, handle = sized(raw.obc_polycube_feature_report), Handle(raw.obc_polycube_destroy)
        points = indices(vertices, name="vertices")
        kept: list[Any] = [points, doubles(places, 3, len(points), "places")]
        chosen.point_count, chosen.points, chosen.places = len(points), address(points), address(kept[1])
        if weights is not None:
            kept.append(doubles(weights, rows=len(points), name="weights"))
            chosen.point_weights = address(kept[-1])
        if curves:
            rows = [indices(curve[0], name="curves") for curve in curves]
            kept += [np.concatenate(rows), np.cumsum([0] + [len(row) for row in rows], dtype=np.uint32),
                     doubles([[curve[1], curve[2]] for curve in curves]),
                     doubles([curve[3] if len(curve) > 3 else 0 for curve in curves])]
            chosen.curve_count = len(rows)
            chosen.curve_vertices, chosen.curve_starts, chosen.curve_lines, chosen.curve_weights = map(address, kept[-4:])
        call(raw.obc_polycube_meet_features, self._handle, byref(chosen), HOST, byref(report), byref(handle),
             progress=progress, threads=threads)
        return Polycube(handle, report)

    def graph(self, *, progress: Progress = None) -> Graph:
        return Graph(self, progress=progress)

    def quads(self, *, progress: Progress = None, **options: Any) -> Quads:
        """A mesh of quads on the surface. Options: quads, edge_length."""
        return Quads(self, options, progress)


class Graph:
    """Corners, straight edges and patches of a polycube, without its triangles."""

    def __init__(self, map: Polycube, *, progress: Progress = None) -> None:
        handle = Handle(raw.obc_polycube_graph_destroy)
        call(raw.obc_polycube_graph_create, map._handle, HOST, byref(handle), progress=progress)
        corners, edges = raw.obc_polycube_graph_corner_count(handle), raw.obc_polycube_graph_edge_count(handle)
        patches, loops = raw.obc_polycube_graph_patch_count(handle), raw.obc_polycube_graph_loop_count(handle)
        links = raw.obc_polycube_graph_link_count(handle)

        def numbers(*shape: int) -> Indices:
            return np.empty(shape, dtype=np.uint32)

        self.corner_positions, self.corner_vertices = np.empty((corners, 3)), numbers(corners)
        call(raw.obc_polycube_graph_copy_corners, handle, address(self.corner_positions), address(self.corner_vertices))
        self.edge_corners, self.edge_patches, convex = numbers(edges, 2), numbers(edges, 2), np.empty(edges, np.uint8)
        call(raw.obc_polycube_graph_copy_edges, handle, address(self.edge_corners), address(self.edge_patches),
             address(convex))
        self.edge_convex = convex.astype(bool)
        self.patch_labels, self.patch_coordinates = np.empty(patches, np.uint8), np.empty(patches)
        self.patch_loop_starts = numbers(patches + 1)
        call(raw.obc_polycube_graph_copy_patches, handle, address(self.patch_labels), address(self.patch_coordinates),
             address(self.patch_loop_starts))
        self.loop_starts, self.darts = numbers(loops + 1), numbers(2 * edges)
        call(raw.obc_polycube_graph_copy_loops, handle, address(self.loop_starts), address(self.darts))
        self.dual_starts, self.dual_neighbours = numbers(patches + 1), numbers(links)
        call(raw.obc_polycube_graph_copy_dual, handle, address(self.dual_starts), address(self.dual_neighbours))
        handle.close()


class Quads:
    """A mesh of quads: positions, polycube (the same vertices on it), quads, patches, and where vertices lie in the map:
    triangles and weights."""

    def __init__(self, map: Polycube, options: dict[str, Any], progress: Progress) -> None:
        chosen = filled(raw.obc_polycube_quads_options, raw.obc_polycube_quads_options_init, options)
        handle = Handle(raw.obc_polycube_quads_destroy)
        call(raw.obc_polycube_quads_create, map._handle, byref(chosen), HOST, byref(handle), progress=progress)
        n, m = raw.obc_polycube_quads_vertex_count(handle), raw.obc_polycube_quads_quad_count(handle)
        self.positions, self.polycube = np.empty((n, 3)), np.empty((n, 3))
        self.quads, self.patches = np.empty((m, 4), np.uint32), np.empty(m, np.uint32)
        call(raw.obc_polycube_quads_copy, handle, address(self.positions), address(self.polycube), address(self.quads),
             address(self.patches))
        self.triangles, self.weights = np.empty(n, np.uint32), np.empty((n, 3))
        call(raw.obc_polycube_quads_copy_sources, handle, address(self.triangles), address(self.weights))
        handle.close()


def _options(options: dict[str, Any]) -> Any:
    return filled(raw.obc_polycube_options, raw.obc_polycube_options_init, options, raw, "OBC_POLYCUBE_")


def _domain(options: dict[str, Any]) -> Any:
    return filled(raw.obc_polycube_domain_options, raw.obc_polycube_domain_options_init, options, raw, "OBC_POLYCUBE_")


def compute(surface: Any, *, progress: Progress = None, threads: int = 0, **options: Any) -> Polycube:
    """A polycube of a closed surface of any genus, and a map to it. Options: construction ("auto", "labels", "voxels"),
    corners, seed."""
    given, chosen, handle = Surface(surface), _options(options), Handle(raw.obc_polycube_destroy)
    call(raw.obc_polycube_compute, given.pointer, byref(chosen), HOST, byref(handle), progress=progress, threads=threads)
    return Polycube(handle)


def certify(surface: Any, polycube: ArrayLike, *, progress: Progress = None) -> Polycube:
    """A map made elsewhere, if it is one; NoValidResult says why not."""
    given, handle = Surface(surface), Handle(raw.obc_polycube_destroy)
    places = doubles(polycube, 3, len(given.positions), "polycube")
    call(raw.obc_polycube_create, given.pointer, address(places), HOST, None, byref(handle), progress=progress)
    return Polycube(handle)


def compute_on(surface: Any, polycube: Any, *, corners: Optional[ArrayLike] = None, vertices: Optional[ArrayLike] = None,
               points: Optional[ArrayLike] = None, progress: Progress = None, threads: int = 0) -> Polycube:
    """Maps a surface to the given polycube; corners of it are put at vertices of the surface, or nearest to points."""
    given, target, handle = Surface(surface), Surface(polycube), Handle(raw.obc_polycube_destroy)
    places = raw.obc_polycube_places()
    kept: list[Any] = []
    if corners is not None:
        kept.append(indices(corners, name="corners"))
        places.corners, places.count = address(kept[0]), len(kept[0])
        if vertices is not None:
            kept.append(indices(vertices, rows=places.count, name="vertices"))
            places.vertices = address(kept[-1])
        if points is not None:
            kept.append(doubles(points, 3, places.count, "points"))
            places.points = address(kept[-1])
    call(raw.obc_polycube_compute_on, given.pointer, target.pointer, byref(places) if kept else None, HOST, byref(handle),
         progress=progress, threads=threads)
    return Polycube(handle)


class _Handles:
    """Several at once: an array that C fills."""

    def __init__(self, count: int) -> None:
        self.array = (ctypes.c_void_p * count)()

    def maps(self) -> list[Polycube]:
        made = []
        for i, value in enumerate(self.array):
            handle = Handle(raw.obc_polycube_destroy)
            handle.value, self.array[i] = value, None
            made.append(Polycube(handle))
        return made

    def __del__(self) -> None:
        for value in self.array:
            raw.obc_polycube_destroy(value)


def compute_common(surfaces: Sequence[Any], *, domain: Optional[dict[str, Any]] = None, progress: Progress = None,
                   threads: int = 0, **options: Any) -> tuple[list[Polycube], int]:
    """One polycube for several shapes: a map each, and the number of the shape that it was made for."""
    given, chosen, energy = [Surface(surface) for surface in surfaces], _options(options), _domain(domain or {})
    array = (raw_mesh.obc_surface * len(given))(*[surface.struct for surface in given])
    handles, made_for = _Handles(len(given)), ctypes.c_size_t()
    call(raw.obc_polycube_compute_common, array, len(given), byref(chosen), byref(energy), HOST, byref(made_for),
         handles.array, progress=progress, threads=threads)
    return handles.maps(), made_for.value


def optimize_common_domain(maps: Sequence[Polycube], *, progress: Progress = None, threads: int = 0,
                           **options: Any) -> list[Polycube]:
    """The proportions with the least sum of energies of maps to one polycube."""
    chosen = _domain(options)
    given, handles = (ctypes.c_void_p * len(maps))(*[map._handle.value for map in maps]), _Handles(len(maps))
    call(raw.obc_polycube_optimize_common_domain, given, len(maps), byref(chosen), HOST, handles.array, progress=progress,
         threads=threads)
    return handles.maps()


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_polycube_version()
