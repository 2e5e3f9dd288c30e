"""Minimises f over products of unit spheres: directions, quaternions, unit eigenvectors.

    result = minimize(f_and_gradient, x0)        # x0: a row a sphere; all at once, with the gradient
    result = relax(part, x0, neighbours)         # block by block, with the part of f that contains one
    relaxation = Relaxation(x0, neighbours)      # the same in parts: relaxation.run(part, steps)

Options are the members of `obc_sphere_optimizer_options` and `obc_sphere_optimizer_relaxation_options`; docs/sphere_optimizer.md
of the library tells what they do.
"""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import Any, Callable, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, address, indices, memory_of, put
from ._call import HOST, Handle, Progress, Stop, call, call_init, filled, sized, text
from ._solver import EvaluationFailed, GradientRun, Result
from .raw import sphere_optimizer as raw

__all__ = ["EvaluationFailed", "Relaxation", "Relaxed", "Result", "Solver", "Stop", "minimize", "relax", "version"]


def _points(x0: ArrayLike) -> Doubles:
    array = np.array(x0, dtype=np.float64, order="C")
    if array.ndim != 2:
        raise ValueError(f"x0: a row a sphere is needed, not shape {array.shape}")
    return array


class Solver(GradientRun):
    """A run by questions and answers; x0, the points asked about and gradients have a row a sphere."""

    def __init__(self, x0: ArrayLike, *, _load: Optional[bytes] = None, **options: Any) -> None:
        handle = ctypes.c_void_p()
        if _load is None:
            start = _points(x0)
            shape = start.shape
            chosen = filled(raw.obc_sphere_optimizer_options, raw.obc_sphere_optimizer_options_init, options, raw,
                            "OBC_SPHERE_OPTIMIZER_")
            call(raw.obc_sphere_optimizer_create, start.shape[0], start.shape[1], byref(chosen), address(start), None,
                 byref(handle))
        else:
            call(raw.obc_sphere_optimizer_load, _load, len(_load), None, byref(handle))
            count, dimension = ctypes.c_size_t(), ctypes.c_size_t()
            call(raw.obc_sphere_optimizer_get_shape, handle, byref(count), byref(dimension))
            shape = (count.value, dimension.value)
        super().__init__(raw, "obc_sphere_optimizer", handle.value or 0, shape)

    @classmethod
    def load(cls, blob: bytes) -> Solver:
        """Goes on with a run that was saved."""
        return cls((), _load=blob)


def minimize(f: Callable[[Doubles], tuple[float, ArrayLike]], x0: ArrayLike, *, progress: Progress = None,
             **options: Any) -> Result:
    """The least value of f that is found from x0, a row a sphere; f answers (value, gradient)."""
    return Solver(x0, **options).run(f, progress)


class Relaxed:
    """The points `x`, why it `stop`ped (text), and all figures in `report`."""

    def __init__(self, x: Doubles, report: Any) -> None:
        self.x, self.report = x, report
        self.stop = text(raw.obc_sphere_optimizer_stop_name(report.stop)) or ""


class _Part:
    """The callback of a relaxation: arrays are made once for each place in memory that is seen."""

    def __init__(self, f: Any, shape: tuple[int, int]) -> None:
        self.f, self.shape, self.dimension = f, shape, shape[1]
        self.raised: list[BaseException] = []
        self.arrays: dict[Any, Any] = {}
        self.function = raw.obc_sphere_optimizer_block_function(self.asked)

    def array(self, where: int, shape: tuple[int, ...], writeable: bool) -> Any:
        key = (where, shape, writeable)
        found = self.arrays.get(key)
        if found is None:
            found = memory_of(where, int(np.prod(shape))).reshape(shape)
            found.flags.writeable = writeable
            self.arrays[key] = found
        return found

    def asked(self, block: int, place: int, points: int, value: int, gradient: Optional[int], hessian: Optional[int],
              _: Any) -> int:
        try:
            d = self.dimension
            wanted = 2 if hessian else 1 if gradient else 0
            answer = self.f(block, self.array(place, (d,), False), self.array(points, self.shape, False), wanted)
            if isinstance(answer, tuple):
                if gradient:
                    put(self.array(gradient, (d,), True), answer[1], "gradient")
                if hessian:
                    put(self.array(hessian, (d, d), True), answer[2], "hessian")
                answer = answer[0]
            elif wanted:
                raise TypeError("derivatives are wanted: answer (value, gradient) or (value, gradient, hessian)")
            self.array(value, (1,), True)[0] = answer
            return 0
        except EvaluationFailed:
            return 2
        except Stop:
            return 1
        except BaseException as error:  # noqa: BLE001: an exception cannot pass through C
            self.raised.append(error)
            return 1


def _blocks(x: Doubles, neighbours: Sequence[Sequence[int]]) -> tuple[Any, list[Any]]:
    """obc_sphere_optimizer_blocks, and the arrays that it points at."""
    if len(neighbours) != len(x):
        raise ValueError(f"neighbours: {len(x)} rows are needed, not {len(neighbours)}")
    starts = np.zeros(len(x) + 1, dtype=np.uintp)
    starts[1:] = np.cumsum([len(row) for row in neighbours])
    flat = indices(np.concatenate([np.asarray(row, dtype=np.int64) for row in neighbours]) if len(x) else [],
                   name="neighbours")
    blocks = raw.obc_sphere_optimizer_blocks()
    call_init(raw.obc_sphere_optimizer_blocks_init, blocks)
    blocks.dimension, blocks.count = x.shape[1], x.shape[0]
    blocks.neighbour_start, blocks.neighbour = address(starts), address(flat)
    return blocks, [starts, flat]


def _relaxation_options(options: dict[str, Any]) -> Any:
    return filled(raw.obc_sphere_optimizer_relaxation_options, raw.obc_sphere_optimizer_relaxation_options_init, options,
                  raw, "OBC_SPHERE_OPTIMIZER_")


def relax(f: Callable[..., Any], x0: ArrayLike, neighbours: Sequence[Sequence[int]], *, progress: Progress = None,
          **options: Any) -> Relaxed:
    """Lowers f block by block. `f(block, place, points, derivatives)` answers the part of f that contains a block if it were
    at `place` and all others as in `points`: the value; with derivatives 1 (value, gradient); with 2, when `second_order=1`,
    (value, gradient, hessian). More is fine. The arrays are the solver's own and only valid in the call.
    neighbours[i]: the blocks whose part of f contains block i."""
    x = _points(x0)
    blocks, kept = _blocks(x, neighbours)
    chosen = _relaxation_options(options)
    part = _Part(f, (x.shape[0], x.shape[1]))
    report = sized(raw.obc_sphere_optimizer_relaxation_result)
    call(raw.obc_sphere_optimizer_relax, byref(blocks), byref(chosen), part.function, None, address(x), byref(report),
         HOST, progress=progress, raised=part.raised)
    del kept
    return Relaxed(x, report)


class Relaxation:
    """A relaxation in parts: `run` does so many more steps, `result` tells what is known, `save` and `load` go on elsewhere.
    Ends in the bits of `relax`."""

    def __init__(self, x0: ArrayLike, neighbours: Sequence[Sequence[int]], *, _load: Optional[bytes] = None,
                 **options: Any) -> None:
        x = _points(x0)
        self._shape = (x.shape[0], x.shape[1])
        blocks, kept = _blocks(x, neighbours)
        self._handle = Handle(raw.obc_sphere_optimizer_relaxation_destroy)
        if _load is None:
            chosen = _relaxation_options(options)
            call(raw.obc_sphere_optimizer_relaxation_create, byref(blocks), byref(chosen), address(x), None,
                 byref(self._handle))
        else:
            call(raw.obc_sphere_optimizer_relaxation_load, byref(blocks), _load, len(_load), None, byref(self._handle))
        del kept

    @classmethod
    def load(cls, blob: bytes, x0: ArrayLike, neighbours: Sequence[Sequence[int]]) -> Relaxation:
        """Goes on with a relaxation that was saved, of the same neighbours; of x0 only the shape counts."""
        return cls(x0, neighbours, _load=blob)

    def run(self, f: Callable[..., Any], steps: int) -> Relaxed:
        """At most so many more steps of one block each, with f as of `relax`. `stop` is "running" when there is more to do. What
        f raises comes out, and after `Stop` ("cancelled") too the next call goes on as if it had not been broken off."""
        if not 0 <= steps < 2**64:
            raise ValueError(f"steps={steps}: a number of steps is needed")
        part = _Part(f, self._shape)  # its arrays lie in memory that is only there while the call lasts
        call(raw.obc_sphere_optimizer_relaxation_run, self._handle, part.function, None, steps)
        if part.raised:
            raise part.raised[0]
        return self.result

    @property
    def result(self) -> Relaxed:
        """What is known now, at any time."""
        x = np.empty(self._shape)
        report = sized(raw.obc_sphere_optimizer_relaxation_result)
        call(raw.obc_sphere_optimizer_relaxation_get_result, self._handle, byref(report), address(x))
        return Relaxed(x, report)

    def save(self) -> bytes:
        """The relaxation as bytes, from which `load` goes on to the same bits."""
        size = raw.obc_sphere_optimizer_relaxation_save_size(self._handle)
        blob = ctypes.create_string_buffer(size)
        call(raw.obc_sphere_optimizer_relaxation_save, self._handle, blob, size)
        return blob.raw

    def close(self) -> None:
        """Releases it now, rather than when Python does."""
        self._handle.close()


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_sphere_optimizer_version()
