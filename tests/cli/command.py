"""What the tests of the command share: running it, and reading what it wrote without its help."""
import json
import os
import pty
import resource
import struct
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

COMMAND = os.path.abspath(sys.argv[1])
# Address space cannot be limited where the sanitizer reserves terabytes of it.
with open(COMMAND, "rb") as program:
    SANITIZED = b"__asan_init" in program.read()

# For tests that would take minutes with a sanitizer, where others see the same code.
long = unittest.skipIf(SANITIZED, "long")


def run(*arguments, **keywords):
    keywords.setdefault("timeout", 600 if SANITIZED else 240)
    return subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, **keywords)


def processor_seconds(process=None):
    """What a process that runs has used of all processors, or all those that have ended."""
    if process is None:
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return used.ru_utime + used.ru_stime
    with open(f"/proc/{process.pid}/stat", encoding="ascii") as file:
        user, system = file.read().rpartition(")")[2].split()[11:13]
    return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")


def kind_of(line, file):
    """The kind word of a message `orbicube: FILE: KIND: text`, which must have that form."""
    start = f"orbicube: {file}: "
    if not line.startswith(start):
        return f"(no message about {file}: {line!r})"
    return line[len(start):].split(": ")[0]


def read_obj(path):
    positions, triangles = [], []
    with open(path, encoding="ascii") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                positions.append(tuple(float(word) for word in words[1:4]))
            elif words[:1] == ["f"]:
                triangles.append(tuple(int(word.split("/")[0]) - 1 for word in words[1:]))
    return positions, triangles


def write_obj(path, positions, triangles):
    with open(path, "w", encoding="ascii") as file:
        for p in positions:
            file.write("v %r %r %r\n" % tuple(p))
        for t in triangles:
            file.write("f %d %d %d\n" % tuple(v + 1 for v in t))


def as_float32(value):
    return struct.unpack("<f", struct.pack("<f", value))[0]


class Glb:
    """The one surface of a GLB file; lines may lie on it."""

    def __init__(self, path, texture=True, targets=True):
        with open(path, "rb") as file:
            data = file.read()
        magic, version, length = struct.unpack_from("<4sII", data, 0)
        assert (magic, version, length) == (b"glTF", 2, len(data))
        json_length, json_type = struct.unpack_from("<I4s", data, 12)
        assert json_type == b"JSON"
        self.json = json.loads(data[20:20 + json_length])
        self.chunk = data[20 + json_length + 8:]
        (mesh,) = self.json["meshes"]
        self.primitive, *lines = mesh["primitives"]
        assert all(other["mode"] == 1 for other in lines)
        self.positions = self.accessor(self.primitive["attributes"]["POSITION"])
        if targets:
            self.target_names = mesh["extras"]["targetNames"]
            self.deltas = self.accessor(self.primitive["targets"][0]["POSITION"])
        if texture:
            self.texture_coordinates = self.accessor(self.primitive["attributes"]["TEXCOORD_0"])
        corners = [corner for (corner,) in self.accessor(self.primitive["indices"])]
        self.triangles = [tuple(corners[i:i + 3]) for i in range(0, len(corners), 3)]

    def accessor(self, number):
        accessor = self.json["accessors"][number]
        view = self.json["bufferViews"][accessor["bufferView"]]
        components = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        letter = {5126: "f", 5125: "I", 5123: "H"}[accessor["componentType"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        flat = struct.unpack_from(f"<{components * accessor['count']}{letter}", self.chunk, start)
        return [flat[i:i + components] for i in range(0, len(flat), components)]

    def sphere(self, in_float32):
        """Base + delta, as a renderer adds them or exactly as far as doubles go."""
        rounding = as_float32 if in_float32 else float
        return [tuple(rounding(b + d) for b, d in zip(base, delta))
                for base, delta in zip(self.positions, self.deltas)]


def not_positive(positions, triangles):
    """Number of triangles with det[p q r] <= 0, in rational numbers."""
    exact = [tuple(map(Fraction, p)) for p in positions]
    count = 0
    for p, q, r in ((exact[i] for i in t) for t in triangles):
        det = (p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0])
               + p[2] * (q[0] * r[1] - q[1] * r[0]))
        count += det <= 0
    return count


class InFolder(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def made(self, shape, resolution=600, seed=0, name=None):
        path = self.path(name or f"{shape}.obj")
        done = run("make", shape, "-o", path, "--resolution", resolution, "--seed", seed)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return path

    def on_terminal(self, *arguments):
        """What the command draws there."""
        try:
            terminal, end = pty.openpty()
        except OSError as error:  # a root folder without devpts
            self.skipTest(str(error))
        with subprocess.Popen([COMMAND, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=end) as process:
            os.close(end)
            seen = b""
            try:
                while piece := os.read(terminal, 4096):
                    seen += piece
            except OSError:  # how the end of the other side shows on Linux
                pass
        os.close(terminal)
        self.assertEqual(process.returncode, 0, arguments)
        return seen

    def refused(self, exit_code, kind, file, *arguments, **keywords):
        done = run(*arguments, **keywords)
        self.assertEqual(done.returncode, exit_code, done.stderr)
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), 1, done.stderr)
        self.assertEqual(kind_of(lines[0], file), kind)
        return lines[0]


def main():
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], verbosity=2)
