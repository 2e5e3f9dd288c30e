#!/usr/bin/env python3
"""Writes the raw layers of the bindings, which are the C functions as they are, from api.json.

    scripts/bindings.py           writes what changed: Python's modules, Rust's orbicube-sys, Julia's ccalls,
                                   JavaScript's layouts and types, layouts.c
    scripts/bindings.py --check   changes nothing; fails when writing would change something
    scripts/bindings.py --defaults build/capi
                                   first records what the libraries there fill options with, as the signatures of Python show it

The layers that people use (bindings/python/orbicube/*.py and so on) are written by hand on top of them, but for the options
in the signatures of Python's functions: see raw/python_options.py.
"""

import argparse
import glob
import json
import os
import sys

sys.dont_write_bytecode = True
from raw import javascript, julia, layouts, python, python_options, rust  # noqa: E402
from raw.c_types import Api  # noqa: E402

# Folders with nothing in them but generated files: what lies there and is not written is out of date.
OWNED = ["bindings/python/orbicube/raw/*.py*", "bindings/julia/src/raw/*.jl", "bindings/rust/orbicube-sys/src/*.rs",
         "bindings/js/raw/*"]


def generated_files(api, root):
    result = python_options.files(api, root)
    for writer in (python, rust, julia, javascript, layouts):
        result.update(writer.files(api))
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--root", default=os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--defaults", metavar="FOLDER")
    arguments = parser.parse_args()
    with open(os.path.join(arguments.root, "api.json"), encoding="utf-8") as file:
        api = Api(json.load(file))
    if arguments.defaults:
        python_options.record_defaults(api, arguments.root, arguments.defaults)
    wanted = generated_files(api, arguments.root)
    problems = []
    for pattern in OWNED:
        for path in glob.glob(os.path.join(arguments.root, pattern)):
            name = os.path.relpath(path, arguments.root)
            if name not in wanted:
                if arguments.check:
                    problems.append(f"{name}: of no header; run scripts/bindings.py")
                else:
                    os.remove(path)
                    print(f"removed {name}")
    for name, text in wanted.items():
        path = os.path.join(arguments.root, name)
        old = None
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                old = file.read()
        if old == text:
            continue
        if arguments.check:
            problems.append(f"{name}: not what the headers say; run scripts/bindings.py")
            continue
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        print(f"wrote {name}")
    if problems:
        sys.exit("\n".join(problems))


if __name__ == "__main__":
    main()
