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


def rows_of(constraints: Any, n: int) -> dict[str, Any]:
    """`A` and `b` of scipy.optimize.LinearConstraint objects, all of whose rows must be equations."""
    listed = [] if constraints is None else constraints if isinstance(constraints, (list, tuple)) else [constraints]
    blocks, sides = [], []
    for i, constraint in enumerate(listed):
        if not all(hasattr(constraint, name) for name in ("A", "lb", "ub")):
            raise TypeError(f"constraints[{i}]: a scipy.optimize.LinearConstraint is needed, not {shown(constraint)}")
        sparse = hasattr(constraint.A, "tocsr")
        A = constraint.A if sparse else np.atleast_2d(numbers(constraint.A, f"constraints[{i}].A"))
        low, high = (np.broadcast_to(np.asarray(side, float), (A.shape[0],)) for side in (constraint.lb, constraint.ub))
        if A.shape[1] != n:
            raise ValueError(f"constraints[{i}].A: {n} columns are needed, one for each unknown, not shape {A.shape}")
        if np.any(low != high):
            row = int(np.argmax(low != high))
            raise ValueError(f"constraints[{i}]: lb[{row}] = {low[row]} and ub[{row}] = {high[row]} differ; rows must be equations: "
                             "give an inequality an unknown more, its slack, with bounds")
        blocks.append(A)
        sides.append(low)
    if not blocks:
        return {}
    any_sparse = any(hasattr(block, "tocsr") for block in blocks)
    A = importlib.import_module("scipy.sparse").vstack(blocks, format="csr") if any_sparse else np.vstack(blocks)
    return {"A": A, "b": np.concatenate(sides)}


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


def outcome(result: Result, gradients: bool = False) -> Any:
    """scipy.optimize.OptimizeResult of a run, which has ended or goes on."""
    found = importlib.import_module("scipy.optimize").OptimizeResult()
    found.update(x=result.x, fun=result.fun, nfev=result.nfev, nit=result.nit, success=result.success, status=result.status,
                 message=result.message, report=result.report)
    if gradients:
        found.njev = result.nfev
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
                if (self.callback(intermediate_result=self.show(result)) if self.whole else self.callback(result.x)) is True:
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
        print(f"{found.message}: {result.fun!r} after {result.nfev} evaluations")
    return found
