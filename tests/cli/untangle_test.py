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

    def bipyramid(self, name, positions):
        """Tetrahedra of regions 4 to 6 around an edge, one triangle between two of them and one of the boundary."""
        cells = [[0, 1, 2, 3], [0, 1, 3, 4], [0, 1, 4, 2]]
        write_medit(self.path(name), positions, cells)
        with open(self.path(name), encoding="ascii") as file:
            text = file.read()
        for region, cell in enumerate(cells):
            line = " ".join(str(v + 1) for v in cell)
            text = text.replace(line + " 0", f"{line} {region + 4}")
        with open(self.path(name), "w", encoding="ascii") as file:
            file.write(text.replace("End\n", "Triangles\n2\n1 2 3 8\n1 3 4 9\nEnd\n"))
        return cells

    def test_tetrahedra_around_an_edge_outside_are_split_at_it(self):
        # The edge passes outside of the triangle in the middle.
        positions = [[0, 0, -1], [3, 0, 1], [1, 0, 0], [-0.5, 0.75, 0], [-0.5, -0.75, 0]]
        shapes = [[0, 0, -1], [0, 0, 1]] + positions[2:]
        self.bipyramid("rest.mesh", shapes)
        self.bipyramid("in.mesh", positions)
        out, source, report = (self.path(name) for name in ("out.mesh", "source.mesh", "report.json"))
        self.refused(1, "no-valid-result", out, "untangle", self.path("in.mesh"), "-o", out)
        done = run("untangle", self.path("in.mesh"), "-o", out, "--rest", self.path("rest.mesh"), "--refine", "--source", source,
                   "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("1 vertex added", done.stdout)
        result, cells = read_medit(out)
        shape, same = read_medit(source)
        self.assertEqual((len(result), len(cells), cells), (6, 6, same))
        self.assertEqual((result[:5], shape), (positions, shapes + [[0, 0, 0]]))
        for t in cells:
            self.assertTrue(positive(result, t) and positive(shape, t))
        for path in (out, source):
            with open(path, encoding="ascii") as file:
                words = file.read().split()
            start = words.index("Tetrahedra") + 2
            self.assertEqual(sorted(words[start + 4:start + 30:5]), ["4", "4", "5", "5", "6", "6"])
            start = words.index("Triangles") + 1
            self.assertEqual(words[start:start + 5], ["1", "1", "3", "4", "9"])
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        self.assertEqual([figures[key] for key in ("vertices", "tetrahedra", "splits", "split_elements", "inverted_before", "inverted")],
                         [6, 6, 1, 3, 2, 0])
        self.assertTrue(any("left out" in note for note in figures["notes"]))

    def test_a_flat_mesh_is_split_where_a_corner_is_straight(self):
        moved, triangles, boundary = self.flat(4)
        moved[4] = [3.5, 0.5]  # the only triangle of this corner is flat
        flat, out, source, report = (self.path(name) for name in ("flat.obj", "out.obj", "source.obj", "report.json"))
        with open(flat, "w", encoding="ascii") as file:
            file.writelines(f"v {p[0]!r} {p[1]!r} 0.5\n" for p in moved)
            file.writelines("f " + " ".join(str(v + 1) for v in t) + "\n" for t in triangles)
        self.refused(1, "no-valid-result", out, "untangle", flat, "-o", out)
        done = run("untangle", flat, "-o", out, "--refine", "--rest", self.path("surface.obj"), "--source", source, "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        result, parts = self.read_obj(out)
        shape, same = self.read_obj(source)
        self.assertEqual(parts, same)
        self.assertEqual(len(shape), len(result))
        self.assertEqual(shape[:len(moved)], self.read_obj(self.path("surface.obj"))[0])
        for corners in parts:
            a, b, c = ([Fraction(x) for x in result[v]] for v in corners)
            self.assertGreater((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 0)
        for p, q, fixed in zip(moved, result, boundary):
            if fixed:
                self.assertEqual(p + [0.5], q)
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        self.assertEqual(figures["splits"], len(result) - len(moved))
        self.assertGreater(figures["splits"], 0)
        done = run("untangle", flat, "-o", out, "--source", source)
        self.assertEqual(done.returncode, 2)

    def test_what_needs_no_split_stays_whole(self):
        self.tangled(3)
        out, same, report = self.path("out.mesh"), self.path("same.mesh"), self.path("report.json")
        self.assertEqual(run("untangle", self.path("tangled.mesh"), "-o", out).returncode, 0)
        self.assertEqual(run("untangle", self.path("tangled.mesh"), "-o", same, "--refine", "--report", report).returncode, 0)
        self.assertEqual(read_medit(out), read_medit(same))
        with open(report, encoding="utf-8") as file:
            self.assertEqual(json.load(file)["splits"], 0)

    def test_flat_meshes_are_refused_with_reasons(self):
        self.flat(4)
        flat, surface, out = self.path("flat.obj"), self.path("surface.obj"), self.path("out.obj")
        self.refused(2, "unsupported", surface, "untangle", surface, "-o", out)  # it is not flat
        self.refused(2, "unsupported-format", self.path("out.stl"), "untangle", flat, "-o", self.path("out.stl"))
        done = run("untangle", flat, "-o", out, "--solver", "petsc")
        self.assertEqual(done.returncode, 2)
        self.refused(1, "no-valid-result", out, "untangle", flat, "-o", out, "--max-steps", 0)
        self.assertEqual(run("untangle", flat, "-o", out, "--max-steps", 0, "--keep-partial").returncode, 1)
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
        self.refused(1, "no-valid-result", out, "untangle", tangled, "-o", out, "--max-steps", 0)
        self.assertFalse(os.path.exists(out))
        done = run("untangle", tangled, "-o", out, "--max-steps", 0, "--keep-partial")
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
