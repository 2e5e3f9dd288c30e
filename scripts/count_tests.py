#!/usr/bin/env python3
"""Reads a meson-logs/testlog.json and prints a line a test: passed, skipped or failed, then its name.

    count_tests.py [--seconds] LOG

With --seconds it prints a line a suite instead: its number of tests and the sum of their seconds, the longest first.
"""

import collections
import json
import sys

PASSED = {"OK", "EXPECTEDFAIL"}

with open(sys.argv[-1], encoding="utf-8") as log:
    tests = [json.loads(line) for line in log]
if "--seconds" in sys.argv:
    seconds = collections.defaultdict(list)
    for test in tests:
        # Meson's log has no field for suites: it writes "orbicube:SUITE+SUITE / name". A test counts in its last suite.
        suites = test["name"].split(" / ")[0].split(":")[-1]
        seconds[suites.split("+")[-1]].append(test["duration"])
    for suite, durations in sorted(seconds.items(), key=lambda entry: -sum(entry[1])):
        print(f"{suite:20} {len(durations):4} tests {sum(durations):8.0f} s")
else:
    for test in tests:
        outcome = "passed" if test["result"] in PASSED else "skipped" if test["result"] == "SKIP" else "failed"
        print(outcome, test["name"])
