#!/usr/bin/env python3
"""Makes docs/images/sphere_map_uses.png: what a map to the sphere is for, on shapes that the command makes.

    docs/images/render_uses.py build/cli/orbicube [OUT.png]

Draws triangles itself (parallel light, hidden surfaces by depth, edges darker); needs numpy.
"""
import os
import struct
import subprocess
import sys
import tempfile
import zlib

import numpy as np

SIZE = 420  # pixels of a panel
FINER = 2   # samples a pixel, each way


def read_obj(path):
    positions, triangles = [], []
    with open(path, encoding="ascii") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                positions.append([float(word) for word in words[1:4]])
            elif words[:1] == ["f"]:
                triangles.append([int(word) - 1 for word in words[1:4]])
    return np.array(positions), np.array(triangles)


def panel(positions, triangles, color, turn=0.6, tilt=0.25, edges=True):
    """A picture of the surface, SIZE x SIZE x 3, numbers from 0 to 1."""
    size = SIZE * FINER
    image = np.ones((size, size, 3))
    depth = np.full((size, size), -np.inf)
    about_y = np.array([[np.cos(turn), 0, np.sin(turn)], [0, 1, 0], [-np.sin(turn), 0, np.cos(turn)]])
    about_x = np.array([[1, 0, 0], [0, np.cos(tilt), -np.sin(tilt)], [0, np.sin(tilt), np.cos(tilt)]])
    x = positions @ (about_x @ about_y).T
    low, high = x.min(axis=0), x.max(axis=0)
    scale = 0.92 * size / max(high[:2] - low[:2])
    x = (x - (low + high) / 2) * scale
    screen = np.stack([size / 2 + x[:, 0], size / 2 - x[:, 1], x[:, 2]], axis=1)
    light = np.array([0.35, 0.55, 0.75])
    light /= np.linalg.norm(light)
    for a, b, c in screen[triangles]:
        up = np.array([1, -1, 1])  # the screen's y goes down
        normal = np.cross((b - a) * up, (c - a) * up)
        length = np.linalg.norm(normal)
        area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if length == 0 or area >= 0:  # seen from behind
            continue
        shade = 0.4 + 0.6 * max(0.0, float(normal @ light / length))
        x0, y0 = np.maximum(np.floor(np.minimum(np.minimum(a, b), c)[:2]).astype(int), 0)
        x1, y1 = np.minimum(np.ceil(np.maximum(np.maximum(a, b), c)[:2]).astype(int) + 1, size)
        px, py = np.meshgrid(np.arange(x0, x1) + 0.5, np.arange(y0, y1) + 0.5)
        u = ((b[0] - px) * (c[1] - py) - (b[1] - py) * (c[0] - px)) / area
        v = ((c[0] - px) * (a[1] - py) - (c[1] - py) * (a[0] - px)) / area
        w = 1 - u - v
        z = u * a[2] + v * b[2] + w * c[2]
        seen = (u >= 0) & (v >= 0) & (w >= 0) & (z > depth[y0:y1, x0:x1])
        depth[y0:y1, x0:x1][seen] = z[seen]
        filled = np.broadcast_to(np.array(color) * shade, (*seen.shape, 3)).copy()
        if edges:
            longest = max(np.linalg.norm((b - a)[:2]), np.linalg.norm((c - b)[:2]), np.linalg.norm((a - c)[:2]))
            height = -area / longest
            filled[np.minimum(np.minimum(u, v), w) * height < 0.5] *= 0.6
        image[y0:y1, x0:x1][seen] = filled[seen]
    return image.reshape(SIZE, FINER, SIZE, FINER, 3).mean(axis=(1, 3))


def write_png(path, image):
    data = np.clip(np.round(255 * image ** 0.9), 0, 255).astype(np.uint8)
    height, width, _ = data.shape
    rows = b"".join(b"\0" + row.tobytes() for row in data)

    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
                   + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def main(command, picture):
    with tempfile.TemporaryDirectory() as folder:
        def path(name):
            return os.path.join(folder, name)

        def orbicube(*arguments):
            subprocess.run([command, *arguments, "--quiet"], check=True)

        orbicube("make", "creature", "-o", path("creature.obj"), "--resolution", "16000")
        orbicube("make", "star", "-o", path("star.obj"), "--resolution", "10000")
        for name, grid in (("icosphere.obj", "icosphere:5"), ("cube.obj", "cube:40")):
            orbicube("sphere", path("creature.obj"), "-o", path("map.obj"), "--method", "stretch", "--remesh", path(name),
                     "--grid", grid)
        orbicube("morph", path("creature.obj"), path("star.obj"), "-o", path("morph.glb"), "--steps", "1")
        orbicube("convert", path("morph-01.glb"), path("half.obj"))
        panels = [panel(*read_obj(path(name)), color) for name, color in
                  (("creature.obj", (0.75, 0.78, 0.82)), ("icosphere.obj", (0.55, 0.75, 0.95)),
                   ("cube.obj", (0.95, 0.8, 0.5)), ("half.obj", (0.7, 0.9, 0.65)))]
    picture_rows = np.concatenate(panels, axis=1)
    drawn = np.nonzero((picture_rows < 1).any(axis=(1, 2)))[0]
    write_png(picture, picture_rows[max(drawn[0] - 12, 0):drawn[-1] + 12])
    print(f"{picture}: {os.path.getsize(picture)} bytes")


HERE = os.path.dirname(os.path.abspath(__file__))
main(os.path.abspath(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else os.path.join(HERE, "sphere_map_uses.png"))
