#!/usr/bin/env python3
"""Builds programs together with libraries by CMake, without Meson, and runs them.

    without_meson_test.py CMAKE FOLDER [--generate-all] [LIBRARY...] [-- OPTION...]

FOLDER is emptied first. Without a LIBRARY: trust_region. --generate-all also generates the build files of all libraries that CMake can
build, together and in both ways, without compiling them. By hand also with other libraries, and with options of CMake such as
-DBUILD_SHARED_LIBS=ON or -DFETCH=ON.
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


def buildable():
    """The libraries that CMake can build besides base, which has no program of its own here."""
    folders = os.path.join(ROOT, "libs")
    return sorted(name for name in os.listdir(folders) if name != "base" and os.path.exists(os.path.join(folders, name, "CMakeLists.txt")))


def generate(cmake, folder, libraries, options):
    # Emptied here, since CMake keeps variables of the last run in its cache.
    shutil.rmtree(folder, ignore_errors=True)
    environment = dict(os.environ)
    if shutil.which("ccache"):
        environment |= {"CMAKE_C_COMPILER_LAUNCHER": "ccache", "CMAKE_CXX_COMPILER_LAUNCHER": "ccache"}
    if shutil.which("ninja"):
        environment["CMAKE_GENERATOR"] = "Ninja"
    run([cmake, "-S", os.path.join(HERE, "without_meson"), "-B", folder, f"-DTREE={ROOT}", f"-DPROGRAMS={';'.join(libraries)}", *options],
        env=environment)


def main():
    cmake, folder, *rest = sys.argv[1:]
    libraries, options = (rest[:rest.index("--")], rest[rest.index("--") + 1:]) if "--" in rest else (rest, [])
    all_generated = "--generate-all" in libraries
    libraries = [name for name in libraries if name != "--generate-all"] or ["trust_region"]
    if all_generated:
        for way in ("-DFETCH=OFF", "-DFETCH=ON", "-DBUILD_SHARED_LIBS=ON"):
            generate(cmake, folder, buildable(), [way])
    # One file of all sources is compiled four times as fast, where no two of them have a local name in common.
    one_file = "ON" if set(libraries) <= {"trust_region", "quaternion"} else "OFF"
    generate(cmake, folder, libraries, ["-DCMAKE_UNITY_BUILD=ON", "-DORBICUBE_UNITY_BUILD=" + one_file, "-DCMAKE_UNITY_BUILD_BATCH_SIZE=0", *options])
    run([cmake, "--build", folder, "--parallel", "2", "--target", *libraries])
    for name in libraries:
        print(run([os.path.join(folder, name)]))


if __name__ == "__main__":
    main()
