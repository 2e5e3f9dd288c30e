#!/usr/bin/env python3
"""render_regions.py FOLDER: draws docs/images/hexahedra_regions.png, sections of meshes that bench/hexmesh/assemblies.py made.

FOLDER is the one given to it. Faces between hexahedra on both sides of a plane are drawn in the color of their region. Needs
matplotlib, numpy and what that program needs.
"""
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "bench", "hexmesh"))
from assemblies import read_hexahedra  # noqa: E402

FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
SECTIONS = (("pin", .5), ("nested", 0), ("pillar", .5), ("three", .5))


def section(path, plane):
    """Quads in x and z near y = plane, and the regions of the hexahedra before it."""
    positions, hexahedra, regions = read_hexahedra(path)
    before = positions[hexahedra].mean(axis=1)[:, 1] < plane
    quads = hexahedra[:, FACES].reshape(-1, 4)
    owner = np.repeat(np.arange(len(hexahedra)), len(FACES))
    _, number = np.unique(np.sort(quads, axis=1), axis=0, return_inverse=True)
    sides = np.zeros((number.max() + 1, 2), dtype=bool)
    sides[number.ravel(), before[owner].astype(int)] = True
    chosen = sides[number.ravel()].all(axis=1) & before[owner]
    return positions[quads[chosen]][:, :, [0, 2]], regions[owner[chosen]]


def main():
    figure, axes = plt.subplots(1, len(SECTIONS), figsize=(16, 4.6), constrained_layout=True)
    for at, (name, plane) in zip(axes, SECTIONS):
        quads, regions = section(os.path.join(sys.argv[1], name + ".mesh"), plane)
        at.add_collection(PolyCollection(quads, facecolors=plt.cm.Set2(regions % 8), edgecolors="black", linewidths=.5))
        at.autoscale()
        at.set_aspect("equal")
        at.set_axis_off()
    figure.savefig(os.path.join(HERE, "hexahedra_regions.png"), dpi=70)


if __name__ == "__main__":
    main()
