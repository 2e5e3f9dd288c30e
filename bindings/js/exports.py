#!/usr/bin/env python3
"""Prints what the WebAssembly module shows: exports.py API.JSON LIBRARY..."""

import json
import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from raw.javascript import LEFT_OUT, functions  # noqa: E402

with open(sys.argv[1], encoding="utf-8") as file:
    libraries = json.load(file)["libraries"]
names = ["malloc", "free"] + [function["name"] for library in sys.argv[2:] if library not in LEFT_OUT
                              for function in functions(libraries[library])]
print("\n".join("_" + name for name in names))
