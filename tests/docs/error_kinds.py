#!/usr/bin/env python3
"""The page of statuses and kinds has each row of libs/base/error.cpp and of <orbicube/base.h>, and no others.

    error_kinds.py ROOT
"""

import os
import re
import sys


def read(*path):
    with open(os.path.join(sys.argv[1], *path), encoding="utf-8") as file:
        return file.read()


def main():
    page = read("docs", "error_kinds.md")
    statuses = set(re.findall(r"^\| `(OBC_\w+)` \| (-?\d+) \|", page, re.MULTILINE))
    kinds = set(re.findall(r"^\| `([a-z-]+)` \| `OBC_(\w+)` \|", page, re.MULTILINE))
    declared = set(re.findall(r"^  (OBC_\w+) = (-?\d+),?", read("capi", "include", "orbicube", "base.h"), re.MULTILINE))
    table = {(kind, status.upper())
             for kind, status in re.findall(r'std::pair\{"([a-z-]+)", Status::(\w+)\}', read("libs", "base", "error.cpp"))}
    if len(table) < 30 or len(declared) < 10:
        sys.exit("the tables of the sources were not understood")
    wrong = sorted(str(row) for row in (statuses ^ declared) | (kinds ^ table))
    if wrong:
        sys.exit("docs/error_kinds.md and the sources differ in " + ", ".join(wrong))


if __name__ == "__main__":
    main()
