#!/usr/bin/env python3
"""The verbs of the command: help, options, results in every format, reports.

    verbs_test.py COMMAND
"""
import json
import math
import os
import random
import re

from command import Glb, InFolder, as_float32, main, not_positive, read_obj, run

# Those that the command itself lists: "  NAME  what it does" below "Subcommands:".
VERBS = tuple(re.findall(r"^  ([a-z]+) ", run("--help").stdout.split("Subcommands:")[1].split("\n\n")[0], re.M))
# Endings of formats that keep vertices and doubles.
EXACT = (".obj", ".off", ".ply", ".mesh", ".vtk")
GENUS = {"creature": 0, "blob": 0, "star": 0, "sphere": 0, "cube": 0, "torus": 1, "three-holes": 3, "bracket": 4,
         "l-shape": 0, "cylinder": 0, "vase": 0}


class CommandLine(InFolder):
    def test_help_names_every_verb_and_each_has_its_own(self):
        general = run("--help")
        for verb in ("info", "convert", "make", "sphere", "frames", "morph", "map", "harmonics", "compare", "page"):
            self.assertIn(verb, VERBS)  # these are in every build
        self.assertEqual((general.returncode, general.stderr), (0, ""))
        for verb in VERBS:
            self.assertIn(f"  {verb} ", general.stdout)
            own = run(verb, "--help")
            self.assertEqual((own.returncode, own.stderr), (0, ""))
            for option in ("--quiet", "--threads", "--seed", "--time-limit", "--report"):
                self.assertIn(option, own.stdout)
            self.assertRegex(own.stdout, rf"\n  orbicube {verb} [^\n]+")  # an example of its own

    def test_the_examples_of_help_are_commands(self):
        for verb in VERBS:
            for example in re.findall(rf"^  orbicube ({verb} .*)$", run(verb, "--help").stdout, re.M):
                done = run(*example.split(), cwd=self.folder)  # most of their files are not there
                self.assertNotIn("orbicube: usage", done.stderr, example)

    def test_an_option_takes_the_same_kind_of_value_in_every_verb(self):
        # By the word for its value in help texts. The kind of an output is that of its verb; --weld of repair may have a distance.
        apart = {"--output", "--weld"}
        values = {}
        for verb in VERBS:
            own = run(verb, "--help").stdout.split("\nOptions:\n")[1].split("Options of every verb")[0]
            for option, value in re.findall(r"^  (?:-\w,)?(--[\w-]+)(?:,--[\w-]+)*((?: [A-Z\[][^\s]*)?)", own, re.M):
                values.setdefault(option, {})[verb] = value.strip()
        self.assertGreater(len(values), 100)
        for option, words in values.items():
            if option not in apart:
                self.assertEqual(len(set(words.values())), 1, (option, words))

    def test_mistyped_verbs_and_options_get_the_nearest_ones(self):
        cube, out = self.made("cube"), self.path("out.obj")
        for arguments, meant in ((("sphera", cube), "sphere"), (("shpere", cube, "-o", out), "sphere"), (("comvert",), "convert"),
                                 (("sphere", cube, "-o", out, "--methd", "stretch"), "--method"),
                                 (("sphere", cube, "-o", out, "--remseh=x.obj"), "--remesh"),
                                 (("make", "cube", "-o", out, "--resolutoin", "5"), "--resolution"),
                                 (("SPHERE", cube), "sphere"), (("harm", cube), "harmonics"), (("Conv", cube), "convert"),
                                 (("--versoin",), "--version"), (("--quite", "info", cube), "--quiet"),
                                 (("sphere", cube, "-o", out, "--area", "1"), "--area-weight")):
            done = run(*arguments)
            self.assertEqual(done.returncode, 2)
            self.assertIn("did you mean " + meant + "?", done.stderr)
        # Words around an option that there is not are not what is wrong.
        self.assertRegex(run("sphere", "--methd", "stretch", cube, "-o", out).stderr,
                         r"usage: there is no option --methd; did you mean --method\?; see 'orbicube sphere --help'\n\Z")
        for arguments in (("sing",), ("sphere", cube, "-o", out, "--xylophone")):
            self.assertNotIn("did you mean", run(*arguments).stderr)

    def write(self, name, positions, triangles):
        with open(self.path(name), "w", encoding="ascii") as file:
            file.writelines("v %r %r %r\n" % tuple(p) for p in positions)
            file.writelines("f %d %d %d\n" % tuple(c + 1 for c in t) for t in triangles)
        return self.path(name)

    def test_refusals_name_what_helps(self):
        positions, triangles = read_obj(self.made("sphere", 300))
        out = self.path("out.obj")
        # Three vertices of one face doubled: a hole that welding closes.
        doubled = triangles[:-1] + [tuple(len(positions) + k for k in range(3))]
        twins = self.write("doubled.obj", positions + [positions[v] for v in triangles[-1]], doubled)
        line = self.refused(2, "not-closed", twins, "sphere", twins, "-o", out)
        self.assertIn("3 vertices stand at the place of others: try --weld", line)
        self.assertEqual(run("sphere", twins, "-o", out, "--weld").returncode, 0)
        # One face divided at the middle of an edge, its neighbor not.
        a, b, c = triangles[0]
        middle = [(x + y) / 2 for x, y in zip(positions[a], positions[b])]
        junction = self.write("junction.obj", positions + [middle],
                              triangles[1:] + [(a, len(positions), c), (len(positions), b, c)])
        line = self.refused(2, "not-closed", junction, "sphere", junction, "-o", out)
        self.assertIn(f"vertex {len(positions)} at ", line)
        self.assertRegex(line, rf"lies on the edge ({a}-{b}|{b}-{a})\b")
        hole = self.write("hole.obj", positions, triangles[1:])
        self.assertIn("--repair", self.refused(2, "not-closed", hole, "sphere", hole, "-o", out))
        small = [(5, 0, 0), (6, 0, 0), (5, 1, 0), (5, 0, 1)]
        n = len(positions)
        parts = self.write("parts.obj", positions + small,
                           triangles + [(n, n + 2, n + 1), (n, n + 1, n + 3), (n + 1, n + 2, n + 3), (n, n + 3, n + 2)])
        line = self.refused(2, "not-connected", parts, "sphere", parts, "-o", out)
        self.assertIn(f"{len(triangles)}, 4 triangles", line)
        torus = self.made("torus")
        self.assertIn("polycube", self.refused(2, "wrong-genus", torus, "sphere", torus, "-o", out))

    def test_version(self):
        self.assertRegex(run("--version").stdout, r"^orbicube \d+\.\d+\.\d+$")

    def test_mistakes_on_the_command_line_end_with_2_and_one_clear_line(self):
        cube = self.made("cube")
        out = self.path("out.obj")
        for arguments, word in (
                ((), "verb"), (("sing",), "sing"), (("info",), "IN"), (("info", cube, "--loud"), "--loud"),
                (("sphere", cube), "--output"), (("make", "teapot", "-o", out), "teapot"),
                (("make", "cube", "-o", out, "--resolution", "-5"), "--resolution"),
                (("make", "cube", "-o", out, "--resolution", "many"), "--resolution"),
                (("make", "cube", "-o", out, "--seed", "-1"), "--seed"),
                (("sphere", cube, "-o", out, "--method", "magic"), "magic"),
                (("sphere", cube, "-o", out, "--angle-weight", "-1"), "--angle-weight"),
                (("sphere", cube, "-o", out, "--angle-weight", "0", "--area-weight", "0"), "--angle-weight"),
                (("sphere", cube, "-o", out, "--level-splits", "0", "--method", "dissertation"), "--level-splits"),
                (("sphere", cube, "-o", out, "--level-splits", "20"), "--method dissertation"),
                (("sphere", cube, "-o", out, "--threads", "-1"), "--threads"),
                (("sphere", cube, "-o", out, "--time-limit", "0"), "--time-limit: '0' is not a number above 0;"),
                (("sphere", cube, "-o", out, "--time-limit", "nan"), "--time-limit: 'nan' is not a number above 0;"),
                (("sphere", cube, "-o", out, "--time-limit", "inf"), "--time-limit: 'inf' is not"),
                (("sphere", cube, "-o", out, "--time-limit", "soon"), "--time-limit: 'soon' is not"),
                (("sphere", cube, "-o", out, "--area-weight", "nan"), "--area-weight: 'nan' is not a number of at least 0;"),
                (("repair", cube, "-o", out, "--wrap", "nan"), "--wrap: 'nan' is not a number of at least 0;"),
                (("repair", cube, "-o", out, "--slivers", ".5"), "--slivers: '.5' is not a number from 0 to 0.4999;"),
                (("morph", cube, cube, "-o", out, "--blend", "nan,1"), "--blend: 'nan' is not a finite number;")):
            done = run(*arguments)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertEqual(done.stdout, "")
            self.assertRegex(done.stderr, r"\Aorbicube: usage: [^\n]*\n\Z")
            self.assertIn(word, done.stderr)

    def test_wrong_paths_are_told_before_any_work(self):
        cube = self.made("cube")
        missing = self.path("missing.obj")
        self.refused(2, "io", missing, "info", missing)
        for ending in (".xyz", ""):
            out = self.path("out" + ending)
            self.refused(2, "unsupported-format", out, "sphere", cube, "-o", out)
            self.refused(2, "unsupported-format", out, "convert", cube, out)
            self.refused(2, "unsupported-format", out, "make", "cube", "-o", out)
        nowhere = self.path("nowhere/out.obj")
        self.refused(2, "io", nowhere, "sphere", cube, "-o", nowhere)
        long = self.path("x" * 300 + ".obj")
        self.refused(2, "io", long, "sphere", cube, "-o", long)

    def test_names_of_files_reach_no_terminal_as_commands(self):
        odd = self.path("a\x1b[31m\x7f\r\t.obj")
        done = run("info", odd)
        self.assertEqual((done.returncode, done.stderr), (2, f"orbicube: {self.folder}/a [31m   .obj: io: cannot read: No such file or directory\n"))
        done = run("make", "cube", "-o", odd)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertNotRegex(done.stdout, r"[\x00-\x09\x0b-\x1f\x7f]")
        self.assertTrue(os.path.exists(odd))

    def test_common_options_stand_before_and_behind_the_verb(self):
        cube = self.made("cube")
        for arguments in (("--quiet", "info", cube), ("info", cube, "--quiet"), ("info", "--quiet", cube)):
            done = run(*arguments)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))


class Shapes(InFolder):
    def test_shapes_have_their_genus_and_only_those_of_genus_0_have_a_map(self):
        choice = random.Random(3)
        for shape, genus in GENUS.items():
            path = self.made(shape, choice.randint(500, 1500), choice.randrange(2**63))
            report = self.path("report.json")
            self.assertEqual(run("info", path, "--quiet", "--report", report).returncode, 0)
            with open(report, encoding="utf-8") as file:
                facts = json.load(file)
            self.assertEqual((facts["genus"], facts["closed"], facts["manifold"], facts["outward"]),
                             (genus, True, True, True))
            self.assertEqual(facts["usable_for"]["sphere"]["usable"], genus == 0)
            out = self.path("map.obj")
            if genus > 0:
                self.refused(2, "wrong-genus", path, "sphere", path, "-o", out)
                continue
            done = run("sphere", path, "-o", out)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            directions, triangles = read_obj(out)
            self.assertEqual(triangles, read_obj(path)[1])
            self.assertEqual(not_positive(directions, triangles), 0)
            for d in directions:
                self.assertLess(abs(math.hypot(*d) - 1), 1e-15)  # a few roundings of a normalized vector

    def test_the_same_options_make_the_same_bytes(self):
        with open(self.made("creature", 3000, 5, "a.obj"), "rb") as a, \
                open(self.made("creature", 3000, 5, "b.obj"), "rb") as b, \
                open(self.made("creature", 3000, 6, "c.obj"), "rb") as c:
            first = a.read()
            self.assertEqual(first, b.read())
            self.assertNotEqual(first, c.read())


class SphereMaps(InFolder):
    def test_every_format_holds_the_same_map(self):
        shape = self.made("creature", 1500, 2)
        reference = self.path("reference.obj")
        self.assertEqual(run("sphere", shape, "-o", reference).returncode, 0)
        with open(reference, "rb") as file:
            expected = file.read()
        for ending in EXACT:
            for text in ((), ("--text",)):
                out, back = self.path("map" + ending), self.path("back.obj")
                self.assertEqual(run("sphere", shape, "-o", out, *text).returncode, 0)
                self.assertEqual(run("convert", out, back).returncode, 0)
                with open(back, "rb") as file:
                    self.assertEqual(file.read(), expected, ending)

    def test_stl_is_valid_in_float32(self):
        shape = self.made("creature", 1500, 2)
        out, back = self.path("map.stl"), self.path("back.obj")
        self.assertEqual(run("sphere", shape, "-o", out).returncode, 0)
        self.assertEqual(run("convert", out, back).returncode, 0)
        positions, triangles = read_obj(back)
        self.assertEqual(len(triangles), len(read_obj(shape)[1]))
        self.assertEqual(not_positive(positions, triangles), 0)

    def test_glb_holds_the_surface_and_the_sphere_as_a_morph_target(self):
        for shape, seed in (("creature", 4), ("star", 1), ("cube", 0)):
            path = self.made(shape, 1500, seed)
            out = self.path("map.glb")
            self.assertEqual(run("sphere", path, "-o", out).returncode, 0)
            positions, triangles = read_obj(path)
            glb = Glb(out)
            self.assertEqual(glb.target_names, ["sphere"])
            self.assertEqual(glb.triangles, triangles)
            self.assertEqual(glb.positions, [tuple(map(as_float32, p)) for p in positions])
            for in_float32 in (False, True):
                sphere = glb.sphere(in_float32)
                self.assertEqual(not_positive(sphere, triangles), 0)
                for point in sphere:
                    self.assertLess(abs(math.hypot(*point) - 1), 1e-6)  # steps of float32 are 6e-8 near 1
            for (u, v), (x, y, z) in zip(glb.texture_coordinates, glb.sphere(False)):
                size = abs(x) + abs(y) + abs(z)
                self.assertAlmostEqual(u, 0.5 + 0.5 * x / size, delta=1e-6)
                self.assertAlmostEqual(v, 0.5 - 0.5 * y / size, delta=1e-6)
            self.assertEqual(len(glb.json["images"]), 1)

    def test_a_far_surface_is_written_relative_to_its_bounding_box(self):
        near = self.made("blob", 800)
        positions, triangles = read_obj(near)
        far = self.path("far.obj")
        with open(far, "w", encoding="ascii") as file:
            file.writelines("v %r %r %r\n" % (x + 1e6, y, z) for x, y, z in positions)
            file.writelines("f %d %d %d\n" % (a + 1, b + 1, c + 1) for a, b, c in triangles)
        out = self.path("far.glb")
        self.assertEqual(run("sphere", far, "-o", out).returncode, 0)
        glb = Glb(out)
        for in_float32 in (False, True):
            self.assertEqual(not_positive(glb.sphere(in_float32), triangles), 0)
        (node,) = [n for n in glb.json["nodes"] if "mesh" in n]
        for base, position in zip(glb.positions, positions):
            for k in range(3):
                world = node["translation"][k] + node["scale"][k] * base[k]
                self.assertAlmostEqual(world, position[k] + (1e6 if k == 0 else 0), delta=1e-6)
        converted, back = self.path("converted.glb"), self.path("back.obj")
        self.assertEqual(run("convert", far, converted).returncode, 0)
        self.assertEqual(run("convert", converted, back).returncode, 0)
        for there, position in zip(read_obj(back)[0], positions):
            self.assertLess(math.dist(there, (position[0] + 1e6, *position[1:])), 1e-6)

    def test_unused_vertices_keep_their_place(self):
        positions, triangles = read_obj(self.made("cube", 200))
        path = self.path("loose.obj")
        with open(path, "w", encoding="ascii") as file:
            file.write("v 5 6 7\n")
            file.writelines("v %r %r %r\n" % p for p in positions)
            file.writelines("f %d %d %d\n" % (a + 2, b + 2, c + 2) for a, b, c in triangles)
        for name in ("loose-map.obj", "loose-map.glb"):
            self.assertEqual(run("sphere", path, "-o", self.path(name)).returncode, 0)
        directions, faces = read_obj(self.path("loose-map.obj"))
        self.assertEqual(len(directions), len(positions) + 1)
        self.assertEqual(faces, [(a + 1, b + 1, c + 1) for a, b, c in triangles])
        self.assertLess(abs(math.hypot(*directions[0]) - 1), 1e-15)
        self.assertEqual(len(Glb(self.path("loose-map.glb")).positions), len(positions) + 1)

    def test_inward_surfaces_and_single_faces_are_turned_and_it_is_said(self):
        positions, triangles = read_obj(self.made("blob", 500))
        for name, flip in (("inward", lambda i: True), ("patchy", lambda i: i % 7 == 0)):
            path, out, report = self.path(name + ".obj"), self.path("map.obj"), self.path("report.json")
            with open(path, "w", encoding="ascii") as file:
                file.writelines("v %r %r %r\n" % p for p in positions)
                for i, (a, b, c) in enumerate(triangles):
                    file.write("f %d %d %d\n" % ((a + 1, c + 1, b + 1) if flip(i) else (a + 1, b + 1, c + 1)))
            done = run("sphere", path, "-o", out, "--report", report)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("reversed", done.stdout)
            directions, faces = read_obj(out)
            self.assertEqual([tuple(sorted(f)) for f in faces], [tuple(sorted(t)) for t in triangles])
            self.assertEqual(not_positive(directions, faces), 0)
            with open(report, encoding="utf-8") as file:
                self.assertTrue(any("reversed" in note for note in json.load(file)["notes"]))

    def test_the_number_of_threads_changes_no_bit(self):
        shape = self.made("creature", 8000, 1)
        maps = []
        for threads in (1, 2, 5):
            out = self.path(f"map{threads}.obj")
            self.assertEqual(run("sphere", shape, "-o", out, "--threads", threads).returncode, 0)
            with open(out, "rb") as file:
                maps.append(file.read())
        self.assertEqual(maps[0], maps[1])
        self.assertEqual(maps[0], maps[2])

    def test_every_method_gives_a_valid_map_and_is_best_at_its_own_energy(self):
        shape = self.made("creature", 1500, 3)
        energy = {}
        for method in ("balanced", "angle-area", "isometric", "stretch", "conformal", "dissertation"):
            report, out = self.path("report.json"), self.path("map.obj")
            done = run("sphere", shape, "-o", out, "--method", method, "--report", report)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(not_positive(*read_obj(out)), 0)
            with open(report, encoding="utf-8") as file:
                energy[method] = json.load(file)
        del energy["dissertation"]  # minimizes what angle-area does, from another place
        self.assertEqual(min(energy, key=lambda m: energy[m]["energy"]), "angle-area")
        self.assertEqual(min(energy, key=lambda m: energy[m]["isometric_mean"]), "isometric")
        self.assertEqual(max(energy, key=lambda m: energy[m]["stretch_efficiency"]), "stretch")
        self.assertEqual(min(energy, key=lambda m: energy[m]["energy_angle"]), "conformal")


class Reports(InFolder):
    def test_the_report_of_a_map_has_its_figures(self):
        shape, out, report = self.made("blob", 1000), self.path("map.ply"), self.path("report.json")
        self.assertEqual(run("sphere", shape, "-o", out, "--report", report, "--quiet").returncode, 0)
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        positions, triangles = read_obj(shape)
        for key, value in (("command", "sphere"), ("input", shape), ("output", out), ("exit_code", 0),
                           ("vertices", len(positions)), ("triangles", len(triangles)), ("method", "balanced"),
                           ("angle_weight", 0.1), ("area_weight", 1), ("bijective", True), ("flipped", 0),
                           ("degenerate", 0), ("notes", [])):
            self.assertEqual(figures[key], value, key)
        self.assertAlmostEqual(figures["degree"], 1, delta=1e-9)
        self.assertAlmostEqual(figures["energy"], 0.1 * figures["energy_angle"] + figures["energy_area"], delta=1e-9)
        self.assertGreaterEqual(figures["max_quasi_conformal"], figures["mean_quasi_conformal"])
        self.assertGreater(figures["mean_quasi_conformal"], 1)
        self.assertTrue(0 < figures["stretch_efficiency"] <= 1)
        self.assertGreaterEqual(figures["seconds"], figures["seconds_compute"])
        self.assertGreater(figures["peak_memory_bytes"], 1e6)
        self.assertIn("version", figures)
        self.assertEqual(figures["options"]["method"], "balanced")

    def test_the_report_of_the_dissertations_method_has_its_energy_by_iteration(self):
        shape, out, report = self.made("creature", 1000), self.path("map.ply"), self.path("report.json")
        figures = {}
        for splits in (40, 10):
            self.assertEqual(run("sphere", shape, "-o", out, "--method", "dissertation", "--level-splits", splits,
                                 "--final-tolerance", 0, "--max-final-iterations", 3000, "--report", report).returncode, 0)
            with open(report, encoding="utf-8") as file:
                figures[splits] = json.load(file)
        for splits, found in figures.items():
            course = found["convergence"]
            self.assertEqual(found["options"]["level_splits"], splits)
            self.assertEqual(len(course["iterations"]), len(course["energies"]))
            self.assertEqual(sorted(course["iterations"]), course["iterations"])
            self.assertEqual(course["vertices"][-1], found["vertices"])
            whole = [e for e, n in zip(course["energies"], course["vertices"]) if n == found["vertices"]]
            self.assertEqual(sorted(whole, reverse=True), whole)
            self.assertAlmostEqual(whole[-1], found["energy"], delta=2e-2 * found["energy"])
        self.assertGreater(len(figures[10]["convergence"]["vertices"]), 2 * len(figures[40]["convergence"]["vertices"]))
        self.assertNotEqual(figures[10]["energy"], figures[40]["energy"])

    def test_areas_alone_can_be_optimized(self):
        shape, out, report = self.made("creature", 1000), self.path("map.ply"), self.path("report.json")
        areas = {}
        for weight in (0, 1):
            for method in ("balanced", "angle-area", "dissertation"):
                done = run("sphere", shape, "-o", out, "--method", method, "--angle-weight", weight, "--report", report)
                self.assertEqual(done.returncode, 0, done.stderr)
                with open(report, encoding="utf-8") as file:
                    figures = json.load(file)
                self.assertTrue(figures["bijective"])
                self.assertEqual(figures["equation_3_4"], figures["energy_area"])
                self.assertLess(figures["equation_3_2"], figures["equation_3_4"])
                self.assertLess(figures["equation_3_1"], figures["equation_3_3"])
                areas[weight, method] = figures["energy_area"]
        for method in ("balanced", "angle-area", "dissertation"):
            self.assertLess(areas[0, method], areas[1, method])

    def test_a_failure_is_reported_too(self):
        torus, report = self.made("torus"), self.path("report.json")
        self.refused(2, "wrong-genus", torus, "sphere", torus, "-o", self.path("map.obj"), "--report", report)
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        self.assertEqual((figures["exit_code"], figures["error"]["kind"], figures["error"]["file"]),
                         (2, "wrong-genus", torus))

    def test_info_tells_facts_of_a_shape_that_is_no_closed_surface(self):
        path, report = self.path("two.obj"), self.path("report.json")
        with open(path, "w", encoding="ascii") as file:
            file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 9 9 9\nf 1 2 3\nf 1 3 4\n")
        self.assertEqual(run("info", path, "--report", report).returncode, 0)
        with open(report, encoding="utf-8") as file:
            facts = json.load(file)
        for key, value in (("vertices", 5), ("triangles", 2), ("edges", 5), ("components", 1), ("boundary_edges", 4),
                           ("boundary_loops", 1), ("closed", False), ("genus", None), ("volume", None), ("area", 1.0),
                           ("unreferenced_vertices", 1), ("consistently_oriented", True),
                           ("bounding_box", {"low": [0, 0, 0], "high": [1, 1, 1]})):
            self.assertEqual(facts[key], value, key)
        self.assertEqual(facts["usable_for"]["sphere"]["kind"], "not-closed")


if __name__ == "__main__":
    main()
