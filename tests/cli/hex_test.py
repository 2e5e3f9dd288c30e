#!/usr/bin/env python3
"""orbicube hex and volume: what they write is positive by rational arithmetic, conforming, and of the solid's topology.

    hex_test.py COMMAND
"""
import json
from collections import Counter
from fractions import Fraction

from command import InFolder, main, run

NEIGHBOURS = ((1, 3, 4), (2, 0, 5), (3, 1, 6), (0, 2, 7), (7, 5, 0), (4, 6, 1), (5, 7, 2), (6, 4, 3))
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


class Hex(InFolder):
    def test_hexahedra_are_positive_and_meet_in_whole_faces(self):
        path, out, report = self.made("three-holes", 900), self.path("out.mesh"), self.path("report.json")
        done = run("hex", path, "-o", out, "--cells", 900, "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        positions, cells = read_medit(out, "Hexahedra", 8)
        faces = Counter()
        for cell in cells:
            for k, near in enumerate(NEIGHBOURS):
                self.assertGreater(determinant(*(positions[cell[i]] for i in (k, *near))), 0)
            for face in FACES:
                faces[tuple(sorted(cell[i] for i in face))] += 1
        self.assertEqual(set(faces.values()), {1, 2})
        outer = [face for face, count in faces.items() if count == 1]
        used = {v for face in outer for v in face}
        self.assertEqual(len(used) - len(outer), 2 - 2 * 3)  # vertices - edges + faces, each face having two edges
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        self.assertEqual(figures["hexahedra"], len(cells))
        self.assertEqual(figures["boundary_quads"], len(outer))
        self.assertEqual(figures["polycube"]["genus"], 3)
        self.assertGreater(figures["scaled_jacobian_min"], 0.2)

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


if __name__ == "__main__":
    main()
