"""Triangle surfaces and meshes of tetrahedra and hexahedra: files, topology, orientation, searches, exact signs.

    shape = make("creature", 5000)
    write("creature.ply", shape)
    topology(read("creature.ply")).genus

A surface is (positions, triangles), or any object with such attributes: a Mesh, a mesh of trimesh or of meshio.
"""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import DOUBLE, INDEX, Doubles, Indices, address, doubles, indices, surface_of, view
from ._call import HOST, Handle, Progress, call, call_init, filled, path_bytes, text
from .raw import mesh as raw

__all__ = ["Mesh", "Search", "check_cells", "check_closed_genus_zero", "first_at_same_position", "intersections", "make",
           "orient", "orientation_2d", "orientation_3d", "orientation_from_origin", "read", "shape_names",
           "tetrahedron_quality", "topology", "version", "write"]


class Surface:
    """The obc_surface of whatever surface_of understands, for as long as this object lives."""

    def __init__(self, shape: Any) -> None:
        self.positions, self.triangles = surface_of(shape)
        self.struct = raw.obc_surface(address(self.positions), len(self.positions), address(self.triangles),
                                      len(self.triangles))

    @property
    def pointer(self) -> Any:
        return byref(self.struct)


class Mesh:
    """A mesh in the library's memory. `positions` and `triangles` are read-only views of it, without a copy."""

    def __init__(self, positions: ArrayLike, triangles: Optional[ArrayLike] = None, tetrahedra: Optional[ArrayLike] = None,
                 hexahedra: Optional[ArrayLike] = None) -> None:
        places = doubles(positions, 3, name="positions")
        cells = raw.obc_mesh_cells()
        call_init(raw.obc_mesh_cells_init, cells)
        cells.positions, cells.vertex_count = address(places), len(places)
        kept = []
        for name, one, given, corners in (("triangles", "triangle", triangles, 3), ("tetrahedra", "tetrahedron", tetrahedra, 4),
                                          ("hexahedra", "hexahedron", hexahedra, 8)):
            if given is not None:
                array = indices(given, corners, name=name)
                kept.append(array)
                setattr(cells, name, address(array))
                setattr(cells, one + "_count", len(array))
        handle = Handle(raw.obc_mesh_destroy)
        call(raw.obc_mesh_create, byref(cells), HOST, byref(handle))
        del kept
        self._take(handle)

    def _take(self, handle: Handle) -> None:
        self._handle = handle
        surface = raw.obc_surface()
        call(raw.obc_mesh_surface, self._handle, byref(surface))
        self.positions: Doubles = view(DOUBLE, surface.positions, (surface.vertex_count, 3), handle)
        self.triangles: Indices = view(INDEX, surface.triangles, (surface.triangle_count, 3), handle)

    def __len__(self) -> int:
        return len(self.positions)

    def __repr__(self) -> str:
        return (f"Mesh({len(self.positions)} vertices, {len(self.triangles)} triangles, "
                f"{raw.obc_mesh_tetrahedron_count(self._handle)} tetrahedra, "
                f"{raw.obc_mesh_hexahedron_count(self._handle)} hexahedra)")

    @property
    def tetrahedra(self) -> Indices:
        """A copy."""
        cells = np.empty((raw.obc_mesh_tetrahedron_count(self._handle), 4), dtype=np.uint32)
        call(raw.obc_mesh_copy, self._handle, None, None, address(cells), None)
        return cells

    @property
    def hexahedra(self) -> Indices:
        """A copy."""
        cells = np.empty((raw.obc_mesh_hexahedron_count(self._handle), 8), dtype=np.uint32)
        call(raw.obc_mesh_copy, self._handle, None, None, None, address(cells))
        return cells

    @property
    def format(self) -> str:
        """Of the file that it was read from, such as "PLY, binary, big-endian"."""
        return text(raw.obc_mesh_format(self._handle)) or ""

    @property
    def polygon_count(self) -> int:
        """Faces of more than three corners in the file."""
        return raw.obc_mesh_polygon_count(self._handle)

    @property
    def welded_vertex_count(self) -> int:
        """Vertices that were joined to others in reading."""
        return raw.obc_mesh_welded_vertex_count(self._handle)

    @property
    def notes(self) -> list[str]:
        """What was changed or left out in reading."""
        found: list[str] = []
        while (note := text(raw.obc_mesh_note(self._handle, len(found)))) is not None:
            found.append(note)
        return found

    def boundary(self, *, progress: Progress = None) -> Mesh:
        """The surface of the solid that the cells fill, with the same vertices."""
        handle = Handle(raw.obc_mesh_destroy)
        call(raw.obc_mesh_boundary, self._handle, HOST, byref(handle), progress=progress)
        return adopt(handle)


def adopt(handle: Handle) -> Mesh:
    """A Mesh that owns a handle."""
    mesh = Mesh.__new__(Mesh)
    mesh._take(handle)
    return mesh


def handle_of(mesh: Any) -> Any:
    """A Mesh of whatever has cells."""
    if isinstance(mesh, Mesh):
        return mesh
    if hasattr(mesh, "points") and hasattr(mesh, "cells"):
        from ._arrays import meshio_cells

        return Mesh(mesh.points, *[meshio_cells(mesh, kind, corners)
                                   for kind, corners in (("triangle", 3), ("tetra", 4), ("hexahedron", 8))])
    if hasattr(mesh, "positions") and (hasattr(mesh, "tetrahedra") or hasattr(mesh, "hexahedra")):
        return Mesh(mesh.positions, *[getattr(mesh, kind, None) for kind in ("triangles", "tetrahedra", "hexahedra")])
    return Mesh(*surface_of(mesh))


def make(shape: str, triangle_count: int = 10000, seed: int = 0, *, progress: Progress = None) -> Mesh:
    """A closed surface by name, see `shape_names`."""
    handle = Handle(raw.obc_mesh_destroy)
    call(raw.obc_mesh_make, shape.encode(), triangle_count, seed, HOST, byref(handle), progress=progress)
    return adopt(handle)


def shape_names() -> list[str]:
    """What `make` knows."""
    found: list[str] = []
    while (name := text(raw.obc_mesh_shape_name(len(found)))) is not None:
        found.append(name)
    return found


def read(path: Any, *, progress: Progress = None, **options: Any) -> Mesh:
    """Reads .obj .off .ply .stl .mesh .vtk. Option: weld_identical."""
    chosen = filled(raw.obc_mesh_read_options, raw.obc_mesh_read_options_init, options)
    handle = Handle(raw.obc_mesh_destroy)
    call(raw.obc_mesh_read, path_bytes(path), byref(chosen), HOST, byref(handle), progress=progress)
    return adopt(handle)


def read_memory(data: bytes, format: str, *, progress: Progress = None, **options: Any) -> Mesh:
    """The same from bytes; format is obj, off, ply, stl, medit or vtk."""
    chosen = filled(raw.obc_mesh_read_options, raw.obc_mesh_read_options_init, options)
    if format not in ("obj", "off", "ply", "stl", "medit", "vtk"):
        raise ValueError(f"format {format!r}: one of obj, off, ply, stl, medit, vtk")
    handle = Handle(raw.obc_mesh_destroy)
    call(raw.obc_mesh_read_memory, data, len(data), getattr(raw, "OBC_MESH_" + format.upper()), byref(chosen), HOST,
         byref(handle), progress=progress)
    return adopt(handle)


def write(path: Any, mesh: Any, *, progress: Progress = None, **options: Any) -> None:
    """Writes triangles to .obj .off .ply .stl, cells too to .mesh and .vtk. Option: binary."""
    chosen = filled(raw.obc_mesh_write_options, raw.obc_mesh_write_options_init, options)
    whole = handle_of(mesh)
    call(raw.obc_mesh_write, path_bytes(path), whole._handle, byref(chosen), HOST, progress=progress)


def topology(surface: Any, *, progress: Progress = None) -> raw.obc_mesh_topology_report:
    """What kind of surface it is: a report with closed, manifold, genus, volume and the first place of each defect."""
    given, report = Surface(surface), raw.obc_mesh_topology_report()
    call_init(raw.obc_mesh_topology_report_init, report)
    call(raw.obc_mesh_topology, given.pointer, HOST, byref(report), progress=progress)
    return report


def check_closed_genus_zero(surface: Any, *, progress: Progress = None) -> None:
    """Raises UnsuitableSurface, with the place, unless the surface is what sphere maps need."""
    given = Surface(surface)
    call(raw.obc_mesh_check_closed_genus_zero, given.pointer, HOST, progress=progress)


def check_cells(mesh: Any, *, progress: Progress = None) -> None:
    """Raises, with the place, unless tetrahedra and hexahedra fill a solid."""
    whole = handle_of(mesh)
    call(raw.obc_mesh_check_cells, whole._handle, HOST, progress=progress)


def tetrahedron_quality(mesh: Any, *, progress: Progress = None) -> raw.obc_mesh_tetrahedron_quality_report:
    """How well shaped tetrahedra are."""
    whole, report = handle_of(mesh), raw.obc_mesh_tetrahedron_quality_report()
    call_init(raw.obc_mesh_tetrahedron_quality_report_init, report)
    call(raw.obc_mesh_tetrahedron_quality, whole._handle, HOST, byref(report), progress=progress)
    return report


def orient(surface: Any, *, progress: Progress = None) -> tuple[Indices, raw.obc_mesh_orient_report]:
    """Triangles turned so that neighbours agree and a closed surface looks outward, and what was done."""
    positions, triangles = surface_of(surface)
    turned = triangles.copy()
    report = raw.obc_mesh_orient_report()
    call_init(raw.obc_mesh_orient_report_init, report)
    call(raw.obc_mesh_orient, address(positions), len(positions), address(turned), len(turned), HOST, byref(report),
         progress=progress)
    return turned, report


def first_at_same_position(positions: ArrayLike, *, progress: Progress = None) -> Indices:
    """For each vertex the lowest one at its very position."""
    places = doubles(positions, 3, name="positions")
    first = np.empty(len(places), dtype=np.uint32)
    call(raw.obc_mesh_first_at_same_position, address(places), len(places), HOST, address(first), progress=progress)
    return first


def intersections(surface: Any, capacity: int = 1000, *, threads: int = 0, progress: Progress = None) -> Indices:
    """The first pairs of triangles that have more in common than the vertices they share, decided exactly."""
    given, count = Surface(surface), ctypes.c_size_t()
    pairs = np.empty((capacity, 2), dtype=np.uint32)
    call(raw.obc_mesh_intersections, given.pointer, HOST, address(pairs), capacity, byref(count), progress=progress,
         threads=threads)
    return pairs[:count.value].copy()


class Search:
    """A surface made ready for searching."""

    def __init__(self, surface: Any, *, progress: Progress = None) -> None:
        given, self._handle = Surface(surface), Handle(raw.obc_mesh_search_destroy)
        call(raw.obc_mesh_search_create, given.pointer, HOST, byref(self._handle), progress=progress)

    def vertices(self, points: ArrayLike) -> Indices:
        """The vertex nearest to each point."""
        asked = doubles(points, 3, name="points")
        found = np.empty(len(asked), dtype=np.uint32)
        call(raw.obc_mesh_search_vertices, self._handle, address(asked), len(asked), address(found))
        return found

    def surface(self, points: ArrayLike) -> tuple[Indices, Doubles, Doubles, Doubles]:
        """Of the nearest point of the surface: triangle, weights at its corners, position, distance."""
        asked = doubles(points, 3, name="points")
        n = len(asked)
        triangles = np.empty(n, dtype=np.uint32)
        weights, positions, distances = np.empty((n, 3)), np.empty((n, 3)), np.empty(n)
        call(raw.obc_mesh_search_surface, self._handle, address(asked), n, address(triangles), address(weights),
             address(positions), address(distances))
        return triangles, weights, positions, distances


def _sign(function: Any, dimension: int, *points: ArrayLike) -> int:
    arrays = [doubles(point, name="point") for point in points]
    if any(array.shape != (dimension,) for array in arrays):
        raise ValueError(f"points of {dimension} coordinates are needed")
    answer = int(function(*[array.ctypes.data for array in arrays]))
    if answer == 2:
        raise ValueError("a coordinate is not finite, or there is no memory")
    return answer


def orientation_2d(a: ArrayLike, b: ArrayLike, c: ArrayLike) -> int:
    """Exact sign of (b - a) x (c - a)."""
    return _sign(raw.obc_mesh_orientation_2d, 2, a, b, c)


def orientation_3d(a: ArrayLike, b: ArrayLike, c: ArrayLike, d: ArrayLike) -> int:
    """Exact sign of det[b - a, c - a, d - a]."""
    return _sign(raw.obc_mesh_orientation_3d, 3, a, b, c, d)


def orientation_from_origin(p: ArrayLike, q: ArrayLike, r: ArrayLike) -> int:
    """Exact sign of det[p, q, r]."""
    return _sign(raw.obc_mesh_orientation_from_origin, 3, p, q, r)


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_mesh_version()


