#!/usr/bin/env python3
"""gap_shapes.py FOLDER [--count N] [--first I]: writes closed surfaces with narrow gaps, as OFF files.

Shape I is the same in every run: its family is I modulo 10, its gap runs through .001 to .05 of the bounding-box diagonal, its
other measures are random with the seed I. Each is a closed manifold of genus 0 in one piece (bowl-and-ball: two pieces) that does
not meet itself. Families: C-rings of round and of flat section, spirals of round and of flat section, clips, serpentines,
coils, combs of fingers, balls on a stem in a bowl, balls in a bowl.
"""
import argparse
import math
import os
import random

FAMILIES = ['ring', 'flat-ring', 'spiral', 'flat-spiral', 'clip', 'serpentine', 'coil', 'fingers', 'stem-bowl', 'ball-bowl']


def gap_of(index):
    """Geometric from .001 to .05 over fifteen steps, each family at others."""
    step = (7 * (index // len(FAMILIES)) + 4 * (index % len(FAMILIES))) % 15
    return .001 * 50 ** (step / 14)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(sum(x * x for x in a))
    return tuple(x / length for x in a)


def section(kind, width, height, count):
    """Points of a closed curve, counter-clockwise: an ellipse, or a rectangle with rounded corners (superellipse of degree 8)."""
    points = []
    for k in range(count):
        t = 2 * math.pi * (k + .5) / count
        c, s = math.cos(t), math.sin(t)
        r = 1 if kind == 'round' else 1 / (abs(c) ** 8 + abs(s) ** 8) ** (1 / 8)
        points.append((width / 2 * r * c, height / 2 * r * s))
    return points


def sweep(path, up, points):
    """A tube along a path in space with flat ends: `up` is about normal to all of the path. The first coordinate of the section
    is along up x direction, the second along up."""
    vertices, faces = [], []
    n, m = len(path), len(points)
    for i, p in enumerate(path):
        if i in (0, n - 1) and n > 2:
            # Of second order: a chord would tilt ends that face each other into one another.
            step = 1 if i == 0 else -1
            along = unit(tuple(step * (4 * path[i + step][k] - 3 * p[k] - path[i + 2 * step][k]) for k in range(3)))
        else:
            along = unit(tuple(y - x for x, y in zip(path[max(i - 1, 0)], path[min(i + 1, n - 1)])))
        side = unit(cross(up, along))
        top = cross(along, side)
        for u, v in points:
            vertices.append(tuple(p[k] + u * side[k] + v * top[k] for k in range(3)))
    for i in range(n - 1):
        for k in range(m):
            a, b = i * m + k, i * m + (k + 1) % m
            faces += [(a, b, b + m), (a, b + m, a + m)]
    # Ends: rings that shrink to the middle.
    for end, ring, turned in ((0, list(range(m)), True), (n - 1, list(range((n - 1) * m, n * m)), False)):
        for part in (.66, .33):
            first = len(vertices)
            for v in range(m):
                outer = vertices[(0 if end == 0 else (n - 1) * m) + v]
                vertices.append(tuple(path[end][k] + part * (outer[k] - path[end][k]) for k in range(3)))
            for k in range(m):
                a, b, c, d = ring[k], ring[(k + 1) % m], first + (k + 1) % m, first + k
                faces += [(a, c, b), (a, d, c)] if turned else [(a, b, c), (a, c, d)]
            ring = list(range(first, first + m))
        vertices.append(path[end])
        for k in range(m):
            a, b = ring[k], ring[(k + 1) % m]
            faces.append((a, len(vertices) - 1, b) if turned else (a, b, len(vertices) - 1))
    return vertices, faces


def revolve(profile, count):
    """A profile (r, z) that begins and ends on the axis, going around the solid on its left."""
    vertices, faces = [(0., 0., profile[0][1])], []
    inner = profile[1:-1]
    for r, z in inner:
        vertices += [(r * math.cos(2 * math.pi * k / count), r * math.sin(2 * math.pi * k / count), z) for k in range(count)]
    vertices.append((0., 0., profile[-1][1]))
    at = lambda i, k: 1 + i * count + k % count
    for k in range(count):
        faces.append((0, at(0, k + 1), at(0, k)))
        for i in range(len(inner) - 1):
            faces += [(at(i, k), at(i, k + 1), at(i + 1, k + 1)), (at(i, k), at(i + 1, k + 1), at(i + 1, k))]
        faces.append((len(vertices) - 1, at(len(inner) - 1, k), at(len(inner) - 1, k + 1)))
    return vertices, faces


def blocks(planes, solid):
    """The surface of the cells (i, j, k) of a grid for which solid(i, j, k)."""
    numbers, vertices, faces = {}, [], []
    size = [len(p) - 1 for p in planes]
    inside = lambda c: all(0 <= c[a] < size[a] for a in range(3)) and solid(*c)

    def number(corner):
        if corner not in numbers:
            numbers[corner] = len(vertices)
            vertices.append(tuple(planes[a][corner[a]] for a in range(3)))
        return numbers[corner]

    for i in range(size[0]):
        for j in range(size[1]):
            for k in range(size[2]):
                cell = (i, j, k)
                if not inside(cell):
                    continue
                for a in range(3):
                    for step in (0, 1):
                        other = list(cell)
                        other[a] += 2 * step - 1
                        if inside(other):
                            continue
                        corners = []
                        for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
                            corner = list(cell)
                            corner[a] += step
                            corner[(a + 1) % 3] += u
                            corner[(a + 2) % 3] += v
                            corners.append(number(tuple(corner)))
                        if step == 0:
                            corners.reverse()
                        faces += [(corners[0], corners[1], corners[2]), (corners[0], corners[2], corners[3])]
    return vertices, faces


def arc(radius, begin, end, gap, centre=(0., 0.)):
    """Points so near to each other that chords are less than a quarter of the gap off."""
    step = min(.12, math.sqrt(2 * gap / radius))
    count = max(2, math.ceil(abs(end - begin) / step))
    return [(centre[0] + radius * math.cos(begin + (end - begin) * k / count),
             centre[1] + radius * math.sin(begin + (end - begin) * k / count)) for k in range(count + 1)]


def straight(a, b, step):
    count = max(1, math.ceil(math.dist(a, b) / step))
    return [tuple(x + (y - x) * k / count for x, y in zip(a, b)) for k in range(count)]


def ring(rng, gap, kind):
    width, height = rng.uniform(.3, .6), rng.uniform(.3, .6)
    angle = gap / (1 - width / 2)       # the gap is that at the inside
    path = [(x, y, 0.) for x, y in arc(1, angle / 2, 2 * math.pi - angle / 2, .02)]
    return sweep(path, (0., 0., 1.), section(kind, width, height, 24))


def spiral(rng, gap, kind):
    width = rng.uniform(.15, .3)
    height = width if kind == 'round' else rng.uniform(.3, .8)
    pitch, turns = width + gap, rng.uniform(1.6, 2.6)
    begin = rng.uniform(.6, 1.) * pitch + width / 2
    path, t = [], 0.
    while t < 2 * math.pi * turns:
        r = begin + pitch * t / (2 * math.pi)
        path.append((r * math.cos(t), r * math.sin(t), 0.))
        t += min(.12, math.sqrt(2 * gap / (r + width)))
    return sweep(path, (0., 0., 1.), section(kind, width, height, 20))


def clip(rng, gap, _):
    width, height, length = rng.uniform(.2, .4), rng.uniform(.2, .5), rng.uniform(.8, 1.6)
    # Round at the bend with room for the section, then legs that come near to each other.
    radius = width / 2 + max(gap / 2, rng.uniform(.1, .3))
    half = (width + gap) / 2
    bend = [(x, y) for x, y in arc(radius, math.pi * 1.5, math.pi * .5, .02)]
    path = []
    for k in range(41):
        t = 1 - k / 40
        s = min(1, t * length / (.6 * length)) if t < .6 else 1
        s = s * s * (3 - 2 * s)
        path.append((t * length, -(radius + (half - radius) * s), 0.))
    path = path[:-1] + [(x, y, 0.) for x, y in bend] + [(x, -y, 0.) for x, y, _ in reversed(path[:-1])]
    return sweep(path, (0., 0., 1.), section('flat' if rng.random() < .5 else 'round', width, height, 20))


def serpentine(rng, gap, _):
    width, height, length = rng.uniform(.2, .3), rng.uniform(.2, .4), rng.uniform(.8, 1.4)
    bends, radius = rng.choice([2, 3]), (width + gap) / 2
    path, y = [], 0.
    for k in range(bends + 1):
        a, b = ((0., y), (length, y)) if k % 2 == 0 else ((length, y), (0., y))
        path += straight(a, b, .06)
        if k < bends:
            turn = arc(radius, -math.pi / 2, math.pi / 2, .001, (0., y + radius))
            path += [(b[0] + (x if k % 2 == 0 else -x), z) for x, z in turn][:-1]
            y += 2 * radius
        else:
            path.append(b)
    # The inside of a bend is a point of radius gap / 2: sections are narrower there than the path's radius by that.
    return sweep([(x, z, 0.) for x, z in path], (0., 0., 1.), section('flat', width, height, 20))


def coil(rng, gap, _):
    width, turns = rng.uniform(.2, .35), rng.uniform(1.5, 2.5)
    pitch = width + gap
    path = []
    count = int(turns * 2 * math.pi / .12)
    for k in range(count + 1):
        t = 2 * math.pi * turns * k / count
        path.append((math.cos(t), math.sin(t), pitch * 1.02 * t / (2 * math.pi)))
    return sweep(path, (0., 0., 1.), section('round', width, width, 20))


def fingers(rng, gap, _):
    count, width = rng.choice([2, 3, 4]), rng.uniform(.25, .4)
    length, palm, thick = rng.uniform(.6, 1.2), rng.uniform(.3, .5), rng.uniform(.25, .4)
    x, is_finger = [0.], []
    for k in range(count):
        for part in range(4):
            x.append(x[-1] + width / 4)
            is_finger.append(True)
        if k + 1 < count:
            x.append(x[-1] + gap)
            is_finger.append(False)
    y = [palm * k / 4 for k in range(4)] + [palm + length * k / 10 for k in range(11)]
    z = [thick * k / 4 for k in range(5)]
    vertices, faces = blocks([x, y, z], lambda i, j, k: is_finger[i] or j < 4)
    # Bent sideways and forward, which keeps lines along the gaps parallel.
    bend = rng.uniform(0, .5)
    warped = [(a, b, c + bend * b * b * .5) for a, b, c in vertices]
    return warped, faces


def bowl_profile(radius, inner, opening, gap):
    """From the bottom of the bowl outside, over its rim, to the axis inside."""
    profile = [(r, z) for r, z in arc(radius, -math.pi / 2, -opening, gap)]
    back = [(r, z) for r, z in arc(inner, -opening, -math.pi / 2, gap)]
    rim = straight(profile[-1], back[0], .08)
    return profile[:-1] + rim + back


def stem_bowl(rng, gap, _):
    ball, wall, stem = 1., rng.uniform(.25, .5), rng.uniform(.25, .4)
    inner, opening = ball + gap, rng.uniform(0., .5)
    profile = bowl_profile(inner + wall, inner, opening, gap)
    begin = math.asin(stem / inner)
    profile = [p for p in profile[:-1] if p[0] > stem * 1.05 or math.hypot(*p) > inner + wall / 2]
    profile.append((inner * math.sin(begin), -inner * math.cos(begin)))
    angle = math.asin(stem / ball)
    profile += arc(ball, angle - math.pi / 2, math.pi / 2, gap)
    profile[0], profile[-1] = (0., profile[0][1]), (0., profile[-1][1])
    return revolve(profile, 40)


def ball_bowl(rng, gap, _):
    ball, wall = 1., rng.uniform(.25, .5)
    inner, opening = ball + gap, rng.uniform(0., .4)
    profile = bowl_profile(inner + wall, inner, opening, gap)
    profile[0], profile[-1] = (0., profile[0][1]), (0., profile[-1][1])
    vertices, faces = revolve(profile, 40)
    sphere = [(r, z) for r, z in arc(ball, -math.pi / 2, math.pi / 2, gap)]
    sphere[0], sphere[-1] = (0., sphere[0][1]), (0., sphere[-1][1])
    more, others = revolve(sphere, 40)
    first = len(vertices)
    return vertices + more, faces + [tuple(v + first for v in f) for f in others]


MAKERS = {'ring': (ring, 'round'), 'flat-ring': (ring, 'flat'), 'spiral': (spiral, 'round'), 'flat-spiral': (spiral, 'flat'),
          'clip': (clip, ''), 'serpentine': (serpentine, ''), 'coil': (coil, ''), 'fingers': (fingers, ''),
          'stem-bowl': (stem_bowl, ''), 'ball-bowl': (ball_bowl, '')}


def diagonal(vertices):
    return math.sqrt(sum((max(v[k] for v in vertices) - min(v[k] for v in vertices)) ** 2 for k in range(3)))


def shape(index):
    """Name, relative gap, vertices and faces of a shape."""
    family = FAMILIES[index % len(FAMILIES)]
    make, kind = MAKERS[family]
    relative, gap = gap_of(index), gap_of(index) * 2
    for _ in range(4):                      # the diagonal depends on the gap
        vertices, faces = make(random.Random(index), gap, kind)
        gap = relative * diagonal(vertices)
    # Turned in space, as shapes come.
    rng = random.Random(1000 + index)
    axis = [unit(tuple(rng.gauss(0, 1) for _ in range(3)))]
    axis.append(unit(cross(axis[0], tuple(rng.gauss(0, 1) for _ in range(3)))))
    axis.append(cross(axis[0], axis[1]))
    vertices = [tuple(sum(axis[k][a] * v[k] for k in range(3)) for a in range(3)) for v in vertices]
    return family, relative, vertices, faces


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('folder')
    parser.add_argument('--count', type=int, default=100)
    parser.add_argument('--first', type=int, default=0)
    options = parser.parse_args()
    os.makedirs(options.folder, exist_ok=True)
    for index in range(options.first, options.first + options.count):
        family, gap, vertices, faces = shape(index)
        with open(os.path.join(options.folder, f'{index:03d}-{family}-{gap:.4f}.off'), 'w') as out:
            out.write(f'OFF\n{len(vertices)} {len(faces)} 0\n')
            out.writelines('%.17g %.17g %.17g\n' % v for v in vertices)
            out.writelines('3 %d %d %d\n' % f for f in faces)


if __name__ == '__main__':
    main()
