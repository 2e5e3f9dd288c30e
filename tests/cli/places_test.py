#!/usr/bin/env python3
"""Places in refusals of the command: each stands once, and is where the input has it, at any size of the input.

    places_test.py COMMAND
"""
import re

from command import InFolder, main, run

FACES = ((0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6),
         (1, 3, 5), (3, 7, 5))
OUTPUTS = {"sphere": "out.ply", "polycube": "out.obj", "tetrahedralize": "out.mesh", "volume": "out.mesh", "hex": "out.mesh"}


def box(low, high):
    return [tuple((low, high)[i >> k & 1][k] for k in range(3)) for i in range(8)]


def joined(positions, triangles):
    """Vertices at the same place become one."""
    first = {p: positions.index(p) for p in positions}
    used = sorted(set(first.values()))
    return [positions[i] for i in used], [tuple(used.index(first[positions[v]]) for v in t) for t in triangles]


def boxes(*corners):
    positions, triangles = [], []
    for low, high in corners:
        triangles += [tuple(len(positions) + v for v in face) for face in FACES]
        positions += box(low, high)
    return positions, triangles


class Places(InFolder):
    def shapes(self):
        """Kind of the refusal and shape."""
        whole = boxes(((1, 2, 3), (2, 4, 6)))
        yield "not-closed", (whole[0], whole[1][:-1])
        yield "duplicate-face", (whole[0], whole[1] + whole[1][-1:])
        yield "non-manifold-edge", joined(*boxes(((0, 0, 0), (1, 1, 1)), ((1, 1, 0), (3, 2, 1))))
        yield "non-manifold-vertex", joined(*boxes(((0, 0, 0), (1, 1, 1)), ((1, 1, 1), (3, 2, 2))))
        yield "self-intersection", boxes(((0, 0, 0), (1, 1, 1)), ((.5, .5, .5), (3, 2, 2)))
        # A face of three points on a line.
        yield "degenerate-face", (whole[0] + [(1.5, 2, 3)], [t for t in whole[1] if t != (0, 2, 1)] + [(0, 8, 1), (0, 2, 8), (8, 2, 1)])

    def message(self, verb, shape, exponent):
        path = self.path("in.off")
        positions, triangles = shape
        with open(path, "w", encoding="ascii") as file:
            file.write(f"OFF\n{len(positions)} {len(triangles)} 0\n")
            file.writelines("%r %r %r\n" % tuple(x * 2.0**exponent for x in p) for p in positions)
            file.writelines("3 %d %d %d\n" % t for t in triangles)
        options = ("--cells", 100) if verb == "hex" else ()
        return run(verb, path, "-o", self.path(OUTPUTS[verb]), *options)

    def test_places_are_told_once_and_grow_with_the_input(self):
        number = r"(-?[\d.]+(?:e[-+]\d+)?)"
        place = re.compile(rf"\({number}, {number}, {number}\)")
        told = 0
        for kind, shape in self.shapes():
            for verb in OUTPUTS:
                found = {}
                for exponent in (0, 40, -40):
                    done = self.message(verb, shape, exponent)
                    if kind == "degenerate-face" and verb in ("sphere", "polycube") and done.returncode == 0:
                        continue  # a triangle without area has a map
                    if kind == "self-intersection" and verb in ("sphere", "polycube"):
                        self.assertIn("not-connected", done.stderr)
                        continue
                    self.assertEqual(done.returncode, 2, (kind, verb, done.stderr))
                    self.assertIn(f": {kind}: ", done.stderr, verb)
                    texts = [match.group(0) for match in place.finditer(done.stderr)]
                    self.assertEqual(len(texts), len(set(texts)), done.stderr)
                    found[exponent] = [tuple(float(x) for x in match) for match in place.findall(done.stderr)]
                for exponent, places in found.items():
                    self.assertEqual(len(places), len(found[0]), (kind, verb, exponent))
                    told += len(places)
                    for one, scaled in zip(found[0], places):
                        self.assertIn(one, shape[0], (kind, verb))
                        for x, y in zip(one, scaled):
                            self.assertAlmostEqual(x, y * 2.0**-exponent, delta=1e-7, msg=(kind, verb, exponent))
        self.assertGreater(told, 30)


if __name__ == "__main__":
    main()
