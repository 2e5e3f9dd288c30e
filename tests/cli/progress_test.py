#!/usr/bin/env python3
"""The progress bar of a verb: one, that never goes back and ends with all done.

    progress_test.py COMMAND
"""
import os
import re

from command import InFolder, long, main, run


class Bar(InFolder):
    def percents(self, *arguments):
        """What the bar showed, one after the other, on a terminal."""
        seen = self.on_terminal(*arguments)
        return [int(found) for found in re.findall(rb"\[[#.]{24}\]\s+(\d+)%", seen)]

    def check(self, verb, sizes, arguments_of):
        """Larger and larger, since what takes less than a fifth of a second has no bar."""
        for size in sizes:
            shown = self.percents(verb, *arguments_of(size))
            if len(shown) > 2:
                break
        self.assertGreater(len(shown), 2, verb)
        self.assertEqual(shown, sorted(shown), verb)
        self.assertEqual(shown[-1], 100, verb)
        self.assertLess(shown[0], 100, verb)

    def test_surfaces(self):
        out = self.path("out.obj")
        many = (100_000, 400_000, 1_600_000)
        few = (20_000, 80_000, 320_000)
        self.check("make", many, lambda n: ("creature", "-o", out, "--resolution", n))
        self.check("convert", many, lambda n: (self.made("creature", n), out))
        self.check("info", many, lambda n: (self.made("creature", n),))
        self.check("sphere", few, lambda n: (self.made("creature", n), "-o", out))
        self.check("morph", few, lambda n: (self.made("creature", n), self.made("blob", n), "-o", self.path("out.glb")))

    def test_spheres(self):
        def mapped(n):
            shape, sphere = self.made("creature", n), self.path(f"sphere-{n}.obj")
            if not os.path.exists(sphere):
                self.assertEqual(run("sphere", shape, "-o", sphere).returncode, 0)
            return shape, sphere

        sizes = (20_000, 80_000, 320_000)
        page, coefficients = self.path("out.html"), self.path("out.sh")
        self.check("page", sizes, lambda n: (*6 * mapped(n), "-o", page))
        self.check("harmonics", sizes,
                   lambda n: (mapped(n)[0], "--sphere", mapped(n)[1], "--degree", 24, "-o", coefficients))

    @long
    def test_polycubes(self):
        sizes = (2000, 8000)
        self.check("polycube", sizes, lambda n: (self.made("creature", n), "-o", self.path("out.obj")))
        self.check("hex", sizes, lambda n: (self.made("blob", n), "-o", self.path("out.mesh"), "--cells", 500))


if __name__ == "__main__":
    main()
