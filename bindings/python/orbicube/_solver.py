"""What the solvers have in common: reverse communication, callbacks, saved runs."""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, address, buffer, memory_of, numbers, put
from ._call import Handle, Progress, Stop, bar, call, sized, text
from ._checks import kind_of, public

NEED, ITERATION, DONE = 1, 2, 3  # of every solver


class EvaluationFailed(Exception):
    """Raise it in a function that a solver calls where it has no value: the method goes on elsewhere."""


class Result:
    """How a run ended: the point `x`, the `value` there, why it `stop`ped (text), and all figures in `report`; also by the words of
    scipy.optimize: `fun`, `nfev`, `nit`, `success`, `status`, `message`."""

    def __init__(self, x: Doubles, report: Any, stop: str) -> None:
        self.x, self.value, self.stop, self.report = x, float(report.value), stop, report

    @property
    def converged(self) -> bool:
        return self.stop == "converged"

    @property
    def evaluations(self) -> int:
        return int(self.report.evaluations)

    @property
    def fun(self) -> float:
        return self.value

    @property
    def nfev(self) -> int:
        return self.evaluations

    @property
    def nit(self) -> int:
        return int(self.report.iterations)

    @property
    def success(self) -> bool:
        return self.stop in ("converged", "target reached", "noise limit")

    @property
    def status(self) -> int:
        return int(self.report.stop)

    @property
    def message(self) -> str:
        return self.stop

    def __repr__(self) -> str:
        return f"Result(stop={self.stop!r}, value={self.value!r}, evaluations={self.evaluations}, x={self.x!r})"


class Run:
    """A handle of a solver, and the arrays that go in and out of it. Points have the given shape.

    What is done for each evaluation is kept short: arguments are made once, and so is an array for each place in the
    solver's memory that it shows points at. These arrays never leave the object, which gives out copies: what they show
    changes with the next step and is gone with the handle."""

    def __init__(self, raw: Any, prefix: str, handle: int, shape: tuple[int, ...]) -> None:
        self._raw, self._prefix, self._shape, self._size = raw, prefix, shape, int(np.prod(shape))
        self._handle = Handle(self._function("destroy"), handle)
        self._step = self._function("step")
        self._tell = self._function("tell")
        self._point = ctypes.c_void_p()
        self._step_arguments: tuple[Any, ...] = (self._handle, byref(self._point))
        self._points: dict[Optional[int], Doubles] = {}
        self._check: Optional[Callable[[], None]] = None  # raises what a callback of a step has left
        self._asked_name = "f"  # the name of the callback as the user gave it
        self.stopped = False

    def _function(self, name: str) -> Any:
        return getattr(self._raw, f"{self._prefix}_{name}")

    def _asked(self) -> Doubles:
        """The point queried, copied."""
        where = self._point.value
        seen = self._points.get(where)
        if seen is None:
            seen = memory_of(where or 0, self._size).reshape(self._shape)
            self._points[where] = seen
        return seen.copy()

    def _answer(self, answer: Any) -> None:
        """Supplies the return value of a callback."""
        raise NotImplementedError

    def _failed(self) -> None:
        """Reports an undefined value."""
        raise NotImplementedError

    def _last(self, *answer: Any) -> None:
        """Supplies the value of a Stop."""
        self._answer(answer[0] if len(answer) == 1 else answer)

    def ask(self) -> Optional[Doubles]:
        """The point that is queried next; None when the run has ended."""
        return None if self._next() == DONE else self._asked()

    @public
    def run(self, f: Callable[[Doubles], Any], progress: Progress = None) -> Result:
        """Calls f, which returns the arguments of `tell`, until the run has ended."""
        report: Any = bar() if progress is True else progress or None
        try:
            while self._next(report) != DONE:
                try:
                    self._answer(f(self._asked()))
                except EvaluationFailed:
                    self._failed()
                except Stop as stop:
                    self.stopped = True
                    if stop.args:
                        self._last(*stop.args)
                    break
        finally:
            if hasattr(report, "close"):
                report.close()
        return self.result

    def _next(self, progress: Any = None) -> int:
        """Goes on to the next question; with a progress function that returns something, as if done."""
        while True:
            with self._handle:  # a method's callback may run in it
                request: int = self._step(*self._step_arguments)
            if self._check is not None:
                self._check()
            if request == ITERATION:
                if progress is not None:
                    report = self._report()
                    if progress("minimize", int(report.evaluations), 0, float(report.value)):
                        self.stopped = True
                        return DONE
                continue
            if request < 0:
                raise RuntimeError(f"{self._prefix}_step returned {request}")
            return request

    def _result_arguments(self, x: Optional[int]) -> list[Any]:
        return [x]

    def _report(self) -> Any:
        report = sized(getattr(self._raw, self._prefix + "_result"))
        call(self._function("get_result"), self._handle, byref(report), *self._result_arguments(None))
        return report

    @property
    def result(self) -> Result:
        """What is known now, at any time."""
        x = np.empty(self._shape)
        report = sized(getattr(self._raw, self._prefix + "_result"))
        call(self._function("get_result"), self._handle, byref(report), *self._result_arguments(address(x)))
        if self.stopped:
            report.stop = getattr(self._raw, self._prefix.upper() + "_CANCELLED")
        stop = text(self._function("stop_name")(report.stop)) or ""
        return Result(x, report, stop)

    def save(self) -> bytes:
        """The run as bytes, from which `load` goes on to the same bits."""
        size = self._function("save_size")(self._handle)
        blob = ctypes.create_string_buffer(size)
        call(self._function("save"), self._handle, blob, size)
        return blob.raw

    def close(self) -> None:
        """Releases the run now, rather than when Python does."""
        self._handle.close()
        self._points.clear()


def real_or_nan(value: Any, name: str) -> float:
    """A number, also of numpy or an array of one; NaN says that there is none."""
    array = numbers(value, name)
    if array.size != 1:
        raise ValueError(f"{name}: one number is needed, not shape {array.shape}")
    return float(array.reshape(()))


NO_VALUE = "or raise orbicube.EvaluationFailed where there is none"


def explain_pair(answer: Any, shape: tuple[int, ...], name: str) -> None:
    """Raises what is wrong with what a function returned in the place of (value, gradient)."""
    pair = f"return (value, gradient), {NO_VALUE}"
    if answer is None:
        raise TypeError(f"{name} returned None: {pair}")
    if not isinstance(answer, (tuple, list)) and (not isinstance(answer, np.ndarray) or answer.ndim == 0):
        raise TypeError(f"{name} returned {kind_of(answer)}: {pair}")
    if len(answer) != 2:
        raise ValueError(f"{name} returned {len(answer)} values: {pair}")
    for part, title in zip(answer, ("value", "gradient")):
        if part is None:
            raise TypeError(f"{name} returned None as the {title}: {pair}")
    real_or_nan(answer[0], f"the value that {name} returned")
    put(np.empty(shape), answer[1], f"the gradient that {name} returned")


class GradientRun(Run):
    """A run that requires a value and the gradient."""

    def __init__(self, raw: Any, prefix: str, handle: int, shape: tuple[int, ...]) -> None:
        super().__init__(raw, prefix, handle, shape)
        flat, where = buffer(np.float64, self._size)
        self._gradient_at = ctypes.c_void_p(where)
        self._gradient = flat.reshape(shape)

    def tell(self, value: Optional[float], gradient: Optional[ArrayLike]) -> None:
        """Value and gradient at the point queried; None, NaN or infinity: there is none."""
        if value is None or gradient is None:
            call(self._tell, self._handle, float("nan"), None)
            return
        put(self._gradient, gradient, "gradient")
        if not isinstance(value, float):  # of numpy too
            value = real_or_nan(value, "value")
        if self._tell(self._handle, value, self._gradient_at, None):
            call(self._tell, self._handle, value, self._gradient_at)

    def _answer(self, answer: Any) -> None:
        try:
            value, gradient = answer
            if value is not None and gradient is not None:
                self.tell(value, gradient)
                return
        except (TypeError, ValueError, ctypes.ArgumentError):
            explain_pair(answer, self._gradient.shape, self._asked_name)
            raise
        explain_pair(answer, self._gradient.shape, self._asked_name)

    def _failed(self) -> None:
        self.tell(None, None)

    def _last(self, *answer: Any) -> None:
        """The value alone is used, and the gradient may be missing."""
        pair = answer[0] if len(answer) == 1 and isinstance(answer[0], (tuple, list)) else answer
        self._answer(pair if len(pair) > 1 else (pair[0], np.zeros(self._shape)))
