#!/usr/bin/env python3
"""Runs what the pages say is to be typed: the blocks of a page one after the other, in a folder of its own.

    sh_samples.py BUILD     (with the command in BUILD/cli, where it is built)

There, program.c and program.cpp include the header of the page's library, example.c is the program of the README, and
creature.obj and star.obj are small shapes. The command comes before all else in PATH, pkg-config finds the build.
"""

import os
import shutil
import subprocess
import sys
import tempfile

from samples import ROOT, blocks, pages

BROWSER = any(map(shutil.which, ("chromium", "chromium-browser", "google-chrome")))


def main():
    build = os.path.abspath(sys.argv[1])
    command = os.path.join(build, "cli", "orbicube")
    environment = {**os.environ, "PATH": os.path.dirname(command) + os.pathsep + os.environ["PATH"],
                   "PKG_CONFIG_PATH": os.path.join(build, "meson-uninstalled"), "LD_LIBRARY_PATH": os.path.join(build, "capi")}
    ran = left = 0
    for page in pages():
        found = list(blocks(page, "sh"))
        if not found:
            continue
        name = os.path.splitext(os.path.basename(page))[0]
        header = name if os.path.exists(os.path.join(ROOT, "capi", "include", "orbicube", name + ".h")) else "base"
        with tempfile.TemporaryDirectory() as folder:
            for ending in ("c", "cpp"):
                with open(os.path.join(folder, "program." + ending), "w", encoding="utf-8") as file:
                    file.write(f"#include <orbicube/{'sphere_map.hpp' if ending == 'cpp' else header + '.h'}>\nint main() {{ return 0; }}\n".replace(
                        "main()", "main(void)" if ending == "c" else "main()"))
            with open(os.path.join(folder, "example.c"), "w", encoding="utf-8") as file:
                file.write(next(text for _, text in blocks(os.path.join(ROOT, "README.md"), "c")))
            for line, text in found:
                where = f"{os.path.basename(page)}:{line}"
                if "orbicube " in text and not os.path.exists(command):
                    print(where, "is left out: the command is not built")
                    left += 1
                    continue
                if "orbicube view" in text and "--png" in text and not BROWSER:
                    print(where, "is left out: there is no Chromium")
                    left += 1
                    continue
                if "creature.obj" in text and not os.path.exists(os.path.join(folder, "creature.obj")) and os.path.exists(command):
                    for shape in ("creature", "star"):
                        subprocess.run([command, "make", shape, "-o", shape + ".obj", "--resolution", "2000", "--quiet"], check=True, cwd=folder)
                print(where, flush=True)
                subprocess.run(["bash", "-euo", "pipefail", "-c", text], check=True, cwd=folder, env=environment, stdout=subprocess.DEVNULL)
                ran += 1
    print(f"{ran} samples ran, {left} were left out")
    if ran == 0:
        sys.exit("nothing to run was found")


if __name__ == "__main__":
    main()
