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


if __name__ == "__main__":
    unittest.main()
