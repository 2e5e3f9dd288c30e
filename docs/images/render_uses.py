#!/usr/bin/env python3
"""Makes docs/images/sphere_map_uses.png: what a map to the sphere is for, on shapes that the command makes.

    docs/images/render_uses.py build/cli/orbicube [OUT.png]

Needs numpy.
"""
import os
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from raster import panel, read_obj, without_margins, write_png  # noqa: E402


def main(command, picture):
    with tempfile.TemporaryDirectory() as folder:
        def path(name):
            return os.path.join(folder, name)

        def orbicube(*arguments):
            subprocess.run([command, *arguments, "--quiet"], check=True)

        orbicube("make", "creature", "-o", path("creature.obj"), "--resolution", "16000")
        orbicube("make", "star", "-o", path("star.obj"), "--resolution", "10000")
        for name, grid in (("icosphere.obj", "icosphere:5"), ("cube.obj", "cube:40")):
            orbicube("sphere", path("creature.obj"), "-o", path("map.obj"), "--method", "stretch", "--remesh", path(name),
                     "--grid", grid)
        orbicube("morph", path("creature.obj"), path("star.obj"), "-o", path("morph.glb"), "--intermediates", "1")
        orbicube("convert", path("morph-01.glb"), path("half.obj"))
        panels = [panel(*read_obj(path(name)), color) for name, color in
                  (("creature.obj", (0.75, 0.78, 0.82)), ("icosphere.obj", (0.55, 0.75, 0.95)),
                   ("cube.obj", (0.95, 0.8, 0.5)), ("half.obj", (0.7, 0.9, 0.65)))]
    write_png(picture, without_margins(np.concatenate(panels, axis=1)))
    print(f"{picture}: {os.path.getsize(picture)} bytes")


HERE = os.path.dirname(os.path.abspath(__file__))
main(os.path.abspath(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else os.path.join(HERE, "sphere_map_uses.png"))
