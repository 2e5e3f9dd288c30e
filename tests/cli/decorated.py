"""A textured, skinned GLB: an egg with a seam of texture coordinates, two materials, vertex colors, two bones that bend."""
import json
import math
import struct
import zlib

COLUMNS, ROWS = 16, 8
BYTE, SHORT, FLOAT = (5121, "B"), (5123, "H"), (5126, "f")
TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


def png(width, height, color):
    """RGB; color(x, y) gives three bytes."""
    rows = b"".join(b"\0" + bytes(c for x in range(width) for c in color(x, y)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class Buffer:
    def __init__(self):
        self.bytes, self.views, self.accessors = b"", [], []

    def view(self, data, target=None):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        self.views.append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data)}
                          | ({"target": target} if target else {}))
        self.bytes += data
        return len(self.views) - 1

    def accessor(self, values, kind, target=34962, bounds=False, normalized=False):
        component_type, letter = kind
        components = len(values[0])
        flat = [x for value in values for x in value]
        accessor = {"bufferView": self.view(struct.pack(f"<{len(flat)}{letter}", *flat), target),
                    "componentType": component_type, "count": len(values), "type": TYPES[components]}
        if bounds:
            stored = struct.unpack(f"<{len(flat)}f", struct.pack(f"<{len(flat)}f", *flat))
            accessor["min"] = [min(stored[k::components]) for k in range(components)]
            accessor["max"] = [max(stored[k::components]) for k in range(components)]
        if normalized:
            accessor["normalized"] = True
        self.accessors.append(accessor)
        return len(self.accessors) - 1


def vertices():
    for i in range(ROWS + 1):
        theta = math.pi * i / ROWS
        radius = math.sin(theta) if 0 < i < ROWS else 0.0
        for j in range(COLUMNS + 1):
            phi = 2 * math.pi * (j % COLUMNS) / COLUMNS
            yield i, j, (0.5 * radius * math.cos(phi), math.cos(theta), 0.75 * radius * math.sin(phi))


def corners(rows):
    for i in rows:
        for j in range(COLUMNS):
            a = i * (COLUMNS + 1) + j
            c = a + COLUMNS + 1
            yield from ((a,), (a + 1,), (c,)) if i > 0 else ()
            yield from ((a + 1,), (c + 1,), (c,)) if i + 1 < ROWS else ()


def unit(x, y, z):
    length = math.sqrt(x * x + y * y + z * z)
    return (x / length, y / length, z / length)


def write_decorated(path, scale=1.0, bones=True):
    """`scale` of the positions; without bones the egg stands below a node that turns it."""
    buffer, points = Buffer(), list(vertices())
    upper = [(y + 1) / 2 for _, _, (_, y, _) in points]
    attributes = {
        "POSITION": buffer.accessor([tuple(scale * x for x in p) for _, _, p in points], FLOAT, bounds=True),
        "NORMAL": buffer.accessor([unit(x / 0.25, y, z / 0.5625) for _, _, (x, y, z) in points], FLOAT),
        "TEXCOORD_0": buffer.accessor([(j / COLUMNS, i / ROWS) for i, j, _ in points], FLOAT),
        "COLOR_0": buffer.accessor([(255, 255 - 10 * i, 255, 255) for i, _, _ in points], BYTE, normalized=True)}
    if bones:
        attributes["JOINTS_0"] = buffer.accessor([(0, 1 if w > 0 else 0, 0, 0) for w in upper], BYTE)
        attributes["WEIGHTS_0"] = buffer.accessor([(1 - w, w, 0, 0) for w in upper], FLOAT)
    halves = [buffer.accessor(list(corners(rows)), SHORT, 34963)
              for rows in (range(ROWS // 2), range(ROWS // 2, ROWS))]
    quarter = math.sqrt(0.5)
    scene = {
        "asset": {"version": "2.0"}, "scene": 0,
        "scenes": [{"name": "the scene", "nodes": [0, 1] if bones else [0], "extras": {"author": "A"}}],
        "meshes": [{"name": "egg", "extras": {"note": "kept"},
                    "primitives": [{"attributes": attributes, "indices": indices, "material": material}
                                   for material, indices in enumerate(halves)]}],
        "nodes": [{"name": "hips", "translation": [3, 0, 0], "rotation": [quarter, 0, 0, quarter], "children": [1]},
                  {"name": "body", "mesh": 0, "extras": {"id": 7}}],
        "materials": [{"name": "painted", "extras": {"k": [1, 2]},
                       "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0}},
                      {"name": "red", "doubleSided": True,
                       "pbrMetallicRoughness": {"baseColorFactor": [0.9, 0.1, 0.1, 1]},
                       "emissiveTexture": {"index": 0}, "emissiveFactor": [0.1, 0.1, 0.1]}],
        "textures": [{"source": 0, "sampler": 0}], "samplers": [{"magFilter": 9728, "minFilter": 9728}],
        "images": [{"name": "paint", "mimeType": "image/png", "bufferView": buffer.view(
            png(32, 16, lambda x, y: (8 * x, 16 * y, 200 if (x // 4 + y // 4) % 2 else 40)))}]}
    if bones:
        def shifted(y):
            return (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, y, 0, 1)

        scene["nodes"] = [{"name": "body", "mesh": 0, "skin": 0, "extras": {"id": 7}},
                          {"name": "root", "translation": [0, -scale, 0], "children": [2]},
                          {"name": "tip", "translation": [0, scale, 0]}]
        scene["skins"] = [{"name": "bones", "joints": [1, 2], "skeleton": 1,
                           "inverseBindMatrices": buffer.accessor([shifted(scale), shifted(0)], FLOAT, None)}]
        times = buffer.accessor([(0,), (1,)], FLOAT, None, bounds=True)
        turns = buffer.accessor([(0, 0, 0, 1), (0, 0, 0.6, 0.8)], FLOAT, None)
        scene["animations"] = [{"name": "bend", "samplers": [{"input": times, "output": turns}],
                                "channels": [{"sampler": 0, "target": {"node": 2, "path": "rotation"}}]}]
    buffer.bytes += b"\0" * (-len(buffer.bytes) % 4)
    scene |= {"buffers": [{"byteLength": len(buffer.bytes)}], "bufferViews": buffer.views, "accessors": buffer.accessors}
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<4sIII4s", b"glTF", 2, 28 + len(text) + len(buffer.bytes), len(text), b"JSON") + text
                   + struct.pack("<I4s", len(buffer.bytes), b"BIN\0") + buffer.bytes)
    return path
