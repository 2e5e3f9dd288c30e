"""Spherical harmonics of scattered samples and of shapes: fit, reconstruction, spectra, distance, alignment, files.

Coefficients are arrays of (degree + 1)^2 rows, Y_lm in row l*l + l + m, with a column a channel: for a shape x, y and z.
"""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import Any, Literal, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, address, doubles
from ._call import HOST, Handle, Progress, call, call_init, filled, path_bytes, with_options
from ._checks import PathLike, integer, public
from ._foreign import surface_of
from .raw import harmonics as raw


def _channels(values: ArrayLike, name: str) -> Doubles:
    array = doubles(values, name=name)
    if array.size == 0 or array.ndim == 0:
        raise ValueError(f"{name}: a row for each and a column for each channel are needed, not shape {array.shape}")
    return array.reshape(len(array), -1)


def _coefficients(values: ArrayLike, name: str) -> Doubles:
    array = _channels(values, name)
    _degree(len(array), name)
    return array


def _together(f: ArrayLike, g: ArrayLike, first: str, second: str) -> tuple[Doubles, Doubles]:
    """Coefficients of as many channels."""
    a, b = _coefficients(f, first), _coefficients(g, second)
    if a.shape[1] != b.shape[1]:
        raise ValueError(f"{second}: {a.shape[1]} channels are needed, as {first} has, not {b.shape[1]}")
    return a, b


def _degree(rows: int, name: str) -> int:
    degree = int(round(rows ** 0.5)) - 1
    if degree < 0 or (degree + 1) ** 2 != rows:
        raise ValueError(f"{name}: (degree + 1)^2 rows are needed (1, 4, 9, 16, ...), not {rows}")
    return degree


@public
def degree_of(coefficients: ArrayLike) -> int:
    """From the number of rows."""
    return _degree(len(_channels(coefficients, "coefficients")), "coefficients")


@public
def evaluate(directions: ArrayLike, degree: int, *, threads: int = 0, progress: Progress = None) -> Doubles:
    """Y_lm at each direction, a row a direction."""
    at, degree = doubles(directions, 3, name="directions"), integer(degree, "degree", 0, 1000)
    rows = np.empty((len(at), (degree + 1) ** 2))
    call(raw.obc_harmonics_evaluate, address(at), len(at), degree, HOST, address(rows), threads=threads, progress=progress)
    return rows


@with_options("obc_harmonics_fit_options")
def fit(directions: ArrayLike, values: ArrayLike, weights: Optional[ArrayLike] = None, *,
        # options of obc_harmonics_fit_options, written by scripts/bindings.py
        degree: int = 16, method: Literal["automatic", "dense", "iterative"] = "automatic",
        regularization: Optional[float] = None,
        # end of options
        threads: int = 0, progress: Progress = None) -> tuple[Doubles, raw.obc_harmonics_fit_report]:
    """The coefficients that fit values at scattered directions best, and a report."""
    chosen = filled(raw.obc_harmonics_fit_options, raw.obc_harmonics_fit_options_init, locals())
    at, given = doubles(directions, 3, name="directions"), _channels(values, "values")
    if len(at) != len(given):
        raise ValueError(f"values: {len(at)} rows are needed, one for each of the directions, not {len(given)}")
    shares = None if weights is None else doubles(weights, rows=len(at), name="weights", each="direction")
    integer(degree, "degree", 0, 1000)
    coefficients = np.empty(((chosen.degree + 1) ** 2, given.shape[1]))
    report = raw.obc_harmonics_fit_report()
    call_init(raw.obc_harmonics_fit_report_init, report)
    call(raw.obc_harmonics_fit, address(at), address(shares), address(given), len(at), given.shape[1], byref(chosen), HOST,
         address(coefficients), byref(report), threads=threads, progress=progress)
    return coefficients, report


@with_options("obc_harmonics_fit_options")
def refine_map(surface: Any, directions: ArrayLike, weights: Optional[ArrayLike] = None, *, rounds: int = 10,
               # options of obc_harmonics_fit_options, written by scripts/bindings.py
               degree: int = 16, method: Literal["automatic", "dense", "iterative"] = "automatic",
               regularization: Optional[float] = None,
               # end of options
               threads: int = 0, progress: Progress = None) -> tuple[Doubles, raw.obc_harmonics_refinement_report]:
    """A sphere map moved to where the surface of the degree comes nearest to the vertices, and a report; a bijection stays one."""
    chosen = filled(raw.obc_harmonics_fit_options, raw.obc_harmonics_fit_options_init, locals())
    positions, triangles = surface_of(surface)
    moved = doubles(directions, 3, rows=len(positions), name="directions", each="vertex").copy()
    shares = None if weights is None else doubles(weights, rows=len(positions), name="weights", each="vertex")
    integer(degree, "degree", 0, 1000)
    report = raw.obc_harmonics_refinement_report()
    call_init(raw.obc_harmonics_refinement_report_init, report)
    call(raw.obc_harmonics_refine_map, address(positions), len(positions), address(triangles), len(triangles), address(shares),
         byref(chosen), integer(rounds, "rounds", 0, 2**32 - 1), HOST, address(moved), byref(report), threads=threads,
         progress=progress)
    return moved, report


@public
def synthesize(coefficients: ArrayLike, directions: ArrayLike, *, threads: int = 0,
               progress: Progress = None) -> Doubles:
    """The functions at the directions, a row a direction."""
    return _synthesized(coefficients, directions, False, threads, progress)[0]


@public
def gradients(coefficients: ArrayLike, directions: ArrayLike, *, threads: int = 0, progress: Progress = None) -> Doubles:
    """Their gradients on the unit sphere: shape (directions, channels, 3)."""
    return _synthesized(coefficients, directions, True, threads, progress)[1]


@public
def analyze(directions: ArrayLike, values: ArrayLike, degree: int, weights: Optional[ArrayLike] = None, *, threads: int = 0,
            progress: Progress = None) -> Doubles:
    """The transpose of synthesize: for each Y_lm the sum of weight * value * Y_lm over the directions."""
    at, given = doubles(directions, 3, name="directions"), _channels(values, "values")
    if len(at) != len(given):
        raise ValueError(f"values: {len(at)} rows are needed, one for each of the directions, not {len(given)}")
    shares = None if weights is None else doubles(weights, rows=len(at), name="weights", each="direction")
    degree = integer(degree, "degree", 0, 1000)
    sums = np.empty(((degree + 1) ** 2, given.shape[1]))
    call(raw.obc_harmonics_analyze, address(at), address(shares), address(given), len(at), given.shape[1], degree, HOST,
         address(sums), threads=threads, progress=progress)
    return sums


def _synthesized(coefficients: ArrayLike, directions: ArrayLike, wanted: bool, threads: int,
                 progress: Progress) -> tuple[Doubles, Doubles]:
    a, at = _coefficients(coefficients, "coefficients"), doubles(directions, 3, name="directions")
    values = np.empty((len(at), a.shape[1]))
    slopes = np.empty((len(at), a.shape[1], 3)) if wanted else np.empty(0)
    call(raw.obc_harmonics_synthesize, address(a), degree_of(a), a.shape[1], address(at), len(at), HOST, address(values),
         address(slopes), threads=threads, progress=progress)
    return values, slopes


@public
def degree_norms(coefficients: ArrayLike) -> Doubles:
    """The norm of each degree, which rotations do not change."""
    a = _coefficients(coefficients, "coefficients")
    norms = np.empty(degree_of(a) + 1)
    call(raw.obc_harmonics_degree_norms, address(a), degree_of(a), a.shape[1], address(norms))
    return norms


@public
def shape_distance(f: ArrayLike, g: ArrayLike, first: int = 0, last: Optional[int] = None) -> float:
    """The distance D_n between shapes, by the norms of their degrees from first to last."""
    a, b = _together(f, g, "f", "g")
    distance = ctypes.c_double()
    end = max(degree_of(a), degree_of(b)) if last is None else last
    call(raw.obc_harmonics_shape_distance, address(a), degree_of(a), address(b), degree_of(b), a.shape[1], first, end,
         byref(distance))
    return distance.value


@public
def filter(coefficients: ArrayLike, low: int, high: int, width: int = 0, keep_mean: bool = False) -> Doubles:
    """A copy of which the degrees from low to high stay."""
    a = _coefficients(coefficients, "coefficients").copy()
    call(raw.obc_harmonics_filter, address(a), degree_of(a), a.shape[1], low, high, width, int(keep_mean))
    return a


@public
def rotate(coefficients: ArrayLike, rotation: ArrayLike, *, progress: Progress = None) -> Doubles:
    """The functions turned with the sphere by a matrix."""
    a, matrix = _coefficients(coefficients, "coefficients"), doubles(rotation, 3, 3, name="rotation")
    turned = np.empty_like(a)
    call(raw.obc_harmonics_rotate, address(a), degree_of(a), a.shape[1], address(matrix), HOST, address(turned),
         progress=progress)
    return turned


@with_options("obc_harmonics_align_options")
def align(fixed: ArrayLike, moving: ArrayLike, *,
          # options of obc_harmonics_align_options, written by scripts/bindings.py
          turn_values: bool = False, search_degree: int = 12,
          # end of options
          progress: Progress = None) -> raw.obc_harmonics_alignment:
    """The rotation that brings `moving` best into line with `fixed`: rotation and values (nine numbers by rows), correlation."""
    chosen = filled(raw.obc_harmonics_align_options, raw.obc_harmonics_align_options_init, locals())
    a, b = _together(fixed, moving, "fixed", "moving")
    found = raw.obc_harmonics_alignment()
    call_init(raw.obc_harmonics_alignment_init, found)
    call(raw.obc_harmonics_align, address(a), degree_of(a), address(b), degree_of(b), a.shape[1], byref(chosen), HOST,
         byref(found), progress=progress)
    return found


def _format(name: str) -> int:
    return int(getattr(raw, "OBC_HARMONICS_" + name.upper().replace("-", "_")))


@public
def write(path: PathLike, coefficients: ArrayLike, format: Literal["by-ending", "shtools", "spharm-pdm"] = "by-ending") -> None:
    """To a file of SHTOOLS (.sh .shtools .txt) or SPHARM-PDM (.coef)."""
    a = _coefficients(coefficients, "coefficients")
    call(raw.obc_harmonics_write, path_bytes(path), _format(format), address(a), degree_of(a), a.shape[1])


@public
def read(path: PathLike, format: Literal["by-ending", "shtools", "spharm-pdm"] = "by-ending", *, progress: Progress = None) -> Doubles:
    """Coefficients from such a file."""
    handle = Handle(raw.obc_harmonics_coefficients_destroy)
    call(raw.obc_harmonics_read, path_bytes(path), _format(format), HOST, byref(handle), progress=progress)
    try:
        degree = raw.obc_harmonics_coefficients_degree(handle)
        values = np.empty(((degree + 1) ** 2, raw.obc_harmonics_coefficients_channels(handle)))
        call(raw.obc_harmonics_coefficients_copy, handle, address(values))
    finally:
        handle.close()
    return values


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_harmonics_version()
