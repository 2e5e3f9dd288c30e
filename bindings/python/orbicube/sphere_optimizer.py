"""Minimizes f over products of unit spheres: directions, quaternions, unit eigenvectors.

    result = minimize(f_and_gradient, x0)        # x0: a row a sphere; all at once, with the gradient
    result = relax(part, x0, neighbors)         # block by block, with the part of f that contains one
    relaxation = Relaxation(x0, neighbors)      # the same in parts: relaxation.run(part, steps)

Options are the members of `obc_sphere_optimizer_options` and `obc_sphere_optimizer_relaxation_options`; docs/sphere_optimizer.md
of the library describes them.
"""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import Any, Callable, Literal, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, address, doubles, indices, memory_of, put
from ._call import HOST, Handle, Progress, Stop, call, call_init, filled, picked, sized, text, with_options
from ._checks import integer, kind_of, public
from ._solver import NO_VALUE, EvaluationFailed, GradientRun, Result, real_or_nan
from .raw import sphere_optimizer as raw

__all__ = ["EvaluationFailed", "Relaxation", "Relaxed", "Result", "Solver", "Stop", "minimize", "relax", "version"]


def _points(x0: ArrayLike) -> Doubles:
    array = doubles(x0, name="x0")
    if array.ndim != 2 or array.size == 0:
        raise ValueError(f"x0: a row for each sphere is needed, not shape {array.shape}")
    for i in np.flatnonzero(~array.any(axis=1))[:1]:
        raise ValueError(f"x0[{i}] is zero: a direction is needed")
    return array.copy()


class _Product:
    """What a callback for products returned."""

    def __init__(self, value: Any) -> None:
        if value is None:
            raise TypeError(f"hessian_product returned None: return the product, {NO_VALUE}")
        self.value = value


class Solver(GradientRun):
    """A run by reverse communication; x0, the points queried and gradients have a row a sphere."""

    @with_options("obc_sphere_optimizer_options")
    def __init__(self, x0: ArrayLike, *,
                 # options of obc_sphere_optimizer_options, written by scripts/bindings.py
                 method: Literal["limited-memory", "barzilai-borwein", "great-circle", "dissertation", "truncated-newton"] = "limited-memory",
                 memory: int = 16, history: int = 10, gradient_tolerance: float = 1e-08, target: float = float("-inf"),
                 max_evaluations: int = 100000, max_iterations: int = 100000, starts: int = 1, seed: int = 0,
                 hessian_products: bool = False,
                 # end of options
                 ) -> None:
        chosen = filled(raw.obc_sphere_optimizer_options, raw.obc_sphere_optimizer_options_init, locals())
        start, handle = _points(x0), ctypes.c_void_p()
        call(raw.obc_sphere_optimizer_create, start.shape[0], start.shape[1], byref(chosen), address(start), None, byref(handle))
        super().__init__(raw, "obc_sphere_optimizer", handle.value or 0, start.shape)

    @property
    def direction(self) -> Optional[Doubles]:
        """With `hessian_products`, the vector whose product with the Hessian at the point queried is to be told; None: value and
        gradient are."""
        where = ctypes.c_void_p()
        if raw.obc_sphere_optimizer_get_direction(self._handle, byref(where), None):
            return None
        direction: Doubles = memory_of(where.value or 0, self._size).reshape(self._shape).copy()
        return direction

    def tell_product(self, product: Optional[ArrayLike]) -> None:
        """The product of the Hessian and `direction`; None: there is none."""
        if product is None:
            call(raw.obc_sphere_optimizer_tell_product, self._handle, None)
            return
        put(self._gradient, product, "product")
        call(raw.obc_sphere_optimizer_tell_product, self._handle, self._gradient_at)

    @public
    def run(self, f: Callable[[Doubles], Any], progress: Progress = None,
            hessian_product: Optional[Callable[[Doubles, Doubles], ArrayLike]] = None) -> Result:
        """Calls f, which returns (value, gradient), and with `hessian_products` hessian_product(x, direction), until the run has ended."""
        if hessian_product is None:
            return super().run(f, progress)
        product: Callable[[Doubles, Doubles], ArrayLike] = hessian_product

        def reply(x: Doubles) -> Any:
            direction = self.direction
            return f(x) if direction is None else _Product(product(x, direction))
        return super().run(reply, progress)

    def _answer(self, answer: Any) -> None:
        if isinstance(answer, _Product):
            self.tell_product(answer.value)
        else:
            super()._answer(answer)

    def _failed(self) -> None:
        if self.direction is None:
            super()._failed()
        else:
            self.tell_product(None)

    def _last(self, *answer: Any) -> None:
        if self.direction is None:  # the value of f, not of a product
            super()._last(*answer)

    @classmethod
    @public
    def load(cls, blob: bytes) -> Solver:
        """Goes on with a run that was saved."""
        handle, count, dimension = ctypes.c_void_p(), ctypes.c_size_t(), ctypes.c_size_t()
        call(raw.obc_sphere_optimizer_load, blob, len(blob), None, byref(handle))
        call(raw.obc_sphere_optimizer_get_shape, handle, byref(count), byref(dimension))
        solver = cls.__new__(cls)
        GradientRun.__init__(solver, raw, "obc_sphere_optimizer", handle.value or 0, (count.value, dimension.value))
        return solver


@with_options("obc_sphere_optimizer_options")
def minimize(f: Callable[[Doubles], tuple[float, ArrayLike]], x0: ArrayLike, *,
             # options of obc_sphere_optimizer_options, written by scripts/bindings.py
             method: Literal["limited-memory", "barzilai-borwein", "great-circle", "dissertation", "truncated-newton"] = "limited-memory",
             memory: int = 16, history: int = 10, gradient_tolerance: float = 1e-08, target: float = float("-inf"),
             max_evaluations: int = 100000, max_iterations: int = 100000, starts: int = 1, seed: int = 0,
             hessian_products: bool = False,
             # end of options
             hessian_product: Optional[Callable[[Doubles, Doubles], ArrayLike]] = None, progress: Progress = None) -> Result:
    """The minimum value of f that is found from x0, a row a sphere; f returns (value, gradient).

    hessian_product(x, direction) returns the product of the Hessian of f at x, as a function of all numbers of x, and a direction of
    the same shape; the method is then "truncated-newton"."""
    options = picked(locals(), "obc_sphere_optimizer_options")
    if hessian_product is not None:
        if method not in ("limited-memory", "truncated-newton"):
            raise ValueError(f"hessian_product: method {method!r} takes none")
        options.update(method="truncated-newton", hessian_products=True)
    return Solver(x0, **options).run(f, progress, hessian_product)


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
            if isinstance(answer, tuple) and len(answer) > wanted:
                if gradient:
                    put(self.array(gradient, (d,), True), answer[1], "the gradient that f returned")
                if hessian:
                    put(self.array(hessian, (d, d), True), answer[2], "the hessian that f returned")
                answer = answer[0]
            elif wanted or answer is None:
                what = ("a number", "(value, gradient)", "(value, gradient, hessian)")[wanted]
                raise TypeError(f"f returned {kind_of(answer)}: return {what}, {NO_VALUE}")
            self.array(value, (1,), True)[0] = answer if isinstance(answer, float) else real_or_nan(answer, "the value that f returned")
            return 0
        except EvaluationFailed:
            return 2
        except Stop:
            return 1
        except BaseException as error:  # noqa: BLE001: an exception cannot pass through C
            self.raised.append(error)
            return 1


def _blocks(x: Doubles, neighbors: Sequence[Sequence[int]]) -> tuple[Any, list[Any]]:
    """obc_sphere_optimizer_blocks, and the arrays that it points at."""
    if len(neighbors) != len(x):
        raise ValueError(f"neighbors: {len(x)} rows are needed, one for each row of x0, not {len(neighbors)}")
    rows = [indices(row, name=f"neighbors[{i}]", below=len(x), of="spheres").ravel() for i, row in enumerate(neighbors)]
    starts = np.zeros(len(x) + 1, dtype=np.uintp)
    starts[1:] = np.cumsum([len(row) for row in rows])
    flat = np.concatenate(rows)
    blocks = raw.obc_sphere_optimizer_blocks()
    call_init(raw.obc_sphere_optimizer_blocks_init, blocks)
    blocks.dimension, blocks.count = x.shape[1], x.shape[0]
    blocks.neighbor_start, blocks.neighbor = address(starts), address(flat)
    return blocks, [starts, flat]


@with_options("obc_sphere_optimizer_relaxation_options")
def relax(f: Callable[..., Any], x0: ArrayLike, neighbors: Sequence[Sequence[int]], *,
          # options of obc_sphere_optimizer_relaxation_options, written by scripts/bindings.py
          method: Literal["great-circle", "dissertation"] = "great-circle", second_order: bool = False,
          order: Literal["automatic", "queue", "sweeps"] = "automatic", gradient_tolerance: float = 1e-06,
          relative_gain: float = 0.0, over_relaxation: float = 0.0, max_passes: int = 10000,
          # end of options
          progress: Progress = None) -> Relaxed:
    """Lowers f block by block. `f(block, place, points, derivatives)` returns the part of f that contains a block if it were
    at `place` and all others as in `points`: the value; with derivatives 1 (value, gradient); with 2, when `second_order=1`,
    (value, gradient, hessian). More is fine. The arrays are the solver's own and only valid in the call.
    neighbors[i]: the blocks whose part of f contains block i."""
    chosen = filled(raw.obc_sphere_optimizer_relaxation_options, raw.obc_sphere_optimizer_relaxation_options_init, locals())
    x = _points(x0)
    blocks, kept = _blocks(x, neighbors)
    part = _Part(f, (x.shape[0], x.shape[1]))
    report = sized(raw.obc_sphere_optimizer_relaxation_result)
    call(raw.obc_sphere_optimizer_relax, byref(blocks), byref(chosen), part.function, None, address(x), byref(report),
         HOST, progress=progress, raised=part.raised)
    del kept
    return Relaxed(x, report)


class Relaxation:
    """A relaxation in parts: `run` performs the given number of steps, `result` is the current state, `save` and `load` go on elsewhere.
    Ends in the bits of `relax`."""

    @with_options("obc_sphere_optimizer_relaxation_options")
    def __init__(self, x0: ArrayLike, neighbors: Sequence[Sequence[int]], *,
                 # options of obc_sphere_optimizer_relaxation_options, written by scripts/bindings.py
                 method: Literal["great-circle", "dissertation"] = "great-circle", second_order: bool = False,
                 order: Literal["automatic", "queue", "sweeps"] = "automatic", gradient_tolerance: float = 1e-06,
                 relative_gain: float = 0.0, over_relaxation: float = 0.0, max_passes: int = 10000,
                 # end of options
                 ) -> None:
        chosen = filled(raw.obc_sphere_optimizer_relaxation_options, raw.obc_sphere_optimizer_relaxation_options_init, locals())
        x = _points(x0)
        blocks, kept = _blocks(x, neighbors)
        self._begin((x.shape[0], x.shape[1]))
        call(raw.obc_sphere_optimizer_relaxation_create, byref(blocks), byref(chosen), address(x), None, byref(self._handle))
        del kept

    def _begin(self, shape: tuple[int, int]) -> None:
        self._shape, self._handle = shape, Handle(raw.obc_sphere_optimizer_relaxation_destroy)

    @classmethod
    @public
    def load(cls, blob: bytes, x0: ArrayLike, neighbors: Sequence[Sequence[int]]) -> Relaxation:
        """Goes on with a relaxation that was saved, of the same neighbors; of x0 only the shape counts."""
        x = _points(x0)
        blocks, kept = _blocks(x, neighbors)
        relaxation = cls.__new__(cls)
        relaxation._begin((x.shape[0], x.shape[1]))
        call(raw.obc_sphere_optimizer_relaxation_load, byref(blocks), blob, len(blob), None, byref(relaxation._handle))
        del kept
        return relaxation

    @public
    def run(self, f: Callable[..., Any], steps: int) -> Relaxed:
        """Relaxes up to the given number of further blocks, with f as of `relax`. `stop` is "running" when there is more to do. What
        f raises comes out, and after `Stop` ("cancelled") too the next call goes on as if it had not been broken off."""
        integer(steps, "steps", 0, 2**64 - 1)
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
