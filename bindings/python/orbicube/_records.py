"""What the classes of results and meshes have in common: comparing, copying and showing what they hold."""

from __future__ import annotations

from typing import Any

import numpy as np


def same(a: Any, b: Any) -> bool:
    """Equal values; arrays of the same shape, type and numbers."""
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        return isinstance(a, np.ndarray) and isinstance(b, np.ndarray) and a.dtype == b.dtype and np.array_equal(a, b)
    if isinstance(a, (list, tuple)) and isinstance(b, (list, tuple)):
        return len(a) == len(b) and all(same(x, y) for x, y in zip(a, b))
    return bool(a == b)


class Record:
    """A class of named values, mostly arrays: equal when all are, shown by their counts."""

    def __eq__(self, other: object) -> bool:
        if type(self) is not type(other):
            return NotImplemented
        mine, others = vars(self), vars(other)
        return mine.keys() == others.keys() and all(same(value, others[name]) for name, value in mine.items())

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        counts = [f"{len(value)} {name.replace('_', ' ')}" for name, value in vars(self).items()
                  if isinstance(value, (np.ndarray, list))]
        return f"{type(self).__name__}({', '.join(counts)})"
