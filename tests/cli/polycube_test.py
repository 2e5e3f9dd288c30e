#!/usr/bin/env python3
"""orbicube polycube: what it writes lies on a polycube and on the surface, and what it cannot do it says.

    polycube_test.py COMMAND
"""
import json
import os
from fractions import Fraction

from command import InFolder, kind_of, main, read_obj, run


def looks_along(positions, triangle):
    """(axis, sign) of a triangle that lies exactly in an axis-aligned plane and has area, else None."""
    points = [tuple(map(Fraction, positions[v])) for v in triangle]
    for axis in range(3):
        if len({p[axis] for p in points}) == 1:
            u, v = (axis + 1) % 3, (axis + 2) % 3
            a, b, c = points
            area = (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u])
            if area != 0:
                return axis, 1 if area > 0 else -1
    return None


class Polycube(InFolder):
    def test_every_triangle_lies_in_an_axis_aligned_plane_and_the_surface_is_kept(self):
        for shape, corners in (("bracket", 0), ("sphere", 8)):
            path = self.made(shape, 1500)
            out, refined, report = self.path("out.obj"), self.path("refined.obj"), self.path("report.json")
            done = run("polycube", path, "-o", out, "--surface", refined, "--corners", corners, "--report", report)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            surface, faces = read_obj(path)
            positions, triangles = read_obj(refined)
            on_polycube, same_triangles = read_obj(out)
            self.assertEqual(triangles, same_triangles)
            self.assertEqual(positions[:len(surface)], surface)
            labels = [looks_along(on_polycube, t) for t in triangles]
            self.assertNotIn(None, labels)
            # Neighbours in one plane look the same way.
            edges = {}
            for t, triangle in enumerate(triangles):
                for k in range(3):
                    edges[triangle[k], triangle[(k + 1) % 3]] = t
            for (a, b), t in edges.items():
                other = labels[edges[b, a]]
                self.assertNotEqual((labels[t][0], -labels[t][1]), other)
            with open(report, encoding="utf-8") as file:
                figures = json.load(file)
            self.assertEqual(figures["vertices"], len(positions))
            self.assertEqual(figures["vertices_added"], len(positions) - len(surface))
            self.assertEqual(figures["triangles"], len(triangles))
            if corners:
                self.assertEqual((figures["corners"], figures["patches"]), (8, 6))

    def test_the_report_says_which_construction_was_best(self):
        path = self.made("creature", 1200)
        figures = {}
        for method in ("auto", "labels", "voxels"):
            report = self.path(method + ".json")
            done = run("polycube", path, "-o", self.path(method + ".obj"), "--construct", method, "--corners", 24, "--report",
                       report)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            with open(report, encoding="utf-8") as file:
                figures[method] = json.load(file)
            self.assertLessEqual(figures[method]["corners"], 24)
            self.assertLessEqual(1, figures[method]["polycubes_valid"])
            self.assertLessEqual(figures[method]["polycubes_valid"], figures[method]["polycubes_tried"])
        self.assertEqual(figures["labels"]["construction"], "labels")
        self.assertEqual(figures["voxels"]["construction"], "voxels")
        # The best map is the very map of that construction.
        best = figures["auto"]["construction"]
        self.assertEqual(figures["auto"]["distortion"], figures[best]["distortion"])
        with open(self.path("auto.obj"), "rb") as one, open(self.path(best + ".obj"), "rb") as other:
            self.assertEqual(one.read(), other.read())

    def test_unknown_constructions_are_refused(self):
        path, out = self.made("sphere", 800), self.path("out.obj")
        for option in (("--construct", "magic"), ("--corners", "-3"), ("--corners", "few")):
            done = run("polycube", path, "-o", out, *option)
            self.assertEqual(done.returncode, 2)
            self.assertFalse(os.path.exists(out))

    def test_the_best_proportions_are_no_worse_and_still_a_polycube(self):
        path, out, report = self.made("bracket", 1500), self.path("out.obj"), self.path("report.json")
        for options in ((), ("--measure", "faces", "--area-weight", 0.5)):
            done = run("polycube", path, "-o", out, "--optimise", "domain", *options, "--report", report)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            positions, triangles = read_obj(out)
            self.assertNotIn(None, [looks_along(positions, t) for t in triangles])
            with open(report, encoding="utf-8") as file:
                figures = json.load(file)
            domain = figures["domain"]
            energies = domain["energies"]
            self.assertEqual(energies, sorted(energies, reverse=True))
            self.assertTrue(domain["converged"])
            after, before = figures["distortion"], domain["distortion_before"]
            weight, which = (0.5, "mean") if options else (1, "weighted_mean")
            for energy, d in ((energies[0], before), (energies[-1], after)):
                # Sums of as many triangles in another order.
                self.assertAlmostEqual(energy, d["angle_" + which] + weight * d["area_" + which], delta=1e-9)
        done = run("polycube", path, "-o", out, "--optimise", "corner")
        self.assertEqual(done.returncode, 2)

    def test_no_valid_map_is_told_and_nothing_is_written(self):
        path, out = self.made("sphere", 800), self.path("out.obj")
        done = run("polycube", path, "-o", out, "--corners", 7)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(kind_of(done.stderr, path), "no-valid-result")
        self.assertFalse(os.path.exists(out))

    def test_formats_that_round_are_refused_before_the_work(self):
        path = self.made("sphere", 800)
        for name in ("out.stl", "out.glb"):
            done = run("polycube", path, "-o", self.path(name))
            self.assertEqual(done.returncode, 2)
            self.assertEqual(kind_of(done.stderr, self.path(name)), "unsupported-format")

    def test_open_surfaces_are_refused(self):
        path = self.path("open.off")
        with open(path, "w", encoding="ascii") as file:
            file.write("OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 3 2\n")
        done = run("polycube", path, "-o", self.path("out.obj"))
        self.assertEqual(done.returncode, 2)
        self.assertEqual(kind_of(done.stderr, path), "not-closed")


if __name__ == "__main__":
    main()
