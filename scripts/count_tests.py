#!/usr/bin/env python3
"""Reads a meson-logs/testlog.json and prints a line a test: passed, skipped or failed, then its name."""

import json
import sys

PASSED = {"OK", "EXPECTEDFAIL"}

with open(sys.argv[1], encoding="utf-8") as log:
    for line in log:
        test = json.loads(line)
        outcome = "passed" if test["result"] in PASSED else "skipped" if test["result"] == "SKIP" else "failed"
        print(outcome, test["name"])
