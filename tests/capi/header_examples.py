#!/usr/bin/env python3
"""The example in the first comment of each public header compiles as C99 without a warning, links and runs.

    header_examples.py INCLUDE LIBRARY.so...     (the headers are those of the libraries)

An example begins after a line ` * Example: ...` and consists of the lines after it that are indented by three blanks.
"""

import os
import re
import subprocess
import sys
import tempfile


def example(text):
    """The program in a header's first comment, or None."""
    comment = text[:text.index("*/")]
    found = re.search(r"^ \* Example:[^\n]*\n(?: \* [^ \n][^\n]*\n)* \*\n((?: \*(?:   [^\n]*)?\n)+)", comment, re.MULTILINE)
    return re.sub(r"(?m)^ \*(   )?", "", found.group(1)) if found else None


def main():
    include, *libraries = sys.argv[1:]
    shared = [os.path.abspath(library) for library in libraries]
    missing = []
    with tempfile.TemporaryDirectory() as folder:
        for library in shared:
            name = re.sub(r"^liborbicube-|\.so.*$", "", os.path.basename(library)).replace("-", "_")
            with open(os.path.join(include, "orbicube", name + ".h"), encoding="utf-8") as file:
                program = example(file.read())
            if program is None:
                missing.append(name)
                continue
            source, executable = os.path.join(folder, name + ".c"), os.path.join(folder, name)
            with open(source, "w", encoding="utf-8") as file:
                file.write(program)
            print(name, flush=True)
            folders = sorted({"-Wl,-rpath," + os.path.dirname(path) for path in shared})
            subprocess.run(["cc", "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", source, "-I", include, *shared, *folders, "-lm", "-o",
                            executable], check=True)
            subprocess.run([executable], check=True, cwd=folder, timeout=120)
    if missing:
        sys.exit("headers without an example: " + ", ".join(missing))


if __name__ == "__main__":
    main()
