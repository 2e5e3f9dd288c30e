#!/usr/bin/env python3
"""Maps from one surface to another, what they carry, and blends of several shapes.

    maps_test.py COMMAND
"""
import json
import math
import re

from command import InFolder, main, read_obj, run


class Reports(InFolder):
    def report(self, *arguments):
        path = self.path("report.json")
        done = run(*arguments, "--report", path)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(path, encoding="utf-8") as file:
            return json.load(file)


class Maps(Reports):
    def write(self, name, text):
        path = self.path(name)
        with open(path, "w", encoding="ascii") as file:
            file.write(text)
        return path

    def table(self, path):
        with open(path, encoding="ascii") as file:
            lines = file.read().splitlines()
        self.assertEqual(lines[0].replace(",", " "), "triangle weight0 weight1 weight2")
        rows = [line.replace(",", " ").split() for line in lines[1:]]
        return [(int(row[0]), [float(word) for word in row[1:]]) for row in rows]

    def test_the_table_names_the_points_that_the_mesh_has_and_maps_back(self):
        a, b = self.made("blob", 300), self.made("blob", 400, seed=1)
        for via in ("sphere", "polycube"):
            out, table, back = self.path("out.obj"), self.path("table.csv"), self.path("back.txt")
            report = self.report("map", a, b, "--via", via, "-o", out, "--table", table)
            from_a, triangles = read_obj(a)
            positions, corners = read_obj(b)
            on_b, same = read_obj(out)
            self.assertEqual(same, triangles)
            self.assertEqual((report["vertices"], report["points"], report["flipped"]), (len(from_a), len(from_a), 0))
            rows = self.table(table)
            for p, (triangle, weights) in zip(on_b, rows):
                self.assertAlmostEqual(sum(weights), 1, delta=1e-12)
                self.assertGreaterEqual(min(weights), 0)
                at = [sum(w * positions[v][k] for w, v in zip(weights, corners[triangle])) for k in range(3)]
                self.assertLess(math.dist(p, at), 1e-12)
            if via == "polycube":
                continue
            # The points come back near to the vertices that they are of: spheres are aligned anew.
            points = self.write("points.txt", "".join(f"{t} {w[0]} {w[1]} {w[2]}\n" for t, w in rows))
            self.report("map", b, a, "--via", via, "-o", out, "--points", points, "--table", back)
            for p, (triangle, weights) in zip(from_a, self.table(back)):
                at = [sum(w * from_a[v][k] for w, v in zip(weights, triangles[triangle])) for k in range(3)]
                self.assertLess(math.dist(p, at), 0.2)

    def test_a_surface_is_mapped_to_itself_by_the_identity(self):
        for via, shape in (("sphere", "blob"), ("polycube", "torus")):
            path, out = self.made(shape, 300), self.path("out.obj")
            self.report("map", path, path, "--via", via, "-o", out)
            self.assertLess(max(math.dist(p, q) for p, q in zip(read_obj(path)[0], read_obj(out)[0])), 1e-9)

    def test_values_of_one_surface_are_carried_to_the_other(self):
        a, b = self.made("blob", 300), self.made("blob", 400, seed=1)
        positions, triangles = read_obj(b)
        out, carried = self.path("out.obj"), self.path("values.csv")
        values = self.write("given.csv", "x,y,z\n" + "".join(",".join(map(repr, p)) + "\n" for p in positions))
        self.report("map", a, b, "-o", out, "--attributes", carried, "--values", values)
        with open(carried, encoding="ascii") as file:
            lines = file.read().splitlines()
        self.assertEqual(lines[0], "x,y,z")
        for p, line in zip(read_obj(out)[0], lines[1:]):
            self.assertLess(math.dist(p, [float(word) for word in line.split(",")]), 1e-12)
        # Colors of PLY and texture coordinates of OBJ, with a seam between triangles.
        ply = self.write("colored.ply", "ply\nformat ascii 1.0\n" + f"element vertex {len(positions)}\n"
                         "property double x\nproperty double y\nproperty double z\nproperty uchar red\n"
                         f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
                         + "".join(f"{x!r} {y!r} {z!r} 200\n" for x, y, z in positions)
                         + "".join("3 {} {} {}\n".format(*t) for t in triangles))
        for name in ("values.ply", "values.txt"):
            self.report("map", a, ply, "-o", out, "--attributes", self.path(name))
            with open(self.path(name), encoding="ascii") as file:
                text = file.read()
            self.assertIn("property uchar red\n" if name.endswith("ply") else "red\n", text)
        self.assertTrue(all(abs(float(line) - 200) < 1e-9 for line in text.splitlines()[1:]))
        obj = self.write("textured.obj", "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in positions) + "vt 0.25 1\nvt 0.75 1\n"
                         + "".join("f " + " ".join(f"{v + 1}/{i % 2 + 1}" for v in t) + "\n" for i, t in enumerate(triangles)))
        self.report("map", a, obj, "-o", out, "--attributes", carried)
        with open(carried, encoding="ascii") as file:
            rows = [line.split(",") for line in file.read().splitlines()]
        self.assertEqual(rows[0], ["s", "t"])
        self.assertTrue({round(float(row[0]), 9) for row in rows[1:]} <= {0.25, 0.75})
        self.assertTrue(all(abs(float(row[1]) - 1) < 1e-12 for row in rows[1:]))
        self.refused(2, "unsupported", b, "map", a, b, "-o", out, "--attributes", carried)
        short = self.write("short.csv", "1\n2\n")
        self.refused(2, "parse", short, "map", a, b, "-o", out, "--attributes", carried, "--values", short)

    def test_what_cannot_be_mapped_is_refused(self):
        ball, ring, out = self.made("blob", 300), self.made("torus", 300), self.path("out.obj")
        # Where a handle is, and what can be done.
        for options, advice in (((), "--via polycube"), (("--via", "polycube"), "orbicube repair --genus")):
            text = self.refused(2, "wrong-genus", ring, "map", ball, ring, "-o", out, *options)
            at = re.search(r"a handle is at \(.*\) \(vertex (\d+)\)", text)
            self.assertLess(int(at.group(1)), len(read_obj(ring)[0]))
            self.assertIn(advice, text)
        points = self.write("points.txt", "100000 1 0 0\n")
        self.refused(2, "invalid-argument", points, "map", ball, ball, "-o", out, "--table", self.path("t"), "--points", points)
        for options in (("--corners", 8), ("--via", "polycube", "--align", "none"), ("--points", points), ("--values", points)):
            done = run("map", ball, ball, "-o", out, *options)
            self.assertEqual(done.returncode, 2, options)
            self.assertTrue(done.stderr.startswith("orbicube: usage: "), done.stderr)


class Blends(Reports):
    def test_ten_shapes_are_blended_and_one_weight_is_that_shape(self):
        shapes = [self.made("blob", 200, seed=seed) for seed in range(10)]
        out = self.path("blend.obj")
        report = self.report("morph", *shapes, "-o", out, "--align", "none", "--blend", ",".join(["0.1"] * 10))
        self.assertEqual(report["blend"], [0.1] * 10)
        self.assertEqual([shape["flipped"] for shape in report["shapes"]], [0] * 10)
        self.assertEqual(len(read_obj(out)[0]), report["vertices"])
        self.report("morph", *shapes[:2], "-o", out, "--grid", "first", "--blend", "1,0")
        self.assertEqual(read_obj(out), read_obj(shapes[0]))

    def test_a_blend_through_a_polycube_has_quads(self):
        ring, out, quads = self.made("torus", 300), self.path("blend.obj"), self.path("quads.obj")
        other = self.made("torus", 400, seed=1)
        report = self.report("morph", ring, other, "-o", out, "--polycube", "--grid", "cells:300", "--blend", "0.25,0.75",
                             "--quads", quads)
        with open(quads, encoding="ascii") as file:
            lines = file.read().splitlines()
        faces = [line for line in lines if line.startswith("f ")]
        self.assertEqual(len(faces), report["quads"])
        self.assertTrue(all(len(face.split()) == 5 for face in faces))
        self.assertEqual(2 * len(faces), report["triangles"])

    def test_what_cannot_be_blended_is_refused(self):
        a, out = self.made("blob", 300), self.path("out.obj")
        for options in (("--blend", "1"), ("--blend", "1,2,3"), ("--blend", "1,x"), ("--blend", ".5,.5", "--seconds", 2),
                        ("--blend", ".5,.5", "--intermediates", 2), ("--quads", out),
                        ("--polycube", "--blend", ".5,.5", "--grid", "first", "--quads", out)):
            done = run("morph", a, a, "-o", out, *options)
            self.assertEqual(done.returncode, 2, options)
            self.assertTrue(done.stderr.startswith("orbicube: usage: "), done.stderr)


if __name__ == "__main__":
    main()
