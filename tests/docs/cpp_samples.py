#!/usr/bin/env python3
"""Compiles and runs each C++ program of a page.

    cpp_samples.py PAGE.md LIBRARIES
"""

import glob
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def main():
    page, libraries = sys.argv[1], os.path.abspath(sys.argv[2])
    with open(page, encoding="utf-8") as file:
        programs = re.findall(r"^```cpp\n(.*?)^```", file.read(), re.MULTILINE | re.DOTALL)
    if not programs:
        sys.exit("no C++ in " + page)
    for program in programs:
        with tempfile.TemporaryDirectory() as folder:
            source, executable = os.path.join(folder, "program.cpp"), os.path.join(folder, "program")
            with open(source, "w", encoding="utf-8") as file:
                file.write(program)
            subprocess.run(["c++", "-std=c++17", "-O1", "-Wall", "-Wextra", "-Werror", source, "-o", executable,
                            "-I", os.path.join(ROOT, "capi", "include"), "-I", os.path.join(ROOT, "bindings", "cpp"),
                            *sorted(glob.glob(os.path.join(libraries, "liborbicube-*.so"))), "-Wl,-rpath," + libraries],
                           check=True)
            subprocess.run([executable], check=True, cwd=folder)


if __name__ == "__main__":
    main()
