#!/usr/bin/env python3
"""The files of one run: all of them are new, or all are old, whatever ends it; and nobody can put a link in their way.

    outputs_test.py COMMAND
"""
import os
import re
import resource
import signal
import stat
import subprocess
import time

from command import COMMAND, InFolder, kind_of, main, read_obj, run

LEFT = re.compile(r"\.orbicube-tmp-[0-9a-v]{26}$")


def limited_files():
    """Files of more than 40 KB cannot be written."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (40_000, 40_000))


class Outputs(InFolder):
    def setUp(self):
        super().setUp()
        self.shape = self.made("creature", 3000)
        self.names = {name: self.path(name) for name in ("map.obj", "page.html", "remesh.obj", "image.png", "report.json")}

    def arguments(self):
        n = self.names
        return ("sphere", self.shape, "-o", n["map.obj"], "--page", n["page.html"], "--remesh", n["remesh.obj"],
                "--grid", "icosphere:5", "--image", n["image.png"], "--image-grid", "octahedron:64")

    def old(self, *names):
        for name in names or self.names:
            with open(self.names[name], "wb") as file:
                file.write(b"old " + name.encode())

    def states(self, names):
        """Which are old, none of them being neither old nor new."""
        result = []
        for name in names:
            with open(self.names[name], "rb") as file:
                content = file.read()
            result.append(content == b"old " + name.encode())
            self.assertTrue(result[-1] or content == self.new[name], name)
        return result

    def remember(self):
        done = run(*self.arguments())
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.new = {}
        for name, path in self.names.items():
            if name == "report.json":
                continue
            with open(path, "rb") as file:
                self.new[name] = file.read()

    def test_a_run_that_is_stopped_at_any_time_leaves_all_old_or_all_new(self):
        self.remember()
        start = time.monotonic()
        self.assertEqual(run(*self.arguments()).returncode, 0)
        whole = time.monotonic() - start
        stopped = 0
        for step in range(30):
            self.old(*self.new)
            # Times at which reports come, over the whole run; the limit is asked at each of them.
            done = run(*self.arguments(), "--time-limit", f"{max(1e-4, whole * step / 29):.6f}")
            states = self.states(self.new)
            self.assertEqual(states, [done.returncode != 0] * len(states), done.stderr)
            stopped += done.returncode != 0
            if done.returncode != 0:
                self.assertEqual(kind_of(done.stderr.strip(), self.shape), "time-limit")
                self.assertNotIn("wrote", done.stdout)
            self.assertFalse([name for name in os.listdir(self.folder) if LEFT.search(name)])
        self.assertGreater(stopped, 3)

    def test_a_killed_run_leaves_old_files_and_the_next_one_clears_up(self):
        self.remember()
        left = 0
        for step in range(20):
            self.old(*self.new)
            with subprocess.Popen([COMMAND, *self.arguments()], stdout=subprocess.DEVNULL) as process:
                # Killed as soon as it has begun to write, or a little later.
                while process.poll() is None and not any(LEFT.search(name) for name in os.listdir(self.folder)):
                    time.sleep(0.001)
                time.sleep(0.01 * step)
                process.kill()
                process.wait()
            self.states(self.new)  # each is whole
            left += any(LEFT.search(name) for name in os.listdir(self.folder))
            done = run(*self.arguments())
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertFalse([name for name in os.listdir(self.folder) if LEFT.search(name)])
            self.assertEqual(self.states(self.new), [False] * len(self.new))
        self.assertGreater(left, 0)

    def test_a_file_that_cannot_be_written_keeps_all_others_from_their_places(self):
        self.remember()
        for name in self.new:
            self.old(*self.new)
            full = self.path("full" + os.path.splitext(name)[1])
            os.symlink("/dev/full", full)
            kept = self.names[name]
            self.names[name] = full
            done = run(*self.arguments())
            self.names[name] = kept
            os.remove(full)
            self.assertEqual(done.returncode, 1)
            self.assertEqual(kind_of(done.stderr.strip(), full), "io")
            self.assertEqual(self.states(self.new), [True] * len(self.new))
            self.assertEqual(done.stdout, "")
        # The page is larger than the limit, the map, which is written first, is not.
        small = self.made("sphere", 300)
        self.old()
        done = run("sphere", small, "-o", self.names["map.obj"], "--page", self.names["page.html"],
                   preexec_fn=limited_files)
        self.assertEqual((done.returncode, kind_of(done.stderr.strip(), self.names["page.html"])), (1, "io"))
        for name in ("map.obj", "page.html"):
            with open(self.names[name], "rb") as file:
                self.assertEqual(file.read(), b"old " + name.encode())

    def test_a_place_that_takes_no_file_gives_the_others_their_old_content_back(self):
        self.remember()
        self.old(*self.new)
        busy = self.path("busy")
        with open(busy, "wb") as file:
            file.write(b"busy")
        os.remove(self.names["remesh.obj"])  # and one that was not there is not there afterwards
        mounted = subprocess.run(["mount", "--bind", busy, self.names["image.png"]], capture_output=True, check=False)
        if mounted.returncode != 0:
            self.skipTest("no right to mount a file on another, which is what keeps it from being replaced")
        try:
            self.refused(1, "io", self.names["image.png"], *self.arguments())
        finally:
            subprocess.run(["umount", self.names["image.png"]], check=True)
        self.assertFalse(os.path.exists(self.names["remesh.obj"]))
        self.assertEqual(self.states([n for n in self.new if n != "remesh.obj"]), [True] * 3)
        self.assertFalse([name for name in os.listdir(self.folder) if LEFT.search(name)])

    def test_two_outputs_with_one_place_are_refused(self):
        self.old()
        done = run("sphere", self.shape, "-o", self.names["map.obj"], "--remesh", self.names["map.obj"])
        self.assertEqual((done.returncode, kind_of(done.stderr.strip(), self.names["map.obj"])), (2, "usage"))
        with open(self.names["map.obj"], "rb") as file:
            self.assertEqual(file.read(), b"old map.obj")

    def seen_names(self, out):
        """Names that stood beside OUT while the command wrote it."""
        seen = set()
        with subprocess.Popen([COMMAND, "make", "creature", "-o", out, "--resolution", "100000"],
                              stdout=subprocess.DEVNULL) as process:
            while process.poll() is None:
                for name in os.listdir(os.path.dirname(out)):
                    if LEFT.search(name):
                        seen.add(name)
                        try:
                            facts = os.lstat(os.path.join(os.path.dirname(out), name))
                        except FileNotFoundError:  # in its place by now
                            continue
                        # Others can neither look in nor lay anything there.
                        self.assertTrue(stat.S_ISDIR(facts.st_mode))
                        self.assertEqual(facts.st_mode & 0o077, 0)
        self.assertEqual(process.returncode, 0)
        return seen

    def test_names_do_not_repeat_and_links_of_the_former_scheme_are_not_followed(self):
        out, victim = self.path("out.obj"), self.path("victim")
        with open(victim, "wb") as file:
            file.write(b"precious")
        with open("/proc/loadavg", encoding="ascii") as file:
            latest = int(file.read().split()[-1])
        planted = [f"out.tmp-{pid}.obj" for pid in range(latest, latest + 300)]
        for name in planted:
            os.symlink(victim, self.path(name))
        first, second = self.seen_names(out), self.seen_names(out)
        self.assertTrue(first and second)
        self.assertFalse(first & second)
        with open(victim, "rb") as file:
            self.assertEqual(file.read(), b"precious")
        for name in planted:
            self.assertEqual(os.readlink(self.path(name)), victim)
        self.assertGreater(len(read_obj(out)[1]), 0)


if __name__ == "__main__":
    main()
