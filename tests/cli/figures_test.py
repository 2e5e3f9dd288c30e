"""Figures of surfaces with triangles without area, with vertices in no face, and at any scale."""
import json
import math
import unittest

from command import InFolder, main, read_obj, run, write_obj


def split_one_side(positions, triangles, every):
    """Some edges get a vertex on one of their two sides only: a triangle without area is between."""
    positions, triangles = list(positions), list(triangles)
    added = 0
    for t in range(0, len(triangles), every):
        a, b, c = triangles[t]
        positions.append(tuple(0.6 * x + 0.4 * y for x, y in zip(positions[a], positions[b])))
        m = len(positions) - 1
        triangles[t] = (a, m, c)
        triangles += [(m, b, c), (a, b, m)]
        added += 1
    return positions, triangles, added


class Figures(InFolder):
    def report(self, *arguments):
        path = self.path("report.json")
        done = run(*arguments, "--report", path)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(path, encoding="utf-8") as file:
            return json.load(file), done.stdout + done.stderr

    def shape(self, name, change):
        """A creature, changed."""
        positions, triangles = read_obj(self.made("creature", 600, 1, "creature.obj"))
        path = self.path(name)
        write_obj(path, *change(positions, triangles))
        return path

    def test_triangles_without_area_enter_no_figure_and_are_noted(self):
        plain = self.shape("plain.obj", lambda p, t: (p, t))
        added = []

        def change(p, t):
            positions, triangles, count = split_one_side(p, t, 40)
            added.append(count)
            return positions, triangles
        split = self.shape("split.obj", change)
        before, _ = self.report("sphere", plain, "-o", self.path("a.obj"))
        after, said = self.report("sphere", split, "-o", self.path("b.obj"))
        self.assertEqual(before["zero_area_faces"], 0)
        self.assertEqual(after["zero_area_faces"], added[0])
        self.assertIn(f"{added[0]} triangles are degenerate", said)
        self.assertTrue(any("degenerate" in note for note in after["notes"]))
        self.assertLess(after["energy"], 1.1 * before["energy"])
        self.assertLess(after["mean_quasi_conformal"], 1.1 * before["mean_quasi_conformal"])
        blob = self.made("blob", 400)
        split = self.path("split.obj")
        *surface, count = split_one_side(*read_obj(blob), 40)
        write_obj(split, *surface)
        added[0] = count
        before, _ = self.report("polycube", blob, "-o", self.path("a.obj"), "--construct", "labels")
        after, said = self.report("polycube", split, "-o", self.path("b.obj"), "--construct", "labels")
        self.assertGreaterEqual(after["distortion"]["zero_area_faces"], added[0])
        self.assertIn(f"{added[0]} triangles are degenerate", said)
        for mean in ("angle_mean", "area_mean", "angle_weighted_mean", "area_weighted_mean"):
            self.assertLess(after["distortion"][mean], 1.5 * before["distortion"][mean])
        self.assertIn("mean distortion of angles %f, of areas %f (over the surface" % (
            after["distortion"]["angle_weighted_mean"], after["distortion"]["area_weighted_mean"]), said)

    def test_vertices_in_no_face_change_no_figure(self):
        plain = self.shape("plain.obj", lambda p, t: (p, t))
        strays = [(90.0, -70.0, 1e6), (0.0, 0.0, 0.0), (1e200, 0.0, 3.0)]
        stray = self.shape("stray.obj", lambda p, t: (list(p) + strays, t))
        count = len(read_obj(plain)[0])
        for weights in ("area", "sphere", "uniform"):
            figures = []
            for shape in (plain, stray):
                self.report("sphere", shape, "-o", self.path("map.obj"))
                figures.append(self.report("harmonics", shape, "--sphere", self.path("map.obj"), "--degree", "6", "-o", self.path("x.sh"),
                                           "--reconstruct", self.path("again.obj"), "--vertex-weights", weights)[0])
                self.assertEqual(len(read_obj(self.path("again.obj"))[0]), len(read_obj(shape)[0]))
            for key in ("error", "residual", "area", "degree_norms", "rank", "condition"):
                self.assertEqual(figures[0][key], figures[1][key], key)
        self.report("sphere", stray, "-o", self.path("map.obj"))
        directions = read_obj(self.path("map.obj"))[0]
        self.assertEqual(len(directions), count + len(strays))
        for direction in directions:
            self.assertAlmostEqual(math.dist(direction, (0, 0, 0)), 1, places=12)

    def test_morphs_have_no_vertices_in_no_face(self):
        plain = self.shape("plain.obj", lambda p, t: (p, t))
        other = self.shape("other.obj", lambda p, t: ([(x, 1.3 * y, z) for x, y, z in p], t))
        strays = [(40.0 + k, -k, 3.0) for k in range(30)]
        for grid in ("both", "first"):
            figures = []
            for change in ([], strays):
                paths = []
                for k, path in enumerate((plain, other)):
                    positions, triangles = read_obj(path)
                    paths.append(self.path(f"shape{k}.obj"))
                    # In front: the numbers of all vertices are others.
                    write_obj(paths[-1], list(change) + list(positions), [tuple(v + len(change) for v in t) for t in triangles])
                figures.append(self.report("morph", *paths, "-o", self.path("morph.glb"), "--grid", grid)[0])
            for key in ("vertices", "triangles"):
                self.assertEqual(figures[0][key], figures[1][key], (grid, key))
            for a, b in zip(figures[0]["shapes"], figures[1]["shapes"]):
                self.assertEqual(a["distance"], b["distance"])

    def test_harmonics_of_any_scale_have_the_same_figures(self):
        self.report("sphere", self.shape("plain.obj", lambda p, t: (p, t)), "-o", self.path("map.obj"))
        expected = None
        for exponent in (0, -900, 900):
            scale = math.ldexp(1, exponent)
            shape = self.shape("scaled.obj", lambda p, t: ([tuple(scale * x for x in v) for v in p], t))
            figures, _ = self.report("harmonics", shape, "--sphere", self.path("map.obj"), "--degree", "8", "-o", self.path("x.sh"),
                                     "--reconstruct", self.path("again.obj"))
            found = (figures["error"], figures["condition"], [x / scale for x in figures["degree_norms"]], figures["residual"] / scale,
                     [tuple(x / scale for x in v) for v in read_obj(self.path("again.obj"))[0]])
            expected = expected or found
            self.assertEqual(found, expected)
            self.assertEqual(figures["area"] is None, exponent != 0)

    def test_shapes_that_are_compared_in_their_own_unit_are_refused_at_extreme_sizes(self):
        for scale in (1e-200, 1e200):
            tiny = self.shape("extreme.obj", lambda p, t: ([tuple(scale * x for x in v) for v in p], t))
            self.refused(2, "unsupported", tiny, "morph", tiny, tiny, "-o", self.path("morph.glb"))
            self.refused(2, "unsupported", tiny, "polycube", tiny, tiny, "-o", self.path("out.obj"))
            self.refused(2, "unsupported", tiny, "polycube", tiny, "-o", self.path("out.obj"), "--quads", self.path("quads.obj"))


if __name__ == "__main__":
    main()
