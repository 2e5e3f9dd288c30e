"""Shapes on one triangulation from Python; given the command, that they are the mesh of `orbicube morph`, bit for bit in float32."""

import json
import os
import struct
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import orbicube
from orbicube import mesh
from orbicube.correspondence import Correspondence

COMMAND = (sys.argv.pop(1) if len(sys.argv) > 1 else "") or None


def chunks(path):
    """The JSON and the binary part of a GLB file."""
    with open(path, "rb") as file:
        data = file.read()
    length = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + length]), data[28 + length:]


def accessor(scene, binary, index):
    """The numbers of an accessor, in rows of what it holds."""
    one = scene["accessors"][index]
    view = scene["bufferViews"][one["bufferView"]]
    kind = {5123: np.uint16, 5125: np.uint32, 5126: np.float32}[one["componentType"]]
    columns = {"SCALAR": 1, "VEC3": 3}[one["type"]]
    offset = view.get("byteOffset", 0) + one.get("byteOffset", 0)
    return np.frombuffer(binary, kind, one["count"] * columns, offset).reshape(-1, columns)


def delta_for(base, target):
    """The float32 whose float32 sum with the base is nearest to the target, as a glTF file stores it."""
    nearest = best = (target.astype(float) - base).astype(np.float32)

    def error(delta):
        return np.abs((base + delta).astype(float) - target)

    for limit in (-np.inf, np.inf):
        candidate = np.nextafter(nearest, np.float32(limit))
        best = np.where(error(candidate) < error(best), candidate, best)
    return best


class Shapes(unittest.TestCase):
    def setUp(self):
        self.shapes = [mesh.make("creature", 500, seed=seed) for seed in (0, 1)]

    def test_blends_end_at_the_shapes(self):
        both = Correspondence(self.shapes, grid="first")
        self.assertEqual(both.shape_count, 2)
        self.assertTrue(np.array_equal(both.blend([0, 1]), both.positions(1)))
        self.assertTrue(np.array_equal(both.blend([0.5, 0.5]), 0.5 * both.positions(0) + 0.5 * both.positions(1)))
        self.assertEqual(len(both.triangles), 2 * len(both.positions(0)) - 4)

    def test_points_are_mapped_there_and_back(self):
        both = Correspondence(self.shapes, grid="first")
        triangles, weights = both.map(0, 1)
        self.assertEqual(len(triangles), len(self.shapes[0].positions))
        back = both.map(1, 0, triangles, weights)
        corners = self.shapes[0].triangles[back[0]]
        found = np.einsum("vk,vkx->vx", back[1], self.shapes[0].positions[corners])
        self.assertLess(np.abs(found - self.shapes[0].positions).max(), 1e-6)
        self.assertTrue(np.allclose(np.linalg.norm(both.domain, axis=1), 1))
        self.assertEqual(both.quads.shape, (0, 4))
        self.assertRaises(ValueError, both.map, 0, 2)
        self.assertRaises(ValueError, both.map, 0, 1, triangles)
        self.assertRaises(ValueError, both.map, 0, 1, triangles, weights[:-1])

    def test_landmarks_replace_the_alignment(self):
        landmarks = [shape.positions[[3, 50, 90, 130]] for shape in (self.shapes[0], self.shapes[0])]
        same = Correspondence([self.shapes[0]] * 2, grid="first", landmarks=landmarks)
        self.assertLess(np.abs(same.positions(0) - same.positions(1)).max(), 1e-9)
        self.assertRaises(ValueError, Correspondence, self.shapes, landmarks=landmarks[:1])

    def test_mistakes_are_refused(self):
        both = Correspondence(self.shapes, grid="first")
        self.assertRaises(ValueError, both.blend, [1])
        self.assertRaises(ValueError, both.positions, 2)
        self.assertRaises(orbicube.InvalidArgument, Correspondence, self.shapes[:1])
        self.assertRaises(ValueError, Correspondence, self.shapes, via="cube")

    def test_any_number_of_threads_gives_the_same_bits(self):
        one, four = (Correspondence(self.shapes, threads=threads) for threads in (1, 4))
        self.assertTrue(np.array_equal(one.positions(1), four.positions(1)))
        self.assertTrue(np.array_equal(one.triangles, four.triangles))


@unittest.skipIf(COMMAND is None, "no command")
class Command(unittest.TestCase):
    def test_the_mesh_is_that_of_morph(self):
        for via, options in (("sphere", []), ("polycube", ["--polycube", "--grid", "cells:600"])):
            with self.subTest(via), tempfile.TemporaryDirectory() as folder:
                paths = [os.path.join(folder, name) for name in ("a.ply", "b.ply")]
                for path, shape in zip(paths, (mesh.make("creature", 300, seed=seed) for seed in (0, 1))):
                    mesh.write(path, shape)
                out = os.path.join(folder, "morph.glb")
                subprocess.run([COMMAND, "morph", *paths, "-o", out, "--placement", "scaled", *options], check=True,
                               capture_output=True)
                both = Correspondence([mesh.read(path) for path in paths], via=via, placement="scaled",
                                      cells=600 if via == "polycube" else 0)
                self.compare(out, both)

    def compare(self, path, both):
        scene, binary = chunks(path)
        primitive = scene["meshes"][0]["primitives"][0]
        stored = accessor(scene, binary, primitive["attributes"]["POSITION"])
        triangles = accessor(scene, binary, primitive["indices"]).reshape(-1, 3)
        node = next(node for node in scene["nodes"] if "mesh" in node)
        shift, scale = np.array(node.get("translation", [0, 0, 0])), np.array(node.get("scale", [1, 1, 1]))
        self.assertTrue(np.array_equal(triangles, both.triangles))
        self.assertTrue(np.array_equal(stored, ((both.positions(0) - shift) / scale).astype(np.float32)))
        delta = accessor(scene, binary, primitive["targets"][0]["POSITION"])
        target = ((both.positions(1) - shift) / scale).astype(np.float32)
        self.assertTrue(np.array_equal(delta, delta_for(stored, target)))


if __name__ == "__main__":
    unittest.main()
