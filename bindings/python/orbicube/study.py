"""Studies of groups of shapes by the command `orbicube study`: by processes of this machine, or on a Dask cluster.

    result = study.run("subjects/", "out/")
    result = study.run("list.csv", "out/", client=dask.distributed.Client(address), groups="diagnosis")

Every subject is a task. Results are the same bits wherever it ran; machines whose elementary functions round otherwise are refused.
docs/study.md describes the steps and the files of `out/`.
"""

from __future__ import annotations

import csv
import math
import os
import time
import webbrowser
from typing import Any, Literal, Mapping, NamedTuple, Optional

import numpy as np

from . import __version__, _command
from ._arrays import Doubles
from ._call import Progress, bar
from ._checks import PathLike, integer, public
from ._command import exception
from ._records import Record
from ._tasks import Cluster, Finished, Local, Workers

__all__ = ["Failed", "Study", "Subject", "run", "subjects"]

# Seconds after which the group is tried again where files of other machines have not arrived: the caches of network file systems
# hold the names in a folder for up to a minute.
ARRIVAL = (2, 20, 60)


class Subject(NamedTuple):
    """A subject of a study: the name of its files and rows, and its file."""

    name: str
    file: str


class Failed(NamedTuple):
    """A subject that was left out, the kind of its error in one word, and the message."""

    name: str
    file: str
    kind: str
    message: str


class Study(Record):
    """
    What a study has written: `folder`; `report`, the figures of the command; and `failed`, the subjects that were left out. The
    contents of files are read at their first use.
    """

    def __init__(self, folder: str, report: Mapping[str, Any], failed: list[Failed]) -> None:
        self.folder, self.report, self.failed = folder, report, failed

    @property
    def names(self) -> list[str]:
        """The subjects on the grid, which rows of `distances` and `scores` belong to."""
        return [str(subject["name"]) for subject in self.report["subjects"]]

    @property
    def outliers(self) -> list[str]:
        """The subjects far from the mean."""
        return [str(subject["name"]) for subject in self.report["subjects"] if subject["outlier"]]

    @property
    def page(self) -> str:
        """The path of the page."""
        return os.path.join(self.folder, "study.html")

    @property
    def distances(self) -> Doubles:
        """Root mean square distance between the points of each two subjects."""
        return self._table("distances.csv")

    @property
    def scores(self) -> Doubles:
        """Scores of the subjects, a column for each mode."""
        return self._table("scores.csv")

    @property
    def mean(self) -> Any:
        """The mean shape, a `Mesh`."""
        return self._mesh("mean.ply")

    def subject(self, name: str) -> Any:
        """A subject on the grid, where its file has it, a `Mesh`."""
        if name not in self.names:
            raise ValueError(f"name={name!r}: one of {', '.join(map(repr, self.names))} is needed")
        return self._mesh("subjects", f"{name}.ply")

    def open(self) -> None:
        """Opens the page in a browser."""
        webbrowser.open("file://" + os.path.abspath(self.page))

    def __repr__(self) -> str:
        return f"Study({self.folder!r}, {len(self.names)} subjects, {len(self.failed)} failed)"

    def _table(self, name: str) -> Doubles:
        with open(os.path.join(self.folder, name), encoding="utf-8", newline="") as file:
            rows = list(csv.reader(file))
        return np.array([[float(cell) for cell in row[1:]] for row in rows[1:]], dtype=float)

    def _mesh(self, *names: str) -> Any:
        from . import mesh  # needs the libraries, which the rest does not
        return mesh.read(os.path.join(self.folder, *names))


@public
def subjects(subjects: PathLike, *, command: Optional[PathLike] = None) -> list[Subject]:
    """The subjects of a folder or table, in the order of the study."""
    given = _Given(os.fsdecode(subjects), "", {}, command)
    report = _command.run("study", given.arguments("list"), given.command)
    given.require_done(report)
    return [Subject(row["name"], row["file"]) for row in report["list"]]


@public
def run(subjects: PathLike, output: PathLike, *, client: Any = None, grid: str = "icosphere:5",
        align: Literal["shape", "rotation", "none"] = "shape", placement: Literal["robust", "turned", "scaled", "kept"] = "robust",
        label: int = 0, modes: int = 5, groups: Optional[str] = None, covariate: Optional[str] = None,
        test: Literal["normal", "position"] = "normal", permutations: int = 1000, seed: int = 0, processes: int = 0, threads: int = 1, retries: int = 2,
        command: Optional[PathLike] = None, progress: Progress = None) -> Study:
    """
    Brings many subjects onto one grid and computes what they have in common and how they differ. A subject that cannot be mapped is
    left out and reported. A study that was stopped or killed continues where it was, by the same call.

    subjects: folder of closed genus-0 surfaces and label images, or a table of them: CSV with a column "file".
    output: folder to write to, created if it does not exist.
    client: dask.distributed.Client whose workers do the work; None: processes of this machine. The workers have this package with its
      command, and both folders, by the same paths.
    grid: vertices of every subject, as "icosphere:5", "latlong:ROWSxCOLS" and so on.
    align: rotation of the spheres: to maximum correlation with the first subject for any poses, for equal poses, or none.
    placement: pose of the subjects before they are compared: moved to where their surfaces vary least, to their mean by least squares,
      to one size as well, or as in their files.
    label: label whose voxels are the object, in images. 0: the only one.
    modes: number of principal modes in the files for viewers, 0 to 100.
    groups: column of the table with two values: test where the groups differ.
    covariate: column of the table with numbers: test where the shapes change with it.
    test: what is tested at each point: its position along the normal of the mean, or all its coordinates.
    permutations: number of permutations from which p-values are computed, at least 1.
    seed: seed of random choices.
    processes: number of processes without a client. 0: one a core.
    threads: number of threads of each process.
    retries: number of further attempts where a process was killed, or failed for lack of memory or by an error of the file system.
    command: the file of the command. None: the one that is installed with this package, on each machine.
    progress: function of (phase, done, total, best), which may return True to cancel; True: a bar of tqdm.
    """
    options = {"grid": grid, "align": align, "placement": placement, "modes": integer(modes, "modes", 0, 100),
               "seed": integer(seed, "seed", 0, 2**64 - 1)}
    if label:
        options["label"] = integer(label, "label", -2**31, 2**31 - 1)
    if groups is not None:
        options["groups"] = groups
    if covariate is not None:
        options["covariate"] = covariate
    integer(permutations, "permutations", 1, 1_000_000)
    if groups is not None or covariate is not None:
        options["permutations"] = permutations
        options["test"] = test
    elif permutations != 1000:
        raise ValueError(f"permutations={permutations}: they are for groups and covariate, and neither is given")
    elif test != "normal":
        raise ValueError(f"test={test!r}: it is for groups and covariate, and neither is given")
    integer(retries, "retries", 0)
    integer(threads, "threads", 1, 4096)
    if client is not None and processes:
        raise ValueError(f"processes={processes}: they are for a study without client")
    given = _Given(os.fsdecode(subjects), os.fsdecode(output), options, command)
    count = integer(processes, "processes", 0, 4096) or os.cpu_count() or 1
    workers: Workers = Local(count, threads)
    if client is not None:
        workers = Cluster(client, threads)
    shown: Any = bar() if progress is True else progress or None
    try:
        return _Run(given, workers, shown, retries).study()
    finally:
        workers.close()
        if hasattr(shown, "close"):
            shown.close()


class _Given:
    """What the user gave, as a command line of each stage."""

    def __init__(self, subjects: str, output: str, options: Mapping[str, Any], command: Optional[PathLike]) -> None:
        self.subjects, self.output, self.options = subjects, output, options
        self.command = None if command is None else os.path.abspath(os.fsdecode(command))
        # Paths are left as they are, since the files of the study have them.
        self.folder = None if os.path.isabs(subjects) and os.path.isabs(output) else os.getcwd()

    def arguments(self, stage: str, *names: str) -> list[str]:
        values = [f"--{option}={value}" for option, value in self.options.items()]
        output = [f"--output={self.output}"] if self.output else []
        only = [f"--subjects={name}" for name in names]
        return [*output, *values, f"--stage={stage}", *only, "--", self.subjects]

    def require_done(self, report: Mapping[str, Any]) -> None:
        """Raises the error of a report, which begins with the argument that it is about."""
        if not report["exit_code"]:
            return
        file, kind, message = (report["error"][name] for name in ("file", "kind", "message"))
        for option, value in self.options.items():
            if f"--{option}" in message:
                raise exception(kind, f"{option}={value!r}: {message}")
        for argument, value in (("output", self.output), ("subjects", self.subjects)):
            if file == value:
                raise exception(kind, f"{argument}={value!r}: {message}")
        raise exception(kind, f"{file}: {message}" if file else message)


class _Run:
    """One study: its tasks, and what came of them."""

    def __init__(self, given: _Given, workers: Workers, progress: Any, retries: int) -> None:
        self.given, self.workers, self.progress, self.retries = given, workers, progress, retries
        self.phase, self.done, self.total = "", 0, 0
        self.rounding = ""                 # of the machine of the first task
        self.mapped: set[str] = set()      # by a task that has ended well
        self.broken: dict[str, str] = {}   # why the last attempt of a task has no result

    def study(self) -> Study:
        listed = self.alone("listing the subjects", "list")["list"]
        first = self.alone("mapping the first subject", "first")
        finished = {row["name"] for row in [*first["subjects"], *first["failed"]]}
        self.map([row["name"] for row in listed if row["name"] not in finished])
        report = self.group()
        failed = []
        for row in report["failed"]:
            why = self.broken.get(row["name"], row["message"]) if row["kind"] == "no-valid-result" else row["message"]
            failed.append(Failed(row["name"], row["file"], row["kind"], why))
        return Study(self.given.output, report, failed)

    def alone(self, phase: str, stage: str) -> Mapping[str, Any]:
        """A stage that nothing else can be done beside."""
        self.begin(phase, 1)
        for attempt in range(self.retries + 1):
            self.workers.submit(stage, True, self.given.arguments(stage), self.given.command, self.given.folder)
            task = self.next()
            if task.broken is None or attempt == self.retries:
                break
        if task.broken is not None:
            if task.report.get("error", {}).get("kind", "killed") == "killed":
                raise exception("no-valid-result", f"{phase}: {task.broken}")
        self.given.require_done(task.report)
        self.report(1)
        return task.report

    def map(self, names: list[str]) -> None:
        self.begin("mapping the subjects", len(names))
        attempts = dict.fromkeys(names, 0)
        for name in names:
            self.submit(name)
        done = 0
        while done < len(names):
            task = self.next()
            if task.broken is not None and task.again and attempts[task.name] < self.retries:
                attempts[task.name] += 1
                self.submit(task.name)
                continue
            if task.broken is not None:
                self.broken[task.name] = task.broken
            elif task.report["exit_code"]:
                self.given.require_done(task.report)
            else:
                self.mapped.update(row["name"] for row in task.report["subjects"])
            done += 1
            self.report(done)

    def submit(self, name: str) -> None:
        self.workers.submit(name, False, self.given.arguments("subjects", name), self.given.command, self.given.folder)

    def group(self) -> Mapping[str, Any]:
        for pause in (*ARRIVAL, None):
            report = self.alone("analyzing the group", "group")
            absent = [row["name"] for row in report["failed"] if row["kind"] == "no-valid-result" and row["name"] in self.mapped]
            if not absent:
                return report
            if pause is not None:
                time.sleep(pause)
        raise exception("io", f"output={self.given.output!r}: {absent[0]!r} was mapped by a worker, and another does not see its files; "
                              "the folder must be one that all of them share")

    def next(self) -> Finished:
        """The next task that has ended."""
        while True:
            task = self.workers.next(0.1)
            self.report(self.done)
            if task is None:
                continue
            version = task.report.get("version", __version__)
            if version != __version__:
                raise RuntimeError(f"{self.workers.where}: the command has version {version}, this package {__version__}")
            rounding = task.report.get("rounding", self.rounding)
            self.rounding = self.rounding or rounding
            if rounding != self.rounding:
                raise RuntimeError(f"{self.workers.where}: elementary functions round otherwise on the machine of {task.name!r} (digest "
                                   f"{rounding}) than on that of the first task ({self.rounding}), and so would results; a study needs "
                                   "machines with one C library and processors of one kind")
            return task

    def begin(self, phase: str, total: int) -> None:
        self.phase, self.total = phase, total
        self.report(0)

    def report(self, done: int) -> None:
        self.done = done
        if self.progress is not None and self.progress(self.phase, done, self.total, math.nan):
            raise exception("cancelled", f"stopped while {self.phase}: {done} of {self.total}")
