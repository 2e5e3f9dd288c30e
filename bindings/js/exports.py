#!/usr/bin/env python3
"""Prints what the WebAssembly module shows: exports.py API.JSON LIBRARY..."""

import json
import sys

with open(sys.argv[1], encoding="utf-8") as file:
    libraries = json.load(file)["libraries"]
names = ["malloc", "free"] + [function["name"] for library in sys.argv[2:] for function in libraries[library]["functions"]]
print("\n".join("_" + name for name in names))
