#!/usr/bin/env python3
"""Parts of the package for pages that need little: a folder with a WebAssembly module of a few libraries and the scripts that call it.

    parts.py list                                  prints a line a part: its name, and its libraries, separated by commas
    parts.py exports API.JSON LIBRARY,...          prints what a module of these libraries shows
    parts.py package API.JSON PART FOLDER          makes FOLDER of parts/PART.js and what it imports
"""

import json
import os
import re
import shutil
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "scripts"))
from raw import javascript  # noqa: E402
from raw.c_types import Api  # noqa: E402

PARTS = {
    "trust_region": ["base", "trust_region"],
    "projected_gradient": ["base", "projected_gradient"],
    "sphere_optimizer": ["base", "sphere_optimizer"],
    "sphere_map": ["base", "mesh", "sphere_map"],
}
IMPORT = re.compile(r"^(?:import|export)\b[^;]*?from '\./([a-z_/]+\.js)';", re.MULTILINE | re.DOTALL)
# Made by the build: the module, its glue and what its structs are like.
MADE = {"raw/raw.js"}


def api_of(path, only):
    with open(path, encoding="utf-8") as file:
        whole = json.load(file)
    whole["libraries"] = {name: library for name, library in whole["libraries"].items() if name in only}
    return Api(whole)


def print_exports(path, libraries):
    api = api_of(path, libraries)
    names = ["malloc", "free"] + [function["name"] for library in javascript.parts(api) for function in javascript.functions(library)]
    print("\n".join("_" + name for name in names))


def scripts_of(script):
    """The scripts that one imports, itself included, by their names in the package."""
    found, open_ = {"index.js": script}, [script]
    while open_:
        with open(open_.pop(), encoding="utf-8") as file:
            text = file.read()
        for name in IMPORT.findall(text):
            if name not in found and name not in MADE:
                found[name] = os.path.join(HERE, "src", name)
                open_.append(found[name])
    return found


def exported_names(script):
    with open(script, encoding="utf-8") as file:
        lists = re.findall(r"^export \{([^}]*)\}", file.read(), re.MULTILINE)
    return sorted(name.strip() for names in lists for name in names.split(","))


def make_package(path, part, folder):
    script = os.path.join(HERE, "parts", part + ".js")
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(os.path.join(folder, "raw"))
    for name, source in scripts_of(script).items():
        shutil.copy(source, os.path.join(folder, name))
    api = api_of(path, PARTS[part])
    with open(os.path.join(folder, "raw", "raw.js"), "w", encoding="utf-8") as file:
        file.write(javascript.module(api) + javascript.words(api))
    with open(os.path.join(folder, "index.d.ts"), "w", encoding="utf-8") as file:
        file.write("// What is here of the whole package, with the same names; types of options are those of 'orbicube'.\n"
                   f"export {{ {', '.join(exported_names(script))} }} from '../index.js';\n")


def main():
    verb, arguments = sys.argv[1], sys.argv[2:]
    if verb == "list":
        for part, libraries in PARTS.items():
            print(part, ",".join(libraries))
    elif verb == "exports":
        print_exports(arguments[0], arguments[1].split(","))
    else:
        make_package(*arguments)


if __name__ == "__main__":
    main()
