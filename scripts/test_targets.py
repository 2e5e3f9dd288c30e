#!/usr/bin/env python3
"""Prints the targets of ninja that the tests of a build folder need, but for those of some suites: `scripts/test` builds no others.

    test_targets.py BUILD [SUITE...]
"""
import json
import os
import sys


def main(build, *left_out):
    def read(kind):
        with open(os.path.join(build, "meson-info", f"intro-{kind}.json"), encoding="utf-8") as file:
            return json.load(file)

    needed = set()
    for test in read("tests"):
        if not {suite.split(":")[-1] for suite in test["suite"]} & set(left_out):
            needed.update(test["depends"])
    for target in read("targets"):
        if target["id"] in needed:
            print(*(os.path.relpath(name, os.path.abspath(build)) for name in target["filename"]), sep="\n")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
