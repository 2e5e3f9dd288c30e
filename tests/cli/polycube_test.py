#!/usr/bin/env python3
"""orbicube polycube: what it writes lies on a polycube and on the surface, and what it cannot do it says.

    polycube_test.py COMMAND
"""
import base64
import json
import math
import os

from command import InFolder, kind_of, long, main, read_obj, run, write_obj
from on_polycube import looks_along


def area(positions, triangles):
    def twice(a, b, c):
        u, v = ([q[k] - a[k] for k in range(3)] for q in (b, c))
        return math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])

    return math.fsum(twice(*(positions[v] for v in t)) for t in triangles) / 2


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
            # Neighbors in one plane look the same way.
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

    def test_the_refined_surface_covers_a_long_ring_once(self):
        # Its pieces are so thin that rounding turns some; vertices that then went the wrong way folded the surface.
        around, across, tube, stretch = 11, 13, 0.392, 22.5
        turn = ((0.05619697, -0.47450193, 0.87845877), (-0.66455799, -0.67440832, -0.32177025),
                (0.74512051, -0.56570429, -0.35323376))
        positions, triangles = [], []
        for i in range(around):
            a, c = 2 * math.pi * i / around, (i + 1) % around
            for j in range(across):
                b, d = 2 * math.pi * j / across, (j + 1) % across
                ring = 1 + tube * math.cos(b)
                p = (ring * math.cos(a), stretch * ring * math.sin(a), tube * math.sin(b))
                positions.append(tuple(sum(row[k] * p[k] for k in range(3)) for row in turn))
                triangles += [(i * across + j, c * across + j, c * across + d), (i * across + j, c * across + d, i * across + d)]
        path, refined = self.path("ring.obj"), self.path("refined.obj")
        write_obj(path, positions, triangles)
        done = run("polycube", path, "-o", self.path("out.obj"), "--surface", refined)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        before, after = area(positions, triangles), area(*read_obj(refined))
        self.assertLess(abs(after / before - 1), 1e-12)

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

    def test_the_method_of_the_dissertation_is_certified_or_refused_with_the_place(self):
        path, out, report = self.made("l-shape", 800), self.path("out.obj"), self.path("report.json")
        done = run("polycube", path, "-o", out, "--method", "dissertation", "--report", report)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        positions, triangles = read_obj(out)
        self.assertNotIn(None, [looks_along(positions, t) for t in triangles])
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        self.assertEqual(figures["construction"], "dissertation")
        self.assertLessEqual(figures["corners"], figures["corner_points"])
        energies = figures["dissertation"]["energies"]
        self.assertEqual(energies, sorted(energies, reverse=True))
        # No round is the map before the first step, and the rounds that it takes to convergence are those of no limit.
        runs = {}
        for rounds in (0, 1, figures["dissertation"]["rounds"], 100):
            done = run("polycube", path, "-o", out, "--method", "dissertation", "--rounds", rounds, "--report", report)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            with open(report, encoding="utf-8") as file:
                of = json.load(file)
            self.assertEqual(of["options"]["rounds"], rounds)
            runs[rounds] = of["dissertation"]
            self.assertLessEqual(runs[rounds]["rounds"], rounds)
            self.assertEqual(runs[rounds]["energies"], energies[:len(runs[rounds]["energies"])])
        self.assertEqual((len(runs[0]["energies"]), runs[0]["rounds"], runs[0]["converged"]), (1, 0, False))
        self.assertEqual((runs[100]["energies"], runs[100]["converged"]), (energies, True))
        # The energy of one map is linear in the weight of areas.
        first = {1: energies[0]}
        for weight in (0, 100):
            done = run("polycube", path, "-o", out, "--method", "dissertation", "--rounds", 0, "--area-weight", weight, "--report", report)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            with open(report, encoding="utf-8") as file:
                first[weight] = json.load(file)["dissertation"]["energies"][0]
        self.assertLess(first[0], first[1])
        self.assertAlmostEqual(first[100], first[0] + 100 * (first[1] - first[0]), delta=1e-9 * first[100])
        # Of genus 3, with fewer corner points than its octree needs.
        out = self.path("none.obj")
        holes = self.made("three-holes", 1500)
        done = run("polycube", holes, "-o", out, "--method", "dissertation", "--corners", 12)
        self.assertEqual((done.returncode, kind_of(done.stderr, holes)), (1, "no-valid-result"))
        self.assertFalse(os.path.exists(out))
        done = run("polycube", path, path, "-o", out, "--method", "dissertation")
        self.assertEqual(done.returncode, 2)

    def test_rounds_without_what_they_limit_are_refused(self):
        path, out = self.made("sphere", 800), self.path("out.obj")
        for options in (("--rounds", 3), ("--rounds", 3, "--optimize", "domain"), ("--rounds", 0, "--optimize", "corners"),
                        ("--rounds", -1, "--method", "dissertation"), (path, "--rounds", 2, "--optimize", "corners")):
            done = run("polycube", path, "-o", out, *options)
            self.assertEqual(done.returncode, 2, options)
            self.assertIn("--rounds", done.stderr)
            self.assertFalse(os.path.exists(out))
        report = self.path("report.json")
        for rounds in (1, 6):
            done = run("polycube", path, "-o", out, "--corners", 8, "--optimize", "all", "--rounds", rounds, "--report", report)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            with open(report, encoding="utf-8") as file:
                # In a round two steps at most.
                self.assertLessEqual(len(json.load(file)["corner_optimization"]["energies"]), 1 + 2 * rounds)

    def test_unknown_constructions_are_refused(self):
        path, out = self.made("sphere", 800), self.path("out.obj")
        for option in (("--construct", "magic"), ("--corners", "-3"), ("--corners", "few")):
            done = run("polycube", path, "-o", out, *option)
            self.assertEqual(done.returncode, 2)
            self.assertFalse(os.path.exists(out))

    @long
    def test_the_best_proportions_are_no_worse_and_still_a_polycube(self):
        path, out, report = self.made("bracket", 1500), self.path("out.obj"), self.path("report.json")
        for options in ((), ("--measure", "faces", "--area-weight", 0.5)):
            done = run("polycube", path, "-o", out, "--optimize", "domain", *options, "--report", report)
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
                # Sums of as many triangles in another order; the whole area of the energy's has no degenerate ones, whose
                # heights are below 1e-6 of their longest sides, so that such an area is below 1e-8 of this surface's.
                delta = 1e-9 + 1e-8 * d["zero_area_faces"]
                self.assertAlmostEqual(energy, d["angle_" + which] + weight * d["area_" + which], delta=delta)
        done = run("polycube", path, "-o", out, "--optimize", "corner")
        self.assertEqual(done.returncode, 2)

    def test_quads_lie_on_the_surface_and_are_regular_but_at_corners(self):
        path, quads, report = self.made("bracket", 1500), self.path("quads.obj"), self.path("report.json")
        done = run("polycube", path, "-o", self.path("out.obj"), "--quads", quads, "--cells", 4000, "--report", report)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        positions, faces = read_obj(quads)
        self.assertEqual({len(face) for face in faces}, {4})
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        self.assertEqual((figures["quads"]["vertices"], figures["quads"]["quads"]), (len(positions), len(faces)))
        self.assertLess(abs(len(faces) - 4000), 2000)
        valence = [0] * len(positions)
        edges = set()
        for face in faces:
            for k in range(4):
                valence[face[k]] += 1
                edge = (face[k], face[(k + 1) % 4])
                self.assertNotIn(edge, edges)
                edges.add(edge)
        self.assertTrue(all((b, a) in edges for a, b in edges))
        irregular = sum(n != 4 for n in valence)
        self.assertEqual(irregular, figures["quads"]["irregular_vertices"])
        self.assertLessEqual(irregular, figures["corners"])
        # Euler's formula, for the genus of the shape.
        self.assertEqual(len(positions) - len(edges) // 2 + len(faces), 2 - 2 * figures["genus"])
        # Vertices lie on the surface, so nothing is far from it that way.
        self.assertLess(figures["quads"]["distance"]["to_surface"]["rms_of_diagonal"], 0.02)
        self.assertEqual(figures["quads"]["self_intersections"], 0)
        self.assertNotIn("intersects itself", done.stdout)
        again = self.path("again.obj")
        done = run("polycube", path, "-o", self.path("out.obj"), "--quads", again, "--cell-size", 0.2)
        self.assertEqual(done.returncode, 0)
        done = run("polycube", path, "-o", self.path("out.obj"), "--quads", again, "--cell-size", 0.2, "--cells", 10)
        self.assertEqual(done.returncode, 2)

    @long
    def test_quads_too_few_for_narrow_parts_are_reported_where_they_intersect(self):
        path, report = self.made("creature", 6000), self.path("report.json")
        done = run("polycube", path, "-o", self.path("out.obj"), "--quads", self.path("quads.obj"), "--cells", 50, "--report",
                   report)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        self.assertGreater(figures["quads"]["self_intersections"], 0)
        self.assertRegex(done.stdout, r"note: .*quads.obj intersects itself: \d+ pairs of faces, the first at \(")

    def test_features_come_to_their_places(self):
        ball, domain, out = self.made("sphere", 800), self.path("domain.json"), self.path("out.obj")
        report, wanted = self.path("report.json"), self.path("features.json")
        self.assertEqual(run("polycube", ball, "-o", out, "--domain", domain, "--corners", 8).returncode, 0)
        before = read_obj(out)[0]
        low, high = ([f(p[k] for p in before) for k in range(3)] for f in (min, max))
        middle = [(a + b) / 2 for a, b in zip(low, high)]
        top = [middle[0] + 0.1 * (high[0] - low[0]), middle[1], high[2]]
        count = len(read_obj(ball)[0])
        nearest = min(range(count), key=lambda v: math.dist(before[v], (middle[0], middle[1], high[2])))
        with open(wanted, "w", encoding="utf-8") as file:
            json.dump({"points": [{"vertex": nearest, "target": top}]}, file)
        done = run("polycube", ball, "-o", out, "--from", domain, "--targets", wanted, "--report", report)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        positions, triangles = read_obj(out)
        self.assertEqual(tuple(positions[nearest]), tuple(top))
        self.assertNotIn(None, [looks_along(positions, t) for t in triangles])
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)["features"]
        self.assertEqual((figures["points"], figures["distances"]), (1, [0]))
        self.assertGreater(figures["distances_before"][0], 0)
        bracket = self.made("bracket", 1500)
        done = run("polycube", bracket, "-o", out, "--feature-angle", 60, "--report", report)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)["features"]
        self.assertGreater(figures["sharp_on_edges"], 0.7 * figures["sharp_length"])
        os.remove(out)
        for kind, text in (("parse", "[]"), ("parse", '{"points": [{}]}'), ("parse", '{"curves": [{"vertices": 1}]}'),
                           ("invalid-argument", '{"points": [{"vertex": 0, "target": [9, 9, 9]}]}')):
            with open(wanted, "w", encoding="utf-8") as file:
                file.write(text)
            done = run("polycube", ball, "-o", out, "--from", domain, "--targets", wanted)
            self.assertEqual((done.returncode, kind_of(done.stderr, wanted)), (2, kind))
            self.assertFalse(os.path.exists(out))

    def test_glb_and_page_hold_the_map(self):
        path, glb, page, report = (self.made("bracket", 1500), self.path("map.glb"), self.path("map.html"),
                                   self.path("report.json"))
        done = run("polycube", path, "-o", self.path("out.obj"), "--glb", glb, "--page", page, "--optimize", "domain",
                   "--report", report)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        with open(glb, "rb") as file:
            data = file.read()
        length = int.from_bytes(data[12:16], "little")
        scene = json.loads(data[20:20 + length])
        mesh = scene["meshes"][0]
        self.assertEqual(mesh["extras"]["targetNames"], ["polycube"])
        attributes = mesh["primitives"][0]["attributes"]
        count = scene["accessors"][attributes["POSITION"]]["count"]
        self.assertEqual(count, figures["glb"]["vertices"])
        # Vertices on edges are there for each patch.
        self.assertGreater(count, figures["vertices"])
        self.assertEqual(scene["accessors"][attributes["TEXCOORD_0"]]["count"], count)
        self.assertEqual(scene["accessors"][mesh["primitives"][0]["indices"]]["count"], 3 * figures["triangles"])
        self.assertEqual(figures["glb"]["triangles_lost_in_float32"], 0)
        with open(page, encoding="utf-8") as file:
            text = file.read()
        start = text.index(">", text.index('id="results"')) + 1
        result = json.loads(text[start:text.index("</script>", start)])["results"][0]
        self.assertEqual(result["energies"], figures["domain"]["energies"])
        self.assertEqual((result["vertices"], result["triangles"]), (figures["vertices"], figures["triangles"]))
        steps = base64.b64decode(result["polycube"]["positions"])
        self.assertEqual(len(steps), 6 * figures["vertices"])
        # Faces of the polycube are flat in the page as well: few different coordinates.
        numbers = [steps[i] | steps[i + 1] << 8 for i in range(0, len(steps), 2)]
        self.assertEqual((min(numbers), max(numbers)), (0, 65535))
        rotation = result["polycube"]["facing"]
        for i in range(3):
            for j in range(3):
                dot = sum(rotation[3 * i + k] * rotation[3 * j + k] for k in range(3))
                self.assertAlmostEqual(dot, i == j, delta=1e-12)

    @long
    def test_corners_in_better_places_leave_a_polycube_that_is_no_worse(self):
        path, out, report = self.made("bracket", 1500), self.path("out.obj"), self.path("report.json")
        for options in (("corners", "--corner-search", "gradient"), ("all", "--area-weight", 0.5)):
            done = run("polycube", path, "-o", out, "--optimize", *options, "--report", report)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn("energy after each step: ", done.stdout)
            positions, triangles = read_obj(out)
            self.assertNotIn(None, [looks_along(positions, t) for t in triangles])
            with open(report, encoding="utf-8") as file:
                figures = json.load(file)
            found = figures["corner_optimization"]
            energies = found["energies"]
            self.assertEqual(energies, sorted(energies, reverse=True))
            weight = 0.5 if "all" in options else 1
            for energy, d in ((energies[0], found["distortion_before"]), (energies[-1], figures["distortion"])):
                # Sums of as many triangles in another order.
                self.assertAlmostEqual(energy, d["angle_weighted_mean"] + weight * d["area_weighted_mean"], delta=1e-9)
        done = run("polycube", path, "-o", out, "--optimize", "corners", "--corner-search", "magic")
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
