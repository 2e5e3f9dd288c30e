#!/usr/bin/env python3
"""orbicube repair and --repair: what comes out is closed, oriented and manifold by counting edges, clean files stay, refusals have reasons.

    repair_test.py COMMAND
"""
import collections
import json

from command import InFolder, main, run


def read_off(path):
    with open(path, encoding="ascii") as file:
        words = file.read().split()
    n, m = int(words[1]), int(words[2])
    numbers = words[4:]
    positions = [tuple(map(float, numbers[3 * i:3 * i + 3])) for i in range(n)]
    faces = numbers[3 * n:]
    return positions, [tuple(map(int, faces[4 * i + 1:4 * i + 4])) for i in range(m)]


def write_off(path, positions, triangles):
    with open(path, "w", encoding="ascii") as file:
        print("OFF", file=file)
        print(len(positions), len(triangles), 0, file=file)
        for p in positions:
            print(*map(repr, p), file=file)
        for t in triangles:
            print(3, *t, file=file)


class Repair(InFolder):
    def setUp(self):
        super().setUp()
        self.sphere = self.path("sphere.off")
        self.assertEqual(run("make", "sphere", "-o", self.sphere, "--resolution", "1000").returncode, 0)
        self.positions, self.triangles = read_off(self.sphere)

    def repaired(self, positions, triangles, *options, exit_code=0):
        write_off(self.path("in.off"), positions, triangles)
        done = run("repair", self.path("in.off"), "-o", self.path("out.off"), "--report", self.path("report.json"), *options)
        self.assertEqual(done.returncode, exit_code, done.stdout + done.stderr)
        with open(self.path("report.json"), encoding="utf-8") as file:
            return done, json.load(file)

    def check_closed(self, path):
        edges = collections.Counter((t[k], t[(k + 1) % 3]) for t in read_off(path)[1] for k in range(3))
        self.assertTrue(all(n == 1 and edges[b, a] == 1 for (a, b), n in list(edges.items())))

    def test_clean_file_stays(self):
        done, report = self.repaired(self.positions, self.triangles)
        self.assertFalse(report["changed"])
        self.assertEqual(read_off(self.path("out.off")), (self.positions, self.triangles))
        self.assertIn("as they were", done.stdout)

    def test_damage_of_all_kinds(self):
        n = len(self.positions)
        positions = self.positions + [(9, 9, 9), (9.1, 9, 9), (9, 9.1, 9), (5, 5, 5)]
        a, b, c = self.triangles[40]
        triangles = self.triangles[5:40] + [(b, a, c)] + self.triangles[41:] + [(n, n + 1, n + 2), (a, a, b), self.triangles[60]]
        done, report = self.repaired(positions, triangles)
        self.check_closed(self.path("out.off"))
        steps = report["steps"]
        self.assertEqual((steps["clean"]["degenerate_faces"], steps["clean"]["duplicate_faces"]), (1, 1))
        self.assertEqual((steps["parts"]["found"], steps["parts"]["kept"]), (2, 1))
        self.assertEqual(steps["orient"]["reversed_triangles"], 1)
        self.assertGreaterEqual(steps["holes"]["filled"], 1)
        self.assertEqual(report["distance"]["from_result"], 0)
        certificate = report["certificate"]
        self.assertEqual((certificate["genus"], certificate["self_intersections"]), (0, 0))
        actions = {event["action"] for event in report["events"]}
        self.assertLessEqual({"removed-degenerate", "removed-duplicate", "dropped-part", "filled-hole"}, actions)
        self.assertIn("filled", done.stdout)

    def test_options(self):
        _, report = self.repaired(self.positions, self.triangles[1:], "--fill-holes", "2")
        self.assertEqual(report["certificate"]["boundary_loops"], 1)
        _, report = self.repaired(self.positions, self.triangles[1:], "--skip", "holes", "slivers")
        self.assertEqual(report["certificate"]["boundary_loops"], 1)
        apart = self.positions + [tuple(x + 5 for x in p) for p in self.positions]
        two = self.triangles + [tuple(v + len(self.positions) for v in t) for t in self.triangles]
        for options, parts in ((("--largest",), 1), (("--keep", "0"), 2), (("--keep", "2"), 2), (("--min-part", "60"), 1), (("--min-part", "40"), 2)):
            _, report = self.repaired(apart, two, *options)
            self.assertEqual(report["certificate"]["parts"], parts, options)
        _, report = self.repaired(self.positions, self.triangles, "--wrap", "0.2")
        self.assertGreater(report["steps"]["wrap"]["triangles"], 100)
        self.check_closed(self.path("out.off"))
        torus = self.path("torus.off")
        self.assertEqual(run("make", "torus", "-o", torus, "--resolution", "600").returncode, 0)
        _, report = self.repaired(*read_off(torus), "--genus", "0")
        self.assertEqual((report["certificate"]["genus"], report["steps"]["handles"]["cut"]), (0, 1))
        _, report = self.repaired(*read_off(torus), "--max-handle", "0.01")
        self.assertEqual(report["certificate"]["genus"], 1)
        self.assertFalse(report["changed"])

    def test_parts_that_intersect_are_counted_and_wrapped(self):
        through = self.positions + [(x + 0.5, y, z) for x, y, z in self.positions]
        two = self.triangles + [tuple(v + len(self.positions) for v in t) for t in self.triangles]
        done, report = self.repaired(through, two, "--keep", "0")
        self.assertGreater(report["certificate"]["self_intersections"], 0)
        self.assertIn(f"{report['certificate']['self_intersections']} pairs of triangles intersect; --wrap", done.stdout)
        done, report = self.repaired(through, two, "--wrap", "0.1")
        self.check_closed(self.path("out.off"))
        self.assertEqual((report["certificate"]["parts"], report["certificate"]["self_intersections"]), (1, 0))
        self.assertIn("no self-intersection", done.stdout)

    def test_what_cannot_be_reached(self):
        # The projective plane with six vertices.
        positions = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (-1, 0, 0.1), (0, -1, 0.2), (0, 0.3, -1)]
        plane = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5), (0, 5, 1), (1, 2, 4), (2, 3, 5), (3, 4, 1), (4, 5, 2), (5, 1, 3)]
        done, report = self.repaired(positions, plane, exit_code=1)
        self.assertIn("no-valid-result", done.stderr)
        self.assertFalse(report["certificate"]["oriented"])
        self.assertFalse(self.exists("out.off"))
        self.repaired(positions, plane, "--keep-partial", exit_code=1)
        self.assertTrue(self.exists("out.off"))

    def exists(self, name):
        try:
            with open(self.path(name), encoding="ascii"):
                return True
        except FileNotFoundError:
            return False

    def test_options_that_would_be_ignored_are_refused(self):
        for options in (("--skip", "holes", "--fill-holes", "5"), ("--skip", "weld", "--weld", "0.1"), ("--skip", "parts", "--keep", "2"),
                        ("--cavities",), ("--largest", "--keep", "2"), ("--skip", "everything"), ("--slivers", "0.6"), ("--weld", "-1")):
            done = run("repair", self.sphere, "-o", self.path("out.off"), *options)
            self.assertEqual(done.returncode, 2, options)
            self.assertIn("usage", done.stderr)

    def test_verbs_take_what_they_refuse(self):
        hole = self.path("hole.off")
        write_off(hole, self.positions, self.triangles[3:])
        for verb, output in (("sphere", "x.ply"), ("polycube", "x.obj"), ("tetrahedralize", "x.mesh")):
            if run(verb, "--help").returncode != 0:
                continue
            out = self.path(output)
            done = run(verb, hole, "-o", out)
            self.assertEqual(done.returncode, 2)
            self.assertIn("--repair", done.stderr)
            done = run(verb, hole, "-o", out, "--repair", "--report", self.path("report.json"))
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(self.path("report.json"), encoding="utf-8") as file:
                self.assertIn("hole", " ".join(json.load(file)["notes"]))

    def test_info_says_what_a_repair_would_do(self):
        hole = self.path("hole.off")
        write_off(hole, self.positions, self.triangles[1:])
        done = run("info", hole)
        self.assertRegex(done.stdout, r"repair +1 hole was filled|repair +1 hole")
        self.assertRegex(done.stdout, r"hole of 3 edges, length [0-9.]+ at \(")
        done = run("make", "torus", "-o", self.path("torus.off"), "--resolution", "600")
        self.assertRegex(run("info", self.path("torus.off")).stdout, r"loop of \d+ edges, length [0-9.]+, around \(")


if __name__ == "__main__":
    main()
