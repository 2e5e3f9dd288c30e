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
    """The options of a struct by their own names or by SciPy's words for them."""
    allowed = [option.name for option in OPTIONS[struct]]
    chosen: dict[str, Any] = {}
    for name, value in given.items():
        own = other_words.get(name, name)
        if own not in allowed:
            words = [*allowed, *other_words]
            raise TypeError(f"options: there is no {name!r}{nearest(name, words) or '.'} There are: {', '.join(words)}")
        if value is not None:
            chosen[own] = value
    return chosen


def outcome(result: Result) -> Any:
    """scipy.optimize.OptimizeResult of a run that has ended."""
    found = importlib.import_module("scipy.optimize").OptimizeResult()
    found.update(x=result.x, fun=result.fun, nfev=result.nfev, nit=result.nit, success=result.success, status=int(result.report.stop),
                 message=result.message, report=result.report)
    return found


def follow(run: Run, callback: Optional[Callable[..., Any]]) -> Optional[Callable[[str, int, int, float], bool]]:
    """A progress function that calls back after each iteration as SciPy does: with the best point, or with an OptimizeResult if
    the only parameter is named intermediate_result. StopIteration, or True as the return value, ends the run."""
    if callback is None:
        return None
    told: Callable[..., Any] = callback
    try:
        whole = list(inspect.signature(told).parameters) == ["intermediate_result"]
    except (TypeError, ValueError):  # a function of C, which tells no names
        whole = False

    def report(*_: Any) -> bool:
        try:
            result = run.result
            return (told(intermediate_result=outcome(result)) if whole else told(result.x)) is True
        except StopIteration:
            return True

    return report


def minimized(run: Run, f: Callable[[Any], Any], callback: Any, disp: Any) -> Any:
    """Runs a solver to its end."""
    result = run.run(f, follow(run, callback))
    if disp:
        print(f"{result.message}: {result.fun!r} after {result.nfev} evaluations")
    return outcome(result)
