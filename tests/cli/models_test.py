#!/usr/bin/env python3
"""The command on the files of ORBICUBE_MODELS: every malformed file ends as its line in bad/bad.tsv says, and the smaller
real shapes are mapped. Skipped without that folder.

    models_test.py COMMAND
"""
import os
import re
import subprocess
import sys
import tempfile

from command import InFolder, kind_of, main, not_positive, processor_seconds, read_obj, run

MODELS = os.environ.get("ORBICUBE_MODELS", "")
SECONDS = 2.0  # of the processor: machines may have other things to do
# What a shape is like is no fault of its file: `info` tells it and ends well.
SHAPES = {"not-closed", "non-manifold-edge", "non-manifold-vertex", "inconsistent-orientation", "non-orientable",
          "not-connected", "duplicate-face", "wrong-genus", "degenerate-face", "degenerate-geometry"}
CELLS = {"degenerate-cell", "inverted-cell", "duplicate-cell", "non-manifold-face", "no-cells"}


def rows(path):
    with open(path, encoding="utf-8") as file:
        return [line.rstrip("\n").split("\t") for line in file][1:]


class BadFiles(InFolder):
    def test_every_file_ends_as_its_line_says(self):
        folder = os.path.join(MODELS, "bad")
        wrong = []
        for name, expected, kinds, _ in rows(os.path.join(folder, "bad.tsv")):
            if expected == "n/a":
                continue
            path = os.path.join(folder, name)
            allowed = set(re.findall(r"[a-z]+(?:-[a-z]+)*", kinds)) - {"or", "accept"}
            ends = {}
            for verb in (("info", path), ("sphere", path, "-o", self.path("out.obj"))):
                start = processor_seconds()
                try:
                    done = run(*verb, timeout=60)
                except subprocess.TimeoutExpired:
                    wrong.append(f"{verb[0]} {name}: does not end")
                    break
                seconds = processor_seconds() - start
                if seconds > SECONDS:
                    wrong.append(f"{verb[0]} {name}: {seconds:.1f} s")
                kind = kind_of(done.stderr.strip(), path) if done.returncode else ""
                ends[verb[0]] = (done.returncode, kind)
            if len(ends) < 2:
                continue
            (info_code, info_kind), (code, kind) = ends["info"], ends["sphere"]
            if expected == "reject":
                # "degenerate" stands for each of the kinds that begin so.
                good = code == 2 and (kind in allowed or ("degenerate" in allowed and kind.startswith("degenerate")))
            elif expected == "accept":
                good = code == 0
            else:
                good = code == 0 or (code == 2 and (kind in allowed or kind in SHAPES | CELLS | {"unsupported"}))
            if kind in SHAPES:
                # A reader may refuse it as well, when it cannot even hold it.
                good = good and (info_code == 0 or info_kind == kind)
            elif kind not in CELLS | {"unsupported", "non-manifold-edge"}:
                good = good and (info_code, info_kind) == (code, kind)
            if not good:
                wrong.append(f"{name} ({expected} {kinds}): info {info_code} {info_kind}, sphere {code} {kind}")
        self.assertEqual(wrong, [])


class RealShapes(InFolder):
    def test_smaller_shapes_are_mapped_one_to_one(self):
        folder = os.path.join(MODELS, "dev")
        mapped = 0
        for name, category, vertices, _, genus, *_ in rows(os.path.join(folder, "models.tsv")):
            if category not in ("g0", "cad") or genus != "0" or int(vertices) > 6000:
                continue
            out = self.path("map.obj")
            done = run("sphere", os.path.join(folder, name), "-o", out)
            self.assertEqual((done.returncode, done.stderr), (0, ""), name)
            directions, triangles = read_obj(out)
            self.assertEqual(len(directions), int(vertices), name)
            self.assertEqual(not_positive(directions, triangles), 0, name)
            self.assertEqual(run("sphere", os.path.join(folder, name), "-o", self.path("map.glb")).returncode, 0, name)
            mapped += 1
        self.assertGreater(mapped, 3)


if __name__ == "__main__":
    if not os.path.isdir(os.path.join(MODELS, "bad")):
        print("skipped: ORBICUBE_MODELS names no folder with models")
        sys.exit(77)
    main()
