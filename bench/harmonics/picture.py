"""Shaded pictures of meshes and line charts as PNG, with numpy alone."""
import struct
import zlib

import numpy


def read_obj(path):
    positions, triangles = [], []
    with open(path, encoding="ascii") as file:
        for line in file:
            if line.startswith("v "):
                positions.append(line.split()[1:4])
            elif line.startswith("f "):
                triangles.append([word.split("/")[0] for word in line.split()[1:4]])
    return numpy.array(positions, float), numpy.array(triangles, int) - 1


def write_png(path, pixels):
    """Rows of gray bytes."""
    height, width = pixels.shape

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + row.tobytes() for row in pixels.astype(numpy.uint8))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def compress(path):
    """Writes the pixels of a picture, which the command does not compress, at their smallest."""
    with open(path, "rb") as file:
        data = file.read()
    before, packed, after, at = data[:8], b"", b"", 8

    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        elif packed:
            after += data[at:at + 12 + length]
        else:
            before += data[at:at + 12 + length]
        at += 12 + length
    with open(path, "wb") as file:
        file.write(before + chunk(b"IDAT", zlib.compress(zlib.decompress(packed), 9)) + after)


def shaded(positions, triangles, low, high, size):
    """A view along -z of the box from low to high: each pixel the brightness of the nearest triangle there."""
    scale = 0.94 * size / max(high[0] - low[0], high[1] - low[1])
    centre = (low + high) / 2
    x = (positions[:, 0] - centre[0]) * scale + size / 2
    y = size / 2 - (positions[:, 1] - centre[1]) * scale
    z = positions[:, 2]
    corners = positions[triangles]
    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    # Smooth: the normals of vertices are sums of those of their triangles.
    smooth = numpy.zeros_like(positions)
    for k in range(3):
        numpy.add.at(smooth, triangles[:, k], normals)
    smooth /= numpy.maximum(numpy.linalg.norm(smooth, axis=1, keepdims=True), 1e-300)
    light = numpy.array([-0.35, 0.5, 0.8])
    bright = 40 + 200 * numpy.clip(smooth @ (light / numpy.linalg.norm(light)), 0, 1)
    image = numpy.full((size, size), 255.0)
    depth = numpy.full((size, size), -numpy.inf)
    for t in numpy.nonzero(normals[:, 2] > 0)[0]:
        a, b, c = triangles[t]
        left, right = max(int(min(x[a], x[b], x[c])), 0), min(int(max(x[a], x[b], x[c])) + 1, size - 1)
        top, bottom = max(int(min(y[a], y[b], y[c])), 0), min(int(max(y[a], y[b], y[c])) + 1, size - 1)
        area = (x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a])
        if left > right or top > bottom or area == 0:
            continue
        px, py = numpy.meshgrid(numpy.arange(left, right + 1), numpy.arange(top, bottom + 1))
        u = ((px - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (py - y[a])) / area
        v = ((x[b] - x[a]) * (py - y[a]) - (px - x[a]) * (y[b] - y[a])) / area
        here = z[a] + u * (z[b] - z[a]) + v * (z[c] - z[a])
        part = slice(top, bottom + 1), slice(left, right + 1)
        hit = (u >= -1e-9) & (v >= -1e-9) & (u + v <= 1 + 1e-9) & (here > depth[part])
        depth[part][hit] = here[hit]
        image[part][hit] = (bright[a] + u * (bright[b] - bright[a]) + v * (bright[c] - bright[a]))[hit]
    return image


def chart(curves, width=520, height=320):
    """Curves (x, y), x by its logarithm, in one frame from the minimum to the maximum of each; circles at the points."""
    image = numpy.full((height, width), 255.0)
    margin = 20
    xs = numpy.log(numpy.concatenate([x for x, _ in curves]))
    ys = numpy.concatenate([y for _, y in curves])
    image[margin, margin:-margin] = image[-margin, margin:-margin] = 0
    image[margin:-margin, margin] = image[margin:-margin, -margin] = 0
    for x, y in curves:
        i = 2 * margin + (numpy.log(x) - xs.min()) / max(numpy.ptp(xs), 1e-300) * (width - 4 * margin)
        j = height - 2 * margin - (numpy.asarray(y) - ys.min()) / max(numpy.ptp(ys), 1e-300) * (height - 4 * margin)
        for k in range(len(i) - 1):
            steps = int(max(abs(i[k + 1] - i[k]), abs(j[k + 1] - j[k]))) + 1
            s = numpy.linspace(0, 1, steps)
            image[(j[k] + s * (j[k + 1] - j[k])).round().astype(int), (i[k] + s * (i[k + 1] - i[k])).round().astype(int)] = 0
        rows, columns = numpy.indices(image.shape)
        for a, b in zip(i, j):
            image[(rows - b) ** 2 + (columns - a) ** 2 <= 9] = 0
    return image
