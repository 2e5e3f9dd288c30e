"""Meshes of trimesh and of meshio themselves are taken as surfaces and solids, and those two read what is written here."""

import importlib.util
import os
import sys
import tempfile
import unittest

import numpy as np

import orbicube
from orbicube import mesh, polycube, sphere_map

HAS_MESHIO, HAS_TRIMESH = (importlib.util.find_spec(name) is not None for name in ("meshio", "trimesh"))


def kuhn_cube():
    """The unit cube in six tetrahedra around a diagonal."""
    corners = np.array([[(i >> k) & 1 for k in range(3)] for i in range(8)], dtype=float)
    return corners, np.array([[0, 1, 3, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 6, 4, 7], [0, 4, 5, 7], [0, 5, 1, 7]])


@unittest.skipUnless(HAS_MESHIO, "there is no meshio (Debian: python3-meshio)")
class Meshio(unittest.TestCase):
    def test_surface_in_several_blocks(self):
        import meshio

        shape = mesh.make("torus", 800)
        triangles = shape.triangles.astype(np.int64)
        other = meshio.Mesh(np.array(shape.positions), [("line", [[0, 1]]), ("triangle", triangles[:300]),
                                                        ("triangle", triangles[300:])])
        self.assertEqual(mesh.topology(other).as_dict(), mesh.topology(shape).as_dict())
        self.assertEqual(mesh.topology(other).genus, 1)

    def test_solid(self):
        import meshio

        corners, tetrahedra = kuhn_cube()
        report = mesh.tetrahedron_quality(meshio.Mesh(corners, [("tetra", tetrahedra)]))
        self.assertEqual(report.positive, 6)
        self.assertAlmostEqual(report.volume, 1, places=14)

    def test_it_reads_what_is_written(self):
        import meshio

        corners, tetrahedra = kuhn_cube()
        shape = mesh.make("sphere", 500)
        with tempfile.TemporaryDirectory() as folder:
            for name in ("surface.off", "surface.stl", "surface.ply", "surface.obj", "surface.mesh"):
                path = os.path.join(folder, name)
                mesh.write(path, shape)
                read = meshio.read(path)
                # STL repeats the corners and has single precision.
                np.testing.assert_allclose(read.points[read.get_cells_type("triangle")], shape.positions[shape.triangles], atol=1e-6 if "stl" in name else 1e-15,
                                           err_msg=name)
            for name in ("solid.vtk", "solid.mesh"):
                path = os.path.join(folder, name)
                mesh.write(path, mesh.Mesh(corners, tetrahedra=tetrahedra))
                read = meshio.read(path)
                np.testing.assert_array_equal(read.points[read.get_cells_type("tetra")], corners[tetrahedra], err_msg=name)


@unittest.skipUnless(HAS_TRIMESH, "there is no trimesh (pip install trimesh)")
class Trimesh(unittest.TestCase):
    def test_sphere_map_of_a_shape_of_trimesh(self):
        import trimesh

        shape = trimesh.creation.icosphere(subdivisions=3)
        shape.apply_scale((1, 2, 3))
        self.assertTrue(shape.is_watertight)
        result = sphere_map.compute(shape)
        self.assertTrue(result.report.bijective)
        image = trimesh.Trimesh(result.directions, shape.faces, process=False)
        self.assertTrue(image.is_watertight and image.is_winding_consistent)
        # A polyhedron with its corners on the sphere, turned outwards, with the sphere's volume but for what chords cut off.
        self.assertTrue(0.97 < image.volume / (4 * np.pi / 3) < 1)

    def test_polycube_of_a_box(self):
        import trimesh

        box = trimesh.creation.box((3, 2, 1)).subdivide().subdivide().subdivide()
        result = polycube.compute(box)
        image = trimesh.Trimesh(result.polycube, result.triangles, process=False)
        self.assertTrue(image.is_watertight)
        self.assertEqual(result.corner_count, 8)
        # On a face of a box a coordinate is constant: each triangle's normal is along an axis.
        np.testing.assert_allclose(np.abs(image.face_normals).max(axis=1), 1, atol=1e-9)

    def test_it_reads_what_is_written(self):
        import trimesh

        shape = mesh.make("sphere", 500)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "surface.glb")
            orbicube.gltf.write(path, shape)
            read = trimesh.load(path, force="mesh", process=False)
            np.testing.assert_allclose(read.vertices[read.faces], shape.positions[shape.triangles], atol=1e-6)


if __name__ == "__main__":
    if not (HAS_MESHIO or HAS_TRIMESH):
        print("there is neither trimesh nor meshio")
        sys.exit(77)  # what Meson takes for "skipped"
    unittest.main()
