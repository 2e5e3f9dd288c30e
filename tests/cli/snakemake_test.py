#!/usr/bin/env python3
"""The example of a study on a batch system ends in the bits of the command, also after its jobs were killed. Skipped where there is
no Snakemake (scripts/dask puts it into build-dask).

    snakemake_test.py COMMAND EXAMPLE
"""
import importlib.util
import os
import shutil
import subprocess
import sys

from command import COMMAND, InFolder, main, run
from folders import files_in

EXAMPLE = os.path.abspath(sys.argv.pop(2))
OPTIONS = ("--grid", "icosphere:2", "--groups", "diagnosis", "--permutations", "99")


class Snakemake(InFolder):
    def snakemake(self, command, *arguments):
        home = {"HOME": self.path("home"), "XDG_CACHE_HOME": self.path("home/cache"), "SNAKEMAKE_PROFILE": ""}
        return subprocess.run([sys.executable, "-m", "snakemake", "--snakefile", os.path.join(EXAMPLE, "Snakefile"), "--profile",
                               os.path.join(EXAMPLE, "slurm"), "--config", "subjects=in/list.csv", "output=out", f"command={command}",
                               "options=" + " ".join(OPTIONS), *arguments],
                              capture_output=True, text=True, cwd=self.folder, env={**os.environ, **home}, check=False)

    def subjects(self):
        os.makedirs(self.path("in"))
        os.makedirs(self.path("home"))
        rows = ["in file.obj,b", "missing.obj,a"]
        with open(self.path("in/in file.obj"), "w", encoding="ascii") as file:
            file.write("nothing\n")
        for seed in range(1, 6):
            self.made("creature", 300, seed, name=f"in/c{seed}.obj")
            rows.append(f"c{seed}.obj,{'ab'[seed % 2]}")
        with open(self.path("in/list.csv"), "w", encoding="ascii") as file:
            file.write("file,diagnosis\n" + "\n".join(rows) + "\n")
        self.assertEqual(run("study", "in/list.csv", "-o", "whole", *OPTIONS, cwd=self.folder).returncode, 0)
        return files_in(self.path("whole"))

    def assert_same(self, whole):
        self.assertEqual({name: data for name, data in files_in(self.path("out")).items() if not name.startswith("jobs")}, whole)

    def test_jobs_end_in_the_bits_of_the_command(self):
        whole = self.subjects()
        done = self.snakemake(COMMAND, "--executor", "local", "--cores", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same(whole)
        again = self.snakemake(COMMAND, "--executor", "local", "--cores", "2")
        self.assertIn("Nothing to be done", again.stdout + again.stderr)
        # A subject that changes is mapped again, and the group after it.
        shutil.copy(self.path("in/c1.obj"), self.path("in/c4.obj"))
        done = self.snakemake(COMMAND, "--executor", "local", "--cores", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(run("study", "in/list.csv", "-o", "whole", *OPTIONS, cwd=self.folder).returncode, 0)
        self.assert_same(files_in(self.path("whole")))

    def test_a_batch_system_runs_jobs_again_that_were_killed(self):
        if importlib.util.find_spec("snakemake_executor_plugin_cluster_generic") is None:
            self.skipTest("there is no snakemake-executor-plugin-cluster-generic")
        whole = self.subjects()
        wrapped = self.path("wrapped")
        with open(wrapped, "w", encoding="utf-8") as file:
            file.write(f"""#!/bin/sh
case "$*" in *--subjects=c3*) if mkdir '{self.path("once")}' 2>/dev/null; then kill -9 $$; fi;; esac
exec '{COMMAND}' "$@"
""")
        os.chmod(wrapped, 0o755)
        # The shell is a batch system with one machine.
        done = self.snakemake(wrapped, "--executor", "cluster-generic", "--cluster-generic-submit-cmd", "sh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(os.path.exists(self.path("once")))
        self.assert_same(whole)


if __name__ == "__main__":
    if importlib.util.find_spec("snakemake") is None:
        print("there is no snakemake (scripts/dask build-dask): its example is not tried")
        sys.exit(77)  # what Meson takes for "skipped"
    main()
