#!/usr/bin/env python3
"""Draws the scenes that `orbicube frames --glb` writes: docs/images/frame_field.png, of shapes that the command makes, or any.

    docs/images/render_frames.py build/cli/orbicube              (a command built with TetGen)
    docs/images/render_frames.py OUT.png SCENE.glb [SCENE.glb ...]

Draws triangles itself (parallel light, hidden surfaces by depth, transparent parts as layers over what is opaque); needs numpy.
"""
import json
import os
import struct
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from raster import without_margins, write_png  # noqa: E402

SIZE = 460  # pixels of a panel
FINER = 2   # samples a pixel, each way


def read_glb(path):
    """Corners (n x 3 x 3) and color of each part."""
    with open(path, "rb") as file:
        data = file.read()
    length = struct.unpack_from("<I", data, 12)[0]
    text, chunk = json.loads(data[20:20 + length]), data[28 + length:]
    types = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}

    def values(number):
        accessor = text["accessors"][number]
        view = text["bufferViews"][accessor["bufferView"]]
        components = {"SCALAR": 1, "VEC3": 3}[accessor["type"]]
        flat = np.frombuffer(chunk, types[accessor["componentType"]], components * accessor["count"],
                             view.get("byteOffset", 0))
        return flat.reshape(-1, components)

    parts = []
    for node in text["nodes"]:
        (primitive,) = text["meshes"][node["mesh"]]["primitives"]
        positions = values(primitive["attributes"]["POSITION"]).astype(float)
        color = text["materials"][primitive["material"]]["pbrMetallicRoughness"]["baseColorFactor"]
        parts.append((positions[values(primitive["indices"])[:, 0].reshape(-1, 3)], np.array(color)))
    return parts


class Panel:
    """A picture, samples x samples, seen along the turned z axis."""

    def __init__(self, turn, tilt):
        self.samples = SIZE * FINER
        shape = (self.samples, self.samples)
        self.depth = np.full(shape, -np.inf)
        self.opaque = np.ones((*shape, 3))
        self.clear = np.ones(shape)  # what passes through the layers in front
        self.light = np.zeros((*shape, 3))  # what these add, each covered by half of the others
        about_y = np.array([[np.cos(turn), 0, np.sin(turn)], [0, 1, 0], [-np.sin(turn), 0, np.cos(turn)]])
        about_x = np.array([[1, 0, 0], [0, np.cos(tilt), -np.sin(tilt)], [0, np.sin(tilt), np.cos(tilt)]])
        self.view = (about_x @ about_y).T

    def fit(self, corners):
        seen = corners.reshape(-1, 3) @ self.view
        low, high = seen.min(axis=0), seen.max(axis=0)
        self.middle, self.scale = (low + high) / 2, 0.94 * self.samples / max(high[:2] - low[:2])

    def draw(self, corners, color):
        x = ((corners.reshape(-1, 3) @ self.view - self.middle) * self.scale).reshape(-1, 3, 3)
        normals = np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0])
        lengths = np.linalg.norm(normals, axis=1)
        light = np.array([0.35, 0.55, 0.75]) / np.linalg.norm([0.35, 0.55, 0.75])
        x[:, :, 1] *= -1  # the screen's y goes down
        x[:, :, :2] += self.samples / 2
        for (a, b, c), normal, length in zip(x, normals, lengths):
            if length == 0 or (color[3] == 1 and normal[2] <= 0):
                continue
            towards = normal / length * (1 if normal[2] > 0 else -1)
            tint = color[:3] * (0.45 + 0.55 * max(0.0, float(towards @ light)))
            self.fill(a, b, c, tint, color[3])

    def fill(self, a, b, c, tint, opacity):
        x0, y0 = np.maximum(np.floor(np.minimum(np.minimum(a, b), c)[:2]).astype(int), 0)
        x1, y1 = np.minimum(np.ceil(np.maximum(np.maximum(a, b), c)[:2]).astype(int) + 1, self.samples)
        area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if area == 0 or x1 <= x0 or y1 <= y0:
            return
        px, py = np.arange(x0, x1)[None, :] + 0.5, np.arange(y0, y1)[:, None] + 0.5
        u = ((b[0] - px) * (c[1] - py) - (b[1] - py) * (c[0] - px)) / area
        v = ((c[0] - px) * (a[1] - py) - (c[1] - py) * (a[0] - px)) / area
        w = 1 - u - v
        z = u * a[2] + v * b[2] + w * c[2]
        here = (slice(y0, y1), slice(x0, x1))
        seen = (u >= 0) & (v >= 0) & (w >= 0) & (z > self.depth[here])
        if opacity == 1:
            self.depth[here][seen] = z[seen]
            self.opaque[here][seen] = tint
        else:
            self.light[here][seen] += opacity * tint * self.clear[here][seen][:, None]
            self.clear[here][seen] *= 1 - opacity

    def image(self):
        picture = self.opaque * self.clear[:, :, None] + self.light
        return picture.reshape(SIZE, FINER, SIZE, FINER, 3).mean(axis=(1, 3))


def panel(path, turn=0.6, tilt=0.35):
    parts = read_glb(path)
    picture = Panel(turn, tilt)
    picture.fit(np.concatenate([corners for corners, _ in parts]))
    for corners, color in sorted(parts, key=lambda part: part[1][3] < 1):  # what is opaque first
        picture.draw(corners, color)
    return picture.image()


def main(arguments):
    if arguments[0].endswith(".png"):
        picture, scenes = arguments[0], [panel(path) for path in arguments[1:]]
    else:
        picture, scenes = os.path.join(os.path.dirname(os.path.abspath(__file__)), "frame_field.png"), []
        with tempfile.TemporaryDirectory() as folder:
            for shape, triangles in (("bracket", 6000), ("sphere", 3000), ("torus", 3000)):
                surface, solid, scene = (os.path.join(folder, shape + ending) for ending in (".off", ".mesh", ".glb"))
                for command in (["make", shape, "-o", surface, "--resolution", str(triangles)],
                                ["tetrahedralize", surface, "-o", solid],
                                ["frames", solid, "-o", solid + ".frames", "--glb", scene, "--crosses", "400"]):
                    subprocess.run([os.path.abspath(arguments[0]), *command, "--quiet"], check=True)
                scenes.append(panel(scene))
    write_png(picture, without_margins(np.concatenate(scenes, axis=1)), gamma=0.6)  # colors of glTF are linear
    print(f"{picture}: {os.path.getsize(picture)} bytes")


main(sys.argv[1:])
