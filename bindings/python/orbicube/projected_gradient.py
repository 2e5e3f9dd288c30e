"""Minimizes f(x) subject to A x = b and lower <= x <= upper, with the gradient of f; and projects onto such sets.

    result = minimize(f_and_gradient, x0, lower=0, upper=0.6, A=[[1, 1, 1]], b=[1])

`A` is an array of rows, a matrix of scipy.sparse (or anything with `tocsr`), or (row_start, column, value). Instead of bounds
and rows, `project` may be a function that returns the nearest point of a convex set. Options are the members of
`obc_projected_gradient_options`; docs/projected_gradient.md of the library describes them.
"""

from __future__ import annotations

import ctypes
import warnings
from ctypes import byref
from typing import Any, Callable, Literal, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, address, doubles, indices, memory_of, numbers, put, spread, start_of
from ._call import HOST, Cancelled, Progress, Stop, call, call_init, filled, picked, sized, text, with_options
from ._checks import public
from ._scipy import Differences, Rows, arguments_of, bounds_of, minimized, options_of, outcome
from ._solver import EvaluationFailed, GradientRun, Result, explain_pair
from .raw import projected_gradient as raw

__all__ = ["EvaluationFailed", "GradientCheck", "Result", "Solver", "Stop", "check_gradient", "minimize", "project", "scipy_method",
           "version"]


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
                self.keep(name, spread(value, n, name))
        if A is None and b is not None:
            raise ValueError("b without A: A x = b needs both")
        if A is not None:
            starts, columns, values = _rows(A, n)
            self.struct.m = starts.size - 1
            self.keep("row_start", starts)
            self.keep("column", columns)
            self.keep("value", values)
            if b is None:
                raise TypeError(f"b is needed with A: a number for each of its rows, {self.struct.m} in all")
            self.keep("b", doubles(np.ravel(numbers(b, "b")), rows=self.struct.m, name="b", each="row of A"))
        if project is not None:
            if A is not None or lower is not None or upper is not None:
                raise ValueError("project stands for the whole feasible set: give it, or lower, upper, A and b, not both")
            self.function = project
            self.struct.project = raw.obc_projected_gradient_projection(self.projected)

    def keep(self, name: str, array: Any) -> None:
        self.kept.append(array)
        setattr(self.struct, name, address(array))

    def projected(self, y: int, n: int, x: int, _: Any) -> int:
        try:
            put(memory_of(x, n), self.function(memory_of(y, n).copy()), "what project returned")
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
        starts, columns, values = [numbers(part, f"A[{i}]") for i, part in enumerate(A)]
    elif hasattr(A, "tocsr"):
        csr = A.tocsr()
        starts, columns, values = csr.indptr, csr.indices, csr.data
        if csr.shape[1] != n:
            raise ValueError(f"A: {n} columns are needed, not shape {csr.shape}")
    else:
        dense = np.atleast_2d(doubles(A, name="A"))
        if dense.ndim != 2 or dense.shape[1] != n:
            raise ValueError(f"A: {n} columns are needed, one for each unknown, not shape {dense.shape}")
        row, columns = np.nonzero(dense)
        values, starts = dense[row, columns], np.searchsorted(row, np.arange(len(dense) + 1))
    starts = np.ascontiguousarray(indices(starts, name="A: row_start"), dtype=np.uintp)
    columns, values = indices(columns, name="A: column", below=n, of="unknowns"), doubles(values, name="A: value")
    if starts.size == 0 or starts[0] != 0 or np.any(np.diff(starts.astype(np.int64)) < 0) or \
            not columns.size == values.size == starts[-1]:
        raise ValueError("A: row_start must rise from 0 to the number of entries of column and value")
    return starts, columns, values


class Solver(GradientRun):
    """A run by reverse communication."""

    @with_options("obc_projected_gradient_options")
    def __init__(self, x0: ArrayLike, *, lower: Optional[ArrayLike] = None, upper: Optional[ArrayLike] = None,
                 A: Any = None, b: Optional[ArrayLike] = None, project: Optional[Callable[[Doubles], ArrayLike]] = None,
                 # options of obc_projected_gradient_options, written by scripts/bindings.py
                 method: Literal["face", "dissertation"] = "face",
                 line_search: Literal["max-of-last", "average"] = "max-of-last", memory: int = 10, history: int = 10,
                 average_weight: float = 0.85, gradient_tolerance: float = 1e-08, target: float = float("-inf"),
                 max_evaluations: int = 100000, max_iterations: int = 100000,
                 # end of options
                 ) -> None:
        chosen = filled(raw.obc_projected_gradient_options, raw.obc_projected_gradient_options_init, locals())
        start = start_of(x0, "x0")
        problem, handle = _Problem(start.size, lower, upper, A, b, project), ctypes.c_void_p()
        call(raw.obc_projected_gradient_create, byref(problem.struct), byref(chosen), address(start), None, byref(handle))
        self._begin(handle, start.size, problem)

    def _begin(self, handle: ctypes.c_void_p, n: int, problem: _Problem) -> None:
        self._problem = problem
        super().__init__(raw, "obc_projected_gradient", handle.value or 0, (n,))
        self._check = problem.check

    @classmethod
    @public
    def load(cls, blob: bytes, x0: ArrayLike, *, lower: Optional[ArrayLike] = None, upper: Optional[ArrayLike] = None,
             A: Any = None, b: Optional[ArrayLike] = None,
             project: Optional[Callable[[Doubles], ArrayLike]] = None) -> Solver:
        """Goes on with a run that was saved, of the same problem; of x0 only the length counts."""
        n = np.size(numbers(x0, "x0"))
        problem, handle = _Problem(n, lower, upper, A, b, project), ctypes.c_void_p()
        call(raw.obc_projected_gradient_load, byref(problem.struct), blob, len(blob), None, byref(handle))
        solver = cls.__new__(cls)
        solver._begin(handle, n, problem)
        return solver

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


@with_options("obc_projected_gradient_options")
def minimize(f: Callable[[Doubles], tuple[float, ArrayLike]], x0: ArrayLike, *, lower: Optional[ArrayLike] = None,
             upper: Optional[ArrayLike] = None, A: Any = None, b: Optional[ArrayLike] = None,
             project: Optional[Callable[[Doubles], ArrayLike]] = None,
             # options of obc_projected_gradient_options, written by scripts/bindings.py
             method: Literal["face", "dissertation"] = "face",
             line_search: Literal["max-of-last", "average"] = "max-of-last", memory: int = 10, history: int = 10,
             average_weight: float = 0.85, gradient_tolerance: float = 1e-08, target: float = float("-inf"),
             max_evaluations: int = 100000, max_iterations: int = 100000,
             # end of options
             progress: Progress = None) -> Result:
    """The minimum value of f in the feasible set; f returns (value, gradient)."""
    options = picked(locals(), "obc_projected_gradient_options")
    return Solver(x0, lower=lower, upper=upper, A=A, b=b, project=project, **options).run(f, progress)


_WORDS = {"maxfev": "max_evaluations", "maxfun": "max_evaluations", "maxiter": "max_iterations", "maxcor": "memory",
          "gtol": "gradient_tolerance", "tol": "gradient_tolerance"}


def scipy_method(fun: Callable[..., Any], x0: ArrayLike, args: tuple[Any, ...] = (), *, jac: Any = None, bounds: Any = None,
                 constraints: Any = (), callback: Any = None, hess: Any = None, hessp: Any = None, disp: bool = False,
                 differences: str = "2-point", finite_diff_rel_step: Any = None, **options: Any) -> Any:
    """scipy.optimize.minimize(fun, x0, jac=..., method=scipy_method): fun with its gradient, within bounds and LinearConstraint
    objects. Without jac, the gradient is by differences within the bounds, which leave the rows; `nfev` counts their evaluations.
    `tol` is gradient_tolerance, and `options` has those of `minimize` here, also as maxfev, maxfun, maxiter, maxcor and gtol, and
    `differences`, '2-point' or '3-point', with finite_diff_rel_step."""
    for name, value in (("hess", hess), ("hessp", hessp)):
        if value:
            warnings.warn(f"projected_gradient.scipy_method does not use second derivatives ({name})", RuntimeWarning, stacklevel=3)
    start, rest = start_of(x0, "x0"), arguments_of(args)
    n, kind, own_bounds = start.size, Differences.wanted(jac, differences), bounds_of(bounds, start.size)
    rows, chosen = Rows(constraints, n), options_of(options, "obc_projected_gradient_options", _WORDS)
    f: Any = lambda x: (fun(x, *rest), jac(x, *rest))  # noqa: E731
    if kind is not None:
        f = Differences(lambda x: fun(x, *rest), kind, own_bounds, n, finite_diff_rel_step)
        chosen.setdefault("gradient_tolerance", f.tolerance)
        if "max_evaluations" in chosen:  # of fun, as SciPy counts them
            chosen["max_evaluations"] = max(1, chosen["max_evaluations"] // (1 + n * (1 + f.central)))
    solver = Solver(rows.start(start), **rows.bounds(own_bounds), **rows.equations, **chosen)
    solver._asked_name = "fun" if kind is not None else "fun, jac"

    def show(result: Result) -> Any:
        found = outcome(result)
        found.update(x=result.x[:n], njev=result.nfev, nfev=result.nfev if kind is None else f.evaluations)
        return found

    return minimized(solver, rows.widened(f), callback, disp, show=show)


class Projection:
    """The nearest point `x`, the `multipliers` of the rows, the text `stop` and the figures in `report`."""

    def __init__(self, x: Doubles, multipliers: Doubles, report: Any) -> None:
        self.x, self.multipliers, self.report = x, multipliers, report
        self.stop = text(raw.obc_projected_gradient_stop_name(report.stop)) or ""


@public
def project(y: ArrayLike, *, lower: Optional[ArrayLike] = None, upper: Optional[ArrayLike] = None, A: Any = None,
            b: Optional[ArrayLike] = None, progress: Progress = None) -> Projection:
    """The point of the feasible set that is nearest to y."""
    point = start_of(y, "y")
    problem = _Problem(point.size, lower, upper, A, b, None)
    x, multipliers = np.empty(point.size), np.empty(problem.struct.m)
    report = sized(raw.obc_projected_gradient_result)
    call(raw.obc_projected_gradient_project, byref(problem.struct), address(point), address(x), address(multipliers),
         byref(report), HOST, progress=progress)
    return Projection(x, multipliers, report)


class GradientCheck:
    """Whether every entry of a gradient `agrees` with differences; `worst`, the entry with the largest error, as it was `told` and
    by `difference`, the relative `error` of it, and all figures in `report`."""

    def __init__(self, report: Any) -> None:
        self.report, self.agrees, self.worst = report, bool(report.agrees), int(report.worst)
        self.told, self.difference, self.error = float(report.told), float(report.difference), float(report.error)

    def __repr__(self) -> str:
        return (f"GradientCheck(agrees={self.agrees}, worst={self.worst}, told={self.told!r}, "
                f"difference={self.difference!r}, error={self.error:.2g})")


@public
def check_gradient(f: Callable[[Doubles], tuple[float, ArrayLike]], x0: ArrayLike, *, lower: Optional[ArrayLike] = None,
                   upper: Optional[ArrayLike] = None, progress: Progress = None) -> GradientCheck:
    """Compares the gradient that f returns at x0 with differences of its values, within the bounds: what to look at when a run
    ends as "stalled"."""
    point = start_of(x0, "x0")
    problem = _Problem(point.size, lower, upper, None, None, None)
    raised: list[BaseException] = []

    def called(at: int, n: int, value: int, gradient: int, _: Any) -> int:
        try:
            answer = f(memory_of(at, n).copy())
            explain_pair(answer, point.shape, "f")
            put(memory_of(gradient, n), answer[1], "gradient")
            memory_of(value, 1)[0] = answer[0]
            return 0
        except EvaluationFailed:
            return raw.OBC_PROJECTED_GRADIENT_FAILED
        except BaseException as error:  # noqa: BLE001: an exception cannot pass through C
            raised.append(error)
            return raw.OBC_PROJECTED_GRADIENT_STOP

    report = sized(raw.obc_projected_gradient_check)
    try:
        call(raw.obc_projected_gradient_check_gradient, byref(problem.struct), raw.obc_projected_gradient_function(called), None,
             address(point), byref(report), HOST, progress=progress)
    except Cancelled:
        if not raised:
            raise
    if raised:
        raise raised[0]
    return GradientCheck(report)


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_projected_gradient_version()
