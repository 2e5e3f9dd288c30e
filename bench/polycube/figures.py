#!/usr/bin/env python3
"""The figures of the dissertation's chapter 4, made again with the command; writes docs/images/polycube_*.png and
docs/polycube_figures.md.

    bench/polycube/figures.py build/cli/orbicube FOLDER_OF_MODELS

Figures 4.2 and 4.9: domain and corners optimized from a cube. Figure 4.10: shapes blended over a common polycube. Figure 4.11:
more corners. Figure 4.12: weights of areas. Figure 4.13: the domain of a torus optimized. Needs numpy.
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

COMMAND, MODELS = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
COLORS = np.array([[0.95, 0.5, 0.45], [0.5, 0.8, 0.55], [0.5, 0.65, 0.95]])  # of faces across x, y and z
SQUARES = 30  # on the longest side of a polycube
UPRIGHT = {  # turns that put up along y and faces to the front
    "max-planck": ((-1, 0, 0), (0, 1, 0), (0, 0, -1)), "bimba": ((-1, 0, 0), (0, 1, 0), (0, 0, -1)),
    "torus": ((1, 0, 0), (0, 1, 0), (0, 0, 1)), "horse": ((1, 0, 0), (0, 0, 1), (0, -1, 0)),
    "cow": ((1, 0, 0), (0, 1, 0), (0, 0, 1))}
TURN, TILT = -0.6, 0.3


def run(*arguments):
    subprocess.run([COMMAND, *map(str, arguments), "--quiet"], check=True)


class Mapped:
    """A surface and its polycube, by `orbicube polycube MODEL` and the arguments."""

    def __init__(self, folder, model, *arguments):
        self.name = model.split(".")[0]
        surface, polycube, report = (os.path.join(folder, name) for name in ("surface.obj", "polycube.obj", "report.json"))
        self.domain = os.path.join(folder, "domain.json")
        run("polycube", os.path.join(MODELS, model), "-o", polycube, "--surface", surface, "--domain", self.domain,
            "--report", report, *arguments)
        self.surface, self.triangles = raster.read_obj(surface)
        self.polycube, _ = raster.read_obj(polycube)
        with open(report, encoding="utf-8") as file:
            found = json.load(file)
        self.corners = found["corners"]
        self.angle, self.area = found["distortion"]["angle_mean"], found["distortion"]["area_mean"]

    def figures(self):
        return f"{self.angle:.3f} / {self.area:.3f}"

    def checker(self):
        corners = self.polycube[self.triangles]
        axes = np.abs(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])).argmax(axis=1)
        # Squares are as large on every polycube of a surface, whose area it has.
        area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2
        side = np.sqrt(area / 6) / SQUARES * 2
        squares = (corners - self.polycube.min(axis=0)) / side + 1e-6  # faces lie on no line of the checker

        def color(triangle, weights):
            place = np.einsum("kyx,kc->yxc", weights, squares[triangle])
            dark = np.floor(place).astype(int).sum(axis=2) % 2
            return COLORS[axes[triangle]] * np.where(dark, 0.6, 1)[..., None]

        return color

    def panel(self, positions):
        turned = positions @ np.array(UPRIGHT[self.name], dtype=float).T
        return raster.panel(turned, self.triangles, self.checker(), turn=TURN, tilt=TILT, edges=False)

    def pictures(self):
        return np.concatenate([self.panel(self.surface), self.panel(self.polycube)], axis=0)


def write(name, panels):
    image = raster.without_margins(np.concatenate(panels, axis=1))
    raster.write_png(os.path.join(ROOT, "docs", "images", f"polycube_{name}.png"), image)
    return f"![{name}](images/polycube_{name}.png)\n"


def other_proportions(source, target, factors):
    """The polycube as JSON with its box stretched along each axis."""
    with open(source, encoding="utf-8") as file:
        domain = json.load(file)
    corners = np.array(domain["corners"])
    low, high = corners.min(axis=0), corners.max(axis=0)
    domain["corners"] = ((corners - low) * (np.array(factors(high - low)) / (high - low))).tolist()
    with open(target, "w", encoding="utf-8") as file:
        json.dump(domain, file)


def optimized(folder, model):
    """From a cube: as drawn, with the best proportions, with the best corners, with both."""
    cube = os.path.join(folder, "cube.json")
    other_proportions(Mapped(folder, model, "--corners", 8).domain, cube, lambda size: (1, 1, 1))
    given = ("--from", cube)
    return [Mapped(folder, model, *given), Mapped(folder, model, *given, "--optimize", "domain"),
            Mapped(folder, model, *given, "--optimize", "corners", "--corner-search", "gradient"),
            Mapped(folder, model, *given, "--optimize", "all", "--corner-search", "gradient")]


def from_a_cube(folder):
    first = optimized(folder, "max-planck.obj")
    second = optimized(folder, "bimba.obj")
    names = ("a cube", "best domain", "best corners", "both")
    text = ["## Figures 4.2 and 4.9: domain and corners", "",
            "From a cube to the optimized domain: the map traced on the cube and smoothed, then "
            "`--optimize domain`, `corners` and `all`.", "",
            write("figure_4_2", [m.pictures() for m in first]), write("figure_4_9", [m.pictures() for m in second]),
            "Means over triangles of angle and area distortion (1 for an isometry).", "",
            "| | " + " | ".join(names) + " |", "|---|" + "---|" * 4,
            *(f"| {ms[0].name} | " + " | ".join(m.figures() for m in ms) + " |" for ms in (first, second)), "",
            "The dissertation's Figure 4.2 reports the harmonic energy with the term of areas, whose minimum is not stated, as "
            "5.4414, 4.7812 with the optimal domain, 4.5961 with optimal corners.", ""]
    return text


def blended(folder):
    models = ["horse.ply", "cow.off"]
    quads = os.path.join(folder, "quads.obj")
    run("polycube", *(os.path.join(MODELS, m) for m in models), "-o", os.path.join(folder, "out.obj"), "--quads", quads,
        "--cells", 9000, "--corners", 60)
    shapes = []
    for i, name in ((1, "horse"), (2, "cow")):
        positions, faces = raster.read_obj(quads.replace(".obj", f"-{i}.obj"))
        turned = positions @ np.array(UPRIGHT[name], dtype=float).T
        size = np.sqrt(quad_areas(turned, faces).sum())
        shapes.append((turned - turned.mean(axis=0)) / size)
    shapes[1] = shapes[1] @ best_rotation(shapes[1], shapes[0]).T
    triangles = np.concatenate([faces[:, [0, 1, 2]], faces[:, [0, 2, 3]]], axis=1).reshape(-1, 3)
    panels = []
    for part in (0, 1 / 3, 2 / 3, 1):
        panels.append(raster.panel((1 - part) * shapes[0] + part * shapes[1], triangles, np.array([0.62, 0.72, 0.85]), turn=TURN,
                                   tilt=TILT, edges=False))
    return ["## Figure 4.10: shapes blended over a common polycube", "",
            "Horse and cow (the goat is not available), each vertex of the polycube's grid of quads at the weighted mean of its two positions.", "",
            write("figure_4_10", panels)]


def quad_areas(positions, quads):
    a, b, c, d = (positions[quads[:, k]] for k in range(4))
    return np.linalg.norm(np.cross(c - a, d - b), axis=1) / 2


def best_rotation(moved, fixed):
    """Of points that belong together (Kabsch 1976)."""
    u, _, v = np.linalg.svd(moved.T @ fixed)
    return v.T @ np.diag([1, 1, np.sign(np.linalg.det(v.T @ u.T))]) @ u.T


def more_corners(folder):
    maps = [Mapped(folder, "bimba.obj", "--corners", n, "--construct", how) for n, how in ((8, "auto"), (20, "voxels"))]
    return ["## Figure 4.11: more corners", "",
            f"Bimba (the Beethoven of the dissertation is not available) with {maps[0].corners} and with {maps[1].corners} corners: "
            f"{maps[0].figures()} and {maps[1].figures()}.", "",
            write("figure_4_11", [m.pictures() for m in maps])]


def weights(folder):
    maps = [Mapped(folder, "max-planck.obj", "--corners", 8, "--optimize", "all", "--corner-search", "gradient", "--area-weight", w)
            for w in (1000, 0.01)]
    return ["## Figure 4.12: weights of areas", "",
            f"Max-Planck with 1000, where areas are kept, and with 0.01, where angles are: {maps[0].figures()} and "
            f"{maps[1].figures()}.", "", write("figure_4_12", [m.pictures() for m in maps])]


def torus(folder):
    start = Mapped(folder, "torus.obj", "--corners", 16)
    flat = os.path.join(folder, "flat.json")
    other_proportions(start.domain, flat, lambda size: size * np.array([1.5, 0.75, 1]))
    maps = [Mapped(folder, "torus.obj", "--from", flat), Mapped(folder, "torus.obj", "--from", flat, "--optimize", "domain")]
    return ["## Figure 4.13: the domain of a torus", "",
            f"Traced on a polycube of other proportions, {maps[0].figures()}, and with the best ones, {maps[1].figures()}.", "",
            write("figure_4_13", [m.pictures() for m in maps])]


def main():
    with tempfile.TemporaryDirectory() as folder:
        parts = [from_a_cube(folder), blended(folder), more_corners(folder), weights(folder), torus(folder)]
    text = ["# The dissertation's figures of polycubes", "",
            "Made by `bench/polycube/figures.py`. Above the surface, below its polycube, a color for the faces across each axis and the same "
            "checker on both: squares that stay square are angles that are kept, squares of one size are areas.", ""]
    for part in parts:
        text += part
    with open(os.path.join(ROOT, "docs", "polycube_figures.md"), "w", encoding="utf-8") as file:
        file.write("\n".join(text).rstrip() + "\n")


main()
