"""Unit quaternions w x y z, rotations, the 24 rotations of the cube, and frames up to them.

Functions take one quaternion (or vector, matrix) or rows of them, and return likewise; one of two arguments may be single.
"""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import Doubles, address, doubles, finite, numbers
from ._call import call
from ._checks import integer, public
from .raw import quaternion as raw


Part = tuple[str, ArrayLike, int]  # what an argument is called, its numbers, and how many belong together


def _together(parts: list[Part]) -> tuple[list[Doubles], tuple[int, ...]]:
    """Arguments broadcast to one shape of rows, and that shape."""
    arrays = [finite(np.asarray(numbers(values, name), dtype=np.float64), name) for name, values, _ in parts]
    for array, (name, _, width) in zip(arrays, parts):
        if width > 1 and array.shape[-1:] != (width,):
            raise ValueError(f"{name}: {width} numbers in the last dimension are needed, not shape {array.shape}")
    rows = [array.shape[:-1] if width > 1 else array.shape for array, (_, _, width) in zip(arrays, parts)]
    try:
        shape = np.broadcast_shapes(*rows)
    except ValueError:
        what = " and ".join(f"{name} {shape}" for (name, _, _), shape in zip(parts, rows))
        raise ValueError(f"rows that do not go together: {what}") from None
    wide = [np.ascontiguousarray(np.broadcast_to(array, shape + ((width,) if width > 1 else ())))
            for array, (_, _, width) in zip(arrays, parts)]
    return wide, shape


def _filled(function: Any, parts: list[Part], width: int, kind: Any) -> Any:
    """A function of arrays with the count before the result."""
    arrays, shape = _together(parts)
    out = np.empty(shape + ((width,) if width > 1 else ()), dtype=kind)
    function(*[array.ctypes.data for array in arrays], int(np.prod(shape)), out.ctypes.data)
    return out[()] if out.ndim == 0 else out


def _array(function: Any, parts: list[Part], width: int) -> Doubles:
    out: Doubles = _filled(function, parts, width, np.float64)
    return out


def _elements(function: Any, parts: list[Part]) -> NDArray[np.uint8]:
    """Numbers of the cube's rotations."""
    out: NDArray[np.uint8] = _filled(function, parts, 1, np.uint8)
    return out


def _each(function: Any, parts: list[Part], width: int, checked: bool = False) -> Doubles:
    return _rows(function, parts, [width], checked)[0]


def _rows(function: Any, parts: list[Part], widths: list[int], checked: bool = False) -> list[Doubles]:
    """A function of one, called for each row."""
    arrays, shape = _together(parts)
    count = int(np.prod(shape))
    outs = [np.empty(shape + ((width,) if width > 1 else ())) for width in widths]
    places = [(array.ctypes.data, 8 * width) for array, (_, _, width) in zip(arrays, parts)]
    ends = [(out.ctypes.data, 8 * width) for out, width in zip(outs, widths)]
    for i in range(count):
        arguments = [start + i * step for start, step in places] + [start + i * step for start, step in ends]
        if checked:
            call(function, *arguments)
        else:
            function(*arguments)
    return outs


@public
def multiply(p: ArrayLike, q: ArrayLike) -> Doubles:
    """p q, Hamilton's product: turns by q first."""
    return _array(raw.obc_quaternion_multiply_array, [("p", p, 4), ("q", q, 4)], 4)


@public
def inverse(q: ArrayLike) -> Doubles:
    return _each(raw.obc_quaternion_inverse, [("q", q, 4)], 4)


@public
def normalize(q: ArrayLike) -> Doubles:
    """Of length 1."""
    return _array(raw.obc_quaternion_normalize_array, [("q", q, 4)], 4)


@public
def exponential(q: ArrayLike) -> Doubles:
    return _each(raw.obc_quaternion_exponential, [("q", q, 4)], 4)


@public
def logarithm(q: ArrayLike) -> Doubles:
    return _each(raw.obc_quaternion_logarithm, [("q", q, 4)], 4)


@public
def slerp(p: ArrayLike, q: ArrayLike, t: ArrayLike) -> Doubles:
    """Along the shorter arc, p at t = 0 and q at t = 1."""
    return _array(raw.obc_quaternion_slerp_array, [("p", p, 4), ("q", q, 4), ("t", t, 1)], 4)


@public
def average(q: ArrayLike, weights: Optional[ArrayLike] = None) -> tuple[Doubles, float]:
    """The mean rotation of rows, and how much they agree (1: all)."""
    rows = doubles(q, 4, name="q")
    shares = None if weights is None else doubles(weights, rows=len(rows), name="weights", each="row of q")
    mean, agreement = np.empty(4), ctypes.c_double()
    call(raw.obc_quaternion_average, address(rows), address(shares), len(rows), address(mean), byref(agreement))
    return mean, agreement.value


@public
def rotate(q: ArrayLike, v: ArrayLike) -> Doubles:
    """q v q^-1."""
    return _array(raw.obc_quaternion_rotate_array, [("q", q, 4), ("v", v, 3)], 3)


@public
def from_axis_angle(axis: ArrayLike, angle: ArrayLike) -> Doubles:
    """Turns about an axis of any length, by radians."""
    (axes, angles), shape = _together([("axis", axis, 3), ("angle", angle, 1)])
    if not np.all(axes.any(axis=-1)):
        raise ValueError("axis is zero: a direction is needed")
    out = np.empty(shape + (4,))
    for i, (row, turn) in enumerate(zip(axes.reshape(-1, 3), angles.ravel())):
        call(raw.obc_quaternion_from_axis_angle, row.ctypes.data, float(turn), out.ctypes.data + 32 * i)
    return out


@public
def to_axis_angle(q: ArrayLike) -> tuple[Doubles, Doubles]:
    axis, angle = _rows(raw.obc_quaternion_to_axis_angle, [("q", q, 4)], [3, 1])
    return axis, angle


@public
def from_rotation_vector(v: ArrayLike) -> Doubles:
    return _each(raw.obc_quaternion_from_rotation_vector, [("v", v, 3)], 4)


@public
def to_rotation_vector(q: ArrayLike) -> Doubles:
    return _each(raw.obc_quaternion_to_rotation_vector, [("q", q, 4)], 3)


def _matrices(matrix: ArrayLike) -> Doubles:
    array = doubles(matrix, name="matrix")
    if array.shape[-2:] != (3, 3):
        raise ValueError(f"matrix: 3 by 3 numbers are needed, not shape {array.shape}")
    return np.ascontiguousarray(array).reshape(array.shape[:-2] + (9,))


@public
def to_matrix(q: ArrayLike) -> Doubles:
    flat = _array(raw.obc_quaternion_to_matrix_array, [("q", q, 4)], 9)
    return flat.reshape(flat.shape[:-1] + (3, 3))


@public
def from_matrix(matrix: ArrayLike) -> Doubles:
    """Of rotation matrices; InvalidArgument for what is none."""
    flat = _matrices(matrix)
    out = np.empty(flat.shape[:-1] + (4,))
    call(raw.obc_quaternion_from_matrix_array, flat.ctypes.data, int(np.prod(flat.shape[:-1])), out.ctypes.data)
    return out


@public
def nearest_to_matrix(matrix: ArrayLike) -> Doubles:
    """The rotation nearest to any matrix."""
    return _each(raw.obc_quaternion_nearest_to_matrix, [("matrix", _matrices(matrix), 9)], 4, checked=True)


@public
def cube_element(number: int) -> Doubles:
    """The quaternion of one of the 24 rotations of the cube."""
    out = np.empty(4)
    call(raw.obc_quaternion_cube_element, integer(number, "number", 0, 23), out.ctypes.data)
    return out


@public
def cube_matrix(number: int) -> Doubles:
    out = np.empty((3, 3))
    call(raw.obc_quaternion_cube_matrix, integer(number, "number", 0, 23), out.ctypes.data)
    return out


@public
def cube_product(a: int, b: int) -> int:
    """The number of a b, b first."""
    return raw.obc_quaternion_cube_product(integer(a, "a", 0, 23), integer(b, "b", 0, 23))


@public
def cube_inverse(a: int) -> int:
    return raw.obc_quaternion_cube_inverse(integer(a, "a", 0, 23))


@public
def cube_class(number: int) -> int:
    """OBC_QUATERNION_IDENTITY, ... of the raw module."""
    return raw.obc_quaternion_cube_class(integer(number, "number", 0, 23))


@public
def cube_nearest(r: ArrayLike) -> NDArray[np.uint8]:
    """The number of the cube's rotation nearest to each."""
    return _elements(raw.obc_quaternion_cube_nearest_array, [("r", r, 4)])


@public
def symmetric_distance(p: ArrayLike, q: ArrayLike) -> Doubles:
    """The angle between frames, up to the 24 rotations of the cube."""
    return _array(raw.obc_quaternion_symmetric_distance_array, [("p", p, 4), ("q", q, 4)], 1)


@public
def symmetric_sine_square(p: ArrayLike, q: ArrayLike) -> Doubles:
    """sin^2 of half of it."""
    return _array(raw.obc_quaternion_symmetric_sine_square_array, [("p", p, 4), ("q", q, 4)], 1)


@public
def symmetric_matching(start: ArrayLike, end: ArrayLike) -> NDArray[np.uint8]:
    """The number of the g for which start g is nearest to the frame `end`."""
    return _elements(raw.obc_quaternion_symmetric_matching_array, [("start", start, 4), ("end", end, 4)])


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_quaternion_version()
