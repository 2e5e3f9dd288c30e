#!/usr/bin/env python3
"""Builds a program together with the library trust_region by CMake, without Meson, and runs it.

    without_meson_test.py CMAKE FOLDER [LIBRARY...] [-- OPTION...]

FOLDER is emptied first. By hand also with other libraries, and with options of CMake such as -DBUILD_SHARED_LIBS=ON or -DFETCH=ON.
"""

import os
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))


def run(command, **options):
    done = subprocess.run(command, capture_output=True, text=True, check=False, **options)
    if done.returncode != 0 or "warning" in done.stdout.lower() + done.stderr.lower():
        sys.exit(f"{' '.join(command)}\nreturned {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done.stdout


def main():
    cmake, folder, *rest = sys.argv[1:]
    libraries, options = (rest[:rest.index("--")], rest[rest.index("--") + 1:]) if "--" in rest else (rest, [])
    libraries = libraries or ["trust_region"]
    shutil.rmtree(folder, ignore_errors=True)
    # One file of all sources is compiled four times as fast.
    options = ["-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=0", *options]
    environment = dict(os.environ)
    if shutil.which("ccache"):
        environment |= {"CMAKE_C_COMPILER_LAUNCHER": "ccache", "CMAKE_CXX_COMPILER_LAUNCHER": "ccache"}
    if shutil.which("ninja"):
        environment["CMAKE_GENERATOR"] = "Ninja"
    run([cmake, "-S", os.path.join(HERE, "without_meson"), "-B", folder, f"-DTREE={ROOT}", f"-DPROGRAMS={';'.join(libraries)}", *options],
        env=environment)
    run([cmake, "--build", folder, "--parallel", "2", "--target", *libraries], env=environment)
    for name in libraries:
        print(run([os.path.join(folder, name)]))


if __name__ == "__main__":
    main()
