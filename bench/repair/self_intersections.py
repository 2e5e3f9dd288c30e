#!/usr/bin/env python3
"""Repairs surfaces that intersect themselves by the command, with --wrap and without, and compares its certificates with exact ones.

    self_intersections.py --command build/cli/orbicube [--seeds N] [--first SEED] [--kinds KIND,...] [--wrap PERCENT] [--keep FOLDER]

Kinds: overlapping shells; shells almost or exactly on each other; inner walls of three and more faces an edge; cells of a grid, each with all of
its walls; patches folded over, or pushed through the opposite side; tubes through themselves; Klein bottles; crumpled surfaces with
holes; random triangles. Everything depends on the seed alone.

A certificate is right if the surface that was written is closed, oriented and manifold exactly when the report says so, if it has as
many intersecting pairs of triangles as the report says, which counts up to 10,000, and if the command fails exactly when it is not closed, oriented
and manifold. A wrap is right if moreover it is closed, oriented and manifold, no triangles intersect, and 300 of its vertices are at most
twice the distance (1.5 % of the diagonal, or --wrap) away from the input or the patches of its holes. Exit code 1 if any is wrong.
"""
import argparse
import collections
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy

from judging import diagonal_of, distances_to_surface, intersecting_pairs, is_solid, read_off, write_off

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from random_shapes import blob, icosphere  # noqa: E402  pylint: disable=wrong-import-position


def together(*parts):
    positions, triangles, count = [], [], 0
    for p, t in parts:
        positions.append(p)
        triangles.append(numpy.asarray(t) + count)
        count += len(p)
    return numpy.concatenate(positions), numpy.concatenate(triangles)


def overlapping(random):
    parts = []
    for _ in range(random.integers(2, 6)):
        positions, triangles = blob(random)
        parts.append((positions * random.uniform(0.4, 1) + random.uniform(-0.6, 0.6, 3), triangles))
    return together(*parts)


def almost_equal(random):
    """A surface and a copy with noise down to nothing."""
    positions, triangles = blob(random)
    noise = random.choice([0, 1e-12, 1e-6, 1e-3, 1e-2])
    copy = triangles[:, ::-1] if random.random() < 0.5 else triangles
    return together((positions, triangles), (positions + noise * random.normal(size=positions.shape), copy))


def inner_walls(random):
    """Sheets of vertices of the surface: each has edges with three faces where it is an edge's, and cuts the surface elsewhere."""
    positions, triangles = blob(random)
    for _ in range(random.integers(1, 4)):
        axis = random.normal(size=3)
        side = positions @ axis > random.uniform(-0.3, 0.3)
        rim = [(t[k], t[k - 2]) for t in triangles for k in range(3)
               if not side[t[k]] and not side[t[k - 2]] and side[t[k - 1]]]
        if rim:
            center = positions[[a for a, _ in rim]].mean(axis=0)
            wall = [(a, b, len(positions)) for a, b in rim]
            positions, triangles = numpy.concatenate([positions, [center]]), numpy.concatenate([triangles, wall])
    return positions, triangles


def cells(random):
    """Each cell of a set with all six sides, whether another has the same, in vertices of its own or shared."""
    corners = numpy.array([[v & 1, v >> 1 & 1, v >> 2] for v in range(8)])
    cube = numpy.array([[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4], [2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6], [1, 3, 5],
                        [3, 7, 5]])
    chosen = numpy.argwhere(random.random((3, 3, 3)) < 0.5)
    if len(chosen) == 0:
        chosen = numpy.zeros((1, 3), int)
    positions, triangles = together(*[(c + corners, cube) for c in chosen])
    if random.random() < 0.5:
        positions, number = numpy.unique(positions, axis=0, return_inverse=True)
        triangles = number.reshape(-1)[triangles]
    return positions.astype(float), triangles


def neighborhood(triangles, count, random, rings):
    reached = numpy.zeros(count, bool)
    reached[random.integers(count)] = True
    for _ in range(rings):
        reached[triangles[reached[triangles].any(axis=1)]] = True
    return reached


def folded(random):
    """Patches moved along the surface over their surroundings, or through the opposite side."""
    positions, triangles = blob(random)
    for _ in range(random.integers(1, 4)):
        patch = neighborhood(triangles, len(positions), random, random.integers(1, 3))
        center = positions[patch].mean(axis=0)
        if random.random() < 0.5:
            along = numpy.cross(center, random.normal(size=3))
            positions[patch] += random.uniform(0.3, 0.8) * along / numpy.linalg.norm(along)
        else:
            positions[patch] -= random.uniform(1, 3) * center
    return positions, triangles


def tube(random):
    """Around a closed curve that crosses itself, or comes near to it."""
    n, around = 80, 12
    t = numpy.arange(n) * 2 * numpy.pi / n
    lift = random.uniform(0, 0.4)
    curve = numpy.stack([numpy.sin(t), numpy.sin(2 * t) / 2, lift * numpy.cos(t)], axis=1)
    tangent = numpy.roll(curve, -1, axis=0) - numpy.roll(curve, 1, axis=0)
    tangent /= numpy.linalg.norm(tangent, axis=1)[:, None]
    second = numpy.cross(tangent, [0, 0, 1])
    second /= numpy.linalg.norm(second, axis=1)[:, None]
    third = numpy.cross(tangent, second)
    angle = numpy.arange(around) * 2 * numpy.pi / around
    positions = curve[:, None] + random.uniform(0.08, 0.3) * (
        numpy.cos(angle)[None, :, None] * second[:, None] + numpy.sin(angle)[None, :, None] * third[:, None])
    number = numpy.arange(n * around).reshape(n, around)
    a, b = number, numpy.roll(number, -1, axis=0)
    c, d = numpy.roll(b, -1, axis=1), numpy.roll(number, -1, axis=1)
    return positions.reshape(-1, 3), numpy.concatenate([numpy.stack(x, axis=-1).reshape(-1, 3) for x in ((a, b, c), (a, c, d))])


def klein_bottle(random):
    """The figure-eight immersion, which crosses itself along a circle."""
    n, m, radius = int(random.integers(20, 60)), 24, random.uniform(2, 3)
    u, v = numpy.meshgrid(numpy.arange(n) * 2 * numpy.pi / n, numpy.arange(m) * 2 * numpy.pi / m, indexing="ij")
    r = radius + numpy.cos(u / 2) * numpy.sin(v) - numpy.sin(u / 2) * numpy.sin(2 * v)
    z = numpy.sin(u / 2) * numpy.sin(v) + numpy.cos(u / 2) * numpy.sin(2 * v)
    positions = numpy.stack([r * numpy.cos(u), r * numpy.sin(u), z], axis=-1).reshape(-1, 3)
    triangles = []
    for i in range(n):
        for j in range(m):
            def at(k, l):
                return (k * m + l % m) if k < n else (-l) % m
            a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
            triangles += [(a, b, c), (a, c, d)]
    return positions, numpy.array(triangles)


def crumpled(random):
    positions, triangles = icosphere(3)
    positions = positions + random.uniform(0.05, 0.3) * random.normal(size=positions.shape)
    for _ in range(5):
        patch = neighborhood(triangles, len(positions), random, 1)
        triangles = triangles[~patch[triangles].all(axis=1)]
    return positions, triangles


def random_triangles(random):
    n = int(random.integers(20, 100))
    return random.random((3 * n, 3)), numpy.arange(3 * n).reshape(-1, 3)


MAX_PAIRS = 10_000  # that the certificate counts

KINDS = {"overlapping": overlapping, "almost-equal": almost_equal, "inner-walls": inner_walls, "cells": cells, "folded": folded, "tube": tube,
         "klein-bottle": klein_bottle, "crumpled": crumpled, "random": random_triangles}


def repaired(command, path, out, *options):
    """Exit code, what is printed of an error, the report, and the surface or None."""
    report = out + ".json"
    for old in (out, report):
        if os.path.exists(old):
            os.remove(old)
    done = subprocess.run([command, "repair", path, "-o", out, "--text", "--keep-partial", "--report", report, *options], capture_output=True, text=True,
                          check=False)
    figures = {}
    if os.path.exists(report):
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
    return done.returncode, done.stderr.strip(), figures, read_off(out) if os.path.exists(out) else None


def faults(code, error, figures, made):
    """What a certificate has wrong, and the number of intersecting pairs."""
    if code not in (0, 1):
        return [f"exit code {code}: {error}"], None
    if made is None:
        return [] if error else ["no word of why nothing was written"], None
    certificate = figures["certificate"]
    solid, pairs = is_solid(made[1]), len(intersecting_pairs(*made))
    wrong = []
    if solid != (certificate["closed"] and certificate["manifold"] and certificate["oriented"]):
        wrong.append("a solid" if solid else "no solid")
    if min(pairs, MAX_PAIRS) != certificate["self_intersections"]:
        wrong.append(f"{pairs} pairs of triangles intersect, not {certificate['self_intersections']}")
    if solid != (code == 0):
        wrong.append(f"exit code {code}")
    if not solid and not error:
        wrong.append("no word of what is missing")
    return wrong, pairs


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--command", required=True)
    parser.add_argument("--seeds", type=int, default=10)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--kinds", type=lambda text: text.split(","), default=list(KINDS))
    parser.add_argument("--wrap", type=float, default=1.5)
    parser.add_argument("--keep")
    options = parser.parse_args()
    options.command = os.path.abspath(options.command)
    wrong_in_all = 0
    print("| kind | surfaces | of them intersect | repaired to a solid | of them without intersections | certificate right | wrapped without intersections | largest "
          "distance / offset | certificate right |\n" + "|---" * 9 + "|")
    with tempfile.TemporaryDirectory() as folder:
        for number, kind in enumerate(KINDS):
            if kind not in options.kinds:
                continue
            count = collections.Counter()
            largest, lines = 0, []
            for seed in range(options.first, options.first + options.seeds):
                random = numpy.random.default_rng((seed, number))
                positions, triangles = KINDS[kind](random)
                path, out = os.path.join(options.keep or folder, f"{kind}-{seed}.off"), os.path.join(folder, "out.off")
                write_off(path, positions, triangles)
                count["intersect"] += len(intersecting_pairs(positions, triangles)) > 0
                code, error, figures, closed = repaired(options.command, path, out, "--keep", "0", "--cavities")
                wrong, pairs = faults(code, error, figures, closed)
                count["solid"] += code == 0
                count["clean"] += code == 0 and pairs == 0
                count["certificates"] += not wrong
                lines += [f"{kind}-{seed}: {w}" for w in wrong]
                distance = options.wrap / 100 * diagonal_of(positions)
                code, error, figures, made = repaired(options.command, path, out, "--keep", "0", "--wrap", repr(float(distance)))
                wrong, pairs = faults(code, error, figures, made)
                away = 0
                if made is not None:
                    chosen = random.choice(len(made[0]), min(300, len(made[0])), replace=False)
                    away = distances_to_surface(made[0][chosen], positions, triangles)
                    if closed is not None and away.max() > distance:
                        away = numpy.minimum(away, distances_to_surface(made[0][chosen], *closed))
                    away = away.max() / distance
                    largest = max(largest, away)
                good = code == 0 and pairs == 0 and away <= 2
                count["wraps"] += good
                count["wrap certificates"] += not wrong
                lines += [f"{kind}-{seed} --wrap: {w}" for w in wrong] + ([] if good else [f"{kind}-{seed} --wrap: code {code}, {pairs} pairs, {away:.2f} {error}"])
            print(f"| {kind} | {options.seeds} | {count['intersect']} | {count['solid']} | {count['clean']} | {count['certificates']} | {count['wraps']} | {largest:.2f} |"
                  f" {count['wrap certificates']} |", flush=True)
            for line in lines:
                print("  ", line, flush=True)
            wrong_in_all += len(lines)
    print(f"\n{wrong_in_all} wrong")
    return 1 if wrong_in_all else 0


if __name__ == "__main__":
    sys.exit(main())
