#!/usr/bin/env python3
"""The figures of the dissertation's section 3.3, made again with the command; writes docs/images and docs/harmonics_figures.md.

    bench/harmonics/figures.py build/cli/orbicube FOLDER_OF_MODELS

Figure 3.9: surfaces of L_max = 6, 16, 32 beside the model. Figures 3.10 and 3.11: the error against the weights of angles and
areas. Figure 3.12: distances in a sequence of deformations.
"""
import json
import os
import subprocess
import sys
import tempfile

import numpy

import picture

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
RATIOS = (0.01, 0.03, 0.1, 0.2, 0.3, 0.5, 1, 2, 5, 10)
COMMAND, MODELS = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])


def run(*arguments):
    subprocess.run([COMMAND, *map(str, arguments), "--quiet"], check=True)


def image(name):
    return os.path.join(ROOT, "docs", "images", name)


def error(model, sphere, degree, folder, *arguments):
    report = os.path.join(folder, "report.json")
    run("harmonics", model, "--sphere", sphere, "--degree", degree, "-o", os.path.join(folder, "c.sh"), "--report", report,
        *arguments)
    with open(report, encoding="utf-8") as file:
        return json.load(file)["error"]


def reconstructions(folder, views):
    """Figure 3.9. A view turns the model so that it is seen along -z."""
    rows, table = [], ["| model | 6 | 16 | 32 |", "|---|---|---|---|"]
    for name, view in views.items():
        model, sphere, out = os.path.join(MODELS, name), os.path.join(folder, "map.obj"), os.path.join(folder, "out.obj")
        run("sphere", model, "-o", sphere, "--method", "stretch")
        run("convert", model, os.path.join(folder, "model.obj"))
        positions, triangles = picture.read_obj(os.path.join(folder, "model.obj"))
        positions = positions @ numpy.array(view).T
        low, high = positions.min(axis=0), positions.max(axis=0)
        row, errors = [picture.shaded(positions, triangles, low, high, 320)], []
        for degree in (6, 16, 32):
            errors.append(error(model, sphere, degree, folder, "--reconstruct", out))
            row.append(picture.shaded(picture.read_obj(out)[0] @ numpy.array(view).T, triangles, low, high, 320))
        rows.append(numpy.hstack(row))
        table.append(f"| {name} | " + " | ".join(f"{e:.4f}" for e in errors) + " |")
    picture.write_png(image("harmonics_reconstruction.png"), numpy.vstack(rows))
    return table


def against_weights(folder, name, picture_name):
    """Figures 3.10 and 3.11: the curves for L_max = 6 above, 16 below."""
    model, sphere = os.path.join(MODELS, name), os.path.join(folder, "map.obj")
    errors = {6: [], 16: []}
    for ratio in RATIOS:
        run("sphere", model, "-o", sphere, "--method", "angle-area", "--angle-weight", ratio, "--area-weight", 1)
        for degree, found in errors.items():
            found.append(error(model, sphere, degree, folder))
    picture.write_png(image(picture_name), numpy.vstack([picture.chart([(RATIOS, e)]) for e in errors.values()]))
    return [f"| {name} | " + " | ".join(map(str, RATIOS)) + " |", "|---" * (len(RATIOS) + 1) + "|"] + \
           [f"| L_max = {degree} | " + " | ".join(f"{e:.5f}" for e in found) + " |" for degree, found in errors.items()]


def deformations(folder):
    """Figure 3.12: a shape that turns into another in eight steps, each turned in space as well."""
    ends = []
    for seed in (1, 4):
        path = os.path.join(folder, f"end{seed}.obj")
        run("make", "blob", "-o", path, "--resolution", 12000, "--seed", seed)
        ends.append(picture.read_obj(path))
    files, row = [], []
    for k, share in enumerate(numpy.linspace(0, 1, 9)):
        positions = (1 - share) * ends[0][0] + share * ends[1][0]
        angle = 0.7 * k
        turn = numpy.array([[numpy.cos(angle), -numpy.sin(angle), 0], [numpy.sin(angle), numpy.cos(angle), 0], [0, 0, 1]])
        shape, sphere, out = (os.path.join(folder, f"step{k}{end}") for end in (".obj", ".sphere.obj", ".sh"))
        with open(shape, "w", encoding="ascii") as file:
            file.writelines("v %.17g %.17g %.17g\n" % tuple(p) for p in positions @ turn.T)
            file.writelines("f %d %d %d\n" % tuple(t + 1) for t in ends[0][1])
        run("sphere", shape, "-o", sphere)
        run("harmonics", shape, "--sphere", sphere, "--degree", 16, "-o", out)
        files.append(out)
        row.append(picture.shaded(positions, ends[0][1], numpy.full(3, -1.6), numpy.full(3, 1.6), 150))
    picture.write_png(image("harmonics_sequence.png"), numpy.hstack(row))
    matrix = os.path.join(folder, "matrix.txt")
    run("compare", *files, "-o", matrix, "--png", image("harmonics_distances.png"), "--min-degree", 1)
    # The command does not compress.
    picture.write_png(image("harmonics_distances.png"), picture.read_png(image("harmonics_distances.png")))
    rows = numpy.loadtxt(matrix)
    return ["| | " + " | ".join(str(k + 1) for k in range(9)) + " |", "|---" * 10 + "|"] + \
           [f"| {k + 1} | " + " | ".join(f"{d:.2e}" for d in r) + " |" for k, r in enumerate(rows)]


def main():
    with tempfile.TemporaryDirectory() as folder:
        text = ["# Figures of the harmonics", "",
                "Section 3.3 of the dissertation, recomputed by `bench/harmonics/figures.py build/cli/orbicube FOLDER`; errors are",
                "e(M, M^) for surfaces of area 4 pi.", "",
                "## Figure 3.9: reconstructions", "",
                "The model, then L_max = 6, 16 and 32, on maps of method `stretch`, vertices weighted by area.", "",
                "![Models and their reconstructions](images/harmonics_reconstruction.png)", ""]
        text += reconstructions(folder, {"bunny.ply": numpy.eye(3), "armadillo.ply": numpy.eye(3),
                                         "horse.ply": [[0, 1, 0], [0, 0, -1], [-1, 0, 0]]})
        for number, name, kind in (("3.10", "venus.ply", "venus"), ("3.11", "bunny.ply", "bunny")):
            text += ["", f"## Figure {number}: error against the weights, {kind}", "",
                     "Maps of method `angle-area` with the ratio of the weights of angles and areas in the head; in the picture",
                     "L_max = 6 above, 16 below, the ratio by its logarithm.", "",
                     f"![Error by ratio](images/harmonics_weights_{kind}.png)", ""]
            text += against_weights(folder, name, f"harmonics_weights_{kind}.png")
        text += ["", "## Figure 3.12: distances in a sequence of deformations", "",
                 "Nine steps from one shape of `orbicube make` to another, each rotated by 40 degrees against the last; the",
                 "head models of the dissertation are not available. D_16 of default maps, from degree 1; black is equal.", "",
                 "![The sequence](images/harmonics_sequence.png)", "",
                 "![Distances](images/harmonics_distances.png)", ""]
        text += deformations(folder)
    with open(os.path.join(ROOT, "docs", "harmonics_figures.md"), "w", encoding="utf-8") as file:
        file.write("\n".join(text) + "\n")


main()
