"""Meshes of pyvista are taken and given; without pyvista, by a stand-in with the attributes that are looked at. Cells of other kinds
than ours are cut, noted or refused like those of files, whoever holds them."""

import types
import unittest

import numpy as np
import orbicube
from orbicube import hexmesh, mesh, polycube, sphere_map, untangle, volume_map

try:
    import pyvista
except ImportError:
    pyvista = None

CORNERS = np.array([[(i >> k) & 1 for k in range(3)] for i in range(8)], dtype=float)
KUHN = np.array([[0, 1, 3, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 6, 4, 7], [0, 4, 5, 7], [0, 5, 1, 7]])
HEXAHEDRON = np.array([[0, 1, 3, 2, 4, 5, 7, 6]])


def padded(cells):
    return np.concatenate([[len(cell), *cell] for cell in cells]) if len(cells) else np.empty(0, int)


def polygons(points, faces):
    if pyvista is not None:
        return pyvista.PolyData(np.array(points), padded(faces))
    return types.SimpleNamespace(points=np.array(points), faces=padded(faces), strips=np.empty(0, int))


def grid(points, cells, kinds):
    if pyvista is not None:
        return pyvista.UnstructuredGrid(padded(cells), np.array(kinds, np.uint8), np.array(points))
    return types.SimpleNamespace(points=np.array(points), cells=padded(cells), celltypes=np.array(kinds, np.uint8))


class Taken(unittest.TestCase):
    def test_triangles(self):
        shape = mesh.make("torus", 600)
        other = polygons(shape.positions, shape.triangles.astype(int))
        self.assertEqual(mesh.topology(other), mesh.topology(shape))
        ball = mesh.make("sphere", 300)
        self.assertTrue(sphere_map.compute(polygons(ball.positions, ball.triangles.astype(int))).report.bijective)

    def test_quads_and_polygons_are_cut_as_those_of_files(self):
        quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
        report = mesh.topology(polygons(CORNERS, quads))
        self.assertEqual((report.closed, report.genus), (1, 0))
        self.assertAlmostEqual(report.volume, 1, places=14)
        self.assertEqual(polycube.compute(polygons(CORNERS, quads)).corner_count, 8)
        mixed = [[0, 2, 3], [0, 3, 1]] + quads[1:]
        self.assertAlmostEqual(mesh.topology(polygons(CORNERS, mixed)).volume, 1, places=14)

    def test_tetrahedra_and_hexahedra(self):
        self.assertAlmostEqual(mesh.tetrahedron_quality(grid(CORNERS, KUHN, [10] * 6)).volume, 1, places=14)
        self.assertEqual(untangle.tetrahedra(grid(CORNERS, KUHN, [10] * 6), fixed=np.ones(8, bool))[1].inverted_before, 0)
        mesh.check_cells(grid(CORNERS, HEXAHEDRON, [12]))
        lines = grid(CORNERS, [[0, 1]] + KUHN.tolist() + [[5]], [3] + [10] * 6 + [1])
        self.assertEqual(mesh.tetrahedron_quality(lines).positive, 6)

    def test_no_cell_is_left_out_in_silence(self):
        with self.assertRaisesRegex(ValueError, "solid: 1 hexahedra beside 6 tetrahedra"):
            untangle.tetrahedra(grid(np.vstack([CORNERS, CORNERS + [5, 0, 0]]), KUHN.tolist() + (HEXAHEDRON + 8).tolist(), [10] * 6 + [12]))
        with self.assertRaisesRegex(ValueError, "surface: there are no triangles, but 6 tetrahedra.*boundary"):
            mesh.topology(grid(CORNERS, KUHN, [10] * 6))
        with self.assertRaisesRegex(ValueError, "solid: there are no tetrahedra, but 1 hexahedra"):
            untangle.tetrahedra(grid(CORNERS, HEXAHEDRON, [12]))
        with self.assertRaisesRegex(orbicube.Error, r"mesh: among its cells \(1 of type 42, 6 of type tetra\)|mesh: .*type 42"):
            mesh.check_cells(types.SimpleNamespace(points=CORNERS, cells=padded(KUHN.tolist() + [[0, 1, 2, 4]]),
                                                   celltypes=np.array([10] * 6 + [42])))

    def test_prisms_and_pyramids_fill_the_same_solid_or_are_refused_with_their_number(self):
        prisms = grid(CORNERS, [[0, 2, 1, 4, 6, 5], [1, 2, 3, 5, 6, 7]], [13, 13])
        try:
            self.assertAlmostEqual(abs(mesh.tetrahedron_quality(prisms).volume), 1, places=14)
        except orbicube.Error as error:
            self.assertRegex(str(error), "mesh: among its cells .2 of type wedge.")

    def test_cells_of_a_meshio_mesh_likewise(self):
        def held(*blocks):
            return types.SimpleNamespace(points=CORNERS, cells=[types.SimpleNamespace(type=kind, data=np.array(data))
                                                                for kind, data in blocks])

        quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
        self.assertAlmostEqual(mesh.topology(held(("quad", quads))).volume, 1, places=14)
        self.assertEqual(mesh.tetrahedron_quality(held(("tetra", KUHN), ("line", [[0, 1]]))).positive, 6)
        with self.assertRaisesRegex(ValueError, "mesh: cells that are not read: 2 of type tetra10"):
            mesh.check_cells(held(("tetra", KUHN), ("tetra10", np.zeros((2, 10), int))))
        with self.assertRaisesRegex(ValueError, "solid: cells of type tetra are not rows"):
            volume_map.map_to_polycube(held(("tetra", KUHN[:, :3])))
        with self.assertRaisesRegex(ValueError, r"solid: tetrahedra\[0, 3\] is 7"):
            volume_map.map_to_polycube(types.SimpleNamespace(points=CORNERS[:6], cells={"tetra": KUHN}))


@unittest.skipUnless(pyvista, "there is no pyvista (scripts/pyvista build-pyvista)")
class Given(unittest.TestCase):
    def test_a_surface(self):
        shape = mesh.make("torus", 600)
        given = shape.to_pyvista()
        self.assertIsInstance(given, pyvista.PolyData)
        self.assertTrue(given.is_manifold and given.n_open_edges == 0)
        self.assertAlmostEqual(given.volume, mesh.topology(shape).volume, places=5)  # vtkMassProperties has its own sums
        self.assertEqual(mesh.Mesh(given.points, mesh.Surface(given).triangles), shape)

    def test_a_solid_of_either_kind(self):
        for solid in (mesh.Mesh(CORNERS, tetrahedra=KUHN), mesh.Mesh(CORNERS, hexahedra=HEXAHEDRON),
                      hexmesh.fill_with_hexahedra(mesh.make("cube", 100), cells=8)):
            given = mesh.to_pyvista(solid)
            self.assertIsInstance(given, pyvista.UnstructuredGrid)
            self.assertEqual(mesh.handle_of(given), mesh.handle_of(solid))
            self.assertAlmostEqual(abs(given.volume), abs(mesh.topology(mesh.handle_of(solid).boundary()).volume), places=9)

    def test_shapes_of_pyvista(self):
        report = mesh.topology(pyvista.Sphere().clean())
        self.assertEqual((report.closed, report.genus), (1, 0))
        self.assertEqual(polycube.compute(pyvista.Cube().clean()).corner_count, 8)


if __name__ == "__main__":
    unittest.main()
