#!/usr/bin/env python3
"""scripts/abi.py lets pass what old programs can live with, and nothing else.

    abi_test.py
"""

import copy
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCRIPT = os.path.join(ROOT, "scripts", "abi.py")
HEADER = os.path.join("orbicube", "trust_region.h")


class Gate(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with open(os.path.join(ROOT, "api.json"), encoding="utf-8") as file:
            library = json.load(file)["libraries"]["trust_region"]
        cls.library = library
        cls.folder = tempfile.TemporaryDirectory()
        cls.include, cls.records = os.path.join(cls.folder.name, "include"), os.path.join(cls.folder.name, "records")
        shutil.copytree(os.path.join(ROOT, "capi", "include"), cls.include)
        with open(os.path.join(cls.include, HEADER), encoding="utf-8") as file:
            cls.header = file.read()
        said = cls.run_script(library, "--write")
        assert said.returncode == 0, said.stdout + said.stderr

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def run_script(cls, library, *arguments):
        api = os.path.join(cls.folder.name, "api.json")
        with open(api, "w", encoding="utf-8") as file:
            json.dump({"libraries": {"trust_region": library}}, file)
        return subprocess.run([sys.executable, SCRIPT, "--api", api, "--include", cls.include, "--records", cls.records, *arguments],
                              capture_output=True, text=True, check=False)

    def answer(self, library=None, old="", new=""):
        self.assertIn(old, self.header)
        with open(os.path.join(self.include, HEADER), "w", encoding="utf-8") as file:
            file.write(self.header.replace(old, new, 1) if old else self.header)
        return self.run_script(library or self.library)

    def passes(self, **change):
        said = self.answer(**change)
        self.assertEqual(said.returncode, 0, said.stdout + said.stderr)

    def fails(self, word, **change):
        said = self.answer(**change)
        self.assertEqual(said.returncode, 1, said.stdout + said.stderr)
        self.assertIn(word, said.stderr)

    def without(self, name):
        library = copy.deepcopy(self.library)
        library["functions"] = [function for function in library["functions"] if function["name"] != name]
        return library

    def test_nothing_changed(self):
        self.passes()

    def test_what_is_added_at_the_end_of_options_and_as_a_function_is_compatible(self):
        self.passes(old="} obc_trust_region_options;", new="double more; } obc_trust_region_options;")
        library = copy.deepcopy(self.library)
        library["functions"].append({**self.library["functions"][0], "name": "obc_trust_region_more"})
        self.passes(library=library)

    def test_a_member_in_the_middle_is_not(self):
        self.fails("obc_trust_region_options", old="  double radius_begin;", new="  double before; double radius_begin;")

    def test_another_type_of_a_member_is_not(self):
        self.fails("radius_end", old="  double radius_end;", new="  float radius_end; float padding;")

    def test_a_function_that_is_gone_is_not(self):
        self.fails("obc_trust_region_give", library=self.without("obc_trust_region_give"))

    def test_another_parameter_is_not(self):
        library = copy.deepcopy(self.library)
        give = next(function for function in library["functions"] if function["name"] == "obc_trust_region_give")
        count = next(parameter for parameter in give["parameters"] if parameter["name"] == "count")
        count["type"] = "uint32_t"
        self.fails("obc_trust_region_give", library=library, old="size_t count, obc_error *error);",
                   new="uint32_t count, obc_error *error);")

    def test_with_another_soname_all_is_allowed(self):
        self.passes(library={**self.without("obc_trust_region_give"), "soversion": "1"})


if __name__ == "__main__":
    if shutil.which("abidiff") is None or shutil.which("abidw") is None:
        print("abidiff is missing (Debian: abigail-tools)")
        sys.exit(77)
    unittest.main()
