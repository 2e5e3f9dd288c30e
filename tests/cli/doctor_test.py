#!/usr/bin/env python3
"""orbicube doctor: what it says agrees with what the command does.

    doctor_test.py COMMAND
"""
import json
import os
import re
import shutil

from command import COMMAND, InFolder, main, run


class Doctor(InFolder):
    def figures(self, **keywords):
        done = run("doctor", "--json", **keywords)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return json.loads(done.stdout)

    def test_the_report_is_the_same_in_both_ways(self):
        path = self.path("doctor.json")
        printed = run("doctor", "--json", "--quiet", "--report", path)
        self.assertEqual((printed.returncode, printed.stderr), (0, ""))
        with open(path, encoding="utf-8") as file:
            written = json.load(file)
        own = json.loads(printed.stdout)
        self.assertEqual(list(own), list(written))
        for key in ("command", "version", "options", "exit_code", "compiler", "verbs", "formats", "components", "missing"):
            self.assertEqual(own[key], written[key], key)
        self.assertEqual((own["command"], own["exit_code"]), ("doctor", 0))

    def test_verbs_and_formats_are_those_of_help(self):
        figures = self.figures()
        self.assertEqual(figures["verbs"], re.findall(r"^  ([a-z]+) ", run("--help").stdout.split("Subcommands:")[1].split("\n\n")[0], re.M))
        for ending in figures["formats"]["surfaces"].split():
            self.assertIn(ending, run("info", "--help").stdout)

    def test_each_missing_component_has_its_price_and_its_remedy(self):
        figures = self.figures()
        text = run("doctor").stdout
        for component in figures["components"]:
            self.assertEqual(component["found"], component["name"] not in figures["missing"])
            self.assertTrue(component["use"])
            self.assertIn(component["kind"], ("library", "module", "program"))
            self.assertEqual(component["kind"] != "library" and component["found"], component["path"] is not None)
            if not component["found"]:
                self.assertTrue(component["without"] and component["install"], component)
                self.assertIn("MISSING: " + component["without"], text)
                self.assertIn("to install: " + component["install"], text)
                self.assertIsNone(component["version"])
        by_name = {component["name"]: component for component in figures["components"]}
        self.assertRegex(by_name["Eigen"]["version"], r"^3\.\d+\.\d+$")
        self.assertEqual(by_name["TetGen"]["found"], "tetrahedralize" in figures["verbs"])

    def test_programs_are_those_of_the_path(self):
        for folders, wanted in ((os.environ.get("PATH", ""), shutil.which("chromium")), (self.folder, None)):
            figures = self.figures(env={**os.environ, "PATH": folders})
            chromium = next(component for component in figures["components"] if component["name"] == "Chromium")
            if wanted:
                self.assertEqual(chromium["path"], wanted)
            if folders == self.folder:
                self.assertIn("Chromium", figures["missing"])
        own = self.path("chromium")
        shutil.copy("/bin/true", own)
        figures = self.figures(env={**os.environ, "PATH": self.folder})
        self.assertEqual(next(c for c in figures["components"] if c["name"] == "Chromium")["path"], own)

    def test_libraries_are_those_that_are_linked(self):
        figures = self.figures()
        with open(COMMAND, "rb") as file:
            program = file.read()
        for name, soname in (("CHOLMOD", b"libcholmod.so"), ("TetGen", b"libtet.so"), ("zlib", b"libz.so"), ("libspng", b"libspng.so"),
                             ("meshoptimizer", b"libmeshoptimizer.so")):
            component = next(c for c in figures["components"] if c["name"] == name)
            self.assertTrue(component["found"] or soname not in program, name)

    def test_the_machine_is_this_one(self):
        machine = self.figures()["machine"]
        self.assertEqual(machine["cores"], len(os.sched_getaffinity(0)))
        with open("/proc/meminfo", encoding="ascii") as file:
            total = int(file.readline().split()[1]) * 1024
        self.assertTrue(0 < machine["memory_bytes"] <= total)
        self.assertTrue(0 < machine["free_memory_bytes"] <= machine["memory_bytes"])


if __name__ == "__main__":
    main()
