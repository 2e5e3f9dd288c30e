#!/usr/bin/env python3
"""Compiles and runs the C program in README.md.

    readme.py README.md INCLUDE LIBRARY.so...
"""

import os
import re
import subprocess
import sys
import tempfile


def main():
    readme, include, *libraries = sys.argv[1:]
    with open(readme, encoding="utf-8") as file:
        program = re.search(r"^```c\n(.*?)^```", file.read(), re.MULTILINE | re.DOTALL).group(1)
    with tempfile.TemporaryDirectory() as folder:
        source, executable = os.path.join(folder, "example.c"), os.path.join(folder, "example")
        with open(source, "w", encoding="utf-8") as file:
            file.write(program)
        folders = [os.path.dirname(os.path.abspath(library)) for library in libraries]
        subprocess.run(["cc", "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", source, "-I", include,
                        *[os.path.abspath(library) for library in libraries],
                        *["-Wl,-rpath," + path for path in folders], "-o", executable], check=True)
        printed = subprocess.run([executable], check=True, capture_output=True, text=True).stdout
    # The tip of a shape that is symmetric about the z axis can go anywhere, but it goes to the sphere.
    numbers = [float(number) for number in re.findall(r"-?\d+\.\d+", printed)]
    if len(numbers) != 3 or abs(sum(number * number for number in numbers) - 1) > 0.003:  # printed with three digits
        sys.exit(f"printed what is no unit vector: {printed}")


if __name__ == "__main__":
    main()
