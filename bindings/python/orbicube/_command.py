"""The command `orbicube`: where it is, and runs of it whose figures become values and whose errors become exceptions.

It is looked for by the variable ORBICUBE_COMMAND, among the programs that were installed with the package, then on the path.
"""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import sysconfig
import tempfile
import threading
from typing import Any, Mapping, Optional, Sequence

from ._call import Cancelled, Error, FileError, InvalidArgument, MalformedFile, NoValidResult, OutOfMemory, Unsupported
from .raw import base as raw

_KINDS: dict[str, tuple[type[Error], int]] = {
    "usage": (InvalidArgument, raw.OBC_INVALID_ARGUMENT), "invalid-argument": (InvalidArgument, raw.OBC_INVALID_ARGUMENT),
    "parse": (MalformedFile, raw.OBC_MALFORMED_FILE), "empty-file": (MalformedFile, raw.OBC_MALFORMED_FILE),
    "unsupported": (Unsupported, raw.OBC_UNSUPPORTED),
    "io": (FileError, raw.OBC_IO), "no-valid-result": (NoValidResult, raw.OBC_NO_VALID_RESULT),
    "out-of-memory": (OutOfMemory, raw.OBC_OUT_OF_MEMORY), "cancelled": (Cancelled, raw.OBC_CANCELLED),
    "time-limit": (Cancelled, raw.OBC_CANCELLED),
}


def exception(kind: str, message: str) -> Error:
    """The exception for a failure of the command."""
    error, status = _KINDS.get(kind, (Error, raw.OBC_INTERNAL))
    return error(status, kind, message)


def find() -> str:
    """The path of the command; FileNotFoundError says where it was looked for."""
    named = os.environ.get("ORBICUBE_COMMAND")
    if named:
        return named
    package = os.path.dirname(os.path.abspath(__file__))
    folders = [sysconfig.get_path("scripts"), os.path.join(os.path.dirname(package), "bin"), os.path.dirname(sys.executable)]
    if f"{os.name}_user" in sysconfig.get_scheme_names():
        folders.append(sysconfig.get_path("scripts", f"{os.name}_user"))
    found = shutil.which("orbicube", path=os.pathsep.join(folders)) or shutil.which("orbicube")
    if found is None:
        raise FileNotFoundError(f"there is no command orbicube in {', '.join(dict.fromkeys(folders))} or on the path; `pip install .` "
                                "in the top folder of the tree installs it, or name its file in ORBICUBE_COMMAND")
    return found


class Processes:
    """Runs of the command by this process, which can be ended together."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._running: set[subprocess.Popen[str]] = set()
        self._closed = False

    def run(self, arguments: Sequence[str], folder: Optional[str]) -> tuple[int, str, str]:
        """Runs a program in a folder; its exit code, stdout and stderr."""
        with self._lock:
            if self._closed:
                raise exception("cancelled", "no process is started any more")
            process = subprocess.Popen(arguments, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                       text=True, encoding="utf-8", errors="replace")
            self._running.add(process)
        try:
            said, failed = process.communicate()
        finally:
            with self._lock:
                self._running.discard(process)
        return process.returncode, said, failed

    def close(self) -> None:
        """Ends those that run, which leave no half file, and starts no other."""
        with self._lock:
            self._closed = True
            for process in self._running:
                process.terminate()


def run(verb: str, arguments: Sequence[str], command: Optional[str] = None, folder: Optional[str] = None,
        processes: Optional[Processes] = None) -> Mapping[str, Any]:
    """
    Runs a verb of the command and returns its report. "exit_code" and, of a failure, "error" (file, kind, message) are in it; what ends
    without a report has a kind as well: "usage", or "killed" with the name of the signal.
    """
    path = command or find()
    with tempfile.TemporaryDirectory(prefix="orbicube-") as place:
        written = os.path.join(place, "report.json")
        try:
            code, _, failed = (processes or Processes()).run(
                [path, verb, "--quiet", f"--report={written}", *arguments], folder)
        except OSError as error:
            raise FileNotFoundError(f"{path} in {folder or os.getcwd()}: {error}") from error
        if code >= 0 and os.path.exists(written):
            with open(written, encoding="utf-8") as file:
                report: dict[str, Any] = json.load(file)
            return report
    if code < 0:
        try:
            name = signal.Signals(-code).name
        except ValueError:
            name = str(-code)
        return {"exit_code": code, "error": {"file": "", "kind": "killed", "message": f"the command was killed by {name}"}}
    lines = failed.strip().splitlines() or [f"the command ended with exit code {code} and without a report"]
    message = lines[0][len("orbicube: "):] if lines[0].startswith("orbicube: ") else lines[0]
    kind, _, rest = message.partition(": ")
    known = kind if kind in _KINDS and rest else "usage" if code == 2 else "internal"
    return {"exit_code": code, "error": {"file": "", "kind": known, "message": rest if known == kind else message}}
