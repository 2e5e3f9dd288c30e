#!/usr/bin/env python3
"""Which command computes each equation, algorithm, table and figure of the dissertation, and whether it still does.

    dissertation.py --write                  writes docs/dissertation.md from the list below
    dissertation.py BUILD [--models FOLDER] [--only WORD] [--timeout SECONDS]
                                             runs the rows (those whose label has WORD) and prints ok or the difference, and the seconds
    dissertation.py --check                  fails, with their names, where an equation, algorithm, table or figure of chapters 3 to 6 has
                                             no row in the page, or where --write would change the page

BUILD has cli/orbicube and the tests. Rows of real models are skipped, saying so, without FOLDER (ORBICUBE_MODELS), whose folders dev and
tets have them. The figures of our pages that a row names are read from the page. Exits with 1 where a row fails or --check finds something.
A label names one thing ("Eq. 3.1", "Figure 5.2a") or several ("Eq. 3.1-3.4").
"""

import argparse
import json
import math
import os
import re
import resource
import shlex
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PAGE = os.path.join(ROOT, "docs", "dissertation.md")


class Row:
    """A label, what it is, the commands, and checks: functions of the reports of the commands that return a difference or None."""

    def __init__(self, label, what, commands, *checks, model=False):
        self.label, self.what, self.commands, self.checks, self.model = label, what, commands.split(" && "), checks, model


def value(report, path):
    for key in path.split("."):
        report = report[int(key)] if isinstance(report, list) else report[key]
    return report


def near(path, expected, tolerance=1e-6):
    """The value at a path of the last report; `expected` may be a function, which reads a page."""
    def check(reports):
        wanted, found = expected() if callable(expected) else expected, value(reports[-1], path)
        if abs(found - wanted) <= tolerance * max(abs(wanted), 1e-300):
            return None
        return f"{path} is {found:.6g}, expected {wanted:.6g}"
    return check


def true(text, condition):
    return lambda reports: None if condition(reports[-1]) else "not so: " + text


def cell(page, heading, row, column):
    """The number in a table of docs/PAGE below a heading: of the row whose cells begin so, in the column of that head."""
    def read():
        with open(os.path.join(ROOT, "docs", page), encoding="utf-8") as file:
            part = file.read().split(heading, 1)[1]
        lines = [[word.strip() for word in line.strip()[1:-1].split("|")] for line in part.splitlines() if line.startswith("|")]
        head = lines[0]
        for line in lines:
            if row in (line[0], " ".join(line[:2]).strip()):
                return float(line[head.index(column)].split(" / ")[0])
        raise SystemExit(f"{page} has no row {row} below {heading}")
    return read


def frame_cell(mesh, index):
    """Mean, deviation or maximum with the symmetry, or curves and nodes, in the table of all meshes: method dissertation."""
    def read():
        with open(os.path.join(ROOT, "docs", "frame_field_tables.md"), encoding="utf-8") as file:
            line = next(line for line in file if line.startswith(f"| {mesh} |") and "`dissertation`" in line)
        cells = [word.strip() for word in line.strip("|\n ").split("|")]
        angles, structure = cells[4].split(" / "), cells[8].split(" + ")
        return float({"mean": angles[0], "sd": angles[1], "max": angles[4], "curves": structure[0], "nodes": structure[1]}[index])
    return read


def descends(report):
    course = report["convergence"]
    whole = [e for e, n in zip(course["energies"], course["vertices"]) if n == report["vertices"]]
    return len(whole) > 1 and whole == sorted(whole, reverse=True) and course["restarts"] == 0


def tetrahedron(label, what, key, expected):
    return Row(label, what, "orbicube sphere tetrahedron.obj -o map.obj", near(key, expected, 1e-9))


def test(label, what, program, case):
    return Row(label, what, f"BUILD/tests/test-{program} -tc={shlex.quote(case)}")


def distortion(number, model):
    heading = f"### Table {number}"
    return Row(f"Table {number}", f"distortion, {model}", f"orbicube sphere {model} -o map.obj --method dissertation",
               near("energy_angle", cell("sphere_map_tables.md", heading, "E_D", "our `dissertation`"), 5e-3),
               near("energy_area", cell("sphere_map_tables.md", heading, "E_A", "our `dissertation`"), 5e-3),
               near("flipped", 0), model=True)


def execution_time(model, printed):
    """The time of the processor, so that other processes do not count: of one thread of the map and of input and output."""
    return Row("Table 3.4", f"execution time, {model}: less than the printed {printed} s; there is no Buddha of genus 0",
               f"orbicube sphere {model} -o map.obj --method dissertation",
               lambda reports: None if (found := reports[0]["processor_seconds"]) < printed else f"{found:.1f} s of the processor", model=True)


def harmonics(label, what, model, method, bands, expected, more=""):
    return Row(label, what, f"orbicube sphere {model} -o map.obj {method} && "
               f"orbicube harmonics {model} --sphere map.obj --degree {bands - 1} -o c.sh{more}",
               near("error", expected, 2e-2), model=True)


def frames(number, name, model):
    return Row(f"Table {number}", f"{name}: angles of adjacent frames", f"orbicube frames {model}.mesh -o f.frames --method dissertation",
               *(near(f"angle_deg.{key}", frame_cell(model, key), 5e-3) for key in ("mean", "sd", "max")), model=True)


CREATURE = "orbicube make creature -o creature.obj --resolution 3000"
SOLID = "orbicube make bracket -o bracket.obj --resolution 1500 && orbicube tetrahedralize bracket.obj -o solid.mesh"

FRAMED = SOLID + " && orbicube frames solid.mesh -o f.frames --locally-meshable"
RESAMPLED = "orbicube volume {0} -o image.mesh --source source.mesh --resample hexes.mesh --cells 2000"


def constraints(label, what, more=""):
    return Row(label, what, FRAMED + " && orbicube parameterize solid.mesh -o map.vtk --frames f.frames" + more,
               true("constraints to rounding", lambda r: r["residual"] < 1e-12))


def resampled(number, model):
    return Row(f"Figure {number}", f"{model}: a regular grid taken to the solid by the inverse map; beside it our hexahedra",
               RESAMPLED.format(model) + f" && orbicube hex {model} -o ours.mesh --cells 2000",
               true("our hexahedra are positive", lambda r: r["min_scaled_jacobian"] > 0), model=True)


CHAPTER_5 = [
    Row("Eq. 5.1", "a map of a solid, with exact signs", SOLID + " && orbicube volume solid.mesh -o image.mesh --source source.mesh",
        true("tetrahedra", lambda r: r["tetrahedra"] > 0)),
    test("Eq. 5.2", "gradients: of a bar along its frames they are the frames", "volume-map", "a bar along its frames*"),
    Row("Eq. 5.3", "energy: `energy`, times the volume", FRAMED + " && orbicube parameterize solid.mesh -o map.vtk --frames f.frames",
        true("below that of a constant map, 3", lambda r: 0 < r["energy"] < 3)),
    *(test(f"Eq. 5.{k}", "gradient of one coordinate by areas and normals of faces", "volume-map", "gradients by areas and normals*")
      for k in (4, 5, 6)),
    constraints("Eq. 5.7", "transitions: `rotation` and `gap` in the file, `residual`"),
    *(constraints(f"Eq. 5.{k}", "the same at a corner of a face") for k in (8, 9, 10)),
    test("Eq. 5.11", "around singular edges", "volume-map", "transitions across faces and around singular edges*"),
    constraints("Section 5.1", "with integer gaps", " --integer"),
    Row("Section 5.1", "the rod along a field that is computed for it", "orbicube parameterize rod.mesh -o map.vtk",
        true("constraints to rounding", lambda r: r["residual"] < 1e-12), model=True),
    Row("Section 5.2", "boundary positions of a polycube, identity transitions, and frames inside",
        FRAMED + " && orbicube volume solid.mesh -o image.mesh --frames f.frames",
        true("the energy is at least the minimum with its boundary",
             lambda r: r["frames"]["energy"] >= r["frames"]["minimum_energy"] * (1 - 1e-9))),
    Row("Section 5.2", "the same of a ball; eleven solids are in [figures](volume_map_figures.md#maps-that-frames-guide)",
        "orbicube frames ball.mesh -o f.frames && orbicube volume ball.mesh -o image.mesh --frames f.frames",
        true("the minimum is below the energies of the map and of harmonic coordinates with its boundary",
             lambda r: r["frames"]["minimum_energy"] <= min(r["frames"]["energy"], r["frames"]["harmonic_energy"])), model=True),
    resampled("5.1", "rocker-arm.obj"),
    resampled("5.2a", "bumpy-torus.off"),
    resampled("5.2b", "three-torus.off"),
    resampled("5.3a", "bunny.ply"),
    resampled("5.3b", "hand.off"),
]

CHAPTER_3 = [
    tetrahedron("Eq. 3.1", "angle distortion as printed: `equation_3_1`", "equation_3_1", 64 / 3),
    tetrahedron("Eq. 3.2", "area distortion as printed: `equation_3_2`", "equation_3_2", 16 / (3 * math.pi)),
    tetrahedron("Eq. 3.3", "upper bound of the angle distortion, as printed: `equation_3_3`", "equation_3_3", 192),
    tetrahedron("Eq. 3.3", "read with E_D(T) as a density: `energy_angle`", "energy_angle", 288 / math.sqrt(3)),
    tetrahedron("Eq. 3.4", "upper bound of the area distortion: `equation_3_4`, `energy_area`", "equation_3_4", 48 / math.pi),
    tetrahedron("Eq. 3.5", "their weighted sum: `energy`", "energy", 28.8 / math.sqrt(3) + 48 / math.pi),
    test("Eq. 3.6", "priority of a vertex", "sphere-map", "The dissertation's priority is*"),
    test("Eq. 3.7", "violation of the optimality condition", "sphere-map", "The dissertation's priority is*"),
    test("Eq. 3.8", "first-order condition: where the search ends", "sphere-map", "The great-circle search lowers*"),
    test("Eq. 3.9", "its residual, which is eq. 3.7", "sphere-map", "The great-circle search lowers*"),
    Row("Algorithm 1", "global optimization, with eta 20",
        CREATURE + " && orbicube sphere creature.obj -o map.obj --method dissertation --level-splits 20",
        true("a bijection", lambda r: r["bijective"]),
        true("a level every 20 splits", lambda r: len(set(r["convergence"]["vertices"])) > r["vertices"] // 20 - 5)),
    test("Algorithm 2", "great-circle search of a vertex", "sphere-map", "The great-circle search*"),
    distortion("3.1", "bunny.ply"),
    distortion("3.2", "cow-split.obj"),
    distortion("3.3", "gargoyle-split.obj"),
    *(execution_time(*model) for model in (("cow-split.obj", 21), ("frog-split.obj", 48), ("bunny.ply", 58), ("horse.ply", 89),
                                           ("david-split.obj", 111), ("venus.ply", 70), ("gargoyle-split.obj", 193),
                                           ("armadillo-split.obj", 250))),
    harmonics("Table 3.5", "reconstruction of the bunny, 6 x 6", "bunny.ply", "--method dissertation", 6,
              cell("sphere_map_tables.md", "## Table 3.5", "Bunny", "our `dissertation`")),
    test("Figure 3.1", "two cases of the search", "sphere-map", "The great-circle search*"),
    Row("Figure 3.2", "energy by iteration: `convergence`", CREATURE + " && orbicube sphere creature.obj -o map.obj --method dissertation",
        true("energies of the whole mesh descend", descends)),
    Row("Figure 3.3", "the bunny's map, in a page", "orbicube sphere bunny.ply -o map.obj --method dissertation --page map.html",
        true("a bijection", lambda r: r["bijective"]), model=True),
    *(Row(f"Figure {number}", f"{name}: distortion in colors, harmonic map beside ours", f"orbicube sphere {name} -o harmonic.obj --method "
          f"conformal && orbicube sphere {name} -o ours.obj --page ours.html && orbicube page {name} harmonic.obj {name} ours.obj -o both.html",
          model=True)
      for number, name in (("3.4", "bunny.ply"), ("3.5", "cow.off"), ("3.6", "max-planck.obj"), ("3.7", "gargoyle.ply"))),
    Row("Figure 3.8", "more maps, in pages", "orbicube sphere horse.ply -o map.obj --page map.html",
        true("a bijection", lambda r: r["bijective"]), model=True),
    harmonics("Figure 3.9", "reconstruction of the horse, 16 x 16", "horse.ply", "--method stretch", 16,
              cell("harmonics_figures.md", "## Figure 3.9", "horse.ply", "16 x 16"), " --reconstruct horse16.obj"),
    harmonics("Figure 3.10", "error against the weights, venus, ratio 0.2", "venus.ply", "--method angle-area --angle-weight 0.2", 6,
              cell("harmonics_figures.md", "## Figure 3.10", "6 x 6", "0.2")),
    harmonics("Figure 3.11", "the same, bunny, ratio 0", "bunny.ply", "--method angle-area --angle-weight 0", 6,
              cell("harmonics_figures.md", "## Figure 3.11", "6 x 6", "0")),
    Row("Figure 3.12", "distances of shapes: `compare`",
        "orbicube make blob -o a.obj --seed 1 && orbicube make blob -o b.obj --seed 4 && orbicube sphere a.obj -o sa.obj && "
        "orbicube sphere b.obj -o sb.obj && orbicube harmonics a.obj --sphere sa.obj --degree 16 -o a.sh && "
        "orbicube harmonics b.obj --sphere sb.obj --degree 16 -o b.sh && orbicube compare a.sh b.sh a.sh -o matrix.txt --png matrix.png",
        true("equal shapes have distance 0, others do not", lambda r: r["distance"][0][2] == 0 < r["distance"][0][1])),
]

TWO = "orbicube make l-shape -o a.obj --resolution 600 && orbicube make l-shape -o b.obj --resolution 600 --seed 1 && "
SECTION_4_5 = [
    test("Section 4.5", "energy of several maps to one polycube, E = sum of E(f_i)", "polycube", "Two shapes share the proportions*"),
    test("Section 4.5", "map between shapes, f_ij = f_j^-1 o f_i: the identity for i = j, and f_ji undoes f_ij", "correspondence",
         "The map of a shape to itself is the identity*"),
    Row("Section 4.5", "the same for the vertices of a shape", TWO + "orbicube map a.obj b.obj --via polycube -o on-b.obj --table points.csv",
        true("a point for each vertex", lambda r: r["points"] == r["vertices"])),
    Row("Section 4.5", "horse on cow: no triangle of the overlay is flipped", "orbicube map horse.ply cow.off --via polycube -o on-cow.ply",
        true("none is flipped, by exact signs", lambda r: r["flipped"] == 0), model=True),
    Row("Section 4.5", "maps of one shape with a polycube's corners and proportions in turn",
        TWO + "orbicube polycube a.obj -o p.obj --domain p.json && orbicube polycube a.obj b.obj -o q.obj --from p.json --optimize all "
        "--corner-search gradient",
        true("the energy does not rise", lambda r: r["polycube"]["energies"] == sorted(r["polycube"]["energies"], reverse=True))),
    Row("Figure 4.8", "horse and cow on one polycube, beside those of their own: `energy_over_own`",
        "orbicube polycube horse.ply cow.off -o p.obj --page p.html", true("a sum near those of their own",
                                                                           lambda r: r["polycube"]["energy_over_own"] < 1.5), model=True),
    Row("Figure 4.9", "a map before and after the optimization; Bimba and Max-Planck are in [figures](polycube_figures.md)",
        "orbicube make blob -o a.obj --resolution 1000 && orbicube polycube a.obj -o p.obj --corners 8 --optimize all --corner-search gradient --glb p.glb",
        true("the energy falls", lambda r: r["corner_optimization"]["energies"][-1] < r["corner_optimization"]["energies"][0])),
    Row("Figure 4.10", "three shapes blended over one polycube, as mesh and quads",
        TWO + "orbicube make l-shape -o c.obj --resolution 600 --seed 2 && orbicube morph a.obj b.obj c.obj --polycube --grid cells:1000 "
        "--blend .2,.5,.3 -o mixed.obj --quads quads.obj",
        true("no triangle is flipped on the polycube", lambda r: r["flipped"] == 0),
        true("triangles are halves of quads", lambda r: r["triangles"] == 2 * r["quads"])),
    Row("Figure 4.10", "horse, cow and another cow", "orbicube morph horse.ply cow.off spot.obj --polycube --blend .2,.5,.3 -o mixed.ply "
        "--quads quads.obj", true("no triangle is flipped on the polycube", lambda r: r["flipped"] == 0), model=True),
]

L_SHAPE = "orbicube make l-shape -o a.obj --resolution 3000 && "
PRINTED = L_SHAPE + "orbicube polycube a.obj -o p.obj --method dissertation"


def polycube_case(label, what, case):
    return test(label, what, "polycube", case)


def optimized_domain(label, what):
    return Row(label, what, PRINTED, true("proportions are optimized", lambda r: r["dissertation"]["domain_evaluations"] > 0),
               true("the energy falls", lambda r: r["dissertation"]["energies"][-1] < r["dissertation"]["energies"][0]))


def table_4_2(model, corners, result):
    """A row of Table 4.2 by the printed method: its distortion after the optimization, from our page."""
    return Row("Table 4.2", f"{model}, at most {corners} corner points, the printed method, of whose octrees the one of 8 has a map; "
               "all rows are in [tables](polycube_tables.md)",
               f"orbicube polycube {model} -o p.obj --method dissertation --corners {corners}",
               true("angles after the optimization", lambda r: abs(r["distortion"]["angle_mean"] - result) < 2e-3),
               near("corner_points", 8), model=True)


CHAPTER_4 = [
    polycube_case("Eq. 4.1", "harmonic maps of rectangles, cotangent weights", "Harmonic maps of a box*"),
    *(polycube_case(f"Eq. 4.{k}", what, "Energies of rectangles are eqs. 4.2 to 4.4*")
      for k, what in ((2, "harmonic energy of one coordinate, over the rectangles"), (3, "area term"), (4, "their sum with the weight alpha"),
                      (5, "energy of a coordinate by the proportions beta"), (6, "the same by alpha and beta"), (7, "area term by alpha and beta"),
                      (8, "their sum"))),
    polycube_case("Eq. 4.8", "derivative of the sum, against differences", "The derivative of the energy of proportions*"),
    polycube_case("Eq. 4.9", "constraints of the proportions: the area stays", "Optimal proportions keep the area*"),
    optimized_domain("Eq. 4.10", "minimization with bounds and rows, by projected gradients"),
    test("Eq. 4.11", "steps along projected directions, to known minima", "projected-gradient", "Hock and Schittkowski*"),
    test("Eq. 4.12", "Barzilai-Borwein steps", "projected-gradient", "Random quadratics in a box with rows*"),
    test("Eq. 4.13", "their closed form", "projected-gradient", "Random quadratics in a box with rows*"),
    polycube_case("Eq. 4.14", "energy over two coordinates of each corner point", "A corner point that is displaced*"),
    test("Eq. 4.15", "signed sums of squares within bounds", "trust-region", "Signed sums go to the same minimum*"),
    test("Eq. 4.16", "models of minimum norm in a trust region", "trust-region", "Updated point by point*"),
    Row("Algorithm 3", "proportions and corners in turn: `energies` under `dissertation`", PRINTED,
        true("the energy does not rise", lambda r: r["dissertation"]["energies"] == sorted(r["dissertation"]["energies"], reverse=True)),
        true("it ends", lambda r: r["dissertation"]["converged"])),
    Row("Table 4.1", "the column of this library: automatic, optimal, at most N corners, common",
        TWO + "orbicube polycube a.obj b.obj -o q.obj --corners 20 --optimize all --corner-search gradient",
        true("at most 20 corners", lambda r: r["polycube"]["corners"] <= 20)),
    table_4_2("bimba.obj", 20, 1.109),
    table_4_2("david.obj", 60, 1.047),
    Row("Table 4.3", "the weight alpha of areas: 1.5 after 0.1; real models are in [tables](polycube_tables.md)",
        "orbicube make blob -o a.obj --resolution 1000 && "
        "orbicube polycube a.obj -o p.obj --corners 8 --optimize all --corner-search gradient --area-weight 0.1 && "
        "orbicube polycube a.obj -o q.obj --corners 8 --optimize all --corner-search gradient --area-weight 1.5",
        lambda reports: None if reports[-1]["distortion"]["area_mean"] < reports[-2]["distortion"]["area_mean"]
        and reports[-1]["distortion"]["angle_mean"] > reports[-2]["distortion"]["angle_mean"] else "not so: areas for angles"),
    Row("Figure 4.1", "dual graph of the patches, in the file of the domain", L_SHAPE + "orbicube polycube a.obj -o p.obj --domain p.json",
        true("eight patches", lambda r: r["patches"] == 8)),
    Row("Figure 4.2", "initial map, domain and map optimized in turn", PRINTED + " --page p.html",
        true("the energy falls", lambda r: r["dissertation"]["energies"][-1] < r["dissertation"]["energies"][0])),
    polycube_case("Figure 4.3", "construction by an octree, whose faces are merged", "Merged rectangles cover*"),
    polycube_case("Figure 4.4", "coordinates alpha and beta of a polycube", "Optimal proportions keep the area*"),
    optimized_domain("Figure 4.5", "domain before and after: `distortion_before`"),
    polycube_case("Figure 4.6", "corners that move to where the energy is less", "A corner point that is displaced*"),
    Row("Figure 4.7", "corners of the horse move, on a polycube of at most 60",
        "orbicube polycube horse.ply -o p.obj --corners 60 --optimize corners --corner-search gradient",
        true("the energy falls", lambda r: r["corner_optimization"]["energies"][-1] < r["corner_optimization"]["energies"][0]), model=True),
    Row("Figure 4.11", "more corners, less distortion: bimba by 8 and by 20",
        "orbicube polycube bimba.obj -o p.obj --corners 8 && orbicube polycube bimba.obj -o q.obj --corners 20",
        lambda reports: None if reports[-1]["distortion"]["angle_mean"] <= reports[-2]["distortion"]["angle_mean"] else "not so: angles", model=True),
    Row("Figure 4.12", "weights 1000 and 0.01 of areas",
        "orbicube make blob -o a.obj --resolution 1000 && "
        "orbicube polycube a.obj -o p.obj --corners 8 --optimize domain --area-weight 1000 && "
        "orbicube polycube a.obj -o q.obj --corners 8 --optimize domain --area-weight 0.01",
        lambda reports: None if reports[-1]["distortion"]["angle_mean"] <= reports[-2]["distortion"]["angle_mean"] else "not so: angles for areas"),
    Row("Figure 4.13", "domain of a torus", "orbicube make torus -o a.obj --resolution 2000 && orbicube polycube a.obj -o p.obj --optimize domain",
        true("genus 1", lambda r: r["genus"] == 1)),
]

CHAPTER_6 = [
    test("Eq. 6.1", "quaternions", "quaternion", "The product is Hamilton's*"),
    test("Eq. 6.2", "by axis and angle", "quaternion", "Axis and angle*"),
    test("Eq. 6.3", "frames as rotations", "quaternion", "Every rotation comes back from its matrix*"),
    test("Eq. 6.4", "rotation from frame to frame", "quaternion", "A unit quaternion turns vectors actively*"),
    test("Eq. 6.5", "the same by quaternions", "quaternion", "Inverse and normalization work*"),
    test("Eq. 6.6", "angle up to the 24 rotations", "quaternion", "The distance of frames is*"),
    test("Eq. 6.7", "matchings", "quaternion", "Equal frames and common rotations*"),
    test("Eq. 6.8", "cosine of half the angle", "quaternion", "The nearest element is the one*"),
    Row("Eq. 6.9", "angles of adjacent frames: `angle_deg`", SOLID + " && orbicube frames solid.mesh -o f.frames --method dissertation",
        true("at most 62.8 degrees", lambda r: 0 < r["angle_deg"]["max"] < 62.81)),
    test("Eq. 6.10", "energy of a face", "frame-field", "A smoothed field is a minimum*"),
    test("Eq. 6.11", "its derivative", "sphere-optimizer", "Algorithm 2 as printed lowers the energy*"),
    Row("Eq. 6.12", "energy of a field, shifted by the number of inner faces: `E`",
        SOLID + " && orbicube frames solid.mesh -o f.frames --method dissertation && "
        "orbicube frames solid.mesh -o g.frames --start-field f.frames --unchanged",
        lambda reports: near("E", reports[-2]["E"], 1e-9)(reports)),
    test("Section 6.1.4", "the sextic with matchings on the sphere: every field is a minimum of it", "frame-field",
         "with matchings free on the sphere*"),
    frames("6.1", "rod", "rod"),
    Row("Table 6.2", "bunny: no tetrahedral mesh of the printed size; of another in [tables](frame_field_tables.md)", SOLID +
        " && orbicube frames solid.mesh -o f.frames --method dissertation", true("a field", lambda r: r["E"] > 0)),
    frames("6.3", "fertility", "fertility"),
    frames("6.4", "joint", "joint"),
    frames("6.5", "hanger", "hanger"),
    frames("6.6", "rocker arm", "rockerarm"),
    Row("Table 6.7", "singularities of the rod: `curves`, `nodes`", "orbicube frames rod.mesh -o f.frames --method dissertation",
        near("curves", frame_cell("rod", "curves"), 2e-2), near("nodes", frame_cell("rod", "nodes"), 0.3), model=True),
    test("Figure 6.1", "frames as quaternions", "quaternion", "A unit quaternion turns vectors actively*"),
    test("Figure 6.2", "types of parametric lines: the 24 rotations", "quaternion", "The elements are 24 different rotations*"),
    Row("Figure 6.3", "distribution of angles", SOLID + " && orbicube frames solid.mesh -o f.frames --method dissertation --plot angles.png",
        true("all faces are counted", lambda r: sum(r["histogram"]) == r["interior_faces"])),
]
CHAPTERS = (("Chapter 3: spherical maps", CHAPTER_3), ("Chapter 4: polycube maps", CHAPTER_4),
            ("Section 4.5: polycubes of several objects", SECTION_4_5),
            ("Chapter 5: volumetric parameterization", CHAPTER_5), ("Chapter 6: frame fields", CHAPTER_6))
INTRODUCTION = """# The dissertation, by command

Written by `scripts/dissertation.py --write` from the list that `scripts/dissertation.py BUILD` runs; each row is printed as ok or with its difference from
the value that is known or from our page. `tetrahedron.obj` is a regular tetrahedron, whose figures are computed by hand; a name with `-split` is a
model with each triangle split in four, as in [the tables of sphere maps](sphere_map_tables.md). Complete tables beside the printed figures:
[sphere maps](sphere_map_tables.md), [harmonics](harmonics_figures.md), [frame fields](frame_field_tables.md). Where a method departs from the text,
[sphere_map](sphere_map.md#the-dissertations-method), [polycube](polycube.md#the-dissertations-method) and [frame_field](frame_field.md#the-dissertations-tables) say so.
"""


def write():
    lines = [INTRODUCTION]
    for title, rows in CHAPTERS:
        lines += [f"## {title}", "", "| | what | command |", "|---|---|---|"]
        lines += [f"| {row.label} | {row.what} | " + "<br>".join("`" + c.replace("|", "\\|") + "`" for c in row.commands) + " |" for row in rows]
        lines.append("")
    return "\n".join(lines)


# The numbered things of chapters 3 to 6: of which chapter, and up to which number. Algorithms are numbered through.
NUMBERED = {"Eq.": ((3, 9), (4, 16), (5, 11), (6, 12)),
            "Table": ((3, 5), (4, 3), (6, 7)),
            "Figure": ((3, 12), (4, 13), (5, 3), (6, 3))}
NAMES = [f"{kind} {chapter}.{k}" for kind, chapters in NUMBERED.items() for chapter, last in chapters for k in range(1, last + 1)]
NAMES += [f"Algorithm {k}" for k in (1, 2, 3)]


def names_of(label):
    """The names in a label, which may have ranges, lists and parts: of "Eq. 3.1-3.3, 3.5" four, of "Figure 5.2a" one."""
    kind, _, numbers = label.partition(" ")
    found = set()
    for part in re.split(r", *| and ", numbers):
        ends = [re.fullmatch(r"((?:\d+\.)?)(\d+)[a-z]?", end.strip()) for end in re.split("[-\u2013]", part)]
        if not all(ends):
            return set()
        found |= {f"{kind} {ends[0][1]}{k}" for k in range(int(ends[0][2]), int(ends[-1][2]) + 1)}
    return found


def missing_names(page):
    """The names that no row of the page has, in their order."""
    labels = [line.split("|")[1].strip() for line in page.splitlines() if line.startswith("|")]
    named = set().union(*map(names_of, labels))
    return [name for name in NAMES if name not in named]


def check():
    """What is wrong with the page, or an empty text."""
    with open(PAGE, encoding="utf-8") as file:
        page = file.read()
    missing = missing_names(page)
    if missing:
        return "docs/dissertation.md has no row for " + ", ".join(missing)
    return "" if page == write() else "docs/dissertation.md is not what scripts/dissertation.py --write writes"


def processor_seconds():
    """Of all commands that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Runner:
    def __init__(self, build, models, folder, timeout):
        self.timeout, self.end = timeout, None
        self.build, self.models, self.folder, self.known = os.path.abspath(build), models, folder, {}
        corners = ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))
        with open(self.at("tetrahedron.obj"), "w", encoding="ascii") as file:
            file.writelines("v %d %d %d\n" % corner for corner in corners)
            file.write("f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n")

    def at(self, name):
        return os.path.join(self.folder, name)

    def input(self, word):
        """A model of that name is linked into the folder, or made of one."""
        if not self.models or os.path.exists(self.at(word)):
            return
        for folder in ("dev", "tets"):
            path = os.path.join(self.models, folder, word)
            if os.path.exists(path):
                os.symlink(path, self.at(word))
                return
        split = re.fullmatch(r"(\w+)-split\.obj", word)
        if split:
            whole = next(n for n in (split[1] + end for end in (".off", ".ply", ".obj")) if os.path.exists(os.path.join(self.models, "dev", n)))
            self.input(whole)
            self.run(f"orbicube convert {whole} {split[1]}-whole.obj")
            self.split(self.at(split[1] + "-whole.obj"), self.at(word))

    @staticmethod
    def split(source, target):
        points, faces, middles = [], [], {}
        with open(source, encoding="ascii") as file:
            for line in file:
                words = line.split()
                if words[:1] == ["v"]:
                    points.append(tuple(map(float, words[1:4])))
                elif words[:1] == ["f"]:
                    faces.append([int(word.split("/")[0]) - 1 for word in words[1:4]])

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(points)
                points.append(tuple((x + y) / 2 for x, y in zip(points[a], points[b])))
            return middles[key]
        with open(target, "w", encoding="ascii") as file:
            finer = []
            for a, b, c in faces:
                d, e, f = middle(a, b), middle(b, c), middle(c, a)
                finer += [(a, d, f), (d, b, e), (f, e, c), (d, e, f)]
            file.writelines("v %.17g %.17g %.17g\n" % p for p in points)
            file.writelines("f %d %d %d\n" % (a + 1, b + 1, c + 1) for a, b, c in finer)

    def run(self, command):
        """The report of a command of ours; of others an empty one. Raises CalledProcessError."""
        words = shlex.split(command.replace("BUILD", self.build))
        if words[0] == "orbicube":
            for word in words[1:]:
                self.input(word)
            words[0] = os.path.join(self.build, "cli", "orbicube")
            words += ["--quiet", "--report", "report.json"]
        start = processor_seconds()
        done = subprocess.run(words, cwd=self.folder, check=True, capture_output=True, text=True,
                              timeout=max(1, self.end - time.monotonic()) if self.end else None)
        if re.search(r"test cases: +0 \|", done.stdout):
            raise subprocess.CalledProcessError(1, words, stderr="no test has that name")
        if "--report" not in words:
            return {}
        with open(self.at("report.json"), encoding="utf-8") as file:
            return {**json.load(file), "processor_seconds": processor_seconds() - start}

    def outcome(self, row):
        if row.model and not self.models:
            return "skipped: no models"
        if row.commands[0].startswith("BUILD") and not os.path.exists(row.commands[0].split(" -tc=")[0].replace("BUILD", self.build)):
            return "skipped: " + row.commands[0].split(" ")[0] + " is not built"
        self.end = time.monotonic() + self.timeout if self.timeout else None
        try:
            # Several rows read the report of one command on a model; commands that follow need its files, too.
            if row.model and len(row.commands) == 1 and row.commands[0] not in self.known:
                self.known[row.commands[0]] = self.run(row.commands[0])
            if len(row.commands) == 1 and row.commands[0] in self.known:
                reports = [self.known[row.commands[0]]]
            else:
                reports = [self.run(command) for command in row.commands]
        except subprocess.TimeoutExpired as error:
            return f"failed: not done after {self.timeout} s: {shlex.join(map(os.path.basename, error.cmd[:2]))}"
        except subprocess.CalledProcessError as error:
            return "failed: " + (error.stderr or error.stdout or "").strip().splitlines()[-1]
        differences = [difference for check in row.checks if (difference := check(reports))]
        return "; ".join(differences) or "ok"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?")
    parser.add_argument("--models", default=os.environ.get("ORBICUBE_MODELS"))
    parser.add_argument("--only", default="")
    parser.add_argument("--timeout", type=float, help="seconds that a row may take [default: no limit]")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--check", action="store_true", help="fail when a name has no row, or --write would change the page")
    options = parser.parse_args()
    if options.write:
        with open(PAGE, "w", encoding="utf-8") as file:
            file.write(write())
    if options.check:
        sys.exit(check() or 0)
    if not options.build:
        return
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(options.build, options.models, folder, options.timeout)
        for _, rows in CHAPTERS:
            for row in rows:
                if options.only in row.label:
                    start = time.monotonic()
                    outcome = runner.outcome(row)
                    wrong += not outcome.startswith(("ok", "skipped"))
                    print(f"{row.label:12} {time.monotonic() - start:6.1f} s  {outcome}", flush=True)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
