"""Meshes and results are values: they compare, hash, copy, pickle and show what they hold."""

import copy
import os
import pickle
import tempfile
import unittest

import numpy as np
import orbicube
from solids import box_of_tetrahedra
from orbicube import gltf, hexmesh, mesh, polycube, sphere_map, trust_region, volume_map


class Meshes(unittest.TestCase):
    def test_a_pickled_mesh_has_the_same_bits_and_what_its_file_said(self):
        positions, tetrahedra = box_of_tetrahedra(2)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.vtk")
            mesh.write(path, mesh.Mesh(positions, tetrahedra=tetrahedra))
            read = mesh.read(path)
        for one in (mesh.make("creature", 500), read, mesh.Mesh(positions, [[0, 1, 2]], tetrahedra), mesh.Mesh(np.empty((0, 3)))):
            for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
                again = pickle.loads(pickle.dumps(one, protocol))
                for name in ("positions", "triangles", "tetrahedra", "hexahedra"):
                    self.assertEqual(getattr(again, name).tobytes(), getattr(one, name).tobytes(), name)
                for name in ("format", "polygon_count", "welded_vertex_count", "notes"):
                    self.assertEqual(getattr(again, name), getattr(one, name), name)
                self.assertEqual(again, one)
                self.assertEqual(hash(again), hash(one))
                self.assertEqual(repr(again), repr(one))
                self.assertFalse(again.positions.flags.writeable)
            self.assertEqual(pickle.loads(pickle.dumps(pickle.loads(pickle.dumps(one)))).format, one.format)

    def test_regions_are_kept_in_files_and_pickles_and_compared(self):
        positions, tetrahedra = box_of_tetrahedra(2)
        materials = np.arange(len(tetrahedra), dtype=np.int32) % 3 - 1
        one = mesh.Mesh(positions, [[0, 1, 2], [1, 2, 3]], tetrahedra, triangle_regions=[5, 0], tetrahedron_regions=materials)
        self.assertEqual(one.triangle_regions.tolist(), [5, 0])
        self.assertIsNone(one.hexahedron_regions)
        self.assertIsNone(mesh.make("cube", 100).triangle_regions)
        held = [form.ending for form in mesh.formats() if form.regions and form.cells]
        self.assertEqual(held, [".mesh", ".vtk", ".msh", ".inp", ".vtu"])
        with tempfile.TemporaryDirectory() as folder:
            for ending in held:
                path = os.path.join(folder, "a" + ending)
                mesh.write(path, one)
                self.assertEqual(mesh.read(path), one, ending)
        self.assertEqual(pickle.loads(pickle.dumps(one)), one)
        for unlike in ({}, {"triangle_regions": [5, 1], "tetrahedron_regions": materials}):
            self.assertNotEqual(mesh.Mesh(positions, one.triangles, tetrahedra, **unlike), one)
        for given, message in (([5], "1 numbers of 2 triangles"), ([1.5, 2], "one integer"), ([2**31, 0], "32 bits")):
            with self.assertRaisesRegex(ValueError, "triangle_regions: .*" + message):
                mesh.Mesh(positions, one.triangles, triangle_regions=given)

    def test_copies_are_equal_and_other_meshes_are_not(self):
        one, other = mesh.make("sphere", 200), mesh.make("cube", 200)
        for made in (copy.copy(one), copy.deepcopy(one), copy.deepcopy([one])[0], mesh.Mesh(one.positions, one.triangles)):
            self.assertEqual(made, one)
            self.assertIn(made, {one})
        moved = one.positions.copy()
        moved[3, 1] += 1e-12
        for unlike in (other, mesh.Mesh(moved, one.triangles), mesh.Mesh(one.positions, one.triangles[1:]), 3, None):
            self.assertNotEqual(unlike, one)
        zeros = mesh.Mesh(np.zeros((1, 3))), mesh.Mesh(-np.zeros((1, 3)))
        self.assertEqual(*zeros)
        self.assertEqual(*map(hash, zeros))

    def test_what_is_shown_has_the_counts_that_there_are(self):
        self.assertEqual(repr(mesh.Mesh(*box_of_tetrahedra(1)[:1], tetrahedra=box_of_tetrahedra(1)[1])),
                         "Mesh(8 vertices, 6 tetrahedra)")
        self.assertRegex(repr(mesh.make("cube", 100)), r"^Mesh\(\d+ vertices, \d+ triangles\)$")


class Results(unittest.TestCase):
    def test_results_pickle_copy_and_compare(self):
        shape, solid = mesh.make("cube", 100), box_of_tetrahedra(1)
        with tempfile.TemporaryDirectory() as folder:
            gltf.write(os.path.join(folder, "a.glb"), shape)
            surface = gltf.read(os.path.join(folder, "a.glb"))
        map = polycube.compute(shape)
        for result in (sphere_map.compute(shape), surface, volume_map.map_to_polycube(solid), map.graph(), map.quads(quads=50),
                       hexmesh.fill_with_hexahedra(shape, cells=8), mesh.topology(shape)):
            again = pickle.loads(pickle.dumps(result))
            self.assertEqual(again, result)
            self.assertEqual(copy.deepcopy(result), result)
            self.assertNotEqual(result, None)
            self.assertRegex(repr(again), r"\w+\(.*\d")
        other = volume_map.map_to_polycube(solid)
        other.positions[0, 0] += 1
        self.assertNotEqual(other, volume_map.map_to_polycube(solid))

    def test_a_map_to_a_polycube_is_copied_and_says_how_it_is_kept(self):
        map = polycube.compute(mesh.make("cube", 100))
        self.assertIs(copy.deepcopy(map), map)
        with self.assertRaisesRegex(TypeError, "certify"):
            pickle.dumps(map)

    def test_a_run_says_that_it_is_saved_otherwise(self):
        with self.assertRaises((TypeError, ValueError)):
            pickle.dumps(trust_region.Solver([0.0]))
        self.assertEqual(orbicube.NoValidResult(-11, "a", "b").args, ("a: b",))


if __name__ == "__main__":
    unittest.main()
