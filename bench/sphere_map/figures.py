#!/usr/bin/env python3
"""Figures 3.3 to 3.8 of the dissertation, made again with the methods of the command; writes docs/images/sphere_map_figure_*.png and
docs/sphere_map_figures.md.

    bench/sphere_map/figures.py build/cli/orbicube FOLDER_OF_MODELS

`conformal` stands for the harmonic map, `stretch` for the map of Praun and Hoppe, whose measure it minimizes. Needs numpy; some minutes.
"""
import json
import os
import subprocess
import sys
import tempfile

import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "docs", "images"))
import raster  # noqa: E402

COMMAND, MODELS = (os.path.abspath(word) for word in sys.argv[1:3])
METHODS = ("conformal", "stretch", "dissertation", "balanced")
COMPARED = (("3.4", "bunny.ply"), ("3.5", "cow.off"), ("3.6", "max-planck.obj"), ("3.7", "gargoyle.ply"))
MORE = ("horse.ply", "venus.ply", "armadillo.ply")  # figure 3.8
# Where colors end: the ratio of the singular values of a triangle's map, and the ratio of its areas.
LARGEST_ANGLE, LARGEST_AREA = 3.0, 8.0
UPRIGHT = {  # turns that put up along y and the front along z
    "horse": ((1, 0, 0), (0, 0, 1), (0, -1, 0)), "armadillo": ((-1, 0, 0), (0, 1, 0), (0, 0, -1)),
    "max-planck": ((-1, 0, 0), (0, 1, 0), (0, 0, -1))}
raster.SIZE = 260
PAGE = """# Figures 3.3 to 3.8 of the dissertation

Made by `bench/sphere_map/figures.py`: the same models where they are available ([which](sphere_map_tables.md#which-model-stands-for-which)), the Head by Max Planck's.
The harmonic map is method `conformal`, whose E_D is within 2 percent of the harmonic map's and which flips nothing; `stretch` minimizes the measure of Praun and Hoppe,
whose own program is not available; a [baseline of the curvilinear map](sphere_map_tables.md#distortion) is in the tables. Weights are (0.1, 1), as printed.

## Figure 3.3: the sphere around the tail of the bunny

The images of the triangles, for `{methods}`, with the vertex at the end of the tail in the middle; colors are the ratios of areas of the next figures.

![Spheres of the bunny](images/sphere_map_figure_3_3.png)

## Figures 3.4 to 3.7: distortion in colors

Columns: `{methods}`. Above the quasi-conformal distortion K of each triangle, blue for 1 to red for {angle:g} and more, below the ratio of its areas on sphere and
surface, blue for equal to red for {area:g} times and more, either way. {parts}

{table}
## Figure 3.8: more maps

The default map of the horse, Venus and the armadillo: the model, and its sphere from both sides.

![More maps](images/sphere_map_figure_3_8.png)
"""


def run(*arguments):
    subprocess.run([COMMAND, *map(str, arguments), "--quiet"], check=True)


class Mapped:
    def __init__(self, folder, model, method):
        self.name = model.split(".")[0]
        plain, sphere, report = (os.path.join(folder, name) for name in ("plain.obj", "sphere.obj", "report.json"))
        run("convert", os.path.join(MODELS, model), plain)
        run("sphere", plain, "-o", sphere, "--method", method, "--report", report)
        self.surface, self.triangles = raster.read_obj(plain)
        self.sphere, _ = raster.read_obj(sphere)
        with open(report, encoding="utf-8") as file:
            self.report = json.load(file)
        upright = np.array(UPRIGHT.get(self.name, np.eye(3)), float)
        self.turned = self.surface @ upright.T
        self.turned_sphere = self.sphere @ upright.T

    def distortions(self):
        """K, and the ratio of areas for equal total areas, of each triangle."""
        def sides(positions):
            p = positions[self.triangles]
            return p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]

        def gram(u, v):
            return np.stack([(u * u).sum(1), (u * v).sum(1), (v * v).sum(1)])
        (a, b, c), (d, e, f) = gram(*sides(self.surface)), gram(*sides(self.sphere))
        area, image = np.sqrt(np.maximum(a * c - b * b, 1e-300)), np.sqrt(np.maximum(d * f - e * e, 1e-300))
        trace = (c * d - 2 * b * e + a * f) / (area * area)  # of the map's metric in that of the surface
        determinant = (image / area) ** 2
        root = np.sqrt(np.maximum(trace * trace / 4 - determinant, 0))
        k = np.sqrt((trace / 2 + root) / np.maximum(trace / 2 - root, 1e-300))
        return k, image / area * area.sum() / image.sum()


def colors(share):
    """Blue, cyan, green, yellow, red for 0 to 1."""
    stops = np.array([[0.25, 0.35, 0.9], [0.3, 0.8, 0.9], [0.4, 0.8, 0.4], [0.95, 0.9, 0.35], [0.9, 0.25, 0.2]])
    at = np.clip(share, 0, 1) * (len(stops) - 1)
    low = np.minimum(at.astype(int), len(stops) - 2)
    return stops[low] + (at - low)[:, None] * (stops[low + 1] - stops[low])


def painted(positions, triangles, triangle_colors, turn=0.5, tilt=0.2):
    return raster.panel(positions, triangles, lambda number, weights: triangle_colors[number], turn=turn, tilt=tilt, edges=False)


def write(name, image):
    raster.write_png(os.path.join(ROOT, "docs", "images", f"sphere_map_figure_{name}.png"), raster.without_margins(image))
    print("figure", name, flush=True)


def compared(folder):
    table = ["| figure | model | | " + " | ".join(f"`{method}`" for method in METHODS) + " |", "|---" * (3 + len(METHODS)) + "|"]
    parts = []
    for number, model in COMPARED:
        maps = [Mapped(folder, model, method) for method in METHODS]
        rows = [[], []]
        for m in maps:
            k, ratio = m.distortions()
            rows[0].append(painted(m.turned, m.triangles, colors((k - 1) / (LARGEST_ANGLE - 1))))
            rows[1].append(painted(m.turned, m.triangles, colors(np.abs(np.log(ratio)) / np.log(LARGEST_AREA))))
        file = number.replace(".", "_")
        write(file, np.concatenate([np.concatenate(row, axis=1) for row in rows], axis=0))
        parts.append(f"\n\n![{model}](images/sphere_map_figure_{file}.png)")
        for key, title in (("energy_angle", "E_D"), ("energy_area", "E_A")):
            table.append(f"| {number} | {maps[0].name} | {title} | " + " | ".join(f"{m.report[key]:.2f}" for m in maps) + " |")
        if number == "3.4":
            tail(maps)
    return "".join(parts), "\n".join(table) + "\n"


def tail(maps):
    """Spheres seen from where the tail is: the vertex of the bunny that is farthest to one side."""
    panels = []
    for m in maps:
        vertex = int(np.argmax(m.surface[:, 0] - 0.5 * m.surface[:, 1]))
        towards = m.sphere[vertex] / np.linalg.norm(m.sphere[vertex])
        up = np.array([0.0, 1.0, 0.0]) if abs(towards[1]) < 0.9 else np.array([1.0, 0.0, 0.0])
        right = np.cross(up, towards)
        right /= np.linalg.norm(right)
        axes = np.stack([right, np.cross(towards, right), towards])
        own = colors(np.abs(np.log(m.distortions()[1])) / np.log(LARGEST_AREA))
        panels.append(painted(m.sphere @ axes.T, m.triangles, own, turn=0, tilt=0))
    write("3_3", np.concatenate(panels, axis=1))


def more(folder):
    rows = []
    for model in MORE:
        m = Mapped(folder, model, "balanced")
        _, ratio = m.distortions()
        own = colors(np.abs(np.log(ratio)) / np.log(LARGEST_AREA))
        rows.append(np.concatenate([painted(m.turned, m.triangles, own), painted(m.turned_sphere, m.triangles, own),
                                    painted(m.turned_sphere, m.triangles, own, turn=0.5 + np.pi)], axis=1))
    write("3_8", np.concatenate(rows, axis=0))


def main():
    with tempfile.TemporaryDirectory() as folder:
        parts, table = compared(folder)
        more(folder)
    page = PAGE.format(methods="`, `".join(METHODS), angle=LARGEST_ANGLE, area=LARGEST_AREA, parts=parts, table=table)
    with open(os.path.join(ROOT, "docs", "sphere_map_figures.md"), "w", encoding="utf-8") as file:
        file.write(page)


main()
