"""How a C function is called: errors become exceptions, the host reports progress, Ctrl-C stops the work."""

from __future__ import annotations

import ctypes
import importlib
import os
import signal
import threading
from ctypes import byref, sizeof
from typing import Any, Callable, Optional, TypeVar, Union

from .raw import base as raw

Progress = Union[None, bool, Callable[[str, int, int, float], Any]]
S = TypeVar("S", bound=ctypes.Structure)


class Error(Exception):
    """What a library refused or failed at: `status` (a number of raw.base), `kind` (one word) and `message`."""

    def __init__(self, status: int, kind: str, message: str) -> None:
        super().__init__(f"{kind}: {message}" if message else kind)
        self.status, self.kind, self.message = status, kind, message

    def __reduce__(self) -> Any:
        return type(self), (self.status, self.kind, self.message)


class InvalidArgument(Error, ValueError):
    """NULL, NaN or a wrong size where that is not allowed, or an unknown option."""


class MalformedFile(Error, ValueError):
    """The file is not what its format asks for."""


class UnsuitableSurface(Error, ValueError):
    """Not closed, not manifold, of the wrong genus, or degenerate."""


class OutOfMemory(Error, MemoryError):
    """The library could not allocate."""


class Cancelled(Error):
    """The progress function asked to stop."""


class FileError(Error, OSError):
    """A file could not be opened, read or written."""

    def __str__(self) -> str:
        return f"{self.kind}: {self.message}"


class Unsupported(Error):
    """Legal, but not something that the library does."""


class NoValidResult(Error):
    """The method ended without a result that can be certified. `best`: what there is of one, where a function says so."""

    best: Any = None


class Stop(Exception):
    """Raise it in a function that a solver calls: the run ends as cancelled, and the best point so far is handed out."""


_EXCEPTIONS: dict[int, type[Error]] = {
    raw.OBC_INVALID_ARGUMENT: InvalidArgument, raw.OBC_MALFORMED_FILE: MalformedFile,
    raw.OBC_NOT_CLOSED: UnsuitableSurface, raw.OBC_NOT_MANIFOLD: UnsuitableSurface,
    raw.OBC_WRONG_GENUS: UnsuitableSurface, raw.OBC_DEGENERATE: UnsuitableSurface,
    raw.OBC_OUT_OF_MEMORY: OutOfMemory, raw.OBC_CANCELLED: Cancelled, raw.OBC_IO: FileError,
    raw.OBC_UNSUPPORTED: Unsupported, raw.OBC_NO_VALID_RESULT: NoValidResult,
}


def exception(status: int, error: raw.obc_error) -> Error:
    message = error.message.decode("utf-8", "replace")
    kind = error.kind.decode("ascii", "replace") or (raw.obc_status_name(status) or b"").decode("ascii")
    return _EXCEPTIONS.get(status, Error)(status, kind, message)


class _Host:
    """Stands for the obc_host in the arguments of `call`."""


HOST = _Host()


class Handle(ctypes.c_void_p):
    """What a library hands out, released with the last reference to it: an owner and the arrays over its memory hold it, so
    that no cycle arises that runs through an array, which Python's collector would not see."""

    def __init__(self, destroy: Any) -> None:
        super().__init__()
        self._destroy = destroy

    def __del__(self) -> None:
        self.close()

    def close(self) -> None:
        """Releases it now."""
        if self.value:
            self._destroy(self.value)
            self.value = None


def call(function: Any, *arguments: Any, progress: Progress = None, threads: int = 0,
         raised: Optional[list[BaseException]] = None) -> None:
    """Calls a function whose last parameter is obc_error, which is added here; HOST stands for the host. What another
    callback puts into `raised` stops the work at the next report, and is raised in the end."""
    error = raw.obc_error()
    if HOST not in arguments:
        status = function(*arguments, byref(error))
        if status:
            raise exception(status, error)
        return
    lent = _Lent(progress, threads, [] if raised is None else raised)
    try:
        host = byref(lent.host)
        status = function(*[host if argument is HOST else argument for argument in arguments], byref(error))
    finally:
        lent.close()
    if lent.raised:
        raise lent.raised[0]
    if status:
        raise exception(status, error)


class _Lent:
    """A host for one call. In the main thread SIGINT is taken note of while the call lasts, since an exception cannot pass
    through C: the next report of progress stops the work, and the exception of the former handler is raised after it."""

    def __init__(self, progress: Progress, threads: int, raised: list[BaseException]) -> None:
        if not 0 <= threads < 2**32:
            raise ValueError(f"threads={threads}: a number of threads is needed, or 0")
        self.raised = raised
        self.progress: Any = bar() if progress is True else progress or None
        self.host = raw.obc_host()
        raw.obc_host_init(byref(self.host), sizeof(self.host))
        self.host.thread_count = threads
        self.host.progress = raw.obc_progress_function(self.report)
        self.former: Any = None
        if threading.current_thread() is threading.main_thread():
            former = signal.getsignal(signal.SIGINT)
            if callable(former):
                self.former = former
                signal.signal(signal.SIGINT, self.interrupt)

    def interrupt(self, number: int, frame: Any) -> None:
        try:
            self.former(number, frame)
        except BaseException as error:  # noqa: BLE001: whatever it is, it is raised when the call has ended
            self.raised.append(error)

    def report(self, phase: bytes, done: int, total: int, best: float, _: Any) -> int:
        if not self.raised and self.progress is not None:
            try:
                if self.progress(phase.decode("utf-8", "replace"), done, total, best):
                    return 1
            except BaseException as error:  # noqa: BLE001
                self.raised.append(error)
        return 1 if self.raised else 0

    def close(self) -> None:
        if self.former is not None:
            signal.signal(signal.SIGINT, self.former)
        if hasattr(self.progress, "close"):
            self.progress.close()
        self.host.progress = raw.obc_progress_function()  # breaks the cycle of references


def bar() -> Optional[Callable[[str, int, int, float], Any]]:
    """A progress bar of tqdm, one for all phases, of which there may be hundreds; None where tqdm is not installed."""
    try:
        tqdm = importlib.import_module("tqdm.auto").tqdm
    except ImportError:
        return None

    class Bar:
        def __init__(self) -> None:
            self.phase = ""
            self.bar: Any = None

        def __call__(self, phase: str, done: int, total: int, best: float) -> None:
            if self.bar is None:
                self.bar = tqdm(leave=False)
            if phase != self.phase or done < self.bar.n:
                self.phase = phase
                self.bar.set_description(phase, refresh=False)
                self.bar.reset(total or None)
            self.bar.total = total or None
            self.bar.update(done - self.bar.n)

        def close(self) -> None:
            if self.bar is not None:
                self.bar.close()
                self.bar = None

    return Bar()


def filled(kind: type[S], init: Any, given: dict[str, Any], module: Any = None, prefix: str = "") -> S:
    """Options: the library's defaults, then what is given by name. The text "angle-area" of `method` stands for the constant
    <prefix>METHOD_ANGLE_AREA of the raw module, or <prefix>ANGLE_AREA."""
    options = kind()
    call_init(init, options)
    names = [row[0] for row in kind._fields_ if row[0] not in ("struct_size", "reserved")]
    for name, value in given.items():
        if name not in names:
            raise TypeError(f"no option {name!r}; there are {', '.join(names)}")
        if isinstance(value, str) and module is not None:
            word = value.upper().replace("-", "_").replace(" ", "_")
            constant = f"{prefix}{name.upper()}_{word}"
            if not hasattr(module, constant):
                constant = prefix + word
            if not hasattr(module, constant):
                raise ValueError(f"{name}={value!r}: there is no {constant}")
            value = getattr(module, constant)
        setattr(options, name, value)
        if isinstance(value, int) and getattr(options, name) != value:  # ctypes drops what does not fit
            raise ValueError(f"{name}={value}: out of range")
    return options


def call_init(init: Any, struct: ctypes.Structure) -> None:
    status = init(byref(struct), sizeof(struct))
    if status:
        raise exception(status, raw.obc_error())


def sized(kind: type[S]) -> S:
    """An empty result that knows its size."""
    result = kind()
    result.struct_size = sizeof(kind)
    return result


def path_bytes(path: Any) -> bytes:
    name = os.fsencode(path)
    if b"\0" in name:
        raise ValueError("embedded null byte in a path")
    return name


def text(value: Optional[bytes]) -> Optional[str]:
    return None if value is None else value.decode("utf-8", "replace")
