"""Pages of meshes in notebooks and conversions for other packages: the page holds the mesh, whatever it is made of."""

import base64
import html
import itertools
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import types
import unittest

import numpy as np
from orbicube import mesh, sphere_map

CORNERS = np.array([[(i >> k) & 1 for k in range(3)] for i in range(8)], dtype=float)
KUHN = np.array([[0, 1, 3, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 6, 4, 7], [0, 4, 5, 7], [0, 5, 1, 7]])
HEXAHEDRON = np.array([[0, 1, 3, 2, 4, 5, 7, 6]])


BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
HEXAHEDRON_NEIGHBORS = [[1, 3, 4], [2, 0, 5], [3, 1, 6], [0, 2, 7], [7, 5, 0], [4, 6, 1], [5, 7, 2], [6, 4, 3]]
TETRAHEDRON_NEIGHBORS = [[1, 2, 3], [2, 0, 3], [0, 1, 3], [1, 0, 2]]


def bent_cube(n, tetrahedra=False):
    """n^3 sheared hexahedra, far from the origin, or six tetrahedra for each."""
    at = lambda x, y, z: x + (n + 1) * (y + (n + 1) * z)
    points = np.array([[100 + x + 0.4 * y * y / n, y, z] for z, y, x in itertools.product(range(n + 1), repeat=3)])
    cells = []
    for z, y, x in itertools.product(range(n), repeat=3):
        cell = [at(x + a, y + b, z + c) for a, b, c in CORNERS.astype(int)]
        cells += [[cell[i] for i in piece] for piece in KUHN] if tetrahedra else [[cell[i] for i in HEXAHEDRON[0]]]
    return points, np.array(cells)


def scaled_jacobians(points, cells, neighbors, regular):
    edges = points[cells[:, neighbors]] - points[cells][:, :, None]
    return (regular * np.linalg.det(edges) / np.linalg.norm(edges, axis=3).prod(axis=2)).min(axis=1)


def data_of(shown):
    return json.loads(re.search(r'id="results">(.*?)</script>', shown.text, re.S).group(1))


def numbers(text, width, corners):
    data = np.frombuffer(base64.b64decode(text), np.uint8).reshape(-1, width)
    return sum(data[:, k].astype(np.uint32) << 8 * k for k in range(width)).reshape(-1, corners)


def positions(item):
    return np.array(item["low"]) + item["step"] * numbers(item["positions"], 3, 3)


class Page(unittest.TestCase):
    def test_it_holds_the_mesh(self):
        shape = mesh.make("torus", 900)
        item, = data_of(shape.show("a </script> name"))["items"]
        self.assertEqual(shape.show("a </script> name").text.count("</script>"), 2)
        self.assertTrue(np.array_equal(numbers(item["triangles"], item["width"], 3), shape.triangles))
        self.assertLessEqual(abs(positions(item) - shape.positions).max(), 0.51 * item["step"])

    def test_cells_and_several_shapes(self):
        first, second = data_of(mesh.show(mesh.Mesh(CORNERS, tetrahedra=KUHN), mesh.Mesh(CORNERS, hexahedra=HEXAHEDRON)))["items"]
        self.assertTrue(np.array_equal(numbers(first["tetrahedra"], 1, 4), KUHN))
        self.assertTrue(np.array_equal(numbers(second["hexahedra"], 1, 8), HEXAHEDRON))
        item, = data_of(mesh.show((CORNERS[:3], [[0, 1, 2]]), names=["one"]))["items"]
        self.assertEqual((item["name"], numbers(item["triangles"], 1, 3).tolist()), ("one", [[0, 1, 2]]))

    def test_maps(self):
        ball = mesh.make("creature", 300)
        image = sphere_map.compute(ball).directions
        target, = data_of(mesh.show(ball, maps=[image]))["items"][0]["targets"]
        self.assertLess(abs(np.linalg.norm(positions(target), axis=1) - 1).max(), 1e-6)
        with self.assertRaisesRegex(ValueError, "the map has 2 positions"):
            mesh.show(ball, maps=[image[:2]])

    def test_mistakes(self):
        for call in (lambda: mesh.show(), lambda: mesh.show((CORNERS, [[0, 1, 2]]), names=[]), lambda: mesh.show((CORNERS, [])),
                     lambda: mesh.show((CORNERS, [[0, 1, 2]]), up="w")):
            self.assertRaises(ValueError, call)
        self.assertRaises(TypeError, lambda: mesh.show(3))
        self.assertRaises(ValueError, lambda: mesh.show((CORNERS, [[0, 1, 8]])))
        self.assertRaises(ValueError, lambda: mesh.show((CORNERS * np.nan, [[0, 1, 2]])))

    def test_notebooks(self):
        text = mesh.make("torus", 300)._repr_html_()
        self.assertTrue(text.startswith("<iframe srcdoc="))
        inner = html.unescape(re.search(r'srcdoc="([^"]*)"', text).group(1))
        self.assertTrue(inner.startswith("<!doctype html>") and inner.rstrip().endswith("</html>"))
        self.assertIsNone(mesh.Mesh(CORNERS)._repr_html_())
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "page.html")
            mesh.make("torus", 300).show().write(path)
            with open(path, encoding="utf-8") as file:
                self.assertEqual(file.read(), inner)


@unittest.skipUnless(BROWSER, "there is no chromium")
class InABrowser(unittest.TestCase):
    def report(self, shown, preset):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "page.html")
            shown.write(path)
            done = subprocess.run(
                [BROWSER, "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", f"--user-data-dir={folder}/profile",
                 "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--enable-logging=stderr", "--window-size=900,700",
                 "--virtual-time-budget=20000", "--dump-dom", f"file://{path}#{preset}"], capture_output=True, text=True, timeout=240)
        self.assertEqual([line for line in done.stderr.splitlines() if "CONSOLE" in line], [])
        return json.loads(html.unescape(re.search(r'data-check="([^"]*)"', done.stdout).group(1)))

    def test_what_is_drawn_measured_and_picked(self):
        hexahedra, tetrahedra = bent_cube(3), bent_cube(3, True)
        report = self.report(mesh.show(mesh.Mesh(hexahedra[0], hexahedra=hexahedra[1]), mesh.Mesh(tetrahedra[0], tetrahedra=tetrahedra[1]),
                                       mesh.make("creature", 800)), "check&color=jacobian")
        for frame in report["frames"]:
            self.assertEqual(frame["error"], 0, frame)
            for view in frame["views"]:
                self.assertTrue(0.01 < view["drawn"] < 0.6 and view["colors"] > 3, frame)
        whole = report["frames"][0]["views"][0]["drawn"]
        sliced = [frame["views"][0]["drawn"] for frame in report["frames"] if frame["what"].startswith("slice")]
        self.assertTrue(len(sliced) == 3 and all(part < 0.95 * whole for part in sliced), (whole, sliced))
        # The script measures as this test does.
        for (points, cells), values, neighbors, regular in ((hexahedra, report["values"][0], HEXAHEDRON_NEIGHBORS, 1),
                                                            (tetrahedra, report["values"][1], TETRAHEDRON_NEIGHBORS, 2**0.5)):
            self.assertLess(abs(np.array(values["jacobian"]) - scaled_jacobians(points, cells, neighbors, regular)).max(), 2e-5)
            self.assertAlmostEqual(sum(values["volume"]), 27, places=3)
        for picked, name in zip(report["picked"], ("Hexahedron", "Tetrahedron", "Triangle")):
            self.assertIn(f"{name} {picked['element']} of", picked["text"])

    def test_a_map_that_keeps_nothing_but_angles(self):
        ball = mesh.make("sphere", 300)
        values, = self.report(mesh.show(ball, maps=[3 * ball.positions]), "check&morph=0.5")["values"]
        self.assertLess(abs(np.array(values["angle0"])).max(), 1e-2)  # the square root of the rounding of positions
        self.assertLess(abs(np.array(values["ratio0"])).max(), 1e-4)


class OtherPackages(unittest.TestCase):
    """By stand-ins, so that what is handed over is seen."""

    def setUp(self):
        self.had = {name: sys.modules.get(name) for name in ("trimesh", "polyscope")}
        keep = lambda *arguments, **named: (arguments, named)
        sys.modules["trimesh"] = types.SimpleNamespace(Trimesh=keep)
        sys.modules["polyscope"] = types.SimpleNamespace(register_surface_mesh=keep, register_volume_mesh=keep)

    def tearDown(self):
        for name, module in self.had.items():
            if module is None:
                del sys.modules[name]
            else:
                sys.modules[name] = module

    def test_trimesh(self):
        shape = mesh.make("torus", 300)
        (vertices, faces), named = mesh.to_trimesh(shape)
        self.assertTrue(np.array_equal(vertices, shape.positions) and np.array_equal(faces, shape.triangles))
        self.assertEqual(named, {"process": False})
        (vertices, faces), _ = mesh.to_trimesh(mesh.Mesh(CORNERS, hexahedra=HEXAHEDRON))
        self.assertEqual(len(faces), 12)

    def test_polyscope(self):
        shape = mesh.make("torus", 300)
        (name, vertices, faces), _ = mesh.to_polyscope(shape, "ring")
        self.assertEqual((name, len(vertices), len(faces)), ("ring", len(shape), len(shape.triangles)))
        _, named = mesh.to_polyscope(mesh.Mesh(CORNERS, tetrahedra=KUHN))
        self.assertTrue(np.array_equal(named["tets"], KUHN) and named["hexes"] is None)


if __name__ == "__main__":
    unittest.main()
