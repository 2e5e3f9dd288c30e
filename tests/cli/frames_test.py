#!/usr/bin/env python3
"""orbicube frames: files, figures against a computation of their own, refusals, starts and constraints.

    frames_test.py COMMAND
"""
import itertools
import json
import math
import os
import random
import struct

from command import InFolder, as_float32, main, run
from png_rows import Png
from tetrahedra import box, write_medit

HALF = math.sqrt(0.5)


def cube_group():
    units = [tuple(float(i == k) for i in range(4)) for k in range(4)]
    for i, j in itertools.combinations(range(4), 2):
        for sign in (1, -1):
            units.append(tuple(HALF if k == i else sign * HALF if k == j else 0.0 for k in range(4)))
    units += [(0.5, a, b, c) for a, b, c in itertools.product((0.5, -0.5), repeat=3)]
    return units


GROUP = cube_group()


def relative(p, q):
    """conjugate(p) q"""
    w, x, y, z = p[0], -p[1], -p[2], -p[3]
    return (w * q[0] - x * q[1] - y * q[2] - z * q[3], w * q[1] + x * q[0] + y * q[3] - z * q[2],
            w * q[2] - x * q[3] + y * q[0] + z * q[1], w * q[3] + x * q[2] - y * q[1] + z * q[0])


def energy(p, q):
    r = relative(p, q)
    return 1 - max(abs(sum(a * b for a, b in zip(r, g))) for g in GROUP) ** 2


def bent_box(n, bend):
    """A box of tetrahedra, bent towards a ball."""
    points, cells = box(n)
    positions = []
    for p in points:
        p = [2 * c / n - 1 for c in p]
        length = math.hypot(*p)
        scale = 1 - bend + bend * max(map(abs, p)) / length if length else 1
        positions.append([scale * c for c in p])
    return positions, cells


def read_frames(path):
    with open(path, encoding="ascii") as file:
        return [tuple(map(float, line.split())) for line in file]


def glb_parts(path):
    """Corners of the triangles, and color, of each named part."""
    with open(path, "rb") as file:
        data = file.read()
    length = struct.unpack_from("<I", data, 12)[0]
    text, chunk = json.loads(data[20:20 + length]), data[28 + length:]
    forms = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}

    def values(number, components):
        accessor = text["accessors"][number]
        view = text["bufferViews"][accessor["bufferView"]]
        form = forms[accessor["componentType"]]
        found = struct.unpack_from(f"<{components * accessor['count']}{form}", chunk, view.get("byteOffset", 0))
        return [found[i:i + components] for i in range(0, len(found), components)]

    parts = {}
    for node in text["nodes"]:
        (primitive,) = text["meshes"][node["mesh"]]["primitives"]
        positions = values(primitive["attributes"]["POSITION"], 3)
        color = text["materials"][primitive["material"]]["pbrMetallicRoughness"]["baseColorFactor"]
        parts[node["name"]] = ([positions[i] for (i,) in values(primitive["indices"], 1)], color)
    return parts


class Frames(InFolder):
    def solid(self, n=5, bend=0.7):
        path = self.path("solid.mesh")
        positions, cells = bent_box(n, bend)
        write_medit(path, positions, cells)
        return path, positions, cells

    def figures(self, *arguments):
        report = self.path("report.json")
        done = run("frames", *arguments, "--report", report)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(report, encoding="utf-8") as file:
            return json.load(file)

    def test_figures_are_those_of_the_file_and_of_vectors(self):
        path, positions, cells = self.solid()
        out, vtk = self.path("solid.frames"), self.path("solid.vtk")
        facts = self.figures(path, "-o", out, "--vtk", vtk)
        frames = read_frames(out)
        self.assertEqual(len(frames), len(cells))
        for q in frames:
            self.assertAlmostEqual(math.hypot(*q), 1, delta=1e-14)
        faces = {}
        for t, cell in enumerate(cells):
            for k in range(4):
                faces.setdefault(frozenset(cell[:k] + cell[k + 1:]), []).append(t)
        pairs = [f for f in faces.values() if len(f) == 2]
        self.assertEqual(facts["interior_faces"], len(pairs))
        self.assertEqual(sum(facts["histogram"]), len(pairs))
        self.assertEqual(facts["boundary_faces"], len(faces) - len(pairs))
        self.assertAlmostEqual(facts["E"], sum(energy(frames[a], frames[b]) for a, b in pairs), delta=1e-9)
        self.assertLessEqual(facts["angle_deg"]["max"], 62.80)
        self.assertLess(facts["misalignment_deg"]["one_face_max"], 1e-6)
        self.assertEqual(facts["dead_ends"], 0)
        self.assertEqual(facts["boundary_index_sum"], facts["euler_characteristic"])
        self.assertEqual(facts["euler_characteristic"], 2)
        with open(vtk, encoding="ascii") as file:
            lines = file.read().split("\n")
        start = lines.index("VECTORS axis_2 double") + 1
        for q, line in zip(frames, lines[start:start + len(frames)]):
            w, x, y, z = q
            axis = (2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x))
            for a, b in zip(axis, map(float, line.split())):
                self.assertAlmostEqual(a, b, delta=1e-12)
        self.assertIn(f"POINTS {len(positions)} double", lines)

    def test_figures_do_not_depend_on_names_of_frames_order_of_cells_or_place(self):
        path, positions, cells = self.solid()
        out = self.path("solid.frames")
        before = self.figures(path, "-o", out, "--start", "identity")
        frames = read_frames(out)
        choice = random.Random(3)
        angle, axis = 0.7, (2 / 3, -1 / 3, 2 / 3)
        turn = (math.cos(angle), *(math.sin(angle) * a for a in axis))
        order = list(range(len(cells)))
        choice.shuffle(order)
        names = list(range(len(positions)))
        choice.shuffle(names)
        moved = [None] * len(positions)
        for name, p in zip(names, positions):
            q = relative(turn, relative((0.0, *(-x for x in p)), turn))  # turned by the inverse
            moved[name] = [a + b for a, b in zip(q[1:], (3.0, -1.0, 2.0))]
        # Even changes of the corners' order keep the sign.
        renamed = []
        for i in order:
            a, b, c, d = (names[v] for v in cells[i])
            renamed.append(choice.choice([[a, b, c, d], [b, c, a, d], [b, a, d, c], [d, c, b, a]]))
        other, relabelled = self.path("other.mesh"), self.path("other.frames")
        write_medit(other, moved, renamed)
        with open(relabelled, "w", encoding="ascii") as file:
            for i in order:
                g = choice.choice(GROUP)
                q = relative(turn, frames[i])  # turned by the inverse as well
                q = relative((q[0], -q[1], -q[2], -q[3]), g)  # and in its own axes
                sign = choice.choice((1, -1))
                file.write("%r %r %r %r\n" % tuple(sign * x for x in q))
        after = self.figures(other, "-o", self.path("same.frames"), "--start-field", relabelled, "--unchanged")
        self.assertEqual(after["start"], "given")
        for key in ("interior_faces", "boundary_faces", "faces_above_30deg", "singular_edges", "curves", "loops", "nodes",
                    "boundary_ends", "dead_ends", "boundary_index_sum", "euler_characteristic", "locally_meshable",
                    "improper_edges", "turning_points", "improper_nodes", "histogram"):
            self.assertEqual(before[key], after[key], key)
        self.assertAlmostEqual(before["E"], after["E"], delta=1e-9)
        self.assertAlmostEqual(before["singular_length"], after["singular_length"], delta=1e-9)
        for key, value in before["angle_deg"].items():
            self.assertAlmostEqual(value, after["angle_deg"][key], delta=1e-5)  # near 0 the arc cosine has half the digits
        self.assertLess(after["misalignment_deg"]["one_face_max"], 1e-6)

    def test_a_field_is_as_smooth_whatever_the_order_of_the_cells(self):
        path, positions, cells = self.solid()
        out = self.path("solid.frames")
        before = self.figures(path, "-o", out)
        frames = read_frames(out)
        order = list(range(len(cells)))
        random.Random(4).shuffle(order)
        write_medit(path, positions, [cells[i] for i in order])
        after = self.figures(path, "-o", out)
        self.assertEqual(before["E"], after["E"])
        self.assertEqual([frames[i] for i in order], read_frames(out))

    def test_places_that_no_hexahedral_mesh_has_are_listed(self):
        path, positions, _ = self.solid(6, 1)
        facts = self.figures(path, "-o", self.path("solid.frames"), "--start", "identity")
        places = facts["improper_places"]
        self.assertGreater(len(places["edges"]) + len(places["vertices"]), 0)
        self.assertEqual(len(places["edges"]), min(1000, facts["improper_edges"]))
        self.assertEqual(len(places["vertices"]), min(1000, facts["turning_points"] + facts["improper_nodes"]))
        for edge in places["edges"]:
            for at, ends in zip(edge["at"], zip(*(positions[v] for v in edge["vertices"]))):
                self.assertAlmostEqual(at, sum(ends) / 2, delta=1e-12)
        for turn in ("120", "180", "other"):
            named = sum(edge["turn"] == turn for edge in places["edges"])
            self.assertLessEqual(named, facts["singular_edges"][turn])
        kinds = [vertex["kind"] for vertex in places["vertices"]]
        self.assertEqual(kinds.count("turning-point"), facts["turning_points"])
        for vertex in places["vertices"]:
            self.assertEqual(vertex["at"], list(positions[vertex["vertex"]]))

    def test_the_scene_has_the_curves_in_the_surface_and_frames(self):
        path, positions, cells = self.solid(6, 1)
        out, glb = self.path("solid.frames"), self.path("solid.glb")
        facts = self.figures(path, "-o", out, "--start", "identity", "--glb", glb, "--crosses", "100")
        parts = glb_parts(glb)
        tubes = {"threes", "fives", "half turns", "third turns", "diagonal half turns"}
        counts = facts["singular_edges"]
        self.assertEqual("third turns" in parts, counts["120"] > 0)
        self.assertEqual("diagonal half turns" in parts, counts["other"] > 0)
        self.assertEqual("threes" in parts or "fives" in parts, counts["90"] > 0)
        self.assertEqual("nodes" in parts, facts["nodes"] > 0)
        self.assertEqual("not meshable" in parts, facts["turning_points"] + facts["improper_nodes"] > 0)
        surface, color = parts.pop("surface")
        self.assertEqual(len(surface), 3 * facts["boundary_faces"])
        corners = {tuple(map(as_float32, p)) for p in positions}
        self.assertTrue(all(p in corners for p in surface))
        self.assertLess(color[3], 0.5)
        crosses, _ = parts.pop("frames")
        self.assertEqual(len(crosses) % 72, 0)  # corners of 24 triangles each
        self.assertTrue(30 < len(crosses) // 72 < 300)
        # The tip of each spindle lies along an axis of a frame from the center of its tetrahedron.
        centers = [[sum(positions[v][k] for v in cell) / 4 for k in range(3)] for cell in cells]
        for first in range(0, min(len(crosses), 5 * 72), 72):
            cross = crosses[first:first + 72]
            middle = [sum(p[k] for p in cross) / 72 for k in range(3)]
            t = min(range(len(cells)), key=lambda i: math.dist(centers[i], middle))
            self.assertLess(math.dist(centers[t], middle), 1e-5)
            w, x, y, z = read_frames(out)[t]
            tip = [a - b for a, b in zip(max(cross[:24], key=lambda p: math.dist(p, middle)), middle)]
            axis = (1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y))
            self.assertAlmostEqual(abs(sum(a * b for a, b in zip(tip, axis))) / math.hypot(*tip), 1, delta=1e-5)
        # What is left is opaque and lies within the solid, but for the thickness of a tube.
        for name, (points, color) in parts.items():
            self.assertIn(name, tubes | {"nodes", "not meshable"})
            self.assertEqual(color[3], 1)
            self.assertTrue(all(math.hypot(*p) < 1.05 for p in points), name)

    def test_the_picture_has_a_bar_where_there_are_angles(self):
        path, _, _ = self.solid(3)
        out, picture = self.path("solid.frames"), self.path("solid.png")
        facts = self.figures(path, "-o", out, "--plot", picture)
        with open(picture, "rb") as file:
            png = Png(file.read())
        self.assertEqual(png.bits, 8)
        bars = [0] * 64
        for row in png.rows:
            for degree in range(64):
                bars[degree] += row[round(60 + (degree + 0.5) / 64 * 820)] == 3
        for degree, count in enumerate(facts["histogram"]):
            # The curve may hide a bar that is low, and hides some dots of the others.
            share = 490 * count / facts["interior_faces"]
            self.assertLessEqual(bars[degree], share + 1)
            self.assertGreaterEqual(bars[degree], share - 40)

    def test_each_start_and_method_ends_in_a_valid_field_and_auto_in_the_best(self):
        path, _, _ = self.solid()
        out = self.path("solid.frames")
        best = self.figures(path, "-o", out)["E"]
        for options in (("--start", "identity"), ("--start", "propagated"), ("--start", "harmonic"),
                        ("--start", "diffusion"), ("--method", "dissertation")):
            facts = self.figures(path, "-o", out, *options)
            self.assertLess(facts["misalignment_deg"]["one_face_max"], 1e-6)
            self.assertLessEqual(best, 1.01 * facts["E"])
        self.assertEqual(self.figures(path, "-o", out, "--start", "harmonic", "--threads", "1")["start"], "harmonic")

    def test_options_that_would_be_ignored_are_refused(self):
        path, _, cells = self.solid(3, 0)
        own, out = self.path("own.frames"), self.path("out.frames")
        with open(own, "w", encoding="ascii") as file:
            file.write("1 0 0 0\n" * len(cells))
        for options, named in ((("--method", "dissertation", "--start", "harmonic"), "--start"),
                               (("--method", "dissertation", "--start-field", own), "--start-field"),
                               (("--method", "dissertation", "--rounds", "3"), "--rounds"),
                               (("--start", "harmonic", "--rounds", "3"), "--rounds"),
                               (("--start-field", own, "--start", "harmonic"), "--start"),
                               (("--start-field", own, "--unchanged", "--face-weights", "geometric"), "--face-weights"),
                               (("--crosses", "10"), "--crosses")):
            done = run("frames", path, "-o", out, *options)
            self.assertEqual(done.returncode, 2, options)
            self.assertIn(named, done.stderr.splitlines()[0])
            self.assertIn("usage", done.stderr)
            self.assertFalse(os.path.exists(out))
        done = run("frames", path, "-o", out, "--method", "dissertation", "--start", "identity")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_field_of_ones_own_is_smoothed_and_a_boundary_of_ones_own_is_held(self):
        path, _, cells = self.solid(4, 0)
        own, out = self.path("own.frames"), self.path("out.frames")
        choice = random.Random(2)
        with open(own, "w", encoding="ascii") as file:
            file.write("# frames of length 2\n\n")
            for _ in cells:
                angle = choice.uniform(-0.1, 0.1)
                file.write(f"{2 * math.cos(angle)} {2 * math.sin(angle)} 0 0\n")
        self.assertLess(self.figures(path, "-o", out, "--start-field", own)["E"], 1e-9)
        facts = self.figures(path, "-o", out, "--boundary", own)
        self.assertGreater(facts["E"], 0.01)
        held = 0
        with open(own, encoding="ascii") as file:
            lines = [line for line in file if line.strip() and line[0] != "#"]
        for line, q in zip(lines, read_frames(out)):
            wanted = [0.5 * float(word) for word in line.split()]
            held += abs(abs(sum(a * b for a, b in zip(wanted, q))) - 1) < 1e-12
        self.assertGreater(held, 100)
        self.assertLess(held, len(cells))

    def test_what_is_wrong_is_refused_and_nothing_is_written(self):
        path, positions, cells = self.solid(2)
        out = self.path("out.frames")
        surface = self.made("cube")
        self.refused(2, "no-cells", surface, "frames", surface, "-o", out)
        missing = self.path("missing.mesh")
        self.refused(2, "io", missing, "frames", missing, "-o", out)
        nowhere = self.path("nowhere/out.frames")
        self.refused(2, "io", nowhere, "frames", path, "-o", nowhere)
        own = self.path("own.frames")
        for text, kind in (("1 0 0 0\n", "truncated"), ("1 0 0 0\n" * (len(cells) + 1), "trailing-data"),
                           ("1 0 0 x\n" * len(cells), "parse"), ("0 0 0 0\n" * len(cells), "degenerate-geometry"),
                           ("1 0 0 nan\n" * len(cells), "non-finite"), ("1 0 0 0 0\n" * len(cells), "parse")):
            with open(own, "w", encoding="ascii") as file:
                file.write(text)
            self.refused(2, kind, own, "frames", path, "-o", out, "--start-field", own)
        cells[0][0], cells[0][1] = cells[0][1], cells[0][0]
        write_medit(path, positions, cells)
        self.refused(2, "inverted-cell", path, "frames", path, "-o", out)
        self.assertFalse(os.path.exists(out))

    def test_the_time_limit_stops_it(self):
        path, _, _ = self.solid(20)
        out = self.path("out.frames")
        done = run("frames", path, "-o", out, "--time-limit", "0.2", "--rounds", "1000")
        self.assertEqual(done.returncode, 1)
        self.assertIn("time-limit", done.stderr)
        self.assertFalse(os.path.exists(out))


if __name__ == "__main__":
    main()
