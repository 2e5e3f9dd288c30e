"""Meshes without inverted elements.

    positions, report = tetrahedra((positions, tetrahedra), rest=rest_positions, fixed=fixed)
    flat, report = triangles(flat, surface.triangles, rest=surface.positions)
    refined = refine_triangles(flat, surface.triangles, rest=surface.positions)   # splits triangles where that is needed
"""

from __future__ import annotations

from ctypes import byref
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, Indices, address, doubles, indices, numbers
from ._call import HOST, Handle, NoValidResult, Progress, call, call_init, filled, with_options
from ._foreign import solid_of
from ._records import Record
from .raw import untangle as raw

__all__ = ["Refined", "refine_tetrahedra", "refine_triangles", "tetrahedra", "triangles", "version"]


def _set_constraints(problem: Any, positions: Doubles, rest: Optional[ArrayLike], fixed: Optional[ArrayLike],
                     ties: Optional[ArrayLike]) -> list[Any]:
    """Sets rest positions, fixed vertices or coordinates, and ties; returns the arrays to keep."""
    kept: list[Any] = []
    if rest is not None:
        kept.append(doubles(rest, 3, len(positions), "rest", each="vertex"))
        problem.rest = address(kept[-1])
    if fixed is not None:
        flags = numbers(fixed, "fixed")
        if flags.shape not in (positions.shape, (len(positions),)) or not np.all((flags == 0) | (flags == 1)):
            raise ValueError(f"fixed: a flag for each coordinate, shape {positions.shape}, or for each vertex, shape "
                             f"({len(positions)},), is needed, not shape {flags.shape}")
        kept.append(np.ascontiguousarray(flags, dtype=np.uint8))
        if flags.ndim == 1:
            problem.fixed = address(kept[-1])
        else:
            problem.fixed_coordinates = address(kept[-1])
    if ties is not None:
        kept.append(indices(ties, positions.shape[1], len(positions), "ties", each="vertex"))
        problem.ties = address(kept[-1])
    return kept


def _tetrahedra_problem(solid: Any, rest: Optional[ArrayLike], fixed: Optional[ArrayLike],
                        ties: Optional[ArrayLike]) -> tuple[Any, Doubles, list[Any]]:
    """The problem, its positions, and the arrays to keep."""
    positions, cells = solid_of(solid)
    problem = raw.obc_untangle_tetrahedra_problem()
    call_init(raw.obc_untangle_tetrahedra_problem_init, problem)
    problem.positions, problem.vertex_count = address(positions), len(positions)
    problem.tetrahedra, problem.tetrahedron_count = address(cells), len(cells)
    return problem, positions, [positions, cells, *_set_constraints(problem, positions, rest, fixed, ties)]


def _triangles_problem(positions: ArrayLike, triangles: ArrayLike, rest: Optional[ArrayLike], fixed: Optional[ArrayLike],
                       ties: Optional[ArrayLike]) -> tuple[Any, Doubles, list[Any]]:
    """The same for triangles."""
    places = doubles(positions, 2, name="positions")
    corners = indices(triangles, 3, name="triangles")
    problem = raw.obc_untangle_triangles_problem()
    call_init(raw.obc_untangle_triangles_problem_init, problem)
    problem.positions, problem.vertex_count = address(places), len(places)
    problem.triangles, problem.triangle_count = address(corners), len(corners)
    shapes = numbers(rest, "rest") if rest is not None else None
    if shapes is not None and shapes.ndim == 2 and shapes.shape[1] == 2:
        shapes = np.hstack([shapes, np.zeros((len(shapes), 1))])
    return problem, places, [places, corners, *_set_constraints(problem, places, shapes, fixed, ties)]


def _run(function: Any, problem: Any, kept: list[Any], chosen: Any, positions: Doubles, threads: int,
         progress: Progress) -> tuple[Doubles, raw.obc_untangle_report]:
    """Calls with arrays that `kept` keeps."""
    report = raw.obc_untangle_report()
    call_init(raw.obc_untangle_report_init, report)
    result = np.empty_like(positions)
    try:
        call(function, byref(problem), byref(chosen), HOST, address(result), byref(report), threads=threads, progress=progress)
    except NoValidResult as error:
        error.best = (result, report)
        raise
    return result, report


class Refined(Record):
    """positions and elements of the mesh after splits; parents, for each element the one of the mesh before that it is part of;
    origins and weights, for each vertex the vertices of the mesh before whose mean it is there (2 ** 32 - 1 and 0: none); and the
    report. Vertices of the mesh before come first."""

    def __init__(self, positions: Doubles, elements: Indices, parents: Indices, origins: Indices, weights: Doubles,
                 report: raw.obc_untangle_report) -> None:
        self.positions, self.elements, self.parents = positions, elements, parents
        self.origins, self.weights, self.report = origins, weights, report


def _refine(function: Any, problem: Any, kept: list[Any], chosen: Any, axes: int, threads: int, progress: Progress) -> Refined:
    report, handle = raw.obc_untangle_report(), Handle(raw.obc_untangle_refined_destroy)
    call_init(raw.obc_untangle_report_init, report)
    call(function, byref(problem), byref(chosen), HOST, byref(handle), byref(report), threads=threads, progress=progress)
    try:
        n, m = raw.obc_untangle_refined_vertex_count(handle), raw.obc_untangle_refined_element_count(handle)
        positions, elements, parents = np.empty((n, axes)), np.empty((m, axes + 1), np.uint32), np.empty(m, np.uint32)
        origins, weights = np.empty((n, axes + 1), np.uint32), np.empty((n, axes + 1))
        call(raw.obc_untangle_refined_copy, handle, address(positions), address(elements), address(parents), address(origins),
             address(weights))
        return Refined(positions, elements, parents, origins, weights, report)
    finally:
        handle.close()


@with_options("obc_untangle_options")
def tetrahedra(solid: Any, *,
               # options of obc_untangle_options, written by scripts/bindings.py
               max_steps: int = 500, max_polish_steps: int = 20, free_boundary: bool = False, volume_weight: float = 1.0,
               tolerance: float = 0.0001,
               # end of options
               rest: Optional[ArrayLike] = None, fixed: Optional[ArrayLike] = None, ties: Optional[ArrayLike] = None, threads: int = 0, progress: Progress = None) -> tuple[Doubles, raw.obc_untangle_report]:
    """Moves vertices until every tetrahedron is positive; returns positions and a report. rest: positions in which each has its
    target shape. fixed: a flag a vertex, shape (n,), or a coordinate, shape (n, 3); default: boundary vertices are fixed. ties: a
    group a coordinate, whose coordinates are kept equal, or 2^32 - 1. If some remain inverted, the NoValidResult has the best
    positions and report found as its member `best`."""
    chosen = filled(raw.obc_untangle_options, raw.obc_untangle_options_init, locals())
    problem, positions, kept = _tetrahedra_problem(solid, rest, fixed, ties)
    return _run(raw.obc_untangle_tetrahedra, problem, kept, chosen, positions, threads, progress)


@with_options("obc_untangle_options")
def triangles(positions: ArrayLike, triangles: ArrayLike, *,
              # options of obc_untangle_options, written by scripts/bindings.py
              max_steps: int = 500, max_polish_steps: int = 20, free_boundary: bool = False, volume_weight: float = 1.0,
              tolerance: float = 0.0001,
              # end of options
              rest: Optional[ArrayLike] = None, fixed: Optional[ArrayLike] = None, ties: Optional[ArrayLike] = None, threads: int = 0, progress: Progress = None) -> tuple[Doubles, raw.obc_untangle_report]:
    """Moves vertices in the plane, positions of shape (n, 2), until every triangle is positive; returns positions and a report. rest:
    positions in which each has its target shape, of shape (n, 3), such as a surface whose map to the plane the mesh is, or (n, 2).
    fixed, ties and errors as of tetrahedra(), for two coordinates a vertex."""
    chosen = filled(raw.obc_untangle_options, raw.obc_untangle_options_init, locals())
    problem, places, kept = _triangles_problem(positions, triangles, rest, fixed, ties)
    return _run(raw.obc_untangle_triangles, problem, kept, chosen, places, threads, progress)


@with_options("obc_untangle_options")
def refine_tetrahedra(solid: Any, *,
                      # options of obc_untangle_options, written by scripts/bindings.py
                      max_steps: int = 500, max_polish_steps: int = 20, free_boundary: bool = False,
                      volume_weight: float = 1.0, tolerance: float = 0.0001,
                      # end of options
                      rest: Optional[ArrayLike] = None, fixed: Optional[ArrayLike] = None, ties: Optional[ArrayLike] = None, threads: int = 0, progress: Progress = None) -> Refined:
    """As tetrahedra(), and splits tetrahedra where the mesh as it is has no solution, or none is found."""
    chosen = filled(raw.obc_untangle_options, raw.obc_untangle_options_init, locals())
    problem, _, kept = _tetrahedra_problem(solid, rest, fixed, ties)
    return _refine(raw.obc_untangle_refine_tetrahedra, problem, kept, chosen, 3, threads, progress)


@with_options("obc_untangle_options")
def refine_triangles(positions: ArrayLike, triangles: ArrayLike, *,
                     # options of obc_untangle_options, written by scripts/bindings.py
                     max_steps: int = 500, max_polish_steps: int = 20, free_boundary: bool = False,
                     volume_weight: float = 1.0, tolerance: float = 0.0001,
                     # end of options
                     rest: Optional[ArrayLike] = None, fixed: Optional[ArrayLike] = None, ties: Optional[ArrayLike] = None, threads: int = 0, progress: Progress = None) -> Refined:
    """As triangles(), and splits triangles where the mesh as it is has no solution, or none is found. A disk whose boundary is fixed to a
    star-shaped polygon always has one."""
    chosen = filled(raw.obc_untangle_options, raw.obc_untangle_options_init, locals())
    problem, _, kept = _triangles_problem(positions, triangles, rest, fixed, ties)
    return _refine(raw.obc_untangle_refine_triangles, problem, kept, chosen, 2, threads, progress)


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_untangle_version()
