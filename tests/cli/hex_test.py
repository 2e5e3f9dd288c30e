#!/usr/bin/env python3
"""orbicube hex and volume: what they write is positive by rational arithmetic, conforming, and of the solid's topology.

    hex_test.py COMMAND
"""
import cmath
import importlib.util
import json
import math
import os
from collections import Counter
from fractions import Fraction
from itertools import product

from command import Glb, InFolder, main, run
from tetrahedra import write_medit

NEIGHBORS = ((1, 3, 4), (2, 0, 5), (3, 1, 6), (0, 2, 7), (7, 5, 0), (4, 6, 1), (5, 7, 2), (6, 4, 3))
FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))


def read_medit(path, name, corners):
    with open(path, encoding="ascii") as file:
        words = file.read().split()
    start = words.index("Vertices") + 2
    positions = [tuple(Fraction(c) for c in words[start + 4 * i:start + 4 * i + 3]) for i in range(int(words[start - 1]))]
    start = words.index(name) + 2
    size = corners + 1
    return positions, [tuple(int(v) - 1 for v in words[start + size * i:start + size * i + corners])
                       for i in range(int(words[start - 1]))]


def determinant(o, a, b, c):
    u, v, w = ([p[i] - o[i] for i in range(3)] for p in (a, b, c))
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
            + u[2] * (v[0] * w[1] - v[1] * w[0]))


def hexahedron_volume(p):
    """Of the trilinear map, by Gauss's two points each way, which are exact for its determinant."""
    points = (0.5 - 0.5 / math.sqrt(3), 0.5 + 0.5 / math.sqrt(3))
    corners = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
    volume = 0.0
    for place in product(points, repeat=3):
        rows = []
        for axis in range(3):
            row = [0.0, 0.0, 0.0]
            for corner, position in zip(corners, p):
                weight = 1.0
                for k in range(3):
                    weight *= (1 if corner[k] else -1) if k == axis else place[k] if corner[k] else 1 - place[k]
                row = [x + weight * y for x, y in zip(row, position)]
            rows.append(row)
        volume += determinant((0, 0, 0), *rows) / 8
    return volume


def write_cylinder(path, frames):
    """A bar of 6 x 6 x 2 cubes, round about z, with frames that turn about z around four lines; as in tests/volume_map/frame_solids.h."""
    n, layers = 6, 2
    at = {}
    for i, j, k in product(range(n + 1), range(n + 1), range(layers + 1)):
        x, y = 2 * i / n - 1, 2 * j / n - 1
        longest = max(abs(x), abs(y))
        scale = (1 - longest) + longest * longest / math.hypot(x, y) if longest > 0 else 1
        at[i, j, k] = (len(at), (scale * x, scale * y, 0.7 * k / layers))
    positions = [place for _, place in at.values()]
    cells = []
    for cube in product(range(n), range(n), range(layers)):
        for o, order in enumerate(((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2))):
            p, cell = list(cube), [at[cube][0]]
            for axis in order:
                p[axis] += 1
                cell.append(at[tuple(p)][0])
            if o >= 3:
                cell[2], cell[3] = cell[3], cell[2]
            cells.append(cell)
    write_medit(path, positions, cells)
    radius = math.hypot(*positions[at[3 * n // 4, 3 * n // 4, 0][0]][:2])
    points = [cmath.rect(radius, math.pi * (0.25 + 0.5 * k)) for k in range(4)]
    with open(frames, "w", encoding="ascii") as file:
        for cell in cells:
            z = sum(complex(*positions[v][:2]) for v in cell) / 4
            turn = sum(cmath.phase((z - p) * (1 - p.conjugate() * z)) for p in points) / 4
            file.write(f"{math.cos(turn / 2)!r} 0 0 {math.sin(turn / 2)!r}\n")


def write_prism(path, sides, cuts=4):
    """A regular prism of height 2: quads in rings around the middle of both ends and in layers at the sides, in triangles."""
    corners = [cmath.exp(2j * cmath.pi * k / sides) for k in range(sides + 1)]
    rim = [corners[k] + (corners[k + 1] - corners[k]) * i / cuts for k in range(sides) for i in range(cuts)]
    loops = [(r / cuts, 0) for r in range(1, cuts)] + [(1, 2 * l / cuts) for l in range(cuts + 1)]
    loops += [(r / cuts, 2) for r in range(cuts - 1, 0, -1)]
    n = len(rim)
    with open(path, "w", encoding="ascii") as file:
        for scale, z in loops:
            file.writelines(f"v {scale * p.real!r} {scale * p.imag!r} {z!r}\n" for p in rim)
        file.write("v 0 0 0\nv 0 0 2\n")
        for k in range(n):
            for loop in range(len(loops) - 1):
                a, b = loop * n + k + 1, loop * n + (k + 1) % n + 1
                file.write(f"f {a} {b} {b + n}\nf {a} {b + n} {a + n}\n")
            last = (len(loops) - 1) * n + 1
            file.write(f"f {1 + (k + 1) % n} {1 + k} {last + n}\nf {last + k} {last + (k + 1) % n} {last + n + 1}\n")


class Hex(InFolder):
    def check(self, path, handles):
        """Positive corners, whole faces, and a boundary of one piece of that genus; answers the numbers of cells and quads."""
        positions, cells = read_medit(path, "Hexahedra", 8)
        faces = Counter()
        for cell in cells:
            for k, near in enumerate(NEIGHBORS):
                self.assertGreater(determinant(*(positions[cell[i]] for i in (k, *near))), 0)
            for face in FACES:
                faces[tuple(sorted(cell[i] for i in face))] += 1
        self.assertEqual(set(faces.values()), {1, 2})
        outer = [face for face, count in faces.items() if count == 1]
        used = {v for face in outer for v in face}
        self.assertEqual(len(used) - len(outer), 2 - 2 * handles)  # vertices - edges + faces, each face having two edges
        return len(cells), len(outer)

    def made_hexahedra(self, path, *options):
        """What the report says, and the file."""
        out, report = self.path("out.mesh"), self.path("report.json")
        done = run("hex", path, "-o", out, "--report", report, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(report, encoding="utf-8") as file:
            return json.load(file), out

    def test_hexahedra_are_positive_and_meet_in_whole_faces(self):
        path = self.made("three-holes", 900)
        for method in ("polycube", "frames"):
            figures, out = self.made_hexahedra(path, "--cells", 900, "--distance", 3, "--method", method)
            cells, quads = self.check(out, 3)
            self.assertEqual((figures["method"], figures["hexahedra"], figures["boundary_quads"]), (method, cells, quads))
            if method == "polycube":
                self.assertEqual(figures["polycube"]["genus"], 3)
            self.assertGreater(figures["min_scaled_jacobian"], 0.2)
            self.assertLess(figures["hausdorff_percent"], 3)
            self.assertLess(figures["volume_error_percent"], 3)

    def test_machined_parts_follow_frames_and_others_polycubes(self):
        # Five sides, where a polycube has four corners: frames have a curve in the middle around which cells meet in fives.
        prism = self.path("prism.obj")
        write_prism(prism, 5)
        figures, out = self.made_hexahedra(prism, "--cells", 100)
        self.check(out, 0)
        self.assertEqual(figures["method"], "frames")
        self.assertGreater(figures["inner_irregular_edges"], 0)
        self.assertGreater(figures["min_scaled_jacobian"], 0.9)
        self.assertLess(figures["hexahedra"], 200)
        # Layers are those of a polycube, and a round shape is not machined.
        figures, _ = self.made_hexahedra(self.made("cube", 300), "--cells", 64, "--padding", "with")
        self.assertEqual((figures["method"], figures["padded"]), ("polycube", True))
        figures, _ = self.made_hexahedra(self.made("blob", 600), "--cells", 200, "--distance", 0)
        self.assertEqual(figures["method"], "polycube")

    def test_the_scene_is_the_boundary_of_what_is_not_cut_away(self):
        path, out, scene, report = self.made("cube", 300), self.path("out.mesh"), self.path("out.glb"), self.path("report.json")
        for cut in ("none", "quarter", "half"):
            done = run("hex", path, "-o", out, "--cells", 60, "--glb", scene, "--cut", cut, "--report", report)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            positions, cells = read_medit(out, "Hexahedra", 8)
            middle = [(min(p[k] for p in positions) + max(p[k] for p in positions)) / 2 for k in range(3)]
            faces = {}
            for cell in cells:
                center = [sum(positions[v][k] for v in cell) / 8 for k in range(3)]
                away = cut != "none" and center[2] > middle[2] and (cut == "half" or center[1] > middle[1])
                if not away:
                    for face in FACES:
                        faces.setdefault(tuple(sorted(cell[i] for i in face)), []).append([cell[i] for i in face])
            shown = [found[0] for found in faces.values() if len(found) == 1]
            glb = Glb(scene, texture=False, targets=False)
            with open(report, encoding="utf-8") as file:
                figures = json.load(file)["scene"]
            self.assertEqual((figures["quads"], len(glb.triangles)), (len(shown), 2 * len(shown)))
            self.assertEqual(figures["quads_inside"] > 0, cut != "none")
            # Twice the vector area of a closed surface is nothing, and its volume that of the hexahedra that are left.
            volume, area = 0, [0, 0, 0]
            for a, b, c in ([glb.positions[v] for v in t] for t in glb.triangles):
                n = [(b[i - 2] - a[i - 2]) * (c[i - 1] - a[i - 1]) - (b[i - 1] - a[i - 1]) * (c[i - 2] - a[i - 2]) for i in range(3)]
                area = [x + y for x, y in zip(area, n)]
                volume += sum(x * y for x, y in zip(a, n)) / 6
            self.assertLess(max(map(abs, area)), 1e-5)
            exact = sum(float(determinant(*(positions[face[i]] for i in (0, *half)), middle)) / -6
                        for face in shown for half in ((1, 2), (2, 3)))
            self.assertAlmostEqual(volume, exact, delta=1e-5)
            self.assertGreater(volume, 0)
        self.refused(2, "unsupported-format", self.path("out.obj"), "hex", path, "-o", out, "--glb", self.path("out.obj"))

    def test_volume_maps_are_positive_in_space_and_on_the_polycube(self):
        path, image, source = self.made("sphere", 500), self.path("image.mesh"), self.path("source.mesh")
        done = run("volume", path, "-o", image, "--source", source)
        self.assertEqual(done.returncode, 0, done.stderr)
        positions, cells = read_medit(image, "Tetrahedra", 4)
        places, same = read_medit(source, "Tetrahedra", 4)
        self.assertEqual(cells, same)
        faces = Counter()
        for a, b, c, d in cells:
            for p in (positions, places):
                self.assertGreater(determinant(p[a], p[b], p[c], p[d]), 0)
            for face in ((a, b, c), (a, b, d), (a, c, d), (b, c, d)):
                faces[tuple(sorted(face))] += 1
        for face, count in faces.items():
            if count == 1:
                self.assertTrue(any(len({positions[v][axis] for v in face}) == 1 for axis in range(3)))
        # Tetrahedra are taken as they are, the same solid again.
        again = self.path("again.mesh")
        done = run("volume", source, "-o", again)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_hexahedra_along_frames_of_a_cylinder_meet_in_threes_around_four_inner_curves(self):
        path, out, report = self.path("bar.mesh"), self.path("out.mesh"), self.path("report.json")
        frames = self.path("bar.frames")
        write_cylinder(path, frames)
        done = run("hex", path, "-o", out, "--method", "frames", "--frames", frames, "--cells", 120, "--distance", 0,
                   "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        positions, cells = read_medit(out, "Hexahedra", 8)
        edges, outer = Counter(), set()
        faces = Counter()
        for cell in cells:
            for k, near in enumerate(NEIGHBORS):
                self.assertGreater(determinant(*(positions[cell[i]] for i in (k, *near))), 0)
                edges.update(tuple(sorted((cell[k], cell[n]))) for n in near if n > k)
            for face in FACES:
                faces[tuple(cell[i] for i in face)] += 1
        sides = Counter(tuple(sorted(face)) for face in faces)
        self.assertEqual(set(sides.values()), {1, 2})
        for face in faces:
            if sides[tuple(sorted(face))] == 1:
                outer.update(tuple(sorted((face[k], face[k - 1]))) for k in range(4))
        inner = Counter(count for edge, count in edges.items() if edge not in outer)
        self.assertEqual(set(inner), {3, 4})
        self.assertEqual(inner[3] % 4, 0)
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        self.assertEqual(figures["inner_irregular_edges"], inner[3])
        self.assertEqual(figures["hexahedra"], len(cells))
        # Too far from a round bar; with more cells not.
        self.assertGreater(max(figures["hausdorff_percent"], figures["volume_error_percent"]), 1)
        done = run("hex", path, "-o", out, "--method", "frames", "--frames", frames, "--cells", 120, "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        self.assertLessEqual(max(figures["hausdorff_percent"], figures["volume_error_percent"]), 1)
        self.assertGreater(figures["hexahedra"], len(cells))
        # A frame less, and frames of a solid that is not there.
        with open(frames, encoding="ascii") as file:
            lines = file.readlines()
        with open(frames, "w", encoding="ascii") as file:
            file.writelines(lines[1:])
        done = run("hex", path, "-o", out, "--method", "frames", "--frames", frames)
        self.assertEqual(done.returncode, 2, done.stderr)

    def test_wrong_input_is_refused(self):
        path, out = self.made("cube", 600), self.path("out.mesh")
        self.refused(2, "unsupported-format", self.path("out.obj"), "hex", path, "-o", self.path("out.obj"))
        with open(path, encoding="ascii") as file:
            lines = file.read().splitlines()
        opened = self.path("open.obj")
        with open(opened, "w", encoding="ascii") as file:
            file.write("\n".join(lines[:-1]) + "\n")
        self.refused(2, "not-closed", opened, "hex", opened, "-o", out)
        self.refused(2, "not-closed", opened, "volume", opened, "-o", out)
        self.assertRegex(run("hex", opened, "-o", out).stderr, r"first edge \d+-\d+, at \([-0-9.e]+, [-0-9.e]+, [-0-9.e]+\)")
        # A box through a box.
        path = self.boxes("crossing", ((0, 0, 0), 3), ((2, 2, 2), 2))
        for verb in ("hex", "volume"):
            self.refused(2, "self-intersection", path, verb, path, "-o", out)
            self.assertIn(", at (", run(verb, path, "-o", out).stderr)

    def test_cells_of_a_grid_in_space(self):
        path, out, report = self.made("creature", 2000), self.path("out.mesh"), self.path("report.json")
        done = run("hex", path, "-o", out, "--cells", 1200, "--distance", 3, "--method", "grid", "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(report, encoding="ascii") as file:
            figures = json.load(file)
        self.assertEqual(figures["method"], "grid")
        self.assertNotIn("polycube", figures)
        self.assertLessEqual(max(figures["hausdorff_percent"], figures["volume_error_percent"]), 3)
        self.assertGreater(figures["min_scaled_jacobian"], 0)
        positions, cells = read_medit(out, "Hexahedra", 8)
        self.assertEqual(len(cells), figures["hexahedra"])
        self.assertLess(len(cells), 2000)
        neighbors = ((1, 3, 4), (2, 0, 5), (3, 1, 6), (0, 2, 7), (7, 5, 0), (4, 6, 1), (5, 7, 2), (6, 4, 3))
        for cell in cells:
            for corner, around in enumerate(neighbors):
                self.assertGreater(determinant(*(positions[cell[v]] for v in (corner, *around))), 0)

    def rod(self, name, sides, radius, length, scale=1.0):
        """A closed rod along a slanted direction."""
        axis, across = (0.36, 0.48, 0.8), (0.8, -0.6, 0)
        third = tuple(axis[i - 2] * across[i - 1] - axis[i - 1] * across[i - 2] for i in range(3))
        path = self.path(name + ".obj")
        with open(path, "w", encoding="ascii") as file:
            for k in range(sides):
                a = cmath.rect(radius, 2 * math.pi * k / sides)
                for z in (0, length):
                    file.write("v %r %r %r\n" % tuple(scale * (a.real * u + a.imag * v + z * w)
                                                      for u, v, w in zip(across, third, axis)))
            for k in range(sides):
                a, b = 2 * k + 1, 2 * ((k + 1) % sides) + 1
                file.write(f"f {a} {b} {b + 1}\nf {a} {b + 1} {a + 1}\n")
                if 0 < k < sides - 1:
                    file.write(f"f 1 {b} {a}\nf 2 {a + 1} {b + 1}\n")
        return path

    def octahedron(self):
        path = self.path("octahedron.obj")
        with open(path, "w", encoding="ascii") as file:
            corners = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
            file.writelines(f"v {x} {y} {z}\n" for x, y, z in corners)
            for upper in (5, 6):
                for a, b in ((1, 3), (3, 2), (2, 4), (4, 1)):
                    a, b = (a, b) if upper == 5 else (b, a)
                    file.write(f"f {a} {b} {upper}\n")
        return path, corners

    def test_sharp_edges_are_chains_of_edges_of_the_boundary(self):
        path, corners = self.octahedron()
        figures, out = self.made_hexahedra(path, "--cells", 900, "--method", "grid", "--distance", 0, "--features",
                                           "auto")
        features = figures["features"]
        self.assertEqual((features["curves"], features["corners"], features["replaced"]), (12, 6, True))
        self.assertEqual((features["missing"], round(features["captured"], 9)), ([], 1))
        self.assertAlmostEqual(features["scaled_jacobian_bound"], 0.5 / math.sqrt(3), 6)
        self.assertLess(figures["min_scaled_jacobian"], features["scaled_jacobian_bound"])
        self.check(out, 0)
        positions, cells = read_medit(out, "Hexahedra", 8)
        seen = Counter(frozenset(cell[v] for v in face) for cell in cells for face in FACES)
        edges = {frozenset((cell[face[k]], cell[face[(k + 1) % 4]])) for cell in cells for face in FACES for k in range(4)
                 if seen[frozenset(cell[v] for v in face)] == 1}
        # The octahedron's edges: one coordinate is 0, the others' absolute values add up to 1 (written with 17 digits).
        at_corner = {c: v for v, p in enumerate(positions) for c in corners if p == c}
        self.assertEqual(len(at_corner), 6)
        for i, a in enumerate(corners):
            for b in corners[i + 1:]:
                if all(x == -y for x, y in zip(a, b)):
                    continue
                along = sorted((sum((p[k] - a[k]) * (b[k] - a[k]) for k in range(3)), v) for v, p in enumerate(positions)
                               if sum(abs(p[k] - a[k] - sum((p[j] - a[j]) * (b[j] - a[j]) for j in range(3)) / 2 *
                                          (b[k] - a[k])) for k in range(3)) < Fraction(1, 10 ** 12))
                self.assertEqual((along[0][1], along[-1][1]), (at_corner[a], at_corner[b]))
                for (_, v), (_, w) in zip(along, along[1:]):
                    self.assertIn(frozenset((v, w)), edges)

    def test_features_are_those_that_the_file_marks(self):
        cube = self.path("cube.mesh")
        with open(cube, "w", encoding="ascii") as file:
            file.write("MeshVersionFormatted 2\nDimension 3\nVertices 8\n")
            for k in range(8):
                file.write(f"{k & 1} {k >> 1 & 1} {k >> 2} 0\n")
            file.write("Edges 3\n1 2 1\n2 4 1\n2 3 1\nRidges 2\n1 3\nCorners 1\n8\nTriangles 12\n")
            for a, b, c, d in ((3, 4, 2, 1), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)):
                file.write(f"{a} {b} {c} 0\n{a} {c} {d} 0\n")
            file.write("End\n")
        out = self.path("out.mesh")
        options = ("--cells", 60, "--distance", 0)
        figures, _ = self.made_hexahedra(cube, *options, "--features", "strict")
        self.assertEqual((figures["features"]["curves"], figures["features"]["missing"]), (12, []))
        # The method's mesh is left as it is where it has all of them.
        self.assertFalse(figures["features"]["replaced"])
        # The diagonal from 2 to 3 is no edge of a mesh along the axes.
        figures, _ = self.made_hexahedra(cube, *options, "--method", "polycube", "--features", "tags")
        features = figures["features"]
        self.assertEqual((features["curves"], features["corners"]), (2, 4))
        self.assertEqual(len(features["missing"]), 1)
        self.assertEqual({tuple(features["missing"][0][end]) for end in ("from", "to")}, {(1, 0, 0), (0, 1, 0)})
        self.assertIn("not to be replaced", features["missing"][0]["why"])
        sphere = self.made("sphere", 400)
        message = self.refused(2, "usage", sphere, "hex", sphere, "-o", out, "--features", "tags")
        self.assertIn("marks no", message)

    def test_missing_features_are_no_result_where_all_are_wanted(self):
        path, _ = self.octahedron()
        out = self.path("strict.mesh")
        options = ("hex", path, "-o", out, "--cells", 200, "--method", "polycube", "--distance", 0, "--features", "strict")
        message = self.refused(1, "no-valid-result", out, *options)
        self.assertIn("are missing", message)
        self.assertFalse(os.path.exists(out))
        self.refused(1, "no-valid-result", out, *options, "--keep-partial")
        self.assertTrue(os.path.exists(out))

    def test_long_rods_keep_their_volume_at_any_size(self):
        for scale in (1.0, 1e-200, 1e150):
            path = self.rod("rod", 12, 1, 2000, scale)
            figures, out = self.made_hexahedra(path, "--cells", 1500)
            self.assertLessEqual(max(figures["hausdorff_percent"], figures["volume_error_percent"]), 1)
            positions, cells = read_medit(out, "Hexahedra", 8)
            volume = sum(hexahedron_volume([[float(x / Fraction(scale)) for x in positions[v]] for v in cell])
                         for cell in cells)
            self.assertAlmostEqual(volume / (12 * math.sin(math.pi / 6) / 2 * 2000), 1, delta=0.0101)

    def test_what_is_too_far_is_kept_where_that_is_asked_for_alone(self):
        path, out, report = self.made("torus", 2000), self.path("out.mesh"), self.path("report.json")
        options = ("--cells", 20, "--max-cells", 20, "--distance", 0.05, "--report", report)
        message = self.refused(1, "no-valid-result", out, "hex", path, "-o", out, *options)
        self.assertIn("--keep-partial", message)
        self.assertFalse(os.path.exists(out))
        self.refused(1, "no-valid-result", out, "hex", path, "-o", out, "--keep-partial", *options)
        self.check(out, 1)
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        self.assertGreater(max(figures["hausdorff_percent"], figures["volume_error_percent"]), 0.1)

    def test_figures_are_of_the_whole_and_of_each_piece(self):
        path = self.boxes("speck", ((0, 0, 0), 3), ((4, 1, 1), 0.1))
        figures, _ = self.made_hexahedra(path, "--cells", 100)
        pieces = figures["by_piece"]
        self.assertEqual(figures["pieces"], 2)
        self.assertEqual(sum(piece["hexahedra"] for piece in pieces), figures["hexahedra"])
        for piece, center in zip(pieces, ((1.5, 1.5, 1.5), (4.05, 1.05, 1.05))):
            for x, y in zip(piece["place"], center):
                self.assertAlmostEqual(x, y, delta=1e-12)
            self.assertLess(piece["volume_error_percent"], 1)
        message = self.refused(2, "invalid-argument", path, "hex", path, "-o", self.path("out.mesh"), "--cells", 1)
        self.assertIn("2 pieces", message)

    def test_a_ball_in_a_bowl_stays_off_it(self):
        # Its gap is much narrower than a cell: walls that are fitted each by itself would meet across it.
        spec = importlib.util.spec_from_file_location(
            "gap_shapes", os.path.join(os.path.dirname(__file__), "..", "..", "bench", "hexmesh", "gap_shapes.py"))
        shapes = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(shapes)
        family, _, vertices, faces = shapes.shape(49)
        self.assertEqual(family, "ball-bowl")
        path = self.path("bowl.off")
        with open(path, "w", encoding="ascii") as file:
            file.write(f"OFF\n{len(vertices)} {len(faces)} 0\n")
            file.writelines("%.17g %.17g %.17g\n" % v for v in vertices)
            file.writelines("3 %d %d %d\n" % f for f in faces)
        figures, _ = self.made_hexahedra(path, "--cells", 1500, "--distance", 2)
        self.assertEqual(figures["intersecting_quads"], 0)
        self.assertEqual(figures["pieces"], 2)
        self.assertLessEqual(figures["hausdorff_percent"], 2)
        for piece in figures["by_piece"]:
            self.assertLess(piece["volume_error_percent"], 4)

    def test_a_cavity_stays_empty(self):
        # Its wall looks to the wrong side and is turned.
        path, out = self.boxes("cavity", ((0, 0, 0), 3), ((1, 1, 0.5), 1)), self.path("out.mesh")
        for method in ("polycube", "frames"):
            report = self.path("report.json")
            done = run("hex", path, "-o", out, "--cells", 400, "--method", method, "--report", report)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("12 triangles of parts oriented into the solid were reversed", done.stdout)
            with open(report, encoding="ascii") as file:
                figures = json.load(file)
            self.assertEqual(figures["input"]["cavities"], 1)
            self.assertLess(figures["volume_error_percent"], 1)
            positions, cells = read_medit(out, "Hexahedra", 8)
            # No corner and no middle of a hexahedron is in it.
            for cell in cells:
                middle = [sum(positions[v][k] for v in cell) / 8 for k in range(3)]
                for p in [middle, *(positions[v] for v in cell)]:
                    self.assertFalse(all(low + 0.01 < x < low + 0.99 for x, low in zip(p, (1, 1, 0.5))), p)
        done = run("volume", path, "-o", out)
        self.assertEqual(done.returncode, 0, done.stderr)

    def boxes(self, name, *boxes):
        path = self.path(name + ".obj")
        faces = ((0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2),
                 (2, 4, 6), (1, 3, 5), (3, 7, 5))
        with open(path, "w", encoding="ascii") as file:
            for low, size in boxes:
                for i in range(8):
                    file.write("v {} {} {}\n".format(*(low[k] + size * (i >> k & 1) for k in range(3))))
            for b in range(len(boxes)):
                for face in faces:
                    file.write("f {} {} {}\n".format(*(8 * b + v + 1 for v in face)))
        return path

    def test_pieces_are_done_each_by_itself(self):
        path, out = self.boxes("two", ((0, 0, 0), 1), ((3, 0, 0), 2)), self.path("out.mesh")
        self.refused(2, "not-connected", path, "hex", path, "-o", out, "--method", "frames")
        self.assertIn("(3, 0, 0)", run("hex", path, "-o", out, "--method", "frames").stderr)
        done = run("hex", path, "-o", out, "--cells", 90)
        self.assertEqual(done.returncode, 0, done.stderr)
        positions, cells = read_medit(out, "Hexahedra", 8)
        sides = {all(positions[v][0] < 2 for v in cell) for cell in cells}
        self.assertEqual(sides, {True, False})
        self.assertEqual(sum(1 for cell in cells if len({positions[v][0] < 2 for v in cell}) > 1), 0)
        image = self.path("image.mesh")
        done = run("volume", path, "-o", image)
        self.assertEqual(done.returncode, 0, done.stderr)
        positions, cells = read_medit(image, "Tetrahedra", 4)
        self.assertTrue(all(determinant(*(positions[v] for v in cell)) > 0 for cell in cells))


if __name__ == "__main__":
    main()
