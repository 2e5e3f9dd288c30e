#!/usr/bin/env python3
"""Studies of generated subjects whose groups differ in a known place: what is found, what is found by chance, times, resuming.

    studies.py ORBICUBE [--subjects N] [--nulls N] [--only SECTION] [--write]

Prints the tables; with --write into docs/study_figures.md, all of them or the section `found`, `chance`, `times` or `killed`. Takes three minutes of
processor time for 200 subjects.
"""
import argparse
import csv
import hashlib
import json
import math
import os
import random
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "docs", "study_figures.md")
GRID = ("--grid", "icosphere:3")
POINTS = 642
EFFECT = 0.1  # growth of the second group at the pole, of the radius
SPREAD = 0.1  # standard deviation of that growth in each group
NOISE = 0.02  # standard deviation of each of eight smooth functions on the sphere, of the radius
LEVEL = 0.05
def run(orbicube, *words, report=None):
    arguments = [orbicube, *map(str, words), "--quiet"]
    if report:
        arguments += ["--report", report]
    subprocess.run(arguments, check=True)
    if report:
        with open(report, encoding="utf-8") as file:
            return json.load(file)
    return None


def read_obj(path):
    with open(path, encoding="ascii") as file:
        lines = [line.split() for line in file]
    return ([tuple(map(float, line[1:])) for line in lines if line[:1] == ["v"]],
            [" ".join(line[1:]) for line in lines if line[:1] == ["f"]])


def grown(spheres, number, group, draw):
    """Returns the points of the sphere and of the subject, and triangles as text."""
    points, triangles = spheres[number % len(spheres)]
    growth = draw.gauss(0, SPREAD) + EFFECT * group
    axes = [length * (1 + draw.gauss(0, 0.03)) for length in (1.5, 1.2, 1)]
    waves = [(draw.gauss(0, NOISE), [draw.gauss(0, 2) for _ in range(3)], draw.uniform(0, 2 * math.pi)) for _ in range(8)]
    moved = []
    for p in points:
        radius = 1 + growth * max(0, p[2]) ** 4 + 0.4 * max(0, p[0]) ** 2 + 0.25 * max(0, p[1]) ** 2
        radius += sum(size * math.sin(sum(a * b for a, b in zip(wave, p)) + phase) for size, wave, phase in waves)
        moved.append(tuple(radius * axis * x for axis, x in zip(axes, p)))
    return points, moved, triangles


def make_subjects(orbicube, folder, count):
    """Writes the subjects; returns the sphere's points and positions of the first one."""
    spheres = []
    for resolution in (1400, 1500, 1600, 1700, 1800):
        run(orbicube, "make", "sphere", "-o", os.path.join(folder, "sphere.obj"), "--resolution", resolution)
        spheres.append(read_obj(os.path.join(folder, "sphere.obj")))
    os.makedirs(os.path.join(folder, "in"))
    draw, first = random.Random(1), None
    for i in range(count):
        points, moved, triangles = grown(spheres, i, i % 2, draw)
        first = first or (points, moved)
        with open(os.path.join(folder, "in", f"s{i:03}.obj"), "w", encoding="ascii") as file:
            file.writelines("v %.17g %.17g %.17g\n" % p for p in moved)
            file.writelines(f"f {t}\n" for t in triangles)
    return first


def write_list(folder, name, groups):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="ascii") as file:
        file.write("file,group\n" + "".join(f"in/s{i:03}.obj,{'ab'[group]}\n" for i, group in enumerate(groups)))
    return path


def arrays(path):
    """Point data of mean.vtk."""
    with open(path, "rb") as file:
        data = file.read()
    result, at = {}, data.index(b"POINT_DATA")
    at = data.index(b"\n", at) + 1
    while at < len(data):
        end = data.index(b"\n", at)
        words, at = data[at:end].decode("ascii").split(), end + 1
        if words[:1] not in (["SCALARS"], ["VECTORS"]):
            continue
        count = POINTS if words[0] == "SCALARS" else 3 * POINTS
        at = at if words[0] == "VECTORS" else data.index(b"\n", at) + 1
        result[words[1]] = struct.unpack_from(f">{count}d", data, at)
        at += 8 * count
    return result


def ply_points(path):
    with open(path, "rb") as file:
        data = file.read()
    at = data.index(b"end_header\n") + len(b"end_header\n")
    return [struct.unpack_from("<3d", data, at + 24 * i) for i in range(POINTS)]


def heights(first, path):
    """z on the first subject's sphere of each point of the grid: that of the nearest vertex."""
    points, moved = first
    result = []
    for p in ply_points(path):
        nearest = min(range(len(moved)), key=lambda v: sum((a - b) ** 2 for a, b in zip(moved[v], p)))
        result.append(points[nearest][2])
    return result


def percent(values):
    return f"{100 * sum(values) / len(values):.1f} %"


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def bits(folder):
    """A hash of all files of a study."""
    result = hashlib.sha256()
    for place, folders, names in os.walk(folder):
        folders.sort()
        for name in sorted(names):
            with open(os.path.join(place, name), "rb") as file:
                result.update(name.encode() + file.read())
    return result.hexdigest()


def detection(orbicube, folder, table, first):
    text = """
## What is found

Share of the points with a false-discovery rate of 0.05 or less: where the growth is at least a tenth of its maximum, where it is less, and on the other half, which has none.
The difference is the group's, by the displacement of the points at the pole and the maximum on the other half, in units of the radius.

| align, placement, test | grown | margin | other half | family-wise, grown | family-wise, other half | difference at the pole | on the other half |
|---|---|---|---|---|---|---|---|
"""
    # The last is what null studies continue.
    for align, placement, test in (("shape", "robust", "normal"), ("shape", "turned", "position"), ("rotation", "kept", "normal"),
                                   ("rotation", "turned", "position"), ("rotation", "robust", "normal")):
        run(orbicube, "study", table, "-o", os.path.join(folder, "out"), *GRID, "--groups", "group", "--align", align, "--placement", placement,
            "--test", test)
        data, z = arrays(os.path.join(folder, "out", "mean.vtk")), heights(first, os.path.join(folder, "out", "subjects", "s000.ply"))
        places = ([v for v in range(POINTS) if z[v] > 0 and z[v] ** 4 >= 0.1],
                  [v for v in range(POINTS) if z[v] > 0 and z[v] ** 4 < 0.1], [v for v in range(POINTS) if z[v] <= 0])
        q, wise, difference = data["group_q"], data["group_p_family_wise"], data["group_difference"]
        length = [math.hypot(*difference[3 * v:3 * v + 3]) for v in range(POINTS)]
        cells = [percent([q[v] <= LEVEL for v in place]) for place in places]
        cells += [percent([wise[v] <= LEVEL for v in place]) for place in (places[0], places[2])]
        top = max(range(POINTS), key=lambda v: z[v])
        cells += [f"{length[top]:.3f}", f"{max(length[v] for v in places[2]):.3f}"]
        text += f"| {align}, {placement}, {test} | " + " | ".join(cells) + " |\n"
    return text


def rate(found, count):
    error = 100 * math.sqrt(max(found, 1) * max(count - found, 1) / count) / count
    return f"{found} of {count} ({100 * found / count:.0f} %, standard error {error:.1f} %)"


def nulls(orbicube, folder, subjects, count):
    by_q = by_wise = 0
    shares = []
    draw = random.Random(2)
    for _ in range(count):
        groups = [i % 2 for i in range(subjects)]
        draw.shuffle(groups)
        report = run(orbicube, "study", write_list(folder, "null.csv", groups), "-o", os.path.join(folder, "out"), *GRID, "--align", "rotation",
                     "--groups", "group", "--permutations", 500, report=os.path.join(folder, "report.json"))
        by_q += report["groups"]["points_q_0.05"] > 0
        by_wise += report["groups"]["points_family_wise_0.05"] > 0
        shares.append(sum(p <= LEVEL for p in arrays(os.path.join(folder, "out", "mean.vtk"))["group_p"]) / POINTS)
    return f"""
## What is found by chance

{count} studies of the same subjects whose groups are shuffled, 500 permutations each: no point differs. Studies with any discovery, which may be 5 %:
by false-discovery rates {rate(by_q, count)}; by family-wise p-values {rate(by_wise, count)}. Points with p <= 0.05: {100 * sum(shares) / count:.1f} % on average.
"""


def times(orbicube, folder, table):
    text = """
## Times

40 of the subjects, `--align rotation`. On a machine that others use, compare the processor seconds.

| threads | seconds | processor seconds | a subject | bits |
|---|---|---|---|---|
"""
    seconds, hashes = {}, {}
    with open(table, encoding="ascii") as file:
        count = sum(1 for _ in csv.DictReader(file))
    for threads in (1, 2):
        out = os.path.join(folder, f"threads-{threads}")
        start, used = time.monotonic(), processor_seconds()
        run(orbicube, "study", table, "-o", out, *GRID, "--align", "rotation", "--threads", threads)
        seconds[threads], hashes[threads] = time.monotonic() - start, bits(out)
        same = "the same" if hashes[threads] == hashes[1] else "DIFFERENT"
        used = processor_seconds() - used
        text += f"| {threads} | {seconds[threads]:.1f} | {used:.1f} | {used / count:.3f} | {same} |\n"
    return text + f"\n{seconds[1] / seconds[2]:.2f} times as fast with two threads.\n"


def resumed(orbicube, folder, table, rounds=3):
    text = """
## Killed and continued

`kill -9` at a random moment, two threads; the same command again. At most the subject that each thread works on is lost.

| finished when killed | of these made again | of | bits |
|---|---|---|---|
"""
    draw, out = random.Random(3), os.path.join(folder, "killed")
    words = ["study", table, "-o", out, *GRID, "--align", "rotation", "--threads", "2"]
    start = time.monotonic()
    run(orbicube, *words)
    seconds, expected = time.monotonic() - start, bits(out)
    for _ in range(rounds):
        shutil.rmtree(out)
        with subprocess.Popen([orbicube, *words, "--quiet"]) as process:
            time.sleep(draw.uniform(0.2, 0.8) * seconds)
            process.send_signal(signal.SIGKILL)
        kept = sum(name.endswith(".json") for name in os.listdir(os.path.join(out, "subjects")))
        report = run(orbicube, *words, report=os.path.join(folder, "report.json"))
        text += f"| {kept} | {kept - report['reused']} | {len(report['subjects'])} | {'the same' if bits(out) == expected else 'DIFFERENT'} |\n"
    return text


def write(sections):
    """Puts sections, each with its heading, in place of those of the page."""
    with open(PAGE, encoding="utf-8") as file:
        old = file.read().split("\n## ")
    known = {part.split("\n")[0]: part for part in old[1:]}
    for section in sections:
        text = section.removeprefix("\n## ").rstrip("\n") + "\n"
        known[text.split("\n")[0]] = text
    with open(PAGE, "w", encoding="utf-8") as file:
        file.write("\n## ".join([old[0], *known.values()]))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("orbicube")
    parser.add_argument("--subjects", type=int, default=200)
    parser.add_argument("--nulls", type=int, default=100)
    parser.add_argument("--only", choices=("found", "chance", "times", "killed"), default="")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    orbicube = os.path.abspath(options.orbicube)
    with tempfile.TemporaryDirectory() as folder:
        first = make_subjects(orbicube, folder, options.subjects)
        table = write_list(folder, "list.csv", [i % 2 for i in range(options.subjects)])
        few = write_list(folder, "few.csv", [i % 2 for i in range(min(40, options.subjects))])
        sections = {"found": lambda: detection(orbicube, folder, table, first),
                    "chance": lambda: nulls(orbicube, folder, options.subjects, options.nulls),
                    "times": lambda: times(orbicube, folder, few), "killed": lambda: resumed(orbicube, folder, few)}
        made = []
        for name, section in sections.items():
            if options.only in ("", name):
                made.append(section())
                print(made[-1], end="", flush=True)
    if options.write:
        write(made)


if __name__ == "__main__":
    sys.exit(main())
