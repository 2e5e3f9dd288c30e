#!/usr/bin/env python3
"""orbicube surface: NIfTI, NRRD and MetaImage files of every encoding give one surface at the places that their headers say; hostile files are refused.

    surface_test.py COMMAND
"""
import collections
import gzip
import json
import math
import os
import struct
import zlib

from command import InFolder, main, run
from repair_test import read_off

SIZE = (14, 12, 10)
# Label 2: an ellipsoid with a tunnel along x; label 7: a speck and a bar beside it.
LABELS = [2 if ((x - 6) / 5)**2 + ((y - 5) / 4)**2 + ((z - 4) / 3.4)**2 < 1 and (y, z) != (6, 5) else 0
          for z in range(SIZE[2]) for y in range(SIZE[1]) for x in range(SIZE[0])]
for _x in range(10, 13):
    LABELS[_x + SIZE[0] * (10 + SIZE[1] * 8)] = 7

# A rotation, a reflection and spacing: columns are the steps along the axes.
ROTATION = [[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]]
SPACING = (0.5, 0.75, 2.0)
ORIGIN = (-12.5, 30.25, 7.0)
AFFINE = [[ROTATION[r][c] * SPACING[c] for c in range(3)] + [ORIGIN[r]] for r in range(3)]


def packed(kind, order, labels=None):
    labels = LABELS if labels is None else labels
    return struct.pack(f"{order}{len(labels)}{kind}", *labels)


def nifti1(kind="B", code=2, order="<", size=SIZE, sform=AFFINE, qform=None, slope=0.0, intercept=0.0, magic=b"n+1\0", dims=3, offset=352.0,
           handed=1.0):
    header = bytearray(348)

    def put(at, form, *values):
        struct.pack_into(order + form, header, at, *values)

    put(0, "i", 348)
    put(40, "8h", dims, *size, *[1] * (7 - len(size)))
    put(70, "hh", code, 8 * struct.calcsize(kind))
    put(76, "8f", handed, *SPACING, 1, 1, 1, 1)
    put(108, "fff", offset, slope, intercept)
    if sform is not None:
        put(254, "h", 1)
        put(280, "12f", *sform[0], *sform[1], *sform[2])
    if qform is not None:
        put(252, "h", 1)
        put(256, "6f", *qform)
    header[344:348] = magic
    return bytes(header) + bytes(4)


def nifti2(order=">"):
    header = bytearray(540)

    def put(at, form, *values):
        struct.pack_into(order + form, header, at, *values)

    put(0, "i", 540)
    header[4:12] = b"n+2\0\r\n\032\n"
    put(12, "hh", 8, 32)
    put(16, "8q", 3, *SIZE, 1, 1, 1, 1)
    put(104, "8d", 1, *SPACING, 1, 1, 1, 1)
    put(168, "q", 544)
    put(344, "ii", 0, 1)
    put(400, "12d", *AFFINE[0], *AFFINE[1], *AFFINE[2])
    return bytes(header) + bytes(4)


def nrrd(extra="", encoding="raw", kind="int16", endian="little", sizes=SIZE):
    columns = " ".join("(" + ",".join(repr(AFFINE[r][c]) for r in range(3)) + ")" for c in range(3))
    text = f"NRRD0004\n# labels\ntype: {kind}\ndimension: {len(sizes)}\nspace: left-posterior-superior\nsizes: {' '.join(map(str, sizes))}\n"
    text += f"space directions: {columns}\nkinds: domain domain domain\nendian: {endian}\nencoding: {encoding}\nkey:=value: more\n"
    return (text + f"space origin: ({','.join(map(repr, ORIGIN))})\n{extra}\n").encode()


def metaimage(file="LOCAL", extra="", kind="MET_SHORT", sizes=SIZE):
    matrix = " ".join(repr(ROTATION[r][c]) for c in range(3) for r in range(3))
    return (f"ObjectType = Image\nNDims = 3\nBinaryData = True\n{extra}TransformMatrix = {matrix}\nOffset = {' '.join(map(repr, ORIGIN))}\n"
            f"ElementSpacing = {' '.join(map(repr, SPACING))}\nDimSize = {' '.join(map(str, sizes))}\nElementType = {kind}\n"
            f"ElementDataFile = {file}\n").encode()


class Surface(InFolder):
    def put(self, name, data):
        with open(self.path(name), "wb") as file:
            file.write(data)
        return self.path(name)

    def extracted(self, name, *options):
        report = self.path("report.json")
        done = run("surface", self.path(name), "-o", self.path("out.off"), "--report", report, *options)
        self.assertEqual(done.returncode, 0, name + done.stdout + done.stderr)
        with open(report, encoding="utf-8") as file:
            return read_off(self.path("out.off")), json.load(file), done.stdout

    def refused(self, name, kind, *words, options=("--label", "2")):
        out = self.path("refused.off")
        done = run("surface", self.path(name), "-o", out, *options)
        self.assertEqual(done.returncode, 2, name + done.stdout + done.stderr)
        for word in (kind + ": ", *words):
            self.assertIn(word, done.stderr, name)
        self.assertFalse(os.path.exists(out))

    def near(self, one, other, tolerance):
        self.assertEqual(len(one), len(other))
        self.assertLess(max(math.dist(a, b) for a, b in zip(one, other)), tolerance)

    def test_formats_agree(self):
        self.put("plain.nii", nifti1() + packed("B", "<"))
        (positions, triangles), report, text = self.extracted("plain.nii", "--label", 2)
        edges = collections.Counter((t[k], t[(k + 1) % 3]) for t in triangles for k in range(3))
        self.assertTrue(all(n == 1 and edges[b, a] == 1 for (a, b), n in list(edges.items())))
        self.assertEqual(len(positions) - len(edges) // 2 + len(triangles), 2)
        self.assertEqual((report["certificate"]["genus"], report["certificate"]["self_intersections"], report["handles"]["removed"]), (0, 0, 1))
        self.assertEqual(report["voxels"], LABELS.count(2))
        kept = report["voxels"] + report["handles"]["added_voxels"] - report["handles"]["removed_voxels"]
        self.assertAlmostEqual(report["certificate"]["volume"], 0.75 * kept, delta=0.09 * kept)  # pits and edges of voxels are cut off
        self.assertIn("1 handle or tunnel removed", text)
        files = {
            "a.nii": nifti1("h", 4, ">") + packed("h", ">"), "b.nii": nifti1("f", 16) + packed("f", "<"),
            "c.nii.gz": gzip.compress(nifti1("d", 64, ">") + packed("d", ">")), "d.nii": nifti2() + packed("i", ">"),
            "d2.nii": nifti2("<") + packed("i", "<"), "e.NII": nifti1("b", 256) + packed("b", "<"),
            "f.nii": nifti1("Q", 1280) + packed("Q", "<"), "g.nii": nifti1("H", 512, slope=0.5, intercept=-1.0) +
            packed("H", "<", [2 * v + 2 for v in LABELS]), "h.nii": nifti1(size=(*SIZE, 1, 1), dims=5) + packed("B", "<"),
            # Two compressed streams, one after the other.
            "i.nii.gz": gzip.compress(nifti1()) + gzip.compress(packed("B", "<")),
            "a.nrrd": nrrd() + packed("h", "<"), "b.nrrd": nrrd(endian="big", kind="unsigned int") + packed("I", ">"),
            "c.nrrd": nrrd(encoding="gzip", kind="double") + gzip.compress(packed("d", "<")),
            "d.nrrd": nrrd(encoding="ascii") + "\n".join(map(str, LABELS)).encode(),
            "e.nrrd": nrrd(extra="byte skip: 3\nline skip: 1\n") + b"a line\nxyz" + packed("h", "<"),
            "f.nrrd": nrrd(extra="byte skip: -1\n") + b"some bytes" + packed("h", "<"),
            "a.mha": metaimage() + packed("h", "<"),
            "b.mha": metaimage(extra="BinaryDataByteOrderMSB = True\n", kind="MET_INT") + packed("i", ">"),
            "c.mha": metaimage(extra="CompressedData = True\n", kind="MET_UCHAR") + zlib.compress(packed("B", "<")),
            "d.mhd": metaimage(file="voxels.raw", kind="MET_UCHAR", extra="HeaderSize = 5\n"),
            "e.nhdr": nrrd(extra="data file: voxels2.raw\n", kind="uchar"),
            "f.mhd": metaimage(file="voxels.raw", kind="MET_UCHAR", extra="HeaderSize = -1\n"),
        }
        self.put("voxels.raw", b"12345" + packed("B", "<"))
        self.put("voxels2.raw", packed("B", "<"))
        for name, data in files.items():
            self.put(name, data)
            (places, faces), found, _ = self.extracted(name, "--label", 2)
            self.assertEqual(faces, triangles, name)
            self.near(places, positions, 1e-4 if "nii" in name.lower() else 1e-5)
            self.assertEqual(found["image"]["size"], list(SIZE))
            self.assertEqual(found["image"]["space"], "RAS" if "nii" in name.lower() else "LPS")

    def test_orientation_by_quaternion(self):
        # A turn by 90 degrees around z: x goes to y.
        half = math.sqrt(0.5)
        self.put("q.nii", nifti1(sform=None, qform=(0, 0, half, *ORIGIN), handed=-1.0) + packed("B", "<"))
        (turned, faces), _, _ = self.extracted("q.nii", "--label", 2)
        self.put("s.nii", nifti1(sform=[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]) + packed("B", "<"))
        (plain, plain_faces), _, _ = self.extracted("s.nii", "--label", 2)
        # In single precision; a mirroring header turns the faces, not the surface.
        expected = [(-SPACING[1] * y + ORIGIN[0], SPACING[0] * x + ORIGIN[1], -SPACING[2] * z + ORIGIN[2]) for x, y, z in plain]
        self.near(turned, expected, 1e-5)
        self.assertEqual(faces, [(a, c, b) for a, b, c in plain_faces])
        self.put("n.nii", nifti1(sform=None) + packed("B", "<"))
        (scaled, _), report, text = self.extracted("n.nii", "--label", 2)
        self.near(scaled, [tuple(s * v for s, v in zip(SPACING, p)) for p in plain], 1e-5)
        self.assertIsNone(report["image"]["space"])
        self.assertIn("no orientation", text)

    def test_options(self):
        self.put("a.nii", nifti1() + packed("B", "<"))
        _, report, _ = self.extracted("a.nii", "--label", 2, "--keep-handles")
        self.assertEqual(report["certificate"]["genus"], 1)
        _, report, _ = self.extracted("a.nii", "--label", 7, "--max-slide", 0)
        self.assertEqual(report["largest_slide"], 0)
        split = list(LABELS)
        split[11 + SIZE[0] * (10 + SIZE[1] * 8)] = 0
        split[6 + SIZE[0] * (3 + SIZE[1] * 4)] = 7  # a part of its own, and a cavity of label 2
        self.put("b.nii", nifti1() + packed("B", "<", split))
        _, report, text = self.extracted("b.nii", "--label", 7, "--keep", 0)
        self.assertEqual((report["certificate"]["parts"], report["certificate"]["genus"]), (3, 0))
        _, report, text = self.extracted("b.nii", "--label", 7)
        self.assertEqual(report["parts"], {"found": 3, "kept": 1, "dropped_voxels": 2})
        self.assertIn("kept 1 of 3 parts", text)
        _, report, text = self.extracted("b.nii", "--label", 2)
        self.assertIn("1 cavity filled, 1 voxel", text)
        _, report, _ = self.extracted("b.nii", "--label", 2, "--keep-handles", "--cavities")
        self.assertEqual(report["certificate"]["parts"], 2)
        border = [5] * len(LABELS)
        self.put("c.nii", nifti1() + packed("B", "<", border))
        _, report, text = self.extracted("c.nii")
        self.assertEqual(report["label"], 5)
        self.assertIn("reaches the border", text)
        one = run("surface", self.path("a.nii"), "--label", 2, "-o", self.path("1.off"), "--threads", 1)
        four = run("surface", self.path("a.nii"), "--label", 2, "-o", self.path("4.off"), "--threads", 4)
        self.assertEqual((one.returncode, four.returncode), (0, 0))
        self.assertEqual(read_off(self.path("1.off")), read_off(self.path("4.off")))
        for options in (("--cavities",), ("--smoothing", 1, "--max-slide", 0), ("--max-slide", 0.5), ("--label", 0), ("--label", 2.5),
                        ("--keep", -1)):
            self.refused("a.nii", "usage", options=options)
        self.refused("a.nii", "invalid-argument", "2 (", "7 (3 voxels)", "--label", options=())
        self.refused("a.nii", "invalid-argument", "no voxel has label 3; there are labels 2 (", "7 (3 voxels)", options=("--label", 3))

    def test_sphere_map_of_it(self):
        self.put("a.nii", nifti1() + packed("B", "<"))
        self.extracted("a.nii", "--label", 2)
        done = run("sphere", self.path("out.off"), "-o", self.path("sphere.off"))
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_hostile_files(self):
        data, huge = packed("B", "<"), (32767, 32767, 32767)
        whole = nifti1() + data
        cases = {
            "empty.nii": (b"", "empty-file"), "text.nii": (b"no image at all, but long enough to be one" * 20, "bad-magic"),
            "short.nii": (whole[:100], "truncated"), "three.nii": (whole[:3], "truncated"), "data.nii": (whole[:-1], "truncated"),
            "magic.nii": (nifti1(magic=b"abc\0") + data, "bad-magic"), "pair.nii": (nifti1(magic=b"ni1\0") + data, "unsupported"),
            "huge.nii": (nifti1(size=huge) + data, "truncated"), "huge64.nii": (nifti1("d", 64, size=huge) + data, "truncated"),
            "seven.nii": (nifti1(size=(*huge, 32767, 32767, 32767, 32767), dims=7) + data, "unsupported"),
            "zero.nii": (nifti1(size=(14, 0, 10)) + data, "parse"), "negative.nii": (nifti1(size=(14, -12, 10)) + data, "parse"),
            "dims.nii": (nifti1(dims=8) + data, "parse"), "dims0.nii": (nifti1(dims=0) + data, "parse"),
            "complex.nii": (nifti1(code=32) + data, "unsupported"), "four.nii": (nifti1(size=(*SIZE[:2], 5, 2), dims=4) + data, "unsupported"),
            "offset.nii": (nifti1(offset=3.0) + data, "parse"), "offset2.nii": (nifti1(offset=float("nan")) + data, "parse"),
            "offset3.nii": (nifti1(offset=1e14) + data, "truncated"),
            "nan.nii": (nifti1(sform=[[math.nan] * 4] * 3) + data, "invalid-argument"),
            "flat.nii": (nifti1(sform=[[1, 1, 0, 0], [1, 1, 0, 0], [0, 0, 1, 0]]) + data, "invalid-argument"),
            "fraction.nii": (nifti1("f", 16) + packed("f", "<", [0.5] * len(LABELS)), "unsupported"),
            "nans.nii": (nifti1("f", 16) + packed("f", "<", [math.nan] * len(LABELS)), "unsupported"),
            "large.nii": (nifti1("I", 768) + packed("I", "<", [2**32 - 1] * len(LABELS)), "unsupported"),
            "background.nii": (nifti1() + bytes(len(LABELS)), "invalid-argument"),
            "cut.nii.gz": (gzip.compress(whole)[:-20], "truncated"), "damaged.nii.gz": (gzip.compress(whole)[:10] + b"\xff" * 60, "parse"),
            "checksum.nii.gz": (gzip.compress(whole)[:-8] + bytes(8), "parse"), "bomb.nii.gz": (gzip.compress(nifti1(size=huge)), "truncated"),
            "magic.nrrd": (b"NRR", "bad-magic"), "none.nrrd": (b"NRRD0004\n", "parse"), "sizes.nrrd": (nrrd(sizes=(2**63, 2**63, 2)), "parse"),
            "more.nrrd": (nrrd(sizes=(2**64, 1, 1)), "parse"), "data.nrrd": (nrrd() + packed("h", "<")[:-1], "truncated"),
            "bzip.nrrd": (nrrd(encoding="bzip2") + data, "unsupported-mode"), "type.nrrd": (nrrd(kind="block") + data, "unsupported"),
            "path.nrrd": (nrrd(extra="data file: ../secret.raw\n"), "unsafe-path"), "list.nrrd": (nrrd(extra="data file: LIST\n"), "unsupported-mode"),
            "absent.nrrd": (nrrd(extra="data file: absent.raw\n"), "io"), "text.nrrd": (nrrd(encoding="ascii") + b"1 2 3", "truncated"),
            "words.nrrd": (nrrd(encoding="ascii") + b"a " * len(LABELS), "parse"), "gzip.nrrd": (nrrd(encoding="gzip") + b"x" * 5000, "parse"),
            "skip.nrrd": (nrrd(extra="line skip: 99999999999\n") + data, "truncated"), "bytes.nrrd": (nrrd(extra="byte skip: 999999999\n") + data, "truncated"),
            "line.nrrd": (b"NRRD0004\nno field\n\n", "parse"), "empty.mha": (b"\n\n", "bad-magic"),
            "none.mha": (b"NDims = 3\n", "truncated"), "sizes.mha": (metaimage(sizes=(2**40, 2**40, 2)), "parse"),
            "path.mhd": (metaimage(file="/etc/passwd"), "unsafe-path"), "data.mha": (metaimage() + packed("h", "<")[:-2], "truncated"),
            "type.mha": (metaimage(kind="MET_ARRAY") + data, "unsupported"), "zlib.mha": (metaimage(extra="CompressedData = True\n") + b"abc" * 999, "parse"),
            "channels.mha": (metaimage(extra="ElementNumberOfChannels = 3\n") + data, "unsupported"),
            "image.png": (data, "unsupported-format"),
        }
        for name, (content, kind) in cases.items():
            self.put(name, content)
            self.refused(name, kind)
        os.symlink("/etc/passwd", self.path("link.raw"))
        self.put("link.mhd", metaimage(file="link.raw"))
        self.refused("link.mhd", "unsafe-path")
        # What a file holds does not reach a terminal as it is.
        self.put("escape.nrrd", nrrd(extra="\x1b[31m\n") + data)
        done = run("surface", self.path("escape.nrrd"), "-o", self.path("out.off"))
        self.assertIn('the line "?[31m" of the header', done.stderr)
        # Any byte of a header changed: a surface or a refusal, in time.
        for at in range(0, 352, 7):
            broken = bytearray(whole)
            broken[at] ^= 0xFF
            self.put("broken.nii", bytes(broken))
            done = run("surface", self.path("broken.nii"), "-o", self.path("out.off"), "--label", 2)
            self.assertIn(done.returncode, (0, 2), at)


if __name__ == "__main__":
    main()
