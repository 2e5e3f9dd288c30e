#!/usr/bin/env python3
"""`catch (...)` stands in two places only, each with a handler for the end of a thread before it (libs/base/catch_all.h).

    catch_all_test.py ROOT
"""
import os
import re
import sys

ROOT = sys.argv[1]
PLACES = {"libs/base/catch_all.h", "bindings/cpp/orbicube/base.hpp"}
seen = set()
for top in ("libs", "capi", "cli", "bindings"):
    for folder, _, names in os.walk(os.path.join(ROOT, top)):
        for name in names:
            if not name.endswith((".h", ".hpp", ".cpp")):
                continue
            path = os.path.join(folder, name)
            with open(path, encoding="utf-8") as file:
                text = re.sub(r"//[^\n]*", "", file.read())
            found = len(re.findall(r"catch\s*\(\s*\.\.\.\s*\)", text))
            passed_on = len(re.findall(r"catch \(const abi::__forced_unwind&\)", text))
            if found:
                seen.add(os.path.relpath(path, ROOT))
            if found != passed_on:
                sys.exit(f"{path}: catch (...) swallows the end of a thread: use base::catch_all")
if seen != PLACES:
    sys.exit(f"catch (...) is in {sorted(seen)}, not in {sorted(PLACES)}")
