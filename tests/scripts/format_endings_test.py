"""The tables of formats are the only lists of file endings: libs/mesh/formats/formats.cpp, and form.cpp of gltf for its own.

    format_endings_test.py ROOT

Fails where a source file of libs, cli, capi or bindings writes an ending in a string, or two endings in a row anywhere, and
where docs/file_formats.md has other endings than the tables. A file name ("creature.obj") is no ending. Left out: the
tables, tests, and bindings/*/raw, which scripts/bindings.py writes from the headers."""

import os
import re
import sys
import unittest

ROOT = sys.argv.pop()
TABLES = {"libs/mesh/formats/formats.cpp", "libs/mesh/formats/formats.h", "libs/gltf/writing/form.cpp"}
SOURCES = (".cpp", ".h", ".hpp", ".py", ".rs", ".jl", ".js", ".mjs", ".ts")
# Strings on one line, and the texts in triple quotes of Python and Julia.
STRING = re.compile(r'"""[\s\S]*?"""|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)*\'|`(?:[^`\\\n]|\\.)*`')


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def rows():
    """Ending, and whether its files hold cells, of each row of the table of mesh formats."""
    found = re.findall(r'FormatRow\{Format::\w+,\s*"(\.\w+)",\s*"\w+",\s*\w+,\s*(\w+),', read("libs/mesh/formats/formats.cpp"))
    return {ending: cells == "true" for ending, cells in found}


def gltf_endings():
    return re.findall(r'_ending = "(\.\w+)"', read("libs/gltf/writing/form.cpp"))


def sources():
    for top in ("libs", "cli", "capi/src", "capi/include", "bindings"):
        for folder, _, names in os.walk(os.path.join(ROOT, top)):
            for name in names:
                path = os.path.relpath(os.path.join(folder, name), ROOT)
                if name.endswith(SOURCES) and path not in TABLES and not re.search(r"(^|/)(raw|node_modules|orbicube-sys|target|tests?)/", path):
                    yield path


def lists_in(text, endings):
    """Each place where a text lists endings: the line and what is written there."""
    any_of = "|".join(re.escape(ending[1:]) for ending in endings)
    ending = rf"(?<![\w)\]}}*/])\.(?:{any_of})\b(?![.(])"
    found = []
    for string in STRING.finditer(text):
        found += [string.start() + one.start() for one in re.finditer(ending, string.group())]
    found += [one.start() for one in re.finditer(rf"{ending}(?:[\s,`'\"]|and|or){{1,6}}{ending}", text)]
    return [(text.count("\n", 0, at) + 1, text[at:at + 20].split("\n")[0]) for at in sorted(set(found))]


class Endings(unittest.TestCase):
    def test_the_tables_are_read(self):
        self.assertEqual(sorted(rows()), [".gii", ".inp", ".mesh", ".msh", ".obj", ".off", ".ply", ".stl", ".vtk", ".vtp", ".vtu", ".white"])
        self.assertEqual(gltf_endings(), [".glb", ".gltf"])

    def test_what_counts_as_a_list(self):
        endings = [".obj", ".mesh", ".vtk"]
        for text in ('"cells to write: .mesh"', "x == '.obj'", "// reads .obj .vtk", '"""Writes `.obj` and `.vtk`."""'):
            self.assertTrue(lists_in(text, endings), text)
        for text in ('"creature.obj"', "made.mesh.positions", '"FILE.vtk"', "input\n    .mesh(.obj)", "// MEDIT .mesh (Frey 2001)"):
            self.assertFalse(lists_in(text, endings), text)

    def test_no_other_list_in_the_sources(self):
        endings = [*rows(), *gltf_endings()]
        paths = sorted(sources())
        self.assertGreater(len(paths), 500)
        # Members of a JSON text that are called as an ending is.
        allowed = {("libs/gltf/reading/scene.cpp", '.mesh"'), ("libs/gltf/kept/kept.cpp", '.mesh"')}
        found = [f"{path}:{line}: {text}" for path in paths for line, text in lists_in(read(path), endings)
                 if (path, text.split(")")[0]) not in allowed]
        self.assertEqual(found, [], "take endings from the table: mesh::format_endings, obc_mesh_format_ending")

    def test_the_page_of_file_formats(self):
        listed = {}
        for line in read("docs/file_formats.md").splitlines():
            if line.startswith("| `.") and ("mesh_formats.md" in line or "(gltf.md" in line):
                for ending in re.findall(r"`(\.\w+)`", line.split("|")[1]):
                    listed[ending] = "hexahedra" in line
        self.assertEqual(listed, {**rows(), **{ending: False for ending in gltf_endings()}})


if __name__ == "__main__":
    unittest.main()
