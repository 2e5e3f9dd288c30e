"""Minimises f(x), or a sum of squares of residuals, within bounds, from values alone: no derivatives.

    result = minimize(lambda x: (x[0] - 1) ** 2 + (x[1] + 2) ** 2, [0, 0], lower=[-1, -1])
    result = least_squares(residuals, [1, 0.1, 0], 8)

or, one evaluation at a time, by whatever program asks:

    solver = Solver([0, 0])
    while (x := solver.ask()) is not None:
        solver.tell(f(x))
    solver.result.x

Options are the members of `obc_trust_region_options`, docs/trust_region.md of the library tells what they do.
"""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, address, buffer, doubles, memory_of, put
from ._call import Progress, Stop, call, call_init, filled
from ._solver import DONE, EvaluationFailed, Result, Run
from .raw import trust_region as raw

__all__ = ["EvaluationFailed", "Result", "Solver", "Stop", "least_squares", "minimize", "version"]


def _problem(n: int, residuals: int, lower: Any, upper: Any, scale: Any, sign: Any) -> tuple[Any, list[Any]]:
    problem = raw.obc_trust_region_problem()
    call_init(raw.obc_trust_region_problem_init, problem)
    problem.n, problem.residuals = n, residuals
    kept = []
    for name, value, length in (("lower", lower, n), ("upper", upper, n), ("scale", scale, n), ("sign", sign, residuals)):
        if value is not None:
            array = doubles(np.broadcast_to(value, (length,)), name=name)
            kept.append(array)
            setattr(problem, name, address(array))
    return problem, kept


class Solver(Run):
    """A run by questions and answers. `residuals` is their number, 0 for one value f. Bounds and scale are a number for all
    unknowns, or one each; `sign`, 1 or -1 a residual, says how their squares are summed."""

    def __init__(self, x0: ArrayLike, residuals: int = 0, *, lower: Optional[ArrayLike] = None,
                 upper: Optional[ArrayLike] = None, scale: Optional[ArrayLike] = None, sign: Optional[ArrayLike] = None,
                 _load: Optional[bytes] = None, **options: Any) -> None:
        start = doubles(np.ravel(np.asarray(x0, dtype=np.float64)), name="x0")
        problem, kept = _problem(start.size, residuals, lower, upper, scale, sign)
        handle = ctypes.c_void_p()
        if _load is None:
            chosen = filled(raw.obc_trust_region_options, raw.obc_trust_region_options_init, options, raw,
                            "OBC_TRUST_REGION_")
            call(raw.obc_trust_region_create, byref(problem), byref(chosen), address(start), None, byref(handle))
        else:
            call(raw.obc_trust_region_load, byref(problem), _load, len(_load), None, byref(handle))
        del kept
        super().__init__(raw, "obc_trust_region", handle.value or 0, start.shape)
        self._count = ctypes.c_size_t()
        self._step_arguments += (byref(self._count),)
        self._outputs, where = buffer(np.float64, max(1, residuals))
        self._outputs_at = ctypes.c_void_p(where)

    @classmethod
    def load(cls, blob: bytes, x0: ArrayLike, residuals: int = 0, *, lower: Optional[ArrayLike] = None,
             upper: Optional[ArrayLike] = None, scale: Optional[ArrayLike] = None,
             sign: Optional[ArrayLike] = None) -> Solver:
        """Goes on with a run that was saved, of the same problem; of x0 only the length counts."""
        return cls(x0, residuals, lower=lower, upper=upper, scale=scale, sign=sign, _load=blob)

    def _result_arguments(self, x: Optional[int]) -> list[Any]:
        return [x, None]

    def ask_all(self) -> Optional[Doubles]:
        """All points that may be evaluated at the same time, as rows; tell of each in order. None: the run has ended."""
        if self._next() == DONE:
            return None
        count = self._count.value
        points: Doubles = memory_of(self._point.value or 0, count * self._size).reshape(count, self._size).copy()
        return points

    def tell(self, outputs: Any) -> None:
        """The value, or the residuals, at the first point asked for; None, NaN or infinity: there is none."""
        if outputs is None:
            call(self._tell, self._handle, None)
            return
        put(self._outputs, outputs, "outputs")
        if self._tell(self._handle, self._outputs_at, None):
            call(self._tell, self._handle, self._outputs_at)

    def _answer(self, answer: Any) -> None:
        self.tell(answer)

    def _failed(self) -> None:
        self.tell(None)

    def give(self, points: ArrayLike, outputs: ArrayLike) -> None:
        """Evaluations made before, rows of points with their outputs; before the first `ask`."""
        rows = doubles(points, self._size, name="points")
        values = doubles(np.asarray(outputs, dtype=np.float64).reshape(len(rows), self._outputs.size), name="outputs")
        call(raw.obc_trust_region_give, self._handle, address(rows), address(values), len(rows))

    @property
    def outputs(self) -> Doubles:
        """The value, or the residuals, at the best point so far."""
        outputs = np.empty(self._outputs.size)
        call(raw.obc_trust_region_get_result, self._handle, None, None, address(outputs))
        return outputs


def minimize(f: Callable[[Doubles], float], x0: ArrayLike, *, lower: Optional[ArrayLike] = None,
             upper: Optional[ArrayLike] = None, scale: Optional[ArrayLike] = None, progress: Progress = None,
             **options: Any) -> Result:
    """The least value of f that is found from x0."""
    return Solver(x0, lower=lower, upper=upper, scale=scale, **options).run(f, progress)


def least_squares(residuals: Callable[[Doubles], ArrayLike], x0: ArrayLike, count: int, *,
                  lower: Optional[ArrayLike] = None, upper: Optional[ArrayLike] = None,
                  scale: Optional[ArrayLike] = None, sign: Optional[ArrayLike] = None, progress: Progress = None,
                  **options: Any) -> Result:
    """The least sum of squares of `count` residuals, with signs if there are any, that is found from x0."""
    return Solver(x0, count, lower=lower, upper=upper, scale=scale, sign=sign, **options).run(residuals, progress)


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_trust_region_version()
