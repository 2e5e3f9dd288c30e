"""Surfaces repaired from Python: damage of several kinds, options, places, and refusals."""

import unittest

import numpy as np
import orbicube
from orbicube import mesh, repair


def sphere(triangles=500):
    made = mesh.make("sphere", triangles)
    return np.array(made.positions), np.array(made.triangles)


class Repair(unittest.TestCase):
    def test_clean_surface_is_as_it_was(self):
        positions, triangles = sphere()
        repaired = repair.repair((positions, triangles))
        self.assertEqual(repaired.report.changed, 0)
        np.testing.assert_array_equal(repaired.positions, positions)
        np.testing.assert_array_equal(repaired.triangles, triangles)
        self.assertEqual(repaired.events, [])
        self.assertEqual(list(repaired.vertex_source), list(range(len(positions))))

    def test_hole_and_speck(self):
        positions, triangles = sphere()
        speck = np.array([[9, 9, 9], [9.1, 9, 9], [9, 9.1, 9]])
        n = len(positions)
        damaged = np.vstack([positions, speck]), np.vstack([triangles[1:], [[n, n + 1, n + 2]]])
        repaired = repair.repair(damaged)
        report = repaired.report
        self.assertTrue(report.closed and report.manifold and report.oriented)
        self.assertEqual((report.filled_holes, report.dropped_triangles, report.genus, report.self_intersections), (1, 1, 0, 0))
        self.assertEqual([event[0] for event in repaired.events], ["dropped-part", "filled-hole"])
        np.testing.assert_array_equal(repaired.positions, positions)
        open_one = repair.repair(damaged, fill_holes=False, keep_parts=0)
        self.assertEqual((open_one.report.closed, open_one.report.parts, open_one.report.boundary_loops), (0, 2, 2))

    def test_handles_and_wrap(self):
        torus = mesh.make("torus", 600)
        self.assertEqual(repair.repair(torus).report.genus, 1)
        self.assertEqual(repair.repair(torus, max_genus=0).report.genus, 0)
        wrapped = repair.repair(torus, wrap_offset=0.1)
        self.assertTrue(wrapped.report.closed)
        self.assertEqual(wrapped.report.self_intersections, 0)

    def test_mistakes(self):
        positions, triangles = sphere()
        with self.assertRaises(orbicube.InvalidArgument):
            repair.repair((positions, triangles), weld_distance=-1.0)
        with self.assertRaises(TypeError):
            repair.repair((positions, triangles), weld="yes")
        with self.assertRaises(TypeError):
            repair.repair((positions, triangles), holes=False)
        with self.assertRaises(orbicube.Cancelled):
            repair.repair((positions, triangles), progress=lambda *_: True)

    def test_surface_of_label(self):
        x, y, z = np.meshgrid(*[np.arange(n) for n in (14, 12, 10)], indexing="ij")
        labels = np.where((x - 6)**2 + (y - 5)**2 + (z - 4)**2 < 11, 4, 0)
        labels[6, 5, :] = 0  # a tunnel
        affine = np.array([[0, -0.5, 0, 3], [0.5, 0, 0, -2], [0, 0, 2, 1], [0, 0, 0, 1.0]])
        made = repair.surface_of_label(labels, affine)
        self.assertEqual((made.report.closed, made.report.genus, made.report.self_intersections), (1, 0, 0))
        self.assertEqual((made.label_report.label, made.label_report.handles, made.label_report.voxels), (4, 1, (labels == 4).sum()))
        np.testing.assert_allclose(made.positions.mean(axis=0), (affine @ [6, 5, 4, 1])[:3], atol=0.2)
        kept = repair.surface_of_label(np.asfortranarray(labels.astype(np.uint8)), label=4, handles=True)
        self.assertEqual(kept.report.genus, 1)
        for bad in (labels * 1.5, labels[0], np.full((2, 2, 2), 2**40)):
            with self.assertRaises((TypeError, ValueError)):
                repair.surface_of_label(bad)
        with self.assertRaises(orbicube.InvalidArgument):
            repair.surface_of_label(labels, label=5)
        with self.assertRaises(ValueError):
            repair.surface_of_label(labels, affine[:3])


if __name__ == "__main__":
    unittest.main()
