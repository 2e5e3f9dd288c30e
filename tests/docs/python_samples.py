#!/usr/bin/env python3
"""Runs the Python of a page, block after block, as one program in a folder of its own.

    python_samples.py PAGE.md
"""

import os
import sys
import tempfile

from samples import blocks


def main():
    page = os.path.abspath(sys.argv[1])
    found = list(blocks(page, "python"))
    if not found:
        sys.exit("no Python in " + page)
    names = {"__name__": "__main__"}
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for line, text in found:
            exec(compile("\n" * (line - 1) + text, page, "exec"), names)  # lines as in the page
        os.chdir("/")


if __name__ == "__main__":
    main()
