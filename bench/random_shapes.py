#!/usr/bin/env python3
"""Runs verbs of the command on random shapes and compares files and reports with what independent judges measure.

usage: random_shapes.py VERB COUNT --command build/cli/orbicube --judges FOLDER [--first SEED] [--plain] [--keep FOLDER]

VERB is sphere, polycube or hex. Shapes depend on their seed alone: blobs, creatures, extrusions, boxes, unions of cells
of a grid, rods, plates, tori, noise and surfaces with slivers, of 100 to 1000 triangles, stretched up to 1000:1, far from
the origin, and scaled by 1e-300 to 1e300 (--plain: neither stretched, moved nor scaled). FOLDER holds the judges
measure_sphere.py, check_polycube.py and check_hex.py. A fault is a crash, an exit code other than 0, 1 and 2 or a
signal, or exit 0 where a judge calls the result invalid or measures a figure that differs from the report's by more
than 1 %. Files are brought to a size near 1 by a power of two before they are judged. Triangles whose height is below
1e-6 of their longest side, or below the rounding of their coordinates, are left out of figures. Needs numpy and scipy.
Exit code 1 when there are faults.
"""
import argparse
import collections
import json
import math
import os
import subprocess
import sys
import tempfile

import numpy as np

TOLERANCE = 0.01
DEGENERATE_HEIGHT = 1e-6


# ---------------------------------------------------------------- shapes

def icosphere(levels):
    g = (1 + 5 ** 0.5) / 2
    vertices = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g), (g, 0, -1),
                (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
             (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    vertices = [np.array(v) / np.linalg.norm(v) for v in vertices]
    for _ in range(levels):
        faces = split_in_four(vertices, faces)
        vertices = [v / np.linalg.norm(v) for v in vertices]
    return np.array(vertices), np.array(faces)


def split_in_four(vertices, faces):
    middles = {}

    def middle(a, b):
        key = (min(a, b), max(a, b))
        if key not in middles:
            middles[key] = len(vertices)
            vertices.append((vertices[a] + vertices[b]) / 2)
        return middles[key]
    result = []
    for a, b, c in faces:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        result += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
    return result


def refined(V, F, random, least=100):
    vertices, faces = [np.array(v, float) for v in V], [tuple(f) for f in F]
    while len(faces) < least:
        faces = split_in_four(vertices, faces)
    return np.array(vertices), np.array(faces)


def blob(random):
    V, F = icosphere(int(random.integers(1, 4)) if random.random() < .3 else 2)
    radius = np.ones(len(V))
    for _ in range(random.integers(2, 8)):
        axis = random.normal(size=3)
        radius += random.uniform(-.25, .25) * np.cos(random.uniform(1, 3) * (V @ axis / np.linalg.norm(axis)) + random.uniform(0, 6))
    return V * np.maximum(radius, .15)[:, None], F


def creature(random):
    V, F = icosphere(int(random.integers(2, 4)) if random.random() < .3 else 2)
    radius = np.full(len(V), .6)
    for _ in range(random.integers(2, 7)):
        axis = random.normal(size=3)
        radius += random.uniform(.5, 4) * np.exp(-random.uniform(8, 40) * (1 - V @ axis / np.linalg.norm(axis)))
    return V * radius[:, None], F


def noise(random):
    V, F = icosphere(2)
    return V + random.uniform(.01, .08) * random.normal(size=V.shape), F


def extrusion(random):
    n = int(random.integers(5, 30))
    angle = np.sort(random.uniform(0, 2 * math.pi, n)) if random.random() < .5 else np.arange(n) * 2 * math.pi / n
    if np.diff(np.append(angle, angle[0] + 2 * math.pi)).max() > 2.8 or np.diff(angle).min() < 1e-3:
        angle = np.arange(n) * 2 * math.pi / n
    radius = random.uniform(.4, 1, n)
    layers = int(random.integers(1, 6))
    vertices, faces = [], []
    for layer in range(layers + 1):
        for a, r in zip(angle, radius):
            vertices.append((r * math.cos(a), r * math.sin(a), layer / layers))
    for layer in range(layers):
        for i in range(n):
            a, b = layer * n + i, layer * n + (i + 1) % n
            faces += [(a, b, b + n), (a, b + n, a + n)]
    for z, first, turn in ((0, 0, True), (1, layers * n, False)):
        vertices.append((0, 0, z))
        for i in range(n):
            t = (len(vertices) - 1, first + i, first + (i + 1) % n)
            faces.append((t[0], t[2], t[1]) if turn else t)
    return refined(vertices, faces, random)


def of_cells(cells):
    """The surface of a set of unit cells, each quad as two triangles, vertices shared by position."""
    number, vertices, faces = {}, [], []
    corners = {(1, 0, 0): [(1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)], (-1, 0, 0): [(0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)],
               (0, 1, 0): [(0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0)], (0, -1, 0): [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)],
               (0, 0, 1): [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)], (0, 0, -1): [(0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)]}
    for cell in sorted(cells):
        for step, around in corners.items():
            if tuple(np.add(cell, step)) in cells:
                continue
            quad = []
            for corner in around:
                key = tuple(int(x) for x in np.add(cell, corner))
                if key not in number:
                    number[key] = len(vertices)
                    vertices.append(key)
                quad.append(number[key])
            faces += [(quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])]
    return np.array(vertices, float), np.array(faces)


def is_manifold(F):
    """Whether each edge has two triangles and each vertex one fan."""
    edges = collections.Counter()
    for t in F:
        for k in range(3):
            edges[tuple(sorted((t[k], t[(k + 1) % 3])))] += 1
    if set(edges.values()) != {2}:
        return False
    around = collections.defaultdict(dict)
    for a, b, c in F:
        for p, q, r in ((a, b, c), (b, c, a), (c, a, b)):
            around[p][q] = r
    for following in around.values():
        start = next(iter(following))
        at, seen = following[start], 1
        while at != start and seen <= len(following):
            at, seen = following[at], seen + 1
        if seen != len(following):
            return False
    return True


def genus_of(F):
    edges = {tuple(sorted((t[k], t[(k + 1) % 3]))) for t in F for k in range(3)}
    return (2 - (len(set(F.ravel().tolist())) - len(edges) + len(F))) // 2


def grid_solid(random):
    while True:
        cells = {(0, 0, 0)}
        for _ in range(random.integers(2, 22)):
            base = sorted(cells)[random.integers(len(cells))]
            axis = int(random.integers(3))
            step = [0, 0, 0]
            step[axis] = int(random.choice([-1, 1]))
            cells.add(tuple(int(x) for x in np.add(base, step)))
        V, F = of_cells(cells)
        if not is_manifold(F):
            continue
        # Planes at uneven distances, as of parts drawn by hand.
        for axis in range(3):
            planes = np.cumsum(random.uniform(.3, 1.5, 50))
            V[:, axis] = planes[(V[:, axis] + 24).astype(int)]
        return refined(V, F, random)


def frame_solid(random):
    size = [int(x) for x in random.integers(3, 5, 3)]
    cells = {(x, y, z) for x in range(size[0]) for y in range(size[1]) for z in range(2)}
    cells -= {(1, 1, z) for z in range(2)}
    return refined(*of_cells(cells), random)


def box(random):
    return refined(*of_cells({(0, 0, 0)}), random, least=[100, 300][random.integers(2)])


def rod(random):
    V, F = extrusion(random)
    V[:, 2] *= 10 ** random.uniform(0, 2)
    return V, F


def plate(random):
    V, F = extrusion(random)
    V[:, 2] *= 10 ** random.uniform(-2, 0)
    return V, F


def torus(random):
    n, m, r = int(random.integers(8, 24)), int(random.integers(5, 16)), random.uniform(.1, .6)
    V = [((1 + r * math.cos(b)) * math.cos(a), (1 + r * math.cos(b)) * math.sin(a), r * math.sin(b))
         for a in np.arange(n) * 2 * math.pi / n for b in np.arange(m) * 2 * math.pi / m]
    F = []
    for i in range(n):
        for j in range(m):
            a, b, c, d = i * m + j, (i + 1) % n * m + j, (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m
            F += [(a, b, c), (a, c, d)]
    return refined(V, F, random)


def with_slivers(random, V, F):
    """Edges get a vertex of one of their two sides only; the other side gets a triangle without height, or nearly."""
    vertices, faces = [v for v in V], [tuple(f) for f in F]
    for _ in range(random.integers(1, 1 + max(1, len(F) // 20))):
        t = int(random.integers(len(F)))
        a, b, c = faces[t]
        share = random.uniform(.2, .8)
        height = 0 if random.random() < .4 else 10 ** random.uniform(-16, -7)
        m = len(vertices)
        vertices.append((1 - share) * vertices[a] + share * vertices[b] + height * (vertices[c] - vertices[a]))
        faces[t] = (a, m, c)
        faces += [(m, b, c), (a, b, m)]
    return np.array(vertices), np.array(faces)


def random_rotation(random):
    q = random.normal(size=4)
    w, x, y, z = q / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def random_shape(seed, verb, plain):
    """(name, V, F)."""
    random = np.random.default_rng(seed)
    kinds = [blob, creature, extrusion, grid_solid, box, rod, plate, noise] + ([frame_solid, torus] if verb != 'sphere' else [])
    while True:
        kind = kinds[random.integers(len(kinds))]
        V, F = kind(random)
        if verb != 'sphere' or genus_of(F) == 0:
            break
    name = kind.__name__
    if verb != 'hex' and random.random() < .2:
        V, F = with_slivers(random, V, F)
        name += ' with slivers'
    if plain:
        return name, V, F
    if random.random() < .4:
        ratio = 10 ** random.uniform(0, 3)
        longest = random.random() < .5  # one long side, or one short one
        stretch = np.ones(3)
        stretch[random.integers(3)] = ratio if longest else 1 / ratio
        V = V * stretch
        name += ', %s 1:%.0f' % ('long' if longest else 'flat', ratio)
    if random.random() < .5:
        V = V @ random_rotation(random).T
        name += ', turned'
    if random.random() < .2:
        far = 10 ** random.uniform(0, 6)
        V = V + far * np.abs(V).max() * random.uniform(-1, 1, 3)
        name += ', %.1e sizes from the origin' % far
    if random.random() < .6:
        exponent = random.uniform(-300, 300)
        V = V * 10 ** exponent / np.abs(V).max()
        name += ', scaled to 1e%.0f' % exponent
    if random.random() < .1:
        V = np.concatenate([V, V.mean(0) + 5 * (V.max(0) - V.mean(0)) * random.normal(size=(3, 3))])
        name += ', 3 vertices in no face'
    return name, V, F


# ---------------------------------------------------------------- files

def write_off(path, V, F):
    with open(path, 'w') as file:
        file.write('OFF\n%d %d 0\n' % (len(V), len(F)))
        for p in V:
            file.write('%r %r %r\n' % tuple(float(x) for x in p))
        for t in F:
            file.write('3 %d %d %d\n' % tuple(t))


def read_off(path):
    words = open(path).read().split()
    n, m = int(words[1]), int(words[2])
    V = np.array([float(x) for x in words[4:4 + 3 * n]]).reshape(n, 3)
    F = np.array([int(x) for x in words[4 + 3 * n:4 + 3 * n + 4 * m]]).reshape(m, 4)[:, 1:]
    return V, F


def unit_exponent(V, F):
    """The power of two that brings the box of the faces' vertices to a size near 1."""
    used = V[np.unique(F)]
    half = (0.5 * used.max(0) - 0.5 * used.min(0)).max()
    return -math.frexp(half)[1] if half > 0 else 0


def scaled(V, exponent):
    return np.ldexp(np.ldexp(V, exponent // 2), exponent - exponent // 2)


def proper_faces(V, F):
    """Which faces are not degenerate."""
    T = V[F]
    e, f = T[:, 1] - T[:, 0], T[:, 2] - T[:, 0]
    longest = np.sqrt(np.maximum(np.maximum((e * e).sum(1), (f * f).sum(1)), ((e - f) ** 2).sum(1)))
    height = np.linalg.norm(np.cross(e, f), axis=1) / np.where(longest > 0, longest, 1)
    return height > np.maximum(1.001 * DEGENERATE_HEIGHT * longest, 4.01 * 2.0 ** -53 * np.abs(T).max((1, 2)))


# ---------------------------------------------------------------- judging

class Faults(list):
    def compare(self, name, reported, measured):
        if reported is None or not (math.isfinite(reported) and math.isfinite(measured)) or \
                abs(reported - measured) > TOLERANCE * max(abs(measured), abs(reported)) + 1e-9:
            self.append('%s: reported %r, measured %r' % (name, reported, measured))


def run_command(command, arguments, seconds):
    try:
        done = subprocess.run([command] + arguments, capture_output=True, text=True, timeout=seconds + 60, errors='replace')
        return done.returncode, (done.stdout + done.stderr).strip()
    except subprocess.TimeoutExpired:
        return None, 'did not end'


def judge_sphere(folder, args, V, F, faults):
    import measure_sphere
    S, G = read_off(os.path.join(folder, 'out.off'))
    report = json.load(open(os.path.join(folder, 'report.json')))
    if len(S) != len(V) or len(G) != len(F):
        faults.append('other vertices or faces')
        return
    U = scaled(V, unit_exponent(V, F))
    used = np.unique(F)
    S = S.copy()
    S[np.setdiff1d(np.arange(len(S)), used)] = (0, 0, 1)
    whole = measure_sphere.measure(U, F, S)
    if not whole['bijective']:
        faults.append('not one to one: %r' % whole)
        return
    proper = proper_faces(U, F)
    # The area of the whole surface is that of its proper faces but for a millionth of it.
    m = measure_sphere.measure(U, F[proper], S)
    for name, key in (('energy_angle', 'E_D'), ('energy_area', 'E_A'), ('energy', 'E'), ('mean_quasi_conformal', 'K_mean_area_weighted'),
                      ('max_quasi_conformal', 'K_max'), ('min_area_ratio', 'area_ratio_min'), ('max_area_ratio', 'area_ratio_max'),
                      ('stretch_efficiency', 'L2_stretch_efficiency'), ('isometric_mean', 'symm_dirichlet_mean')):
        faults.compare(name, report[name], m[key])
    if report['zero_area_faces'] != int((~proper).sum()):
        faults.append('%d degenerate faces reported, %d found' % (report['zero_area_faces'], int((~proper).sum())))
    args.table.append((m['K_mean_area_weighted'], whole['K_mean_area_weighted']))


def judge_polycube(folder, args, V, F, faults):
    exponent = unit_exponent(V, F)
    S, G = read_off(os.path.join(folder, 'surface.off'))
    P, H = read_off(os.path.join(folder, 'out.off'))
    report = json.load(open(os.path.join(folder, 'report.json')))
    S, P = scaled(S, exponent), scaled(P, exponent)
    unused = np.setdiff1d(np.arange(len(S)), np.unique(G))
    keep = np.setdiff1d(np.arange(len(S)), unused)
    number = np.full(len(S), -1)
    number[keep] = np.arange(len(keep))
    if not np.array_equal(G, H):
        faults.append('other faces')
        return
    used = np.unique(F)
    back = np.full(len(V), -1)
    back[used] = np.arange(len(used))
    write_off(os.path.join(folder, 'judged_input.off'), scaled(V, exponent)[used], back[F])
    write_off(os.path.join(folder, 'judged_surface.off'), S[keep], number[G])
    write_off(os.path.join(folder, 'judged_polycube.off'), P[keep], number[G])
    done = subprocess.run([sys.executable, os.path.join(args.judges, 'check_polycube.py'), 'judged_surface.off', 'judged_polycube.off',
                           '--input', 'judged_input.off', '--json'], cwd=folder, capture_output=True, text=True)
    verdict = json.loads(done.stdout)
    if not verdict['valid']:
        faults.append('invalid: %r' % (verdict.get('reasons') or verdict.get('unusable'),))
        return
    import judge_common
    m = judge_common.surface_distortion(S, P, G[proper_faces(S, G)])
    d = report['distortion']
    for name, kind, mean in (('angle_weighted_mean', 'eps_angle', 'weighted_mean'), ('area_weighted_mean', 'eps_area', 'weighted_mean'),
                             ('angle_mean', 'eps_angle', 'mean'), ('area_mean', 'eps_area', 'mean')):
        faults.compare(name, d[name], m[kind][mean])
    for name in ('corners', 'patches'):
        faults.compare(name, report[name], verdict['polycube'][name])
    args.table.append((d['angle_weighted_mean'], d['area_weighted_mean']))


def judge_hex(folder, args, V, F, faults):
    exponent = unit_exponent(V, F)
    report = json.load(open(os.path.join(folder, 'report.json')))
    lines, at = open(os.path.join(folder, 'out.mesh')).read().split('\n'), None
    for i, line in enumerate(lines):
        if line.strip() == 'Vertices':
            at, count = i + 2, int(lines[i + 1])
    rows = [line.split() for line in lines[at:at + count]]
    P = scaled(np.array([[float(x) for x in row[:3]] for row in rows]), exponent)
    lines[at:at + count] = ['%r %r %r 0' % tuple(float(x) for x in p) for p in P]
    open(os.path.join(folder, 'judged.mesh'), 'w').write('\n'.join(lines))
    used = np.unique(F)
    back = np.full(len(V), -1)
    back[used] = np.arange(len(used))
    write_off(os.path.join(folder, 'judged_input.off'), scaled(V, exponent)[used], back[F])
    done = subprocess.run([sys.executable, os.path.join(args.judges, 'check_hex.py'), 'judged.mesh', '--surface', 'judged_input.off', '--json'],
                          cwd=folder, capture_output=True, text=True)
    verdict = json.loads(done.stdout)
    if not verdict['valid']:
        faults.append('invalid: %r' % (verdict.get('reasons') or verdict.get('unusable'),))
        return
    faults.compare('hexahedra', report['hexahedra'], verdict['hexes'])
    faults.compare('min_scaled_jacobian', report['min_scaled_jacobian'], verdict['scaled_jacobian']['min'])
    faults.compare('mean_scaled_jacobian', report['mean_scaled_jacobian'], verdict['scaled_jacobian']['mean'])
    surface = verdict['surface']
    # Both distances are of samples; volume errors of some thousandths of a percent are those of rounding.
    if abs(report['volume_error_percent'] - surface['volume_error_percent']) > .01 * surface['volume_error_percent'] + 1e-4:
        faults.append('volume error: reported %r, measured %r' % (report['volume_error_percent'], surface['volume_error_percent']))
    if surface['hausdorff_percent'] > 1.01 * report['hausdorff_percent'] + .02:
        faults.append('distance: reported %r, measured %r' % (report['hausdorff_percent'], surface['hausdorff_percent']))
    args.table.append((report['min_scaled_jacobian'], surface['volume_error_percent']))


VERBS = {'sphere': (judge_sphere, ['out.off', '--text'], 60), 'polycube': (judge_polycube, ['out.off', '--text', '--surface', 'surface.off'], 120),
         'hex': (judge_hex, ['out.mesh'], 200)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('verb', choices=sorted(VERBS))
    parser.add_argument('count', type=int)
    parser.add_argument('--command', required=True)
    parser.add_argument('--judges', required=True, help='folder of the judges')
    parser.add_argument('--first', type=int, default=0, help='seed of the first shape [default: 0]')
    parser.add_argument('--plain', action='store_true', help='neither stretched, moved nor scaled')
    parser.add_argument('--cells', type=int, default=300, help='of hex [default: 300]')
    parser.add_argument('--arguments', default='', help='further words for the command')
    parser.add_argument('--seconds', type=int, default=0, help='time limit of the command for each shape')
    parser.add_argument('--keep', help='folder for the inputs of faults')
    parser.add_argument('--verbose', action='store_true', help='one line for each shape')
    args = parser.parse_args()
    sys.path.insert(0, args.judges)
    args.table = []
    args.command, args.judges = os.path.abspath(args.command), os.path.abspath(args.judges)
    judge, arguments, seconds = VERBS[args.verb]
    seconds = args.seconds or seconds
    codes, faulty, refusals = collections.Counter(), 0, collections.Counter()
    for seed in range(args.first, args.first + args.count):
        with np.errstate(all='ignore'), tempfile.TemporaryDirectory() as folder:
            name, V, F = random_shape(seed, args.verb, args.plain)
            path = os.path.join(folder, 'in.off')
            write_off(path, V, F)
            words = [path if x == 'in.off' else os.path.join(folder, x) if '.' in x else x for x in arguments]
            words = [args.verb, path, '-o'] + words + ['--report', os.path.join(folder, 'report.json'), '--time-limit', str(seconds)]
            if args.verb == 'hex':
                words += ['--cells', str(args.cells)]
            words += args.arguments.split()
            code, text = run_command(args.command, words, seconds)
            codes[code] += 1
            faults = Faults()
            if code == 0:
                try:
                    judge(folder, args, V, F, faults)
                except Exception as problem:  # what a judge cannot read is a fault as well
                    faults.append('the judge failed: %r' % problem)
            elif code not in (1, 2, 3):
                faults.append('exit code %r' % code)
            else:
                kind = text.split('error:')[-1].strip().split('\n')[0][-110:]
                refusals[kind] += 1
            if faults or args.verbose:
                print('%d %s (%d triangles): exit %r%s' % (seed, name, len(F), code, ''.join('\n    ' + f for f in faults)))
                if code != 0:
                    print('    ' + text[:300])
                sys.stdout.flush()
            if faults:
                faulty += 1
                if args.keep:
                    os.makedirs(args.keep, exist_ok=True)
                    write_off(os.path.join(args.keep, '%s_%d.off' % (args.verb, seed)), V, F)
    print('%s: %d shapes, exit codes %s, %d with faults' % (args.verb, args.count, dict(codes), faulty))
    for kind, times in refusals.most_common(12):
        print('    %d x %s' % (times, kind))
    if args.table:
        print('    medians %s' % np.median(np.array(args.table), 0))
    return 1 if faulty else 0


if __name__ == '__main__':
    sys.exit(main())
