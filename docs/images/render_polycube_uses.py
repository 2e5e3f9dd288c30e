#!/usr/bin/env python3
"""Makes docs/images/polycube_uses.png: two shapes that the command makes with the same mesh of quads, from the grid of one
polycube, and the shape halfway between them.

    docs/images/render_polycube_uses.py build/cli/orbicube [OUT.png]

Needs numpy.
"""
import os
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from raster import panel, read_obj, without_margins, write_png  # noqa: E402

COLOR = np.array([0.62, 0.72, 0.85])


def picture(positions, quads):
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]], axis=1).reshape(-1, 3)

    def lined(triangle, weights):
        # The diagonal is no side: opposite corner 1 of the first half, corner 2 of the second.
        sides = [weights[k] for k in range(3) if k != (1 if triangle % 2 == 0 else 2)]
        return np.where(np.minimum(*sides)[..., None] < 0.07, 0.35 * COLOR, COLOR)

    return panel(positions, triangles, lined, turn=-0.7, tilt=0.35, edges=False)


def main(command, target):
    with tempfile.TemporaryDirectory() as folder:
        shapes = [os.path.join(folder, f"shape{seed}.obj") for seed in range(2)]
        quads = os.path.join(folder, "quads.obj")
        for seed, shape in enumerate(shapes):
            subprocess.run([command, "make", "creature", "-o", shape, "--resolution", "6000", "--seed", str(seed), "--quiet"],
                           check=True)
        subprocess.run([command, "polycube", *shapes, "-o", os.path.join(folder, "out.obj"), "--quads", quads, "--cells", "3000",
                        "--corners", "60", "--quiet"], check=True)
        (first, faces), (second, same) = (read_obj(quads.replace(".obj", f"-{i}.obj")) for i in (1, 2))
    assert np.array_equal(faces, same)
    panels = [picture(x, faces) for x in (first, (first + second) / 2, second)]
    write_png(target, without_margins(np.concatenate(panels, axis=1)))
    print(f"{target}: {os.path.getsize(target)} bytes")


HERE = os.path.dirname(os.path.abspath(__file__))
main(os.path.abspath(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else os.path.join(HERE, "polycube_uses.png"))
