"""Minimises f(x) subject to A x = b and lower <= x <= upper, with the gradient of f; and projects onto such sets.

    result = minimize(f_and_gradient, x0, lower=0, upper=0.6, A=[[1, 1, 1]], b=[1])

`A` is an array of rows, a matrix of scipy.sparse (or anything with `tocsr`), or (row_start, column, value). Instead of bounds
and rows, `project` may be a function that answers the nearest point of a convex set. Options are the members of
`obc_projected_gradient_options`; docs/projected_gradient.md of the library tells what they do.
"""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, address, doubles, indices, memory_of, put
from ._call import HOST, Progress, Stop, call, call_init, filled, sized, text
from ._solver import EvaluationFailed, GradientRun, Result
from .raw import projected_gradient as raw

__all__ = ["EvaluationFailed", "Result", "Solver", "Stop", "minimize", "project", "version"]


class _Problem:
    """obc_projected_gradient_problem with the arrays and the callback that it points at."""

    def __init__(self, n: int, lower: Any, upper: Any, A: Any, b: Any, project: Any) -> None:
        self.struct = raw.obc_projected_gradient_problem()
        call_init(raw.obc_projected_gradient_problem_init, self.struct)
        self.struct.n = n
        self.kept: list[Any] = []
        self.raised: Optional[BaseException] = None
        for name, value in (("lower", lower), ("upper", upper)):
            if value is not None:
                self.keep(name, doubles(np.broadcast_to(value, (n,)), name=name))
        if A is not None:
            starts, columns, values = _rows(A, n)
            self.struct.m = starts.size - 1
            self.keep("row_start", starts)
            self.keep("column", columns)
            self.keep("value", values)
            self.keep("b", doubles(b, rows=starts.size - 1, name="b"))
        if project is not None:
            self.function = project
            self.struct.project = raw.obc_projected_gradient_projection(self.projected)

    def keep(self, name: str, array: Any) -> None:
        self.kept.append(array)
        setattr(self.struct, name, address(array))

    def projected(self, y: int, n: int, x: int, _: Any) -> int:
        try:
            put(memory_of(x, n), self.function(memory_of(y, n).copy()), "project")
            return 0
        except BaseException as error:  # noqa: BLE001: raised again by the solver's caller
            self.raised = error
            return 1

    def check(self) -> None:
        if self.raised is not None:
            raised, self.raised = self.raised, None
            raise raised


def _rows(A: Any, n: int) -> tuple[Any, Any, Any]:
    if isinstance(A, tuple) and len(A) == 3:
        starts, columns, values = A
    elif hasattr(A, "tocsr"):
        csr = A.tocsr()
        starts, columns, values = csr.indptr, csr.indices, csr.data
        if csr.shape[1] != n:
            raise ValueError(f"A: {n} columns are needed, not shape {csr.shape}")
    else:
        dense = np.atleast_2d(np.asarray(A, dtype=np.float64))
        if dense.shape[1] != n:
            raise ValueError(f"A: {n} columns are needed, not shape {dense.shape}")
        row, columns = np.nonzero(dense)
        values, starts = dense[row, columns], np.searchsorted(row, np.arange(len(dense) + 1))
    starts = np.ascontiguousarray(starts, dtype=np.uintp)
    columns, values = indices(columns, name="column"), doubles(values, name="value")
    if starts.size == 0 or starts[0] != 0 or np.any(np.diff(starts.astype(np.int64)) < 0) or \
            not columns.size == values.size == starts[-1]:
        raise ValueError("A: row_start must rise from 0 to the number of entries of column and value")
    return starts, columns, values


class Solver(GradientRun):
    """A run by questions and answers."""

    def __init__(self, x0: ArrayLike, *, lower: Optional[ArrayLike] = None, upper: Optional[ArrayLike] = None,
                 A: Any = None, b: Optional[ArrayLike] = None,
                 project: Optional[Callable[[Doubles], ArrayLike]] = None, _load: Optional[bytes] = None,
                 **options: Any) -> None:
        start = doubles(np.ravel(np.asarray(x0, dtype=np.float64)), name="x0")
        self._problem = _Problem(start.size, lower, upper, A, b, project)
        handle = ctypes.c_void_p()
        if _load is None:
            chosen = filled(raw.obc_projected_gradient_options, raw.obc_projected_gradient_options_init, options, raw,
                            "OBC_PROJECTED_GRADIENT_")
            call(raw.obc_projected_gradient_create, byref(self._problem.struct), byref(chosen), address(start), None,
                 byref(handle))
        else:
            call(raw.obc_projected_gradient_load, byref(self._problem.struct), _load, len(_load), None, byref(handle))
        super().__init__(raw, "obc_projected_gradient", handle.value or 0, start.shape)
        if project is not None:
            self._check = self._problem.check

    @classmethod
    def load(cls, blob: bytes, x0: ArrayLike, *, lower: Optional[ArrayLike] = None, upper: Optional[ArrayLike] = None,
             A: Any = None, b: Optional[ArrayLike] = None,
             project: Optional[Callable[[Doubles], ArrayLike]] = None) -> Solver:
        """Goes on with a run that was saved, of the same problem; of x0 only the length counts."""
        return cls(x0, lower=lower, upper=upper, A=A, b=b, project=project, _load=blob)

    @property
    def multipliers(self) -> Doubles:
        """Of the rows, at the current iterate: gradient - A't is zero strictly between the bounds of a solution."""
        found = np.empty(self._problem.struct.m)
        call(raw.obc_projected_gradient_multipliers, self._handle, address(found))
        return found

    @property
    def certificate(self) -> Doubles:
        """After "infeasible": c with c'A x < c'b for all x within the bounds."""
        found = np.empty(self._problem.struct.m)
        call(raw.obc_projected_gradient_certificate, self._handle, address(found))
        return found


def minimize(f: Callable[[Doubles], tuple[float, ArrayLike]], x0: ArrayLike, *, lower: Optional[ArrayLike] = None,
             upper: Optional[ArrayLike] = None, A: Any = None, b: Optional[ArrayLike] = None,
             project: Optional[Callable[[Doubles], ArrayLike]] = None, progress: Progress = None,
             **options: Any) -> Result:
    """The least value of f in the feasible set; f answers (value, gradient)."""
    return Solver(x0, lower=lower, upper=upper, A=A, b=b, project=project, **options).run(f, progress)


class Projection:
    """The nearest point `x`, the `multipliers` of the rows, the text `stop` and the figures in `report`."""

    def __init__(self, x: Doubles, multipliers: Doubles, report: Any) -> None:
        self.x, self.multipliers, self.report = x, multipliers, report
        self.stop = text(raw.obc_projected_gradient_stop_name(report.stop)) or ""


def project(y: ArrayLike, *, lower: Optional[ArrayLike] = None, upper: Optional[ArrayLike] = None, A: Any = None,
            b: Optional[ArrayLike] = None, progress: Progress = None) -> Projection:
    """The point of the feasible set that is nearest to y."""
    point = doubles(np.ravel(np.asarray(y, dtype=np.float64)), name="y")
    problem = _Problem(point.size, lower, upper, A, b, None)
    x, multipliers = np.empty(point.size), np.empty(problem.struct.m)
    report = sized(raw.obc_projected_gradient_result)
    call(raw.obc_projected_gradient_project, byref(problem.struct), address(point), address(x), address(multipliers),
         byref(report), HOST, progress=progress)
    return Projection(x, multipliers, report)


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_projected_gradient_version()
