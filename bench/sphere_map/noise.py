#!/usr/bin/env python3
"""Measures how far noise moves maps to the sphere.

    noise.py --command build/cli/orbicube [--noise FRACTION] [--seeds N] FILE...

Each surface is mapped as it is, with other orders of decimation (`--seed` of the command), and with normal noise of the given fraction of the
diagonal (default: 0.001, root mean square of a vertex). A figure is the mean angle between two maps of a surface after the best rotation, in degrees,
weighted by area; each cell has the largest of N (default: 2). Seconds are those of both cores for the first map. Surfaces that are not closed are repaired first.
"""
import argparse
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "repair"))
from judging import diagonal_of, read_off, write_off  # noqa: E402  pylint: disable=wrong-import-position


def mapped(command, folder, positions, triangles, *options):
    surface, sphere = os.path.join(folder, "surface.off"), os.path.join(folder, "sphere.off")
    write_off(surface, positions, triangles)
    subprocess.run([command, "sphere", surface, "-o", sphere, "--text", *options], capture_output=True, check=True)
    return read_off(sphere)[0]


def weights_of(positions, triangles):
    """The area of the triangles at each vertex."""
    a, b, c = (positions[triangles[:, k]] for k in range(3))
    area = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1)
    return sum(numpy.bincount(triangles[:, k], area, len(positions)) for k in range(3))


def angle_between(first, second, weights):
    """Mean angle in degrees after the best rotation (Kabsch 1976)."""
    u, _, v = numpy.linalg.svd((first * weights[:, None]).T @ second)
    rotation = u @ numpy.diag([1, 1, numpy.sign(numpy.linalg.det(u @ v))]) @ v
    half = numpy.linalg.norm(first @ rotation - second, axis=1) / 2
    return numpy.degrees((2 * numpy.arcsin(numpy.minimum(half, 1)) * weights).sum() / weights.sum())


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+")
    parser.add_argument("--command", required=True)
    parser.add_argument("--noise", type=float, default=1e-3)
    parser.add_argument("--seeds", type=int, default=2)
    options = parser.parse_args()
    command = os.path.abspath(options.command)
    rows = []
    print("| surface | vertices | seconds | other order, degrees | noise, degrees |\n" + "|---" * 5 + "|")
    with tempfile.TemporaryDirectory() as folder:
        for path in options.files:
            start = os.path.join(folder, "start.off")
            subprocess.run([command, "repair", path, "-o", start, "--text"], capture_output=True, check=True)
            positions, triangles = read_off(start)
            weights = weights_of(positions, triangles)
            before = processor_seconds()
            original = mapped(command, folder, positions, triangles)
            seconds = processor_seconds() - before
            order, noise = [], []
            for seed in range(1, options.seeds + 1):
                order.append(angle_between(original, mapped(command, folder, positions, triangles, "--seed", str(seed)), weights))
                moves = numpy.random.default_rng(seed).normal(size=positions.shape) / numpy.sqrt(3)
                noisy = positions + options.noise * diagonal_of(positions) * moves
                noise.append(angle_between(original, mapped(command, folder, noisy, triangles), weights))
            rows.append((max(order), max(noise)))
            print(f"| {os.path.splitext(os.path.basename(path))[0]} | {len(positions)} | {seconds:.2f} | {rows[-1][0]:.2f} | {rows[-1][1]:.2f} |", flush=True)
    print(f"| mean | | | {numpy.mean([r[0] for r in rows]):.2f} | {numpy.mean([r[1] for r in rows]):.2f} |")


if __name__ == "__main__":
    main()
