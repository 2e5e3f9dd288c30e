#!/usr/bin/env python3
"""orbicube view: the page holds what the files hold, loads nothing, and its
size is within twice the binary mesh.

    view_test.py COMMAND
"""
import base64
import itertools
import json
import math
import os
import re
import shutil
import stat
import struct
import subprocess
import sys
import unittest

from command import COMMAND, InFolder, main, run

BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


def data_of(path):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    return text, json.loads(re.search(r'<script type="application/json" id="results">(.*?)</script>', text, re.S).group(1))


def numbers(text, width):
    data = base64.b64decode(text)
    return [int.from_bytes(data[i:i + width], "little") for i in range(0, len(data), width)]


def positions(item):
    steps = numbers(item["positions"], 3)
    return [tuple(item["low"][k] + item["step"] * steps[i + k] for k in range(3)) for i in range(0, len(steps), 3)]


def lists(item, name, corners):
    flat = numbers(item[name], item["width"])
    return [tuple(flat[i:i + corners]) for i in range(0, len(flat), corners)]


def write_grid(path, n, bend=0.0, tetrahedra=False):
    """A bent cube of n^3 hexahedra, or of six tetrahedra for each."""
    at = lambda x, y, z: 1 + x + (n + 1) * (y + (n + 1) * z)
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    pieces = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)]
    cells = []
    for z, y, x in itertools.product(range(n), repeat=3):
        hexahedron = [at(x + a, y + b, z + c) for a, b, c in corners]
        cells += [[hexahedron[i] for i in piece] for piece in pieces] if tetrahedra else [hexahedron]
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"MeshVersionFormatted 2\nDimension 3\nVertices\n{(n + 1) ** 3}\n")
        for z, y, x in itertools.product(range(n + 1), repeat=3):
            file.write(f"{100 + x + bend * y * y / n} {y} {z} 0\n")
        file.write(f"{'Tetrahedra' if tetrahedra else 'Hexahedra'}\n{len(cells)}\n")
        file.writelines(" ".join(map(str, cell)) + " 0\n" for cell in cells)
        file.write("End\n")
    return path


class View(InFolder):
    def page(self, *files, options=()):
        out = self.path("out.html")
        done = run("view", *files, "-o", out, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return data_of(out)

    def test_the_page_holds_the_mesh(self):
        surface = self.made("torus", 900, name="torus.obj")
        text, data = self.page(surface)
        item, = data["items"]
        with open(surface, encoding="utf-8") as file:
            lines = [line.split() for line in file]
        vertices = [tuple(map(float, line[1:4])) for line in lines if line and line[0] == "v"]
        triangles = [tuple(int(word.split("/")[0]) - 1 for word in line[1:4]) for line in lines if line and line[0] == "f"]
        self.assertEqual(lists(item, "triangles", 3), triangles)
        self.assertTrue(all(abs(a - b) <= 0.51 * item["step"] for p, q in zip(positions(item), vertices) for a, b in zip(p, q)))
        self.assertEqual(dict(map(tuple, item["figures"]))["Genus"], "1")
        # Nothing is loaded, and nothing leaves its place.
        self.assertIn("default-src 'none'", text)
        self.assertNotRegex(text, r"""(src|href)=["'](?!data:,)""")
        self.assertNotRegex(text, r"https?://|fetch\(|XMLHttpRequest|@import|url\(")
        hostile, _ = self.page(surface, options=("--title", "</script><b>x"))
        self.assertEqual(hostile.count("</script>"), 2)
        self.assertNotIn("<b>x", hostile)

    def test_size_is_within_twice_the_binary_mesh(self):
        surface = self.made("creature", 20000, name="c.ply")
        self.page(surface)
        self.assertLess(os.path.getsize(self.path("out.html")), 2 * os.path.getsize(surface))
        hexes = write_grid(self.path("h.mesh"), 16)
        self.page(hexes)
        # 24 bytes a vertex and 36 a hexahedron in binary VTK
        self.assertLess(os.path.getsize(self.path("out.html")), 2 * (24 * 17**3 + 36 * 16**3))

    def test_maps_of_gltf_files_are_targets(self):
        made = self.made("creature", 600, name="c.obj")
        self.assertEqual(run("sphere", made, "-o", self.path("c.glb"), "--quiet").returncode, 0)
        _, data = self.page(self.path("c.glb"))
        target, = data["items"][0]["targets"]
        self.assertEqual(target["name"], "sphere")
        used = set(itertools.chain(*lists(data["items"][0], "triangles", 3)))
        self.assertTrue(all(abs(math.hypot(*positions(target)[v]) - 1) < 1e-5 for v in used))

    def test_frame_fields_have_singular_curves(self):
        tets = write_grid(self.path("t.mesh"), 3, tetrahedra=True)
        self.assertEqual(run("frames", tets, "-o", self.path("t.frames"), "--quiet").returncode, 0)
        _, data = self.page(tets, self.path("t.frames"))
        self.assertEqual(len(data["items"]), 1)
        self.assertEqual([curve["edges"] for curve in data["items"][0]["curves"]], ["", "", ""])  # a cube has none
        self.refused(2, "usage", self.path("t.frames"), "view", self.path("t.frames"), "-o", self.path("x.html"))
        self.refused(2, "no-cells", self.path("t.frames"), "view", self.made("torus", 300, name="s.obj"), self.path("t.frames"),
                     "-o", self.path("x.html"))

    def test_mistakes(self):
        surface = self.made("torus", 300, name="torus.obj")
        out = self.path("out.html")
        for words in (("--size", "100x100"), ("--size", "axb", "--png", self.path("o.png")), ("--size", "99999999999x9", "--png", out)):
            done = run("view", surface, "-o", out, *words)
            self.assertEqual((done.returncode, "usage" in done.stderr), (2, True), done.stderr)
        self.assertFalse(os.path.exists(out))
        empty = dict(os.environ, PATH=self.path("nowhere"))
        done = subprocess.run([COMMAND, "view", surface, "--png", self.path("o.png")], capture_output=True, text=True, env=empty, timeout=60)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no chromium, chromium-browser or google-chrome in PATH", done.stderr)
        done = subprocess.run([COMMAND, "view", surface], capture_output=True, text=True, env=empty, timeout=60)
        self.assertEqual(done.returncode, 1)
        self.assertIn("xdg-open", done.stderr)

    def test_a_browser_is_opened(self):
        os.makedirs(self.path("bin"))
        opener = self.path("bin/xdg-open")
        with open(opener, "w", encoding="utf-8") as file:
            file.write(f'#!/bin/sh\nmv "$1" "{self.path("page.html")}.part"\nmv "{self.path("page.html")}.part" "{self.path("page.html")}"\n')
        os.chmod(opener, stat.S_IRWXU)
        environment = dict(os.environ, PATH=self.path("bin") + os.pathsep + os.environ["PATH"], TMPDIR=self.path("."))
        done = subprocess.run([COMMAND, "view", self.made("torus", 300, name="torus.obj")], capture_output=True, text=True,
                              env=environment, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        for _ in range(200):
            if os.path.exists(self.path("page.html")):
                break
            subprocess.run(["sleep", "0.05"], check=True)
        self.assertEqual(len(data_of(self.path("page.html"))[1]["items"]), 1)

    def test_no_program_beside_the_files_is_started(self):
        surface = self.made("torus", 300, name="torus.obj")
        for name in ("chromium", "xdg-open"):
            with open(self.path(name), "w", encoding="utf-8") as file:
                file.write("#!/bin/sh\ntouch started\n")
            os.chmod(self.path(name), stat.S_IRWXU)
        for folders in (".", "", ":", f"nowhere:{os.path.basename(self.folder)}/.."):
            for words in (("--png", "o.png"), ()):
                done = subprocess.run([COMMAND, "view", surface, *words], capture_output=True, text=True, cwd=self.folder,
                                      env=dict(os.environ, PATH=folders), timeout=60)
                self.assertEqual(done.returncode, 1, folders)
                self.assertIn("in PATH", done.stderr)
        self.assertFalse(os.path.exists(self.path("started")))

    def test_the_browser_finds_the_page_in_any_folder(self):
        odd = self.path("a#b?c d%41é")
        os.makedirs(odd)
        os.makedirs(self.path("bin"))
        browser = self.path("bin/chromium")
        with open(browser, "w", encoding="utf-8") as file:
            file.write(f"""#!{sys.executable}
import sys, urllib.parse
address = urllib.parse.urlsplit(sys.argv[-1])
assert (address.scheme, address.netloc, address.query, address.fragment) == ("file", "", "", "")
with open(urllib.parse.unquote(address.path), "rb") as page:
    assert b"</html>" in page.read()
picture = [word for word in sys.argv if word.startswith("--screenshot=")][0].split("=", 1)[1]
with open(picture, "wb") as file:
    file.write(b"picture")
""")
        os.chmod(browser, stat.S_IRWXU)
        for folder in (odd, os.path.basename(odd)):
            environment = dict(os.environ, PATH=self.path("bin") + os.pathsep + os.environ["PATH"], TMPDIR=folder)
            done = subprocess.run([COMMAND, "view", self.made("torus", 300, name="torus.obj"), "--png", self.path("o.png")],
                                  capture_output=True, text=True, cwd=self.folder, env=environment, timeout=60)
            self.assertEqual((done.returncode, done.stderr), (0, ""), folder)
            with open(self.path("o.png"), "rb") as file:
                self.assertEqual(file.read(), b"picture")
            self.assertEqual(os.listdir(odd), [])

    @unittest.skipUnless(BROWSER, "there is no chromium")
    def test_pictures(self):
        hexes = write_grid(self.path("h.mesh"), 3, bend=0.4)
        done = run("view", hexes, "--png", self.path("h.png"), "--size", "400x300", "--preset", "theme=light")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("h.png"), "rb") as file:
            head = file.read(24)
        self.assertEqual(head[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", head[16:]), (400, 300))
        self.assertGreater(os.path.getsize(self.path("h.png")), 5000)  # a picture of one color has about 1 KB


if __name__ == "__main__":
    main()
