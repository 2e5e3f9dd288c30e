"""Bijective, low-distortion maps of closed genus-0 surfaces to the unit sphere, and what they are for.

    result = compute(mesh.make("creature", 5000), method="balanced")
    result.directions, result.report.mean_quasi_conformal
    Locator(surface, result.directions).sample(directions, surface.positions)

A surface is (positions, triangles), or any object with such attributes: a Mesh, a mesh of trimesh, meshio or pyvista.
"""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import Any, Callable, Literal, Mapping, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import Doubles, Indices, address, doubles
from ._call import HOST, Cancelled, Handle, NoValidResult, Progress, call, call_init, filled, path_bytes, with_options
from ._checks import PathLike, integer, public
from ._records import Record
from .mesh import Mesh, Surface, adopt
from .raw import mesh as raw_mesh
from .raw import sphere_map as raw


class SphereMap(Record):
    """`directions`, a unit vector a vertex, and the figures in `report`."""

    def __init__(self, directions: Doubles, report: raw.obc_sphere_map_report) -> None:
        self.directions, self.report = directions, report

    def __repr__(self) -> str:
        return (f"SphereMap({len(self.directions)} vertices, bijective={self.report.bijective}, "
                f"energy={self.report.energy:.6g})")


def _report() -> raw.obc_sphere_map_report:
    report = raw.obc_sphere_map_report()
    call_init(raw.obc_sphere_map_report_init, report)
    return report


def _options(given: Mapping[str, Any]) -> Any:
    return filled(raw.obc_sphere_map_options, raw.obc_sphere_map_options_init, given)


@with_options("obc_sphere_map_options")
def compute(surface: Any, *,
            # options of obc_sphere_map_options, written by scripts/bindings.py
            method: Literal["balanced", "angle-area", "isometric", "stretch", "conformal", "dissertation"] = "balanced",
            angle_weight: float = 0.1, area_weight: float = 1.0, seed: int = 0, level_splits: int = 40,
            level_tolerance: float = 0.0001, final_tolerance: float = 0.0001, max_level_iterations: int = 0,
            max_final_iterations: int = 0,
            # end of options
            trace: Optional[Callable[[int, int, float], Any]] = None, threads: int = 0, progress: Progress = None) -> SphereMap:
    """Maps a surface to the sphere. trace(iterations, vertices, energy) is called during the method `dissertation`."""
    chosen = _options(locals())
    given, report = Surface(surface), _report()
    raised: list[BaseException] = []
    if trace is not None:
        tell = trace

        def told(iterations: int, vertices: int, energy: float, _: Any) -> None:
            try:
                if not raised:
                    tell(iterations, vertices, energy)
            except BaseException as error:  # noqa: BLE001: an exception cannot pass through C
                raised.append(error)

        chosen.trace = raw.obc_sphere_map_trace_function(told)
    directions = np.empty((len(given.positions), 3))
    call(raw.obc_sphere_map_compute, given.pointer, byref(chosen), HOST, address(directions), byref(report),
         threads=threads, progress=progress, raised=raised)
    return SphereMap(directions, report)


@with_options("obc_sphere_map_options")
def compute_partial(surface: Any, *,
                    # options of obc_sphere_map_options, written by scripts/bindings.py
                    method: Literal["balanced", "angle-area", "isometric", "stretch", "conformal", "dissertation"] = "balanced",
                    angle_weight: float = 0.1, area_weight: float = 1.0, seed: int = 0, level_splits: int = 40,
                    level_tolerance: float = 0.0001, final_tolerance: float = 0.0001, max_level_iterations: int = 0,
                    max_final_iterations: int = 0,
                    # end of options
                    threads: int = 0, progress: Progress = None) -> tuple[Doubles, int, Optional[Exception]]:
    """As `compute`, and when that is cancelled or finds no valid result: what there is of the map, how many vertices have
    places of their own, and the exception (None when all went well)."""
    chosen = _options(locals())
    given, report, placed = Surface(surface), _report(), ctypes.c_size_t()
    directions = np.zeros((len(given.positions), 3))
    failed: Optional[Exception] = None
    try:
        call(raw.obc_sphere_map_compute_partial, given.pointer, byref(chosen), HOST, address(directions), byref(placed),
             byref(report), threads=threads, progress=progress)
    except (Cancelled, NoValidResult) as error:
        failed = error
    return directions, placed.value, failed


@with_options("obc_sphere_map_options")
def measure(surface: Any, directions: ArrayLike, *,
            # options of obc_sphere_map_options: angle_weight, area_weight, written by scripts/bindings.py
            angle_weight: float = 0.1, area_weight: float = 1.0,
            # end of options
            progress: Progress = None) -> raw.obc_sphere_map_report:
    """Figures of any map; a bad one is no error."""
    chosen = _options(locals())
    given, report = Surface(surface), _report()
    places = doubles(directions, 3, len(given.positions), "directions", each="vertex")
    call(raw.obc_sphere_map_measure, given.pointer, address(places), byref(chosen), HOST, byref(report), progress=progress)
    return report


@public
def face_distortion(surface: Any, directions: ArrayLike, *, progress: Progress = None) -> tuple[Doubles, Doubles]:
    """Quasi-conformal distortion and area ratio of each triangle."""
    given = Surface(surface)
    places = doubles(directions, 3, len(given.positions), "directions", each="vertex")
    quasi_conformal, area_ratio = np.empty(len(given.triangles)), np.empty(len(given.triangles))
    call(raw.obc_sphere_map_face_distortion, given.pointer, address(places), HOST, address(quasi_conformal), address(area_ratio),
         progress=progress)
    return quasi_conformal, area_ratio


@public
def round_to_float(surface: Any, directions: ArrayLike, *, progress: Progress = None) -> NDArray[np.float32]:
    """The map in 32-bit floats, repaired where rounding flips triangles."""
    given = Surface(surface)
    places = doubles(directions, 3, len(given.positions), "directions", each="vertex")
    rounded = np.empty((len(places), 3), dtype=np.float32)
    call(raw.obc_sphere_map_round_to_float, given.pointer, address(places), HOST, address(rounded), progress=progress)
    return rounded


class Locator:
    """The inverse of a map: which triangle a direction lies in."""

    @public
    def __init__(self, surface: Any, directions: ArrayLike, *, progress: Progress = None) -> None:
        given, self._handle = Surface(surface), Handle(raw.obc_sphere_map_locator_destroy)
        self._vertex_count = len(given.positions)
        places = doubles(directions, 3, self._vertex_count, "directions", each="vertex")
        call(raw.obc_sphere_map_locator_create, given.pointer, address(places), HOST, byref(self._handle), progress=progress)

    @public
    def locate(self, directions: ArrayLike, *, threads: int = 0, progress: Progress = None) -> tuple[Indices, Doubles]:
        """The triangle of each direction, and its weights at the corners."""
        asked = doubles(directions, 3, name="directions")
        triangles, weights = np.empty(len(asked), dtype=np.uint32), np.empty((len(asked), 3))
        call(raw.obc_sphere_map_locate, self._handle, address(asked), len(asked), HOST, address(triangles),
             address(weights), threads=threads, progress=progress)
        return triangles, weights

    @public
    def sample(self, directions: ArrayLike, values: ArrayLike, *, unit: bool = False, threads: int = 0,
               progress: Progress = None) -> Doubles:
        """Values of the vertices, interpolated where each direction lies."""
        asked, given = doubles(directions, 3, name="directions"), doubles(values, rows=self._vertex_count, name="values",
                                                                                         each="vertex")
        components = given.size // max(1, len(given))
        sampled = np.empty((len(asked),) + given.shape[1:])
        call(raw.obc_sphere_map_sample, self._handle, address(asked), len(asked), address(given), components, int(unit),
             HOST, address(sampled), threads=threads, progress=progress)
        return sampled

    @public
    def remesh(self, positions: ArrayLike, grid: Literal["icosphere", "cube", "latitude", "octahedron"], resolution: int, *, progress: Progress = None) -> Mesh:
        """The surface on a regular triangulation: "icosphere", "cube", "latitude" or "octahedron"."""
        places, handle = doubles(positions, 3, self._vertex_count, "positions", each="vertex"), Handle(raw_mesh.obc_mesh_destroy)
        call(raw.obc_sphere_map_remesh, self._handle, address(places), _grid(grid), resolution, HOST, byref(handle),
             progress=progress)
        return adopt(handle)

    @public
    def image(self, positions: ArrayLike, layout: Literal["octahedron", "cube"], resolution: int, *, progress: Progress = None) -> Doubles:
        """A geometry image, shape (height, width, 3): "octahedron" or "cube"."""
        places = doubles(positions, 3, self._vertex_count, "positions", each="vertex")
        pixels = np.empty(image_size(layout, resolution)[::-1] + (3,))
        call(raw.obc_sphere_map_image, self._handle, address(places), _grid(layout), resolution, HOST, address(pixels),
             progress=progress)
        return pixels


def _grid(name: str) -> int:
    return int(getattr(raw, "OBC_SPHERE_MAP_" + name.upper()))


@public
def grid(name: Literal["icosphere", "cube", "latitude", "octahedron"], resolution: int, *, progress: Progress = None) -> Mesh:
    """A regular triangulation of the sphere."""
    handle = Handle(raw_mesh.obc_mesh_destroy)
    call(raw.obc_sphere_map_grid, _grid(name), resolution, HOST, byref(handle), progress=progress)
    return adopt(handle)


@public
def image_size(layout: Literal["octahedron", "cube"], resolution: int) -> tuple[int, int]:
    """Width and height."""
    width, height = ctypes.c_size_t(), ctypes.c_size_t()
    call(raw.obc_sphere_map_image_size, _grid(layout), resolution, byref(width), byref(height))
    return width.value, height.value


def _pixels(pixels: ArrayLike, layout: Literal["octahedron", "cube"], resolution: int) -> Doubles:
    array = doubles(pixels, name="pixels")
    wanted = image_size(layout, resolution)[::-1] + (3,)
    if array.shape != wanted:
        raise ValueError(f"pixels: shape {wanted} is needed, not {array.shape}")
    return array


@public
def image_surface(pixels: ArrayLike, layout: Literal["octahedron", "cube"], resolution: int, *, progress: Progress = None) -> tuple[Mesh, float]:
    """The closed surface of a geometry image, and the largest distance between pixels that are one vertex."""
    array, handle, gap = _pixels(pixels, layout, resolution), Handle(raw_mesh.obc_mesh_destroy), ctypes.c_double()
    call(raw.obc_sphere_map_image_surface, address(array), _grid(layout), resolution, HOST, byref(handle), byref(gap),
         progress=progress)
    return adopt(handle), gap.value


@public
def write_image(path: PathLike, pixels: ArrayLike, layout: Literal["octahedron", "cube"], resolution: int, *, progress: Progress = None) -> None:
    """To .pfm or .png."""
    array = _pixels(pixels, layout, resolution)
    call(raw.obc_sphere_map_image_write, path_bytes(path), address(array), _grid(layout), resolution, HOST,
         progress=progress)


@public
def read_image(path: PathLike, *, progress: Progress = None) -> tuple[Doubles, str, int]:
    """Pixels, layout and resolution."""
    layout, resolution = ctypes.c_int32(), ctypes.c_size_t()
    call(raw.obc_sphere_map_image_read, path_bytes(path), HOST, byref(layout), byref(resolution), None, 0)
    name: Literal["octahedron", "cube"] = "cube" if layout.value == raw.OBC_SPHERE_MAP_CUBE else "octahedron"
    pixels = np.empty(image_size(name, resolution.value)[::-1] + (3,))
    call(raw.obc_sphere_map_image_read, path_bytes(path), HOST, byref(layout), byref(resolution), address(pixels),
         pixels.size, progress=progress)
    return pixels, name, resolution.value


@public
def best_rotation(start: ArrayLike, end: ArrayLike) -> Doubles:
    """The matrix that takes directions nearest to others."""
    a = doubles(start, 3, name="start")
    b, matrix = doubles(end, 3, len(a), "end"), np.empty((3, 3))
    call(raw.obc_sphere_map_best_rotation, address(a), address(b), len(a), address(matrix))
    return matrix


class Warp:
    """A smooth bijection of the sphere that carries landmarks onto landmarks."""

    @public
    def __init__(self, start: ArrayLike, end: ArrayLike, *, progress: Progress = None) -> None:
        a, self._handle = doubles(start, 3, name="start"), Handle(raw.obc_sphere_map_warp_destroy)
        b = doubles(end, 3, len(a), "end")
        call(raw.obc_sphere_map_warp_create, address(a), address(b), len(a), HOST, byref(self._handle), progress=progress)

    @public
    def apply(self, directions: ArrayLike, backward: bool = False, *, threads: int = 0,
              progress: Progress = None) -> Doubles:
        """Where each direction goes, or comes from."""
        asked = doubles(directions, 3, name="directions")
        moved = np.empty_like(asked)
        call(raw.obc_sphere_map_warp_apply, self._handle, address(asked), len(asked), int(backward), HOST, address(moved),
             threads=threads, progress=progress)
        return moved


@public
def overlay(first: Any, first_directions: ArrayLike, second: Any, second_directions: ArrayLike, *,
            progress: Progress = None) -> tuple[Mesh, Indices]:
    """One triangulation of the sphere with the vertices of two maps, and where those of the second are in it."""
    a, b, handle = Surface(first, "first"), Surface(second, "second"), Handle(raw_mesh.obc_mesh_destroy)
    places_a = doubles(first_directions, 3, len(a.positions), "first_directions", each="vertex")
    places_b = doubles(second_directions, 3, len(b.positions), "second_directions", each="vertex")
    where = np.empty(len(b.positions), dtype=np.uint32)
    call(raw.obc_sphere_map_overlay, a.pointer, address(places_a), b.pointer, address(places_b), HOST, byref(handle),
         address(where), progress=progress)
    return adopt(handle), where


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_sphere_map_version()
