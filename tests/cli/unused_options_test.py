#!/usr/bin/env python3
"""Options that a command line gives and that its verb would ignore are refused, with what they are for.

    unused_options_test.py COMMAND
"""
import os

from command import InFolder, main, run


class UnusedOptions(InFolder):
    def test_options_without_what_they_are_for_are_refused(self):
        shape, out = self.made("cube", 300), self.path("out.obj")
        glb, coefficients = self.path("out.glb"), self.path("out.sh")
        harmonics = ("harmonics", shape, "--sphere", shape, "--degree", 2, "-o", coefficients)
        morph = ("morph", shape, shape, "-o", glb)
        hexes = ("hex", shape, "-o", self.path("out.mesh"))
        for command, named in ((("sphere", shape, "-o", out, "--grid", "icosphere:3"), "--grid is for --remesh"),
                               (("sphere", shape, "-o", out, "--image-grid", "cube:9"), "--image-grid is for --image"),
                               (("polycube", shape, "-o", out, "--cells", 50), "--cells is for --quads"),
                               (("polycube", shape, "-o", out, "--cell-size", 0.1), "--cell-size is for --quads"),
                               ((*harmonics, "--align", "rotation"), "--align is for --align-to"),
                               ((*harmonics, "--width", 1), "--width is for --low, --high and --band"),
                               ((*harmonics, "--text"), "--text is for --reconstruct and --refined-map"),
                               ((*morph, "--align", "none", "--landmarks", shape), "--align is for spheres without landmarks"),
                               ((*morph, "--polycube", "--align", "none"), "--align is for spheres without landmarks"),
                               ((*morph, "--polycube", "--tolerance", 1), "--tolerance is for --grid both"),
                               ((*morph, "--grid", "first", "--tolerance", 1), "--tolerance is for --grid both"),
                               *((("sphere", shape, "-o", out, "--method", method, weight, 2), f"{weight} is for the methods balanced, angle-area and")
                                 for method in ("stretch", "isometric", "conformal") for weight in ("--angle-weight", "--area-weight")),
                               ((*hexes, "--cut", "half"), "--cut is for --glb"),
                               ((*hexes, "--method", "grid", "--frames", shape), "--frames is for --method frames"),
                               ((*hexes, "--method", "polycube", "--frames", shape), "--frames is for --method frames"),
                               ((*hexes, "--frames", shape, "--padding", "with"), "--padding is for polycubes and grids"),
                               ((*hexes, "--method", "frames", "--padding", "with"), "--padding is for polycubes and grids"),
                               ((*hexes, "--method", "frames", "--corners", 8), "--corners is for --method polycube"),
                               ((*hexes, "--method", "grid", "--corners", 8), "--corners is for --method polycube"),
                               ((*hexes, "--distance", 0, "--features", "off", "--max-cells", 9), "--max-cells is for a positive --distance"),
                               ((*hexes, "--features", "off", "--method", "grid", "--feature-angle", 9), "--feature-angle is for --features"),
                               (("tetrahedralize", shape, "-o", self.path("out.mesh"), "--growth", 0.2), "--growth is for --sizing")):
            done = run(*command)
            if "has no verb" in done.stderr or "not expected" in done.stderr:  # left out of this build
                continue
            self.assertEqual(done.returncode, 2, command)
            self.assertTrue(done.stderr.startswith("orbicube: usage: " + named), done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)
            for path in (out, glb, coefficients, self.path("out.mesh")):
                self.assertFalse(os.path.exists(path))

    def test_options_with_what_they_are_for_are_taken(self):
        shape, out, image = self.made("cube", 300), self.path("out.obj"), self.path("image.png")
        done = run("sphere", shape, "-o", out, "--image", image, "--image-grid", "cube:9")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        done = run("harmonics", shape, "--sphere", out, "--degree", 2, "-o", self.path("out.sh"), "--low", 2, "--width", 1)
        self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    main()
