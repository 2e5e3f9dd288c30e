"""What the solvers have in common: a run is asked what it wants to know and is told it."""

from __future__ import annotations

import ctypes
import weakref
from ctypes import byref
from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, address, buffer, memory_of, put
from ._call import Progress, Stop, bar, call, sized, text

NEED, ITERATION, DONE = 1, 2, 3  # of every solver


class EvaluationFailed(Exception):
    """Raise it in a function that a solver calls where it has no value: the method goes on elsewhere."""


class Result:
    """How a run ended: the point `x`, the `value` there, why it `stop`ped (text), and all figures in `report`."""

    def __init__(self, x: Doubles, report: Any, stop: str) -> None:
        self.x, self.value, self.stop, self.report = x, float(report.value), stop, report

    @property
    def converged(self) -> bool:
        return self.stop == "converged"

    @property
    def evaluations(self) -> int:
        return int(self.report.evaluations)

    def __repr__(self) -> str:
        return f"Result(stop={self.stop!r}, value={self.value!r}, evaluations={self.evaluations}, x={self.x!r})"


class Run:
    """A handle of a solver, and the arrays that go in and out of it. Points have the given shape."""

    def __init__(self, raw: Any, prefix: str, handle: int, shape: tuple[int, ...]) -> None:
        self._raw, self._prefix, self._shape, self._size = raw, prefix, shape, int(np.prod(shape))
        self._handle: Optional[int] = handle
        self._finalizer = weakref.finalize(self, self._function("destroy"), handle)
        self._step = self._function("step")
        self._tell = self._function("tell")
        self._point = ctypes.c_void_p()
        self._point_out = byref(self._point)
        self._views: dict[Any, Any] = {}
        self.stopped = False

    def _function(self, name: str) -> Any:
        return getattr(self._raw, f"{self._prefix}_{name}")

    def _copied(self, where: int, shape: tuple[int, ...]) -> Doubles:
        """What the solver has there, copied: its memory changes with the next step."""
        seen = self._views.get((where, shape))
        if seen is None:
            seen = memory_of(where, int(np.prod(shape))).reshape(shape)
            self._views[(where, shape)] = seen
        return seen.copy()

    def _request(self) -> int:
        return self._step(self._handle, self._point_out)

    def _answer(self, answer: Any) -> None:
        """Tells what a function of the user has answered."""
        raise NotImplementedError

    def _failed(self) -> None:
        """Tells that there is no value."""
        raise NotImplementedError

    def ask(self) -> Optional[Doubles]:
        """The point that is asked about next; None when the run has ended."""
        return None if self._next() == DONE else self._copied(self._point.value or 0, self._shape)

    def run(self, f: Callable[[Doubles], Any], progress: Progress = None) -> Result:
        """Asks f, which answers what `tell` takes, until the run has ended."""
        report: Any = bar() if progress is True else progress or None
        try:
            while self._next(report) != DONE:
                try:
                    self._answer(f(self._copied(self._point.value or 0, self._shape)))
                except EvaluationFailed:
                    self._failed()
                except Stop:
                    self.stopped = True
                    break
        finally:
            if hasattr(report, "close"):
                report.close()
        return self.result

    def _next(self, progress: Any = None) -> int:
        """Goes on to the next question; with a progress function that answers something, as if done."""
        while True:
            request = self._request()
            if request == ITERATION:
                if progress is not None:
                    report = self._report()
                    if progress("minimize", int(report.evaluations), 0, float(report.value)):
                        self.stopped = True
                        return DONE
                continue
            if request < 0:
                raise RuntimeError(f"{self._prefix}_step answered {request}")
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
        self._finalizer()
        self._handle = None


class GradientRun(Run):
    """A run that asks for a value and the gradient."""

    def __init__(self, raw: Any, prefix: str, handle: int, shape: tuple[int, ...]) -> None:
        super().__init__(raw, prefix, handle, shape)
        flat, self._gradient_at = buffer(np.float64, self._size)
        self._gradient = flat.reshape(shape)

    def tell(self, value: Optional[float], gradient: Optional[ArrayLike]) -> None:
        """Value and gradient at the point asked about; None, NaN or infinity: there is none."""
        if value is None or gradient is None:
            call(self._tell, self._handle, float("nan"), None)
            return
        put(self._gradient, gradient, "gradient")
        status = self._tell(self._handle, value, self._gradient_at, None)
        if status:
            call(self._tell, self._handle, value, self._gradient_at)

    def _answer(self, answer: Any) -> None:
        self.tell(*answer)

    def _failed(self) -> None:
        self.tell(None, None)
