"""The verbs harmonics and compare, tried from outside: the sums that files hold are evaluated here again."""
import json
import math
import os
import unittest

from command import InFolder, main, not_positive, read_obj, run
from png_rows import Png


def legendre(degree, order, x):
    """P_lm without the Condon-Shortley phase."""
    value = 1.0
    for k in range(1, order + 1):
        value *= (2 * k - 1) * math.sqrt((1 - x) * (1 + x))
    before = 0.0
    for l in range(order + 1, degree + 1):
        before, value = value, ((2 * l - 1) * x * value - (l + order - 1) * before) / (l - order)
    return value


def norm(degree, order):
    return math.sqrt((2 * degree + 1) * math.factorial(degree - order) / math.factorial(degree + order))


def read_shtools(path):
    """Blocks of {(l, m): (C, S)}."""
    blocks = []
    with open(path, encoding="ascii") as file:
        for line in file:
            if line.startswith("#"):
                continue
            l, m, c, s = line.split(",")
            if (int(l), int(m)) == (0, 0):
                blocks.append({})
            blocks[-1][int(l), int(m)] = float(c), float(s)
    return blocks


def evaluate(block, direction):
    x, y, z = direction
    phi = math.atan2(y, x)
    return sum(norm(l, m) * (math.sqrt(2) if m else 1) * legendre(l, m, z) *
               (c * math.cos(m * phi) + s * math.sin(m * phi)) for (l, m), (c, s) in block.items())


def read_spharm(path):
    with open(path, encoding="ascii") as file:
        words = file.read().replace("{", " ").replace("}", " ").replace(",", " ").split()
    numbers = list(map(float, words[1:]))
    assert len(numbers) == 3 * int(words[0])
    return [numbers[i:i + 3] for i in range(0, len(numbers), 3)]


class Harmonics(InFolder):
    def mapped(self, shape="creature", resolution=1500, seed=0):
        path = self.made(shape, resolution, seed, f"{shape}{seed}.obj")
        sphere = path[:-4] + ".sphere.obj"
        done = run("sphere", path, "-o", sphere, "--quiet")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return path, sphere

    def fitted(self, path, sphere, degree, name, *arguments):
        report = self.path("report.json")
        done = run("harmonics", path, "--sphere", sphere, "--degree", degree, "-o", self.path(name), "--report", report,
                   *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(report, encoding="utf-8") as file:
            return json.load(file)

    def test_the_written_coefficients_make_the_written_surface(self):
        path, sphere = self.mapped()
        out = self.path("again.obj")
        report = self.fitted(path, sphere, 6, "c.sh", "--reconstruct", out)
        self.fitted(path, sphere, 6, "c.coef")
        directions, _ = read_obj(sphere)
        rebuilt, triangles = read_obj(out)
        self.assertEqual(triangles, read_obj(path)[1])
        blocks = read_shtools(self.path("c.sh"))
        self.assertEqual(len(blocks), 3)
        triples = read_spharm(self.path("c.coef"))
        for v in range(0, len(directions), 97):
            length = math.sqrt(sum(c * c for c in directions[v]))
            direction = [c / length for c in directions[v]]
            phi, z = math.atan2(direction[1], direction[0]), direction[2]
            for k in range(3):
                self.assertAlmostEqual(evaluate(blocks[k], direction), rebuilt[v][k], delta=1e-12)
                total = 0
                for l in range(7):
                    for m in range(l + 1):
                        # SPHARM-PDM's function: orthonormal, with the phase.
                        y = norm(l, m) / math.sqrt(4 * math.pi) * (-1) ** m * legendre(l, m, z)
                        if m == 0:
                            total += triples[l * l][k] * y
                        else:
                            total += y * (triples[l * l + 2 * m - 1][k] * math.cos(m * phi) +
                                          triples[l * l + 2 * m][k] * math.sin(m * phi))
                self.assertAlmostEqual(total, rebuilt[v][k], delta=1e-12)
        self.assertEqual(report["command"], "harmonics")
        self.assertEqual((report["degree"], report["unknowns"], report["rank"]), (6, 49, 49))
        self.assertEqual(len(report["degree_norms"]), 7)
        # The error by a plain search.
        original, _ = read_obj(path)
        scale = math.sqrt(4 * math.pi / report["area"])

        def mean(a, b):
            return sum(min(math.dist(p, q) for q in b) for p in a) / len(a)
        self.assertAlmostEqual(report["error"], scale * max(mean(original, rebuilt), mean(rebuilt, original)), delta=1e-12)

    def test_more_degrees_come_nearer(self):
        path, sphere = self.mapped(resolution=3000)
        errors = [self.fitted(path, sphere, degree, "c.sh")["error"] for degree in (2, 6, 12)]
        self.assertGreater(errors[0], 1.5 * errors[1])
        self.assertGreater(errors[1], 1.5 * errors[2])

    def test_a_refined_map_comes_nearer_and_stays_one_to_one(self):
        path, sphere = self.mapped()
        refined = self.path("refined.obj")
        before = self.fitted(path, sphere, 6, "c.sh")
        after = self.fitted(path, sphere, 6, "c.sh", "--refine-map", 5, "--refined-map", refined)
        self.assertLess(after["error"], 0.9 * before["error"])
        found = after["refinement"]
        self.assertAlmostEqual(found["residual_before"], before["residual"], delta=1e-9 * before["residual"])
        self.assertAlmostEqual(found["residual"], after["residual"], delta=1e-9 * after["residual"])
        self.assertEqual(not_positive(*read_obj(refined)), 0)
        self.assertAlmostEqual(self.fitted(path, refined, 6, "d.sh")["error"], after["error"], delta=1e-9)
        out = self.path("e.sh")
        for options, named in ((("--refined-map", refined), "--refine-map"),
                               (("--refine-map", 3, "--refined-map", self.path("m.stl")), "unsupported-format")):
            done = run("harmonics", path, "--sphere", sphere, "--degree", 6, "-o", out, *options)
            self.assertEqual(done.returncode, 2)
            self.assertIn(named, done.stderr)
            self.assertFalse(os.path.exists(out))

    def test_a_map_in_glb_is_read_as_well(self):
        path, _ = self.mapped()
        glb = self.path("map.glb")
        self.assertEqual(run("sphere", path, "-o", glb, "--quiet").returncode, 0)
        report = self.fitted(path, glb, 6, "c.sh")
        self.assertEqual(report["rank"], 49)

    def test_filters_keep_their_degrees(self):
        path, sphere = self.mapped()
        self.fitted(path, sphere, 6, "all.sh")
        self.fitted(path, sphere, 6, "low.sh", "--low", 3)
        self.fitted(path, sphere, 6, "high.sh", "--high", 4)
        self.fitted(path, sphere, 6, "band.sh", "--band", 2, 3)
        whole = read_shtools(self.path("all.sh"))
        for name, kept in (("low.sh", range(0, 4)), ("high.sh", [0, 4, 5, 6]), ("band.sh", [0, 2, 3])):
            for some, all_of in zip(read_shtools(self.path(name)), whole):
                for (l, m), value in some.items():
                    self.assertEqual(value, all_of[l, m] if l in kept else (0, 0))

    def test_too_few_vertices_are_told(self):
        path, sphere = self.mapped(resolution=400)
        report = self.fitted(path, sphere, 20, "c.sh")
        self.assertLess(report["rank"], 441)
        self.assertLessEqual(report["rank"], report["vertices"])
        self.assertTrue(any("rank-deficient" in note for note in report["notes"]))
        smooth = self.fitted(path, sphere, 20, "c.sh", "--regularization", 1e-6)
        self.assertEqual((smooth["rank"], smooth["notes"]), (441, []))

    def test_what_is_wrong_is_said(self):
        path, sphere = self.mapped()
        other, _ = self.mapped("blob", 600)
        out = self.path("c.sh")
        self.refused(2, "invalid-argument", sphere, "harmonics", other, "--sphere", sphere, "--degree", 4, "-o", out)
        self.refused(2, "unsupported-format", self.path("c.obj"), "harmonics", path, "--sphere", sphere, "--degree", 4, "-o",
                     self.path("c.obj"))
        self.refused(2, "io", self.path("no.obj"), "harmonics", path, "--sphere", self.path("no.obj"), "--degree", 4, "-o",
                     out)
        self.assertEqual(run("harmonics", path, "--sphere", sphere, "--degree", 4, "-o", out, "--low", 2, "--high",
                             3).returncode, 2)
        self.assertFalse(os.path.exists(out))

    def test_compare_gives_the_distances_as_text_and_picture(self):
        files = []
        for seed in range(3):
            path, sphere = self.mapped("blob", 800, seed)
            name = f"blob{seed}.sh"
            self.fitted(path, sphere, 5, name)
            files.append(self.path(name))
        table, picture, report = self.path("matrix.txt"), self.path("matrix.png"), self.path("compare.json")
        done = run("compare", *files, "-o", table, "--png", picture, "--report", report, "--keep-size")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        norms = []
        for file in files:
            squares = [0.0] * 6
            for block in read_shtools(file):
                for (l, _), (c, s) in block.items():
                    squares[l] += 4 * math.pi * (c * c + s * s)
            norms.append([math.sqrt(s) for s in squares])
        with open(table, encoding="utf-8") as file:
            rows = [list(map(float, line.split())) for line in file if not line.startswith("#")]
        for i in range(3):
            for j in range(3):
                expected = sum((a - b) ** 2 for a, b in zip(norms[i], norms[j]))
                self.assertAlmostEqual(rows[i][j], expected, delta=1e-12 * (1 + expected))
        with open(report, encoding="utf-8") as file:
            self.assertEqual(json.load(file)["distance"], rows)
        with open(picture, "rb") as file:
            png = Png(file.read())
        # The diagonal is black, the largest distance light yellow.
        self.assertEqual((png.bits, png.color), (8, 2))
        rows_of = png.rows
        self.assertEqual(rows_of[30][90:93], bytes(3))
        largest = max(max(row) for row in rows)
        i, j = next((i, j) for i in range(3) for j in range(3) if rows[i][j] == largest)
        at = 3 * (30 + 64 * j)
        self.assertEqual(rows_of[30 + 64 * i][at:at + 3], bytes((255, 255, 190)))
        self.assertNotIn("\033", done.stdout)  # colors are for terminals
        lines = done.stdout.splitlines()
        self.assertEqual([line.split()[:2] for line in lines[1:]], [[str(k + 1), f"blob{k}.sh"] for k in range(3)])

    def test_shapes_of_other_sizes_are_alike_unless_sizes_are_kept(self):
        path, sphere = self.mapped("blob", 800)
        self.fitted(path, sphere, 6, "a.sh")
        large = self.path("large.obj")
        positions, triangles = read_obj(path)
        with open(large, "w", encoding="ascii") as file:
            file.writelines("v %r %r %r\n" % tuple(7 * c for c in p) for p in positions)
            file.writelines("f %d %d %d\n" % tuple(c + 1 for c in t) for t in triangles)
        self.fitted(large, sphere, 6, "b.sh")
        report = self.path("compare.json")
        for options, alike in (((), True), (("--keep-size",), False)):
            done = run("compare", self.path("a.sh"), self.path("b.sh"), "--min-degree", 1, "--report", report, *options)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            with open(report, encoding="utf-8") as file:
                figures = json.load(file)
            self.assertAlmostEqual(figures["size"][1] / figures["size"][0], 7, delta=1e-9)
            self.assertEqual(figures["distance"][0][1] < 1e-20, alike)

    def test_a_turned_copy_is_brought_to_lie_as_the_other(self):
        path, sphere = self.mapped("creature", 1500)
        self.fitted(path, sphere, 10, "a.sh")
        turned = self.path("turned.obj")
        positions, triangles = read_obj(path)
        with open(turned, "w", encoding="ascii") as file:  # a third of a turn about (1, 1, 1)
            file.writelines("v %r %r %r\n" % (p[2], p[0], p[1]) for p in positions)
            file.writelines("f %d %d %d\n" % tuple(c + 1 for c in t) for t in triangles)
        report = self.fitted(turned, sphere, 10, "b.sh", "--align-to", self.path("a.sh"))
        self.assertAlmostEqual(report["alignment"]["turn_degrees"], 120, delta=1e-3)
        self.assertAlmostEqual(report["alignment"]["correlation"], 1, delta=1e-9)
        for a, b in zip(read_shtools(self.path("a.sh")), read_shtools(self.path("b.sh"))):
            for key, pair in a.items():
                for x, y in zip(pair, b[key]):
                    self.assertAlmostEqual(x, y, delta=1e-6)

    def test_flipped_triangles_and_lengths_of_a_map_are_told(self):
        path, sphere = self.mapped("blob", 600)
        directions, triangles = read_obj(sphere)

        def write(directions):
            with open(self.path("map.obj"), "w", encoding="ascii") as file:
                file.writelines("v %r %r %r\n" % tuple(d) for d in directions)
                file.writelines("f %d %d %d\n" % tuple(c + 1 for c in t) for t in triangles)
        self.assertEqual(self.fitted(path, sphere, 4, "c.sh")["map"]["flipped"], 0)
        v = triangles[10][0]
        write([[-c for c in d] if k == v else d for k, d in enumerate(directions)])
        report = self.fitted(path, self.path("map.obj"), 4, "c.sh")
        self.assertGreater(report["map"]["flipped"], 0)
        self.assertEqual(report["map"]["flipped"], not_positive(read_obj(self.path("map.obj"))[0], triangles))
        self.assertTrue(any("flips" in note for note in report["notes"]))
        write([[2 * c for c in d] if k % 2 else d for k, d in enumerate(directions)])
        report = self.fitted(path, self.path("map.obj"), 4, "c.sh")
        self.assertAlmostEqual(report["map"]["length_max"], 2, delta=1e-12)
        self.assertTrue(any("lengths" in note for note in report["notes"]))
        # A mirrored map is one of a surface that is inward-oriented, and no fault; one of random points is no map.
        write([[-d[0], d[1], d[2]] for d in directions])
        self.assertEqual(self.fitted(path, self.path("map.obj"), 4, "c.sh")["map"]["flipped"], 0)
        write([directions[(97 * k) % len(directions)] for k in range(len(directions))])
        line = self.refused(2, "invalid-argument", self.path("map.obj"), "harmonics", path, "--sphere",
                            self.path("map.obj"), "--degree", 4, "-o", self.path("c.sh"))
        self.assertIn("orbicube sphere", line)

    def test_compare_refuses_damaged_and_different_files(self):
        good, bad, one = self.path("good.sh"), self.path("bad.coef"), self.path("one.sh")
        with open(good, "w", encoding="ascii") as file:
            file.write("0, 0, 1, 0\n" * 3)
        with open(one, "w", encoding="ascii") as file:
            file.write("0, 0, 1, 0\n")
        with open(bad, "w", encoding="ascii") as file:
            file.write("{ 4,{1, 2, 3}")
        line = self.refused(2, "truncated", bad, "compare", good, bad)
        self.assertIn("line 1", line)
        self.refused(2, "invalid-argument", one, "compare", good, one)


if __name__ == "__main__":
    main()
