#!/usr/bin/env python3
"""orbicube untangle: what it writes is positive by rational arithmetic, what stays stays, refusals have their reasons.

    untangle_test.py COMMAND
"""
import json
import os
import random
from fractions import Fraction

from command import InFolder, main, run
from tetrahedra import box, write_medit


def unit_box(n):
    """Positions and tetrahedra of the unit cube, and whether a vertex is on its boundary."""
    points, cells = box(n)
    return [[c / n for c in p] for p in points], cells, [any(c in (0, n) for c in p) for p in points]


def read_medit(path):
    with open(path, encoding="ascii") as file:
        words = file.read().split()
    start = words.index("Vertices") + 2
    positions = [[float(c) for c in words[start + 4 * i:start + 4 * i + 3]] for i in range(int(words[start - 1]))]
    start = words.index("Tetrahedra") + 2
    return positions, [[int(v) - 1 for v in words[start + 5 * i:start + 5 * i + 4]] for i in range(int(words[start - 1]))]


def positive(positions, cell):
    a, b, c, d = ([Fraction(x) for x in positions[v]] for v in cell)
    u, v, w = ([p[i] - a[i] for i in range(3)] for p in (b, c, d))
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
            + u[2] * (v[0] * w[1] - v[1] * w[0])) > 0


class Untangle(InFolder):
    def tangled(self, n):
        positions, cells, boundary = unit_box(n)
        write_medit(self.path("rest.mesh"), positions, cells)
        generator = random.Random(5)
        moved = [p if fixed else [generator.random() for _ in p] for p, fixed in zip(positions, boundary)]
        write_medit(self.path("tangled.mesh"), moved, cells)
        return positions, cells, boundary

    def flat(self, n, z=0.5):
        """A square of n by n squares cut in two with strewn inner vertices, as OBJ; its rest positions, triangles, and which are fixed."""
        points = [[x, y] for y in range(n + 1) for x in range(n + 1)]
        triangles = [t for y in range(n) for x in range(n) for p in [(n + 1) * y + x]
                     for t in ([p, p + 1, p + n + 2], [p, p + n + 2, p + n + 1])]
        boundary = [any(c in (0, n) for c in p) for p in points]
        generator = random.Random(7)
        moved = [p if fixed else [n * generator.random(), n * generator.random()] for p, fixed in zip(points, boundary)]
        for name, places, height in (("flat.obj", moved, lambda p: z), ("surface.obj", points, lambda p: p[0] * p[1] / n)):
            with open(self.path(name), "w", encoding="ascii") as file:
                file.writelines(f"v {p[0]!r} {p[1]!r} {height(p)!r}\n" for p in places)
                file.writelines("f " + " ".join(str(v + 1) for v in t) + "\n" for t in triangles)
        return moved, triangles, boundary

    def read_obj(self, path):
        with open(path, encoding="ascii") as file:
            rows = [line.split() for line in file]
        return ([[float(c) for c in row[1:]] for row in rows if row and row[0] == "v"],
                [[int(v) - 1 for v in row[1:]] for row in rows if row and row[0] == "f"])

    def test_a_flat_mesh_is_positive_and_its_boundary_stays(self):
        moved, triangles, boundary = self.flat(6)
        out, report = self.path("out.obj"), self.path("report.json")
        for more in ([], ["--rest", self.path("surface.obj")]):
            done = run("untangle", self.path("flat.obj"), "-o", out, "--report", report, *more)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("triangles, all positive", done.stdout + done.stderr)
            result, same = self.read_obj(out)
            self.assertEqual(same, triangles)
            for corners in triangles:
                a, b, c = ([Fraction(x) for x in result[v]] for v in corners)
                self.assertGreater((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 0)
            for p, q, fixed in zip(moved, result, boundary):
                self.assertEqual(q[2], 0.5)
                if fixed:
                    self.assertEqual(p, q[:2])
            with open(report, encoding="utf-8") as file:
                figures = json.load(file)
            self.assertEqual((figures["inverted"], figures["triangles"]), (0, 72))
            self.assertGreater(figures["inverted_before"], 10)

    def test_flat_meshes_are_refused_with_reasons(self):
        self.flat(4)
        flat, surface, out = self.path("flat.obj"), self.path("surface.obj"), self.path("out.obj")
        self.refused(2, "unsupported", surface, "untangle", surface, "-o", out)  # it is not flat
        self.refused(2, "unsupported-format", self.path("out.stl"), "untangle", flat, "-o", self.path("out.stl"))
        done = run("untangle", flat, "-o", out, "--solver", "petsc")
        self.assertEqual(done.returncode, 2)
        self.refused(1, "no-valid-result", out, "untangle", flat, "-o", out, "--steps", 0)
        self.assertEqual(run("untangle", flat, "-o", out, "--steps", 0, "--keep-partial").returncode, 1)
        self.assertTrue(os.path.exists(out))

    def test_all_are_positive_and_the_boundary_stays(self):
        positions, cells, boundary = self.tangled(4)
        out, report = self.path("out.mesh"), self.path("report.json")
        done = run("untangle", self.path("tangled.mesh"), "-o", out, "--rest", self.path("rest.mesh"), "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        result, same = read_medit(out)
        self.assertEqual(same, cells)
        self.assertTrue(all(positive(result, t) for t in cells))
        for p, q, fixed in zip(positions, result, boundary):
            if fixed:
                self.assertEqual(p, q)
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        self.assertEqual(figures["inverted"], 0)
        self.assertGreater(figures["inverted_before"], 50)
        self.assertGreater(figures["min_determinant"], 0)

    def test_threads_do_not_matter_and_vtk_holds_the_same(self):
        self.tangled(3)
        texts = []
        for threads in (1, 3):
            out = self.path("out%d.mesh" % threads)
            done = run("untangle", self.path("tangled.mesh"), "-o", out, "--threads", threads)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(out, encoding="ascii") as file:
                texts.append(file.read())
        self.assertEqual(texts[0], texts[1])
        vtk = self.path("out.vtk")
        self.assertEqual(run("untangle", self.path("tangled.mesh"), "-o", vtk).returncode, 0)
        self.assertEqual(run("convert", vtk, self.path("again.mesh")).returncode, 0)
        self.assertEqual(read_medit(self.path("again.mesh")), read_medit(self.path("out1.mesh")))

    def test_a_boundary_that_lies_over_itself_is_reported(self):
        positions, cells, _ = unit_box(2)
        out, report = self.path("out.mesh"), self.path("report.json")
        for shift, meets in ((0.3, True), (1.5, False)):
            both = positions + [[c + shift for c in p] for p in positions]
            write_medit(self.path("two.mesh"), both, cells + [[v + len(positions) for v in t] for t in cells])
            done = run("untangle", self.path("two.mesh"), "-o", out, "--report", report)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            with open(report, encoding="utf-8") as file:
                figures = json.load(file)
            self.assertEqual(figures["self_intersections"] > 0, meets)
            self.assertEqual("intersects itself" in done.stdout, meets)
            self.assertEqual(any("intersects itself" in note for note in figures["notes"]), meets)

    def test_without_steps_it_fails_and_keeps_what_it_has_on_request(self):
        self.tangled(3)
        out, tangled = self.path("out.mesh"), self.path("tangled.mesh")
        self.refused(1, "no-valid-result", out, "untangle", tangled, "-o", out, "--steps", 0)
        self.assertFalse(os.path.exists(out))
        done = run("untangle", tangled, "-o", out, "--steps", 0, "--keep-partial")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(read_medit(out), read_medit(tangled))

    def test_wrong_input_is_refused(self):
        positions, cells, _ = self.tangled(3)
        out, tangled = self.path("out.mesh"), self.path("tangled.mesh")
        self.refused(2, "unsupported-format", self.path("out.obj"), "untangle", tangled, "-o", self.path("out.obj"))
        write_medit(self.path("other.mesh"), positions, cells[1:])
        self.refused(2, "unsupported", self.path("other.mesh"), "untangle", tangled, "-o", out, "--rest",
                     self.path("other.mesh"))
        self.refused(2, "inverted-cell", tangled, "untangle", tangled, "-o", out, "--rest", tangled)
        self.refused(2, "unsupported-format", self.path("in.txt"), "untangle", self.path("in.txt"), "-o", out)


if __name__ == "__main__":
    main()
