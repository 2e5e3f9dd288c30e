"""Where the tasks of a study run: in processes of this machine, or on the workers of a Dask cluster.

A task is one run of the command. What it is done on may be killed, and so may the command.
"""

from __future__ import annotations

import importlib
import queue
from concurrent import futures
from typing import Any, Mapping, NamedTuple, Optional, Protocol
from uuid import uuid4

from . import _command

# Kinds of failures of the command that another attempt, perhaps on another machine, may not have.
PASSING = ("killed", "out-of-memory", "io")


class Finished(NamedTuple):
    """A task that has ended: with the report of the command, and why it has no result where it may be tried elsewhere."""

    name: str
    report: Mapping[str, Any]
    broken: Optional[str]
    again: bool  # whether another attempt has a chance


class Workers(Protocol):
    """What does tasks. `where`: the argument of the user that says so."""

    where: str

    def submit(self, name: str, alone: bool, arguments: list[str], command: Optional[str], folder: Optional[str]) -> None:
        """Starts a task. `alone`: no other one runs, so that it may use all threads."""

    def next(self, seconds: float) -> Optional[Finished]:
        """The next task that has ended; None where none does within this time."""

    def close(self) -> None:
        """Ends all tasks."""


class _Queue:
    """Tasks in the order in which they end. `where`: the beginning of a message about what a task could not be run on."""

    def __init__(self, where: str = "") -> None:
        self._where = where
        self._ended: queue.SimpleQueue[tuple[str, Any]] = queue.SimpleQueue()
        self._futures: dict[str, Any] = {}

    def add(self, name: str, future: Any) -> None:
        self._futures[name] = future
        future.add_done_callback(lambda ended: self._ended.put((name, ended)))

    def next(self, seconds: float) -> Optional[Finished]:
        try:
            name, future = self._ended.get(timeout=seconds)
        except queue.Empty:
            return None
        del self._futures[name]
        try:
            report = future.result()
        except futures.CancelledError as cancelled:
            raise RuntimeError(f"{self._where}a task was cancelled: {cancelled}") from cancelled
        except Exception as error:  # noqa: BLE001: of the kinds of dask.distributed
            if type(error).__name__ == "KilledWorker":
                return Finished(name, {}, f"killed: {error}", False)
            if not self._where:
                raise
            raise RuntimeError(f"{self._where}a task cannot be run there: {type(error).__name__}: {error}") from error
        failure = report.get("error")
        if failure is None or failure["kind"] not in PASSING:
            return Finished(name, report, None, False)
        return Finished(name, report, f"{failure['kind']}: {failure['message']}", True)

    def left(self) -> list[Any]:
        return list(self._futures.values())


class Local:
    """Processes of this machine."""

    where = "command"

    def __init__(self, processes: int, threads: int) -> None:
        self._count, self._threads = processes, threads
        self._processes = _command.Processes()
        self._pool = futures.ThreadPoolExecutor(processes)
        self._queue = _Queue()

    def submit(self, name: str, alone: bool, arguments: list[str], command: Optional[str], folder: Optional[str]) -> None:
        threads = self._threads * (self._count if alone else 1)
        self._queue.add(name, self._pool.submit(_command.run, "study", [f"--threads={threads}", *arguments], command, folder,
                                                self._processes))

    def next(self, seconds: float) -> Optional[Finished]:
        return self._queue.next(seconds)

    def close(self) -> None:
        for future in self._queue.left():
            future.cancel()
        self._processes.close()
        self._pool.shutdown()


def _on_worker(arguments: list[str], threads: int, alone: bool, command: Optional[str], folder: Optional[str]) -> Mapping[str, Any]:
    """Runs the command on a worker of a cluster."""
    if alone:
        threads *= importlib.import_module("distributed").get_worker().state.nthreads
    return _command.run("study", [f"--threads={threads}", *arguments], command, folder)


class Cluster:
    """The workers of a client of dask.distributed, whose scheduler gives tasks of killed workers to others."""

    where = "client"

    def __init__(self, client: Any, threads: int) -> None:
        if not any(kind.__name__ == "Client" and kind.__module__.startswith("distributed") for kind in type(client).__mro__):
            raise TypeError(f"client: a dask.distributed.Client is needed, not {type(client).__name__}")
        if client.asynchronous:
            raise ValueError("client: it is asynchronous; make it with asynchronous=False")
        if client.status != "running":
            raise ValueError(f"client: it is {client.status}, not running")
        self._client, self._threads = client, threads
        self._queue = _Queue("client: ")

    def submit(self, name: str, alone: bool, arguments: list[str], command: Optional[str], folder: Optional[str]) -> None:
        self._queue.add(name, self._client.submit(_on_worker, arguments, self._threads, alone, command, folder, pure=False,
                                                  key=f"orbicube-study-{uuid4()}"))

    def next(self, seconds: float) -> Optional[Finished]:
        return self._queue.next(seconds)

    def close(self) -> None:
        left = self._queue.left()
        if left:
            self._client.cancel(left)
