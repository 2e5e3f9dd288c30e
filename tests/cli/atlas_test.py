#!/usr/bin/env python3
"""orbicube polycube --atlas: patches in [0, 1]^2 without overlap, tangents, and textures that show what they should.

    atlas_test.py COMMAND
"""
import json
import math
import os
import struct
import subprocess
from collections import Counter
from fractions import Fraction

from command import Glb, InFolder, main, run
from decorated import png
from png_rows import Png

HERE = os.path.dirname(os.path.abspath(__file__))


class AtlasFile(Glb):
    def __init__(self, path):
        super().__init__(path)
        attributes = self.primitive["attributes"]
        self.normals, self.tangents = self.accessor(attributes["NORMAL"]), self.accessor(attributes["TANGENT"])
        self.extras = self.json["scenes"][0]["extras"]
        view = self.json["bufferViews"][self.json["images"][0]["bufferView"]]
        self.width, self.height, self.pixels = decoded(self.chunk[view.get("byteOffset", 0):][:view["byteLength"]])
        self.on_polycube = self.sphere(False)  # base and delta of the morph target

    def charts(self):
        """The number of the chart of each triangle: triangles that share vertices."""
        parent = list(range(len(self.positions)))

        def root(v):
            while parent[v] != v:
                parent[v] = parent[parent[v]]
                v = parent[v]
            return v

        for a, b, c in self.triangles:
            parent[root(a)] = parent[root(b)] = root(c)
        return [root(t[0]) for t in self.triangles]

    def texel(self, u, v):
        return self.pixels[min(int(v * self.height), self.height - 1)][min(int(u * self.width), self.width - 1)]


def decoded(data):
    """Width, height and rows of RGB of a PNG: palette of one bit, or RGB of eight."""
    png = Png(data)
    if png.palette:
        rows = [[png.palette[row[x // 8] >> (7 - x % 8) & 1] for x in range(png.width)] for row in png.rows]
    else:
        rows = [[tuple(row[3 * x:3 * x + 3]) for x in range(png.width)] for row in png.rows]
    return png.width, png.height, rows


def exact(points):
    """Integers in proportion to these floats, which are multiples of 2^-149."""
    return [tuple(int(Fraction(x) * 2 ** 149) for x in point) for point in points]


def area(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def apart(one, other):
    """Whether the interiors of two triangles are disjoint: an edge of one has all of the other on its outer side."""
    return any(all(area(t[i], t[(i + 1) % 3], p) <= 0 for p in s)
               for t, s in ((one, other), (other, one)) for i in range(3))


def overlaps(triangles):
    """Pairs of counter-clockwise triangles with common inner points."""
    boxes = [(min(p[0] for p in t), max(p[0] for p in t), min(p[1] for p in t), max(p[1] for p in t)) for t in triangles]
    order = sorted(range(len(triangles)), key=lambda i: boxes[i][0])
    active, found = [], 0
    for i in order:
        active = [j for j in active if boxes[j][1] > boxes[i][0]]
        for j in active:
            if boxes[j][2] < boxes[i][3] and boxes[i][2] < boxes[j][3] and not apart(triangles[i], triangles[j]):
                found += 1
        active.append(i)
    return found


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def middle(points):
    return tuple(sum(xs) / 3 for xs in zip(*points))


def srgb(amount):
    return 255 * (12.92 * amount if amount <= 0.0031308 else 1.055 * amount ** (1 / 2.4) - 0.055)


class Atlas(InFolder):
    def atlas(self, source, *options, name="atlas.glb"):
        done = run("polycube", source, "-o", self.path("polycube.obj"), "--atlas", self.path(name), "--report", self.path("report.json"), *options)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(self.path("report.json"), encoding="utf-8") as file:
            self.figures = json.load(file)["atlas"]
        return AtlasFile(self.path(name))

    def check_layout(self, file, padding):
        self.assertTrue(all(0 <= x <= 1 for at in file.texture_coordinates for x in at))
        # v goes down: mirrored, so that triangles are counter-clockwise.
        corners = exact([(u, -v) for u, v in file.texture_coordinates])
        triangles = [tuple(corners[v] for v in t) for t in file.triangles]
        self.assertEqual(sum(area(*t) <= 0 for t in triangles), self.figures["triangles_lost_in_texture"])
        self.assertEqual(self.figures["triangles_lost_in_texture"], 0)
        self.assertEqual(overlaps(triangles), 0)
        # Borders of charts are horizontal and vertical, so that the larger of the gaps along both is at most their distance.
        charts = file.charts()
        self.assertEqual(len(set(charts)), self.figures["patches"])
        sides = Counter(frozenset((t[i], t[(i + 1) % 3])) for t in file.triangles for i in range(3))
        borders = []
        for t, chart in zip(file.triangles, charts):
            for i in range(3):
                if sides[frozenset((t[i], t[(i + 1) % 3]))] == 1:
                    a, b = file.texture_coordinates[t[i]], file.texture_coordinates[t[(i + 1) % 3]]
                    borders.append((chart, min(a[0], b[0]), max(a[0], b[0]), min(a[1], b[1]), max(a[1], b[1])))
        # Of a texel, that rounding to float32 may take away: 2^-24 of the texture at either side.
        least = padding - 2 * file.width * 2.0 ** -24
        for i, (chart, *one) in enumerate(borders):
            for other_chart, *other in borders[:i]:
                if chart != other_chart:
                    gap = max(one[0] - other[1], other[0] - one[1], one[2] - other[3], other[2] - one[3])
                    self.assertGreaterEqual(gap * file.width, least)
            self.assertGreaterEqual(min(one[0], one[2], 1 - one[1], 1 - one[3]) * file.width, least / 2)

    def check_scale(self, file):
        """All edges are as long in the texture as on the polycube, times one scale."""
        scale = file.extras["texels_per_unit"]
        size = max(abs(x) for p in file.on_polycube for x in p)
        for t in file.triangles:
            for i in range(3):
                a, b = t[i], t[(i + 1) % 3]
                on_polycube = math.dist(file.on_polycube[a], file.on_polycube[b])
                texels = math.dist(file.texture_coordinates[a], file.texture_coordinates[b]) * file.width
                # float32 has 24 bits of each coordinate.
                self.assertAlmostEqual(texels, scale * on_polycube, delta=8 * 2.0 ** -24 * (file.width + scale * size))

    def check_directions(self, file):
        for normal, tangent in zip(file.normals, file.tangents):
            self.assertAlmostEqual(dot(normal, normal), 1, places=5)
            self.assertAlmostEqual(dot(tangent[:3], tangent[:3]), 1, places=5)
            self.assertAlmostEqual(dot(normal, tangent[:3]), 0, places=5)
            self.assertEqual(tangent[3], 1)
        # Along the growth of u: on few of these coarse, distorted triangles is the mean at a vertex a quarter turn or more away.
        along = 0
        for t in file.triangles:
            p, q, r = (file.positions[v] for v in t)
            (s, _), (s1, t1), (s2, t2) = (minus(file.texture_coordinates[v], file.texture_coordinates[t[0]]) for v in t)
            determinant = s1 * t2 - s2 * t1
            growth = tuple((t2 * x - t1 * y) / determinant for x, y in zip(minus(q, p), minus(r, p)))
            along += sum(dot(growth, file.tangents[v][:3]) > 0 for v in t)
        self.assertGreater(along, 0.95 * 3 * len(file.triangles))

    def test_patches_lie_apart_in_the_square(self):
        for shape, options in (("bracket", ()), ("creature", ("--atlas-padding", 10)), ("torus", ("--atlas-size", 300, "--atlas-padding", 0))):
            source = self.made(shape, 900)
            file = self.atlas(source, *options)
            given = dict(zip(options[::2], options[1::2]))
            self.assertEqual((file.width, file.height), 2 * (given.get("--atlas-size", 1024),))
            self.check_layout(file, given.get("--atlas-padding", 4))
            self.check_scale(file)
            self.check_directions(file)
            self.assertGreater(self.figures["coverage"], 0.4)

    def test_the_checker_has_the_squares_of_the_polycube(self):
        file = self.atlas(self.made("bracket", 900))
        low = [min(p[k] for p in file.on_polycube) for k in range(3)]
        square = file.extras["square"]
        seen = Counter()
        for t in file.triangles:
            at = middle([file.on_polycube[v] for v in t])
            flat = min(range(3), key=lambda k: max(file.on_polycube[v][k] for v in t) - min(file.on_polycube[v][k] for v in t))
            squares = [(at[k] - low[k]) / square for k in range(3) if k != flat]
            # A texel shows its own middle, which is up to a texel from here.
            if all(min(x % 1, 1 - x % 1) * square * file.extras["texels_per_unit"] > 1.5 for x in squares):
                color = file.texel(*middle([file.texture_coordinates[v] for v in t]))
                self.assertEqual(color, ((235, 235, 235), (70, 110, 160))[sum(map(math.floor, squares)) % 2])
                seen[color] += 1
        self.assertGreater(min(seen.values()), 50)
        self.assertEqual(len(seen), 2)

    def write_colored(self, name, positions, triangles, color_of, image=None):
        """A GLB whose colors of vertices, or whose texture, depend on the position."""
        low, high = (tuple(f(p[k] for p in positions) for k in range(3)) for f in (min, max))
        inside = [tuple((p[k] - low[k]) / (high[k] - low[k]) for k in range(3)) for p in positions]
        parts = [struct.pack(f"<{3 * len(positions)}f", *(x for p in positions for x in p)),
                 struct.pack(f"<{3 * len(triangles)}I", *(v for t in triangles for v in t)),
                 struct.pack(f"<{(2 if image else 3) * len(inside)}f", *(x for p in inside for x in (p[:2] if image else color_of(p)))), image or b""]
        views, binary = [], b""
        for part in parts:
            views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(part)})
            binary += part + b"\0" * (-len(part) % 4)
        attributes = {"POSITION": 0, "TEXCOORD_0" if image else "COLOR_0": 2}
        document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                    "meshes": [{"primitives": [{"attributes": attributes, "indices": 1, "material": 0}]}],
                    "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 1, 1]}}],
                    "buffers": [{"byteLength": len(binary)}], "bufferViews": views if image else views[:3],
                    "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(positions), "type": "VEC3", "min": low, "max": high},
                                  {"bufferView": 1, "componentType": 5125, "count": 3 * len(triangles), "type": "SCALAR"},
                                  {"bufferView": 2, "componentType": 5126, "count": len(positions), "type": "VEC2" if image else "VEC3"}]}
        if image:
            document |= {"images": [{"bufferView": 3, "mimeType": "image/png"}], "textures": [{"source": 0, "sampler": 0}],
                         "samplers": [{"wrapS": 33071, "wrapT": 33071}]}
            document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
        text = json.dumps(document).encode()
        text += b" " * (-len(text) % 4)
        with open(self.path(name), "wb") as file:
            file.write(struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(binary), len(text), 0x4E4F534A) + text +
                       struct.pack("<II", len(binary), 0x004E4942) + binary)
        return self.path(name), low, high

    def check_colors(self, file, low, high, color_of, tolerance):
        """Of the texel in the middle of each triangle, by the position of that texel's own middle."""
        for t in file.triangles:
            u, v = middle([file.texture_coordinates[v] for v in t])
            at = ((int(u * file.width) + 0.5) / file.width, (int(v * file.height) + 0.5) / file.height)
            corners = [file.texture_coordinates[v] for v in t]
            whole = area(*corners)
            weights = [area(at, corners[1], corners[2]) / whole, area(corners[0], at, corners[2]) / whole, area(corners[0], corners[1], at) / whole]
            if min(weights) < 0.01:
                continue
            world = self.figures_frame(file, [sum(w * file.positions[v][k] for w, v in zip(weights, t)) for k in range(3)])
            inside = tuple((world[k] - low[k]) / (high[k] - low[k]) for k in range(3))
            for seen, wanted in zip(file.texel(*at), color_of(inside)):
                self.assertAlmostEqual(seen, srgb(wanted), delta=tolerance)

    def figures_frame(self, file, stored):
        node = file.json["nodes"][0]
        return [x * s + t for x, s, t in zip(stored, node.get("scale", (1, 1, 1)), node.get("translation", (0, 0, 0)))]

    def surface(self):
        path = self.made("blob", 1200)
        positions, triangles = [], []
        with open(path, encoding="ascii") as file:
            for line in file:
                words = line.split()
                if words[0] == "v":
                    positions.append(tuple(map(float, words[1:])))
                elif words[0] == "f":
                    triangles.append(tuple(int(w) - 1 for w in words[1:]))
        return positions, triangles

    def test_the_texture_has_the_colors_of_vertices(self):
        # Linear in the position, as colors are mixed on triangles. 1.5 levels: rounding to levels and to float32.
        color_of = lambda p: (p[0], 0.5 * p[1], p[2])
        path, low, high = self.write_colored("colored.glb", *self.surface(), lambda p: (p[0], p[1], p[2]))
        file = self.atlas(path, "--texture")
        self.check_colors(file, low, high, color_of, 1.5)
        again = self.atlas(path, "--texture", "--threads", 2, name="again.glb")
        self.assertEqual(file.chunk, again.chunk)

    def test_the_texture_has_the_colors_of_a_texture(self):
        # Ramps along both sides in sRGB, each step of 4 levels a pixel wide, so that mixing in linear light is off by little.
        image = png(64, 64, lambda x, y: (4 * x, 4 * y, 128))
        path, low, high = self.write_colored("textured.glb", *self.surface(), None, image)
        file = self.atlas(path, "--texture")

        def linear(s):
            return s / 12.92 if s <= 0.04045 else ((s + 0.055) / 1.055) ** 2.4

        def color_of(p):
            ramp = [linear(4 * min(max(64 * x - 0.5, 0), 63) / 255) for x in p[:2]]
            return ramp[0], 0.5 * ramp[1], linear(128 / 255)

        self.check_colors(file, low, high, color_of, 2.5)

    def test_what_cannot_be_done_is_refused(self):
        cube, out = self.made("cube", 300), self.path("out.obj")
        self.refused(2, "unsupported-format", self.path("atlas.obj"), "polycube", cube, "-o", out, "--atlas", self.path("atlas.obj"))
        self.refused(2, "unsupported", cube, "polycube", cube, "-o", out, "--atlas", self.path("atlas.glb"), "--texture")
        for options in (("--texture",), ("--atlas-size", 64), ("--atlas-padding", 2)):
            line = run("polycube", cube, "-o", out, *options).stderr
            self.assertIn(f"{options[0]} is for --atlas", line)
        self.refused(2, "unsupported", self.path("atlas.glb"), "polycube", cube, "-o", out, "--atlas", self.path("atlas.glb"), "--atlas-size", 16,
                     "--atlas-padding", 16)
        self.assertFalse(os.path.exists(out))

    def test_the_validator_finds_nothing(self):
        modules = os.environ.get("ORBICUBE_NODE_MODULES", "")
        if not os.path.isdir(os.path.join(modules, "node_modules", "gltf-validator")):
            self.skipTest("gltf-validator is not installed")
        path, _, _ = self.write_colored("colored.glb", *self.surface(), lambda p: (p[0], p[1], p[2]))
        self.atlas(path, "--texture", name="texture.glb")
        self.atlas(self.made("bracket", 600), name="checker.glb")
        done = subprocess.run(["node", os.path.join(HERE, "..", "gltf", "engines", "validate.mjs"), modules, self.path("texture.glb"),
                               self.path("checker.glb")], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)


if __name__ == "__main__":
    main()
