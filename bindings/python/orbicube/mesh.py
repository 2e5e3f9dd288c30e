"""Triangle surfaces and meshes of tetrahedra and hexahedra: files, topology, orientation, searches, exact signs.

    shape = make("creature", 5000)
    write("creature.ply", shape)
    topology(read("creature.ply")).genus

A surface is (positions, triangles), or any object with such attributes: a Mesh, a mesh of trimesh, meshio or pyvista.
"""

from __future__ import annotations

import ctypes
import zlib
from ctypes import byref
from typing import Any, NamedTuple, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import DOUBLE, INDEX, Doubles, Indices, Regions, address, doubles, indices, numbers, view
from ._call import HOST, Handle, Progress, call, call_init, filled, path_bytes, text, with_options
from ._checks import PathLike, integer, public, word
from ._foreign import MANY, parts_of, surface_of
from ._viewer import Shown
from ._viewer import show as _show
from .raw import mesh as raw

__all__ = ["Format", "Mesh", "Search", "check_cells", "check_closed_genus_zero", "first_at_same_position", "formats", "intersections",
           "make", "mean_distance", "orient", "orientation_2d", "orientation_3d", "orientation_from_origin", "read", "read_memory",
           "shape_names", "show", "surface_distance", "tetrahedron_quality", "to_polyscope", "to_pyvista", "to_trimesh", "topology", "version", "vertex_areas",
           "vertex_normals", "write"]


LARGEST_IN_NOTEBOOK = 100000  # triangles and cells, about 2 MB; larger meshes are shown by show()


class Surface:
    """The obc_surface of whatever surface_of understands, for as long as this object lives; `name` is what the argument is
    called in messages."""

    def __init__(self, shape: Any, name: str = "surface") -> None:
        self.positions, self.triangles = surface_of(shape, name)
        self.struct = raw.obc_surface(address(self.positions), len(self.positions), address(self.triangles),
                                      len(self.triangles))

    @property
    def pointer(self) -> Any:
        return byref(self.struct)


class Mesh:
    """A mesh in the library's memory, which does not change. `positions` and `triangles` are read-only views of it, without a
    copy. Regions are integers of 32 bits, one for each triangle or cell, 0 for none. Meshes are equal when positions, cells and
    regions are; they can be pickled and copied."""

    @public
    def __init__(self, positions: ArrayLike, triangles: Optional[ArrayLike] = None, tetrahedra: Optional[ArrayLike] = None,
                 hexahedra: Optional[ArrayLike] = None, *, triangle_regions: Optional[ArrayLike] = None,
                 tetrahedron_regions: Optional[ArrayLike] = None, hexahedron_regions: Optional[ArrayLike] = None) -> None:
        places = doubles(positions, 3, name="positions")
        cells = raw.obc_mesh_cells()
        call_init(raw.obc_mesh_cells_init, cells)
        cells.positions, cells.vertex_count = address(places), len(places)
        kept: list[Any] = []
        for name, one, given, corners, region_numbers in (("triangles", "triangle", triangles, 3, triangle_regions),
                                                          ("tetrahedra", "tetrahedron", tetrahedra, 4, tetrahedron_regions),
                                                          ("hexahedra", "hexahedron", hexahedra, 8, hexahedron_regions)):
            count = 0
            if given is not None:
                array = indices(given, corners, name=name, below=len(places), of="positions")
                kept.append(array)
                count = len(array)
                setattr(cells, name, address(array))
                setattr(cells, one + "_count", count)
            if region_numbers is not None:
                regions = _regions(region_numbers, count, f"{one}_regions", name)
                kept.append(regions)
                setattr(cells, one + "_regions", address(regions))
        handle = Handle(raw.obc_mesh_destroy)
        call(raw.obc_mesh_create, byref(cells), HOST, byref(handle))
        del kept
        self._take(handle)

    def _take(self, handle: Handle) -> None:
        self._handle = handle
        self._facts: Optional[tuple[Any, ...]] = None  # of a file, when this is a copy of what was read from it
        surface = raw.obc_surface()
        call(raw.obc_mesh_surface, self._handle, byref(surface))
        self.positions: Doubles = view(DOUBLE, surface.positions, (surface.vertex_count, 3), handle)
        self.triangles: Indices = view(INDEX, surface.triangles, (surface.triangle_count, 3), handle)

    def __len__(self) -> int:
        return len(self.positions)

    def __repr__(self) -> str:
        counts = [f"{count} {kind}" for kind, count in (
            ("triangles", len(self.triangles)), ("tetrahedra", raw.obc_mesh_tetrahedron_count(self._handle)),
            ("hexahedra", raw.obc_mesh_hexahedron_count(self._handle))) if count]
        origin = f", from {self.format}" if self.format else ""
        return f"Mesh({', '.join([f'{len(self.positions)} vertices'] + counts)}{origin})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Mesh):
            return NotImplemented
        return self is other or all(np.array_equal(mine, others) for mine, others in zip(self._arrays(), other._arrays()))

    def __hash__(self) -> int:
        return hash(tuple(zlib.crc32(np.ascontiguousarray(array + 0).data) for array in self._arrays()))  # + 0: no zero is negative

    def _arrays(self) -> tuple[Any, ...]:
        none = np.empty(0, dtype=np.int32)
        regions = (self.triangle_regions, self.tetrahedron_regions, self.hexahedron_regions)
        return (self.positions, self.triangles, self.tetrahedra, self.hexahedra,
                *(none if numbers is None else numbers for numbers in regions))

    def __copy__(self) -> Mesh:
        return self  # it does not change

    def __deepcopy__(self, memo: Any) -> Mesh:
        return self

    def __reduce__(self) -> Any:
        facts = self.format, self.polygon_count, self.welded_vertex_count, self.notes
        arrays = [np.array(array) for array in (self.positions, self.triangles, self.tetrahedra, self.hexahedra)]
        regions = {"triangle_regions": self.triangle_regions, "tetrahedron_regions": self.tetrahedron_regions,
                   "hexahedron_regions": self.hexahedron_regions}
        return _restored, (arrays, facts, regions)

    def to_pyvista(self) -> Any:
        """As pyvista has it: PolyData of the triangles when there are no other cells, or else an UnstructuredGrid; regions are
        data of cells with the name "region"."""
        return to_pyvista(self)

    def show(self, name: str = "mesh", *, up: str = "y", height: int = 640, preset: str = "") -> Shown:
        """A page with this mesh, which shows itself in a notebook; see orbicube.mesh.show."""
        return _show(self, names=[name], title=name, up=up, height=height, preset=preset)

    def _repr_html_(self) -> Optional[str]:
        """For notebooks; of larger meshes repr() alone, since the page would become part of the notebook."""
        size = len(self.triangles) + len(self.tetrahedra) + len(self.hexahedra)
        return self.show()._repr_html_() if 0 < size <= LARGEST_IN_NOTEBOOK else None

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

    def _regions_of(self, kind: int, count: int, place: int) -> Optional[Regions]:
        if not raw.obc_mesh_region_kinds(self._handle) & kind:
            return None
        numbers = np.empty(count, dtype=np.int32)
        call(raw.obc_mesh_copy_regions, self._handle, *[address(numbers) if i == place else None for i in range(3)])
        return numbers

    @property
    def triangle_regions(self) -> Optional[Regions]:
        """The region number of each triangle, such as its patch of a CAD model, as a copy; None if there are none."""
        return self._regions_of(raw.OBC_MESH_TRIANGLE_REGIONS, len(self.triangles), 0)

    @property
    def tetrahedron_regions(self) -> Optional[Regions]:
        """The region number of each tetrahedron, such as its material, as a copy; None if there are none."""
        return self._regions_of(raw.OBC_MESH_TETRAHEDRON_REGIONS, raw.obc_mesh_tetrahedron_count(self._handle), 1)

    @property
    def hexahedron_regions(self) -> Optional[Regions]:
        """The region number of each hexahedron as a copy; None if there are none."""
        return self._regions_of(raw.OBC_MESH_HEXAHEDRON_REGIONS, raw.obc_mesh_hexahedron_count(self._handle), 2)

    @property
    def format(self) -> str:
        """Of the file that it was read from, such as "PLY, binary, big-endian"."""
        return str(self._facts[0]) if self._facts else text(raw.obc_mesh_format(self._handle)) or ""

    @property
    def polygon_count(self) -> int:
        """Faces of more than three corners in the file."""
        return int(self._facts[1]) if self._facts else raw.obc_mesh_polygon_count(self._handle)

    @property
    def welded_vertex_count(self) -> int:
        """Vertices that were welded to others in reading."""
        return int(self._facts[2]) if self._facts else raw.obc_mesh_welded_vertex_count(self._handle)

    @property
    def notes(self) -> list[str]:
        """What was changed or left out in reading."""
        found: list[str] = list(self._facts[3]) if self._facts else []
        while (note := None if self._facts else text(raw.obc_mesh_note(self._handle, len(found)))) is not None:
            found.append(note)
        return found

    @public
    def boundary(self, *, progress: Progress = None) -> Mesh:
        """The surface of the solid that the cells fill, with the same vertices."""
        handle = Handle(raw.obc_mesh_destroy)
        call(raw.obc_mesh_boundary, self._handle, HOST, byref(handle), progress=progress)
        return adopt(handle)


def _regions(values: ArrayLike, count: int, name: str, of: str) -> Regions:
    array = numbers(values, name)
    if array.ndim != 1 or array.dtype.kind not in "iu":
        raise ValueError(f"{name}: one integer for each of {of} is needed, not an array of {array.dtype} with shape {array.shape}")
    if len(array) != count:
        raise ValueError(f"{name}: {len(array)} numbers of {count} {of}")
    if count and not -2**31 <= int(array.min()) <= int(array.max()) < 2**31:
        raise ValueError(f"{name}: numbers of 32 bits are needed")
    return np.ascontiguousarray(array, dtype=np.int32)


def adopt(handle: Handle) -> Mesh:
    """A Mesh that owns a handle."""
    mesh = Mesh.__new__(Mesh)
    mesh._take(handle)
    return mesh


def _restored(arrays: list[Any], facts: tuple[Any, ...], regions: Optional[dict[str, Any]] = None) -> Mesh:
    """For pickle."""
    mesh = Mesh(*arrays, **(regions or {}))
    mesh._facts = facts
    return mesh


def handle_of(mesh: Any, name: str = "mesh") -> Mesh:
    """A Mesh of whatever has cells."""
    if isinstance(mesh, Mesh):
        return mesh
    parts = None if isinstance(mesh, (tuple, list)) else parts_of(mesh, name)
    if parts is None:
        return Mesh(*surface_of(mesh, name))
    places = doubles(parts.positions, 3, name=f"{name}: positions")
    return Mesh(places, *[None if getattr(parts, kind) is None else
                          indices(getattr(parts, kind), corners, name=f"{name}: {kind}", below=len(places), of="vertices")
                          for kind, corners in MANY.items()])


@public
def to_pyvista(mesh: Any) -> Any:
    """Any mesh as pyvista has it: PolyData of triangles, or else an UnstructuredGrid of all cells."""
    import pyvista  # type: ignore[import]

    whole = handle_of(mesh)
    cells = {5: whole.triangles, 10: whole.tetrahedra, 12: whole.hexahedra}
    if len(cells[10]) == len(cells[12]) == 0:
        faces = np.hstack([np.full((len(whole.triangles), 1), 3), whole.triangles]).astype(np.int64)
        made = pyvista.PolyData(np.array(whole.positions), faces.ravel())
    else:
        kinds = {kind: array.astype(np.int64) for kind, array in cells.items() if len(array)}
        made = pyvista.UnstructuredGrid(kinds, np.array(whole.positions))
    regions = (whole.triangle_regions, whole.tetrahedron_regions, whole.hexahedron_regions)
    if any(numbers is not None for numbers in regions):
        made.cell_data["region"] = np.concatenate([np.zeros(len(array), dtype=np.int32) if numbers is None else numbers
                                                   for numbers, array in zip(regions, cells.values())])
    return made


@public
def to_trimesh(mesh: Any) -> Any:
    """The surface of any mesh as trimesh has it, with vertices in the same order; of a solid its boundary."""
    import trimesh  # type: ignore[import]

    whole = handle_of(mesh)
    solid = len(whole.tetrahedra) + len(whole.hexahedra) > 0
    surface = whole.boundary() if solid else whole
    return trimesh.Trimesh(np.array(surface.positions), surface.triangles.astype(np.int64), process=False)


@public
def to_polyscope(mesh: Any, name: str = "mesh") -> Any:
    """Registers any mesh with polyscope, as a surface or a volume of that name, and returns what polyscope returns."""
    import polyscope  # type: ignore[import]

    whole = handle_of(mesh)
    tetrahedra, hexahedra = whole.tetrahedra.astype(np.int64), whole.hexahedra.astype(np.int64)
    if len(tetrahedra) == len(hexahedra) == 0:
        return polyscope.register_surface_mesh(name, np.array(whole.positions), whole.triangles.astype(np.int64))
    return polyscope.register_volume_mesh(name, np.array(whole.positions), tets=tetrahedra if len(tetrahedra) else None,
                                          hexes=hexahedra if len(hexahedra) else None)


def show(*meshes: Any, names: Optional[Sequence[str]] = None, maps: Optional[Sequence[Any]] = None, title: str = "Orbicube",
         up: str = "y", height: int = 640, preset: str = "") -> Shown:
    """
    A page with one mesh, or with several in linked views: slices, quality, colors, figures of what is
    picked. `maps`: for each mesh positions of its vertices on a map, or None. `preset`: how the page begins, such as
    "color=jacobian&slice=0,0.5&theme=dark". In a notebook the result shows itself; it has write(path) and open().
    """
    return _show(*meshes, names=names, maps=maps, title=title, up=up, height=height, preset=preset)


@public
def make(shape: str, triangle_count: int = 10000, seed: int = 0, *, progress: Progress = None) -> Mesh:
    """A closed surface by name, see `shape_names`."""
    handle = Handle(raw.obc_mesh_destroy)
    call(raw.obc_mesh_make, word(shape, "shape", shape_names()).encode(), integer(triangle_count, "triangle_count", 0, 2**32 - 1),
         integer(seed, "seed", 0, 2**64 - 1), HOST, byref(handle), progress=progress)
    return adopt(handle)


def shape_names() -> list[str]:
    """What `make` knows."""
    found: list[str] = []
    while (name := text(raw.obc_mesh_shape_name(len(found)))) is not None:
        found.append(name)
    return found


class Format(NamedTuple):
    """A file format: its word for `read_memory`, the ending of its files, and whether these hold polygons of shared vertices with
    exact coordinates, cells, binary contents, and regions."""
    word: str
    ending: str
    polygons: bool
    cells: bool
    binary: bool
    regions: bool


def formats() -> list[Format]:
    """The formats of `read` and `write`."""
    found: list[Format] = []
    while (name := text(raw.obc_mesh_format_name(len(found)))) is not None:
        number = len(found)
        held = raw.obc_mesh_format_contents(number)
        found.append(Format(name.lower(), text(raw.obc_mesh_format_ending(number)) or "", bool(held & raw.OBC_MESH_HOLDS_POLYGONS),
                            bool(held & raw.OBC_MESH_HOLDS_CELLS), bool(held & raw.OBC_MESH_HOLDS_BINARY),
                            bool(held & raw.OBC_MESH_HOLDS_REGIONS)))
    return found


@with_options("obc_mesh_read_options")
def read(path: PathLike, *,
         # options of obc_mesh_read_options, written by scripts/bindings.py
         weld_identical: bool = False,
         # end of options
         progress: Progress = None) -> Mesh:
    """Reads a file in the format of its ending; `formats` lists them."""
    chosen = filled(raw.obc_mesh_read_options, raw.obc_mesh_read_options_init, locals())
    handle = Handle(raw.obc_mesh_destroy)
    call(raw.obc_mesh_read, path_bytes(path), byref(chosen), HOST, byref(handle), progress=progress)
    return adopt(handle)


@with_options("obc_mesh_read_options")
def read_memory(data: bytes, format: str, *,
                # options of obc_mesh_read_options, written by scripts/bindings.py
                weld_identical: bool = False,
                # end of options
                progress: Progress = None) -> Mesh:
    """The same from bytes in a format, named by its word in `formats`."""
    chosen = filled(raw.obc_mesh_read_options, raw.obc_mesh_read_options_init, locals())
    handle = Handle(raw.obc_mesh_destroy)
    words = [one.word for one in formats()]
    call(raw.obc_mesh_read_memory, data, len(data), words.index(word(format, "format", words)), byref(chosen), HOST,
         byref(handle), progress=progress)
    return adopt(handle)


@with_options("obc_mesh_write_options")
def write(path: PathLike, mesh: Any, *,
          # options of obc_mesh_write_options, written by scripts/bindings.py
          binary: bool = True,
          # end of options
          progress: Progress = None) -> None:
    """Writes a mesh in the format of the ending; those of `formats` with `cells` hold tetrahedra and hexahedra, those with
    `regions` the numbers of regions."""
    chosen = filled(raw.obc_mesh_write_options, raw.obc_mesh_write_options_init, locals())
    whole = handle_of(mesh)
    call(raw.obc_mesh_write, path_bytes(path), whole._handle, byref(chosen), HOST, progress=progress)


@public
def topology(surface: Any, *, progress: Progress = None) -> raw.obc_mesh_topology_report:
    """What kind of surface it is: a report with closed, manifold, genus, volume and the first place of each defect."""
    given, report = Surface(surface), raw.obc_mesh_topology_report()
    call_init(raw.obc_mesh_topology_report_init, report)
    call(raw.obc_mesh_topology, given.pointer, HOST, byref(report), progress=progress)
    return report


@public
def check_closed_genus_zero(surface: Any, *, progress: Progress = None) -> None:
    """Raises UnsuitableSurface, with the place, unless the surface is what sphere maps need."""
    given = Surface(surface)
    call(raw.obc_mesh_check_closed_genus_zero, given.pointer, HOST, progress=progress)


@public
def check_cells(mesh: Any, *, progress: Progress = None) -> None:
    """Raises, with the place, unless tetrahedra and hexahedra fill a solid."""
    whole = handle_of(mesh)
    call(raw.obc_mesh_check_cells, whole._handle, HOST, progress=progress)


@public
def tetrahedron_quality(mesh: Any, *, progress: Progress = None) -> raw.obc_mesh_tetrahedron_quality_report:
    """How well shaped tetrahedra are."""
    whole, report = handle_of(mesh), raw.obc_mesh_tetrahedron_quality_report()
    call_init(raw.obc_mesh_tetrahedron_quality_report_init, report)
    call(raw.obc_mesh_tetrahedron_quality, whole._handle, HOST, byref(report), progress=progress)
    return report


@public
def orient(surface: Any, *, progress: Progress = None) -> tuple[Indices, raw.obc_mesh_orient_report]:
    """Triangles turned so that neighbors agree and a closed surface is outward-oriented, and what was done."""
    positions, triangles = surface_of(surface)
    turned = triangles.copy()
    report = raw.obc_mesh_orient_report()
    call_init(raw.obc_mesh_orient_report_init, report)
    call(raw.obc_mesh_orient, address(positions), len(positions), address(turned), len(turned), HOST, byref(report),
         progress=progress)
    return turned, report


@public
def first_at_same_position(positions: ArrayLike, *, progress: Progress = None) -> Indices:
    """For each vertex the lowest one at its very position."""
    places = doubles(positions, 3, name="positions")
    first = np.empty(len(places), dtype=np.uint32)
    call(raw.obc_mesh_first_at_same_position, address(places), len(places), HOST, address(first), progress=progress)
    return first


@public
def intersections(surface: Any, capacity: int = 1000, *, threads: int = 0, progress: Progress = None) -> Indices:
    """The first pairs of triangles that have more in common than the vertices they share, decided exactly."""
    given, count = Surface(surface), ctypes.c_size_t()
    pairs = np.empty((integer(capacity, "capacity", 0, 2**32 - 1), 2), dtype=np.uint32)
    call(raw.obc_mesh_intersections, given.pointer, HOST, address(pairs), capacity, byref(count), progress=progress,
         threads=threads)
    return pairs[:count.value].copy()


@public
def vertex_normals(surface: Any, *, progress: Progress = None) -> Doubles:
    """Unit normals, the triangles' weighted by their angles."""
    given = Surface(surface)
    normals = np.empty((len(given.positions), 3))
    call(raw.obc_mesh_vertex_normals, given.pointer, HOST, address(normals), progress=progress)
    return normals


@public
def vertex_areas(surface: Any, *, progress: Progress = None) -> Doubles:
    """A third of the area of its triangles for each vertex: the usual weights of a fit by harmonics."""
    given = Surface(surface)
    areas = np.empty(len(given.positions))
    call(raw.obc_mesh_vertex_areas, given.pointer, HOST, address(areas), progress=progress)
    return areas


@public
def surface_distance(first: Any, second: Any, *, threads: int = 0,
                     progress: Progress = None) -> raw.obc_mesh_distance:
    """Distances from points of one surface to the other, and back."""
    a, b, distance = Surface(first, "first"), Surface(second, "second"), raw.obc_mesh_distance()
    call_init(raw.obc_mesh_distance_init, distance)
    call(raw.obc_mesh_surface_distance, a.pointer, b.pointer, HOST, byref(distance), threads=threads,
         progress=progress)
    return distance


@public
def mean_distance(a: ArrayLike, b: ArrayLike, *, threads: int = 0, progress: Progress = None) -> float:
    """The mean distance from points to the nearest of the others, the greater of both ways: the reconstruction error e(A, B)."""
    first, second, distance = doubles(a, 3, name="a"), doubles(b, 3, name="b"), ctypes.c_double()
    call(raw.obc_mesh_mean_distance, address(first), len(first), address(second), len(second), HOST, byref(distance),
         threads=threads, progress=progress)
    return distance.value


class Search:
    """A surface made ready for searching."""

    @public
    def __init__(self, surface: Any, *, progress: Progress = None) -> None:
        given, self._handle = Surface(surface), Handle(raw.obc_mesh_search_destroy)
        call(raw.obc_mesh_search_create, given.pointer, HOST, byref(self._handle), progress=progress)

    @public
    def vertices(self, points: ArrayLike) -> Indices:
        """The vertex nearest to each point."""
        asked = doubles(points, 3, name="points")
        found = np.empty(len(asked), dtype=np.uint32)
        call(raw.obc_mesh_search_vertices, self._handle, address(asked), len(asked), address(found))
        return found

    @public
    def surface(self, points: ArrayLike) -> tuple[Indices, Doubles, Doubles, Doubles]:
        """Of the nearest point of the surface: triangle, weights at its corners, position, distance."""
        asked = doubles(points, 3, name="points")
        n = len(asked)
        triangles = np.empty(n, dtype=np.uint32)
        weights, positions, distances = np.empty((n, 3)), np.empty((n, 3)), np.empty(n)
        call(raw.obc_mesh_search_surface, self._handle, address(asked), n, address(triangles), address(weights),
             address(positions), address(distances))
        return triangles, weights, positions, distances


def _sign(function: Any, dimension: int, **points: ArrayLike) -> int:
    arrays = {name: doubles(point, name=name) for name, point in points.items()}
    for name, array in arrays.items():
        if array.shape != (dimension,):
            raise ValueError(f"{name}: {dimension} coordinates are needed, not shape {array.shape}")
    found = int(function(*[array.ctypes.data for array in arrays.values()]))
    if found == 2:
        raise MemoryError("there is no memory for an exact sign")
    return found


@public
def orientation_2d(a: ArrayLike, b: ArrayLike, c: ArrayLike) -> int:
    """Exact sign of (b - a) x (c - a)."""
    return _sign(raw.obc_mesh_orientation_2d, 2, a=a, b=b, c=c)


@public
def orientation_3d(a: ArrayLike, b: ArrayLike, c: ArrayLike, d: ArrayLike) -> int:
    """Exact sign of det[b - a, c - a, d - a]."""
    return _sign(raw.obc_mesh_orientation_3d, 3, a=a, b=b, c=c, d=d)


@public
def orientation_from_origin(p: ArrayLike, q: ArrayLike, r: ArrayLike) -> int:
    """Exact sign of det[p, q, r]."""
    return _sign(raw.obc_mesh_orientation_from_origin, 3, p=p, q=q, r=r)


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_mesh_version()
