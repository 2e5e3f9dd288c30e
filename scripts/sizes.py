#!/usr/bin/env python3
"""Prints the largest files, functions and folders of libs/ and cli/.

    scripts/sizes.py           the ten largest of each
    scripts/sizes.py --check   exits with 1 where one is over its limit

Limits: a file has at most 400 lines, a function 60, a folder 25 source files. The code is formatted, so that a function ends at
the first closing brace with the indentation of its opening line.
"""

import argparse
import os
import re
import sys

FILE_LINES, FUNCTION_LINES, FOLDER_FILES = 400, 60, 25
# A line that does not belong to the signature below it: the end of something else, a comment, a template's first line.
NO_SIGNATURE = re.compile(r"[;{}:>]$|^\s*(//|#|})")
NO_FUNCTION = re.compile(r"\s*(namespace|struct|class|enum|union|if|for|while|switch|else|do|try|catch|return|extern)\b|\s*[})]|.*=\s*\{$")


def first_line(lines, last):
    """The line on which a signature begins whose body opens at the end of line `last`, past its list of initializers."""
    first = last
    while first > 0 and lines[first - 1].strip() and not NO_SIGNATURE.search(lines[first - 1]):
        first -= 1
    return first


def functions(lines):
    """Yields (first line, number of lines, name) of each function with a body, also within classes."""
    i = 0
    while i < len(lines):
        first = first_line(lines, i) if lines[i].endswith("{") else i
        indent = len(lines[first]) - len(lines[first].lstrip())
        if not lines[i].endswith("{") or indent > 4 or NO_FUNCTION.match(lines[first]):
            i += 1
            continue
        found = re.search(r"([~\w:<>]+(?:operator\S+)?)\s*\(", " ".join(lines[first : i + 1]))
        end = next((j for j in range(i + 1, len(lines)) if lines[j].startswith(" " * indent + "}")), len(lines) - 1)
        if found:
            yield first + 1, end - first + 1, found.group(1)
            i = end
        i += 1


def measure(root):
    files, made, folders = [], [], {}
    for top in ("libs", "cli"):
        for folder, _, names in os.walk(os.path.join(root, top)):
            sources = [name for name in sorted(names) if name.endswith((".cpp", ".h"))]
            folders[os.path.relpath(folder, root)] = len(sources)
            for name in sources:
                path = os.path.relpath(os.path.join(folder, name), root)
                with open(os.path.join(root, path), encoding="utf-8") as file:
                    lines = file.read().splitlines()
                files.append((len(lines), path))
                made += [(length, f"{path}:{first} {title}") for first, length, title in functions(lines)]
    return (("lines of a file", FILE_LINES, files), ("lines of a function", FUNCTION_LINES, made),
            ("source files in a folder", FOLDER_FILES, [(count, folder) for folder, count in folders.items()]))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--root", default=os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    arguments = parser.parse_args()
    over = 0
    for title, limit, found in measure(arguments.root):
        found.sort(reverse=True)
        too_large = sum(size > limit for size, _ in found)
        over += too_large
        if not arguments.check or too_large > 0:
            print(f"{title}, at most {limit}: {too_large} above")
            for size, name in found[:too_large if arguments.check else 10]:
                print(f"  {size:5} {name}")
    sys.exit(1 if arguments.check and over > 0 else 0)


if __name__ == "__main__":
    main()
