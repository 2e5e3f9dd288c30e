#!/usr/bin/env python3
"""Makes docs/images/polycube.png: shapes that the command makes beside their polycubes, a color for each axis and the same
checker on both.

    docs/images/render_polycube.py build/cli/orbicube [OUT.png]

Needs numpy.
"""
import os
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from raster import panel, read_obj, without_margins, write_png  # noqa: E402

COLORS = np.array([[0.95, 0.45, 0.4], [0.45, 0.8, 0.5], [0.45, 0.6, 0.95]])  # of faces across x, y and z
SQUARES = 14  # along the longest side of a polycube


def pictures(surface, polycube):
    positions, triangles = read_obj(surface)
    on_polycube, same = read_obj(polycube)
    assert np.array_equal(triangles, same)
    corners = on_polycube[triangles]
    axes = np.abs(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])).argmax(axis=1)
    side = (on_polycube.max(axis=0) - on_polycube.min(axis=0)).max() / SQUARES
    squares = (corners - on_polycube.min(axis=0)) / side + 1e-6  # faces lie on no line of the checker

    def checker(triangle, weights):
        place = np.einsum("kyx,kc->yxc", weights, squares[triangle])
        dark = np.floor(place).astype(int).sum(axis=2) % 2
        return COLORS[axes[triangle]] * np.where(dark, 0.75, 1)[..., None]

    return [panel(x, triangles, checker, turn=-0.7, tilt=0.35, edges=False) for x in (positions, on_polycube)]


def main(command, picture):
    panels = []
    with tempfile.TemporaryDirectory() as folder:
        shape, polycube, surface = (os.path.join(folder, name) for name in ("shape.obj", "polycube.obj", "surface.obj"))
        for kind in ("bracket", "creature"):
            for arguments in (["make", kind, "-o", shape, "--resolution", "12000"],
                              ["polycube", shape, "-o", polycube, "--surface", surface]):
                subprocess.run([command, *arguments, "--quiet"], check=True)
            panels += pictures(surface, polycube)
    write_png(picture, without_margins(np.concatenate(panels, axis=1)))
    print(f"{picture}: {os.path.getsize(picture)} bytes")


HERE = os.path.dirname(os.path.abspath(__file__))
main(os.path.abspath(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else os.path.join(HERE, "polycube.png"))
