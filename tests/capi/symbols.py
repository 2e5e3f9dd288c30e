#!/usr/bin/env python3
"""Checks a built shared library: exported symbols, soname, what it needs, stack and relocations.

    symbols.py LIBRARY.so MAP SONAME [NEEDED...]

Exported must be exactly the names of the version script MAP. Besides the C and C++ run-time libraries it may need only the
libraries given as NEEDED, by the start of their names.
"""

import re
import subprocess
import sys

RUN_TIME = ["libc.so.", "libm.so.", "libstdc++.so.", "libgcc_s.so.", "libpthread.so.", "ld-linux"]


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def problems(library, version_script, soname, needed_allowed):
    with open(version_script, encoding="utf-8") as file:
        listed = set(re.findall(r"^\s+(obc_\w+);", file.read(), re.MULTILINE))
    symbols = [line.split() for line in output("nm", "-D", "--defined-only", library).splitlines()]
    # Small letters are local, which linkers may leave in the table all the same; A is the name of the version itself.
    exported = {words[2].split("@")[0] for words in symbols if words[1].isupper() and words[1] != "A"}
    for name in sorted(exported - listed):
        yield f"exports {name}, which the version script does not list"
    for name in sorted(listed - exported):
        yield f"does not export {name}, which the version script lists"

    dynamic = output("readelf", "-dW", library)
    if f"Library soname: [{soname}]" not in dynamic:
        yield f"the soname is not {soname}"
    for needed in re.findall(r"\(NEEDED\)\s+Shared library: \[(.*)\]", dynamic):
        if not needed.startswith(tuple(RUN_TIME + needed_allowed)):
            yield f"needs {needed}"
    if "(TEXTREL)" in dynamic:
        yield "has relocations in its code"

    stack = re.search(r"GNU_STACK.*", output("readelf", "-lW", library))
    if not stack:
        yield "has no GNU_STACK: its stack is executable on some systems"
    elif "E" in stack.group().split()[6]:
        yield "has an executable stack"


if __name__ == "__main__":
    found = list(problems(sys.argv[1], sys.argv[2], sys.argv[3], sys.argv[4:]))
    if found:
        sys.exit("\n".join(f"{sys.argv[1]}: {problem}" for problem in found))
