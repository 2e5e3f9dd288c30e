"""Rotations, frames, polycubes and solids from Python: what comes out is what the libraries promise."""

import os
import tempfile
import unittest

import numpy as np
import orbicube
from orbicube import frame_field, hexmesh, mesh, polycube, quaternion, untangle, volume_map
from solids import HAS_TETRAHEDRA, box_of_tetrahedra
from solvers_test import from_c


class Solids(unittest.TestCase):
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
        atlas = better.atlas(size=64, padding=2)
        self.assertRegex(repr(atlas), r"64 x 64 texels, \d+ triangles")
        triangles, weights, covered = atlas.sample()
        rows, columns = np.nonzero(covered)
        middles = np.einsum("ij,ijk->ik", weights[covered], atlas.coordinates[triangles[covered]])
        np.testing.assert_allclose(64 * middles, np.column_stack([columns, rows]) + 0.5, atol=1e-9)
        # A linear function of the vertices is the same function of the points that texels show.
        image = atlas.texture(better.positions)
        np.testing.assert_allclose(image[covered], np.einsum("ij,ijk->ik", weights[covered],
                                                             better.positions[better.triangles[triangles[covered]]]), atol=1e-12)
        self.assertEqual(atlas.texture(better.positions[:, 0]).tobytes(), image[..., 0].tobytes())
        with self.assertRaises(orbicube.InvalidArgument):
            better.atlas(size=0)
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

    def test_elements_without_room_are_split(self):
        # Around an edge that passes outside of the triangle in the middle, and on both sides of a diagonal outside of a dart.
        places = np.array([[0, 0, -1], [3, 0, 1], [1, 0, 0], [-0.5, 0.75, 0], [-0.5, -0.75, 0]])
        solid = untangle.refine_tetrahedra((places, [[0, 1, 2, 3], [0, 1, 3, 4], [0, 1, 4, 2]]))
        self.assertEqual((solid.report.inverted_before, solid.report.inverted), (2, 0))
        self.assertEqual(sorted(solid.parents.tolist()), [0, 0, 1, 1, 2, 2])
        np.testing.assert_array_equal(solid.positions[:5], places)
        mesh.check_cells(mesh.Mesh(solid.positions, tetrahedra=solid.elements))
        self.assertEqual(solid.origins[5].tolist(), [0, 1, 2**32 - 1, 2**32 - 1])
        np.testing.assert_array_equal(solid.weights[5], [0.5, 0.5, 0, 0])
        dart = np.array([[0.0, 0], [2, 1], [0, 4], [1, 1]])
        flat = untangle.refine_triangles(dart, [[0, 1, 2], [0, 2, 3]], rest=[[0.0, 0], [1, 0], [1, 1], [0, 1]])
        self.assertEqual(flat.elements.shape, (4, 3))
        for a, b, c in flat.positions[flat.elements]:
            self.assertEqual(mesh.orientation_2d(a, b, c), 1)
        crossed = np.array([[0.0, 0], [1, 1], [1, 0], [0, 1]])
        with self.assertRaises(orbicube.NoValidResult):
            untangle.refine_triangles(crossed, [[0, 1, 2], [0, 2, 3]])

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

    def test_regions_of_hexahedra(self):
        places = np.array([[i, j, k] for i in range(3) for j in range(2) for k in range(2)], dtype=float)
        cells, regions = [], []
        for i in range(2):
            for order in ((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (1, 0, 2), (2, 1, 0)):
                corners = [np.array([i, 0, 0])]
                for axis in order:
                    corners.append(corners[-1] + np.eye(3, dtype=int)[axis])
                cell = [int(4 * c[0] + 2 * c[1] + c[2]) for c in corners]
                cells.append(cell if np.linalg.det(places[cell[1:]] - places[cell[0]]) > 0 else [cell[0], cell[2], cell[1], cell[3]])
                regions.append(7 if i == 0 else -4)
        made = hexmesh.fill_with_hexahedra((places, np.array(cells)), method="polycube", cells=100, regions=regions)
        self.assertEqual(made.report.conforming, 1)
        self.assertEqual(set(made.regions.tolist()), {7, -4})
        x = made.positions[made.hexahedra][:, :, 0]
        self.assertLess(x[made.regions == 7].max(), 1 + 1e-12)
        self.assertGreater(x[made.regions == -4].min(), 1 - 1e-12)
        plain = hexmesh.fill_with_hexahedra((places, np.array(cells)), method="polycube", cells=100)
        self.assertFalse(plain.regions.any())
        for wrong in (regions[1:], [0.5] * 12, [2**40] * 12):
            with self.assertRaisesRegex(ValueError, "regions: "):
                hexmesh.fill_with_hexahedra((places, np.array(cells)), regions=wrong)

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
