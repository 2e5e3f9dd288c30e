"""The program ends while daemon threads are inside of calls, as programs with windows, notebooks and servers do: exit 0, without
a word. Each work is tried at several moments; ORBICUBE_EXITS changes how many."""

import os
import subprocess
import sys
import threading
import unittest

import numpy as np
from orbicube import mesh, projected_gradient, trust_region

HEAD = """
import sys, threading, time
import numpy as np
sys.path.insert(0, sys.argv[1])
from solids import box_of_tetrahedra
from orbicube import (frame_field, harmonics, hexmesh, mesh, polycube, projected_gradient, sphere_map, sphere_optimizer, tetrahedra,
                      trust_region)
shape = mesh.make("creature", 8000)
solid = box_of_tetrahedra(8)
def slow(x):
    time.sleep(.001)
    return float(((np.asarray(x) - .5) ** 2 * np.arange(1, np.size(x) + 1).reshape(np.shape(x))).sum())
def slow_gradient(x):
    return slow(x), 2 * (np.asarray(x) - .5) * np.arange(1, np.size(x) + 1).reshape(np.shape(x))
def quietly(*_):
    return 0
"""
WORKS = {
    "sphere map": "sphere_map.compute(shape, threads=1)",
    "sphere map on two threads, with progress": "sphere_map.compute(shape, threads=2, progress=quietly)",
    "sphere map with a trace": "sphere_map.compute(shape, trace=quietly)",
    "polycube": "polycube.compute(shape)",
    "hexahedra": "hexmesh.fill_with_hexahedra(shape)",
    "frames": "frame_field.compute(solid)",
    "tetrahedra": "tetrahedra.fill(shape)",
    "search of a shared handle": "search.vertices(points)",
    "locating in a shared handle": "locator.locate(points)",
    "trust_region": "trust_region.minimize(slow, np.zeros(20))",
    "projected_gradient": "projected_gradient.minimize(slow_gradient, np.zeros(20))",
    "sphere_optimizer": "sphere_optimizer.minimize(slow_gradient, np.eye(4)[:, :3] + .1)",
    "a run that is shared": "ask_the_run()",
    "steps of a run with a projection in Python": "steps()",
}
SHARED = """
search = mesh.Search(shape)
points = np.random.default_rng(1).normal(size=(100000, 3))
ball = mesh.make("sphere", 2000)
locator = sphere_map.Locator(ball, ball.positions / np.linalg.norm(ball.positions, axis=1)[:, None])
run = trust_region.Solver(np.zeros(3))
def ask_the_run():
    global run
    x = run.ask()
    if x is None:
        run = trust_region.Solver(np.zeros(3))
    else:
        run.tell(slow(x))
def steps():
    def clip(y):
        time.sleep(.001)
        return np.clip(y, 0, .25)
    solver = projected_gradient.Solver(np.zeros(5), project=clip)
    while solver.ask() is not None:
        solver.tell(*slow_gradient(solver.ask()))
"""
TAIL = """
ready = threading.Event()
def work():
    ready.set()
    while True:
        try:
            {work}
        except Exception as error:
            print(repr(error), file=sys.stderr, flush=True)
            return
for _ in range({threads}):
    threading.Thread(target=work, daemon=True).start()
ready.wait()
time.sleep(float(sys.argv[2]))
"""


class Exit(unittest.TestCase):
    def test_a_program_may_end_while_daemon_threads_are_inside_of_calls(self) -> None:
        folder, times = os.path.dirname(os.path.abspath(__file__)), int(os.environ.get("ORBICUBE_EXITS", "2"))
        for name, work in WORKS.items():
            script = HEAD + (SHARED if "search" in work or "locator" in work or "run" in work or "steps" in work else "")
            # A run is for one thread at a time.
            script += TAIL.replace("{work}", work).replace("{threads}", "1" if "run" in work else "2")
            for i in range(times):
                moment = .02 + .35 * i / times
                with self.subTest(work=name, moment=moment):
                    done = subprocess.run([sys.executable, "-c", script, folder, str(moment)],
                                          capture_output=True, text=True, timeout=120, check=False)
                    self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_a_handle_closed_during_a_call_is_released_when_that_ends(self) -> None:
        inside, go_on = threading.Event(), threading.Event()

        def project(y):
            inside.set()
            go_on.wait(30)
            return np.clip(y, 0, 1)

        solver = projected_gradient.Solver(np.full(3, .5), project=project)
        answers = []
        thread = threading.Thread(target=lambda: answers.append(self._ask_twice(solver)))
        thread.start()
        self.assertTrue(inside.wait(30))
        solver.close()
        self.assertEqual(len(solver._handle._closed), 1)  # not destroyed yet
        go_on.set()
        thread.join(30)
        self.assertEqual(solver._handle._closed, [])
        self.assertEqual(len(answers), 1)

    @staticmethod
    def _ask_twice(solver):
        try:
            x = solver.ask()
            solver.tell(float((x ** 2).sum()), 2 * x)
            return solver.ask()
        except Exception as error:  # noqa: BLE001: of a handle that is gone, as any use after close()
            return error

    def test_a_closed_handle_is_refused_rather_than_used(self) -> None:
        solver = trust_region.Solver(np.zeros(2))
        solver.close()
        solver.close()
        with self.assertRaises((ValueError, RuntimeError)):
            solver.ask()
        search = mesh.Search(mesh.make("sphere", 100))
        search._handle.close()
        with self.assertRaisesRegex(ValueError, "NULL"):
            search.vertices([[0, 0, 0]])


if __name__ == "__main__":
    unittest.main()
