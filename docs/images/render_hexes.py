#!/usr/bin/env python3
"""Draws hexahedral meshes, a quarter of each cut away: what is inside is colored by scaled Jacobians, red 0.5 and less, blue 1.

    docs/images/render_hexes.py OUT.png COLUMNS MESH.mesh ...

MESH.mesh: as `orbicube hex` writes it. Needs numpy.
"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import raster  # noqa: E402

NEIGHBORS = np.array([[1, 3, 4], [2, 0, 5], [3, 1, 6], [0, 2, 7], [7, 5, 0], [4, 6, 1], [5, 7, 2], [6, 4, 3]])
FACES = np.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])
OUTSIDE = np.array([0.93, 0.86, 0.72])
raster.SIZE = 300


def read_medit(path):
    with open(path, encoding="ascii") as file:
        words = file.read().split()

    def table(name, columns):
        start = words.index(name) + 2
        count = int(words[start - 1])
        return np.array(words[start:start + columns * count], float).reshape(count, columns)

    return table("Vertices", 4)[:, :3], table("Hexahedra", 9)[:, :8].astype(int) - 1


def scaled_jacobians(positions, cells):
    worst = np.ones(len(cells))
    for corner, near in enumerate(NEIGHBORS):
        edges = positions[cells[:, near]] - positions[cells[:, [corner]]]
        lengths = np.linalg.norm(edges, axis=2).prod(axis=1)
        worst = np.minimum(worst, np.linalg.det(edges) / lengths)
    return worst


def boundary(cells):
    """Faces of one cell only, and whose they are."""
    faces = cells[:, FACES].reshape(-1, 4)
    _, where, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    once = np.sort(where[count == 1])
    return faces[once], once // 6


def picture(path):
    positions, cells = read_medit(path)
    quality = scaled_jacobians(positions, cells)
    outer = {tuple(sorted(face)) for face in boundary(cells)[0]}
    centers = positions[cells].mean(axis=1)
    middle = (positions.min(axis=0) + positions.max(axis=0)) / 2
    # Towards the viewer of panel(): above, and in front.
    kept = (centers[:, 1] < middle[1]) | (centers[:, 2] < middle[2])
    quads, owner = boundary(cells[kept])
    inside = np.array([tuple(sorted(quad)) not in outer for quad in quads])
    t = np.clip((quality[kept][owner] - 0.5) / 0.5, 0, 1)[:, None]
    colors = np.where(inside[:, None], (1 - t) * [0.9, 0.2, 0.15] + t * np.array([0.45, 0.65, 0.95]), OUTSIDE)

    def color(triangle, weights):
        # The edge between the two triangles of a quad is none of the mesh.
        drawn = np.minimum(weights[0], weights[2]) if triangle % 2 == 0 else np.minimum(weights[0], weights[1])
        return colors[triangle // 2] * np.where(drawn < 0.07, 0.45, 1)[..., None]

    triangles = np.stack([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]], axis=1).reshape(-1, 3)
    return raster.panel(positions, triangles, color, edges=False)


def main(out, columns, paths):
    panels = [picture(path) for path in paths]
    while len(panels) % columns:
        panels.append(np.ones_like(panels[0]))
    rows = [np.concatenate(panels[i:i + columns], axis=1) for i in range(0, len(panels), columns)]
    raster.write_png(out, np.concatenate(rows, axis=0))
    print(f"{out}: {os.path.getsize(out)} bytes")


main(sys.argv[1], int(sys.argv[2]), sys.argv[3:])
