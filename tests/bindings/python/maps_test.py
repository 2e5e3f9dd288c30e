"""Meshes, maps, harmonics, frames, polycubes and glTF from Python: what comes out is what the libraries promise."""

import gc
import importlib.util
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
from orbicube import frame_field, gltf, harmonics, hexmesh, mesh, polycube, quaternion, sphere_map, untangle, volume_map
from solvers_test import from_c

HAS_TETRAHEDRA = importlib.util.find_spec("orbicube.tetrahedra") is not None
try:
    orbicube.tetrahedra.version()
except ImportError:
    HAS_TETRAHEDRA = False


def box_of_tetrahedra(n):
    """A cube of n^3 cells, six tetrahedra each around its diagonal."""
    axis = np.arange(n + 1)
    positions = np.array(np.meshgrid(axis, axis, axis, indexing="ij")).reshape(3, -1).T / n
    cells = []
    for i in np.ndindex(n, n, n):
        for order in ((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2)):
            corner, path = list(i), [tuple(i)]
            for k in order:
                corner[k] += 1
                path.append(tuple(corner))
            four = [(a * (n + 1) + b) * (n + 1) + c for a, b, c in path]
            cells.append(four if order in ((0, 1, 2), (1, 2, 0), (2, 0, 1)) else [four[0], four[1], four[3], four[2]])
    return positions, np.array(cells, dtype=np.uint32)


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
        self.assertEqual(known["medit"], ("medit", ".mesh", True, True, False))
        self.assertEqual([one.ending for one in mesh.formats() if not one.polygons], [".stl", ".white", ".gii"])

    def test_defects_are_named(self):
        shape = mesh.make("sphere", 500)
        with self.assertRaises(orbicube.UnsuitableSurface) as caught:
            mesh.check_closed_genus_zero((shape.positions, shape.triangles[:-1]))
        self.assertEqual(caught.exception.status, orbicube.raw.base.OBC_NOT_CLOSED)
        broken = shape.triangles.copy()
        broken[7] = broken[7][::-1]
        turned, report = mesh.orient((shape.positions, broken))
        self.assertEqual(report.triangles_turned, 1)
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
            from orbicube import mesh
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
        sent = []

        def send():
            sent.append(time.process_time())
            os.kill(os.getpid(), signal.SIGINT)

        timer = threading.Timer(0.3, send)
        timer.start()
        handler = signal.getsignal(signal.SIGINT)
        with self.assertRaises(KeyboardInterrupt):
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
        sphere_map.compute(mesh.make("creature", 3000))
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


class Cubes(unittest.TestCase):
    def test_quaternions_in_rows(self):
        q = quaternion.normalize(np.random.default_rng(1).normal(size=(100, 4)))
        np.testing.assert_allclose(quaternion.multiply(q, quaternion.inverse(q)), np.tile([1, 0, 0, 0], (100, 1)), atol=1e-15)
        np.testing.assert_allclose(quaternion.exponential(quaternion.logarithm(q)), q, atol=1e-15)
        v = np.array([1.0, 2, 3])
        np.testing.assert_allclose(quaternion.rotate(q, v), quaternion.to_matrix(q) @ v, atol=1e-14)
        axis, angle = quaternion.to_axis_angle(q)
        np.testing.assert_allclose(np.abs(np.sum(quaternion.from_axis_angle(axis, angle) * q, axis=1)), 1, atol=1e-14)
        np.testing.assert_allclose(quaternion.to_rotation_vector(quaternion.from_rotation_vector(0.3 * axis)), 0.3 * axis,
                                   atol=1e-15)
        np.testing.assert_allclose(quaternion.nearest_to_matrix(1.1 * quaternion.to_matrix(q)),
                                   quaternion.from_matrix(quaternion.to_matrix(q)), atol=1e-14)
        for g in range(24):
            element = quaternion.cube_element(g)
            self.assertEqual(quaternion.cube_nearest(element), g)
            self.assertLess(quaternion.symmetric_distance(q[0], quaternion.multiply(q[0], element)), 1e-14)
            self.assertEqual(quaternion.cube_product(g, quaternion.cube_inverse(g)), 0)
            np.testing.assert_array_equal(quaternion.cube_matrix(g), np.rint(quaternion.to_matrix(element)))
        mean, agreement = quaternion.average(q[:1].repeat(3, axis=0))
        self.assertAlmostEqual(agreement, 1, places=14)
        with self.assertRaises(ValueError):
            quaternion.cube_product(24, 0)
        with self.assertRaises(orbicube.InvalidArgument):
            quaternion.from_matrix(2 * np.eye(3))

    def test_frames_of_a_box_are_its_axes(self):
        solid = box_of_tetrahedra(3)
        frames, report = frame_field.compute(solid)
        self.assertLess(report.energy, 1e-20)
        np.testing.assert_allclose(quaternion.symmetric_distance(frames, [1, 0, 0, 0]), 0, atol=1e-7)
        self.assertEqual(frame_field.measure(solid, frames).inner_faces, report.inner_faces)
        self.assertEqual(frame_field.matchings(solid, frames).shape, (len(solid[1]), 4))
        singular = frame_field.Singularities(solid, frames)
        self.assertEqual((len(singular.edges), len(singular.curves), len(singular.unmeshable_edges)), (0, 0, 0))
        held = quaternion.from_axis_angle([0, 0, 1], 0.3)
        frames, _ = frame_field.compute(solid, held_frames=([40], [held]), align_boundary=0)
        self.assertLess(quaternion.symmetric_distance(frames[40], held), 1e-12)

    def test_a_polycube_and_what_is_on_it(self):
        shape = mesh.make("bracket", 1500)
        cube = polycube.compute(shape, construction="voxels")
        self.assertEqual(cube.construction, "voxels")
        self.assertEqual(mesh.topology((cube.polycube, cube.triangles)).genus, mesh.topology(shape).genus)
        np.testing.assert_array_equal(cube.positions[:len(shape)], shape.positions)
        labels, patches, sources = cube.of_triangles()
        self.assertEqual(patches.max() + 1, cube.patch_count)
        self.assertLess(sources.max(), len(shape.triangles))
        corners, weights = cube.sources()
        np.testing.assert_allclose(weights.sum(axis=1), 1, atol=1e-14)
        better = cube.optimize_domain()
        self.assertLessEqual(better.report.energy, better.report.energy_before)
        self.assertTrue(np.all(np.diff(better.energies) <= 0))
        graph = better.graph()
        self.assertEqual(len(graph.corner_positions), better.corner_count)
        self.assertEqual(sorted(graph.darts), list(range(2 * len(graph.edge_corners))))
        quads = better.quads(quads=500)
        np.testing.assert_allclose(
            np.einsum("ij,ijk->ik", quads.weights, better.positions[better.triangles[quads.triangles]]), quads.positions,
            atol=1e-12)
        # A vertex in the middle of a triangle beside it, and curved edges of the surface on edges of the polycube.
        triangle = next(t for t in better.triangles if t[0] < len(shape))
        place = better.polycube[triangle].mean(axis=0)
        met = better.align_features([triangle[0]], [place], feature_angle=60)
        np.testing.assert_allclose(met.polycube[triangle[0]], place, atol=1e-12)
        self.assertGreater(met.report.sharp, 0.5 * met.report.sharp_length)
        with self.assertRaises(orbicube.InvalidArgument):
            better.align_features([0], [place + 100])
        again = polycube.certify((cube.positions, cube.triangles), cube.polycube)
        self.assertEqual(again.corner_count, cube.corner_count)
        with self.assertRaises(orbicube.NoValidResult):
            polycube.certify((cube.positions, cube.triangles), cube.positions)

    def test_inverted_tetrahedra_are_turned_right(self):
        positions, tetrahedra = box_of_tetrahedra(3)
        inside = np.all((positions > 0) & (positions < 1), axis=1)
        tangled = positions.copy()
        tangled[inside] = tangled[inside][::-1]
        result, report = untangle.tetrahedra((tangled, tetrahedra), rest=positions, fixed=~inside)
        self.assertGreater(report.inverted_before, 0)
        self.assertEqual(report.inverted, 0)
        np.testing.assert_array_equal(result[~inside], positions[~inside])
        mesh.check_cells(mesh.Mesh(result, tetrahedra=tetrahedra))

    def test_flipped_triangles_are_turned_right(self):
        x, y = np.meshgrid(np.arange(6.0), np.arange(6.0))
        flat = np.column_stack([x.ravel(), y.ravel()])
        corner = np.array([6 * j + i for j in range(5) for i in range(5)])[:, None]
        triangles = np.vstack([corner + [0, 1, 7], corner + [0, 7, 6]])
        inside = np.all((flat > 0) & (flat < 5), axis=1)
        tangled = flat.copy()
        tangled[inside] = tangled[inside][::-1]
        result, report = untangle.triangles(tangled, triangles, rest=flat, max_polish_steps=50)
        self.assertGreater(report.inverted_before, 0)
        self.assertEqual(report.inverted, 0)
        np.testing.assert_array_equal(result[~inside], flat[~inside])
        np.testing.assert_allclose(result, flat, atol=0.01)
        for a, b, c in result[triangles]:
            self.assertEqual(mesh.orientation_2d(a, b, c), 1)
        same, _ = untangle.triangles(tangled, triangles, rest=np.column_stack([flat, np.zeros(36)]),
                                     fixed=np.column_stack([~inside, ~inside]), max_polish_steps=50)
        np.testing.assert_array_equal(result, same)
        with self.assertRaises(orbicube.NoValidResult) as caught:
            untangle.triangles(tangled, triangles, fixed=np.ones(36, bool))
        np.testing.assert_array_equal(caught.exception.best[0], tangled)

    def check_hexes(self, hexes, volume, within=1e-9):
        """Corners by our own arithmetic, and a boundary in whole faces, of one piece, turned outward."""
        corners = hexes.positions[hexes.hexahedra]
        # Of each corner those that its edges lead to, so that a cube's are right-handed.
        ends = [(1, 3, 4), (2, 0, 5), (3, 1, 6), (0, 2, 7), (7, 5, 0), (4, 6, 1), (5, 7, 2), (6, 4, 3)]
        edges = np.stack([corners[:, list(three)] - corners[:, [k]] for k, three in enumerate(ends)], axis=1)
        jacobians = np.linalg.det(edges) / np.prod(np.linalg.norm(edges, axis=3), axis=2)
        self.assertGreater(jacobians.min(), 0)
        self.assertAlmostEqual(jacobians.min(), hexes.report.min_scaled_jacobian, places=12)
        self.assertAlmostEqual(jacobians.min(axis=1).mean(), hexes.report.mean_scaled_jacobian, places=12)
        self.assertAlmostEqual(hexes.report.volume, volume, delta=within)
        whole = mesh.Mesh(hexes.positions, hexahedra=hexes.hexahedra)
        mesh.check_cells(whole)
        boundary = mesh.topology(whole.boundary())
        self.assertEqual((boundary.components, boundary.closed, boundary.genus), (1, 1, 0))
        self.assertEqual(len(hexes.quad_patches), len(hexes.quads))
        split = np.concatenate([hexes.quads[:, [0, 1, 2]], hexes.quads[:, [0, 2, 3]]])
        self.assertAlmostEqual(mesh.topology((hexes.positions, split)).volume, volume, delta=within)

    def test_a_surface_is_filled_with_hexahedra(self):
        shape = mesh.make("cube", 300)
        volume = mesh.topology(shape).volume
        hexes = hexmesh.fill_with_hexahedra(shape, cells=27, padding="without")
        self.assertEqual((len(hexes.hexahedra), len(hexes.positions), len(hexes.quads)), (27, 64, 54))
        self.assertEqual(len(np.unique(hexes.quad_patches)), 6)
        self.check_hexes(hexes, volume)
        smooth = hexmesh.fill_with_hexahedra(shape, cells=27, padding="without", feature_angle=0)
        self.assertEqual((hexes.report.follows_sharp_edges, smooth.report.follows_sharp_edges), (1, 0))
        padded = hexmesh.fill_with_hexahedra(shape, cells=27, padding="with")
        self.assertEqual(padded.report.padded, 1)
        self.check_hexes(padded, volume, 0.01 * volume)  # what `max_hausdorff_percent` requires
        grid = hexmesh.fill_with_hexahedra(mesh.make("sphere", 800), method="grid", cells=500)
        self.assertEqual((grid.report.grid_based, hexes.report.grid_based), (1, 0))
        self.assertEqual(grid.report.polycube_corners, 0)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "cube.vtk")
            mesh.write(path, hexes)
            np.testing.assert_array_equal(mesh.read(path).hexahedra, hexes.hexahedra)
        with self.assertRaises(orbicube.Cancelled):
            hexmesh.fill_with_hexahedra(shape, cells=27, progress=lambda *_: True)
        with self.assertRaises(ValueError):
            hexmesh.fill_with_hexahedra(shape, padding="thick")
        with self.assertRaises(ValueError):
            hexmesh.fill_with_hexahedra(shape, method="with")
        with self.assertRaises(orbicube.UnsuitableSurface):
            hexmesh.fill_with_hexahedra((shape.positions, shape.triangles[1:]))

    def test_features_of_hexahedra(self):
        corners = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=float)
        triangles = np.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])
        options = {"cells": 200, "max_hausdorff_percent": 0}
        kept = hexmesh.fill_with_hexahedra((corners, triangles), features="angles", method="grid", **options)
        self.assertEqual((kept.report.feature_curves, kept.report.feature_corners, kept.report.embedded), (12, 6, 1))
        self.assertEqual(kept.missing, [])
        self.assertAlmostEqual(kept.report.captured, 1)
        self.assertEqual(len(np.unique(kept.quad_patches)), 8)
        edges = np.unique(np.sort(np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)]), axis=1), axis=0)
        tagged = hexmesh.fill_with_hexahedra((corners, triangles), features="tags", tagged_edges=edges, method="grid", **options)
        self.assertEqual(tagged.report.missing_features, 0)
        lost = hexmesh.fill_with_hexahedra((corners, triangles), features="angles", method="polycube", **options)
        self.assertEqual(len(lost.missing), lost.report.missing_features)
        self.assertLess(lost.report.captured, .9)
        for missing in lost.missing:
            self.assertIn(missing.kind, ("corner", "curve"))
            self.assertTrue(missing.why)
            self.assertLess(missing.captured, .95)
            self.assertAlmostEqual(float(np.abs(missing.first).sum()), 1)
        with self.assertRaisesRegex(ValueError, r"tagged_edges\[0, 1\] is 6"):
            hexmesh.fill_with_hexahedra((corners, triangles), features="tags", tagged_edges=[[0, 6]])

    def test_hexahedra_along_frames(self):
        count, bits = from_c()["cube"]
        corners = np.array([(i & 1, i >> 1 & 1, i >> 2) for i in range(8)], dtype=float)
        ring = [1, 3, 2, 6, 4, 5]
        tetrahedra = [[0, a, b, 7] for a, b in zip(ring, ring[1:] + ring[:1])]
        hexes = hexmesh.fill_with_hexahedra((corners, tetrahedra), method="frames", cells=8)
        self.assertEqual(len(hexes.hexahedra), count)
        self.assertEqual(hexes.positions.tobytes(), bits.tobytes())
        self.check_hexes(hexes, 1)

        solid = box_of_tetrahedra(3)
        frames, _ = frame_field.compute(solid)
        hexes = hexmesh.fill_with_hexahedra(solid, frames, cells=27)
        self.assertEqual((len(hexes.hexahedra), len(hexes.positions), len(hexes.quads)), (27, 64, 54))
        self.assertEqual((hexes.report.singular_edges, hexes.report.irregular_edges), (0, 0))
        self.assertEqual(hexes.report.integers_optimal, 1)
        self.check_hexes(hexes, 1)
        with self.assertRaises(ValueError):
            hexmesh.fill_with_hexahedra(solid, frames[1:])
        with self.assertRaises(orbicube.InvalidArgument):
            hexmesh.fill_with_hexahedra(solid, cells=0)

    def test_a_solid_goes_to_its_polycube(self):
        positions, tetrahedra = box_of_tetrahedra(2)
        solid = volume_map.map_to_polycube((positions, tetrahedra))
        self.assertGreaterEqual(len(solid.tetrahedra), len(tetrahedra))
        for places in (solid.positions, solid.polycube):
            mesh.check_cells(mesh.Mesh(places, tetrahedra=solid.tetrahedra))
        self.assertAlmostEqual(mesh.tetrahedron_quality(solid).volume, 1, places=12)
        boundary = mesh.Mesh(solid.positions, tetrahedra=solid.tetrahedra).boundary()
        polycube.certify(boundary, solid.polycube)
        with self.assertRaises(orbicube.UnsuitableSurface):
            volume_map.map_to_polycube((positions, tetrahedra[:, [1, 0, 2, 3]]))

    def test_a_map_of_a_solid_is_a_function_with_an_inverse(self):
        positions, tetrahedra = box_of_tetrahedra(2)
        solid = volume_map.map_to_polycube((positions, tetrahedra))
        f = volume_map.PiecewiseLinearMap(solid.positions, solid.polycube, solid.tetrahedra)
        points = np.random.default_rng(3).random((200, 3))
        np.testing.assert_allclose(f.inverse(f(points)), points, atol=1e-9)  # the smallest images are 1e-4 of a cell
        np.testing.assert_allclose(f(solid.positions), solid.polycube, atol=1e-9)
        self.assertTrue(np.isnan(f([[0.5, 0.5, 2]])).all())
        locator = volume_map.Locator(solid)
        cells, weights = locator.locate(points)
        made = (weights[:, :, None] * solid.positions[solid.tetrahedra[cells]]).sum(axis=1)
        np.testing.assert_allclose(made, points, atol=1e-12)
        np.testing.assert_allclose(locator.sample(points, solid.positions[:, 0]), points[:, 0], atol=1e-12)
        self.assertEqual(locator.locate(points, threads=1)[1].tobytes(), weights.tobytes())

    def test_a_box_is_parameterized_along_its_axes(self):
        positions, tetrahedra = box_of_tetrahedra(3)
        frames = np.tile([1.0, 0, 0, 0], (len(tetrahedra), 1))
        for given in (frames, None):
            map = volume_map.parameterize((positions, tetrahedra), given, integer=True, cell_length=1 / 3)
            self.assertEqual((map.report.inverted, map.report.patches, len(map.singular_edges)), (0, 6, 0))
            self.assertLess(map.report.energy, 1e-9)
            self.assertLess(map.report.residual, 1e-12)
            # Each chart is that of space up to a rotation of the cube.
            for corners, cell in zip(map.parameters, tetrahedra):
                e, p = corners[1:] - corners[0], 3 * (positions[cell[1:]] - positions[cell[0]])
                turn = np.linalg.solve(p, e)
                np.testing.assert_allclose(np.abs(turn).round(6).sum(axis=0), 1, atol=1e-5)
        with self.assertRaises(ValueError):
            volume_map.parameterize((positions, tetrahedra), frames[1:])
        with self.assertRaises(orbicube.InvalidArgument):
            volume_map.parameterize((positions, tetrahedra), frames, feature_angle=40)

    @unittest.skipUnless(HAS_TETRAHEDRA, "the library tetrahedra is not there")
    def test_a_surface_is_filled(self):
        shape = mesh.make("cube", 300)
        solid = orbicube.tetrahedra.fill(shape, quality=1.6)
        np.testing.assert_array_equal(solid.positions[:len(shape)], shape.positions)
        self.assertAlmostEqual(mesh.tetrahedron_quality(solid).volume, mesh.topology(shape).volume, places=12)
        self.assertEqual((solid.parts, solid.cavities), (1, 0))


if __name__ == "__main__":
    unittest.main()
