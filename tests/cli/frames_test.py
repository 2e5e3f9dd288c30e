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
import zlib

from command import InFolder, main, run

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


def box(n, bend):
    """n^3 cubes, each cut into six tetrahedra; bent towards a ball."""
    def at(p):
        return (p[0] * (n + 1) + p[1]) * (n + 1) + p[2]
    positions = []
    for p in itertools.product(range(n + 1), repeat=3):
        p = [2 * c / n - 1 for c in p]
        length = math.hypot(*p)
        scale = 1 - bend + bend * max(map(abs, p)) / length if length else 1
        positions.append([scale * c for c in p])
    cells = []
    for corner in itertools.product(range(n), repeat=3):
        for order in itertools.permutations(range(3)):
            p, t = list(corner), [at(corner)]
            for axis in order:
                p[axis] += 1
                t.append(at(p))
            if sum(order[i] > order[j] for i, j in ((0, 1), (0, 2), (1, 2))) % 2:
                t[2], t[3] = t[3], t[2]
            cells.append(t)
    return positions, cells


def write_medit(path, positions, cells):
    with open(path, "w", encoding="ascii") as file:
        file.write(f"MeshVersionFormatted 2\nDimension 3\nVertices\n{len(positions)}\n")
        file.writelines("%r %r %r 0\n" % tuple(p) for p in positions)
        file.write(f"Tetrahedra\n{len(cells)}\n")
        file.writelines("%d %d %d %d 0\n" % tuple(v + 1 for v in t) for t in cells)
        file.write("End\n")


def read_frames(path):
    with open(path, encoding="ascii") as file:
        return [tuple(map(float, line.split())) for line in file]


class Frames(InFolder):
    def solid(self, n=5, bend=0.7):
        path = self.path("solid.mesh")
        positions, cells = box(n, bend)
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

    def test_the_picture_has_a_bar_where_there_are_angles(self):
        path, _, _ = self.solid(3)
        out, picture = self.path("solid.frames"), self.path("solid.png")
        facts = self.figures(path, "-o", out, "--plot", picture)
        with open(picture, "rb") as file:
            data = file.read()
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        chunks, at = {}, 8
        while at < len(data):
            length, kind = struct.unpack_from(">I4s", data, at)
            body = data[at + 8:at + 8 + length]
            self.assertEqual(struct.unpack_from(">I", data, at + 8 + length)[0], zlib.crc32(kind + body))
            chunks[kind] = body
            at += length + 12
        width, height, bits = struct.unpack_from(">IIB", chunks[b"IHDR"])
        pixels = zlib.decompress(chunks[b"IDAT"])
        self.assertEqual((bits, len(pixels)), (8, height * (width + 1)))
        bars = [0] * 64
        for y in range(height):
            row = pixels[y * (width + 1) + 1:(y + 1) * (width + 1)]
            for degree in range(64):
                bars[degree] += row[round(60 + (degree + 0.5) / 64 * 820)] == 3
        for degree, count in enumerate(facts["histogram"]):
            # The curve may hide a bar that is low, and hides some dots of the others.
            share = 460 * math.sqrt(count / facts["interior_faces"])
            self.assertLessEqual(bars[degree], share + 30)
            self.assertGreaterEqual(bars[degree], min(share, 490) - 40)

    def test_each_start_and_method_ends_in_a_valid_field_and_auto_in_the_best(self):
        path, _, _ = self.solid()
        out = self.path("solid.frames")
        best = self.figures(path, "-o", out)["E"]
        for options in (("--start", "identity"), ("--start", "propagated"), ("--start", "harmonic"),
                        ("--start", "diffusion"), ("--method", "seed")):
            facts = self.figures(path, "-o", out, *options)
            self.assertLess(facts["misalignment_deg"]["one_face_max"], 1e-6)
            self.assertLessEqual(best, 1.01 * facts["E"])
        self.assertEqual(self.figures(path, "-o", out, "--start", "harmonic", "--threads", "1")["start"], "harmonic")

    def test_a_field_of_ones_own_is_smoothed_and_a_boundary_of_ones_own_is_held(self):
        path, _, cells = self.solid(4, 0)
        own, out = self.path("own.frames"), self.path("out.frames")
        choice = random.Random(2)
        with open(own, "w", encoding="ascii") as file:
            file.write("# frames of length 2\n\n")
            for _ in cells:
                angle = choice.uniform(-0.1, 0.1)
                file.write(f"{2 * math.cos(angle)} {2 * math.sin(angle)} 0 0\n")
        self.assertLess(self.figures(path, "-o", out, "--from", own)["E"], 1e-9)
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
            self.refused(2, kind, own, "frames", path, "-o", out, "--from", own)
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
