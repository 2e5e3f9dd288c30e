#!/usr/bin/env python3
"""Materials, textures, texture coordinates, colors, skins, nodes and extras of a glTF file, through the command.

    kept_test.py COMMAND
"""
import json
import math
import os
import struct
import subprocess

from command import InFolder, as_float32, main, run
from decorated import COLUMNS, ROWS, write_decorated

HERE = os.path.dirname(os.path.abspath(__file__))


class File:
    """A GLB of any meshes."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        length, = struct.unpack_from("<I", data, 12)
        self.json, self.chunk = json.loads(data[20:20 + length]), data[28 + length:]

    def __getitem__(self, name):
        return self.json[name]

    def values(self, number):
        accessor = self.json["accessors"][number]
        view = self.json["bufferViews"][accessor["bufferView"]]
        components = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}[accessor["type"]]
        letter = {5126: "f", 5125: "I", 5123: "H", 5121: "B"}[accessor["componentType"]]
        size = components * struct.calcsize(letter)
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        return [struct.unpack_from(f"<{components}{letter}", self.chunk, start + i * view.get("byteStride", size))
                for i in range(accessor["count"])]

    def image(self):
        view = self.json["bufferViews"][self.json["images"][0]["bufferView"]]
        return self.chunk[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]

    def corners(self):
        """(material, position, texture coordinate) of each corner of a triangle."""
        for mesh in self.json["meshes"]:
            for primitive in mesh["primitives"]:
                places = self.values(primitive["attributes"]["POSITION"])
                coordinates = self.values(primitive["attributes"]["TEXCOORD_0"])
                for (corner,) in self.values(primitive["indices"]):
                    yield primitive["material"], places[corner], coordinates[corner]


class Kept(InFolder):
    def decorated(self, name="egg.glb", **options):
        return write_decorated(self.path(name), **options)

    def run_noting(self, *arguments):
        done = run(*arguments, "--report", self.path("report.json"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(self.path("report.json"), encoding="utf-8") as report:
            return json.load(report)["notes"]

    def validate(self, *names):
        """Khronos's validator finds neither errors nor warnings, where it is installed."""
        modules = os.environ.get("ORBICUBE_NODE_MODULES", "")
        if not os.path.isdir(os.path.join(modules, "node_modules", "gltf-validator")):
            return
        done = subprocess.run(["node", os.path.join(HERE, "..", "gltf", "engines", "validate.mjs"), modules,
                               *map(self.path, names)], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)

    def assert_kept(self, name):
        """All but the meshes is as in the egg."""
        egg, file = File(self.path("egg.glb")), File(self.path(name))
        for member in ("textures", "scenes"):
            self.assertEqual(file[member], egg[member])
        self.assertEqual([m["name"] for m in file["materials"]], ["painted", "red"])
        self.assertEqual(file["materials"][0]["extras"], {"k": [1, 2]})
        self.assertEqual(file["materials"][1]["emissiveFactor"], [0.1, 0.1, 0.1])
        self.assertEqual(file.image(), egg.image())
        self.assertEqual([node["name"] for node in file["nodes"]], ["body", "root", "tip"])
        self.assertEqual((file["nodes"][0]["skin"], file["nodes"][0]["extras"]), (0, {"id": 7}))
        self.assertEqual(file["meshes"][0]["extras"]["note"], "kept")
        self.assertEqual(file["skins"][0]["joints"], [1, 2])
        self.assertEqual(file["animations"][0]["name"], "bend")
        for primitive in file["meshes"][0]["primitives"]:
            for weights in file.values(primitive["attributes"]["WEIGHTS_0"]):
                self.assertAlmostEqual(sum(weights), 1, places=5)
        return file

    def test_convert_writes_the_same_file(self):
        self.decorated()
        self.assertEqual(self.run_noting("convert", self.path("egg.glb"), self.path("out.gltf")), [])
        self.assertEqual(self.run_noting("convert", self.path("out.gltf"), self.path("out.glb")), [])
        egg, file = File(self.path("egg.glb")), self.assert_kept("out.glb")
        self.assertEqual(list(file.corners()), list(egg.corners()))
        self.assertEqual(len(file.chunk), len(egg.chunk))
        self.validate("egg.glb", "out.glb", "out.gltf")

    def test_other_formats_say_what_they_leave_out(self):
        notes = self.run_noting("convert", self.decorated(), self.path("out.obj"))
        self.assertTrue(any(note.startswith("left out: 2 materials, 1 texture") for note in notes), notes)

    def test_a_sphere_map_keeps_texture_coordinates_and_materials(self):
        for scale in (1.0, 100.0):
            notes = self.run_noting("sphere", self.decorated(scale=scale), "-o", self.path("sphere.glb"))
            self.assertFalse(any("left out" in note for note in notes), notes)
            egg, file = File(self.path("egg.glb")), self.assert_kept("sphere.glb")
            self.assertEqual(file["meshes"][0]["extras"]["targetNames"], ["sphere"])
            factor = next(p[1] / q[1] for (_, p, _), (_, q, _) in zip(egg.corners(), file.corners()) if q[1] != 0)
            self.assertEqual(factor > 1, scale > 4)  # coordinates beyond 4 are divided by a power of two
            for (material, place, coordinate), (found, at, kept) in zip(egg.corners(), file.corners()):
                self.assertEqual((material, coordinate), (found, kept))
                self.assertEqual(tuple(as_float32(factor * x) for x in at), place)
            # The skin takes stored positions to those of the file.
            for before, after in zip(egg.values(egg["skins"][0]["inverseBindMatrices"]),
                                     file.values(file["skins"][0]["inverseBindMatrices"])):
                self.assertEqual([factor * x for x in before[:12]], list(after[:12]))
                self.assertEqual(before[12:], after[12:])
            self.validate("sphere.glb")
            # The map is read again as that of its shape.
            self.run_noting("page", self.path("egg.glb"), self.path("sphere.glb"), "-o", self.path("page.html"))

    def test_a_placed_mesh_gets_a_node_of_its_own(self):
        self.run_noting("sphere", self.decorated(bones=False), "-o", self.path("sphere.glb"))
        file = File(self.path("sphere.glb"))
        self.assertEqual([node.get("name") for node in file["nodes"]], ["hips", "body", "egg"])
        self.assertEqual([node.get("mesh") for node in file["nodes"]], [None, None, 0])
        self.assertEqual(file["scenes"][0]["nodes"], [0, 2])
        self.validate("sphere.glb")
        self.run_noting("page", self.path("egg.glb"), self.path("sphere.glb"), "-o", self.path("page.html"))

    def assert_within_seams(self, file):
        """Coordinates are those of the atlas, and no triangle spans the seam."""
        across, corners = 0, list(file.corners())
        for i in range(0, len(corners), 3):
            us = [coordinate[0] for _, _, coordinate in corners[i:i + 3]]
            across += max(us) - min(us) > 0.5
            for _, _, (u, v) in corners[i:i + 3]:
                self.assertTrue(-1e-6 <= u <= 1 + 1e-6 and -1e-6 <= v <= 1 + 1e-6)
        self.assertEqual(across, 0, "triangles that span the seam")
        return corners

    def test_a_morph_keeps_what_its_first_shape_has(self):
        self.decorated()
        other = self.made("star", 800)
        for grid in ("both", "first", "icosphere:4"):
            self.run_noting("morph", self.path("egg.glb"), other, "-o", self.path("morph.glb"), "--grid", grid,
                            "--intermediates", 1)
            file = self.assert_kept("morph.glb")
            self.assertEqual([a["name"] for a in file["animations"]], ["bend", "morph"])
            self.assertEqual(file["meshes"][0]["extras"]["targetNames"], ["star"])
            corners = self.assert_within_seams(file)
            if grid == "both":
                # Corners at vertices of the egg have the coordinates that these have there.
                egg = {}
                for material, place, coordinate in File(self.path("egg.glb")).corners():
                    egg.setdefault(place, set()).add(coordinate)
                found = [coordinate for _, place, coordinate in corners if place in egg]
                self.assertGreater(len(found), 2 * ROWS * COLUMNS)
                wrong = sum(coordinate not in egg[place] for _, place, coordinate in corners if place in egg)
                self.assertLess(wrong, 0.02 * len(found))
            step = self.assert_kept("morph-01.glb")
            self.assertNotIn("targetNames", step["meshes"][0]["extras"])
            self.validate("morph.glb", "morph-01.glb")

    def test_a_morph_through_a_polycube_keeps_what_its_first_shape_has(self):
        self.decorated()
        other = self.made("star", 800)
        heights = [math.cos(math.pi * i / ROWS) for i in range(ROWS + 1)]
        for grid in ("first", "cells:2000"):
            self.run_noting("morph", "--polycube", self.path("egg.glb"), other, "-o", self.path("morph.glb"), "--grid", grid,
                            "--intermediates", 1, "--show-polycube")
            file = self.assert_kept("morph.glb")
            self.assertEqual(file["meshes"][0]["extras"]["targetNames"], ["polycube", "star"])
            corners = self.assert_within_seams(file)
            # On the egg, v is a function of the height that is linear between its rows. At the seam it is that of a place nearby.
            wrong = []
            for _, (_, y, _), (_, v) in corners:
                row = next(i for i in range(ROWS) if heights[i + 1] <= y + 1e-6)
                expected = (row + (heights[row] - y) / (heights[row] - heights[row + 1])) / ROWS
                wrong.append(abs(v - expected))
            self.assertLess(max(wrong), 1 / ROWS)
            self.assertLess(sum(w > 1e-4 for w in wrong), 0.1 * len(wrong))
            self.assert_kept("morph-01.glb")
            self.validate("morph.glb", "morph-01.glb")


if __name__ == "__main__":
    main()
