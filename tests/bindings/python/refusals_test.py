"""What is handed out is released, and what a function cannot take is refused rather than changed in silence."""

import gc
import os
import signal
import tempfile
import unittest
import weakref
from unittest import mock

import numpy as np
import orbicube
from solids import box_of_tetrahedra
from orbicube import gltf, mesh, polycube, projected_gradient, sphere_map, sphere_optimizer, trust_region, untangle, volume_map

TRIANGLE = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]


class Counted:
    """A C function that notes what it is called with."""

    def __init__(self, module, name):
        self.function, self.calls = getattr(module, name), 0
        self.patch = mock.patch.object(module, name, self)

    def __call__(self, *arguments):
        self.calls += 1
        return self.function(*arguments)

    def __enter__(self):
        self.patch.start()
        return self

    def __exit__(self, *_):
        self.patch.stop()


class Released(unittest.TestCase):
    def test_a_mesh_and_its_views_go_with_the_last_reference(self):
        with Counted(orbicube.raw.mesh, "obc_mesh_destroy") as destroy:
            shape = mesh.make("torus", 500)
            gone, view = weakref.ref(shape), shape.positions[::2]
            del shape
            self.assertIsNone(gone())  # without the collector, which does not see cycles through arrays
            self.assertEqual(destroy.calls, 0)
            self.assertGreater(view.max(), 0)
            del view
            self.assertEqual(destroy.calls, 1)

    def test_handles_go_with_their_objects(self):
        shape = mesh.make("sphere", 300)
        directions = sphere_map.compute(shape).directions
        for module, name, make in (
                (orbicube.raw.mesh, "obc_mesh_search_destroy", lambda: mesh.Search(shape)),
                (orbicube.raw.sphere_map, "obc_sphere_map_locator_destroy", lambda: sphere_map.Locator(shape, directions)),
                (orbicube.raw.sphere_map, "obc_sphere_map_warp_destroy", lambda: sphere_map.Warp([[0, 0, 1]], [[0, 1, 1]])),
                (orbicube.raw.polycube, "obc_polycube_destroy", lambda: polycube.compute(mesh.make("cube", 100))),
                (orbicube.raw.volume_map, "obc_volume_map_locator_destroy",
                 lambda: volume_map.Locator((np.vstack([np.zeros(3), np.eye(3)]), [[0, 1, 2, 3]]))),
                (orbicube.raw.trust_region, "obc_trust_region_destroy", lambda: trust_region.Solver([0, 0]))):
            with Counted(module, name) as destroy:
                made = make()
                self.assertEqual(destroy.calls, 0, name)
                del made
                gc.collect()
                self.assertEqual(destroy.calls, 1, name)

    def test_all_maps_of_a_common_polycube_are_released(self):
        cubes = [mesh.make("cube", 100), mesh.make("cube", 200)]
        with Counted(orbicube.raw.polycube, "obc_polycube_destroy") as destroy:
            maps, _ = polycube.compute_common(cubes)
            better = polycube.optimize_common_domain(maps)
            gc.collect()
            before = destroy.calls
            self.assertEqual([len(map.polycube) >= 8 for map in maps + better], [True] * 4)
            del maps, better
            gc.collect()
            self.assertEqual(destroy.calls - before, 4)

    def test_what_was_made_when_ctrl_c_came_is_released(self):
        real = orbicube.raw.mesh.obc_mesh_make

        def interrupted(*arguments):
            status = real(*arguments)
            signal.raise_signal(signal.SIGINT)
            return status

        with Counted(orbicube.raw.mesh, "obc_mesh_destroy") as destroy, \
                mock.patch.object(orbicube.raw.mesh, "obc_mesh_make", interrupted):
            with self.assertRaises(KeyboardInterrupt):
                mesh.make("sphere", 100)
            gc.collect()
            self.assertEqual(destroy.calls, 1)

    def test_the_bar_is_closed_whatever_comes_out_of_a_function(self):
        class Bar:
            closed = False

            def __call__(self, *_):
                return False

            def close(self):
                self.closed = True

        bar = Bar()
        with self.assertRaises(ZeroDivisionError):
            trust_region.minimize(lambda x: 1 / 0, [0], progress=bar)
        self.assertTrue(bar.closed)


class Arrays(unittest.TestCase):
    def test_whatever_holds_the_numbers_they_arrive(self):
        shape = mesh.make("creature", 500)
        expected = mesh.topology(shape).volume
        wide = np.zeros((len(shape.positions), 5))
        wide[:, 1:4] = shape.positions
        raw = np.frombuffer(b"\0" + shape.positions.tobytes(), offset=1).reshape(-1, 3)
        self.assertFalse(raw.flags.aligned)
        records = np.zeros(len(shape.positions), dtype=[("tag", "u1"), ("place", "f8", 3)])
        records["place"] = shape.positions
        for places in (wide[:, 1:4], np.asfortranarray(shape.positions), shape.positions.astype(">f8"), raw,
                       records["place"], shape.positions.tolist(), shape.positions.ravel()):
            for corners in (shape.triangles, shape.triangles.astype(">i8"), np.asfortranarray(shape.triangles),
                            np.repeat(shape.triangles, 2, axis=1)[:, ::2]):
                self.assertEqual(mesh.topology((places, corners)).volume, expected)
        from orbicube._arrays import doubles, indices
        self.assertTrue(doubles(raw).flags.aligned and doubles(records["place"]).flags.aligned)
        odd = np.frombuffer(b"\0" + shape.triangles.tobytes(), dtype=np.uint32, offset=1)
        self.assertTrue(indices(odd).flags.aligned)
        self.assertIs(doubles(shape.positions), shape.positions)  # and what is as C wants it is no copy

    def test_views_cannot_be_written(self):
        empty = mesh.Mesh(TRIANGLE)
        for view in (mesh.make("cube", 50).positions, empty.positions, empty.triangles):
            with self.assertRaises(ValueError):
                view[...] = 0

    def test_indices_that_are_none_are_refused(self):
        for corners in ([[0, 1, -1]], [[0, 1, 2**32]], [[0.0, 1.0, 2.0]], [[True, False, True]]):
            with self.assertRaises((ValueError, TypeError)):
                mesh.Mesh(TRIANGLE, corners)

    def test_colors_that_are_no_bytes_are_refused(self):
        shape = mesh.make("sphere", 100)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.glb")
            for colors in (np.full((len(shape), 4), 0.7), np.full((len(shape), 4), 256), np.full((len(shape), 3), 1)):
                with self.assertRaises(ValueError):
                    gltf.write(path, shape, colors=colors)
            gltf.write(path, shape, colors=np.full((len(shape), 4), 255))


class Answers(unittest.TestCase):
    def test_one_number_is_no_array_of_residuals(self):
        with self.assertRaisesRegex(ValueError, "8"):
            trust_region.least_squares(lambda x: x[0] ** 2, [1.0], 8)
        with self.assertRaises(ValueError):
            trust_region.minimize(lambda x: x, [1.0, 2.0])
        self.assertTrue(trust_region.minimize(lambda x: x[:1] ** 2, [1.0, 2.0]).converged)

    def test_gradients_have_the_shape_of_the_point(self):
        with self.assertRaises(ValueError):
            projected_gradient.minimize(lambda x: ((x ** 2).sum(), 2.0), [1.0, 2.0])
        start = np.eye(3)[:2]
        with self.assertRaises(ValueError):
            sphere_optimizer.minimize(lambda x: (x[:, 0].sum(), np.ones((3, 2))), start)
        flat = sphere_optimizer.minimize(lambda x: (x[:, 2].sum(), np.array([0, 0, 1.0, 0, 0, 1])), start)
        self.assertAlmostEqual(flat.value, -2, places=12)
        with self.assertRaises(ValueError):
            sphere_optimizer.relax(lambda *_: (0.0, 1.0), start, [[], []])
        with self.assertRaises(TypeError):
            projected_gradient.minimize(lambda x: None, [1.0, 2.0])

    def test_a_projection_answers_a_point(self):
        with self.assertRaisesRegex(ValueError, "project"):
            projected_gradient.minimize(lambda x: ((x ** 2).sum(), 2 * x), [1.0, 2.0], project=lambda y: 0.5)

    def test_what_a_trace_raises_stops_the_work_and_comes_out(self):
        told = []

        def trace(*_):
            told.append(1)
            raise ZeroDivisionError

        with self.assertRaises(ZeroDivisionError):
            sphere_map.compute(mesh.make("creature", 2000), method="dissertation", trace=trace)
        self.assertEqual(len(told), 1)

    def test_numbers_that_do_not_fit_are_refused(self):
        cube = mesh.make("cube", 100)
        for options in ({"corners": -1}, {"seed": 2**64}, {"threads": -1}, {"threads": 2**32}):
            with self.assertRaises(ValueError):
                polycube.compute(cube, **options)
        with self.assertRaises(ValueError):
            polycube.compute(cube).optimize_corners(rounds=2**32 + 1)

    def test_paths_and_formats(self):
        with self.assertRaisesRegex(ValueError, "null"):
            mesh.read("a\0.ply")
        with self.assertRaisesRegex(ValueError, "medit"):
            mesh.read_memory(b"", "docx")

    def test_a_mesh_that_stays_tangled_is_handed_out_with_the_error(self):
        positions, tetrahedra = box_of_tetrahedra(1)
        mirrored = positions * [1, 1, -1]  # the boundary is inside out: nothing can be done
        with self.assertRaises(orbicube.NoValidResult) as caught:
            untangle.tetrahedra((mirrored, tetrahedra), fixed=np.ones(8, dtype=bool))
        places, report = caught.exception.best
        np.testing.assert_array_equal(places, mirrored)
        self.assertEqual((report.inverted_before, report.inverted), (6, 6))
        self.assertIsNone(orbicube.NoValidResult(-11, "no-valid-result", "").best)


if __name__ == "__main__":
    unittest.main()
