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
        surface = self.made("cube", 600)
        self.refused(2, "unsupported-format", surface, "untangle", surface, "-o", out)


if __name__ == "__main__":
    main()
