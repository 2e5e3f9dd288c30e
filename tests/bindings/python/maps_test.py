"""Meshes, sphere maps, harmonics and glTF from Python: what comes out is what the libraries promise."""

import gc
import math
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np
import orbicube
from interrupts import interrupted_after
from orbicube import gltf, harmonics, mesh, quaternion, sphere_map
from solids import box_of_tetrahedra
from solvers_test import from_c

class Meshes(unittest.TestCase):
    def test_views_are_not_copies_and_outlive_the_mesh(self):
        torus = mesh.make("torus", 3000)
        positions, triangles = torus.positions, torus.triangles
        self.assertFalse(positions.flags.owndata or positions.flags.writeable or triangles.flags.owndata)
        total = positions.sum()
        del torus
        gc.collect()
        self.assertEqual(positions.sum(), total)
        self.assertEqual(mesh.topology((positions, triangles)).genus, 1)

    def test_files_hold_the_same_bits(self):
        shape = mesh.make("creature", 2000, seed=3)
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.ply", "a.obj", "a.off"):
                path = os.path.join(folder, name)
                mesh.write(path, shape)
                again = mesh.read(path)
                self.assertEqual(again.positions.tobytes(), shape.positions.tobytes())
                self.assertEqual(again.triangles.tobytes(), shape.triangles.tobytes())
            with open(os.path.join(folder, "a.ply"), "rb") as file:
                self.assertEqual(len(mesh.read_memory(file.read(), "ply")), len(shape))
            self.assertIn("PLY", mesh.read(os.path.join(folder, "a.ply")).format)
            with self.assertRaises(orbicube.FileError) as caught:
                mesh.read(os.path.join(folder, "none.ply"))
            self.assertIsInstance(caught.exception, OSError)
            self.assertIn("none.ply", str(caught.exception))

    def test_the_formats_are_those_of_the_library(self):
        known = {one.word: one for one in mesh.formats()}
        self.assertEqual(known["medit"], ("medit", ".mesh", True, True, False, True))
        self.assertEqual([one.ending for one in mesh.formats() if not one.polygons], [".stl", ".white", ".gii"])

    def test_defects_are_named(self):
        shape = mesh.make("sphere", 500)
        with self.assertRaises(orbicube.UnsuitableSurface) as caught:
            mesh.check_closed_genus_zero((shape.positions, shape.triangles[:-1]))
        self.assertEqual(caught.exception.status, orbicube.raw.base.OBC_NOT_CLOSED)
        broken = shape.triangles.copy()
        broken[7] = broken[7][::-1]
        turned, report = mesh.orient((shape.positions, broken))
        self.assertEqual(report.reversed_triangles, 1)
        np.testing.assert_array_equal(turned, np.where(np.arange(len(broken))[:, None] == 7, turned[7], shape.triangles))
        self.assertIn(list(turned[7]), [list(np.roll(shape.triangles[7], k)) for k in range(3)])
        with self.assertRaises(orbicube.MalformedFile):
            mesh.read_memory(b"OFF 3 1 0\n0 0 0\n", "off")
        with self.assertRaisesRegex(ValueError, "not within 0 to"):
            mesh.topology((shape.positions, shape.triangles.astype(np.int64) - 1))
        with self.assertRaisesRegex(ValueError, "shape"):
            mesh.topology((shape.positions[:, :2], shape.triangles))
        with self.assertRaisesRegex(TypeError, "integers"):
            mesh.topology((shape.positions, shape.triangles.astype(float)))

    def test_objects_of_trimesh_and_meshio_are_surfaces(self):
        shape = mesh.make("torus", 800)

        class Trimesh:
            vertices, faces = shape.positions, shape.triangles.astype(np.int64)

        class Block:
            def __init__(self, kind, data):
                self.type, self.data = kind, data

        class Meshio:
            points = shape.positions
            cells = [Block("line", np.zeros((2, 2), int)), Block("triangle", shape.triangles[:300].astype(np.int64)),
                     Block("triangle", shape.triangles[300:].astype(np.int64))]

        for other in (Trimesh(), Meshio()):
            self.assertEqual(mesh.topology(other).as_dict(), mesh.topology(shape).as_dict())

    def test_cells_and_their_boundary(self):
        solid = mesh.Mesh(*[box_of_tetrahedra(2)[0]], tetrahedra=box_of_tetrahedra(2)[1])
        mesh.check_cells(solid)
        self.assertEqual(solid.tetrahedra.shape, (48, 4))
        skin = solid.boundary()
        self.assertEqual(len(skin.triangles), 48)
        report = mesh.tetrahedron_quality(solid)
        self.assertEqual((report.tetrahedra, report.positive), (48, 48))
        self.assertAlmostEqual(report.volume, 1, places=14)

    def test_searches_and_exact_signs(self):
        shape = mesh.make("sphere", 2000)
        search = mesh.Search(shape)
        np.testing.assert_array_equal(search.vertices(shape.positions), np.arange(len(shape)))
        triangles, weights, positions, distances = search.surface(2 * shape.positions[:50])
        corners = shape.positions[shape.triangles[triangles]]
        np.testing.assert_allclose(np.einsum("ij,ijk->ik", weights, corners), positions, atol=1e-14)
        self.assertTrue(np.all(distances > 0))
        self.assertEqual(mesh.orientation_from_origin([.1, .1, .1], [.2, .2, .2], [0, 0, 1]), 0)
        self.assertEqual(mesh.orientation_2d([0, 0], [1, 0], [0, 1]), 1)
        with self.assertRaises(ValueError):
            mesh.orientation_3d([0, 0, math.nan], [1, 0, 0], [0, 1, 0], [0, 0, 1])

    def test_ten_million_vertices_pass_without_a_copy(self):
        """In a process of its own, whose largest size is known: with an array of 240 MB it grows by the 80 MB of the result,
        which the library makes in its own memory first, and not by a copy of what it is given."""
        program = """if True:
            import resource, numpy as np
            from orbicube import gltf, harmonics, mesh, quaternion, sphere_map
            positions = np.ones((10_000_000, 3))
            triangles = np.zeros((1, 3), dtype=np.uint32); triangles[0] = 0, 1, 2
            mesh.vertex_areas((positions[:3], triangles))  # the library is loaded
            before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
            areas = mesh.vertex_areas((positions, triangles))
            after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
            assert areas.nbytes == 80_000_000 and after - before < 200_000, (before, after)  # KiB; a copy: over 312_000
        """
        subprocess.run([sys.executable, "-c", program], check=True)


class Maps(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.shape = mesh.make("creature", 400)
        cls.map = sphere_map.compute(cls.shape)

    def test_the_bits_are_those_of_c(self):
        count, ends = from_c()["creature"]
        directions = self.map.directions
        self.assertEqual(len(directions), count)
        self.assertEqual(np.concatenate([directions[0], directions[-1]]).tobytes(), ends[:6].tobytes())
        total = 0.0
        for value in directions.ravel():
            total = 0.5 * total + value
        self.assertEqual(total, ends[6])

    def test_the_map_is_a_bijection_of_unit_vectors(self):
        self.assertEqual(self.map.report.bijective, 1)
        np.testing.assert_allclose(np.linalg.norm(self.map.directions, axis=1), 1, atol=4e-16)
        again = sphere_map.measure(self.shape, self.map.directions)
        self.assertEqual(again.as_dict(), self.map.report.as_dict())
        self.assertIn("bijective=1", repr(self.map.report))

    def test_progress_is_told_and_can_cancel(self):
        told = []
        sphere_map.compute(self.shape, progress=lambda phase, done, total, best: told.append(phase))
        self.assertGreater(len(told), 3)
        with self.assertRaises(orbicube.Cancelled):
            sphere_map.compute(self.shape, progress=lambda *_: True)
        with self.assertRaises(ZeroDivisionError):
            sphere_map.compute(self.shape, progress=lambda *_: 1 / 0)
        directions, placed, failed = sphere_map.compute_partial(self.shape, progress=lambda *_: True)
        self.assertIsInstance(failed, orbicube.Cancelled)
        self.assertLess(placed, len(directions))

    def test_ctrl_c_stops_the_work_soon(self):
        shape = mesh.make("creature", 60000)
        handler = signal.getsignal(signal.SIGINT)
        with self.assertRaises(KeyboardInterrupt), interrupted_after(0.3) as sent:
            sphere_map.compute(shape)
        self.assertLess(time.process_time() - sent[0], 2)  # 0.05 and a little, while the map takes many seconds
        self.assertIs(signal.getsignal(signal.SIGINT), handler)

    def test_other_threads_run_meanwhile(self):
        """A thread of Python counts while a map is computed: the interpreter's lock is released."""
        counted, stop = [0], threading.Event()

        def count():
            while not stop.is_set():
                counted[0] += 1
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        sphere_map.compute(mesh.make("creature", 20000))
        stop.set()
        thread.join()
        self.assertGreater(counted[0], 10)

    def test_the_course_of_the_dissertations_method(self):
        told = []
        sphere_map.compute(mesh.make("sphere", 200), method="dissertation", trace=lambda *what: told.append(what))
        self.assertGreater(len(told), 2)
        self.assertTrue(all(energy > 0 for _, _, energy in told))

    def test_where_directions_lie_and_what_is_there(self):
        locator = sphere_map.Locator(self.shape, self.map.directions)
        sampled = locator.sample(self.map.directions, self.shape.positions)
        np.testing.assert_allclose(sampled, self.shape.positions, atol=1e-12)  # of weights that are 1 but for rounding
        triangles, weights = locator.locate([[0, 0, 1], [1, 2, 3]])
        self.assertTrue(np.all(weights >= 0))
        np.testing.assert_allclose(weights.sum(axis=1), 1, atol=1e-15)
        regular = locator.remesh(self.shape.positions, "icosphere", 4)
        self.assertEqual(len(regular), 10 * 4**4 + 2)
        self.assertLess(mesh.surface_distance(self.shape, regular).first_mean, 0.05)
        pixels = locator.image(self.shape.positions, "octahedron", 32)
        self.assertEqual(pixels.shape, (33, 33, 3))
        surface, gap = sphere_map.image_surface(pixels, "octahedron", 32)
        self.assertLess(gap, 1e-12)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "image.png")
            sphere_map.write_image(path, pixels, "octahedron", 32)
            again, layout, resolution = sphere_map.read_image(path)
        self.assertEqual((layout, resolution), ("octahedron", 32))
        np.testing.assert_allclose(again, pixels, atol=1e-4)  # 16 bits of a box of about 2

    def test_two_maps_together(self):
        turned = quaternion.rotate(quaternion.normalize([1, 0.2, 0.1, 0]), self.map.directions)
        matrix = sphere_map.best_rotation(self.map.directions, turned)
        np.testing.assert_allclose(self.map.directions @ matrix.T, turned, atol=1e-14)
        warp = sphere_map.Warp([[0, 0, 1.0], [1, 0, 0]], [[0, 0.2, 1.0], [1, 0, 0]])
        there = warp.apply([[0, 0, 1.0]])[0]
        np.testing.assert_allclose(there, np.array([0, 0.2, 1]) / math.hypot(0.2, 1), atol=1e-6)
        np.testing.assert_allclose(warp.apply([there], backward=True)[0], [0, 0, 1], atol=1e-6)
        both, where = sphere_map.overlay(self.shape, self.map.directions, self.shape, turned)
        np.testing.assert_allclose(both.positions[where], turned, atol=1e-12)

    def test_floats_keep_every_triangle(self):
        rounded = sphere_map.round_to_float(self.shape, self.map.directions)
        self.assertEqual(rounded.dtype, np.float32)
        self.assertEqual(sphere_map.measure(self.shape, rounded.astype(float)).flipped, 0)
        quasi_conformal, _ = sphere_map.face_distortion(self.shape, self.map.directions)
        self.assertAlmostEqual(quasi_conformal.max(), self.map.report.max_quasi_conformal, places=12)

    def test_harmonics_of_the_shape(self):
        areas = mesh.vertex_areas(self.shape)
        a, report = harmonics.fit(self.map.directions, self.shape.positions, areas, degree=6)
        moved, refinement = harmonics.refine_map(self.shape, self.map.directions, areas, rounds=3, degree=6)
        self.assertAlmostEqual(refinement.residual_before, report.residual, delta=1e-9 * report.residual)
        self.assertLess(refinement.residual, report.residual)
        self.assertTrue(sphere_map.measure(self.shape, moved).bijective)
        with self.assertRaises(ValueError):
            harmonics.refine_map(self.shape, moved[1:], degree=6)
        self.assertEqual((a.shape, report.rank), ((49, 3), 49))
        values = harmonics.evaluate(self.map.directions, 6) @ a
        np.testing.assert_allclose(harmonics.synthesize(a, self.map.directions), values, atol=1e-12)
        turn = quaternion.to_matrix(quaternion.normalize([1, 2, 3, 4]))
        turned = harmonics.rotate(a, turn)
        np.testing.assert_allclose(harmonics.degree_norms(turned), harmonics.degree_norms(a), rtol=1e-12)
        self.assertLess(harmonics.shape_distance(a, turned), 1e-20)
        found = harmonics.align(turned, a)
        np.testing.assert_allclose(np.reshape(found.rotation, (3, 3)), turn, atol=1e-7)
        self.assertEqual(harmonics.gradients(a, [[0, 0, 1]]).shape, (1, 3, 3))
        degree = harmonics.degree_of(a)
        sums = harmonics.analyze(self.map.directions, values, degree)
        np.testing.assert_allclose(np.sum(sums * a), np.sum(values * harmonics.synthesize(a, self.map.directions)), rtol=1e-12)
        low = harmonics.filter(a, 0, 2)
        self.assertTrue(np.all(low[9:] == 0) and np.all(low[:9] == a[:9]))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "shape.coef")
            harmonics.write(path, a)
            np.testing.assert_allclose(harmonics.read(path), a, rtol=1e-14, atol=1e-16)

    def test_glb_with_the_sphere_as_a_morph_target(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "shape.glb")
            gltf.write(path, self.shape, morph_targets={"sphere": self.map.directions}, name="creature", scale=2.0,
                       extras={"made": "by a test"}, base_color=[1, 0, 0, 1])
            surface = gltf.read(path, morph_target="sphere", weld_identical=False)
            np.testing.assert_allclose(np.linalg.norm(surface.positions, axis=1), 2, atol=1e-6)  # float32
            with open(path, "rb") as file:
                self.assertEqual(len(gltf.read_memory(file.read()).triangles), len(self.shape.triangles))


if __name__ == "__main__":
    unittest.main()
