#!/usr/bin/env python3
"""orbicube study: tables that agree with each other, studies that continue with the same bits, subjects that fail.

    study_test.py COMMAND
"""
import base64
import csv
import html
import json
import math
import os
import re
import shutil
import signal
import struct
import subprocess
import time
import unittest

from command import COMMAND, SANITIZED, Glb, InFolder, main, read_obj, run
from folders import files_in
from surface_test import nrrd, packed

GRID = ("--grid", "icosphere:2")
POINTS = 162


def rows_of(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def point_data(path):
    """The arrays of the points of a binary VTK file with doubles, and its points."""
    with open(path, "rb") as file:
        data = file.read()
    result, at, points = {}, 0, 0
    while at < len(data):
        end = data.index(b"\n", at)
        words = data[at:end].decode("ascii").split()
        at = end + 1
        if words[:1] == ["POINTS"]:
            points, name, count = int(words[1]), "", 3 * int(words[1])
        elif words[:1] == ["POLYGONS"]:
            at += 4 * int(words[2])
            continue
        elif words[:1] == ["SCALARS"]:
            name, count = words[1], points
            at = data.index(b"\n", at) + 1  # LOOKUP_TABLE
        elif words[:1] == ["VECTORS"]:
            name, count = words[1], 3 * points
        else:
            continue
        result[name] = struct.unpack_from(f">{count}d", data, at)
        at += 8 * count
    return result


class Study(InFolder):
    def subjects(self, count=6, resolution=300):
        os.makedirs(self.path("in"), exist_ok=True)
        for seed in range(1, count + 1):
            self.made("creature", resolution, seed, name=f"in/c{seed}.obj")
        return self.path("in")

    def study(self, *arguments, out="out"):
        report = self.path("report.json")
        done = run("study", *arguments, "-o", self.path(out), "--report", report, *GRID)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(report, encoding="utf-8") as file:
            return json.load(file)

    def test_tables_agree_and_a_failing_subject_stops_nothing(self):
        folder = self.subjects()
        with open(os.path.join(folder, "bad.obj"), "w", encoding="ascii") as file:
            file.write("nothing\n")
        with open(os.path.join(folder, "read.me"), "w", encoding="ascii") as file:
            file.write("no surface\n")
        # One subject stands elsewhere, rotated.
        positions, triangles = read_obj(os.path.join(folder, "c1.obj"))
        with open(os.path.join(folder, "moved.obj"), "w", encoding="ascii") as file:
            file.writelines(f"v {-y + 7} {x} {z}\n" for x, y, z in positions)
            file.writelines("f " + " ".join(str(v + 1) for v in t) + "\n" for t in triangles)
        report = self.study(folder)
        self.assertEqual([failed["name"] for failed in report["failed"]], ["bad"])
        self.assertEqual(report["failed"][0]["kind"], "empty-mesh")
        subjects = rows_of(self.path("out/subjects.csv"))
        self.assertEqual([row["name"] for row in subjects], ["bad", "c1", "c2", "c3", "c4", "c5", "c6", "moved"])
        self.assertEqual([row["status"] for row in subjects], ["empty-mesh"] + 7 * ["done"])
        distances, scores = rows_of(self.path("out/distances.csv")), rows_of(self.path("out/scores.csv"))
        names = [row["name"] for row in distances]
        modes = [key for key in scores[0] if key != "name"]
        self.assertIn(len(modes), (5, 6))  # the shape that was moved is the same again, but for its alignment
        for a, x in zip(distances, scores):
            for b, y in zip(names, scores):
                by_modes = math.dist([float(x[m]) for m in modes], [float(y[m]) for m in modes])
                self.assertAlmostEqual(float(a[b]), by_modes / math.sqrt(POINTS), places=9)
        for m in modes:
            self.assertAlmostEqual(sum(float(x[m]) for x in scores), 0, places=9)
        # The shape that was moved is the nearest to what it was.
        to_moved = sorted((float(row["moved"]), row["name"]) for row in distances)
        self.assertEqual({name for _, name in to_moved[:2]}, {"moved", "c1"})
        self.assertLess(to_moved[1][0], 0.01 * to_moved[2][0])
        self.assertAlmostEqual(sum(report["modes"]["fractions"]), 1)
        data = point_data(self.path("out/mean.vtk"))
        self.assertEqual(set(data), {"", "standard_deviation", *(f"mode_{k}" for k in range(1, 6))})
        # The variances of all points are those of all modes.
        self.assertAlmostEqual(sum(x * x for x in data["standard_deviation"]), sum(report["modes"]["variances"]))
        self.assertAlmostEqual(sum(x * x for x in data["mode_1"]), report["modes"]["variances"][0])
        self.assertEqual(run("info", self.path("out/modes.glb")).returncode, 0)
        mean = Glb(self.path("out/mean.glb"), texture=False, targets=False)
        for a, b in zip(mean.positions, zip(*[iter(data[""])] * 3)):
            self.assertLess(math.dist(a, b), 1e-6)
        # Distances from the mean are those of all scores.
        for subject, row in zip(report["subjects"], scores):
            norm = math.hypot(*(float(row[m]) for m in modes))
            self.assertAlmostEqual(subject["distance_from_mean"], norm / math.sqrt(POINTS))

    def test_a_study_goes_on_where_it_was(self):
        folder = self.subjects(4)
        self.assertEqual(self.study(folder)["reused"], 0)
        before = files_in(self.path("out"))
        self.assertEqual(self.study(folder)["reused"], 4)
        self.assertEqual(files_in(self.path("out")), before)
        # What was damaged is made again.
        with open(self.path("out/subjects/c2.ply"), "r+b") as file:
            file.seek(2000)
            file.write(b"damaged")
        with open(self.path("out/subjects/c3.json"), "w", encoding="ascii") as file:
            file.write("{")
        self.assertEqual(self.study(folder)["reused"], 2)
        self.assertEqual(files_in(self.path("out")), before)
        # Another input is another subject, other options are another study.
        self.made("creature", 300, 9, name="in/c4.obj")
        self.assertEqual(self.study(folder)["reused"], 3)
        self.assertEqual(self.study(folder, "--align", "rotation")["reused"], 0)
        self.assertEqual(self.study(folder, "--align", "rotation")["reused"], 4)
        self.made("creature", 300, 10, name="in/c1.obj")
        self.assertEqual(self.study(folder, "--align", "rotation")["reused"], 0)
        self.assertEqual(self.study(folder, "--align", "none")["reused"], 0)
        self.assertEqual(self.study(folder, "--align", "none")["reused"], 4)

    def test_the_same_bits_for_any_number_of_threads(self):
        folder = self.subjects(4)
        self.study(folder, "--threads", 1)
        self.study(folder, "--threads", 3, out="other")
        self.assertEqual(files_in(self.path("out")), files_in(self.path("other")))

    @unittest.skipIf(SANITIZED, "timing")
    def test_a_killed_study_goes_on_with_the_same_bits(self):
        folder = self.subjects(5)
        self.study(folder)
        whole = files_in(self.path("out"))
        for written in (0, 1, 3):
            shutil.rmtree(self.path("out"))
            with subprocess.Popen([COMMAND, "study", folder, "-o", self.path("out"), *GRID, "--quiet"]) as process:
                while process.poll() is None:
                    time.sleep(0.001)
                    place = self.path("out/subjects")
                    if os.path.isdir(place) and sum(n.endswith(".json") for n in os.listdir(place)) >= written:
                        process.send_signal(signal.SIGKILL)
            self.assertGreaterEqual(self.study(folder)["reused"], written)
            self.assertEqual(files_in(self.path("out")), whole)

    def with_failing(self, count=4):
        """Subjects of which the first, and one behind it, cannot be mapped; their names."""
        folder = self.subjects(count)
        self.assertEqual(run("make", "torus", "-o", os.path.join(folder, "a.obj"), "--resolution", 300).returncode, 0)
        with open(os.path.join(folder, "c2b.obj"), "w", encoding="ascii") as file:
            file.write("nothing\n")
        return folder

    def part(self, stage, *arguments, folder="in", out="out", code=0):
        report = self.path("part.json")
        done = run("study", self.path(folder), "-o", self.path(out), "--stage", stage, *arguments, "--report", report, *GRID)
        self.assertEqual(done.returncode, code, done.stderr)
        with open(report, encoding="utf-8") as file:
            return done, json.load(file)

    def test_processes_share_a_study_with_the_same_bits(self):
        folder = self.with_failing()
        whole_report = self.study(folder, out="whole")
        whole = files_in(self.path("whole"))
        done, report = self.part("list")
        names = done.stdout.split()
        self.assertEqual(names, ["a", "c1", "c2", "c2b", "c3", "c4"])
        self.assertEqual([(s["name"], s["file"]) for s in report["list"]], [(n, os.path.join(folder, n + ".obj")) for n in names])
        self.assertFalse(os.path.exists(self.path("out")))
        self.assertEqual(run("study", folder, "--stage", "list", *GRID).stdout.split(), names)
        # In order; then all at the same time, twice each, without a first one.
        _, report = self.part("first")
        self.assertEqual([s["name"] for s in report["subjects"]], ["c1"])
        self.assertEqual([(f["name"], f["kind"]) for f in report["failed"]], [("a", "wrong-genus")])
        self.assertEqual(sorted(os.listdir(self.path("out/subjects"))), ["a.json", "c1.json", "c1.ply"])
        for name in ("c3", "c2b", "c4", "c2"):
            _, report = self.part("subjects", "--subjects", name)
            self.assertEqual({s["name"]: s["reused"] for s in report["subjects"]}, {"c1": True} | ({} if name == "c2b" else {name: False}))
        _, report = self.part("group")
        self.assertEqual(report["reused"], 4)
        self.assertEqual(files_in(self.path("out")), whole)
        for key in ("failed", "modes", "alignment"):
            self.assertEqual(report[key], whole_report[key])
        shutil.rmtree(self.path("out"))
        together = [subprocess.Popen([COMMAND, "study", folder, "-o", self.path("out"), "--stage", "subjects", "--subjects", *some, "--quiet", *GRID])
                    for some in (["c3", "c2"], ["c2b", "c3"], ["c4"], ["c2", "a"])]
        self.assertEqual([process.wait() for process in together], 4 * [0])
        self.part("group")
        self.assertEqual(files_in(self.path("out")), whole)
        # All by one process, and the group without a subject.
        shutil.rmtree(self.path("out"))
        self.part("subjects")
        os.remove(self.path("out/subjects/c3.json"))
        _, report = self.part("group")
        self.assertEqual([(f["name"], f["kind"]) for f in report["failed"]],
                         [("a", "wrong-genus"), ("c2b", "empty-mesh"), ("c3", "no-valid-result")])
        self.assertIn("--stage subjects --subjects c3", report["failed"][2]["message"])
        self.assertEqual(self.study(folder)["reused"], 3)
        self.assertEqual(files_in(self.path("out")), whole)

    def test_no_subject_is_taken_of_a_machine_that_rounds_otherwise(self):
        folder = self.with_failing(3)
        digest = self.part("list")[1]["rounding"]
        self.assertRegex(digest, "^[0-9a-f]{16}$")
        self.study(folder)
        whole = files_in(self.path("out"))
        kept = [json.loads(whole[os.path.join("subjects", f"{name}.json")]) for name in ("a", "c1", "c2", "c2b", "c3")]
        self.assertEqual([k["rounding"] for k in kept], 5 * [digest])

        def change(name):
            path = self.path(f"out/subjects/{name}.json")
            with open(path, encoding="utf-8") as file:
                text = file.read()
            with open(path, "w", encoding="utf-8") as file:
                file.write(text.replace(digest, "0123456789abcdef"))

        # Another subject than the first one is made again, by a process that maps subjects.
        change("c3")
        stages = ("-o", self.path("out"), *GRID, "--stage")
        line = self.refused(1, "unsupported", os.path.join(folder, "c3.obj"), "study", folder, *stages, "group")
        self.assertIn(f"digest 0123456789abcdef, here {digest}", line)
        report = self.part("subjects", "--subjects", "c2", "c3")[1]
        self.assertEqual([s["reused"] for s in report["subjects"]], [True, True, False])
        self.assertTrue(any("1 subject of the study before was mapped on a machine whose" in note for note in report["notes"]), report["notes"])
        # The first one is not, where others have been mapped as well; nor is what failed before it.
        for name in ("c1", "a"):
            change(name)
            for stage in (("group",), ("subjects", "--subjects", "c2")):
                self.refused(1, "unsupported", os.path.join(folder, f"{name}.obj"), "study", folder, *stages, *stage)
            self.assertEqual([s["reused"] for s in self.part("first")[1]["subjects"]], [name == "a"])
            self.assertEqual(self.study(folder)["reused"], 3)
            self.assertEqual(files_in(self.path("out")), whole)

    def test_the_digest_of_rounding_is_that_of_the_functions(self):
        folder = self.subjects(2)
        tunables = {**os.environ, "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-FMA,-FMA_Usable,-AVX2,-AVX2_Usable,-FMA4,-FMA4_Usable"}
        digest = self.part("list")[1]["rounding"]
        self.study(folder)
        self.assertEqual(run("study", folder, "--stage", "list", "--report", self.path("other.json"), env=tunables).returncode, 0)
        with open(self.path("other.json"), encoding="utf-8") as file:
            other = json.load(file)["rounding"]
        if other == digest:
            self.skipTest("glibc has no other functions for processors without FMA here")
        line = self.refused(1, "unsupported", os.path.join(folder, "c1.obj"), "study", folder, "-o", self.path("out"), "--stage", "group", *GRID, env=tunables)
        self.assertIn(f"digest {digest}, here {other}", line)
        done = run("study", folder, "-o", self.path("out"), *GRID, env=tunables)
        self.assertIn("2 subjects of the study before were mapped on a machine whose elementary functions round otherwise", done.stdout)
        self.assertEqual(self.study(folder)["reused"], 0)
        self.assertEqual(self.study(folder)["reused"], 2)

    def test_what_cannot_be_mapped_is_found_once(self):
        folder = self.with_failing(2)
        self.study(folder)
        whole = files_in(self.path("out"))
        with open(self.path("out/subjects/a.json"), encoding="utf-8") as file:
            kept = json.load(file)
        self.assertEqual(kept["failed"]["kind"], "wrong-genus")
        written = os.stat(self.path("out/subjects/a.json")).st_ino
        self.study(folder)
        self.assertEqual(os.stat(self.path("out/subjects/a.json")).st_ino, written)
        self.assertEqual(files_in(self.path("out")), whole)
        # Damaged files are made again.
        kept["failed"]["message"] = "another"
        with open(self.path("out/subjects/a.json"), "w", encoding="utf-8") as file:
            json.dump(kept, file)
        self.study(folder)
        self.assertEqual(files_in(self.path("out")), whole)
        self.made("creature", 300, 9, name="in/a.obj")
        self.assertEqual([f["name"] for f in self.study(folder)["failed"]], ["c2b"])
        self.assertTrue(os.path.exists(self.path("out/subjects/a.ply")))
        shutil.copy(self.path("in/c2b.obj"), self.path("in/a.obj"))
        self.assertEqual([f["name"] for f in self.study(folder)["failed"]], ["a", "c2b"])
        self.assertFalse(os.path.exists(self.path("out/subjects/a.ply")))

    def test_a_part_says_what_may_pass(self):
        folder = self.subjects(2)
        table = self.path("list.csv")
        with open(table, "w", encoding="ascii") as file:
            file.write("file\nin/missing.obj\nin/c1.obj\nin/c2.obj\n")
        missing = os.path.join(self.folder, "in/missing.obj")
        self.part("first", folder="list.csv")
        self.part("subjects", "--subjects", "c2", folder="list.csv")
        self.refused(1, "io", missing, "study", table, "-o", self.path("out"), "--stage", "subjects", "--subjects", "c2", "missing", *GRID)
        self.assertEqual(sorted(os.listdir(self.path("out/subjects"))), ["c1.json", "c1.ply", "c2.json", "c2.ply"])
        _, report = self.part("group", folder="list.csv")
        self.assertEqual([(f["name"], f["kind"]) for f in report["failed"]], [("missing", "io")])
        self.refused(1, "no-valid-result", os.path.join(folder, "c1.obj"), "study", folder, "-o", self.path("none"), "--stage", "group", *GRID)
        self.refused(2, "invalid-argument", folder, "study", folder, "-o", self.path("out"), "--stage", "subjects", "--subjects", "c11")
        for wrong, text in ((("-o", self.path("out"), "--subjects", "c1"), "--subjects is for --stage subjects"), ((), "--output is required")):
            done = run("study", folder, *wrong)
            self.assertEqual((done.returncode, text in done.stderr), (2, True), done.stderr)

    def test_a_table_names_the_subjects(self):
        self.subjects(3)
        shutil.move(self.path("in/c2.obj"), self.path("in/c,2.obj"))
        shutil.copytree(self.path("in"), self.path("in/more"))
        with open(self.path("list.csv"), "w", encoding="utf-8") as file:
            file.write('age, file\r\n3,in/c3.obj\n\n4,"in/c,2.obj"\n5,in/more/c3.obj\n')
        report = self.study(self.path("list.csv"))
        self.assertEqual([s["name"] for s in report["subjects"]], ["c3", "c,2", "c3-2"])
        distances = rows_of(self.path("out/distances.csv"))
        self.assertAlmostEqual(float(distances[0]["c3-2"]), 0, places=9)
        self.assertGreater(float(distances[0]["c,2"]), 0.01)

    def grown(self, count):
        """Copies of a shape, of which every second has one side pulled out, more with each; the table of them."""
        positions, triangles = read_obj(self.made("sphere", 300))
        rows = []
        for i in range(count):
            far = 0.3 * (i % 2) + 0.01 * math.sin(5 * i)
            with open(self.path(f"s{i}.obj"), "w", encoding="ascii") as file:
                for x, y, z in positions:
                    away = 1 + far * max(0, z) ** 4 + 0.01 * math.sin(3 * x + i) + 0.2 * max(0, x) ** 2 + 0.1 * y
                    file.write(f"v {1.5 * x * away} {1.2 * y * away} {z * away}\n")
                file.writelines("f " + " ".join(str(v + 1) for v in t) + "\n" for t in triangles)
            rows.append(f"s{i}.obj,{'patient' if i % 2 else 'control'},{10 * far + 50}")
        table = self.path("list.csv")
        with open(table, "w", encoding="ascii") as file:
            file.write("file,diagnosis,age\n" + "\n".join(rows) + "\n")
        return table

    def test_groups_and_covariates_are_tested(self):
        table = self.grown(8)
        report = self.study(table, "--align", "rotation", "--placement", "kept", "--groups", "diagnosis", "--covariate", "age",
                            "--permutations", 69)
        groups, age = report["groups"], report["covariate"]
        self.assertEqual((groups["values"], groups["subjects"]), (["control", "patient"], [4, 4]))
        data = point_data(self.path("out/mean.vtk"))
        points = [data[""][i:i + 3] for i in range(0, 3 * POINTS, 3)]
        top = max(range(POINTS), key=lambda v: points[v][2])
        for name in ("group", "covariate"):
            self.assertEqual(len(data[f"{name}_t2"]), POINTS)
            for p, q, wise in zip(data[f"{name}_p"], data[f"{name}_q"], data[f"{name}_p_family_wise"]):
                self.assertTrue(1 / 70 - 1e-12 <= p <= q + 1e-12 and q <= 1 and p <= wise <= 1, (p, q, wise))
            self.assertLess(data[f"{name}_p"][top], 0.1)
        difference, slope = data["group_difference"], data["covariate_slope"]
        self.assertGreater(difference[3 * top + 2], 0.2)  # the patients' minus the controls'
        self.assertAlmostEqual(slope[3 * top + 2], difference[3 * top + 2] / 3, delta=0.02)
        self.assertEqual(groups["min_q"], min(data["group_q"]))
        self.assertEqual(age["min_p_family_wise"], min(data["covariate_p_family_wise"]))
        out = self.path("out")
        self.assertIn("--groups: there is no column 'none'; there are 'age', 'diagnosis'",
                      self.refused(2, "invalid-argument", table, "study", table, "-o", out, "--groups", "none"))
        self.refused(2, "invalid-argument", table, "study", table, "-o", out, "--groups", "age")
        self.refused(2, "invalid-argument", table, "study", table, "-o", out, "--covariate", "diagnosis")
        done = run("study", table, "-o", out, "--permutations", 5)
        self.assertEqual((done.returncode, "--permutations is for --groups and --covariate" in done.stderr), (2, True), done.stderr)

    def test_the_page_holds_the_study_and_loads_nothing(self):
        table = self.grown(8)
        with open(table, "a", encoding="ascii") as file:
            file.write("no </script> surface.obj,control,1\n")
        report = self.study(table, "--align", "rotation", "--groups", "diagnosis", "--permutations", 69)
        path = self.path("out/study.html")
        with open(path, encoding="utf-8") as file:
            page = file.read()
        self.assertIsNone(re.search(r"https?://(?!www\.w3\.org/2000/svg)|@[A-Z]+@", page))
        study = json.loads(re.search(r'<script type="application/json" id="results">(.*)</script>', page).group(1))
        self.assertEqual(study["first_map"], "group_q")
        self.assertEqual([s["name"] for s in study["shifts"]], [f"Mode {k}" for k in range(1, 6)] + ["patient minus control"])
        self.assertEqual([s["values"][0] for s in study["subjects"]], 4 * ["control", "patient"])
        self.assertEqual([s["distance"] for s in study["subjects"]], [s["distance_from_mean"] for s in report["subjects"]])
        self.assertEqual([f["name"] for f in study["failed"]], ["script> surface"])  # behind the slash
        self.assertEqual(study["fractions"], report["modes"]["fractions"])
        data = point_data(self.path("out/mean.vtk"))
        for numbers, values in [(study["mean"], data[""]), *((m, data[m["name"]]) for m in study["maps"]),
                                *((s, data[s["id"]]) for s in study["shifts"])]:
            steps = struct.unpack(f"<{len(values)}H", base64.b64decode(numbers["values"]))
            for value, step in zip(values, steps):
                self.assertAlmostEqual(numbers["low"] + numbers["step"] * step, value, delta=0.51 * numbers["step"] + 1e-12)
        browser = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
        if browser is None or SANITIZED:
            return
        done = subprocess.run([browser, "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", f"--user-data-dir={self.path('profile')}",
                               "--enable-logging=stderr", "--window-size=1200,900", "--virtual-time-budget=10000", "--use-angle=swiftshader",
                               "--enable-unsafe-swiftshader", "--dump-dom", f"file://{path}#check"],
                              capture_output=True, text=True, timeout=240)
        self.assertEqual([line for line in done.stderr.splitlines() if "CONSOLE" in line], [])
        shown = json.loads(html.unescape(re.search(r'data-check="([^"]*)"', done.stdout).group(1)))
        self.assertEqual(len(shown["frames"]), len(study["maps"]) + 2)
        self.assertEqual(len(shown["moved"]), len(study["shifts"]))
        for frame in shown["frames"] + shown["moved"]:
            self.assertEqual(frame["error"], 0, frame)
            self.assertTrue(0.05 < frame["drawn"] < 0.9 and frame["colors"] > 20, frame)

    def test_label_images_are_subjects(self):
        size = (16, 14, 12)
        os.makedirs(self.path("in"))
        for i, radius in enumerate((5.5, 4.5, 5.0)):
            labels = [2 if ((x - 7.5) / radius)**2 + ((y - 6.5) / 4.5)**2 + ((z - 5.5) / 4)**2 < 1 else 0
                      for z in range(size[2]) for y in range(size[1]) for x in range(size[0])]
            labels[0] = 7
            with open(self.path(f"in/s{i}.nrrd"), "wb") as file:
                file.write(nrrd(sizes=size) + packed("h", "<", labels))
        # One of them as the surface that the other verb makes.
        done = run("surface", self.path("in/s2.nrrd"), "-o", self.path("in/s3.ply"), "--label", 2)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        report = self.study(self.path("in"), "--align", "rotation", "--label", 2)
        self.assertEqual([s["name"] for s in report["subjects"]], ["s0", "s1", "s2", "s3"])
        distances = rows_of(self.path("out/distances.csv"))
        self.assertLess(float(distances[2]["s3"]), 1e-9)
        self.assertGreater(float(distances[0]["s1"]), 0.1)
        self.assertEqual(self.study(self.path("in"), "--align", "rotation", "--label", 2)["reused"], 4)
        self.assertEqual(run("study", self.path("in"), "-o", self.path("out"), "--label", 3, *GRID).returncode, 1)
        for name in ("s0", "s1", "s2"):
            os.remove(self.path(f"in/{name}.nrrd"))
        self.subjects(2)
        self.refused(2, "usage", self.path("in"), "study", self.path("in"), "-o", self.path("out"), "--label", 2)

    def test_wrong_requests_are_refused(self):
        folder = self.subjects(1)
        self.refused(2, "invalid-argument", folder, "study", folder, "-o", self.path("out"))
        self.refused(2, "io", self.path("none"), "study", self.path("none"), "-o", self.path("out"))
        self.subjects(2)
        self.refused(2, "usage", folder, "study", folder, "-o", folder)
        self.refused(2, "io", self.path("a/b"), "study", folder, "-o", self.path("a/b"))
        table = self.path("list.csv")
        for text in ("name\nin/c1.obj\n", "file,age\nin/c1.obj\n", "file,age,age\nin/c1.obj,1,2\n", "file,file\nin/c1.obj,in/c2.obj\n", 'file\n"in/c1.obj\n', "file\n\0\n"):
            with open(table, "w", encoding="ascii") as file:
                file.write(text)
            self.refused(2, "parse", table, "study", table, "-o", self.path("out"))
        with open(table, "w", encoding="ascii") as file:
            file.write("file\nin/c1.obj\nin/missing.obj\n")
        self.refused(1, "no-valid-result", os.path.join(self.folder, "in/missing.obj"), "study", table, "-o", self.path("out"), *GRID)


if __name__ == "__main__":
    main()
