#!/usr/bin/env python3
"""orbicube parameterize, and volume with frames and a grid: what they write holds what it should, refusals have their reasons.

    parameterize_test.py COMMAND
"""
import json
import os

from command import InFolder, main, run
from tetrahedra import box, write_medit


class Parameterize(InFolder):
    def setUp(self):
        super().setUp()
        points, self.cells = box(3)
        self.points = [[c / 3 for c in p] for p in points]
        self.solid, self.frames = self.path("solid.mesh"), self.path("solid.frames")
        write_medit(self.solid, self.points, self.cells)
        with open(self.frames, "w", encoding="ascii") as file:
            file.write("1 0 0 0\n" * len(self.cells))

    def report(self, *words):
        done = run(*words, "--report", self.path("report.json"))
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("report.json"), encoding="utf-8") as file:
            return json.load(file)

    def test_a_box_has_the_coordinates_of_space(self):
        vtk = self.path("map.vtk")
        figures = self.report("parameterize", self.solid, "-o", vtk, "--frames", self.frames, "--integer", "--cells", 27)
        self.assertEqual((figures["inverted"], figures["patches"], figures["singular_edges"]), (0, 6, 0))
        self.assertLess(figures["residual"], 1e-12)
        self.assertLess(figures["energy"], 1e-9)
        with open(vtk, encoding="ascii") as file:
            words = file.read().split()
        start = words.index("parameters") + 4
        values = [float(x) for x in words[start:start + 12 * len(self.cells)]]
        origin = [values[a] - 3 * self.points[self.cells[0][0]][a] for a in range(3)]
        for t, cell in enumerate(self.cells):
            for k, v in enumerate(cell):
                for a in range(3):
                    self.assertAlmostEqual(values[12 * t + 3 * k + a], 3 * self.points[v][a] + origin[a], places=6)

    def test_a_split_solid_is_that_of_the_map(self):
        split = self.path("split.mesh")
        figures = self.report("parameterize", self.solid, "-o", self.path("map.vtk"), "--split", split, "--cells", 27)
        self.assertEqual((figures["inverted"], figures["split"]), (0, split))
        self.assertEqual(run("frames", split, "-o", self.path("split.frames")).returncode, 0)
        self.report("parameterize", split, "-o", self.path("map.vtk"), "--frames", self.path("split.frames"))
        self.refused(2, "unsupported-format", self.path("split.obj"), "parameterize", self.solid, "-o", self.path("map.vtk"),
                     "--split", self.path("split.obj"))

    def test_other_files_are_written(self):
        for name in ("map.obj", "map.glb", "map.hexex"):
            self.report("parameterize", self.solid, "-o", self.path(name), "--page", self.path("page.html"))
            self.assertGreater(os.path.getsize(self.path(name)), 500)
        self.assertEqual(run("info", self.path("map.glb")).returncode, 0)

    def test_frames_guide_a_map_and_a_grid_comes_back(self):
        out, grid = self.path("image.mesh"), self.path("grid.vtk")
        figures = self.report("volume", self.solid, "-o", out, "--frames", self.frames, "--resample", grid, "--cells", 64)
        self.assertLess(figures["frames"]["energy"], 1)
        self.assertEqual(figures["frames"]["mismatched_faces"], 0)
        self.assertEqual(figures["resampled"]["hexahedra"], 64)
        self.assertEqual(figures["resampled"]["not_positive"], 0)

    def test_refusals(self):
        out = self.path("map.vtk")
        self.refused(2, "unsupported-format", self.path("map.stl"), "parameterize", self.solid, "-o", self.path("map.stl"))
        done = run("parameterize", self.solid, "-o", out, "--frames", self.frames, "--feature-angle", 40)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(run("volume", self.solid, "-o", self.path("o.mesh"), "--cells", 5).returncode, 2)
        with open(self.path("short.frames"), "w", encoding="ascii") as file:
            file.write("1 0 0 0\n")
        self.refused(2, "truncated", self.path("short.frames"), "parameterize", self.solid, "-o", out, "--frames",
                     self.path("short.frames"))
        self.assertFalse(os.path.exists(out))


if __name__ == "__main__":
    main()
