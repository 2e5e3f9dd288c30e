"""Arrays in and out. What is contiguous and of the right type passes as it is; everything else is copied once."""

from __future__ import annotations

import ctypes
from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray

Doubles = NDArray[np.float64]
Indices = NDArray[np.uint32]


def doubles(values: Any, columns: Optional[int] = None, rows: Optional[int] = None, name: str = "array") -> Doubles:
    """C-contiguous doubles; with `columns`, of so many a row (flat arrays too), with `rows`, so many of them."""
    array: Doubles = _shaped(_plain(values, np.float64), columns, rows, name)
    return array


def indices(values: Any, columns: Optional[int] = None, rows: Optional[int] = None, name: str = "indices") -> Indices:
    """The same of indices: integers from 0 to 2^32 - 1."""
    array = np.asarray(values)
    if array.size == 0:
        array = array.astype(np.uint32)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name}: integers are needed, not {array.dtype}")
    if array.dtype != np.uint32 and (array.min() < 0 or array.max() > 0xFFFFFFFF):
        raise ValueError(f"{name}: from {array.min()} to {array.max()}, not within 0 to 2^32 - 1")
    shaped: Indices = _shaped(_plain(array, np.uint32), columns, rows, name)
    return shaped


def _plain(values: Any, kind: Any) -> Any:
    """As C has arrays: contiguous, and at an address that suits the type, which parts of records and of files need not."""
    return np.require(np.ascontiguousarray(values, dtype=kind), requirements="A")


def floats(values: Any, columns: Optional[int] = None, rows: Optional[int] = None, name: str = "array") -> Any:
    """The same of 32-bit floats, for files of engines."""
    return _shaped(_plain(values, np.float32), columns, rows, name)


def put(into: Any, values: Any, name: str) -> None:
    """Into an array of our own: as many numbers as it has, in its shape or flat; nothing is broadcast."""
    if type(values) is np.ndarray and values.shape == into.shape:  # as a rule: no other array is made
        into[...] = values
        return
    array = np.asarray(values, dtype=np.float64)
    if array.shape != into.shape:
        if array.size != into.size or (array.ndim > 1 and into.ndim > 1):
            raise ValueError(f"{name}: {' by '.join(map(str, into.shape))} numbers are needed, not shape {array.shape}")
        array = array.reshape(into.shape)
    into[...] = array


def _shaped(array: Any, columns: Optional[int], rows: Optional[int], name: str) -> Any:
    if columns is not None:
        if array.ndim != 2 or array.shape[1] != columns:
            if array.ndim > 2 or (array.ndim == 2 and array.size) or array.size % columns:
                raise ValueError(f"{name}: shape (n, {columns}) is needed, not {array.shape}")
            array = array.reshape(-1, columns)
    if rows is not None and array.shape[:1] != (rows,):
        raise ValueError(f"{name}: {rows} rows are needed, not shape {array.shape}")
    return array


def address(array: Any) -> Optional[int]:
    """Where an array lies, for C; None for None and for an array of nothing."""
    return None if array is None or array.size == 0 else array.ctypes.data


def view(kind: Any, where: Optional[int], shape: tuple[int, ...], owner: Any) -> Any:
    """A read-only array over memory of a library, without a copy; it keeps `owner`, who holds that memory, alive. The owner
    must not hold the array: Python's collector does not see cycles through arrays."""
    count = int(np.prod(shape))
    if not where or count == 0:
        array = np.empty(shape, dtype=np.dtype(kind))
    else:
        memory = (kind * count).from_address(where)
        memory.owner = owner
        array = np.frombuffer(memory, dtype=np.dtype(kind)).reshape(shape)
    array.flags.writeable = False
    return array


def surface_of(shape: Any) -> tuple[Doubles, Indices]:
    """Positions and triangles of whatever has them: a pair of arrays; positions and triangles, as all that this package
    answers; vertices and faces, as of trimesh; points and cells, as of meshio."""
    if isinstance(shape, (tuple, list)) and len(shape) == 2:
        positions, triangles = shape
    elif hasattr(shape, "positions") and hasattr(shape, "triangles"):
        positions, triangles = shape.positions, shape.triangles
    elif hasattr(shape, "vertices") and hasattr(shape, "faces"):
        positions, triangles = shape.vertices, shape.faces
    elif hasattr(shape, "points") and hasattr(shape, "cells"):
        positions, triangles = shape.points, meshio_cells(shape, "triangle", 3)
    else:
        raise TypeError(f"no surface: {type(shape).__name__}; give (positions, triangles), or an object with those, "
                        "with vertices and faces, or with points and cells")
    return doubles(positions, 3, name="positions"), indices(triangles, 3, name="triangles")


def solid_of(shape: Any) -> tuple[Doubles, Indices]:
    """Positions and tetrahedra, likewise."""
    if isinstance(shape, (tuple, list)) and len(shape) == 2:
        positions, tetrahedra = shape
    elif hasattr(shape, "positions") and hasattr(shape, "tetrahedra"):
        positions, tetrahedra = shape.positions, shape.tetrahedra
    elif hasattr(shape, "points") and hasattr(shape, "cells"):
        positions, tetrahedra = shape.points, meshio_cells(shape, "tetra", 4)
    else:
        raise TypeError(f"no solid: {type(shape).__name__}; give (positions, tetrahedra), or an object with those, or "
                        "with points and cells")
    return doubles(positions, 3, name="positions"), indices(tetrahedra, 4, name="tetrahedra")


def meshio_cells(mesh: Any, kind: str, corners: int) -> Any:
    """The cells of one kind of a meshio mesh, whose cells are a dictionary, blocks with type and data, or pairs."""
    if hasattr(mesh.cells, "items"):
        found = [data for name, data in mesh.cells.items() if name == kind]
    else:
        found = [block.data if hasattr(block, "data") else block[1] for block in mesh.cells
                 if (block.type if hasattr(block, "type") else block[0]) == kind]
    return np.concatenate(found) if found else np.empty((0, corners), dtype=np.uint32)


def memory_of(where: int, count: int) -> Any:
    """Doubles that lie elsewhere; nothing keeps that memory alive."""
    memory: Any = (ctypes.c_double * count).from_address(where)
    return np.frombuffer(memory)


def buffer(kind: Any, count: int) -> tuple[Any, int]:
    """An array of our own and where it lies, for what is written to it again and again."""
    array = np.zeros(count, dtype=np.dtype(kind))
    return array, array.ctypes.data


DOUBLE = ctypes.c_double
INDEX = ctypes.c_uint32
