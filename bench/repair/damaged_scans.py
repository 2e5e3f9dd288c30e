#!/usr/bin/env python3
"""Damages closed surfaces of genus 0 on purpose, repairs and maps them by the command, and judges what comes out.

    damaged_scans.py --command build/cli/orbicube --judges FOLDER [--seeds N] [--first SEED] [--kinds KIND,...] [--max-triangles N]
                     [--keep FOLDER] [--write] FILE...

Each surface is damaged in each of the ways alone, and in all together:

    holes       8 holes of 1 to 3 rings of triangles around a vertex
    specks      5 small cubes and 10 loose triangles beside the surface, and 5 tetrahedra inside
    flips       8 patches of 1 to 6 rings flipped
    duplicates  2 % of the triangles get vertices of their own, half of them at the same position and half at most 1e-8 of the diagonal away
    slivers     1 % of the triangles are split into slivers, whose height over length is 1e-12 to 1e-3, evenly by its logarithm: caps and needles
    fins        5 triangles at an edge of the surface that stand out from it

--seeds N does that N times. Everything depends on the seed alone. A hole that would cut the surface in two is made elsewhere.

Repaired means closed, oriented and manifold, of one part and genus 0, and without new pairs of triangles that intersect (exactly): new is a
pair farther than 0.5 % of the diagonal from all triangles that intersected before the damage. "outside" is the largest distance, over the
diagonal, from the repaired surface of triangles that no damage touched; 0 means that all of them are there, bit for bit. "patches" is that of
new vertices from the undamaged surface. "distortion" is the mean quasi-conformal distortion, weighted by area, of the map to the sphere as
measure_sphere.py of the judges measures it, before the damage and after. --write puts the tables into docs/repair_figures.md.
Exit code 1 if any surface is not repaired or not mapped, moves outside of the damage, or has a distortion that differs by more than 2 %.
"""
import argparse
import collections
import json
import os
import subprocess
import sys
import tempfile

import numpy
import scipy.sparse
import scipy.sparse.csgraph

from judging import Section, diagonal_of, distances_to_surface, euler_characteristic, intersecting_pairs, is_solid, read_off, write_off

INTRODUCTION = """`bench/repair/damaged_scans.py --write` damages closed surfaces of genus 0 on purpose, repairs them by `orbicube repair` without options, and maps them to
the sphere; seeds make the damage. All: 8 holes of 1 to 3 rings of triangles, 15 specks beside the surface and 5 inside, 8 flipped patches of up to 6 rings, 2 % of the triangles
with duplicates of their vertices, 1 % slivers, and 5 fins. Repaired: closed, oriented, manifold, of genus 0, and no triangles intersect
farther than 0.5 % of the diagonal from where some did before. Lost: triangles that no damage
touched and that are not in the result bit for bit. Outside: the largest distance of these from the result. Patches: that of new vertices from the undamaged surface. Both are
fractions of the diagonal. Distortion: the mean quasi-conformal distortion of the map to the sphere, of the undamaged surface and of the repaired one. Rows that end in ** are faults.
All is judged by programs that use nothing of the libraries."""

KINDS = ("holes", "specks", "flips", "duplicates", "slivers", "fins")
TOLERANCE = 0.02


class Scan:
    """A surface under damage; source is the undamaged triangle that each triangle still is, or -1."""

    def __init__(self, positions, triangles):
        self.positions, self.triangles = positions.copy(), triangles.copy()
        self.source = numpy.arange(len(triangles))
        self.diagonal = diagonal_of(positions)
        self.edge = numpy.median(numpy.linalg.norm(positions[triangles[:, 0]] - positions[triangles[:, 1]], axis=1))

    def around(self, random, rings):
        """Numbers of the triangles within rings of a random vertex of the surface."""
        reached = numpy.zeros(len(self.positions), bool)
        reached[random.choice(self.triangles[random.integers(len(self.triangles))])] = True
        for _ in range(rings):
            chosen = reached[self.triangles].any(axis=1)
            reached[self.triangles[chosen]] = True
        return numpy.flatnonzero(chosen)

    def add(self, positions, triangles):
        self.triangles = numpy.concatenate([self.triangles, numpy.asarray(triangles) + len(self.positions)])
        self.positions = numpy.concatenate([self.positions, positions])
        self.source = numpy.concatenate([self.source, numpy.full(len(triangles), -1)])

    def touch(self, chosen):
        self.source[chosen] = -1

    def normal(self, t):
        a, b, c = self.positions[self.triangles[t]]
        n = numpy.cross(b - a, c - a)
        return n / max(numpy.linalg.norm(n), 1e-300)


def parts_of(triangles):
    """The number of parts whose triangles share edges."""
    edges = numpy.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    number = numpy.unique(edges, axis=0, return_inverse=True)[1].reshape(-1)
    order = numpy.argsort(number, kind="stable")
    same = numpy.flatnonzero(number[order[1:]] == number[order[:-1]])
    of = order // 3
    graph = scipy.sparse.coo_matrix((numpy.ones(len(same)), (of[same], of[same + 1])), shape=(len(triangles),) * 2)
    return scipy.sparse.csgraph.connected_components(graph, directed=False)[0]


def holes(scan, random):
    for _ in range(8):
        while True:
            gone = scan.around(random, random.integers(1, 4))
            rest = numpy.delete(scan.triangles, gone, axis=0)
            if parts_of(rest) == parts_of(scan.triangles):
                break
        scan.triangles = rest
        scan.source = numpy.delete(scan.source, gone)


def specks(scan, random):
    tetrahedron = numpy.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    cube = numpy.array([[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4], [2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6], [1, 3, 5],
                        [3, 7, 5]])
    corners = numpy.array([[v & 1, v >> 1 & 1, v >> 2] for v in range(8)], float) - 0.5
    for k in range(20):
        t = random.integers(len(scan.triangles))
        place = scan.positions[scan.triangles[t]].mean(axis=0)
        size = random.uniform(0.1, 0.5) * scan.edge
        if k < 5:
            scan.add(place + 2 * scan.edge * scan.normal(t) + size * corners, cube)
        elif k < 10:
            scan.add(place - scan.edge * scan.normal(t) + size * random.normal(size=(4, 3)), tetrahedron)
        else:
            scan.add(place + 2 * scan.edge * scan.normal(t) + size * random.normal(size=(3, 3)), [[0, 1, 2]])


def flips(scan, random):
    for _ in range(8):
        chosen = scan.around(random, random.integers(1, 7))
        scan.triangles[chosen] = scan.triangles[chosen][:, ::-1]


def duplicates(scan, random):
    """Moved duplicates touch all triangles at the vertex, since any of the positions may remain."""
    chosen = random.choice(len(scan.triangles), len(scan.triangles) // 50, replace=False)
    moved = numpy.zeros(len(scan.positions), bool)
    added = [scan.positions]
    count = len(scan.positions)
    for number, t in enumerate(chosen):
        corners = scan.positions[scan.triangles[t]]
        if number % 2:
            moved[scan.triangles[t]] = True
            corners = corners + 1e-8 / numpy.sqrt(3) * scan.diagonal * random.uniform(-1, 1, (3, 3))
        added.append(corners)
    scan.touch(moved[scan.triangles].any(axis=1))
    for t in chosen:
        scan.triangles[t] = count, count + 1, count + 2
        count += 3
    scan.positions = numpy.concatenate(added)


def slivers(scan, random):
    """A cap splits a triangle at a point beside an edge, a needle splits an edge beside its end; no triangle is split twice."""
    halves = {}
    for t, corners in enumerate(scan.triangles.tolist()):
        for k in range(3):
            halves[corners[k], corners[k - 2]] = t
    split = numpy.zeros(len(scan.triangles), bool)
    near = numpy.zeros(len(scan.positions), bool)
    positions, triangles = [scan.positions], []
    count = len(scan.positions)
    wanted = len(scan.triangles) // 100
    for t in random.permutation(len(scan.triangles)):
        if wanted <= 0:
            break
        k = random.integers(3)
        a, b, c = numpy.roll(scan.triangles[t], -k).tolist()
        other = halves.get((b, a))
        if split[t] or other is None or split[other]:
            continue
        ratio = 10 ** random.uniform(-12, -3)
        pa, pb, pc = scan.positions[[a, b, c]]
        if random.random() < 0.5:
            middle = (pa + pb) / 2
            positions.append([middle + 2 * ratio * (pc - middle)])
            triangles += [(a, b, count), (b, c, count), (c, a, count)]
            split[t] = True
            scan.touch(other)  # whose edge with the cap may be flipped
            wanted -= 1
        else:
            d = next(v for v in scan.triangles[other].tolist() if v not in (a, b))
            positions.append([pa + ratio * (pb - pa)])
            triangles += [(a, count, c), (count, b, c), (count, a, d), (b, count, d)]
            split[t] = split[other] = True
            near[a] = True
            wanted -= 2
        count += 1
    # A needle's edge may be collapsed to either end.
    scan.touch(near[scan.triangles].any(axis=1))
    scan.triangles = numpy.concatenate([scan.triangles[~split], numpy.array(triangles, numpy.int64).reshape(-1, 3)])
    scan.source = numpy.concatenate([scan.source[~split], numpy.full(len(triangles), -1)])
    scan.positions = numpy.concatenate(positions)


def fins(scan, random):
    for t in random.choice(len(scan.triangles), 5, replace=False):
        a, b, _ = scan.triangles[t].tolist()
        top = scan.positions[[a, b]].mean(axis=0) + 0.5 * scan.edge * scan.normal(t)
        scan.add([top], [[a - len(scan.positions), b - len(scan.positions), 0]])


# Slivers first, since they need the surface's edges; duplicates after what chooses patches by shared vertices.
ORDER = {"slivers": slivers, "holes": holes, "flips": flips, "fins": fins, "duplicates": duplicates, "specks": specks}


def damaged(positions, triangles, kinds, seed):
    """A damaged copy of a surface, and which of its triangles were not touched."""
    scan = Scan(positions, triangles)
    for number, (kind, work) in enumerate(ORDER.items()):
        if kind in kinds:
            work(scan, numpy.random.default_rng((seed, number)))
    untouched = numpy.zeros(len(triangles), bool)
    untouched[scan.source[scan.source >= 0]] = True
    return scan.positions, scan.triangles, untouched


# ---------------------------------------------------------------- command and judges

def run(command, verb, *arguments):
    """Exit code, text of the error, and the report."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "report.json")
        done = subprocess.run([command, verb, *arguments, "--report", path], capture_output=True, text=True, check=False)
        report = {}
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                report = json.load(file)
    return done.returncode, done.stderr.strip().splitlines()[-1:] or [""], report


def distortion(options, surface, folder):
    """The mean quasi-conformal distortion of the map to the sphere, or None and why there is none."""
    sphere = os.path.join(folder, "sphere.off")
    code, error, _ = run(options.command, "sphere", surface, "-o", sphere, "--text")
    if code != 0:
        return None, error[0]
    judged = subprocess.run([sys.executable, os.path.join(options.judges, "measure_sphere.py"), surface, sphere, "--json"], capture_output=True,
                            text=True, check=False)
    if judged.returncode != 0:
        return None, "the judge calls the map invalid"
    return json.loads(judged.stdout)["K_mean_area_weighted"], ""


def triples(positions, triangles):
    """Each triangle by its positions, the smallest one first, so that equal ones of one orientation are equal."""
    corners = positions[triangles].tolist()
    result = []
    for t in corners:
        first = t.index(min(t))
        result.append((tuple(t[first]), tuple(t[first - 2]), tuple(t[first - 1])))
    return result


Result = collections.namedtuple("Result", "repaired why pairs lost outside patches")
NEAR = 0.005  # of the diagonal


def new_pairs(clean, made):
    """The numbers of intersecting pairs of a repaired surface, and of those that are not near to ones of the undamaged surface."""
    pairs = intersecting_pairs(*made)
    if not pairs or not clean["pairs"]:
        return len(pairs), len(pairs)
    positions, triangles = clean["surface"]
    centers = made[0][made[1][numpy.array(pairs)]].mean(axis=2)
    away = distances_to_surface(centers.reshape(-1, 3), positions, triangles[numpy.unique(clean["pairs"])]).reshape(-1, 2).min(axis=1)
    return len(pairs), int((away > NEAR * diagonal_of(positions)).sum())


def judged(clean, untouched, made):
    """What a repaired surface is, beside the undamaged one."""
    surface = clean["surface"]
    diagonal = diagonal_of(surface[0])
    solid = is_solid(made[1]) and euler_characteristic(made[1]) == 2
    pairs, fresh = new_pairs(clean, made)
    before, there = triples(*surface), set(triples(*made))
    lost = [t for t in numpy.flatnonzero(untouched) if before[t] not in there]
    outside = patches = 0
    if lost:
        corners = surface[0][surface[1][lost]]
        outside = distances_to_surface(numpy.concatenate([corners.reshape(-1, 3), corners.mean(axis=1)]), *made).max() / diagonal
    added = set(map(tuple, made[0].tolist())) - set(map(tuple, surface[0].tolist()))
    if added:
        patches = distances_to_surface(numpy.array(sorted(added)), *surface).max() / diagonal
    why = "" if solid else "no solid of genus 0"
    if fresh:
        why += f"{fresh} new intersecting pairs"
    return Result(not why, why, pairs, len(lost), outside, patches)


Row = collections.namedtuple("Row", "repaired mapped outside change", defaults=(False, False, 0, None))


def is_fine(row):
    return row.repaired and row.outside == 0 and row.mapped and abs(row.change) <= 100 * TOLERANCE


def run_one(options, section, name, clean, kinds, seed, before, folder):
    """Prints and returns a row of the table."""
    positions, triangles, untouched = damaged(*clean["surface"], kinds, seed)
    label = "all" if len(kinds) > 1 else kinds[0]
    path, out = os.path.join(options.keep or folder, f"{name}-{label}-{seed}.off"), os.path.join(folder, "repaired.off")
    write_off(path, positions, triangles)
    if os.path.exists(out):
        os.remove(out)
    code, error, _ = run(options.command, "repair", path, "-o", out, "--text", "--keep-partial")
    columns = [name, label, seed, len(triangles)]
    if not os.path.exists(out):
        section.print("| " + " | ".join(map(str, [*columns, error[0]])) + " | **")
        return Row()
    result = judged(clean, untouched, read_off(out))
    after, why = distortion(options, out, folder) if result.repaired else (None, "")
    change = 100 * (after / before - 1) if after else None
    row = Row(result.repaired, after is not None, result.outside, change)
    columns += ["yes" if result.repaired else "no: " + (result.why or f"exit code {code}"), len(clean["pairs"]), result.pairs, result.lost,
                f"{result.outside:.1e}", f"{result.patches:.1e}", "yes" if after else "no " + why, f"{before:.4f}"]
    columns += [f"{after:.4f}", f"{change:+.2f}"] if after else ["", ""]
    section.print("| " + " | ".join(map(str, columns)) + (" |" if is_fine(row) else " | **"))
    return row


def print_summary(section, rows):
    """One line for each kind of damage."""
    section.print()
    section.print("| damage | surfaces | repaired | largest movement outside / diagonal | mapped | largest change of the distortion, % | all as it has to be |\n"
          + "|---" * 7 + "|")
    for kind, of_kind in rows.items():
        changes = [abs(row.change) for row in of_kind if row.change is not None]
        section.print(f"| {kind} | {len(of_kind)} | {sum(row.repaired for row in of_kind)} | {max(row.outside for row in of_kind):.1e} |"
                      f" {sum(row.mapped for row in of_kind)} | {max(changes, default=0):.2f} | {sum(map(is_fine, of_kind))} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+")
    parser.add_argument("--command", required=True)
    parser.add_argument("--judges", required=True)
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--kinds", type=lambda text: text.split(","), default=[*KINDS, "all"])
    parser.add_argument("--max-triangles", type=int, default=25000)
    parser.add_argument("--keep")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    options.command = os.path.abspath(options.command)
    rows = collections.defaultdict(list)
    section = Section("Damaged scans", INTRODUCTION)
    section.print("| model | damage | seed | triangles | repaired | intersecting pairs before | after | lost | outside | patches | mapped | distortion before |"
          " after | change, % |\n" + "|---" * 14 + "|")
    with tempfile.TemporaryDirectory() as folder:
        for path in options.files:
            name = os.path.splitext(os.path.basename(path))[0]
            start = os.path.join(folder, "start.off")
            code, _, _ = run(options.command, "repair", path, "-o", start, "--text")
            if code != 0:
                section.print(f"| {name} | is no surface that can be repaired |")
                continue
            surface = read_off(start)
            if len(surface[1]) > options.max_triangles or euler_characteristic(surface[1]) != 2 or not is_solid(surface[1]):
                continue
            before, why = distortion(options, start, folder)
            if before is None:
                section.print(f"| {name} | {why} |")
                continue
            clean = {"surface": surface, "pairs": intersecting_pairs(*surface)}
            for kind in options.kinds:
                for seed in range(options.first, options.first + options.seeds):
                    kinds = KINDS if kind == "all" else (kind,)
                    rows[kind].append(run_one(options, section, name, clean, kinds, seed, before, folder))
    print_summary(section, rows)
    if options.write:
        section.write()
    return 0 if rows and all(is_fine(row) for of_kind in rows.values() for row in of_kind) else 1


if __name__ == "__main__":
    sys.exit(main())
