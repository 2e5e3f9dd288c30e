#!/usr/bin/env python3
"""Makes docs/images/sphere_map.png: a shape that the command makes, beside its sphere map, with the same checker on both.

    docs/images/render.py build/cli/orbicube

Chromium draws it, from the page that the command writes.
"""
import os
import shutil
import subprocess
import sys
import tempfile


def main(command):
    browser = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if browser is None:
        sys.exit("render.py: there is no chromium")
    picture = os.path.join(os.path.dirname(os.path.abspath(__file__)), "sphere_map.png")
    with tempfile.TemporaryDirectory() as folder:
        shape, sphere, page = (os.path.join(folder, name) for name in ("creature.obj", "sphere.obj", "page.html"))
        for arguments in (["make", "creature", "-o", shape, "--resolution", "40000"], ["sphere", shape, "-o", sphere],
                          ["page", shape, sphere, "-o", page]):
            subprocess.run([command, *arguments, "--quiet"], check=True)
        subprocess.run([browser, "--headless=new", "--no-sandbox", "--use-angle=swiftshader",
                        "--enable-unsafe-swiftshader", "--hide-scrollbars", f"--user-data-dir={folder}/profile",
                        "--virtual-time-budget=5000", "--window-size=1080,450", f"--screenshot={picture}",
                        f"file://{page}#picture&theme=light&color=checker"],
                       check=True, capture_output=True, timeout=300)
    print(f"{picture}: {os.path.getsize(picture)} bytes")


main(os.path.abspath(sys.argv[1]))
