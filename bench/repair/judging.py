"""What the Python programs of this folder share: files, and measures of surfaces that use nothing of the libraries.

Whether triangles intersect is decided exactly: by directions that separate them by more than rounding errors, and by rational numbers
where none of a few does.
"""
import collections
import os
from fractions import Fraction

import numpy
import scipy.spatial

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "docs", "repair_figures.md")
HEAD = """# Figures of repairs

Written by programs of `bench/repair/`, which damage surfaces and generate images on purpose.
"""
# Directions must separate triangles by this fraction of their extent, a thousand times the rounding errors of the products.
MARGIN = 1e-12


class Section:
    """A section of the page of figures: prints lines as they come and remembers them."""

    def __init__(self, title, introduction):
        self.title, self.lines = title, [introduction, ""]

    def print(self, line=""):
        print(line, flush=True)
        self.lines.append(line)

    def write(self):
        """Puts it in place of the section with its title, or at the end of the page."""
        page = HEAD
        if os.path.exists(PAGE):
            with open(PAGE, encoding="utf-8") as file:
                page = file.read()
        head, *sections = page.split("\n## ")
        known = {section.split("\n", 1)[0]: section for section in sections}
        known[self.title] = "\n".join([self.title, "", *self.lines]) + "\n"
        with open(PAGE, "w", encoding="utf-8") as file:
            file.write("\n## ".join([head, *known.values()]))


def read_off(path):
    with open(path, encoding="ascii") as file:
        words = file.read().split()
    n, m = int(words[1]), int(words[2])
    positions = numpy.array(words[4:4 + 3 * n], dtype=float).reshape(n, 3)
    return positions, numpy.array(words[4 + 3 * n:4 + 3 * n + 4 * m], dtype=numpy.int64).reshape(m, 4)[:, 1:]


def write_off(path, positions, triangles):
    with open(path, "w", encoding="ascii") as file:
        print("OFF", file=file)
        print(len(positions), len(triangles), 0, file=file)
        for p in positions.tolist():
            print(*map(repr, p), file=file)
        for t in triangles.tolist():
            print(3, *t, file=file)


def is_solid(triangles):
    """Each edge once in each direction, and the triangles around each vertex in one circle."""
    edges = collections.Counter()
    around = collections.defaultdict(dict)
    for a, b, c in triangles.tolist():
        for u, v, w in ((a, b, c), (b, c, a), (c, a, b)):
            edges[u, v] += 1
            around[u][v] = w
    if any(n != 1 or edges.get((b, a)) != 1 for (a, b), n in edges.items()):
        return False
    for following in around.values():
        first = at = next(iter(following))
        steps = 0
        while steps == 0 or at != first:
            at, steps = following[at], steps + 1
            if steps > len(following):
                return False
        if steps != len(following):
            return False
    return True


def volume_of(positions, triangles):
    a, b, c = (positions[triangles[:, k]] - positions[0] for k in range(3))
    return numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6


def diagonal_of(positions):
    return numpy.linalg.norm(numpy.ptp(positions, axis=0))


def euler_characteristic(triangles):
    edges = numpy.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    return len(numpy.unique(triangles)) - len(numpy.unique(edges, axis=0)) + len(triangles)


def distances_to_triangles(points, a, b, c):
    """The distance of each point from the triangle with the same number."""
    def product(u, v):
        return numpy.einsum("ij,ij->i", u, v)
    normal = numpy.cross(b - a, c - a)
    square = product(normal, normal)
    inside = square > 0
    found = numpy.full(len(points), numpy.inf)
    for u, v in ((a, b), (b, c), (c, a)):
        edge = v - u
        length = product(edge, edge)
        along = numpy.clip(product(points - u, edge) / numpy.where(length > 0, length, 1), 0, 1)
        found = numpy.minimum(found, numpy.linalg.norm(u + along[:, None] * edge - points, axis=1))
        inside &= product(numpy.cross(edge, points - u), normal) >= 0
    height = numpy.abs(product(points - a, normal)) / numpy.sqrt(numpy.where(square > 0, square, 1))
    return numpy.where(inside, numpy.minimum(found, height), found)


def distances_to_surface(points, positions, triangles):
    """The distance of each point from the nearest triangle."""
    corners = positions[triangles]
    centers = corners.mean(axis=1)
    reach = numpy.linalg.norm(corners - centers[:, None], axis=2).max(axis=1)
    found = scipy.spatial.cKDTree(corners.reshape(-1, 3)).query(points)[0]
    # Triangles of one size at a time: those that can be nearer have their centers within the distance so far and their reach.
    size = numpy.floor(numpy.log2(numpy.maximum(reach, 1e-300)))
    for of_size in numpy.unique(size):
        chosen = numpy.flatnonzero(size == of_size)
        tree = scipy.spatial.cKDTree(centers[chosen])
        for first in range(0, len(points), 256):
            block = points[first:first + 256]
            near = tree.query_ball_point(block, (found[first:first + 256] + reach[chosen].max()) * (1 + 1e-12))
            point = numpy.repeat(numpy.arange(len(block)), [len(some) for some in near])
            triangle = chosen[numpy.concatenate(near).astype(numpy.int64)]
            numpy.minimum.at(found, first + point, distances_to_triangles(block[point], *corners[triangle].transpose(1, 0, 2)))
    return found


# ---------------------------------------------------------------- intersections

def overlapping_boxes(low, high):
    """Pairs of boxes with a point in common, by a tree over their centers in Morton order."""
    n = len(low)
    center = (low + high) / 2
    scaled = (center - center.min(axis=0)) / max(numpy.ptp(center, axis=0).max(), 1e-300)
    cell = numpy.minimum((scaled * 1024).astype(numpy.int64), 1023)
    code = numpy.zeros(n, numpy.int64)
    for bit in range(10):
        for axis in range(3):
            code |= (cell[:, axis] >> bit & 1) << (3 * bit + axis)
    order = numpy.argsort(code, kind="stable")
    leaves = 1 << max(0, (n - 1).bit_length())
    lows, highs = [numpy.full((leaves, 3), numpy.inf)], [numpy.full((leaves, 3), -numpy.inf)]
    lows[0][:n], highs[0][:n] = low[order], high[order]
    while len(lows[-1]) > 1:
        lows.append(numpy.minimum(lows[-1][0::2], lows[-1][1::2]))
        highs.append(numpy.maximum(highs[-1][0::2], highs[-1][1::2]))
    pairs = numpy.zeros((1, 2), numpy.int64)
    for level in range(len(lows) - 2, -1, -1):
        pairs = numpy.concatenate([2 * pairs + (i, j) for i in (0, 1) for j in (0, 1)])
        pairs = pairs[pairs[:, 0] <= pairs[:, 1]]
        first, second = pairs[:, 0], pairs[:, 1]
        meet = (lows[level][first] <= highs[level][second]).all(axis=1) & (lows[level][second] <= highs[level][first]).all(axis=1)
        pairs = pairs[meet]
    return order[pairs[pairs[:, 0] < pairs[:, 1]]]


def separated(p, q, shared):
    """Whether a direction separates the corners of triangles p and q besides the shared ones, which are equal and come first."""
    origin = p[:, 0] if shared else (p.mean(axis=1) + q.mean(axis=1)) / 2
    p, q = p - origin[:, None], q - origin[:, None]
    own_p, own_q = p[:, shared:], q[:, shared:]
    if shared == 2:  # seen along the edge
        edge = p[:, 1] / numpy.maximum(numpy.linalg.norm(p[:, 1], axis=1), 1e-300)[:, None]
        across = [x - numpy.einsum("nij,nj->ni", x, edge)[:, :, None] * edge[:, None] for x in (own_p, own_q)]
    else:
        across = [own_p, own_q]
    unit = [x / numpy.maximum(numpy.linalg.norm(x, axis=2), 1e-300)[:, :, None] for x in across]
    normals = [numpy.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]) for x in (p, q)]
    directions = [unit[0].mean(axis=1) - unit[1].mean(axis=1), own_p.mean(axis=1) - own_q.mean(axis=1)]
    if shared == 1:
        directions += [unit[0][:, i] - unit[1][:, j] for i in (0, 1) for j in (0, 1)]
    if shared < 2:
        directions += [normals[0], -normals[0], normals[1], -normals[1]]
        lines = [x[:, (k + 1) % 3] - x[:, k] for x in (p, q) for k in range(3)]
        directions += [s * numpy.cross(u, v) for u in lines[:3] for v in lines[3:] for s in (1, -1)]
        directions += [s * numpy.cross(u, n) for n in normals for u in lines for s in (1, -1)]
    extent = numpy.maximum(numpy.abs(p).max(axis=(1, 2)), numpy.abs(q).max(axis=(1, 2)))
    done = numpy.zeros(len(p), bool)
    for direction in directions:
        if shared == 2:
            direction = direction - numpy.einsum("ni,ni->n", direction, edge)[:, None] * edge
        direction = direction / numpy.maximum(numpy.linalg.norm(direction, axis=1), 1e-300)[:, None]
        above = numpy.einsum("nij,nj->ni", own_p, direction).min(axis=1)
        below = numpy.einsum("nij,nj->ni", own_q, direction).max(axis=1)
        if shared:
            done |= (above > MARGIN * extent) & (below < -MARGIN * extent)
        else:
            done |= above > below + MARGIN * extent
    return done


def exactly(point):
    return tuple(map(Fraction, point))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def on_triangle(point, triangle, normal):
    """Whether a point of the triangle's plane is in the triangle."""
    return all(dot(cross(minus(triangle[k - 2], triangle[k]), minus(point, triangle[k])), normal) >= 0 for k in range(3))


def segments_meet(p, q, a, b, normal):
    """Whether two segments in the plane with this normal have a point in common."""
    def side(u, v, w):
        x = dot(cross(minus(v, u), minus(w, u)), normal)
        return (x > 0) - (x < 0)
    sides = side(p, q, a), side(p, q, b), side(a, b, p), side(a, b, q)
    if any(sides):
        return sides[0] * sides[1] <= 0 and sides[2] * sides[3] <= 0
    return any(dot(minus(s, t), minus(s, u)) <= 0 for s, t, u in ((a, p, q), (b, p, q), (p, a, b), (q, a, b)))


def segment_meets(p, q, triangle):
    """Whether the segment p q has a point in the triangle, which has area."""
    normal = cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]))
    at_p, at_q = (dot(normal, minus(x, triangle[0])) for x in (p, q))
    if at_p * at_q > 0:
        return False
    if at_p == 0 and at_q == 0:
        return on_triangle(p, triangle, normal) or on_triangle(q, triangle, normal) or any(
            segments_meet(p, q, triangle[k], triangle[k - 2], normal) for k in range(3))
    share = at_p / (at_p - at_q)
    return on_triangle(tuple(x + share * (y - x) for x, y in zip(p, q)), triangle, normal)


def intersect_exactly(p, q, shared):
    """Whether triangles have a point in common besides the corners that they share, which come first."""
    p, q = [exactly(x) for x in p], [exactly(x) for x in q]
    if shared == 3:
        return True
    for t in (p, q):
        if not any(cross(minus(t[1], t[0]), minus(t[2], t[0]))):
            return False
    if shared == 2:
        across = [cross(minus(t[1], t[0]), minus(t[2], t[0])) for t in (p, q)]
        return not any(cross(*across)) and dot(*across) > 0
    if shared == 1:
        return segment_meets(p[1], p[2], q) or segment_meets(q[1], q[2], p)
    return any(segment_meets(p[k], p[k - 2], q) or segment_meets(q[k], q[k - 2], p) for k in range(3))


def intersecting_pairs(positions, triangles):
    """Pairs of triangles with a point in common besides the vertices that they share by number; those without area are left out."""
    corners = positions[triangles]
    pairs = overlapping_boxes(corners.min(axis=1), corners.max(axis=1))
    p, q = triangles[pairs[:, 0]], triangles[pairs[:, 1]]
    same = p[:, :, None] == q[:, None, :]
    count = same.any(axis=2).sum(axis=1)
    found = []
    for shared in range(4):
        chosen = numpy.flatnonzero(count == shared)
        in_p, in_q = same[chosen].any(axis=2), same[chosen].any(axis=1)
        first = numpy.take_along_axis(p[chosen], numpy.argsort(~in_p, axis=1, kind="stable"), axis=1)
        second = numpy.take_along_axis(q[chosen], numpy.argsort(~in_q, axis=1, kind="stable"), axis=1)
        if shared == 2:  # in the same order
            turned = first[:, 0] != second[:, 0]
            second[turned, 0], second[turned, 1] = second[turned, 1], second[turned, 0].copy()
        a, b = positions[first], positions[second]
        doubt = numpy.arange(len(chosen)) if shared == 3 else numpy.flatnonzero(~separated(a, b, shared))
        found += [pairs[chosen[i]].tolist() for i in doubt if intersect_exactly(a[i].tolist(), b[i].tolist(), shared)]
    return sorted(sorted(pair) for pair in found)
