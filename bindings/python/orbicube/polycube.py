"""Polycubes of closed surfaces, and certified maps to them.

    cube = compute(mesh.make("bracket", 5000))
    better = cube.optimize_domain()
    better.positions, better.polycube, better.triangles
"""

from __future__ import annotations

import contextlib
import ctypes
from ctypes import byref
from typing import Any, Literal, Mapping, NoReturn, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import Doubles, Indices, address, doubles, indices
from ._call import HOST, Handle, Progress, call, filled, named, sized, with_options
from ._checks import kind_of, public, real
from ._records import Record
from .mesh import Surface
from .raw import mesh as raw_mesh
from .raw import polycube as raw


class Polycube:
    """A certified map, which does not change. `report` is that of the optimization that it comes from, if it comes from one."""

    def __init__(self, handle: Handle, report: Any = None) -> None:
        self._handle, self.report = handle, report

    def __repr__(self) -> str:
        return f"Polycube({self.corner_count} corners, {self.patch_count} patches, {self.vertex_count} vertices)"

    def __copy__(self) -> Polycube:
        return self

    def __deepcopy__(self, memo: Any) -> Polycube:
        return self

    def __reduce__(self) -> NoReturn:
        raise TypeError("a Polycube cannot be pickled: keep its positions, polycube and triangles, and `certify` them again")

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

    def corner_points(self) -> int:
        """Corner points in the dissertation's sense: vertices of the rectangles that the patches are cut into."""
        count = ctypes.c_size_t()
        call(raw.obc_polycube_corner_points, self._handle, HOST, byref(count))
        return count.value

    @property
    def construction(self) -> Optional[str]:
        """What found it: "labels", "voxels", "dissertation", or None for a map made elsewhere."""
        return {raw.OBC_POLYCUBE_LABELS: "labels", raw.OBC_POLYCUBE_VOXELS: "voxels",
                raw.OBC_POLYCUBE_DISSERTATION: "dissertation"}.get(
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
        """Of the optimization that it comes from; they never rise."""
        out = np.empty(raw.obc_polycube_energy_count(self._handle))
        call(raw.obc_polycube_copy_energies, self._handle, address(out))
        return out

    @with_options("obc_polycube_domain_options")
    def optimize_domain(self, *,
                        # options of obc_polycube_domain_options, written by scripts/bindings.py
                        measure: Literal["surface-mean", "face-mean", "harmonic"] = "surface-mean", area_weight: float = 1.0,
                        # end of options
                        progress: Progress = None, threads: int = 0) -> Polycube:
        """The best distances between the planes."""
        chosen = _domain(locals())
        report, handle = sized(raw.obc_polycube_domain_report), Handle(raw.obc_polycube_destroy)
        call(raw.obc_polycube_optimize_domain, self._handle, byref(chosen), HOST, byref(report), byref(handle),
             progress=progress, threads=threads)
        return Polycube(handle, report)

    @with_options("obc_polycube_corner_options")
    def optimize_corners(self, *,
                         # options of obc_polycube_corner_options, written by scripts/bindings.py
                         method: Literal["trust-region", "gradient"] = "trust-region", area_weight: float = 1.0,
                         domain: bool = False, rounds: int = 6,
                         # end of options
                         progress: Progress = None, threads: int = 0) -> Polycube:
        """Better positions of the corners on the surface."""
        chosen = filled(raw.obc_polycube_corner_options, raw.obc_polycube_corner_options_init, locals())
        report, handle = sized(raw.obc_polycube_corner_report), Handle(raw.obc_polycube_destroy)
        call(raw.obc_polycube_optimize_corners, self._handle, byref(chosen), HOST, byref(report), byref(handle),
             progress=progress, threads=threads)
        return Polycube(handle, report)

    @public
    def align_features(self, vertices: ArrayLike = (), targets: ArrayLike = (), *, weights: Optional[ArrayLike] = None,
                      curves: Sequence[tuple[Any, ...]] = (), feature_angle: float = 0, progress: Progress = None,
                      threads: int = 0) -> Polycube:
        """The same polycube with vertices at targets on it, each curve (vertices, from, to and perhaps a weight) along a
        line, and sharp edges on its edges. Without weights all of that is met exactly."""
        chosen = filled(raw.obc_polycube_feature_options, raw.obc_polycube_feature_options_init,
                        {"feature_angle": feature_angle})
        report, handle, n = sized(raw.obc_polycube_feature_report), Handle(raw.obc_polycube_destroy), self.vertex_count
        points = indices(vertices, name="vertices", below=n).ravel()
        kept: list[Any] = [points, doubles(targets, 3, len(points), "targets", each="of the vertices")]
        chosen.point_count, chosen.points, chosen.targets = len(points), address(points), address(kept[1])
        if weights is not None:
            kept.append(doubles(weights, rows=len(points), name="weights", each="of the vertices"))
            chosen.point_weights = address(kept[-1])
        if len(curves):
            kept += _curves(curves, n)
            chosen.curve_count = len(curves)
            chosen.curve_vertices, chosen.curve_starts, chosen.curve_lines, chosen.curve_weights = map(address, kept[-4:])
        call(raw.obc_polycube_align_features, self._handle, byref(chosen), HOST, byref(report), byref(handle),
             progress=progress, threads=threads)
        return Polycube(handle, report)

    @public
    def graph(self, *, progress: Progress = None) -> Graph:
        """Its corners, edges and patches."""
        return Graph(self, progress=progress)

    @with_options("obc_polycube_quads_options")
    def quads(self, *,
              # options of obc_polycube_quads_options, written by scripts/bindings.py
              quads: int = 10000, edge_length: float = 0.0,
              # end of options
              progress: Progress = None) -> Quads:
        """A mesh of quads on the surface."""
        chosen = filled(raw.obc_polycube_quads_options, raw.obc_polycube_quads_options_init, locals())
        return Quads(self, chosen, progress)

    @with_options("obc_polycube_atlas_options")
    def atlas(self, *,
              # options of obc_polycube_atlas_options, written by scripts/bindings.py
              size: int = 1024, padding: float = 4.0,
              # end of options
              progress: Progress = None) -> Atlas:
        """The patches packed into a square, for textures."""
        chosen = filled(raw.obc_polycube_atlas_options, raw.obc_polycube_atlas_options_init, locals())
        return Atlas(self, chosen, progress)


class Graph(Record):
    """Corners, straight edges and patches of a polycube, without its triangles."""

    @public
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
        self.dual_starts, self.dual_neighbors = numbers(patches + 1), numbers(links)
        call(raw.obc_polycube_graph_copy_dual, handle, address(self.dual_starts), address(self.dual_neighbors))
        handle.close()


class Quads(Record):
    """A mesh of quads: positions, polycube (the same vertices on it), quads, patches, and where vertices lie in the map:
    triangles and weights."""

    def __init__(self, map: Polycube, chosen: Any, progress: Progress) -> None:
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


class Atlas:
    """A texture atlas of a map: coordinates (u and v of each corner of each triangle, from the top left), size (texels along each
    side), texels_per_unit of the polycube, and coverage, the fraction of the square in patches."""

    def __init__(self, map: Polycube, chosen: Any, progress: Progress) -> None:
        self._handle, self._triangles = Handle(raw.obc_polycube_atlas_destroy), map.triangles
        call(raw.obc_polycube_atlas_create, map._handle, byref(chosen), HOST, byref(self._handle), progress=progress)
        self.size = raw.obc_polycube_atlas_size(self._handle)
        self.coordinates = np.empty((len(self._triangles), 3, 2))
        scale, coverage = ctypes.c_double(), ctypes.c_double()
        call(raw.obc_polycube_atlas_copy, self._handle, address(self.coordinates), byref(scale), byref(coverage))
        self.texels_per_unit, self.coverage = scale.value, coverage.value

    def __repr__(self) -> str:
        return f"Atlas({self.size} x {self.size} texels, {len(self.coordinates)} triangles)"

    @public
    def sample(self, *, progress: Progress = None) -> tuple[Indices, Doubles, NDArray[np.bool_]]:
        """What each texel shows, in rows from the top: the triangle of the map (2^32 - 1 for none), the weights of its three corners,
        and whether it has the middle of the texel; others show the nearest texel in a patch."""
        shape = self.size, self.size
        triangles, weights, covered = np.empty(shape, np.uint32), np.empty((*shape, 3)), np.empty(shape, np.uint8)
        call(raw.obc_polycube_atlas_sample, self._handle, HOST, address(triangles), address(weights), address(covered),
             progress=progress)
        return triangles, weights, covered.astype(bool)

    @public
    def texture(self, values: ArrayLike, *, progress: Progress = None) -> Doubles:
        """Values of the vertices of the map, interpolated at the texels, in rows from the top; NaN where there is no triangle."""
        given = doubles(values, rows=int(self._triangles.max()) + 1, name="values", each="vertex")
        triangles, weights, _ = self.sample(progress=progress)
        none = triangles == np.uint32(2**32 - 1)
        corners = self._triangles[np.where(none, 0, triangles)]
        shape = *triangles.shape, *(1,) * (given.ndim - 1)
        image: Doubles = sum(weights[..., k].reshape(shape) * given[corners[..., k]] for k in range(3))
        image[none] = np.nan
        return image


def _curves(curves: Sequence[tuple[Any, ...]], n: int) -> list[Any]:
    """Vertices, where each curve begins in them, lines and weights."""
    for i, curve in enumerate(curves):
        if not isinstance(curve, (tuple, list)) or len(curve) not in (3, 4):
            raise TypeError(f"curves[{i}]: (vertices, from, to) or (vertices, from, to, weight) is needed, not {kind_of(curve)}")
    rows = [indices(curve[0], name=f"curves[{i}]: vertices", below=n).ravel() for i, curve in enumerate(curves)]
    ends = [doubles(curve[1:3], 3, 2, f"curves[{i}]: from and to") for i, curve in enumerate(curves)]
    weights = [real(curve[3], f"curves[{i}]: weight") if len(curve) > 3 else 0 for i, curve in enumerate(curves)]
    return [np.concatenate(rows), np.cumsum([0] + [len(row) for row in rows], dtype=np.uint32), doubles(ends), doubles(weights)]


def _options(given: Mapping[str, Any]) -> Any:
    return filled(raw.obc_polycube_options, raw.obc_polycube_options_init, given)


def _domain(given: Mapping[str, Any]) -> Any:
    return filled(raw.obc_polycube_domain_options, raw.obc_polycube_domain_options_init, given)


@with_options("obc_polycube_options")
def compute(surface: Any, *,
            # options of obc_polycube_options, written by scripts/bindings.py
            construction: Literal["auto", "labels", "voxels", "dissertation"] = "auto", corners: int = 0, seed: int = 0,
            area_weight: float = 1.0, rounds: int = 40,
            # end of options
            progress: Progress = None, threads: int = 0) -> Polycube:
    """A polycube of a closed surface of any genus, and a map to it."""
    chosen = _options(locals())
    given, handle = Surface(surface), Handle(raw.obc_polycube_destroy)
    call(raw.obc_polycube_compute, given.pointer, byref(chosen), HOST, byref(handle), progress=progress, threads=threads)
    return Polycube(handle)


@public
def certify(surface: Any, polycube: ArrayLike, *, progress: Progress = None) -> Polycube:
    """A map made elsewhere, if it is one; NoValidResult says why not."""
    given, handle = Surface(surface), Handle(raw.obc_polycube_destroy)
    places = doubles(polycube, 3, len(given.positions), "polycube", each="vertex")
    call(raw.obc_polycube_create, given.pointer, address(places), HOST, None, byref(handle), progress=progress)
    return Polycube(handle)


@public
def map_to_domain(surface: Any, polycube: Any, *, corners: Optional[ArrayLike] = None, vertices: Optional[ArrayLike] = None,
               points: Optional[ArrayLike] = None, progress: Progress = None, threads: int = 0) -> Polycube:
    """Maps a surface to the given polycube; corners of it are put at vertices of the surface, or nearest to points."""
    given, target, handle = Surface(surface), Surface(polycube, "polycube"), Handle(raw.obc_polycube_destroy)
    constraints = raw.obc_polycube_constraints()
    kept: list[Any] = []
    for name, value in (("vertices", vertices), ("points", points)):
        if value is not None and (corners is None or (vertices is not None and points is not None)):
            raise ValueError(f"{name}: corners are needed, with either vertices or points of the surface where each goes")
    if corners is not None:
        if vertices is None and points is None:
            raise ValueError("corners: vertices or points are needed, of the surface where each corner goes")
        kept.append(indices(corners, name="corners", below=len(target.positions), of="vertices").ravel())
        constraints.corners, constraints.count = address(kept[0]), len(kept[0])
        if vertices is not None:
            kept.append(indices(vertices, rows=constraints.count, name="vertices", below=len(given.positions),
                                each="of the corners"))
            constraints.vertices = address(kept[-1])
        if points is not None:
            kept.append(doubles(points, 3, constraints.count, "points", each="of the corners"))
            constraints.points = address(kept[-1])
    call(raw.obc_polycube_map_to_domain, given.pointer, target.pointer, byref(constraints) if kept else None, HOST, byref(handle),
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


@with_options("obc_polycube_options")
def compute_common(surfaces: Sequence[Any], *,
                   # options of obc_polycube_options, written by scripts/bindings.py
                   construction: Literal["auto", "labels", "voxels", "dissertation"] = "auto", corners: int = 0,
                   seed: int = 0, area_weight: float = 1.0, rounds: int = 40,
                   # end of options
                   domain: Optional[Mapping[str, Any]] = None, progress: Progress = None, threads: int = 0) -> tuple[list[Polycube], int]:
    """One polycube for several shapes: a map each, and the number of the shape that it was made for. domain: options of
    `optimize_common_domain`, as a dictionary."""
    chosen = _options(locals())
    energy = _domain(named(domain or {}, "obc_polycube_domain_options", "domain"))
    given = [Surface(surface, f"surfaces[{i}]") for i, surface in enumerate(surfaces)]
    if not given:
        raise ValueError("surfaces is empty: one at least is needed")
    array = (raw_mesh.obc_surface * len(given))(*[surface.struct for surface in given])
    handles, constructed_from = _Handles(len(given)), ctypes.c_size_t()
    call(raw.obc_polycube_compute_common, array, len(given), byref(chosen), byref(energy), HOST, byref(constructed_from),
         handles.array, progress=progress, threads=threads)
    return handles.maps(), constructed_from.value


@with_options("obc_polycube_domain_options")
def optimize_common_domain(maps: Sequence[Polycube], *,
                           # options of obc_polycube_domain_options, written by scripts/bindings.py
                           measure: Literal["surface-mean", "face-mean", "harmonic"] = "surface-mean",
                           area_weight: float = 1.0,
                           # end of options
                           progress: Progress = None, threads: int = 0) -> list[Polycube]:
    """The proportions with the minimum sum of energies of maps to one polycube."""
    chosen = _domain(locals())
    for i, map in enumerate(maps):
        if not isinstance(map, Polycube):
            raise TypeError(f"maps[{i}]: a Polycube is needed, not {kind_of(map)}")
    if not len(maps):
        raise ValueError("maps is empty: one at least is needed")
    given, handles = (ctypes.c_void_p * len(maps))(*[map._handle.value for map in maps]), _Handles(len(maps))
    with contextlib.ExitStack() as uses:
        for map in maps:
            uses.enter_context(map._handle)
        call(raw.obc_polycube_optimize_common_domain, given, len(maps), byref(chosen), HOST, handles.array,
             progress=progress, threads=threads)
    return handles.maps()


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_polycube_version()
