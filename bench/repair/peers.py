#!/usr/bin/env python3
"""Repairs damaged surfaces by Orbicube, MeshFix (PyPI: pymeshfix; Attene 2010) and trimesh, and prints what came out of each.

    bench-repair --damaged FOLDER FILE...        then
    peers.py ORBICUBE FILE...                    FILE: FOLDER/NAME.off, or any surface

Every result is judged alike: closed, oriented and manifold by counting edges and the triangles around each vertex; pairs of triangles
that intersect by exact arithmetic of the command. With NAME.clean.off beside NAME.off also: how many vertices of the undamaged surface
are still at their place, bit for bit and within 1e-6 of the diagonal (MeshFix computes in float32), and the error of the volume. A program
that is not installed is left out. Seconds include reading the file, and for Orbicube the start of the command and its report. trimesh has
no repair of its own: the steps are its functions in the order of its documentation, and others may do better.
"""

import collections
import json
import os
import subprocess
import sys
import tempfile
import time

import numpy

from judging import is_solid, read_off, volume_of, write_off

try:
    import pymeshfix
except ImportError:
    pymeshfix = None
try:
    import trimesh
except ImportError:
    trimesh = None


def report_of(orbicube, *arguments):
    with tempfile.TemporaryDirectory() as folder:
        report = os.path.join(folder, "report.json")
        subprocess.run([orbicube, *arguments, "-o", os.path.join(folder, "out.off"), "--report", report], capture_output=True, check=False)
        if not os.path.exists(report):
            return None, None
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        out = os.path.join(folder, "out.off")
        return figures, read_off(out) if os.path.exists(out) else None


def by_orbicube(orbicube, path):
    return report_of(orbicube, "repair", path)[1]


def by_meshfix(_, path):
    positions, triangles = read_off(path)
    return pymeshfix.clean_from_arrays(numpy.ascontiguousarray(positions), numpy.ascontiguousarray(triangles.astype(numpy.int32)))


def by_trimesh(_, path):
    mesh = trimesh.Trimesh(*read_off(path), process=True)
    mesh.update_faces(mesh.nondegenerate_faces())
    mesh.update_faces(mesh.unique_faces())
    mesh.remove_unreferenced_vertices()
    parts = mesh.split(only_watertight=False)
    mesh = max(parts, key=lambda part: part.area)
    trimesh.repair.fix_normals(mesh)
    mesh.fill_holes()
    trimesh.repair.fix_normals(mesh)
    return numpy.asarray(mesh.vertices), numpy.asarray(mesh.faces)


def share_within(points, others, distance):
    """The share of points with one of the others within the distance, in percent."""
    found = 0
    for part in numpy.array_split(points, max(1, len(points) // 200)):
        nearest = numpy.full(len(part), numpy.inf)
        for block in numpy.array_split(others, max(1, len(others) // 4000)):
            nearest = numpy.minimum(nearest, ((part[:, None] - block[None]) ** 2).sum(axis=2).min(axis=1))
        found += (nearest <= distance ** 2).sum()
    return 100 * found / len(points)


def judged(orbicube, path, positions, triangles):
    """solid, intersecting pairs, vertices kept to the bit and nearly, in percent, error of the volume in percent."""
    with tempfile.TemporaryDirectory() as folder:
        result = os.path.join(folder, "result.off")
        write_off(result, positions, triangles)
        figures, _ = report_of(orbicube, "repair", result, "--keep-partial", "--skip", "weld", "clean", "slivers", "t-junctions", "orient",
                               "contacts", "parts", "holes")
    pairs = figures.get("certificate", {}).get("self_intersections") if figures else None
    clean_path = path[:-len(".off")] + ".clean.off"
    kept = near = error = None
    if os.path.exists(clean_path):
        clean, faces = read_off(clean_path)
        there = set(map(tuple, positions.tolist()))
        kept = 100 * numpy.mean([tuple(p) in there for p in clean.tolist()])
        near = share_within(clean, positions, 1e-6 * numpy.linalg.norm(numpy.ptp(clean, axis=0)))
        error = 100 * (volume_of(positions, triangles) / volume_of(clean, faces) - 1)
    return is_solid(triangles), pairs, kept, near, error


def main():
    orbicube, paths = os.path.abspath(sys.argv[1]), sys.argv[2:]
    programs = {"Orbicube": by_orbicube}
    if pymeshfix:
        programs["MeshFix"] = by_meshfix
    if trimesh:
        programs["trimesh"] = by_trimesh
    solid, exact = collections.Counter(), collections.Counter()
    print("| surface | program | solid | intersecting pairs | vertices kept, bits, % | within 1e-6, % | volume, % | s |\n|---|---|---|---|---|---|---|---|")
    for path in paths:
        for name, program in programs.items():
            start = time.perf_counter()
            try:
                made = program(orbicube, path)
            except Exception as error:  # pylint: disable=broad-except
                print(f"| {os.path.basename(path)} | {name} | {type(error).__name__}: {str(error)[:60]} | | | | | |")
                continue
            seconds = time.perf_counter() - start
            if made is None or len(made[1]) == 0:
                print(f"| {os.path.basename(path)} | {name} | nothing | | | | | {seconds:.2f} |")
                continue
            good, pairs, kept, near, error = judged(orbicube, path, numpy.asarray(made[0]), numpy.asarray(made[1]))
            solid[name] += good
            exact[name] += good and pairs == 0
            numbers = ["" if value is None else f"{value:.3f}" for value in (kept, near, error)]
            print(f"| {os.path.basename(path)} | {name} | {'yes' if good else 'no'} | {pairs} | {' | '.join(numbers)} | {seconds:.2f} |", flush=True)
    for name in programs:
        print(f"\n{name}: {solid[name]} of {len(paths)} closed, oriented and manifold, {exact[name]} of them without intersecting triangles")


if __name__ == "__main__":
    main()
