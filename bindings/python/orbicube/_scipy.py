"""The words of scipy.optimize for the solvers: what its `minimize` passes to a function that is given as its method, and the
OptimizeResult that it expects.
"""

from __future__ import annotations

import importlib
import inspect
from typing import Any, Callable, Mapping, Optional

import numpy as np

from ._arrays import numbers
from ._checks import nearest, shown
from ._options import OPTIONS
from ._solver import Result, Run


def bounds_of(bounds: Any, n: int) -> dict[str, Any]:
    """`lower` and `upper` of scipy.optimize.Bounds, or of n pairs in which None stands for no bound."""
    if bounds is None:
        return {}
    if hasattr(bounds, "lb") and hasattr(bounds, "ub"):
        return {"lower": bounds.lb, "upper": bounds.ub}
    pairs = list(bounds)
    if len(pairs) != n or any(np.size(pair) != 2 for pair in pairs):
        raise ValueError(f"bounds: scipy.optimize.Bounds or {n} pairs are needed, one for each unknown, not {shown(bounds)}")
    return {"lower": [-np.inf if low is None else low for low, _ in pairs],
            "upper": [np.inf if high is None else high for _, high in pairs]}


class Rows:
    """What scipy.optimize.LinearConstraint objects say of n unknowns, as equations `A` and `b`: each row with two sides that differ
    gets a further unknown, its slack, which is the row's value and has the sides as its bounds."""

    def __init__(self, constraints: Any, n: int) -> None:
        self.n, self.low, self.high = n, np.empty(0), np.empty(0)  # of the slacks
        self.equations: dict[str, Any] = {}
        listed = [] if constraints is None else constraints if isinstance(constraints, (list, tuple)) else [constraints]
        blocks, lows, highs = [], [], []
        for i, constraint in enumerate(listed):
            if not all(hasattr(constraint, name) for name in ("A", "lb", "ub")):
                raise TypeError(f"constraints[{i}]: a scipy.optimize.LinearConstraint is needed, not {shown(constraint)}")
            A = constraint.A if hasattr(constraint.A, "tocsr") else np.atleast_2d(numbers(constraint.A, f"constraints[{i}].A"))
            low, high = (np.broadcast_to(np.asarray(side, float), (A.shape[0],)) for side in (constraint.lb, constraint.ub))
            if A.shape[1] != n:
                raise ValueError(f"constraints[{i}].A: {n} columns are needed, one for each unknown, not shape {A.shape}")
            for row in np.flatnonzero(~(low <= high)):
                raise ValueError(f"constraints[{i}]: lb[{row}] = {low[row]} is not below ub[{row}] = {high[row]}")
            blocks.append(A)
            lows.append(low)
            highs.append(high)
        if blocks:
            self._make_equations(blocks, np.concatenate(lows), np.concatenate(highs))

    def _make_equations(self, blocks: list[Any], low: Any, high: Any) -> None:
        slack = np.flatnonzero(low < high)
        self.low, self.high = low[slack], high[slack]
        b = np.where(low < high, 0.0, low)
        if not slack.size and not any(hasattr(block, "tocsr") for block in blocks):
            self.equations = {"A": np.vstack(blocks), "b": b}
            return
        sparse = importlib.import_module("scipy.sparse")
        columns = sparse.csr_matrix((-np.ones(slack.size), (slack, np.arange(slack.size))), shape=(b.size, slack.size))
        rows = sparse.vstack([sparse.csr_matrix(block) for block in blocks], format="csr")
        self.equations = {"A": sparse.hstack([rows, columns], format="csr"), "b": b}
        self._slack_rows = rows[slack]

    def start(self, x0: Any) -> Any:
        """The unknowns with the slacks, which are the values of their rows at x0."""
        return np.concatenate([x0, np.clip(self._slack_rows @ x0, self.low, self.high)]) if self.low.size else x0

    def bounds(self, given: Mapping[str, Any]) -> dict[str, Any]:
        """`lower` and `upper` of the unknowns with the slacks."""
        if not self.low.size:
            return dict(given)
        sides = {"lower": (-np.inf, self.low), "upper": (np.inf, self.high)}
        return {name: np.concatenate([np.broadcast_to(np.asarray(given.get(name, none), float), (self.n,)), side])
                for name, (none, side) in sides.items()}

    def widened(self, f: Callable[[Any], Any]) -> Callable[[Any], Any]:
        """f of the unknowns with the slacks, on which it does not depend: f returns (value, gradient)."""
        if not self.low.size:
            return f
        none = np.zeros(self.low.size)

        def wide(x: Any) -> Any:
            value, gradient = f(x[:self.n])
            return value, np.concatenate([np.ravel(gradient), none])

        return wide


# Steps and tolerances of differences: the rounding of f over the step, and what the formula neglects, are about as large.
_DIFFERENCES = {"2-point": (2.0 ** -26, 1e-5), "3-point": (2.0 ** -17, 1e-7)}


class Differences:
    """The gradient of fun by differences that stay within the bounds: forward or backward ones ("2-point"), or central ones where
    there is room on both sides ("3-point"). An entry whose bounds are equal is 0."""

    def __init__(self, fun: Callable[[Any], Any], kind: str, bounds: Mapping[str, Any], n: int, step: Any) -> None:
        self.fun, self.central, self.evaluations = fun, kind == "3-point", 0
        self.step = np.broadcast_to(_DIFFERENCES[kind][0] if step is None else np.abs(numbers(step, "finite_diff_rel_step")), (n,))
        self.lower = np.broadcast_to(np.asarray(bounds.get("lower", -np.inf), float), (n,))
        self.upper = np.broadcast_to(np.asarray(bounds.get("upper", np.inf), float), (n,))
        self.tolerance = _DIFFERENCES[kind][1]

    @staticmethod
    def wanted(jac: Any, kind: str) -> Optional[str]:
        """The kind of differences; None where `jac` is a function. SciPy's `minimize` passes None for names of differences."""
        if callable(jac):
            return None
        wanted = kind if jac is None or jac is False else jac
        if not isinstance(wanted, str) or wanted not in _DIFFERENCES:
            raise ValueError("jac: a function, True where fun returns (value, gradient), '2-point' or '3-point' is needed, "
                             f"not {shown(wanted)}")
        return wanted

    def value(self, x: Any) -> float:
        self.evaluations += 1
        return float(np.ravel(numbers(self.fun(x), "what fun returned"))[0])

    def __call__(self, x: Any) -> Any:
        value, gradient = self.value(x), np.zeros(x.size)
        for j in range(x.size if np.isfinite(value) else 0):
            length = self.step[j] * max(1.0, abs(x[j]))
            up, down = min(x[j] + length, self.upper[j]), max(x[j] - length, self.lower[j])
            if self.central and up > x[j] > down:
                gradient[j] = self._between(x, j, down, up)
            elif up > down:
                far = up if up - x[j] >= x[j] - down else down
                gradient[j] = (self._at(x, j, far) - value) / (far - x[j])
        return value, gradient

    def _at(self, x: Any, j: int, to: float) -> float:
        moved = x.copy()
        moved[j] = to
        return self.value(moved)

    def _between(self, x: Any, j: int, down: float, up: float) -> float:
        return (self._at(x, j, up) - self._at(x, j, down)) / (up - down)


def options_of(given: Mapping[str, Any], struct: str, other_words: Mapping[str, str]) -> dict[str, Any]:
    """The options of a struct by their own names or by SciPy's words for them. `tol`, which `minimize` has beside `options`, counts
    where no option says the same; two words for one option are refused."""
    allowed = [option.name for option in OPTIONS[struct]]
    chosen: dict[str, Any] = {}
    said: dict[str, str] = {}
    for name, value in given.items():
        own = other_words.get(name, name)
        if own not in allowed:
            words = [*allowed, *other_words]
            raise TypeError(f"options: there is no {name!r}{nearest(name, words) or '.'} There are: {', '.join(words)}")
        if value is None or (name == "tol" and own in chosen):
            continue
        if said.get(own, "tol") != "tol":
            raise TypeError(f"options: {said[own]} and {name} both say {own}; give one of them")
        chosen[own], said[own] = value, name
    return chosen


def arguments_of(args: Any) -> tuple[Any, ...]:
    """Further arguments of a function, of which a single one need not be in a tuple."""
    return args if isinstance(args, tuple) else (args,)


def outcome(result: Result) -> Any:
    """scipy.optimize.OptimizeResult of a run, which has ended or goes on."""
    found = importlib.import_module("scipy.optimize").OptimizeResult()
    found.update(x=result.x, fun=result.fun, nfev=result.nfev, nit=result.nit, success=result.success, status=result.status,
                 message=result.message, report=result.report)
    return found


class Follower:
    """A progress function that calls back after each iteration as SciPy does: with the best point, or with what `show` makes of the
    result if the only parameter is named intermediate_result. StopIteration, or True as the return value, ends the run, and
    so does the iteration of number `most`."""

    def __init__(self, run: Run, callback: Optional[Callable[..., Any]], most: Optional[int], show: Callable[[Result], Any]) -> None:
        if callback is not None and not callable(callback):
            raise TypeError(f"callback: a function is needed, not {shown(callback)}")
        self.run, self.callback, self.most, self.show = run, callback, most, show
        self.done, self.spent = 0, False
        try:
            self.whole = callback is not None and list(inspect.signature(callback).parameters) == ["intermediate_result"]
        except (TypeError, ValueError):  # a function of C, which tells no names
            self.whole = False

    def __call__(self, *_: Any) -> bool:
        self.done += 1
        if self.callback is not None:
            result = self.run.result
            try:
                if (self.callback(intermediate_result=self.show(result)) if self.whole else self.callback(self.show(result).x)) is True:
                    return True
            except StopIteration:
                return True
        self.spent = self.most is not None and self.done >= self.most
        return self.spent


def minimized(run: Run, f: Callable[[Any], Any], callback: Any, disp: Any, most: Optional[int] = None,
              show: Callable[[Result], Any] = outcome) -> Any:
    """Runs a solver to its end, which is also that of `most` iterations."""
    follower = Follower(run, callback, most, show) if callback is not None or most is not None else None
    result = run.run(f, follower)
    found = show(result)
    if follower is not None and follower.spent:
        found.message = "iteration budget"
    if disp:
        print(f"{found.message}: {result.fun!r} after {found.nfev} evaluations")
    return found
