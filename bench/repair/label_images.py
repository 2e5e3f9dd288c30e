#!/usr/bin/env python3
"""Extracts surfaces of generated label images by the command, maps them to the sphere, and judges both without the libraries.

    label_images.py --command build/cli/orbicube --judges FOLDER [--images N] [--first SEED] [--kinds KIND,...] [--keep FOLDER] [--write]

Kinds: smooth blobs; two protrusions that meet, with voxels at their walls turned at random (ventricle); loose voxels that touch in every way (touching);
balls with arcs and tunnels of one voxel (handles). Half of the images have oblique axes, voxels of unequal sides, or mirrored axes.
Everything depends on the seed alone. bench-labels does the same inside one program, on images of its own.

Solid means closed, oriented and manifold, of one part, genus 0 and positive volume, and without triangles that intersect (exactly). The
object is what a ray along each row of voxels finds inside the surface. "changed" is the share of voxels that differ between it and the
largest part of the label with its cavities filled. "distance" is the largest distance of vertices and centroids from the sides
between object and background, in voxels, and the other way round from the middles of these sides; the surface is within half a voxel if it is at
most 0.5. Exit code 1 if a surface is not solid, farther away, changed by other voxels than the report says, or not mapped.
--write puts the table into docs/repair_figures.md.
"""
import argparse
import collections
import json
import os
import subprocess
import sys
import tempfile

import numpy
import scipy.ndimage
import scipy.spatial

from judging import Section, euler_characteristic, intersecting_pairs, is_solid, read_off, volume_of

LABEL = 3
INTRODUCTION = """`bench/repair/label_images.py --write` generates images, extracts their surfaces by `orbicube surface` and maps them to the sphere. Half of the images have oblique or mirrored axes and
voxels of unequal sides. Ventricle: two protrusions that meet, with noise at their walls. Touching: loose voxels that touch in every way. Handles: a ball with arcs and tunnels of one
voxel. Solid: closed, oriented, manifold, of one part and genus 0, without triangles that intersect. Changed: voxels in which the object differs from the largest part of the label
with filled cavities. Distance: the largest one between the surface and the sides of the object's voxels, in voxels. All is judged by programs that use nothing of the libraries."""


# ---------------------------------------------------------------- images, indexed [x, y, z]

def grid(*size):
    return numpy.stack(numpy.meshgrid(*[numpy.arange(n) for n in size], indexing="ij"), axis=-1).astype(float)


def blobs(random):
    points = grid(26, 24, 22)
    centers = 5 + random.random((6, 3)) * [15, 13, 11]
    return sum(numpy.exp(-((points - c) ** 2).sum(axis=-1) / 14) for c in centers) > 0.4


def ventricle(random):
    points = grid(34, 30, 20)
    bend, radius = random.uniform(0.5, 1.5), random.uniform(2.5, 4)
    nearest = numpy.full(points.shape[:3], numpy.inf)
    for s in numpy.linspace(-1, 1, 41):
        for side in (-1, 1):
            center = [17 + side * (2.5 + 8 * s * s), 15 + 11 * s, 10 + 6 * bend * (s * s - 0.5)]
            nearest = numpy.minimum(nearest, numpy.linalg.norm(points - center, axis=-1))
    noise = random.random(nearest.shape) < 0.25 * numpy.exp(-abs(nearest - radius))
    return (nearest < radius) != noise


def touching(random):
    return random.random((12, 11, 10)) < random.uniform(0.3, 0.8)


def handles(random):
    points = grid(30, 30, 30)
    inside = numpy.linalg.norm(points - 15, axis=-1) < 8.3
    for _ in range(3):
        start, tilt = random.uniform(0, 6), random.uniform(0, 3)
        at = None
        for t in numpy.linspace(0, 2, 400):
            along = numpy.array([numpy.cos(start + t), numpy.sin(start + t) * numpy.cos(tilt), numpy.sin(start + t) * numpy.sin(tilt)])
            to = numpy.rint(15 + (8 + 4 * numpy.sin(numpy.pi * t / 2)) * along).astype(int)
            at = to if at is None else at
            for axis in range(3):  # through faces of voxels
                at = numpy.where(numpy.arange(3) == axis, to, at)
                inside[tuple(at)] = True
    for _ in range(2):
        x, y = random.integers(11, 20, 2)
        inside[x, y, :] = False
    return inside


KINDS = {"blobs": blobs, "ventricle": ventricle, "touching": touching, "handles": handles}


def matrix(random):
    """Columns: steps of one voxel along each axis."""
    if random.random() < 0.5:
        return numpy.eye(3)
    turned = numpy.linalg.qr(random.normal(size=(3, 3)))[0]  # mirrors or does not
    return turned * random.uniform(0.4, 2, 3)


def write_nrrd(path, inside, steps, origin):
    with open(path, "wb") as file:
        vectors = " ".join("(" + ",".join(map(repr, column.tolist())) + ")" for column in steps.T)
        file.write((f"NRRD0004\ntype: uint8\ndimension: 3\nspace: right-anterior-superior\nsizes: {' '.join(map(str, inside.shape))}\n"
                    f"space directions: {vectors}\nkinds: domain domain domain\nencoding: raw\n"
                    f"space origin: ({','.join(map(repr, origin.tolist()))})\n\n").encode("ascii"))
        file.write((LABEL * inside).astype(numpy.uint8).tobytes(order="F"))


# ---------------------------------------------------------------- what is right

def largest_part(inside):
    """Connected through faces, with its cavities filled, which are apart from the background's outside also over edges and corners."""
    parts, count = scipy.ndimage.label(inside)
    if count > 1:
        inside = parts == 1 + numpy.argmax(numpy.bincount(parts.ravel())[1:])
    background = scipy.ndimage.label(numpy.pad(~inside, 1, constant_values=True), numpy.ones((3, 3, 3)))[0]
    return (background != background[0, 0, 0])[1:-1, 1:-1, 1:-1]


def object_of(positions, triangles, size):
    """Voxels whose centers are inside, by rays along x. Rays pass beside the centers, nearer than the surface comes to any; each
    triangle is in a cell between eight centers, so that one ray alone can meet it."""
    beside = numpy.array([1.1e-3, 1.7e-3])
    a, b, c = (positions[triangles[:, k]] for k in range(3))
    cell = numpy.floor((a + b + c)[:, 1:] / 3).astype(int)
    ray = cell + beside

    def side(u, v):
        return (v[:, 1] - u[:, 1]) * (ray[:, 1] - u[:, 2]) - (v[:, 2] - u[:, 2]) * (ray[:, 0] - u[:, 1])
    sides = numpy.stack([side(a, b), side(b, c), side(c, a)])
    hit = (sides > 0).all(axis=0) | (sides < 0).all(axis=0)
    weight = sides[:, hit] / sides[:, hit].sum(axis=0)
    x = weight[1] * a[hit, 0] + weight[2] * b[hit, 0] + weight[0] * c[hit, 0]
    crossings = numpy.zeros((size[0] + 1, size[1] + 2, size[2] + 2), int)
    numpy.add.at(crossings, (numpy.ceil(x).astype(int), *(cell[hit].T + 1)), 1)
    return numpy.cumsum(crossings, axis=0)[:-1, 1:-1, 1:-1] % 2 == 1


def sides_of(inside):
    """Lower and upper corners of the unit squares between object and background."""
    padded = numpy.pad(inside, 1)
    low, high = [], []
    for axis in range(3):
        at = numpy.argwhere(numpy.diff(padded.astype(int), axis=axis) != 0) - 1.0
        reach = numpy.full(3, 0.5)
        reach[axis] = 0
        middle = at + 0.5 * numpy.eye(3)[axis]
        low.append(middle - reach)
        high.append(middle + reach)
    return numpy.concatenate(low), numpy.concatenate(high)


def distance_between(positions, triangles, inside):
    """The largest distance of the surface's vertices and centroids from the sides, and of the sides' middles from its vertices."""
    low, high = sides_of(inside)
    tree = scipy.spatial.cKDTree((low + high) / 2)
    points = numpy.concatenate([positions, positions[triangles].mean(axis=1)])
    # A side within 0.5 of a point has its middle within 0.5 + sqrt(0.5).
    near = tree.query(points, k=min(24, len(low)), distance_upper_bound=1.3)[1]
    found = numpy.full(len(points), numpy.inf)
    for column in near.T:
        valid = column < len(low)
        beyond = numpy.maximum(numpy.maximum(low[column[valid]] - points[valid], points[valid] - high[column[valid]]), 0)
        found[valid] = numpy.minimum(found[valid], numpy.linalg.norm(beyond, axis=1))
    back = scipy.spatial.cKDTree(positions).query((low + high) / 2)[0]
    return max(found.max(), back.max())


def run(command, *arguments):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "report.json")
        done = subprocess.run([command, *arguments, "--report", path, "--text"], capture_output=True, text=True, check=False)
        report = {}
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                report = json.load(file)
    return done.returncode, done.stderr.strip(), report


def judged(options, path, inside, steps, origin, folder):
    """What is wrong with the surface of an image, and figures of it."""
    surface, sphere = os.path.join(folder, "surface.off"), os.path.join(folder, "sphere.off")
    code, error, report = run(options.command, "surface", path, "--label", str(LABEL), "-o", surface)
    if code != 0:
        return [f"exit code {code}: {error}"], {}
    positions, triangles = read_off(surface)
    wrong = []
    if not (is_solid(triangles) and euler_characteristic(triangles) == 2 and volume_of(positions, triangles) > 0):
        wrong.append("no outward solid of genus 0")
    pairs = len(intersecting_pairs(positions, triangles))
    if pairs:
        wrong.append(f"{pairs} pairs of triangles intersect")
    voxels = numpy.linalg.solve(steps, (positions - origin).T).T
    found = object_of(voxels, triangles, inside.shape)
    changed = int((found != largest_part(inside)).sum())
    distance = distance_between(voxels, triangles, found)
    if distance > 0.5:
        wrong.append(f"{distance:.3f} voxels away")
    counted = report["handles"]["added_voxels"] + report["handles"]["removed_voxels"]
    if changed != counted:
        wrong.append(f"{changed} voxels changed, not {counted}")
    if run(options.command, "sphere", surface, "-o", sphere)[0] != 0:
        wrong.append("no map")
    elif subprocess.run([sys.executable, os.path.join(options.judges, "measure_sphere.py"), surface, sphere, "--json"], capture_output=True,
                        check=False).returncode != 0:
        wrong.append("the judge calls the map invalid")
    return wrong, {"voxels": int(found.sum()), "changed": changed, "distance": distance, "triangles": len(triangles)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--command", required=True)
    parser.add_argument("--judges", required=True)
    parser.add_argument("--images", type=int, default=200)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--kinds", type=lambda text: text.split(","), default=list(KINDS))
    parser.add_argument("--keep")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    options.command = os.path.abspath(options.command)
    lines_in_all = 0
    section = Section("Label images", INTRODUCTION)
    section.print("| images | | solid, within half a voxel, mapped | voxels | changed, % | triangles | distance |\n" + "|---" * 7 + "|")
    with tempfile.TemporaryDirectory() as folder:
        for number, kind in enumerate(KINDS):
            if kind not in options.kinds:
                continue
            total, distance, lines, good = collections.Counter(), 0, [], 0
            count = options.images // len(KINDS)
            for seed in range(options.first, options.first + count):
                random = numpy.random.default_rng((seed, number))
                inside, steps, origin = KINDS[kind](random), matrix(random), random.uniform(-100, 100, 3)
                path = os.path.join(options.keep or folder, f"{kind}-{seed}.nrrd")
                write_nrrd(path, inside, steps, origin)
                wrong, figures = judged(options, path, inside, steps, origin, folder)
                distance = max(distance, figures.pop("distance", 0))
                total.update(figures)
                good += not wrong
                lines += [f"{kind}-{seed}: {w}" for w in wrong]
            section.print(f"| {kind} | {count} | {good} | {total['voxels']} | {100 * total['changed'] / max(1, total['voxels']):.2f} | {total['triangles']} |"
                          f" {distance:.3f} |")
            for line in lines:
                print("  ", line, flush=True)
            lines_in_all += len(lines)
    if options.write:
        section.write()
    print(f"\n{lines_in_all} wrong")
    return 1 if lines_in_all else 0


if __name__ == "__main__":
    sys.exit(main())
