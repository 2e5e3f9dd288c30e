#!/usr/bin/env python3
"""What the command does with sphere maps: remeshing, geometry images, morphs.

    uses_test.py COMMAND
"""
import json
import math
import random
import struct

from command import Glb, InFolder, long, main, read_obj, run
from png_rows import Png


class Uses(InFolder):
    def report(self, *arguments):
        path = self.path("report.json")
        done = run(*arguments, "--report", path)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(path, encoding="utf-8") as file:
            return json.load(file), done.stdout


def closed_sphere(triangles):
    """Whether each edge is passed once in both directions and Euler's number is 2; so for one component."""
    edges = {(t[k], t[(k + 1) % 3]) for t in triangles for k in range(3)}
    vertices = {v for t in triangles for v in t}
    return (len(edges) == 3 * len(triangles) and all((b, a) in edges for a, b in edges)
            and len(vertices) - len(edges) // 2 + len(triangles) == 2)


def volume(positions, triangles):
    return sum(p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) + p[2] * (q[0] * r[1] - q[1] * r[0])
               for p, q, r in ((positions[i] for i in t) for t in triangles)) / 6


class Remesh(Uses):
    def test_each_grid_gives_a_closed_surface_near_the_shape(self):
        blob = self.made("blob", 4000, seed=3)
        wanted = volume(*read_obj(blob))
        for grid, vertices in (("icosphere:4", 2562), ("cube:20", 2402), ("latitude:30", 1742), ("octahedron:50", 2502)):
            out, remesh = self.path("map.obj"), self.path("remesh.obj")
            report, text = self.report("sphere", blob, "-o", out, "--remesh", remesh, "--grid", grid)
            positions, triangles = read_obj(remesh)
            self.assertEqual(len(positions), vertices)
            self.assertTrue(closed_sphere(triangles))
            self.assertAlmostEqual(volume(positions, triangles) / wanted, 1, delta=0.03)
            figures = report["remesh"]
            self.assertEqual((figures["grid"], figures["vertices"], figures["triangles"]), (grid, vertices, len(triangles)))
            self.assertLess(figures["distance"]["to_surface"]["rms_of_diagonal"], 0.005)
            self.assertLess(figures["distance"]["from_surface"]["max_of_diagonal"], 0.05)
            self.assertIn(remesh, text)
            self.assertEqual(len(read_obj(out)[0]), report["vertices"])

    @long
    def test_a_finer_grid_is_nearer(self):
        creature = self.made("creature", 6000)
        distances = []
        for level in (3, 4, 5):
            report, _ = self.report("sphere", creature, "-o", self.path("map.obj"), "--remesh", self.path("remesh.ply"),
                                    "--grid", f"icosphere:{level}")
            distances.append(report["remesh"]["distance"]["from_surface"]["rms"])
        self.assertLess(distances[1], 0.6 * distances[0])
        self.assertLess(distances[2], 0.6 * distances[1])

    def test_glb_has_normals(self):
        blob, remesh = self.made("blob"), self.path("remesh.glb")
        self.assertEqual(run("sphere", blob, "-o", self.path("map.obj"), "--remesh", remesh, "--grid", "cube:6").returncode, 0)
        with open(remesh, "rb") as file:
            data = file.read()
        document = json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])
        self.assertIn("NORMAL", document["meshes"][0]["primitives"][0]["attributes"])

    def test_wrong_grids_and_files_are_told_before_any_work(self):
        blob, out, remesh = self.made("blob"), self.path("map.obj"), self.path("remesh.obj")
        for grid in ("teapot", "icosphere:", "icosphere:11", "icosphere:-1", "cube:0", "cube:x", "octahedron:3", "latitude:1"):
            done = run("sphere", blob, "-o", out, "--remesh", remesh, "--grid", grid)
            self.assertEqual(done.returncode, 2, grid)
            self.assertRegex(done.stderr, r"\Aorbicube: usage: --grid[^\n]*\n\Z")
        self.refused(2, "unsupported-format", self.path("remesh.xyz"), "sphere", blob, "-o", out, "--remesh", self.path("remesh.xyz"))
        self.refused(2, "unsupported-format", self.path("image.jpg"), "sphere", blob, "-o", out, "--image", self.path("image.jpg"))
        done = run("sphere", blob, "-o", out, "--image", self.path("image.png"), "--image-grid", "icosphere:3")
        self.assertEqual(done.returncode, 2)


def read_png_16(path):
    """Width, height, and rows of 16-bit numbers of an RGB image, and its box."""
    with open(path, "rb") as file:
        png = Png(file.read())
    assert (png.bits, png.color) == (16, 2)
    pixels = [struct.unpack(f">{3 * png.width}H", row) for row in png.rows]
    return png.width, png.height, pixels, [float(x) for x in png.texts["orbicube-box"].split()]


class Images(Uses):
    def test_a_png_holds_points_of_the_surface_in_its_box_and_has_no_seam(self):
        blob, image = self.made("blob", 3000), self.path("image.png")
        report, _ = self.report("sphere", blob, "-o", self.path("map.obj"), "--image", image, "--image-grid", "octahedron:32")
        width, height, pixels, box = read_png_16(image)
        self.assertEqual((width, height), (33, 33))
        self.assertEqual((report["image"]["width"], report["image"]["seam_gap"]), (33, 0))
        for i in range(33):
            for a, b in ((pixels[0], pixels[0]), (pixels[32], pixels[32])):
                self.assertEqual(a[3 * i:3 * i + 3], b[3 * (32 - i):3 * (32 - i) + 3])
        positions, _ = read_obj(blob)
        for axis in range(3):
            values = [p[axis] for p in positions]
            self.assertLessEqual(min(values) - 1e-9, box[axis])
            self.assertGreaterEqual(max(values) + 1e-9, box[3 + axis])
        self.assertLess(report["image"]["distance"]["to_surface"]["rms_of_diagonal"], 0.005)

    def test_a_float_file_of_the_cube(self):
        blob, image = self.made("blob", 3000), self.path("image.pfm")
        report, _ = self.report("sphere", blob, "-o", self.path("map.obj"), "--image", image, "--image-grid", "cube:20")
        with open(image, "rb") as file:
            self.assertEqual([file.readline() for _ in range(3)], [b"PF\n", b"63 42\n", b"-1.0\n"])
            self.assertEqual(len(file.read()), 63 * 42 * 12)
        self.assertEqual(report["image"]["seam_gap"], 0)


class Morphs(Uses):
    def test_both_shapes_are_in_one_mesh_and_the_weights_move(self):
        a, b = self.made("creature", 3000), self.made("star", 4000)
        out = self.path("morph.glb")
        report, text = self.report("morph", a, b, "-o", out)
        self.assertIn("wrote", text)
        glb = Glb(out, texture=False)
        self.assertEqual(glb.target_names, ["star"])
        self.assertTrue(closed_sphere(glb.triangles))
        counts = [len(read_obj(path)[0]) for path in (a, b)]
        self.assertGreaterEqual(len(glb.positions), sum(counts))
        self.assertLessEqual(len(glb.positions), 3 * sum(counts))
        self.assertEqual(report["vertices"], len(glb.positions))
        # Both shapes' volumes, and every vertex of both, within float32.
        for path, state in ((a, glb.positions), (b, glb.sphere(True))):
            positions, triangles = read_obj(path)
            self.assertAlmostEqual(volume(state, glb.triangles) / volume(positions, triangles), 1, delta=0.02)
            for p in positions[::37]:  # sums of base and delta are off by a rounding of float32 here and there
                self.assertLess(min(math.dist(p, q) for q in state), 1e-6)
        self.assertEqual([shape["flipped"] for shape in report["shapes"]], [0, 0])
        self.assertLess(report["shapes"][0]["distance"]["from_surface"]["max_of_diagonal"], 1e-12)
        self.assertLess(report["shapes"][1]["distance"]["from_surface"]["rms_of_diagonal"], 0.01)
        (animation,) = glb.json["animations"]
        self.assertEqual(animation["channels"][0]["target"]["path"], "weights")
        times = glb.accessor(animation["samplers"][0]["input"])
        self.assertEqual([t for (t,) in times], [0, 2, 4])
        self.assertEqual([w for (w,) in glb.accessor(animation["samplers"][0]["output"])], [0, 1, 0])

    def test_landmarks_meet(self):
        a, b = self.made("creature", 3000), self.made("creature", 2000, seed=5, name="b.obj")
        in_box = []
        for path in (a, b):
            columns = list(zip(*read_obj(path)[0]))
            in_box.append(list(zip(*[[(x - min(column)) / (max(column) - min(column)) for x in column] for column in columns])))
        landmarks = self.path("landmarks.txt")
        with open(landmarks, "w", encoding="ascii") as file:
            file.write("# vertex of a, vertex of b in the same place of its box\n\n")
            for i in range(5):
                v = (i * len(in_box[0])) // 5
                w = min(range(len(in_box[1])), key=lambda k, at=in_box[0][v]: math.dist(in_box[1][k], at))
                file.write(f"{v} {w}  # {i}\n")
        report, _ = self.report("morph", a, b, "-o", self.path("morph.glb"), "--landmarks", landmarks)
        figures = report["shapes"][1]
        self.assertEqual(figures["landmarks"]["count"], 5)
        self.assertLess(figures["landmarks"]["angle"]["max"], 1e-14)
        self.assertGreater(figures["landmarks"]["angle_rotated"]["max"], 0.01)
        self.assertEqual(figures["landmarks"]["share"], 1)
        self.assertEqual(figures["warp"]["flipped"], 0)
        self.assertEqual([shape["flipped"] for shape in report["shapes"]], [0, 0])
        rotation = figures["rotation"]
        for i in range(3):
            for j in range(3):
                self.assertAlmostEqual(sum(rotation[i][k] * rotation[j][k] for k in range(3)), float(i == j), places=12)

    @long
    def test_landmarks_that_bend_much_turn_nothing_over(self):
        a, b = self.made("creature", 3000), self.made("star", 1500)
        ends = []
        for path in (a, b):
            positions, _ = read_obj(path)
            ends.append([f(range(len(positions)), key=lambda v: positions[v][k]) for k in range(3) for f in (min, max)])
        landmarks = self.path("landmarks.txt")
        with open(landmarks, "w", encoding="ascii") as file:
            file.writelines(f"{i} {j}\n" for i, j in zip(*ends))
        for grid in ("both", "first", "icosphere:4"):
            report, _ = self.report("morph", a, b, "-o", self.path("morph.glb"), "--landmarks", landmarks, "--grid", grid)
            figures = report["shapes"][1]
            self.assertEqual([shape["flipped"] for shape in report["shapes"]], [0, 0])
            self.assertGreater(figures["warp"]["max_quasi_conformal"], 2)
            self.assertEqual(figures["landmarks"]["share"], 1)
            if grid == "both":
                self.assertLess(figures["distance"]["from_surface"]["rms_of_diagonal"], 0.01)

    def test_landmarks_may_be_points(self):
        a, b = self.made("blob", 1500), self.made("blob", 1500, seed=2, name="b.obj")
        points = [read_obj(path)[0][7] for path in (a, b)]
        landmarks = self.path("landmarks.txt")
        with open(landmarks, "w", encoding="ascii") as file:
            file.write(" ".join(repr(x) for p in points for x in p) + "\n")
        report, _ = self.report("morph", a, b, "-o", self.path("morph.glb"), "--landmarks", landmarks)
        self.assertEqual(report["shapes"][1]["landmarks"]["count"], 1)
        self.assertLess(report["shapes"][1]["landmarks"]["angle"]["max"], 1e-13)

    @long
    def test_other_meshes_more_shapes_and_steps(self):
        shapes = [self.made("blob", 1500, seed=i, name=f"shape{i}.obj") for i in range(3)]
        report, _ = self.report("morph", *shapes, "-o", self.path("morph.glb"), "--grid", "first", "--intermediates", "2", "--seconds", "1.5")
        self.assertEqual(report["vertices"], len(read_obj(shapes[0])[0]))
        glb = Glb(self.path("morph.glb"), texture=False)
        self.assertEqual(glb.target_names, ["shape1", "shape2"])
        self.assertEqual(glb.json["animations"][0]["samplers"][0]["interpolation"], "LINEAR")
        self.assertEqual(report["intermediates"], 4)
        for i in range(1, 5):
            path = self.path(f"morph-0{i}.glb")
            report_of_step, _ = self.report("info", path)
            self.assertEqual((report_of_step["genus"], report_of_step["vertices"]), (0, report["vertices"]))
        report, _ = self.report("morph", *shapes[:2], "-o", self.path("grid.gltf"), "--grid", "icosphere:3")
        self.assertEqual(report["vertices"], 642)

    def test_a_shape_that_stands_elsewhere_is_brought_to_the_first(self):
        a = self.made("creature", 1500)
        positions, triangles = read_obj(a)
        # A third turn about (1, 1, 1), 2.5 times as large, moved: x goes to 2.5 (z, x, y) + shift.
        shift = (3, -1, 2)
        moved = [tuple(2.5 * p[(c + 2) % 3] + shift[c] for c in range(3)) for p in positions]
        b, landmarks = self.path("moved.obj"), self.path("pairs.txt")
        with open(b, "w", encoding="ascii") as file:
            file.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in moved)
            file.writelines("f {} {} {}\n".format(*(i + 1 for i in t)) for t in triangles)
        with open(landmarks, "w", encoding="ascii") as file:
            file.writelines(f"{i} {i}\n" for i in range(0, len(positions), 150))
        size = max(abs(x) for p in positions for x in p)
        arguments = ("morph", a, b, "-o", self.path("morph.glb"), "--grid", "first", "--landmarks", landmarks)
        report, _ = self.report(*arguments, "--placement", "scaled")
        placement = report["shapes"][1]["placement"]
        # The two maps are alike but not equal, so positions agree to the size of triangles, not to rounding.
        self.assertAlmostEqual(placement["scale"], 1 / 2.5, delta=0.01)
        for row, expected in zip(placement["rotation"], ((0, 1, 0), (0, 0, 1), (1, 0, 0))):
            for value, wanted in zip(row, expected):
                self.assertAlmostEqual(value, wanted, delta=0.02)
        deltas = Glb(self.path("morph.glb"), texture=False).deltas
        self.assertLess(math.sqrt(sum(x * x for d in deltas for x in d) / len(deltas)), 0.05 * size)
        report, _ = self.report(*arguments, "--placement", "turned")
        placement = report["shapes"][1]["placement"]
        self.assertEqual(placement["scale"], 1)
        for c in range(3):
            self.assertAlmostEqual(placement["rotation"][c][(c + 1) % 3], 1, delta=0.02)
        report, _ = self.report(*arguments)
        self.assertEqual(report["shapes"][1]["placement"], {"scale": 1, "rotation": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "shift": [0, 0, 0]})

    @staticmethod
    def random_rotation(choice):
        w, x, y, z = (choice.gauss(0, 1) for _ in range(4))
        n = math.sqrt(w * w + x * x + y * y + z * z)
        w, x, y, z = w / n, x / n, y / n, z / n
        return ((1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
                (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
                (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)))

    def test_a_turned_copy_is_found_to_be_one_and_becomes_the_shape_itself(self):
        choice = random.Random(5)
        # Maps of the copies were found apart from each other, so they agree to the size of triangles where the shape has protrusions
        # (measured: .015 of the size, and 4e-4 of the rotation), and to rounding for a simple one.
        for shape, triangles, scale, near in (("blob", 1500, 1, 1e-6), ("blob", 1500, 3, 1e-6), ("creature", 8000, 1, 0.03)):
            a = self.made(shape, triangles)
            positions, triangles = read_obj(a)
            size = max(abs(x) for p in positions for x in p)
            r = self.random_rotation(choice)
            b = self.path("turned.obj")
            with open(b, "w", encoding="ascii") as file:
                for p in positions:
                    file.write("v %r %r %r\n" % tuple(scale * sum(row[k] * p[k] for k in range(3)) for row in r))
                file.writelines("f {} {} {}\n".format(*(i + 1 for i in t)) for t in triangles)
            arguments = ("morph", a, b, "-o", self.path("morph.glb"), "--grid", "first")
            report, text = self.report(*arguments, "--placement", "scaled")
            self.assertEqual(report["alignment"], "shape")
            figures = report["shapes"][1]
            self.assertGreater(figures["correlation"], 0.999)
            angle = math.degrees(math.acos(max(-1, min(1, (sum(r[k][k] for k in range(3)) - 1) / 2))))
            self.assertAlmostEqual(figures["turn"]["angle"], angle, delta=57 * near)
            for i in range(3):
                for j in range(3):
                    self.assertAlmostEqual(figures["turn"]["rotation"][i][j], r[j][i], delta=near)
            self.assertIn("correlation", text)
            deltas = Glb(self.path("morph.glb"), texture=False).deltas
            self.assertLess(math.sqrt(sum(x * x for d in deltas for x in d) / len(deltas)), near * size)
            report, text = self.report(*arguments)
            self.assertTrue(any("--placement turned" in note for note in report["notes"]), report["notes"])
            report, _ = self.report(*arguments, "--align", "rotation")
            self.assertLess(report["shapes"][1]["correlation"], figures["correlation"])

    def test_a_shape_into_itself_is_itself(self):
        a = self.made("star", 2000)
        report, _ = self.report("morph", a, a, "-o", self.path("morph.glb"))
        self.assertEqual(report["vertices"], len(read_obj(a)[0]))
        glb = Glb(self.path("morph.glb"), texture=False)
        self.assertTrue(all(x == 0 for d in glb.deltas for x in d))
        self.assertEqual(report["edges_kept"], report["edges_of_others"])

    def test_what_cannot_be_morphed_is_refused(self):
        a, torus = self.made("blob"), self.made("torus")
        out = self.path("morph.glb")
        self.assertEqual(run("morph", a, "-o", out).returncode, 2)
        self.refused(2, "wrong-genus", torus, "morph", a, torus, "-o", out)
        self.refused(2, "unsupported-format", self.path("morph.obj"), "morph", a, a, "-o", self.path("morph.obj"))
        for text, kind in (("", "parse"), ("1 2 3\n", "parse"), ("1 two\n", "parse"), ("1 1000000\n", "index-range"),
                           ("0.5 1\n", "index-range"), ("0 0\n0 1\n", "invalid-argument")):
            landmarks = self.path("landmarks.txt")
            with open(landmarks, "w", encoding="ascii") as file:
                file.write(text)
            self.refused(2, kind, landmarks, "morph", a, a, "-o", out, "--landmarks", landmarks)


if __name__ == "__main__":
    main()
