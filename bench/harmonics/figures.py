#!/usr/bin/env python3
"""Section 3.3 of the dissertation, made again with the command and the bench; writes docs/images and docs/harmonics_figures.md.

    bench/harmonics/figures.py BUILD FOLDER_OF_MODELS

Table 3.5: reconstruction errors. Figure 3.9: surfaces of 6 x 6, 16 x 16 and 32 x 32 coefficients beside the model. Figures 3.10 and
3.11: the error against the weights of angles and areas. Figure 3.12: distances in a sequence of deformations. The errors of the
page are kept in BUILD/bench/harmonics/errors.txt; remove it to measure again.
"""
import json
import os
import subprocess
import sys
import tempfile

import numpy

import picture

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
RATIOS = (0, 0.01, 0.03, 0.1, 0.2, 0.3, 0.5, 1, 2, 5, 10)
BANDS = (6, 16, 32)  # N x N coefficients, degrees 0 to N - 1
BUILD, MODELS = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
COMMAND = os.path.join(BUILD, "cli", "orbicube")


def run(*arguments):
    subprocess.run([COMMAND, *map(str, arguments), "--quiet"], check=True)


def image(name):
    return os.path.join(ROOT, "docs", "images", name)


def error(model, sphere, bands, folder, *arguments):
    report = os.path.join(folder, "report.json")
    run("harmonics", model, "--sphere", sphere, "--degree", bands - 1, "-o", os.path.join(folder, "c.sh"), "--report", report,
        *arguments)
    with open(report, encoding="utf-8") as file:
        return json.load(file)["error"]


def reconstructions(folder, views):
    """Figure 3.9. A view turns the model so that it is seen along -z."""
    rows, table = [], ["| model | 6 x 6 | 16 x 16 | 32 x 32 |", "|---|---|---|---|"]
    for name, view in views.items():
        model, sphere, out = os.path.join(MODELS, name), os.path.join(folder, "map.obj"), os.path.join(folder, "out.obj")
        run("sphere", model, "-o", sphere, "--method", "stretch")
        run("convert", model, os.path.join(folder, "model.obj"))
        positions, triangles = picture.read_obj(os.path.join(folder, "model.obj"))
        positions = positions @ numpy.array(view).T
        low, high = positions.min(axis=0), positions.max(axis=0)
        row, errors = [picture.shaded(positions, triangles, low, high, 320)], []
        for bands in BANDS:
            errors.append(error(model, sphere, bands, folder, "--reconstruct", out))
            row.append(picture.shaded(picture.read_obj(out)[0] @ numpy.array(view).T, triangles, low, high, 320))
        rows.append(numpy.hstack(row))
        table.append(f"| {name} | " + " | ".join(f"{e:.4f}" for e in errors) + " |")
    picture.write_png(image("harmonics_reconstruction.png"), numpy.vstack(rows))
    return table


def against_weights(folder, name, picture_name):
    """Figures 3.10 and 3.11: the curves for 6 x 6 coefficients above, 16 x 16 below. The ratio 0 is left of the others."""
    model, sphere = os.path.join(MODELS, name), os.path.join(folder, "map.obj")
    errors = {6: [], 16: []}
    for ratio in RATIOS:
        run("sphere", model, "-o", sphere, "--method", "angle-area", "--angle-weight", ratio, "--area-weight", 1)
        for bands, found in errors.items():
            found.append(error(model, sphere, bands, folder))
    places = [max(ratio, RATIOS[1] / 3) for ratio in RATIOS]
    picture.write_png(image(picture_name), numpy.vstack([picture.chart([(places, e)]) for e in errors.values()]))
    return [f"| {name} | " + " | ".join(map(str, RATIOS)) + " |", "|---" * (len(RATIOS) + 1) + "|"] + \
           [f"| {bands} x {bands} | " + " | ".join(f"{e:.5f}" for e in found) + " |" for bands, found in errors.items()]


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
    picture.compress(image("harmonics_distances.png"))
    rows = numpy.loadtxt(matrix)
    return ["| | " + " | ".join(str(k + 1) for k in range(9)) + " |", "|---" * 10 + "|"] + \
           [f"| {k + 1} | " + " | ".join(f"{d:.2e}" for d in r) + " |" for k, r in enumerate(rows)]


def errors():
    """Table 3.5, from a former run if there is one."""
    path = os.path.join(BUILD, "bench", "harmonics", "errors.txt")
    if not os.path.exists(path):
        output = subprocess.run([os.path.join(BUILD, "bench", "harmonics", "bench-harmonics"), "errors", MODELS], check=True,
                                capture_output=True, text=True).stdout
        with open(path, "w", encoding="utf-8") as file:
            file.write(output)
    with open(path, encoding="utf-8") as file:
        return file.read().splitlines()


def standing(table, column):
    """How errors of a column compare with those on Praun and Hoppe's maps, to the digits that these have."""
    cells = [[word.strip() for word in line.strip("|").split("|")] for line in table]
    head, ahead, equal, behind = cells[0], 0, [], []
    for row in cells[2:]:
        ours, theirs = row[head.index(column)].split(" / "), row[head.index("Praun-Hoppe map")].split(" / ")
        for bands, a, b in zip(BANDS, ours, theirs if len(theirs) == 3 else ()):
            name = f"{row[0].split('.')[0]} {bands}"
            step = 0.001 if float(b) >= 0.015 else 0.0001
            difference = round(float(a) / step) - round(float(b) / step)
            if difference < 0:
                ahead += 1
            else:
                (equal if difference == 0 else behind).append(name)
    said = f"- *{column}*: ahead in {ahead} of {ahead + len(equal) + len(behind)} cells"
    said += f", equal in {len(equal)} ({', '.join(equal)})" if equal else ""
    return said + (f", behind in {len(behind)} ({', '.join(behind)})." if behind else ".")


def main():
    with tempfile.TemporaryDirectory() as folder:
        text = ["# Tables and figures of the harmonics", "",
                "Section 3.3 of the dissertation, recomputed by `bench/harmonics/figures.py BUILD FOLDER`; errors are",
                "e(M, M^) for surfaces of area 4 pi, between vertices. N x N coefficients are the degrees 0 to N - 1.", "",
                "## Table 3.5: reconstruction errors", "",
                "By `bench-harmonics errors FOLDER`, at 6 x 6 / 16 x 16 / 32 x 32 coefficients of each coordinate: maps of method",
                "`stretch`, vertices weighted by area and equally; the same maps after ten rounds of `obc_harmonics_refine_map` at that",
                "degree, by area; least squares on maps of Praun and Hoppe's program (2003), whose figures are stored in the bench; and the",
                "dissertation's Table 3.5, with its own versions of the models.", ""]
        table = errors()
        text += table + ["", "Against least squares on the maps of Praun and Hoppe, at equal numbers of coefficients:", ""]
        text += [standing(table, column) for column in ("stretch map, by area", "all alike", "refined, by area")]
        text += ["",
                 "The columns *middles of edges* measure the fits where they have seen no sample: the middles of all edges, by the middle of their",
                 "directions. Where vertices are many for the coefficients, a refined map is as good there. The cow at 32 x 32 has less than three",
                 "vertices for each coefficient: its surface oscillates between them, on the refined map more than on the other."]
        text += ["", "## Figure 3.9: reconstructions", "",
                 "The model, then 6 x 6, 16 x 16 and 32 x 32 coefficients, on maps of method `stretch`, vertices weighted by area.", "",
                 "![Models and their reconstructions](images/harmonics_reconstruction.png)", ""]
        text += reconstructions(folder, {"bunny.ply": numpy.eye(3), "armadillo.ply": numpy.eye(3),
                                         "horse.ply": [[0, 1, 0], [0, 0, -1], [-1, 0, 0]]})
        for number, name, kind in (("3.10", "venus.ply", "venus"), ("3.11", "bunny.ply", "bunny")):
            text += ["", f"## Figure {number}: error against the weights, {kind}", "",
                     "Maps of method `angle-area` with the ratio of the weights of angles and areas in the head; in the picture",
                     "6 x 6 coefficients above, 16 x 16 below, the ratio by its logarithm, 0 at the left.", "",
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
