#!/usr/bin/env python3
"""Runs the Python of a page, block after block, as one program in a folder of its own.

    python_samples.py PAGE.md
"""

import os
import re
import sys
import tempfile


def main():
    page = os.path.abspath(sys.argv[1])
    with open(page, encoding="utf-8") as file:
        text = file.read()
    blocks = list(re.finditer(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL))
    if not blocks:
        sys.exit("no Python in " + page)
    names = {"__name__": "__main__"}
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for block in blocks:
            before = text.count("\n", 0, block.start(1))
            exec(compile("\n" * before + block.group(1), page, "exec"), names)  # lines as in the page
        os.chdir("/")


if __name__ == "__main__":
    main()
