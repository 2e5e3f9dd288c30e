#!/usr/bin/env python3
"""Region numbers of a cube, one a side, through the formats that hold them and through the verbs that keep them.

    regions_test.py COMMAND
"""
import collections
import itertools
import json
import re

from command import InFolder, main, run

CORNERS = [(i & 1, i >> 1 & 1, i >> 2 & 1) for i in range(8)]
SIDES = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
HALVES = collections.Counter({10 * side: 2 for side in range(1, 7)})


def cube():
    """MEDIT: the triangles of side k of a cube have region 10 k."""
    triangles = [(t, 10 * (k + 1)) for k, (a, b, c, d) in enumerate(SIDES) for t in ((a, b, c), (a, c, d))]
    rows = [" ".join(str(v + 1) for v in t) + f" {region}" for t, region in triangles]
    places = [" ".join(map(str, p)) + " 0" for p in CORNERS]
    return "\n".join(["MeshVersionFormatted 2", "Dimension 3", "Vertices", "8", *places, "Triangles", str(len(rows)), *rows, "End", ""])


def slope_of(p):
    """Below 0 on one side of the plane between the regions of two_regions()."""
    return p[0] - 1.1 - 0.3 * p[1]


def two_regions():
    """MEDIT: a box of 4 x 2 x 2 sheared cubes of six tetrahedra each, with region 4 before a sloping plane and 9 beyond."""
    number = {p: i + 1 for i, p in enumerate((i, j, k) for i in range(5) for j in range(3) for k in range(3))}
    places = []
    for i, j, k in number:
        y = j / 2
        plane = 1.1 + 0.3 * y
        places.append(f"{plane * i / 2 if i < 3 else plane + (2 - plane) * (i - 2) / 2} {y} {k / 2} 0")
    rows = []
    for start in ((i, j, k) for i in range(4) for j in range(2) for k in range(2)):
        for order in itertools.permutations(range(3)):
            corners = [start]
            for axis in order:
                corners.append(tuple(c + (d == axis) for d, c in enumerate(corners[-1])))
            if order in ((0, 2, 1), (1, 0, 2), (2, 1, 0)):  # odd
                corners[2], corners[3] = corners[3], corners[2]
            rows.append(" ".join(str(number[c]) for c in corners) + (" 4" if start[0] < 2 else " 9"))
    return "\n".join(["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(places)), *places, "Tetrahedra", str(len(rows)), *rows,
                      "End", ""])


def cells(path, section):
    """(vertices, region) of a section of a MEDIT file, and all positions."""
    with open(path, encoding="ascii") as file:
        words = file.read().split()

    def rows(name, width):
        if name not in words:
            return []
        at = words.index(name) + 1
        count = int(words[at])
        return [words[at + 1 + width * i:at + 1 + width * (i + 1)] for i in range(count)]

    positions = [tuple(map(float, row[:3])) for row in rows("Vertices", 4)]
    width = {"Triangles": 4, "Quadrilaterals": 5, "Tetrahedra": 5, "Hexahedra": 9}[section]
    return positions, [([int(v) - 1 for v in row[:-1]], int(row[-1])) for row in rows(section, width)]


def side_of(points):
    """Ten times the number of the side that all points are on."""
    for k, side in enumerate(SIDES):
        for axis in range(3):
            values = {CORNERS[v][axis] for v in side}
            if len(values) == 1 and all(abs(p[axis] - min(values)) < 1e-6 for p in points):
                return 10 * (k + 1)
    return 0


class Regions(InFolder):
    def setUp(self):
        super().setUp()
        with open(self.path("cube.mesh"), "w", encoding="ascii") as file:
            file.write(cube())

    def work(self, *words):
        done = run(*[self.path(word) if re.fullmatch(r"[a-z0-9]+\.[a-z]+", word) else word for word in words])
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def check_sides(self, name, section):
        positions, found = cells(self.path(name), section)
        self.assertGreater(len(found), 0)
        for vertices, region in found:
            self.assertEqual(region, side_of([positions[v] for v in vertices]))
        return collections.Counter(region for _, region in found)

    def test_formats_keep_them(self):
        chain = ["cube.mesh", "a.vtk", "b.msh", "c.vtu", "d.inp", "e.vtp", "f.mesh"]
        for source, target in zip(chain, chain[1:]):
            self.work("convert", source, target)
        self.assertEqual(self.check_sides("f.mesh", "Triangles"), HALVES)
        self.assertIn("6 regions of triangles (10 to 60)", self.work("info", "e.vtp"))

    def test_verbs_keep_them(self):
        self.work("repair", "cube.mesh", "-o", "repaired.mesh")
        self.assertEqual(self.check_sides("repaired.mesh", "Triangles"), HALVES)
        self.work("hex", "cube.mesh", "-o", "hexes.mesh", "--cells", "27")
        sides = self.check_sides("hexes.mesh", "Quadrilaterals")
        self.assertEqual((len(sides), len(set(sides.values()))), (6, 1))

    def test_faces_of_hexahedra_follow_where_regions_meet(self):
        with open(self.path("halves.mesh"), "w", encoding="ascii") as file:
            file.write(two_regions())
        report = self.path("report.json")
        said = self.work("hex", "halves.mesh", "-o", "hexes.mesh", "--cells", "300", "--report", report)
        self.assertIn("between regions", said)
        with open(report, encoding="utf-8") as file:
            regions = json.load(file)["regions"]
        self.assertEqual((regions["hexahedra"], regions["conforming"]), (2, True))
        self.assertGreater(regions["quadrilaterals_between"], 0)
        self.assertLess(regions["hausdorff_percent"], 1e-9)
        positions, found = cells(self.path("hexes.mesh"), "Hexahedra")
        for vertices, region in found:
            for v in vertices:
                beyond = slope_of(positions[v])
                self.assertLess(beyond if region == 4 else -beyond, 1e-9)


if __name__ == "__main__":
    main()
