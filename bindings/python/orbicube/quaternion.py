"""Unit quaternions w x y z, rotations, the 24 rotations of the cube, and frames up to them.

Functions take one quaternion (or vector, matrix) or rows of them, and answer likewise; one of two arguments may be single.
"""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import Doubles, address, doubles
from ._call import call
from .raw import quaternion as raw


def _together(parts: list[tuple[ArrayLike, int]]) -> tuple[list[Doubles], tuple[int, ...]]:
    """Arguments of so many numbers each, broadcast to one shape of rows, and that shape."""
    arrays = [np.asarray(values, dtype=np.float64) for values, _ in parts]
    for array, (_, width) in zip(arrays, parts):
        if width > 1 and array.shape[-1:] != (width,):
            raise ValueError(f"{width} numbers in the last dimension are needed, not shape {array.shape}")
    shape = np.broadcast_shapes(*[array.shape[:-1] if width > 1 else array.shape
                                  for array, (_, width) in zip(arrays, parts)])
    wide = [np.ascontiguousarray(np.broadcast_to(array, shape + ((width,) if width > 1 else ())))
            for array, (_, width) in zip(arrays, parts)]
    return wide, shape


def _filled(function: Any, parts: list[tuple[ArrayLike, int]], width: int, kind: Any) -> Any:
    """A function of arrays with the count before the result."""
    arrays, shape = _together(parts)
    out = np.empty(shape + ((width,) if width > 1 else ()), dtype=kind)
    function(*[array.ctypes.data for array in arrays], int(np.prod(shape)), out.ctypes.data)
    return out[()] if out.ndim == 0 else out


def _array(function: Any, parts: list[tuple[ArrayLike, int]], width: int) -> Doubles:
    out: Doubles = _filled(function, parts, width, np.float64)
    return out


def _elements(function: Any, parts: list[tuple[ArrayLike, int]]) -> NDArray[np.uint8]:
    """Numbers of the cube's rotations."""
    out: NDArray[np.uint8] = _filled(function, parts, 1, np.uint8)
    return out


def _each(function: Any, parts: list[tuple[ArrayLike, int]], width: int, checked: bool = False) -> Doubles:
    return _rows(function, parts, [width], checked)[0]


def _rows(function: Any, parts: list[tuple[ArrayLike, int]], widths: list[int], checked: bool = False) -> list[Doubles]:
    """A function of one, called for each row."""
    arrays, shape = _together(parts)
    count = int(np.prod(shape))
    outs = [np.empty(shape + ((width,) if width > 1 else ())) for width in widths]
    places = [(array.ctypes.data, 8 * width) for array, (_, width) in zip(arrays, parts)]
    ends = [(out.ctypes.data, 8 * width) for out, width in zip(outs, widths)]
    for i in range(count):
        arguments = [start + i * step for start, step in places] + [start + i * step for start, step in ends]
        if checked:
            call(function, *arguments)
        else:
            function(*arguments)
    return outs


def multiply(p: ArrayLike, q: ArrayLike) -> Doubles:
    """p q, Hamilton's product: turns by q first."""
    return _array(raw.obc_quaternion_multiply_array, [(p, 4), (q, 4)], 4)


def inverse(q: ArrayLike) -> Doubles:
    return _each(raw.obc_quaternion_inverse, [(q, 4)], 4)


def normalize(q: ArrayLike) -> Doubles:
    """Of length 1."""
    return _array(raw.obc_quaternion_normalize_array, [(q, 4)], 4)


def exponential(q: ArrayLike) -> Doubles:
    return _each(raw.obc_quaternion_exponential, [(q, 4)], 4)


def logarithm(q: ArrayLike) -> Doubles:
    return _each(raw.obc_quaternion_logarithm, [(q, 4)], 4)


def slerp(p: ArrayLike, q: ArrayLike, t: ArrayLike) -> Doubles:
    """Along the shorter arc, p at t = 0 and q at t = 1."""
    return _array(raw.obc_quaternion_slerp_array, [(p, 4), (q, 4), (t, 1)], 4)


def average(q: ArrayLike, weights: Optional[ArrayLike] = None) -> tuple[Doubles, float]:
    """The mean rotation of rows, and how much they agree (1: all)."""
    rows = doubles(q, 4, name="q")
    shares = None if weights is None else doubles(weights, rows=len(rows), name="weights")
    mean, agreement = np.empty(4), ctypes.c_double()
    call(raw.obc_quaternion_average, address(rows), address(shares), len(rows), address(mean), byref(agreement))
    return mean, agreement.value


def rotate(q: ArrayLike, v: ArrayLike) -> Doubles:
    """q v q^-1."""
    return _array(raw.obc_quaternion_rotate_array, [(q, 4), (v, 3)], 3)


def from_axis_angle(axis: ArrayLike, angle: ArrayLike) -> Doubles:
    axes, angles = np.asarray(axis, dtype=np.float64), np.asarray(angle, dtype=np.float64)
    shape = np.broadcast_shapes(axes.shape[:-1], angles.shape)
    out = np.empty(shape + (4,))
    wide = np.ascontiguousarray(np.broadcast_to(axes, shape + (3,))).reshape(-1, 3)
    for i, (row, turn) in enumerate(zip(wide, np.broadcast_to(angles, shape).ravel())):
        call(raw.obc_quaternion_from_axis_angle, row.ctypes.data, float(turn), out.ctypes.data + 32 * i)
    return out


def to_axis_angle(q: ArrayLike) -> tuple[Doubles, Doubles]:
    axis, angle = _rows(raw.obc_quaternion_to_axis_angle, [(q, 4)], [3, 1])
    return axis, angle


def from_rotation_vector(v: ArrayLike) -> Doubles:
    return _each(raw.obc_quaternion_from_rotation_vector, [(v, 3)], 4)


def to_rotation_vector(q: ArrayLike) -> Doubles:
    return _each(raw.obc_quaternion_to_rotation_vector, [(q, 4)], 3)


def _matrices(matrix: ArrayLike) -> Doubles:
    array = np.asarray(matrix, dtype=np.float64)
    if array.shape[-2:] != (3, 3):
        raise ValueError(f"matrices of 3 by 3 are needed, not shape {array.shape}")
    return np.ascontiguousarray(array).reshape(array.shape[:-2] + (9,))


def to_matrix(q: ArrayLike) -> Doubles:
    flat = _array(raw.obc_quaternion_to_matrix_array, [(q, 4)], 9)
    return flat.reshape(flat.shape[:-1] + (3, 3))


def from_matrix(matrix: ArrayLike) -> Doubles:
    """Of rotation matrices; InvalidArgument for what is none."""
    flat = _matrices(matrix)
    out = np.empty(flat.shape[:-1] + (4,))
    call(raw.obc_quaternion_from_matrix_array, flat.ctypes.data, int(np.prod(flat.shape[:-1])), out.ctypes.data)
    return out


def nearest_to_matrix(matrix: ArrayLike) -> Doubles:
    """The rotation nearest to any matrix."""
    return _each(raw.obc_quaternion_nearest_to_matrix, [(_matrices(matrix), 9)], 4, checked=True)


def cube_element(number: int) -> Doubles:
    """The quaternion of one of the 24 rotations of the cube."""
    out = np.empty(4)
    call(raw.obc_quaternion_cube_element, number, out.ctypes.data)
    return out


def cube_matrix(number: int) -> Doubles:
    out = np.empty((3, 3))
    call(raw.obc_quaternion_cube_matrix, number, out.ctypes.data)
    return out


def _number(answer: int) -> int:
    if answer == raw.OBC_QUATERNION_CUBE_NONE or answer == -1:
        raise ValueError("the cube's rotations have the numbers 0 to 23")
    return answer


def cube_product(a: int, b: int) -> int:
    """The number of a b, b first."""
    return _number(raw.obc_quaternion_cube_product(a, b))


def cube_inverse(a: int) -> int:
    return _number(raw.obc_quaternion_cube_inverse(a))


def cube_class(number: int) -> int:
    """OBC_QUATERNION_IDENTITY, ... of the raw module."""
    return _number(raw.obc_quaternion_cube_class(number))


def cube_nearest(r: ArrayLike) -> NDArray[np.uint8]:
    """The number of the cube's rotation nearest to each."""
    return _elements(raw.obc_quaternion_cube_nearest_array, [(r, 4)])


def symmetric_distance(p: ArrayLike, q: ArrayLike) -> Doubles:
    """The angle between frames, up to the 24 rotations of the cube."""
    return _array(raw.obc_quaternion_symmetric_distance_array, [(p, 4), (q, 4)], 1)


def symmetric_sine_square(p: ArrayLike, q: ArrayLike) -> Doubles:
    """sin^2 of half of it."""
    return _array(raw.obc_quaternion_symmetric_sine_square_array, [(p, 4), (q, 4)], 1)


def symmetric_matching(start: ArrayLike, end: ArrayLike) -> NDArray[np.uint8]:
    """The number of the g for which start g is nearest to the frame `end`."""
    return _elements(raw.obc_quaternion_symmetric_matching_array, [(start, 4), (end, 4)])


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_quaternion_version()


