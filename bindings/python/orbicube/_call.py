"""How a C function is called: errors become exceptions, the host reports progress, Ctrl-C stops the work."""

from __future__ import annotations

import contextlib
import ctypes
import importlib
import inspect
import os
import signal
import threading
from ctypes import byref, sizeof
from typing import Any, Callable, Mapping, Optional, TypeVar, Union

from . import _checks
from ._checks import F
from ._option import Option
from ._options import OPTIONS
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
    """The file is not what its format requires."""


class UnsuitableSurface(Error, ValueError):
    """Not closed, not manifold, of the wrong genus, or degenerate."""


class OutOfMemory(Error, MemoryError):
    """The library could not allocate."""


class Cancelled(Error):
    """The progress function cancelled the work."""


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
    """Raise it in a function that a solver calls: the run ends as cancelled, and the best point so far is handed out.
    `Stop(value)`, or `Stop(residuals)`, or `Stop(value, gradient)`, counts the point at hand as well."""


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
    that no cycle arises that runs through an array, which Python's collector would not see.

    While a thread is inside a call with it, it is not destroyed: close() leaves that to the call, and a thread that never
    returns, as a daemon thread when the interpreter ends, leaves it to the end of the process. A lock is no way to count
    these calls, since such a thread would keep it for ever; appending to a list and popping from it are atomic."""

    def __init__(self, destroy: Any, value: Optional[int] = None) -> None:
        super().__init__(value)
        self._destroy = destroy
        self._uses: list[None] = []
        self._closed: list[int] = []

    def __enter__(self) -> Handle:
        self._uses.append(None)
        return self

    def __exit__(self, *_: Any) -> None:
        self._uses.pop()
        if self._closed:
            self._release()

    def __del__(self) -> None:
        self.close()

    def close(self) -> None:
        """Releases it now, or when the last call with it ends."""
        value = self.value
        if value:
            self.value = None
            self._closed.append(value)
            self._release()

    def _release(self) -> None:
        if self._uses:
            return
        try:
            value = self._closed.pop()
        except IndexError:  # another thread was faster
            return
        self._destroy(value)


def call(function: Any, *arguments: Any, progress: Progress = None, threads: int = 0,
         raised: Optional[list[BaseException]] = None) -> None:
    """Calls a function whose last parameter is obc_error, which is added here; HOST stands for the host. What another
    callback puts into `raised` stops the work at the next report, and is raised in the end."""
    with contextlib.ExitStack() as uses:
        for argument in arguments:
            if isinstance(argument, Handle):
                uses.enter_context(argument)
        _call(function, arguments, progress, threads, raised)


def _call(function: Any, arguments: tuple[Any, ...], progress: Progress, threads: int,
          raised: Optional[list[BaseException]]) -> None:
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


class KeptHost:
    """The host of a handle that keeps it: each report goes to the call that runs. It must live as long as the handle."""

    def __init__(self, threads: int) -> None:
        running: list[_Lent] = []  # rather than self, which would be a cycle through the C function

        def report(phase: bytes, done: int, total: int, best: float, user: Any) -> int:
            return running[-1].report(phase, done, total, best, user) if running else 0

        self._running = running
        self.host = raw.obc_host()
        raw.obc_host_init(byref(self.host), sizeof(self.host))
        self.host.thread_count = threads
        self.host.progress = raw.obc_progress_function(report)

    def call(self, function: Any, *arguments: Any, progress: Progress = None) -> None:
        """`call` for a function whose handle keeps this host."""
        lent = _Lent(progress, 0, [])
        self._running.append(lent)
        try:
            call(function, *arguments)
        except Cancelled:
            if not lent.raised:
                raise
        finally:
            self._running.remove(lent)
            lent.close()
        if lent.raised:
            raise lent.raised[0]


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


def filled(kind: type[S], init: Any, given: Mapping[str, Any]) -> S:
    """Options: the library's defaults, then what `given` has of their names, as the arguments of a function (locals()) do, whatever
    else is in it. A word stands for its constant; None for the default."""
    options = kind()
    call_init(init, options)
    for option in OPTIONS[kind.__name__]:
        value = given.get(option.name)
        if value is not None:
            setattr(options, option.name, _value(option, value, option.name))
    return options


def _value(option: Option, value: Any, name: str) -> Any:
    if option.kind == "word":
        words = option.words or {}
        if not isinstance(value, str) and value in words.values():  # a constant of the raw module
            return value
        return words[_checks.word(value, name, words)]
    if option.kind == "int":
        return _checks.integer(value, name, option.low, option.high)
    if option.kind == "text":
        return _checks.text(value, name).encode()
    return int(_checks.flag(value, name)) if option.kind == "bool" else _checks.real(value, name)


def picked(given: Mapping[str, Any], struct: str) -> dict[str, Any]:
    """The options of a struct among the arguments of a function, to pass on."""
    return {option.name: given[option.name] for option in OPTIONS[struct] if option.name in given}


def named(given: Mapping[str, Any], struct: str, argument: str) -> Mapping[str, Any]:
    """A dictionary of options that a function takes as one argument, when it has nothing else in it."""
    known = {option.name: option for option in OPTIONS[struct]}
    for name, value in given.items():
        if name not in known:
            near = _checks.nearest(str(name), known) or "."
            raise TypeError(f"{argument}: no option {name!r}{near} There are: {', '.join(known)}")
        _value(known[name], value, f"{argument}[{name!r}]")
    return given


def with_options(*structs: str) -> Callable[[F], F]:
    """`public` for a function that takes options, of which its documentation then has what the headers say."""
    def wrap(function: F) -> F:
        names = inspect.signature(function).parameters
        rows = [f"{option.name}: {option.doc}" for struct in structs for option in OPTIONS[struct]
                if option.name in names and option.doc]
        function.__doc__ = "\n    ".join([(function.__doc__ or "").rstrip(), "", "Options:"] + ["  " + row for row in rows])
        return _checks.public(function)
    return wrap


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
    return os.fsencode(path)


def text(value: Optional[bytes]) -> Optional[str]:
    return None if value is None else value.decode("utf-8", "replace")
