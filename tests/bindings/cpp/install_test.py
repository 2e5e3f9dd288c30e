#!/usr/bin/env python3
"""Installs into a staging folder as a distribution does, and builds examples/cpp against it in each way that it shows: with
CMake, with Meson, and with make and pkg-config.

    install_test.py BUILD CMAKE   (CMAKE may be empty: then that way is left out, saying so)
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))


def run(command, **options):
    done = subprocess.run(command, capture_output=True, text=True, check=False, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\nanswered {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done.stdout


def check_targets(cmake, prefix, folder, environment):
    """Each installed library has targets of CMake that its example links, shared and static."""
    files = os.listdir(os.path.join(prefix, "include", "orbicube"))
    names = sorted(name[:-2] for name in files if os.path.exists(os.path.join(ROOT, "examples", "c", name[:-2] + ".c")))
    run([cmake, "-G", "Ninja", "-S", os.path.join(ROOT, "tests", "cmake", "installed"), "-B", folder, f"-DCMAKE_PREFIX_PATH={prefix}",
         f"-DTREE={ROOT}", f"-DPROGRAMS={';'.join(names)}"])
    run([cmake, "--build", folder, "--parallel", "2"])
    texts = {run([os.path.join(folder, name)], env=environment) for name in ("sphere_map", "sphere_map_static")}
    if len(names) < 17 or len(texts) != 1:
        sys.exit(f"the targets of {names} do not return the same: {texts}")


def main():
    build, cmake = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        staging = os.path.join(folder, "staging")
        run(["meson", "install", "-C", build, "--no-rebuild", "--destdir", staging])
        packages = [path for path, _, names in os.walk(staging) if os.path.basename(path) == "pkgconfig"][0]
        libraries = os.path.dirname(packages)
        environment = dict(os.environ, PKG_CONFIG_LIBDIR=packages, PKG_CONFIG_SYSROOT_DIR=staging, LD_LIBRARY_PATH=libraries,
                           LIBRARY_PATH=libraries)
        prefix = [path for path, names, _ in os.walk(staging) if "include" in names][0]
        source = os.path.join(folder, "source")
        shutil.copytree(os.path.join(ROOT, "examples", "cpp"), source)
        printed = {}
        for way, commands in {
            "cmake": [[cmake, "-S", source, "-B", "cmake", f"-DCMAKE_PREFIX_PATH={prefix}"],
                      [cmake, "--build", "cmake"]],
            "meson": [["meson", "setup", "meson", source], ["ninja", "-C", "meson"]],
            "make": [["make", "-C", source]],
        }.items():
            if not commands[0][0]:
                print(f"{way} is missing: not tried")
                continue
            for command in commands:
                run(command, cwd=folder, env=environment)
            place = source if way == "make" else os.path.join(folder, way)
            printed[way] = "".join(run([os.path.join(place, name)], env=environment) for name in ("solvers", "creature"))
        if cmake:
            check_targets(cmake, prefix, os.path.join(folder, "programs"), environment)
        # How often progress is reported depends on the threads' course.
        alike = {re.sub(r"\d+ reports", "reports", text) for text in printed.values()}
        if len(alike) != 1 or "converged" not in printed["make"]:
            sys.exit(f"the ways do not end alike: {printed}")
        print(printed["make"])


if __name__ == "__main__":
    main()
