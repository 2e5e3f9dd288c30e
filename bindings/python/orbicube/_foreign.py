"""Meshes of whoever made them: pairs of arrays, and objects of this package, trimesh, meshio and pyvista, known by their
attributes alone.

Cells of other kinds than triangles, tetrahedra and hexahedra (quads, polygons, strips, prisms, pyramids) are handed to the
library's reader of VTK files, so that they are cut, noted or refused like those of files.
"""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from ._arrays import Doubles, Indices, doubles, indices
from ._checks import kind_of

# Names of meshio -> types of VTK; what is not here is refused by name.
TYPES = {"vertex": 1, "line": 3, "triangle": 5, "polygon": 7, "quad": 9, "tetra": 10, "hexahedron": 12, "wedge": 13,
         "pyramid": 14}
CORNERS = {1: 1, 3: 2, 5: 3, 10: 4, 12: 8}  # of those that need no reader
NAMES = {number: name for name, number in TYPES.items()}
MANY = {"triangles": 3, "tetrahedra": 4, "hexahedra": 8}
GIVE = ("give (positions, {0}), or an object with those, with points and cells or faces (meshio, pyvista){1}")


class Parts:
    """Positions and cells by kind, None where the shape has no such member. `notes` are of the reader."""

    def __init__(self, positions: Any, triangles: Any = None, tetrahedra: Any = None, hexahedra: Any = None) -> None:
        self.positions, self.triangles, self.tetrahedra, self.hexahedra = positions, triangles, tetrahedra, hexahedra

    def count(self, kind: str) -> int:
        cells = getattr(self, kind)
        return 0 if cells is None else len(cells)


def parts_of(shape: Any, name: str) -> Optional[Parts]:
    """Of an object; None when it is none that is known."""
    if hasattr(shape, "positions") and any(hasattr(shape, kind) for kind in MANY):
        return Parts(shape.positions, *(getattr(shape, kind, None) for kind in MANY))
    if hasattr(shape, "vertices") and hasattr(shape, "faces"):
        return Parts(shape.vertices, shape.faces)
    if hasattr(shape, "points") and hasattr(shape, "cells") and hasattr(shape, "celltypes"):  # pyvista.UnstructuredGrid
        return _of_cells(shape.points, shape.cells, np.asarray(shape.celltypes), name)
    if hasattr(shape, "points") and hasattr(shape, "faces"):  # pyvista.PolyData
        return _of_polygons(shape, name)
    if hasattr(shape, "points") and hasattr(shape, "cells"):
        return _of_meshio(shape, name)
    return None


def _of_polygons(shape: Any, name: str) -> Parts:
    faces = np.asarray(shape.faces).ravel()
    strips = np.asarray(getattr(shape, "strips", ())).ravel()
    if not strips.size and faces.size % 4 == 0 and np.all(faces[::4] == 3):
        return Parts(shape.points, faces.reshape(-1, 4)[:, 1:])
    types: list[int] = []
    for flat, kind in ((faces, 7), (strips, 6)):
        at = 0
        while at < flat.size:
            types.append(5 if kind == 7 and flat[at] == 3 else kind)
            at += int(flat[at]) + 1
        if at != flat.size:
            raise ValueError(f"{name}: faces end in the middle of a face")
    return _of_cells(shape.points, np.concatenate([faces, strips]), np.array(types), name)


def _of_meshio(shape: Any, name: str) -> Parts:
    """Cells are a dictionary, blocks with type and data, or pairs."""
    if hasattr(shape.cells, "items"):
        blocks = list(shape.cells.items())
    else:
        blocks = [(block.type, block.data) if hasattr(block, "data") else tuple(block) for block in shape.cells]
    flat, types, refused = [np.empty(0, dtype=np.int64)], [np.empty(0, dtype=np.int64)], []
    for kind, data in blocks:
        if not kind.rstrip("0123456789") == kind or kind not in TYPES:
            refused.append(f"{len(data)} of type {kind}")
            continue
        cells = np.asarray(data)
        if cells.size == 0:
            continue
        if cells.ndim != 2 or cells.dtype.kind not in "iu" or cells.shape[1] != CORNERS.get(TYPES[kind], cells.shape[1]):
            raise ValueError(f"{name}: cells of type {kind} are not rows of vertex numbers")
        flat.append(np.hstack([np.full((len(cells), 1), cells.shape[1]), cells]).astype(np.int64).ravel())
        types.append(np.full(len(cells), TYPES[kind]))
    if refused:
        raise ValueError(f"{name}: cells that are not read: {', '.join(refused)}; leave them out or cut them into "
                         "triangles, tetrahedra or hexahedra")
    return _of_cells(shape.points, np.concatenate(flat), np.concatenate(types), name)


def _of_cells(points: Any, cells: Any, types: Any, name: str) -> Parts:
    """Cells as VTK has them, each after its number of corners."""
    flat = np.asarray(cells).ravel()
    if not np.all(np.isin(types, list(CORNERS))):
        return _read(points, flat, types, name)
    sizes = np.zeros(13, dtype=np.int64)
    for kind, corners in CORNERS.items():
        sizes[kind] = corners + 1
    ends = np.cumsum(sizes[types])
    if (ends[-1] if len(ends) else 0) != flat.size or not np.all(flat[ends - sizes[types]] == sizes[types] - 1):
        raise ValueError(f"{name}: cells do not have the corners of their types")
    found = []
    for kind in (5, 10, 12):
        starts = ends[types == kind] - CORNERS[kind]
        found.append(flat[starts[:, None] + np.arange(CORNERS[kind])])
    return Parts(points, *found)


def _read(points: Any, flat: Any, types: Any, name: str) -> Parts:
    """By the reader of VTK files."""
    from . import mesh
    from ._call import Error

    positions = doubles(points, 3, name=f"{name}: points")
    content = b"".join([
        b"# vtk DataFile Version 3.0\ncells\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS %d double\n" % len(positions),
        positions.astype(">f8").tobytes(), b"\nCELLS %d %d\n" % (len(types), flat.size), flat.astype(">i4").tobytes(),
        b"\nCELL_TYPES %d\n" % len(types), types.astype(">i4").tobytes(), b"\n"])
    try:
        read = mesh.read_memory(content, "vtk")
    except Error as error:
        kinds, counts = np.unique(types, return_counts=True)
        what = ", ".join(f"{count} of type {NAMES.get(int(kind), int(kind))}" for kind, count in zip(kinds, counts))
        raise type(error)(error.status, error.kind, f"{name}: among its cells ({what}): {error.message}") from None
    return Parts(read.positions, read.triangles, read.tetrahedra, read.hexahedra)


def _taken(shape: Any, kind: str, name: str, more: str) -> Parts:
    if isinstance(shape, (tuple, list)) and len(shape) == 2:
        return Parts(shape[0], **{kind: shape[1]})
    parts = parts_of(shape, name)
    if parts is None:
        what = f"{kind_of(shape)} of {len(shape)}" if isinstance(shape, (tuple, list)) else kind_of(shape)
        raise TypeError(f"{name}: {GIVE.format(kind, more)}, not {what}")
    return parts


def _checked(parts: Parts, kind: str, name: str) -> tuple[Doubles, Indices]:
    positions = doubles(parts.positions, 3, name=f"{name}: positions")
    cells = getattr(parts, kind)
    if len(positions) == 0:
        raise ValueError(f"{name}: it is empty, there are no vertices")
    if cells is None or np.size(cells) == 0:
        others = [f"{parts.count(other)} {other}" for other in MANY if parts.count(other)]
        more = "; orbicube.mesh.Mesh has boundary()" if kind == "triangles" and others else ""
        raise ValueError(f"{name}: there are no {kind}, but {' and '.join(others)}{more}" if others else
                         f"{name}: it is empty, there are no {kind}")
    return positions, indices(cells, MANY[kind], name=f"{name}: {kind}", below=len(positions), of="vertices")


def surface_of(shape: Any, name: str = "surface") -> tuple[Doubles, Indices]:
    """Positions and triangles of whatever has them."""
    return _checked(_taken(shape, "triangles", name, ", or with vertices and faces (trimesh)"), "triangles", name)


def solid_of(shape: Any, name: str = "solid") -> tuple[Doubles, Indices]:
    """Positions and tetrahedra, likewise; hexahedra beside them are refused rather than left out."""
    parts = _taken(shape, "tetrahedra", name, "")
    if parts.count("hexahedra") and parts.count("tetrahedra"):
        raise ValueError(f"{name}: {parts.count('hexahedra')} hexahedra beside {parts.count('tetrahedra')} tetrahedra; a "
                         "solid of tetrahedra alone is needed")
    return _checked(parts, "tetrahedra", name)
