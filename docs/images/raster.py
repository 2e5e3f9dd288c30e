"""Pictures of surfaces for the pages: triangles in parallel light, hidden surfaces by depth, edges darker. Needs numpy."""
import struct
import zlib

import numpy as np

SIZE = 420  # pixels of a panel
FINER = 2   # samples a pixel, each way


def read_obj(path):
    """Positions, and faces of one number of corners."""
    positions, faces = [], []
    with open(path, encoding="ascii") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                positions.append([float(word) for word in words[1:4]])
            elif words[:1] == ["f"]:
                faces.append([int(word) - 1 for word in words[1:]])
    return np.array(positions), np.array(faces)


def panel(positions, triangles, color, turn=0.6, tilt=0.25, edges=True):
    """A picture of the surface, SIZE x SIZE x 3, numbers from 0 to 1. `color` is one for all, or color(triangle, weights) of
    the triangle's number and the weights of its corners at some samples (3 x ...)."""
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
    for number, (a, b, c) in enumerate(screen[triangles]):
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
        own = color(number, np.stack([u, v, w])) if callable(color) else np.array(color)
        filled = np.broadcast_to(own * shade, (*seen.shape, 3)).copy()
        if edges:
            longest = max(np.linalg.norm((b - a)[:2]), np.linalg.norm((c - b)[:2]), np.linalg.norm((a - c)[:2]))
            height = -area / longest
            filled[np.minimum(np.minimum(u, v), w) * height < 0.5] *= 0.6
        image[y0:y1, x0:x1][seen] = filled[seen]
    return image.reshape(SIZE, FINER, SIZE, FINER, 3).mean(axis=(1, 3))


def write_png(path, image, gamma=0.9):
    data = np.clip(np.round(255 * np.clip(image, 0, 1) ** gamma), 0, 255).astype(np.uint8)
    height, width, _ = data.shape
    rows = b"".join(b"\0" + row.tobytes() for row in data)

    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
                   + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def without_margins(image, left=12):
    """The rows in which something is drawn, and a few around them."""
    drawn = np.nonzero((image < 1).any(axis=(1, 2)))[0]
    return image[max(drawn[0] - left, 0):drawn[-1] + left]
