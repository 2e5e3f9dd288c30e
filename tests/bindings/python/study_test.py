"""orbicube.study: the bits of the command, by processes of this machine and on a Dask cluster, also where a worker or the program
is killed in the middle. What runs on Dask is left out where dask.distributed is not installed.

    study_test.py COMMAND
"""

import logging
import os
import pickle
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import orbicube
from orbicube import study

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "cli"))
from folders import files_in  # noqa: E402

try:
    import distributed
except ImportError:
    distributed = None

COMMAND = os.path.abspath(sys.argv[1]) if len(sys.argv) > 1 else ""
COUNT = 12
OPTIONS = {"grid": "icosphere:2", "groups": "diagnosis", "permutations": 99}


def run(*arguments):
    subprocess.run([COMMAND, *arguments], check=True, stdout=subprocess.DEVNULL)


class InFolder(unittest.TestCase):
    """Twelve subjects and two that cannot be mapped, the first one of them, and what the command makes of them."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp(prefix="orbicube-study-")
        os.environ["ORBICUBE_COMMAND"] = COMMAND
        os.mkdir(cls.path("in"))
        rows = ["torus.obj,control"]
        run("make", "torus", "-o", cls.path("in/torus.obj"), "--resolution", "300")
        for i in range(1, COUNT + 1):
            run("make", "creature", "-o", cls.path(f"in/c{i:02}.obj"), "--resolution", "300", "--seed", str(i))
            rows.append(f"c{i:02}.obj,{'patient' if i % 2 else 'control'}")
        rows.append("missing.obj,patient")
        with open(cls.path("in/list.csv"), "w", encoding="ascii") as file:
            file.write("file,diagnosis\n" + "\n".join(rows) + "\n")
        cls.list = cls.path("in/list.csv")
        run("study", cls.list, "-o", cls.path("whole"), "--threads", "1", *cls.words())
        run("study", cls.list, "-o", cls.path("other"), "--threads", "2", *cls.words())
        cls.whole = files_in(cls.path("whole"))
        assert files_in(cls.path("other")) == cls.whole and len(cls.whole) == 2 * COUNT + 1 + 8, sorted(cls.whole)

    @staticmethod
    def words():
        return [word for name, value in OPTIONS.items() for word in (f"--{name}", str(value))]

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder, name)

    def setUp(self):
        shutil.rmtree(self.path("out"), ignore_errors=True)
        shutil.rmtree(self.path("once"), ignore_errors=True)

    def wrapped(self, text):
        """A program in the place of the command: `text` of the shell runs before it, with its arguments."""
        path = self.path("wrapped")
        with open(path, "w", encoding="utf-8") as file:
            file.write(f"#!/bin/sh\nonce() {{ mkdir '{self.path('once')}' 2>/dev/null; }}\n"
                       f"{text}\nexec '{COMMAND}' \"$@\"\n")
        os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)
        return path

    def assert_whole(self, result):
        self.assertEqual(files_in(self.path("out")), self.whole)
        self.assertEqual(result.names, [f"c{i:02}" for i in range(1, COUNT + 1)])
        self.assertEqual([(f.name, f.kind) for f in result.failed], [("torus", "wrong-genus"), ("missing", "io")])


KILL_PARENT_ONCE = 'case "$*" in *--subjects=c05*) if once; then kill -9 $PPID; fi;; esac'
KILL_ONCE = 'case "$*" in *--subjects=c05*) if once; then kill -9 $$; fi;; esac'
KILL_ALWAYS = 'case "$*" in *--subjects=c05*) kill -9 $$;; esac'
ELSEWHERE = 'case "$*" in *--subjects=c05*) export GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-FMA_Usable,-AVX2,-AVX2_Usable,-FMA4,-FMA4_Usable;; esac'
LOSE = f"""case "$*" in *--subjects=c05*) '{COMMAND}' "$@"; code=$?; rm "$out"/subjects/c05.*; exit $code;; esac"""


class Local(InFolder):
    def run_study(self, **options):
        return study.run(self.list, self.path("out"), **{**OPTIONS, "processes": 2, **options})

    def test_the_bits_of_the_command(self):
        result = self.run_study()
        self.assert_whole(result)
        self.assertEqual(pickle.loads(pickle.dumps(result)), result)
        distances, scores = result.distances, result.scores
        self.assertEqual(distances.shape, (COUNT, COUNT))
        self.assertTrue((distances == distances.T).all())
        apart = np.linalg.norm(scores[:, None] - scores[None], axis=2) / np.sqrt(162)
        self.assertLess(abs(apart - distances).max(), 1e-9)
        mean = np.mean([result.subject(name).positions.mean(axis=0) for name in result.names], axis=0)
        self.assertEqual(result.mean.positions.shape, (162, 3))
        self.assertTrue(np.isfinite(mean).all())
        self.assertEqual(result.report["groups"]["values"], ["control", "patient"])
        self.assertTrue(set(result.outliers) <= set(result.names))
        self.assertTrue(os.path.exists(result.page))
        with self.assertRaisesRegex(ValueError, "name='c13': one of 'c01'"):
            result.subject("c13")
        # Done before: nothing is mapped again. Other processes, other threads: the same.
        written = os.stat(self.path("out/subjects/c05.json")).st_ino
        self.assert_whole(self.run_study(processes=1, threads=2))
        self.assertEqual(os.stat(self.path("out/subjects/c05.json")).st_ino, written)

    def test_paths_stay_as_they_are(self):
        before = os.getcwd()
        os.chdir(self.folder)
        try:
            run("study", "in/list.csv", "-o", "relative", *self.words())
            self.assertEqual(study.subjects("in/list.csv")[:2], [("torus", "in/torus.obj"), ("c01", "in/c01.obj")])
            study.run("in/list.csv", "out/", processes=2, **OPTIONS)
        finally:
            os.chdir(before)
        self.assertEqual(files_in(self.path("out")), files_in(self.path("relative")))

    def test_a_killed_program_continues(self):
        program = ("import sys; from orbicube import study; "
                   f"study.run(sys.argv[1], sys.argv[2], processes=1, command=sys.argv[3], **{OPTIONS!r})")
        done = subprocess.run([sys.executable, "-c", program, self.list, self.path("out"), self.wrapped(KILL_PARENT_ONCE)], check=False)
        self.assertEqual(done.returncode, -signal.SIGKILL)
        before = {name: os.stat(self.path(f"out/subjects/{name}.json")).st_ino for name in ("torus", "c01", "c02", "c03", "c04")}
        self.assertFalse(os.path.exists(self.path("out/study.html")))
        self.assert_whole(self.run_study())
        for name, number in before.items():
            self.assertEqual(os.stat(self.path(f"out/subjects/{name}.json")).st_ino, number)

    def test_a_killed_command_is_tried_again(self):
        self.assert_whole(self.run_study(command=self.wrapped(KILL_ONCE)))
        shutil.rmtree(self.path("out"))
        result = self.run_study(command=self.wrapped(KILL_ALWAYS), retries=1)
        self.assertEqual([(f.name, f.kind, f.message) for f in result.failed],
                         [("torus", "wrong-genus", result.failed[0].message), ("c05", "no-valid-result", "killed: the command was killed by SIGKILL"),
                          ("missing", "io", result.failed[2].message)])
        self.assertEqual(len(result.names), COUNT - 1)
        with self.assertRaisesRegex(orbicube.NoValidResult, "mapping the first subject: killed: the command was killed by SIGKILL"):
            study.run(self.list, self.path("none"), command=self.wrapped('case "$*" in *--stage=first*) kill -9 $$;; esac'), **OPTIONS)

    def test_machines_that_round_otherwise_are_refused(self):
        with self.assertRaisesRegex(RuntimeError, "command: elementary functions round otherwise on the machine of 'first' .digest 12ab"):
            self.run_study(command=self.wrapped("""case "$*" in *--stage=first*) echo '{"exit_code": 0, "rounding": "12ab"}' > "${3#--report=}"; exit;; esac"""))
        try:
            self.assert_whole(self.run_study(command=self.wrapped(ELSEWHERE)))  # where glibc has no other functions
        except RuntimeError as error:
            self.assertRegex(str(error), "elementary functions round otherwise on the machine of 'c05' ")
        shutil.rmtree(self.path("out"))
        self.assert_whole(self.run_study())

    def test_a_folder_that_is_not_shared_is_found(self):
        waits, study.ARRIVAL = study.ARRIVAL, (0,)
        try:
            with self.assertRaisesRegex(orbicube.FileError, "output='.*/out': 'c05' was mapped by a worker, and another does not see"):
                self.run_study(command=self.wrapped(f"out='{self.path('out')}'\n{LOSE}"))
        finally:
            study.ARRIVAL = waits

    def test_progress_is_reported_and_stops_it(self):
        seen = []
        self.run_study(progress=lambda *report: seen.append(report))
        phases = list(dict.fromkeys(phase for phase, *_ in seen))
        self.assertEqual(phases, ["listing the subjects", "mapping the first subject", "mapping the subjects", "analyzing the group"])
        for phase in phases:
            done = [(a, b) for name, a, b, _ in seen if name == phase]
            self.assertEqual(done, sorted(done))
            self.assertEqual(done[-1][0], done[-1][1])
        shutil.rmtree(self.path("out"))
        with self.assertRaisesRegex(orbicube.Cancelled, "stopped while mapping the subjects: [0-9]+ of 12"):
            self.run_study(progress=lambda phase, *_: phase == "mapping the subjects")
        self.assertFalse(os.path.exists(self.path("out/study.html")))
        self.assert_whole(self.run_study())

    def test_errors_begin_with_the_argument(self):
        for error, message, options in (
                (orbicube.InvalidArgument, "groups='age': ", {"groups": "age"}),
                (orbicube.InvalidArgument, "grid='icosaeder:2': ", {"grid": "icosaeder:2"}),
                (ValueError, "align='shap': one of 'shape', 'rotation', 'none' is needed; did you mean 'shape'", {"align": "shap"}),
                (ValueError, "modes=101: out of range, 0 to 100", {"modes": 101}),
                (ValueError, "permutations=9: they are for groups and covariate", {"permutations": 9, "groups": None}),
                (TypeError, "no argument 'group'; did you mean 'groups'", {"group": "age"}),
                (TypeError, "client: a dask.distributed.Client is needed, not str", {"client": "tcp://scheduler:8786", "processes": 0}),
                (ValueError, "processes=2: they are for a study without client", {"client": object()}),
                (FileNotFoundError, "/none/orbicube", {"command": "/none/orbicube"}),
                (orbicube.InvalidArgument, "label=3: ", {"label": 3}),
                (ValueError, "retries=-1", {"retries": -1})):
            with self.subTest(message=message), self.assertRaises(error) as caught:
                self.run_study(**options)
            self.assertIn(message, str(caught.exception))
        with self.assertRaisesRegex(orbicube.FileError, "subjects='/none': "):
            study.run("/none", self.path("out"))
        with self.assertRaisesRegex(orbicube.FileError, "output='/none/out': "):
            study.run(self.list, "/none/out", **OPTIONS)
        with self.assertRaisesRegex(orbicube.InvalidArgument, "output='.*/in': .*give another"):
            study.run(self.path("in"), self.path("in"))
        with self.assertRaisesRegex(RuntimeError, "command: the command has version 0.0.9, this package 0.1.0"):
            self.run_study(command=self.wrapped("""echo '{"exit_code": 0, "version": "0.0.9"}' > "${3#--report=}"; exit"""))
        found = os.environ.pop("ORBICUBE_COMMAND"), os.environ["PATH"]
        try:
            os.environ["PATH"] = "/none"
            if not shutil.which("orbicube", path=os.path.dirname(sys.executable)):
                with self.assertRaisesRegex(FileNotFoundError, "ORBICUBE_COMMAND"):
                    self.run_study()
        finally:
            os.environ["ORBICUBE_COMMAND"], os.environ["PATH"] = found


@unittest.skipIf(distributed is None, "there is no dask.distributed (scripts/dask build-dask)")
class Dask(InFolder):
    def setUp(self):
        super().setUp()
        self.cluster = distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None,
                                                silence_logs=logging.CRITICAL)
        self.client = distributed.Client(self.cluster)

    def tearDown(self):
        if self.client.status == "running":
            self.client.close()
        self.cluster.close()

    def run_study(self, **options):
        return study.run(self.list, self.path("out"), client=self.client, **{**OPTIONS, **options})

    def pids(self):
        return {worker["pid"] for worker in self.client.run(lambda: {"pid": os.getpid()}).values()}

    def test_a_killed_worker_changes_nothing(self):
        before = self.pids()
        self.assertEqual(len(before), 2)
        self.assert_whole(self.run_study(command=self.wrapped(KILL_PARENT_ONCE)))
        self.assertTrue(os.path.exists(self.path("once")))
        self.client.wait_for_workers(2)
        self.assertEqual(len(before - self.pids()), 1)

    def test_a_subject_that_kills_its_workers_is_left_out(self):
        result = self.run_study(command=self.wrapped('case "$*" in *--subjects=c05*) kill -9 $PPID; exit 1;; esac'))
        self.assertEqual([(f.name, f.kind) for f in result.failed], [("torus", "wrong-genus"), ("c05", "no-valid-result"), ("missing", "io")])
        self.assertRegex(result.failed[1].message, "^killed: ")
        self.assert_whole(self.run_study())

    def test_what_is_stopped_continues(self):
        with self.assertRaises(orbicube.Cancelled):
            self.run_study(progress=lambda phase, done, *_: phase == "mapping the subjects" and done >= 3)
        kept = {name: os.stat(self.path(f"out/subjects/{name}")).st_ino for name in os.listdir(self.path("out/subjects"))
                if name.endswith(".json")}
        self.assertGreaterEqual(len(kept), 5)  # torus, the first one and three
        self.assert_whole(self.run_study())
        for name, number in kept.items():
            self.assertEqual(os.stat(self.path(f"out/subjects/{name}")).st_ino, number)

    def test_mistakes_are_of_the_user(self):
        with self.assertRaisesRegex(orbicube.InvalidArgument, "groups='age': "):
            self.run_study(groups="age")
        with self.assertRaisesRegex(RuntimeError, "client: a task cannot be run there: FileNotFoundError: /none/orbicube"):
            self.run_study(command="/none/orbicube")
        self.client.close()
        with self.assertRaisesRegex(ValueError, "client: it is closed, not running"):
            self.run_study()


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
