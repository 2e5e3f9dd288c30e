#!/usr/bin/env python3
"""One call from C, and one from Python, gives the hexahedra of `orbicube hex IN -o OUT`, to the bit.

    hex_calls_test.py COMMAND HEX_CALL
"""
import importlib
import json
import os
import subprocess
import sys

from command import InFolder, main, run

HEX_CALL = os.path.abspath(sys.argv.pop(2))
METHODS = {"polycube": 1, "grid": 2, "frames": 3}


def content(path):
    with open(path, "rb") as file:
        return file.read()


class HexCalls(InFolder):
    def compare(self, path, cells, method):
        """The command, a C program and Python on the same file; `method` is the one that is to be chosen."""
        ours, of_c, of_python = self.path("ours.vtk"), self.path("c.vtk"), self.path("python.vtk")
        report = self.path("report.json")
        done = run("hex", path, "-o", ours, "--cells", cells, "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        self.assertEqual(figures["method"], method)
        done = subprocess.run([HEX_CALL, path, of_c, str(cells)], capture_output=True, text=True, check=False, timeout=240)
        self.assertEqual(done.returncode, 0, done.stderr)
        number, jacobian = done.stdout.split()
        self.assertEqual((int(number), float(jacobian)), (METHODS[method], figures["min_scaled_jacobian"]))
        self.assertEqual(content(of_c), content(ours))
        try:
            orbicube = importlib.import_module("orbicube")
        except ImportError:
            return  # no numpy
        if "ORBICUBE_LIBRARIES" not in os.environ:
            return
        hexes = orbicube.hexmesh.fill_with_hexahedra(orbicube.mesh.read(path), cells=cells, fill=orbicube.tetrahedra.fill)
        self.assertEqual((hexes.report.method, hexes.report.hausdorff_percent), (METHODS[method], figures["hausdorff_percent"]))
        orbicube.mesh.write(of_python, hexes)
        self.assertEqual(content(of_python), content(ours))

    def test_a_machined_part_goes_along_frames(self):
        self.compare(self.made("bracket", 1500), 600, "frames")

    def test_a_round_shape_follows_its_polycube_with_more_cells(self):
        self.compare(self.made("torus", 1500), 600, "polycube")

    def test_a_shape_whose_polycube_is_far_goes_grid_based(self):
        self.compare(self.made("vase", 1500), 600, "grid")

    def test_a_solid_of_tetrahedra(self):
        solid = self.path("solid.mesh")
        done = run("tetrahedralize", self.made("l-shape", 600), "-o", solid)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.compare(solid, 200, "frames")

    def test_a_surface_that_is_inside_out_and_tiny(self):
        path = self.made("l-shape", 600)
        tiny = self.path("tiny.obj")
        with open(path, encoding="ascii") as source, open(tiny, "w", encoding="ascii") as file:
            for line in source:
                words = line.split()
                if words[:1] == ["v"]:
                    file.write("v " + " ".join(repr(float(x) * 2.0**-60) for x in words[1:4]) + "\n")
                elif words[:1] == ["f"]:
                    file.write("f " + " ".join(reversed(words[1:])) + "\n")
        self.compare(tiny, 200, "frames")


if __name__ == "__main__":
    main()
