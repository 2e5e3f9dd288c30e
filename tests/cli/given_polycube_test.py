#!/usr/bin/env python3
"""orbicube polycube, hex and volume with a polycube that is given, or one for several surfaces.

    given_polycube_test.py COMMAND
"""
import json
import math
import os

from command import Glb, InFolder, kind_of, long, main, read_obj, run
from on_polycube import looks_along


class GivenPolycube(InFolder):
    def test_the_polycube_by_itself_is_read_again_and_mapped_to(self):
        path, domain, report = self.made("creature", 1200), self.path("domain.json"), self.path("report.json")
        out, mesh = self.path("out.obj"), self.path("domain.obj")
        done = run("polycube", path, "-o", out, "--domain", domain, "--corners", 24, "--report", report)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        with open(domain, encoding="utf-8") as file:
            polycube = json.load(file)
        self.assertEqual((polycube["format"], polycube["version"], polycube["genus"]), ("orbicube-polycube", 1, 0))
        self.assertEqual(len(polycube["corners"]), figures["corners"])
        self.assertEqual(len(polycube["patches"]), figures["patches"])
        on_polycube = read_obj(out)[0]
        for corner, vertex in zip(polycube["corners"], polycube["corner_vertices"]):
            self.assertEqual(tuple(corner), tuple(on_polycube[vertex]))
        for patch, around in zip(polycube["patches"], polycube["dual_graph"]):
            axis = "xyz".index(patch["axis"])
            self.assertTrue(patch["loops"])
            for loop in patch["loops"]:
                self.assertTrue(all(polycube["corners"][c][axis] == patch["coordinate"] for c in loop))
            self.assertTrue(around)
        for edge in polycube["edges"]:
            first, second = edge["patches"]
            self.assertIn(second, polycube["dual_graph"][first])
        # A shape mapped to its own polycube again; corners by number, and to a vertex.
        places = self.path("places.json")
        with open(places, "w", encoding="utf-8") as file:
            surface = read_obj(path)[0]
            held = [{"corner": c, "vertex": v} for c, v in enumerate(polycube["corner_vertices"]) if v < len(surface)]
            held += [{"corner": c, "point": polycube["corner_points"][c]}
                     for c, v in enumerate(polycube["corner_vertices"]) if v >= len(surface)]
            json.dump(held, file)
        for more in ((), ("--constraints", places)):
            done = run("polycube", path, "-o", out, "--from", domain, *more, "--domain", mesh, "--report", report)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            positions, triangles = read_obj(out)
            self.assertNotIn(None, [looks_along(positions, t) for t in triangles])
            with open(report, encoding="utf-8") as file:
                again = json.load(file)
            self.assertEqual((again["construction"], again["corners"]), ("given", figures["corners"]))
            self.assertTrue({tuple(c) for c in polycube["corners"]} <= set(map(tuple, positions)))
        for place in held:
            if "vertex" in place:
                self.assertEqual(tuple(positions[place["vertex"]]), tuple(polycube["corners"][place["corner"]]))
        # The mesh of it as well.
        corners, rectangles = read_obj(mesh)
        self.assertEqual({len(face) for face in rectangles}, {4})
        done = run("polycube", path, "-o", out, "--from", mesh)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_polycubes_that_do_not_fit_or_are_none_are_refused(self):
        ball, ring = self.made("sphere", 800), self.made("torus", 800)
        domain, out = self.path("domain.json"), self.path("out.obj")
        self.assertEqual(run("polycube", ball, "-o", out, "--domain", domain, "--corners", 8).returncode, 0)
        os.remove(out)
        with open(domain, encoding="utf-8") as file:
            good = json.load(file)

        def refused(shape, about, kind, *options):
            done = run("polycube", shape, "-o", out, *options)
            self.assertEqual((done.returncode, kind_of(done.stderr, about)), (2, kind))
            self.assertFalse(os.path.exists(out))

        refused(ring, ring, "wrong-genus", "--from", domain)
        bad = self.path("bad.json")

        def with_polycube(text, kind):
            with open(bad, "w", encoding="utf-8") as file:
                file.write(text if isinstance(text, str) else json.dumps(text))
            refused(ball, bad, kind, "--from", bad)

        with_polycube("", "empty-file")
        with_polycube("{", "parse")
        with_polycube("[" * 1000, "depth-limit")
        with_polycube({"format": "something"}, "parse")
        with_polycube({**good, "version": 2}, "unsupported-version")
        with_polycube({**good, "corners": good["corners"][:-1]}, "index-range")
        with_polycube({**good, "patches": good["patches"][:-1]}, "unsupported")
        with_polycube({**good, "corners": [[2 * x for x in good["corners"][0]]] + good["corners"][1:]}, "unsupported")
        with_polycube({**good, "corners": [["a", 0, 0]] + good["corners"][1:]}, "parse")
        with_polycube({**good, "patches": [{**good["patches"][0], "axis": "w"}] + good["patches"][1:]}, "parse")
        with_polycube({**good, "corner_points": []}, "parse")
        for kind, places in (("parse", {}), ("parse", [{}]), ("index-range", [{"corner": 99, "vertex": 0}]),
                             ("parse", [{"corner": 0, "point": [0, 0]}])):
            with open(bad, "w", encoding="utf-8") as file:
                json.dump(places, file)
            refused(ball, bad, kind, "--from", domain, "--constraints", bad)
        # The sphere itself is no polycube.
        refused(ball, ball, "unsupported", "--from", ball)
        done = run("polycube", ball, "-o", out, "--from", domain, "--corners", 8)
        self.assertEqual(done.returncode, 2)
        self.assertTrue(done.stderr.startswith("orbicube: usage: "), done.stderr)

    @long
    def test_several_shapes_share_a_polycube(self):
        first, second = self.made("creature", 1000), self.path("second.obj")
        positions, triangles = read_obj(first)
        with open(second, "w", encoding="ascii") as file:
            for x, y, z in positions:
                file.write(f"v {1.2 * x + 0.1 * y * y!r} {0.9 * y!r} {1.1 * z!r}\n")
            for a, b, c in triangles:
                file.write(f"f {a + 1} {b + 1} {c + 1}\n")
        out, surface, report = self.path("out.obj"), self.path("surface.obj"), self.path("report.json")
        domain, quads = self.path("domain.json"), self.path("quads.obj")
        done = run("polycube", first, second, "-o", out, "--surface", surface, "--corners", 24, "--domain", domain, "--quads",
                   quads, "--cells", 1000, "--report", report)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        energies = figures["polycube"]["energies"]
        self.assertEqual(energies, sorted(energies, reverse=True))
        self.assertLess(figures["polycube"]["energy_over_own"], 1.3)
        with open(domain, encoding="utf-8") as file:
            corners = {tuple(c) for c in json.load(file)["corners"]}
        meshes = []
        for i, path in enumerate((first, second), 1):
            on_polycube, faces = read_obj(out.replace(".obj", f"-{i}.obj"))
            in_space, same = read_obj(surface.replace(".obj", f"-{i}.obj"))
            self.assertEqual(faces, same)
            self.assertNotIn(None, [looks_along(on_polycube, t) for t in faces])
            original = read_obj(path)[0]
            self.assertEqual(in_space[:len(original)], original)
            self.assertTrue(corners <= set(map(tuple, on_polycube)))
            meshes.append(read_obj(quads.replace(".obj", f"-{i}.obj")))
        self.assertEqual(meshes[0][1], meshes[1][1])
        self.assertNotEqual(meshes[0][0], meshes[1][0])
        # Which is what a morph goes through.
        glb = self.path("morph.glb")
        done = run("morph", first, second, "-o", glb, "--polycube", "--corners", 24, "--grid", "cells:2000", "--report", report)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(report, encoding="utf-8") as file:
            morph = json.load(file)
        self.assertEqual(morph["flipped"], 0)
        self.assertEqual(morph["polycube"]["energies"], energies)
        with open(glb, "rb") as file:
            data = file.read()
        scene = json.loads(data[20:20 + int.from_bytes(data[12:16], "little")])
        self.assertEqual(scene["meshes"][0]["extras"]["targetNames"], ["second"])
        # The polycube may be a target itself: all of its triangles lie across an axis.
        done = run("morph", first, second, "-o", glb, "--polycube", "--corners", 24, "--grid", "cells:500", "--show-polycube")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        scene = Glb(glb, texture=False)
        self.assertEqual(scene.target_names, ["polycube", "second"])
        there = [[x + d for x, d in zip(*both)] for both in zip(scene.positions, scene.deltas)]
        for triangle in scene.triangles:
            self.assertLess(min(max(there[v][k] for v in triangle) - min(there[v][k] for v in triangle) for k in range(3)), 1e-6)
        for wrong in (("--grid", "icosphere:3"), ("--grid", "cells:0"), ("--grid", "cells:")):
            done = run("morph", first, second, "-o", glb, "--polycube", *wrong)
            self.assertEqual(done.returncode, 2)
            self.assertTrue(done.stderr.startswith("orbicube: usage: "), done.stderr)
        ring = self.made("torus", 800)
        done = run("polycube", first, ring, "-o", out)
        self.assertEqual((done.returncode, kind_of(done.stderr, ring)), (2, "wrong-genus"))
        for wrong in (("--from", domain, "--constraints", domain), ("--targets", domain)):
            done = run("polycube", first, second, "-o", out, *wrong)
            self.assertEqual(done.returncode, 2)
            self.assertTrue(done.stderr.startswith("orbicube: usage: "), done.stderr)

    def test_several_surfaces_share_a_given_polycube_that_is_optimized_on_request(self):
        first, out, domain, report = self.made("l-shape", 300), self.path("out.obj"), self.path("given.json"), self.path("report.json")
        second = self.path("longer.obj")
        positions, triangles = read_obj(first)
        with open(second, "w", encoding="ascii") as file:
            file.writelines(f"v {1.5 * x} {y} {z}\n" for x, y, z in positions)
            file.writelines(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in triangles)
        self.assertEqual(run("polycube", first, "-o", out, "--domain", domain).returncode, 0)
        with open(domain, encoding="utf-8") as file:
            given = sorted({c[0] for c in json.load(file)["corners"]})
        sums = []
        for options in ((), ("--optimize", "all", "--corner-search", "gradient", "--feature-angle", "40"),
                        ("--optimize", "domain", "--measure", "harmonic", "--area-weight", "2")):
            done = run("polycube", first, second, "-o", out, "--from", domain, "--report", report, *options)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            with open(report, encoding="utf-8") as file:
                figures = json.load(file)
            self.assertEqual(figures["from"]["corners"], 12)
            energies = figures["polycube"]["energies"]
            self.assertEqual(energies, sorted(energies, reverse=True))
            sums.append(energies[-1])
            found = [{p[0] for p in read_obj(self.path(f"out-{i}.obj"))[0]} for i in (1, 2)]
            # The planes are those of the given polycube, or others that all share.
            self.assertEqual([set(given) <= xs for xs in found], [not options] * 2)
            self.assertEqual([("features" in shape) for shape in figures["shapes"]], ["--feature-angle" in options] * 2)
            if not options:
                places = read_obj(self.path("out-1.obj"))[0]
        self.assertLess(sums[1], sums[0])
        self.assertGreater(sums[2], sums[0])
        # A vertex of the first surface at the middle of a patch moves along it.
        low, high = min(p[2] for p in places), max(p[2] for p in places)
        top = [v for v in range(len(positions)) if places[v][2] == high]
        middle = [sum(places[v][k] for v in top) / len(top) for k in range(2)]
        vertex = min(top, key=lambda v: math.dist(places[v][:2], middle))
        target, wanted = [places[vertex][0], places[vertex][1] + 0.02 * (high - low), high], self.path("features.json")
        with open(wanted, "w", encoding="utf-8") as file:
            json.dump({"points": [{"vertex": vertex, "target": target}]}, file)
        done = run("polycube", first, second, "-o", out, "--from", domain, "--report", report, "--targets", wanted, "--targets", "none")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(read_obj(self.path("out-1.obj"))[0][vertex], tuple(target))
        with open(report, encoding="utf-8") as file:
            self.assertEqual([("features" in shape) for shape in json.load(file)["shapes"]], [True, False])

    def test_a_given_polycube_is_that_of_hexahedra_and_of_the_map_of_a_solid(self):
        path, out, surface, domain = self.made("l-shape", 300), self.path("out.obj"), self.path("surface.obj"), self.path("d.json")
        self.assertEqual(run("polycube", path, "-o", out, "--surface", surface, "--domain", domain, "--optimize", "all",
                             "--corner-search", "gradient", "--feature-angle", 40).returncode, 0)
        report, mesh = self.path("report.json"), self.path("solid.mesh")
        solids = run("--help").stdout
        verbs = ([("hex", "--cells", 300)] if "  hex " in solids else []) + ([("volume",)] if "  tetrahedralize " in solids else [])
        for verb, *more in verbs:
            for solid, given, note in ((surface, out, "has the triangles"), (path, domain, "other triangles")):
                if verb == "volume" and solid == path:
                    continue
                done = run(verb, solid, "-o", mesh, "--from", given, "--report", report, *more)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertIn("note: the given polycube", done.stdout)
                self.assertIn(note, done.stdout)
                with open(report, encoding="utf-8") as file:
                    figures = json.load(file)
                self.assertEqual((figures["from"]["corners"], figures["polycube"]["corners"]), (12, 12))
        if "  hex " not in solids:
            return
        for wrong in (("--method", "grid"), ("--corners", 8), ("--triangles", 1000), ("--features", "auto")):
            done = run("hex", surface, "-o", mesh, "--from", out, *wrong)
            self.assertEqual(done.returncode, 2)
            self.assertTrue(done.stderr.startswith("orbicube: usage: "), done.stderr)
        ring = self.made("torus", 400)
        done = run("hex", ring, "-o", mesh, "--from", domain)
        self.assertIn("wrong-genus", done.stderr)

    def test_options_that_would_be_ignored_are_refused(self):
        path, out = self.made("cube", 300), self.path("out.obj")
        for options, named in ((("--measure", "harmonic", "--optimize", "all"), "--measure is for --optimize domain"),
                               (("--measure", "surface"), "--measure is for --optimize domain"),
                               (("--area-weight", 2), "--area-weight is for --optimize"),
                               (("--corner-search", "gradient", "--optimize", "domain"), "--corner-search is for --optimize corners"),
                               (("--landmarks", path), "--landmarks is for several surfaces"),
                               (("--targets", path, "--targets", path), "--targets: one file")):
            done = run("polycube", path, "-o", out, *options)
            self.assertEqual(done.returncode, 2, options)
            self.assertTrue(done.stderr.startswith("orbicube: usage: " + named), done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)
            self.assertFalse(os.path.exists(out))


if __name__ == "__main__":
    main()
