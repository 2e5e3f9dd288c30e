#!/usr/bin/env python3
"""Figures 5.1 to 5.3 of the dissertation: hexahedra by resampling a regular grid, beside those of `orbicube hex`.

    figures.py ORBICUBE MODELS [--write]

MODELS is a folder with the models. Prints the table; with --write into docs/volume_map_figures.md.
"""
import json
import os
import subprocess
import sys
import tempfile

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "docs", "volume_map_figures.md")
MODELS = (("5.1", "rocker-arm.obj"), ("5.2 a", "bumpy-torus.off"), ("5.2 b", "three-torus.off"), ("5.3 a", "bunny.ply"),
          ("5.3 b", "hand.off"))
CELLS = 2000
HEAD = f"""# Hexahedra of figures 5.1 to 5.3 of the dissertation

Written by `bench/volume_map/figures.py`. Left: `orbicube volume MODEL -o IMAGE --resample HEXAHEDRA --cells {CELLS}`, the printed method: a regular grid on the polycube, whose
vertices are taken to the solid by the inverse of the map. Right: `orbicube hex MODEL -o HEXAHEDRA --cells {CELLS}`. Scaled Jacobians are of the worst corner of each
hexahedron; not positive: hexahedra with a corner that is not, by exact signs. Seconds of the whole command on a shared machine of two cores.

| figure | model | resampled | not positive | min / mean | s | ours | not positive | min / mean | distance, % | s |
|---|---|---|---|---|---|---|---|---|---|---|
"""


def run(folder, *words):
    """The report; of a failure the last line of what the command says."""
    report = os.path.join(folder, "report.json")
    done = subprocess.run([*words, "--quiet", "--report", report], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        return None, done.stderr.strip().splitlines()[-1]
    with open(report, encoding="utf-8") as file:
        return json.load(file), ""


def row(orbicube, models, figure, model):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(models, model)
        map_report, reason = run(folder, orbicube, "volume", path, "-o", "image.mesh", "--resample", "grid.mesh", "--cells", str(CELLS))
        if map_report:
            r = map_report["resampled"]
            left = [r["hexahedra"], r["not_positive"], f"{r['min_scaled_jacobian']:.2f} / {r['mean_scaled_jacobian']:.3f}",
                    f"{map_report['seconds']:.0f}"]
        else:
            left = ["none: " + reason.split(": ", 2)[-1], "", "", ""]
        hex_report, reason = run(folder, orbicube, "hex", path, "-o", "hexes.mesh", "--cells", str(CELLS))
        if hex_report:
            right = [hex_report["hexahedra"], 0, f"{hex_report['min_scaled_jacobian']:.2f} / {hex_report['mean_scaled_jacobian']:.3f}",
                     f"{hex_report['hausdorff_percent']:.2f}", f"{hex_report['seconds']:.0f}"]
        else:
            right = ["none: " + reason.split(": ", 2)[-1], "", "", "", ""]
    return "| " + " | ".join(str(x) for x in [figure, model.split(".")[0], *left, *right]) + " |\n"


def main():
    orbicube, models = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    text = HEAD
    for figure, model in MODELS:
        text += row(orbicube, models, figure, model)
        print(text.splitlines()[-1], flush=True)
    if "--write" in sys.argv:
        with open(PAGE, encoding="utf-8") as file:
            guided = "".join(file.read().partition("\n## Maps that frames guide")[1:])  # written by guided.py
        with open(PAGE, "w", encoding="utf-8") as file:
            file.write(text + guided)


main()
