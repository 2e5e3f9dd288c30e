#!/usr/bin/env python3
"""orbicube study: tables that agree with each other, studies that continue with the same bits, subjects that fail.

    study_test.py COMMAND
"""
import csv
import json
import math
import os
import shutil
import signal
import struct
import subprocess
import time
import unittest

from command import COMMAND, SANITIZED, InFolder, main, read_obj, run

GRID = ("--grid", "icosphere:2")
POINTS = 162


def rows_of(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def files_in(folder):
    """The bytes of all files, by name."""
    result = {}
    for place, _, names in os.walk(folder):
        for name in names:
            with open(os.path.join(place, name), "rb") as file:
                result[os.path.relpath(os.path.join(place, name), folder)] = file.read()
    return result


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
        self.assertEqual(len(modes), 6)
        for a, x in zip(distances, scores):
            for b, y in zip(names, scores):
                by_modes = math.dist([float(x[m]) for m in modes], [float(y[m]) for m in modes])
                self.assertAlmostEqual(float(a[b]), by_modes / math.sqrt(POINTS), places=9)
        for m in modes:
            self.assertAlmostEqual(sum(float(x[m]) for x in scores), 0, places=9)
        # The shape that was moved is the nearest to what it was.
        to_moved = sorted((float(row["moved"]), row["name"]) for row in distances)
        self.assertEqual([name for _, name in to_moved[:2]], ["moved", "c1"])
        self.assertLess(to_moved[1][0], 0.5 * to_moved[2][0])
        self.assertAlmostEqual(sum(report["modes"]["fractions"]), 1)
        data = point_data(self.path("out/mean.vtk"))
        self.assertEqual(set(data), {"", "standard_deviation", *(f"mode_{k}" for k in range(1, 6))})
        # The variances of all points are those of all modes.
        self.assertAlmostEqual(sum(x * x for x in data["standard_deviation"]), sum(report["modes"]["variances"]))
        self.assertAlmostEqual(sum(x * x for x in data["mode_1"]), report["modes"]["variances"][0])
        self.assertEqual(run("info", self.path("out/modes.glb")).returncode, 0)

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
        self.refused(2, "invalid-argument", table, "study", table, "-o", out, "--groups", "none")
        self.refused(2, "invalid-argument", table, "study", table, "-o", out, "--groups", "age")
        self.refused(2, "invalid-argument", table, "study", table, "-o", out, "--covariate", "diagnosis")
        done = run("study", table, "-o", out, "--permutations", 5)
        self.assertEqual((done.returncode, "--permutations is for --groups and --covariate" in done.stderr), (2, True), done.stderr)

    def test_wrong_requests_are_refused(self):
        folder = self.subjects(1)
        self.refused(2, "invalid-argument", folder, "study", folder, "-o", self.path("out"))
        self.refused(2, "io", self.path("none"), "study", self.path("none"), "-o", self.path("out"))
        self.subjects(2)
        self.refused(2, "usage", folder, "study", folder, "-o", folder)
        self.refused(2, "io", self.path("a/b"), "study", folder, "-o", self.path("a/b"))
        table = self.path("list.csv")
        for text in ("name\nin/c1.obj\n", "file,age\nin/c1.obj\n", 'file\n"in/c1.obj\n', "file\n\0\n"):
            with open(table, "w", encoding="ascii") as file:
                file.write(text)
            self.refused(2, "parse", table, "study", table, "-o", self.path("out"))
        with open(table, "w", encoding="ascii") as file:
            file.write("file\nin/c1.obj\nin/missing.obj\n")
        self.refused(1, "no-valid-result", os.path.join(self.folder, "in/missing.obj"), "study", table, "-o", self.path("out"), *GRID)


if __name__ == "__main__":
    main()
