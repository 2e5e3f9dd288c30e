#!/usr/bin/env python3
"""Writes the version script of a library that has the C functions of several: combined_map.py OUT.map IN.map..."""

import re
import sys

names = []
for path in sys.argv[2:]:
    with open(path, encoding="utf-8") as file:
        node, functions = re.fullmatch(r"(\w+) \{\s*global:\s*([\w;\s]*?)\s*local:\s*\*;\s*\};\s*", file.read()).groups()
    names += functions.split()
with open(sys.argv[1], "w", encoding="utf-8") as file:
    file.write("\n    ".join([node + " {\n  global:", *names]) + "\n  local:\n    *;\n};\n")
