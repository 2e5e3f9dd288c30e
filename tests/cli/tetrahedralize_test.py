#!/usr/bin/env python3
"""orbicube tetrahedralize: what it writes is the solid that the surface encloses, and what it refuses has its reason.

    tetrahedralize_test.py COMMAND
"""
import json
import os
import signal
import subprocess
import time
from fractions import Fraction

from command import COMMAND, InFolder, main, read_obj, run


def read_medit(path):
    with open(path, encoding="ascii") as file:
        words = file.read().split()
    found = {}
    for name, size in (("Vertices", 4), ("Triangles", 4), ("Tetrahedra", 5)):
        start = words.index(name) + 2
        count = int(words[start - 1])
        rows = [words[start + size * i:start + size * (i + 1) - 1] for i in range(count)]
        found[name] = [tuple(map(float, row)) if size == 4 and name == "Vertices" else tuple(int(i) - 1 for i in row)
                       for row in rows]
    return found["Vertices"], found["Triangles"], found["Tetrahedra"]


def six_volumes(positions, cell):
    """Of a tetrahedron, in rational numbers."""
    a, b, c, d = (tuple(map(Fraction, positions[v])) for v in cell)
    u, v, w = ([p[i] - a[i] for i in range(3)] for p in (b, c, d))
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]))


def six_enclosed(positions, triangles):
    total = Fraction(0)
    for p, q, r in ([tuple(map(Fraction, positions[v])) for v in t] for t in triangles):
        total += (p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0])
                  + p[2] * (q[0] * r[1] - q[1] * r[0]))
    return total


class Tetrahedralize(InFolder):
    def test_the_solid_is_exactly_what_the_surface_encloses(self):
        for shape in ("creature", "bracket"):
            path = self.made(shape, 800)
            out, report = self.path("out.mesh"), self.path("report.json")
            done = run("tetrahedralize", path, "-o", out, "--report", report)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            surface, faces = read_obj(path)
            positions, triangles, tetrahedra = read_medit(out)
            self.assertEqual(positions[:len(surface)], surface)
            self.assertEqual(triangles, faces)
            volumes = [six_volumes(positions, cell) for cell in tetrahedra]
            self.assertGreater(min(volumes), 0)
            self.assertEqual(sum(volumes), six_enclosed(surface, faces))
            with open(report, encoding="utf-8") as file:
                figures = json.load(file)
            self.assertEqual(figures["tetrahedra"], len(tetrahedra))
            self.assertEqual(figures["vertices"], len(positions))
            self.assertEqual(figures["added_vertices"], len(positions) - len(surface))
            self.assertEqual((figures["parts"], figures["cavities"]), (1, 0))
            self.assertEqual(figures["cells"]["positive"], len(tetrahedra))
            self.assertAlmostEqual(figures["cells"]["volume"], float(sum(volumes)) / 6, 9)
            self.assertEqual(sum(figures["cells"]["dihedral_histogram"]), 6 * len(tetrahedra))

    def test_info_tells_of_the_solid_and_its_boundary(self):
        path, out, report = self.made("torus", 800), self.path("out.vtk"), self.path("report.json")
        self.assertEqual(run("tetrahedralize", path, "-o", out).returncode, 0)
        done = run("info", out, "--report", report)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        self.assertTrue(figures["valid_cells"]["usable"])
        self.assertEqual(figures["boundary"]["genus"], 1)
        self.assertEqual(figures["boundary"]["triangles"], len(read_obj(path)[1]))
        self.assertAlmostEqual(figures["boundary"]["volume"], figures["cells"]["volume"], 9)
        self.assertIn("dihedral angles", done.stdout)
        self.assertEqual(figures["usable_for"]["frames"], {"usable": True})
        self.assertFalse(figures["usable_for"]["tetrahedralize"]["usable"])

    def test_info_says_whether_a_surface_can_be_filled_as_the_verb_would(self):
        report, out = self.path("report.json"), self.path("out.mesh")
        positions, faces = read_obj(self.made("cube", 12))
        shifted = [[x + 0.5 for x in p] for p in positions]
        crossing = faces + [tuple(v + len(positions) for v in f) for f in faces]
        for corners, triangles in ((positions, faces), (positions, faces[1:]), (positions + shifted, crossing)):
            path = self.path("surface.obj")
            with open(path, "w", encoding="ascii") as file:
                file.writelines("v %r %r %r\n" % tuple(p) for p in corners)
                file.writelines("f %d %d %d\n" % tuple(v + 1 for v in t) for t in triangles)
            self.assertEqual(run("info", path, "--report", report).returncode, 0)
            with open(report, encoding="utf-8") as file:
                use = json.load(file)["usable_for"]["tetrahedralize"]
            if use["usable"]:
                self.assertEqual(triangles, faces)
                self.assertEqual(run("tetrahedralize", path, "-o", out).returncode, 0)
            else:
                self.refused(2, use["kind"], path, "tetrahedralize", path, "-o", out)

    def test_lengths_at_places_and_at_vertices(self):
        path, sizing, report = self.made("sphere", 600), self.path("sizing.txt"), self.path("report.json")
        vertices = len(read_obj(path)[0])

        def filled(lines, *options):
            with open(sizing, "w", encoding="ascii") as file:
                file.write(lines)
            done = run("tetrahedralize", path, "-o", self.path("out.mesh"), "--sizing", sizing, "--report", report, *options)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            with open(report, encoding="utf-8") as file:
                return json.load(file)["tetrahedra"]

        place = filled("# x y z length\n\n0 0 0 0.05\n")
        self.assertGreater(filled("0 0 0 0.05\n", "--growth", "0.1"), 2 * place)
        self.assertGreater(filled("0.08\n" * vertices), filled("1\n" * vertices))
        for text, kind in (("0.1\n", "truncated"), ("0.1\n" * (vertices + 1), "trailing-data"), ("0 0 0 0\n", "invalid-argument"),
                           ("0 0 0 0.1 2\n", "parse"), ("0 0\n", "parse"), ("0 0 0 inf\n", "non-finite")):
            with open(sizing, "w", encoding="ascii") as file:
                file.write(text)
            self.refused(2, kind, sizing, "tetrahedralize", path, "-o", self.path("none.mesh"), "--sizing", sizing)

    def test_options_make_more_and_the_same_in_every_run(self):
        path = self.made("sphere", 600)
        counts = {}
        for name, options in (("plain", ()), ("again", ()), ("fine", ("--max-volume", 1e-3)),
                              ("short", ("--edge-length", 0.1)), ("good", ("--quality", 1.1)),
                              ("coarse", ("--quality", 0)), ("cut", ("--cut-surface", "--max-volume", 1e-3))):
            out = self.path(name + ".mesh")
            self.assertEqual(run("tetrahedralize", path, "-o", out, *options).returncode, 0)
            with open(out, "rb") as file:
                counts[name] = file.read()
        self.assertEqual(counts["plain"], counts["again"])
        for finer in ("fine", "short", "good", "cut"):
            self.assertGreater(len(counts[finer]), len(counts["plain"]))
        self.assertLess(len(counts["coarse"]), len(counts["plain"]))

    def test_surfaces_that_cannot_be_filled_are_refused_for_their_reason(self):
        out = self.path("out.mesh")
        positions, faces = read_obj(self.made("cube", 12))

        def written(name, corners, triangles):
            path = self.path(name + ".obj")
            with open(path, "w", encoding="ascii") as file:
                file.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in corners)
                file.writelines(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in triangles)
            return path

        opened = written("open", positions, faces[1:])
        self.refused(2, "not-closed", opened, "tetrahedralize", opened, "-o", out)
        count = len(positions)
        twice = written("twice", positions + [(x + 0.5, y + 0.25, z + 0.125) for x, y, z in positions],
                        faces + [tuple(v + count for v in t) for t in faces])
        report = self.path("report.json")
        line = self.refused(2, "self-intersection", twice, "tetrahedralize", twice, "-o", out, "--report", report)
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        pairs = figures["self_intersecting_faces"]
        self.assertEqual(figures["self_intersections"], len(pairs))
        self.assertIn(f"{len(pairs)}; first faces {pairs[0][0]} and {pairs[0][1]}", line)
        self.assertTrue(all(a < len(faces) <= b for a, b in pairs))
        self.assertFalse(os.path.exists(out))

        solid = self.path("solid.mesh")
        self.assertEqual(run("tetrahedralize", self.path("cube.obj"), "-o", solid).returncode, 0)
        self.refused(2, "unsupported", solid, "tetrahedralize", solid, "-o", out)
        for ending in (".obj", ".glb"):
            wrong = self.path("out" + ending)
            self.refused(2, "unsupported-format", wrong, "tetrahedralize", solid, "-o", wrong)

    def test_time_limit_and_interrupt_end_tetgen_too(self):
        path, out = self.made("sphere", 600), self.path("out.mesh")
        endless = ("tetrahedralize", path, "-o", out, "--max-volume", "1e-8")
        start = time.monotonic()
        self.refused(1, "time-limit", path, *endless, "--time-limit", 1)
        self.assertLess(time.monotonic() - start, 20)  # at once; a busy machine may take its time
        process = subprocess.Popen([COMMAND, *endless], stderr=subprocess.PIPE, text=True, start_new_session=True)
        time.sleep(1)
        os.killpg(process.pid, signal.SIGINT)  # as a terminal does
        message = process.communicate(timeout=60)[1]
        self.assertEqual((process.returncode, message.split(": ")[2]), (1, "cancelled"), message)
        self.assertFalse(os.path.exists(out))
        with self.assertRaises(ProcessLookupError):
            os.killpg(process.pid, 0)  # nobody is left of its group


if __name__ == "__main__":
    main()
