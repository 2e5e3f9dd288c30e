#!/usr/bin/env python3
"""Maps of solids to polycubes that frame fields guide (section 5.2 of the dissertation): energies, and inverted tetrahedra.

    guided.py ORBICUBE MODELS [--keep FOLDER] [--write]

MODELS has the folders dev, tets and hexme. Prints a table; with --write into docs/volume_map_figures.md, behind the one of figures 5.1 to 5.3.
With --keep the tetrahedra in space and on the polycube are left in FOLDER, as NAME-source.mesh and NAME-image.mesh, for another judge. The
signs of the tetrahedra as they are in the files are counted here, by rational arithmetic.
"""
import json
import os
import subprocess
import sys
import tempfile
from fractions import Fraction

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "docs", "volume_map_figures.md")
SOLIDS = ("dev/tet-sphere.mesh", "dev/tet-hand.mesh", "dev/tet-rocker-arm.mesh", "dev/tet-kitten.mesh", "dev/tet-m1.mesh", "dev/tet-s1.mesh",
          "tets/ball.mesh", "tets/rod.mesh", "hexme/s09c_bridge.vtk", "hexme/s12c_cube_rounded_1.vtk", "hexme/s15c_cylinder.vtk")
HEADING = "## Maps that frames guide"
TEXT = f"""
{HEADING}

Written by `bench/volume_map/guided.py`. `orbicube frames SOLID -o FRAMES`, then `orbicube volume SOLID -o IMAGE --source SOURCE --frames FRAMES`: the printed
experiment of section 5.2. Energies are eq. 5.3 over the volume, all with the boundary of the map: of harmonic coordinates, the minimum, where tetrahedra may be inverted, and of
the map, in which none is; tetrahedra of the files that are not positive, by rational arithmetic. Seconds of the processor for both commands.

| solid | tetrahedra of the map | harmonic | minimum | map | not positive | s |
|---|---|---|---|---|---|---|
"""


def read_medit(path):
    """Positions and tetrahedra of a MEDIT file in text."""
    with open(path, encoding="ascii") as file:
        words = iter(file.read().split())
    points, cells = [], []
    for word in words:
        if word == "Vertices":
            points = [tuple(float(next(words)) for _ in range(4))[:3] for _ in range(int(next(words)))]
        elif word == "Tetrahedra":
            cells = [tuple(int(next(words)) - 1 for _ in range(5))[:4] for _ in range(int(next(words)))]
        elif word == "End":
            break
    return points, cells


def determinant(p, q, r, s, number):
    a, b, c = ([number(x) - number(y) for x, y in zip(corner, p)] for corner in (q, r, s))
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]))


def not_positive(path):
    points, cells = read_medit(path)
    count = 0
    for cell in cells:
        corners = [points[v] for v in cell]
        size = max(abs(x - y) for corner in corners[1:] for x, y in zip(corner, corners[0]))
        volume = determinant(*corners, float)
        # Far from the rounding errors of floating point, whose sign counts then; signs by rational numbers otherwise.
        if abs(volume) < 1e-10 * size ** 3 or abs(volume) < 1e-290:
            volume = determinant(*corners, Fraction)
        count += volume <= 0
    return count


def row(orbicube, solid, folder):
    name = os.path.basename(solid).split(".")[0]
    seconds = 0.0

    def run(*words):
        nonlocal seconds
        before = os.times()
        report = os.path.join(folder, name + ".json")
        subprocess.run([orbicube, *words, "--quiet", "--report", report], check=True)
        after = os.times()
        seconds += after.children_user + after.children_system - before.children_user - before.children_system
        with open(report, encoding="utf-8") as file:
            return json.load(file)

    frames, image, source = (os.path.join(folder, name + end) for end in (".frames", "-image.mesh", "-source.mesh"))
    run("frames", solid, "-o", frames)
    report = run("volume", solid, "-o", image, "--source", source, "--frames", frames, "--text")
    energies = report["frames"]
    wrong = not_positive(image) + not_positive(source)
    return (f"| {name} | {report['tetrahedra']} | {energies['harmonic_energy']:.4f} | {energies['minimum_energy']:.4f} | {energies['energy']:.4f} | "
            f"{wrong} | {seconds:.1f} |\n")


def main():
    orbicube, models = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    text = TEXT
    with tempfile.TemporaryDirectory() as temporary:
        folder = os.path.abspath(sys.argv[sys.argv.index("--keep") + 1]) if "--keep" in sys.argv else temporary
        for solid in SOLIDS:
            text += row(orbicube, os.path.join(models, solid), folder)
            print(text.splitlines()[-1], flush=True)
    if "--write" in sys.argv:
        with open(PAGE, encoding="utf-8") as file:
            page = file.read().split("\n" + HEADING)[0]
        with open(PAGE, "w", encoding="utf-8") as file:
            file.write(page + text)


main()
