"""Arrays in and out. What is contiguous and of the right type passes as it is; everything else is copied once.

Messages begin with the name that a function's argument has.
"""

from __future__ import annotations

import ctypes
from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray

from ._checks import shown

Doubles = NDArray[np.float64]
Indices = NDArray[np.uint32]
Regions = NDArray[np.int32]


def numbers(values: Any, name: str) -> Any:
    """An array of real numbers of any type, made of whatever holds them."""
    if values is None:
        raise TypeError(f"{name} is None: an array of numbers is needed")
    try:
        array = np.asarray(values)
    except ValueError:
        raise ValueError(f"{name}: rows of the same length are needed") from None
    if array.dtype.kind == "O":
        return _of_objects(array, name)
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{name}: numbers are needed, not {array.dtype if array.size != 1 else shown(values)}")
    return array


def _of_objects(array: Any, name: str) -> Any:
    """Fractions and the like are numbers; None, text and rows of unlike lengths are not."""
    for where, value in np.ndenumerate(array):
        if isinstance(value, (list, tuple, np.ndarray)):
            raise ValueError(f"{name}: rows of the same length are needed")
        if value is None or isinstance(value, (str, bytes, complex)) or not hasattr(value, "__float__"):
            raise TypeError(f"{place(name, where)} is {shown(value)}: a number is needed")
    return array.astype(np.float64)


def place(name: str, where: tuple[int, ...]) -> str:
    """name[2, 0]"""
    return f"{name}[{', '.join(str(int(i)) for i in where)}]" if where else name


def doubles(values: Any, columns: Optional[int] = None, rows: Optional[int] = None, name: str = "array",
            each: str = "") -> Doubles:
    """C-contiguous finite doubles; with `columns`, of that number a row (flat arrays too), with `rows`, that number of them, of
    which there is one for `each`."""
    array: Doubles = _shaped(_plain(numbers(values, name), np.float64), columns, rows, name, each)
    finite(array, name)
    return array


def finite(array: Any, name: str) -> Any:
    """Raises, with the place, where there is a NaN or an infinity; without another array where there is none."""
    if array.size and not (np.isfinite(array.min()) and np.isfinite(array.max())):
        where = tuple(np.argwhere(~np.isfinite(array))[0])
        raise ValueError(f"{place(name, where)} is {array[where]}: a finite number is needed")
    return array


def spread(values: Any, n: int, name: str, finite_only: bool = False) -> Doubles:
    """A number for each of n unknowns, or one for all; infinities are fine, NaN is not."""
    array = np.asarray(numbers(values, name), dtype=np.float64)
    if array.shape not in ((), (1,), (n,)):
        raise ValueError(f"{name}: one number or {n} are needed, not shape {array.shape}")
    bad = ~np.isfinite(array) if finite_only else np.isnan(array)
    if np.any(bad):
        where = tuple(np.argwhere(bad)[0])
        raise ValueError(f"{place(name, where)} is {array[where]}: a number is needed")
    return np.ascontiguousarray(np.broadcast_to(array, (n,)))


def start_of(values: Any, name: str) -> Doubles:
    """A point, flat: at least one unknown."""
    array = np.ravel(np.asarray(numbers(values, name), dtype=np.float64))
    if array.size == 0:
        raise ValueError(f"{name} is empty: one number at least is needed")
    return doubles(array, name=name)


def indices(values: Any, columns: Optional[int] = None, rows: Optional[int] = None, name: str = "indices",
            below: Optional[int] = None, of: str = "", each: str = "") -> Indices:
    """The same of indices: integers from 0 to 2^32 - 1, or less than `below`, the number of what `of` says."""
    array = numbers(values, name)
    if array.size == 0:
        array = array.astype(np.uint32)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name}: integers are needed, not {array.dtype}")
    if array.size and below is not None and (array.max() >= below or array.min() < 0):
        where = tuple(np.argwhere((array < 0) | (array >= below))[0])
        raise ValueError(f"{place(name, where)} is {array[where]}, not within 0 to {below - 1}" if below else
                         f"{place(name, where)} is {array[where]}, but there are no {of or 'numbers'}")
    if array.size and array.dtype != np.uint32 and (array.min() < 0 or array.max() > 0xFFFFFFFF):
        raise ValueError(f"{name}: from {array.min()} to {array.max()}, not within 0 to 2^32 - 1")
    shaped: Indices = _shaped(_plain(array, np.uint32), columns, rows, name, each)
    return shaped


def _plain(values: Any, kind: Any) -> Any:
    """As C has arrays: contiguous, and at an address that suits the type, which parts of records and of files need not."""
    return np.require(np.ascontiguousarray(values, dtype=kind), requirements="A")


def floats(values: Any, columns: Optional[int] = None, rows: Optional[int] = None, name: str = "array", each: str = "") -> Any:
    """The same of 32-bit floats, for files of engines."""
    with np.errstate(over="ignore"):
        array = _plain(numbers(values, name), np.float32)
    return finite(_shaped(array, columns, rows, name, each), name)


def put(into: Any, values: Any, name: str) -> None:
    """Into an array of our own: as many numbers as it has, in its shape or flat; nothing is broadcast."""
    if type(values) is np.ndarray and values.shape == into.shape and values.dtype.kind in "biuf":  # as a rule: no other array
        into[...] = values
        return
    if isinstance(values, float) and into.size == 1:
        into[...] = values
        return
    array = np.asarray(numbers(values, name), dtype=np.float64)
    if array.shape != into.shape:
        if array.size != into.size or (array.ndim > 1 and into.ndim > 1):
            raise ValueError(f"{name}: {' by '.join(map(str, into.shape))} numbers are needed, not shape {array.shape}")
        array = array.reshape(into.shape)
    into[...] = array


def _shaped(array: Any, columns: Optional[int], rows: Optional[int], name: str, each: str) -> Any:
    if columns is not None:
        if array.ndim != 2 or array.shape[1] != columns:
            if array.ndim > 2 or (array.ndim == 2 and array.size) or array.size % columns:
                raise ValueError(f"{name}: shape ({'n' if rows is None else rows}, {columns}) is needed, not {array.shape}")
            array = array.reshape(-1, columns)
    if rows is not None and array.shape[:1] != (rows,):
        raise ValueError(f"{name}: {rows} rows are needed{', one for each ' + each if each else ''}, not shape {array.shape}")
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


def memory_of(where: int, count: int) -> Any:
    """Doubles that lie elsewhere; nothing keeps that memory alive."""
    memory: Any = (ctypes.c_double * count).from_address(where)
    return np.frombuffer(memory)


def buffer(kind: Any, count: int) -> tuple[Any, int]:
    """An array of our own and where it lies, for repeated writing."""
    array = np.zeros(count, dtype=np.dtype(kind))
    return array, array.ctypes.data


DOUBLE = ctypes.c_double
INDEX = ctypes.c_uint32
