"""What all public functions do with their arguments before anything else: one look at each, by its annotation.

`public` wraps a function. An unknown argument is a TypeError with the nearest ones; what is of the wrong type or no allowed word
is a TypeError or ValueError that begins with the name of the argument. Arrays and meshes are looked at where they are used
(_arrays, _foreign), by the same names.
"""

from __future__ import annotations

import ast
import difflib
import functools
import inspect
import math
import numbers
import operator
import os
import reprlib
from typing import Any, Callable, Iterable, Mapping, Optional, TypeVar, Union

import numpy as np

F = TypeVar("F", bound=Callable[..., Any])
PathLike = Union[str, bytes, "os.PathLike[str]", "os.PathLike[bytes]"]
Check = Callable[[Any, str], Any]


def shown(value: Any) -> str:
    """A value in a message: short, in one line."""
    if isinstance(value, np.ndarray):
        return f"an array of shape {value.shape}"
    return " ".join(reprlib.repr(value).split())


def kind_of(value: Any) -> str:
    return "None" if value is None else type(value).__name__


def integer(value: Any, name: str, low: Optional[int] = None, high: Optional[int] = None) -> int:
    """Integers, also those that are written as floats: 1000.0, 1e3."""
    if isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name}={value}: an integer is needed")
    try:
        number = operator.index(value)
    except TypeError:
        if not isinstance(value, (float, np.floating)):
            raise TypeError(f"{name}: an integer is needed, not {kind_of(value)} ({shown(value)})") from None
        if not float(value).is_integer():
            raise ValueError(f"{name}={value}: an integer is needed") from None
        number = int(value)
    if (low is not None and number < low) or (high is not None and number > high):
        raise ValueError(f"{name}={number}: out of range, {'any' if low is None else low} to {'any' if high is None else high}")
    return number


def real(value: Any, name: str) -> float:
    """A number that is not NaN."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if isinstance(value, (bool, np.bool_)) or not (isinstance(value, (numbers.Real, np.number)) or hasattr(value, "__float__")) \
            or isinstance(value, (complex, np.complexfloating, np.ndarray)):
        raise TypeError(f"{name}: a number is needed, not {kind_of(value)} ({shown(value)})")
    number = float(value)
    if math.isnan(number):
        raise ValueError(f"{name} is NaN: a number is needed")
    return number


def flag(value: Any, name: str) -> bool:
    """True, False, 1 or 0."""
    if isinstance(value, (bool, np.bool_)) or (isinstance(value, (int, np.integer)) and value in (0, 1)):
        return bool(value)
    error = ValueError if isinstance(value, (int, float)) else TypeError
    raise error(f"{name}: True or False is needed, not {shown(value)}")


def nearest(wrong: str, allowed: Iterable[str]) -> str:
    """"; did you mean ...?" where something is near."""
    found = difflib.get_close_matches(wrong.lower().replace("_", "-"), list(allowed), 2, 0.6) or \
        difflib.get_close_matches(wrong.lower(), list(allowed), 2, 0.6)
    return f"; did you mean {' or '.join(repr(word) for word in found)}?" if found else ""


def word(value: Any, name: str, allowed: Iterable[str]) -> str:
    """One of the allowed words, however it is capitalised, with - or _ or a space."""
    words = list(allowed)
    among = ", ".join(repr(one) for one in words)
    if not isinstance(value, str):
        raise TypeError(f"{name}: one of {among} is needed, not {kind_of(value)} ({shown(value)})")
    plain = value.lower().replace("_", "-").replace(" ", "-")
    if value not in words and plain not in words:
        raise ValueError(f"{name}={value!r}: one of {among} is needed{nearest(value, words)}")
    return value if value in words else plain


def callback(value: Any, name: str) -> Any:
    if not callable(value):
        raise TypeError(f"{name}: a function is needed, not {kind_of(value)} ({shown(value)})")
    return value


def progress(value: Any, name: str) -> Any:
    if value is not None and not isinstance(value, bool) and not callable(value):
        raise TypeError(f"{name}: None, True or a function of (phase, done, total, best) is needed, not {shown(value)}")
    return value


def path(value: Any, name: str) -> Any:
    try:
        found = os.fsencode(value)
    except TypeError:
        raise TypeError(f"{name}: a path is needed (str, bytes or os.PathLike), not {kind_of(value)}") from None
    if b"\0" in found:
        raise ValueError(f"{name}: embedded null byte")
    return value


def text(value: Any, name: str) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name}: a str is needed, not {kind_of(value)} ({shown(value)})")
    if "\0" in value:
        raise ValueError(f"{name}: embedded null character")
    return value


def data(value: Any, name: str) -> bytes:
    if not isinstance(value, (bytes, bytearray, memoryview)):
        raise TypeError(f"{name}: bytes are needed, not {kind_of(value)}")
    return bytes(value)


def mapping(value: Any, name: str) -> Any:
    if not isinstance(value, Mapping):
        raise TypeError(f"{name}: a dictionary is needed, not {kind_of(value)} ({shown(value)})")
    return value


def sequence(value: Any, name: str) -> Any:
    if isinstance(value, (str, bytes)) or not hasattr(value, "__len__") or not hasattr(value, "__getitem__"):
        raise TypeError(f"{name}: a list or another sequence is needed, not {kind_of(value)}")
    return value


def given(value: Any, name: str) -> Any:
    """Arrays and meshes: that there is one."""
    if value is None:
        raise TypeError(f"{name} is None: it is needed")
    return value


def polycube(value: Any, name: str) -> Any:
    if not any(kind.__name__ == "Polycube" for kind in type(value).__mro__):
        raise TypeError(f"{name}: a Polycube is needed, not {kind_of(value)}")
    return value


def optional(check: Check) -> Check:
    return lambda value, name: None if value is None else check(value, name)


def threads(value: Any, name: str) -> int:
    return integer(value, name, 0, 2**32 - 1)


_PLAIN: dict[str, Check] = {
    "int": integer, "float": real, "bool": flag, "str": text, "bytes": data, "Progress": progress, "PathLike": path,
    "ArrayLike": given, "Polycube": polycube}


def check_of(annotation: str, name: str) -> Optional[Check]:
    """What is done with an argument of that annotation; None: nothing."""
    if annotation.startswith("Optional[") and annotation.endswith("]"):
        inner = check_of(annotation[len("Optional["):-1], name)
        return optional(inner) if inner is not None and inner is not given else None
    if annotation.startswith("Literal["):
        words = ast.literal_eval("(" + annotation[len("Literal["):-1] + ",)")
        return lambda value, name: word(value, name, words)
    if name == "threads":
        return threads
    for start, check in (("Callable", callback), ("Mapping", mapping), ("Sequence", sequence)):
        if annotation.startswith(start):
            return check
    return _PLAIN.get(annotation)


def unknown(function: str, wrong: str, names: Iterable[str]) -> TypeError:
    """The TypeError for an argument that a function has not."""
    known = list(names)
    return TypeError(f"{function}() has no argument {wrong!r}{nearest(wrong, known) or '.'} There are: {', '.join(known)}")


def public(function: F) -> F:
    """A function whose arguments are looked at before it runs."""
    plan: list[tuple[str, Check]] = []
    signature = inspect.signature(function)
    names = [name for name in signature.parameters if name not in ("self", "cls")]
    for parameter in signature.parameters.values():
        check = check_of(str(parameter.annotation), parameter.name)
        if check is not None:
            plan.append((parameter.name, check))
    title = function.__qualname__.replace(".__init__", "")

    @functools.wraps(function)
    def checked(*arguments: Any, **named: Any) -> Any:
        try:
            bound = signature.bind(*arguments, **named)
        except TypeError as error:
            for name in named:
                if name not in names:
                    raise unknown(title, name, names) from None
            raise TypeError(f"{title}(): {error}") from None
        found = bound.arguments
        for name, check in plan:
            if name in found:
                found[name] = check(found[name], name)
        return function(*bound.args, **bound.kwargs)

    return checked  # type: ignore[return-value]
