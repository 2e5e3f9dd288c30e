"""What glTF files have besides their surface stays with another shape of it: materials, textures, texture coordinates, skins."""
import json
import os
import struct
import sys
import tempfile
import unittest

import numpy as np

from orbicube import gltf, mesh

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "cli"))
from decorated import COLUMNS, ROWS, write_decorated  # noqa: E402


class File:
    """The document and the buffer of a GLB."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        length, = struct.unpack_from("<I", data, 12)
        self.json, self.buffer = json.loads(data[20:20 + length]), data[28 + length:]

    def bytes(self, view):
        view = self.json["bufferViews"][view]
        return self.buffer[view.get("byteOffset", 0):][:view["byteLength"]]

    def coordinates(self, primitive):
        accessor = self.json["accessors"][self.json["meshes"][0]["primitives"][primitive]["attributes"]["TEXCOORD_0"]]
        start = accessor.get("byteOffset", 0)
        values = np.frombuffer(self.bytes(accessor["bufferView"])[start:], dtype="<f4", count=2 * accessor["count"])
        return values.reshape(-1, 2)

    @property
    def image(self):
        return self.bytes(self.json["images"][0]["bufferView"])


class Kept(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.given = File(write_decorated(self.path("given.glb")))
        self.surface = gltf.read(self.path("given.glb"), keep=True)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def look_at(self, written):
        self.assertEqual([one["name"] for one in written.json["materials"]], ["painted", "red"])
        self.assertEqual(written.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0)
        self.assertEqual(written.image, self.given.image)
        self.assertEqual(written.json["scenes"][0]["extras"], {"author": "A"})
        self.assertEqual(written.json["skins"][0]["name"], "bones")

    def test_another_shape_keeps_textures_and_texture_coordinates(self):
        self.assertTrue(self.surface.keeps)
        self.assertFalse(any(note.startswith("left out") for note in self.surface.notes))
        moved = 2 * self.surface.positions + [0, 0, 1]
        gltf.write(self.path("moved.glb"), (moved, self.surface.triangles), kept=self.surface)
        written = File(self.path("moved.glb"))
        self.look_at(written)
        wanted = np.array([(j / COLUMNS, i / ROWS) for i in range(ROWS + 1) for j in range(COLUMNS + 1)], dtype=np.float32)
        for primitive in range(2):
            np.testing.assert_array_equal(written.coordinates(primitive), wanted)
        again = gltf.read(self.path("moved.glb"))
        self.assertFalse(again.keeps)
        np.testing.assert_allclose(again.positions, moved, rtol=1e-6, atol=1e-6)

    def test_other_triangles_take_them_from_where_they_lie(self):
        corners = self.surface.positions[self.surface.triangles]
        middles = (corners + np.roll(corners, -1, axis=1)) / 2
        points = np.concatenate([corners, middles], axis=1).reshape(-1, 3)
        quarters = np.array([[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]])
        triangles = (6 * np.arange(len(corners))[:, None, None] + quarters).reshape(-1, 3)
        gltf.write(self.path("finer.glb"), (1.5 * points, triangles), kept=self.surface, kept_positions=points)
        written = File(self.path("finer.glb"))
        self.look_at(written)
        self.assertEqual(len(gltf.read(self.path("finer.glb")).triangles), 4 * len(corners))
        found = np.concatenate([written.coordinates(primitive) for primitive in range(2)])
        self.assertTrue(np.all((found >= 0) & (found <= 1)))
        self.assertTrue({k / (2 * COLUMNS) for k in range(2 * COLUMNS + 1)} <= set(found[:, 0].tolist()))

    def test_the_file_can_be_written_as_it_is(self):
        gltf.write_kept(self.path("same.glb"), self.surface)
        written = File(self.path("same.glb"))
        self.look_at(written)
        self.assertEqual(written.json["meshes"][0]["extras"], {"note": "kept"})
        np.testing.assert_array_equal(gltf.read(self.path("same.glb")).positions, self.surface.positions)

    def test_bytes_keep_as_well(self):
        with open(self.path("given.glb"), "rb") as file:
            surface = gltf.read_memory(file.read(), keep=True)
        gltf.write_kept(self.path("same.glb"), surface)
        self.look_at(File(self.path("same.glb")))

    def test_what_does_not_fit_is_refused(self):
        plain = gltf.read(self.path("given.glb"))
        self.assertFalse(plain.keeps)
        self.assertTrue(any(note.startswith("left out") for note in plain.notes))
        shape = (self.surface.positions, self.surface.triangles)
        with self.assertRaisesRegex(ValueError, "keep=True"):
            gltf.write(self.path("a.glb"), shape, kept=plain)
        with self.assertRaisesRegex(ValueError, "keep=True"):
            gltf.write_kept(self.path("a.glb"), plain)
        with self.assertRaises(TypeError):
            gltf.write_kept(self.path("a.glb"), mesh.make("cube", 100))
        with self.assertRaisesRegex(Exception, "triangles"):
            gltf.write(self.path("a.glb"), (shape[0], shape[1][1:]), kept=self.surface)
        with self.assertRaisesRegex(Exception, "colors"):
            gltf.write(self.path("a.glb"), shape, kept=self.surface, colors=np.zeros((len(shape[0]), 4), dtype=np.uint8))
        with self.assertRaisesRegex(Exception, "needs kept"):
            gltf.write(self.path("a.glb"), shape, kept_positions=shape[0])
        self.assertFalse(os.path.exists(self.path("a.glb")))


if __name__ == "__main__":
    unittest.main()
