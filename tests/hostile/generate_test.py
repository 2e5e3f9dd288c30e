#!/usr/bin/env python3
"""The table of hostile calls has every function of api.json, and one that it knows no arguments for ends the build.

    generate_test.py API.json
"""
import copy
import json
import os
import re
import subprocess
import sys
import tempfile

GENERATE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "generate.py")


def generated(description):
    """The exit status, the table and what was said."""
    with tempfile.TemporaryDirectory() as folder:
        source, target = os.path.join(folder, "api.json"), os.path.join(folder, "table.cpp")
        with open(source, "w", encoding="utf-8") as file:
            json.dump(description, file)
        done = subprocess.run([sys.executable, GENERATE, source, target, *description["libraries"]], capture_output=True,
                              text=True, check=False)
        text = ""
        if os.path.exists(target):
            with open(target, encoding="utf-8") as file:
                text = file.read()
        return done.returncode, text, done.stderr


with open(sys.argv[1], encoding="utf-8") as api_file:
    api = json.load(api_file)
declared = {function["name"] for library in api["libraries"].values() for function in library["functions"]}
status, table, said = generated(api)
assert status == 0, said
rows = re.findall(r'^      \{"(\w+)", call_(\w+), (?:true|false)\},$', table, re.MULTILINE)
assert [a for a, b in rows] == [b for a, b in rows]
assert len(declared) > 200 and len(rows) == len(declared) and {name for name, _ in rows} == declared
for name in declared:
    assert re.search(rf"\b{name}\((?:arg0|\))", table), f"{name} is not called"

UNKNOWN = [{"name": "what", "type": "const long *"}, {"name": "label", "type": "const char *"},
           {"name": "all", "type": "obc_surface **"}, {"name": "f", "function": {"returns": "void", "parameters": []}}]
for parameter in UNKNOWN:
    changed = copy.deepcopy(api)
    changed["libraries"]["mesh"]["functions"].append(
        {"name": "obc_mesh_new", "returns": "obc_status", "doc": "New.", "parameters": [parameter]})
    status, _, said = generated(changed)
    assert status != 0 and "obc_mesh_new" in said, (parameter, status, said)
changed = copy.deepcopy(api)
changed["libraries"]["mesh"]["functions"].append({"name": "obc_mesh_new", "returns": "long", "doc": "New.", "parameters": []})
assert generated(changed)[0] != 0
print(len(rows), "functions")
