#!/usr/bin/env python3
"""Makes the pictures of the gallery, docs/index.md, by the commands below them.

    docs/images/gallery.py build/cli/orbicube     runs them and writes docs/images/gallery/
    docs/images/gallery.py --check                looks whether each picture has its commands, and all are small

Needs Chromium.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tests", "docs"))
from samples import blocks  # noqa: E402

PAGE, FOLDER = os.path.join(ROOT, "docs", "index.md"), os.path.join(ROOT, "docs", "images", "gallery")
MAX_BYTES = 400_000  # all together


def made():
    """The commands that make each picture, by its name."""
    return {name: text for _, text in blocks(PAGE, "sh") for name in re.findall(r"--png (\S+)", text)}


def shown():
    with open(PAGE, encoding="utf-8") as file:
        return re.findall(r"\]\(images/gallery/([^)]+)\)", file.read())


def check():
    problems = []
    pictures, commands = sorted(os.listdir(FOLDER)), made()
    if not sorted(commands) == sorted(shown()) == pictures:
        problems.append(f"made: {sorted(commands)}, shown: {sorted(shown())}, stored: {pictures}")
    for text in commands.values():
        problems += [f"no generated shape: {line}" for line in text.splitlines()[:1] if not line.startswith("orbicube make ")]
    size = sum(os.path.getsize(os.path.join(FOLDER, name)) for name in pictures)
    if size > MAX_BYTES:
        problems.append(f"the pictures have {size} bytes, more than {MAX_BYTES}")
    return problems


def make(command):
    os.makedirs(FOLDER, exist_ok=True)
    environment = {**os.environ, "PATH": os.path.dirname(os.path.abspath(command)) + os.pathsep + os.environ["PATH"]}
    for name, text in made().items():
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(["bash", "-euo", "pipefail", "-c", text], check=True, cwd=folder, env=environment, stdout=subprocess.DEVNULL)
            out = shutil.copy(os.path.join(folder, name), FOLDER)
            print(f"{out}: {os.path.getsize(out)} bytes", flush=True)


if __name__ == "__main__":
    if sys.argv[1] != "--check":
        make(sys.argv[1])
    found = check()
    if found:
        sys.exit("\n".join(found))
