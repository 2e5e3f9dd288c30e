"""Minimizes f(x), or a sum of squares, a sum of magnitudes or the largest of residuals, within bounds, from values alone: no
derivatives.

    result = minimize(lambda x: (x[0] - 1) ** 2 + (x[1] + 2) ** 2, [0, 0], lower=[-1, -1])
    result = least_squares(residuals, [1, 0.1, 0], 8)
    result = minimize_residuals(residuals, [1, 0.1, 0], 8, "max-magnitude")    # a Chebyshev fit

or, one evaluation at a time, by any program:

    solver = Solver([0, 0])
    while (x := solver.ask()) is not None:
        solver.tell(f(x))
    solver.result.x

or by SciPy:

    scipy.optimize.minimize(f, [0, 0], method=scipy_method, bounds=[(-1, 1), (None, 0)], options={"maxfev": 200})
    scipy_least_squares(residuals, [1, 0.1, 0], bounds=([0, 0, -1], [10, 2, 1]))    # as scipy.optimize.least_squares

Options are the members of `obc_trust_region_options`, docs/trust_region.md of the library describes them.
"""

from __future__ import annotations

import ctypes
import warnings
from ctypes import byref
from typing import Any, Callable, Literal, Mapping, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, address, buffer, doubles, memory_of, numbers, put, spread, start_of
from ._call import Progress, Stop, call, call_init, filled, picked, with_options
from ._checks import integer, public, shown, word
from ._scipy import arguments_of, bounds_of, minimized, options_of, outcome
from ._solver import DONE, NO_VALUE, EvaluationFailed, Result, Run
from .raw import trust_region as raw

__all__ = ["EvaluationFailed", "Result", "Solver", "Stop", "least_squares", "minimize", "minimize_residuals", "scipy_least_squares",
           "scipy_method", "version"]

Objective = Literal["sum-of-squares", "sum-of-magnitudes", "max-magnitude", "max-value"]
_OBJECTIVES: tuple[str, ...] = ("sum-of-squares", "sum-of-magnitudes", "max-magnitude", "max-value")


def _problem(n: int, residuals: int, lower: Any, upper: Any, scale: Any, sign: Any, objective: Any) -> tuple[Any, list[Any]]:
    problem = raw.obc_trust_region_problem()
    call_init(raw.obc_trust_region_problem_init, problem)
    problem.n, problem.residuals = n, residuals
    problem.objective = _OBJECTIVES.index(word(objective, "objective", _OBJECTIVES))
    kept = []
    for name, value, length in (("lower", lower, n), ("upper", upper, n), ("scale", scale, n), ("sign", sign, residuals)):
        if value is not None:
            array = spread(value, length, name, finite_only=name in ("scale", "sign"))
            kept.append(array)
            setattr(problem, name, address(array))
            if name == "upper" and lower is not None and np.any(kept[0] > array):
                i = int(np.argmax(kept[0] > array))
                raise ValueError(f"lower[{i}] = {kept[0][i]} is above upper[{i}] = {array[i]}")
            if name == "scale" and np.any(array <= 0):
                raise ValueError(f"scale[{int(np.argmax(array <= 0))}] = {array.min()}: a number above 0 is needed")
            if name == "sign" and np.any(np.abs(array) != 1):
                raise ValueError(f"sign[{int(np.argmax(np.abs(array) != 1))}]: 1 or -1 is needed")
    return problem, kept


class Solver(Run):
    """A run by reverse communication. `residuals` is their number, 0 for one value f. Bounds and scale are a number for all
    unknowns, or one each; `sign`, 1 or -1 a residual, says how their squares are summed, and `objective` what else f may be of them."""

    @with_options("obc_trust_region_options")
    def __init__(self, x0: ArrayLike, residuals: int = 0, *, lower: Optional[ArrayLike] = None,
                 upper: Optional[ArrayLike] = None, scale: Optional[ArrayLike] = None, sign: Optional[ArrayLike] = None,
                 objective: Objective = "sum-of-squares",
                 # options of obc_trust_region_options, written by scripts/bindings.py
                 method: Literal["two-radii", "dissertation"] = "two-radii",
                 start: Literal["automatic", "chain", "cross"] = "automatic", points: int = 0, radius_begin: float = 0.0,
                 radius_end: float = 1e-08, target: float = float("-inf"), noise_absolute: float = 0.0,
                 noise_relative: float = 0.0, restarts: int = 0, max_evaluations: int = 0,
                 # end of options
                 ) -> None:
        chosen = filled(raw.obc_trust_region_options, raw.obc_trust_region_options_init, locals())
        first = start_of(x0, "x0")
        problem, kept = _problem(first.size, integer(residuals, "residuals", 0), lower, upper, scale, sign, objective)
        handle = ctypes.c_void_p()
        call(raw.obc_trust_region_create, byref(problem), byref(chosen), address(first), None, byref(handle))
        del kept
        self._begin(handle, first.size, residuals)

    def _begin(self, handle: ctypes.c_void_p, n: int, residuals: int) -> None:
        super().__init__(raw, "obc_trust_region", handle.value or 0, (n,))
        self._residuals, self._count = residuals, ctypes.c_size_t()
        self._step_arguments += (byref(self._count),)
        self._outputs, where = buffer(np.float64, max(1, residuals))
        self._outputs_at = ctypes.c_void_p(where)

    @classmethod
    @public
    def load(cls, blob: bytes, x0: ArrayLike, residuals: int = 0, *, lower: Optional[ArrayLike] = None,
             upper: Optional[ArrayLike] = None, scale: Optional[ArrayLike] = None,
             sign: Optional[ArrayLike] = None, objective: Objective = "sum-of-squares") -> Solver:
        """Goes on with a run that was saved, of the same problem; of x0 only the length counts."""
        n = np.size(numbers(x0, "x0"))
        problem, kept = _problem(n, integer(residuals, "residuals", 0), lower, upper, scale, sign, objective)
        handle = ctypes.c_void_p()
        call(raw.obc_trust_region_load, byref(problem), blob, len(blob), None, byref(handle))
        del kept
        solver = cls.__new__(cls)
        solver._begin(handle, n, residuals)
        return solver

    def _result_arguments(self, x: Optional[int]) -> list[Any]:
        return [x, None]

    def ask_all(self) -> Optional[Doubles]:
        """All points that may be evaluated at the same time, as rows; tell each in order. None: the run has ended."""
        if self._next() == DONE:
            return None
        count = self._count.value
        points: Doubles = memory_of(self._point.value or 0, count * self._size).reshape(count, self._size).copy()
        return points

    def tell(self, outputs: Any) -> None:
        """The value, or the residuals, at the first point requested; None, NaN or infinity: there is none."""
        if outputs is None:
            call(self._tell, self._handle, None)
            return
        self._told(outputs, "outputs")

    def _told(self, outputs: Any, name: str) -> None:
        put(self._outputs, outputs, name)
        if self._tell(self._handle, self._outputs_at, None):
            call(self._tell, self._handle, self._outputs_at)

    def _answer(self, answer: Any) -> None:
        if answer is None:
            what = f"return {self._residuals} numbers" if self._residuals else "return a number"
            raise TypeError(f"{self._asked_name} returned None: {what}, {NO_VALUE}")
        self._told(answer, f"what {self._asked_name} returned")

    def _failed(self) -> None:
        self.tell(None)

    @public
    def give(self, points: ArrayLike, outputs: ArrayLike) -> None:
        """Evaluations made before, rows of points with their outputs; before the first `ask`."""
        rows = doubles(points, self._size, name="points")
        values = numbers(outputs, "outputs")
        if values.size != len(rows) * self._outputs.size:
            raise ValueError(f"outputs: {self._outputs.size} for each of {len(rows)} points are needed, not shape {values.shape}")
        values = doubles(values.reshape(len(rows), self._outputs.size), name="outputs")
        call(raw.obc_trust_region_give, self._handle, address(rows), address(values), len(rows))

    @property
    def outputs(self) -> Doubles:
        """The value, or the residuals, at the best point so far."""
        outputs = np.empty(self._outputs.size)
        call(raw.obc_trust_region_get_result, self._handle, None, None, address(outputs))
        return outputs


@with_options("obc_trust_region_options")
def minimize(f: Callable[[Doubles], float], x0: ArrayLike, *, lower: Optional[ArrayLike] = None,
             upper: Optional[ArrayLike] = None, scale: Optional[ArrayLike] = None,
             # options of obc_trust_region_options, written by scripts/bindings.py
             method: Literal["two-radii", "dissertation"] = "two-radii",
             start: Literal["automatic", "chain", "cross"] = "automatic", points: int = 0, radius_begin: float = 0.0,
             radius_end: float = 1e-08, target: float = float("-inf"), noise_absolute: float = 0.0,
             noise_relative: float = 0.0, restarts: int = 0, max_evaluations: int = 0,
             # end of options
             progress: Progress = None) -> Result:
    """The minimum value of f that is found from x0."""
    options = picked(locals(), "obc_trust_region_options")
    return Solver(x0, lower=lower, upper=upper, scale=scale, **options).run(f, progress)


@with_options("obc_trust_region_options")
def least_squares(residuals: Callable[[Doubles], ArrayLike], x0: ArrayLike, count: int, *,
                  lower: Optional[ArrayLike] = None, upper: Optional[ArrayLike] = None,
                  scale: Optional[ArrayLike] = None, sign: Optional[ArrayLike] = None,
                  # options of obc_trust_region_options, written by scripts/bindings.py
                  method: Literal["two-radii", "dissertation"] = "two-radii",
                  start: Literal["automatic", "chain", "cross"] = "automatic", points: int = 0, radius_begin: float = 0.0,
                  radius_end: float = 1e-08, target: float = float("-inf"), noise_absolute: float = 0.0,
                  noise_relative: float = 0.0, restarts: int = 0, max_evaluations: int = 0,
                  # end of options
                  progress: Progress = None) -> Result:
    """The minimum sum of squares of `count` residuals, with signs if there are any, that is found from x0."""
    options = picked(locals(), "obc_trust_region_options")
    solver = Solver(x0, integer(count, "count", 1), lower=lower, upper=upper, scale=scale, sign=sign, **options)
    solver._asked_name = "residuals"
    return solver.run(residuals, progress)


@with_options("obc_trust_region_options")
def minimize_residuals(residuals: Callable[[Doubles], ArrayLike], x0: ArrayLike, count: int, objective: Objective, *,
                       lower: Optional[ArrayLike] = None, upper: Optional[ArrayLike] = None, scale: Optional[ArrayLike] = None,
                       # options of obc_trust_region_options, written by scripts/bindings.py
                       method: Literal["two-radii", "dissertation"] = "two-radii",
                       start: Literal["automatic", "chain", "cross"] = "automatic", points: int = 0,
                       radius_begin: float = 0.0, radius_end: float = 1e-08, target: float = float("-inf"),
                       noise_absolute: float = 0.0, noise_relative: float = 0.0, restarts: int = 0, max_evaluations: int = 0,
                       # end of options
                       progress: Progress = None) -> Result:
    """The minimum that is found from x0 of a function of `count` residuals: their sum of magnitudes, max_i |r_i| or max_i r_i."""
    options = picked(locals(), "obc_trust_region_options")
    solver = Solver(x0, integer(count, "count", 1), lower=lower, upper=upper, scale=scale, objective=objective,
                    **options)
    solver._asked_name = "residuals"
    return solver.run(residuals, progress)


_WORDS = {"maxfev": "max_evaluations", "maxfun": "max_evaluations", "tol": "radius_end", "rhobeg": "radius_begin", "rhoend": "radius_end",
          "initial_tr_radius": "radius_begin", "final_tr_radius": "radius_end", "f_target": "target"}


def scipy_method(fun: Callable[..., Any], x0: ArrayLike, args: tuple[Any, ...] = (), *, bounds: Any = None, callback: Any = None,
                 constraints: Any = (), jac: Any = None, hess: Any = None, hessp: Any = None, scale: Optional[ArrayLike] = None,
                 maxiter: Optional[int] = None, disp: bool = False, **options: Any) -> Any:
    """scipy.optimize.minimize(fun, x0, method=scipy_method): fun from its values alone within bounds. `tol` is radius_end, and
    `options` has those of `minimize` here, also as maxfev, maxfun, rhobeg, rhoend, initial_tr_radius, final_tr_radius and f_target, and
    `scale` and `maxiter`."""
    if constraints is not None and np.size(constraints):
        raise ValueError("constraints: this method has bounds only; projected_gradient.scipy_method has linear constraints")
    for name, value in (("jac", jac), ("hess", hess), ("hessp", hessp)):
        if value:
            warnings.warn(f"trust_region.scipy_method does not use derivatives ({name})", RuntimeWarning, stacklevel=3)
    start, rest = start_of(x0, "x0"), arguments_of(args)
    most = None if maxiter is None else integer(maxiter, "maxiter", 1)
    solver = Solver(start, scale=scale, **bounds_of(bounds, start.size), **options_of(options, "obc_trust_region_options", _WORDS))
    solver._asked_name = "fun"
    return minimized(solver, lambda x: fun(x, *rest), callback, disp, most)


def scipy_least_squares(fun: Callable[..., Any], x0: ArrayLike, jac: Any = None, bounds: Any = (-np.inf, np.inf), *,
                        xtol: Optional[float] = None, x_scale: Any = None, max_nfev: Optional[int] = None, args: tuple[Any, ...] = (),
                        kwargs: Optional[Mapping[str, Any]] = None, callback: Any = None, verbose: int = 0,
                        sign: Optional[ArrayLike] = None, maxiter: Optional[int] = None, **options: Any) -> Any:
    """scipy.optimize.least_squares(fun, x0, ...) without derivatives: fun returns residuals, as many as it does at x0. `bounds` is
    (lower, upper), a number for all unknowns or one each, or scipy.optimize.Bounds; `xtol` is radius_end, `max_nfev`
    max_evaluations, and further arguments are the options of `least_squares` here. The result has x, cost (half the sum of
    squares), fun (the residuals at x), active_mask, nfev, nit, success, status and message."""
    if callable(jac):
        warnings.warn("trust_region.scipy_least_squares does not use derivatives (jac)", RuntimeWarning, stacklevel=2)
    for name, unchanged in _WITHOUT_USE.items():
        value = options.pop(name, None)
        if value is not None and (type(value) is not type(unchanged) or value != unchanged):
            raise TypeError(f"{name}: this method has no use for it: squares are summed as they are, and xtol, max_nfev, maxiter, target "
                            "and noise_absolute end a run")
    if isinstance(x_scale, str):
        raise TypeError(f"x_scale: one number or one for each unknown is needed, not {x_scale!r}")
    pair = (bounds.lb, bounds.ub) if hasattr(bounds, "lb") and hasattr(bounds, "ub") else tuple(bounds)
    if len(pair) != 2:
        raise ValueError(f"bounds: (lower, upper) or scipy.optimize.Bounds is needed, not {shown(bounds)}")
    start, rest, named = start_of(x0, "x0"), arguments_of(args), dict(kwargs or {})
    lower, upper = (spread(side, start.size, f"bounds[{i}]") for i, side in enumerate(pair))
    words = {"max_nfev": "max_evaluations", "xtol": "radius_end", "tol": "radius_end"}
    chosen = options_of({"xtol": xtol, "max_nfev": max_nfev, **options}, "obc_trust_region_options", words)
    most = None if maxiter is None else integer(maxiter, "maxiter", 1)
    seen: dict[bytes, Any] = {}

    def residuals(x: Doubles) -> Any:
        key = x.tobytes()
        return seen.pop(key) if key in seen else np.ravel(numbers(fun(x, *rest, **named), "what fun returned"))

    first = np.clip(start, lower, upper)
    seen[first.tobytes()] = at_first = residuals(first)  # which says how many there are, and is not evaluated again
    if at_first.size == 0:
        raise ValueError("fun returned no numbers at x0: one residual at least is needed")
    solver = Solver(first, at_first.size, lower=lower, upper=upper, scale=x_scale, sign=sign, **chosen)
    solver._asked_name = "fun"

    def show(result: Result) -> Any:
        found = outcome(result)
        found.update(cost=0.5 * result.value, fun=solver.outputs,
                     active_mask=(result.x >= upper).astype(int) - (result.x <= lower).astype(int))
        return found

    return minimized(solver, residuals, callback, verbose, most, show)


# Arguments of scipy.optimize.least_squares without a meaning here, with the values that change nothing.
_WITHOUT_USE = {"loss": "linear", "f_scale": 1.0, "ftol": None, "gtol": None, "diff_step": None, "tr_solver": None, "tr_options": {},
                "jac_sparsity": None, "workers": None}


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_trust_region_version()
