#!/usr/bin/env python3
"""Fails where the README's library table does not name what a library includes of others (base, which all use, is left out).

    libraries.py ROOT
"""

import os
import re
import sys


def used(folder, names):
    found = set()
    for parent, _, files in os.walk(folder):
        for name in files:
            if not name.endswith((".h", ".cpp")):
                continue
            with open(os.path.join(parent, name), encoding="utf-8") as file:
                found.update(re.findall(r'^#include "([a-z_]+)/', file.read(), re.MULTILINE))
    return (found & names) - {os.path.basename(folder), "base"}


def main():
    root = sys.argv[1]
    with open(os.path.join(root, "README.md"), encoding="utf-8") as file:
        rows = re.findall(r"^\| \[`(\w+)`\]\([^)]*\)[^|]*\|[^|]*\|([^|]*)\|", file.read(), re.MULTILINE)
    table = {name: set(re.findall(r"\w+", uses)) - {"base"} for name, uses in rows}
    wrong = []
    for name in sorted(table):
        folder = os.path.join(root, "libs", name)
        own = used(folder, set(table))
        if own != table[name]:
            wrong.append(f"{name} uses {', '.join(sorted(own)) or '-'}; README.md says {', '.join(sorted(table[name])) or '-'}")
    if wrong or len(table) < 10:
        sys.exit("\n".join(wrong) or "README.md has no library table")


main()
