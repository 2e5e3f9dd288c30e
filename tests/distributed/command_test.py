#!/usr/bin/env python3
"""`orbicube untangle --solver petsc` on two processes: what it writes is positive by rational arithmetic, a wrong input
ends all processes with its exit code.

    command_test.py COMMAND MPIRUN
"""
import os
import subprocess
import sys
import tempfile
from fractions import Fraction

COMMAND, MPIRUN = os.path.abspath(sys.argv[1]), sys.argv[2]


def run(*arguments):
    return subprocess.run([MPIRUN, "-n", "2", "--oversubscribe", COMMAND, *arguments], capture_output=True, text=True,
                          timeout=100, check=False)


def cube(n):
    """Positions and tetrahedra of the unit cube: each of n^3 cubes as the six around its diagonal."""
    number = lambda p: (p[0] * (n + 1) + p[1]) * (n + 1) + p[2]
    positions = [[x / n, y / n, z / n] for x in range(n + 1) for y in range(n + 1) for z in range(n + 1)]
    cells = []
    for start in ((x, y, z) for x in range(n) for y in range(n) for z in range(n)):
        for order, odd in (((0, 1, 2), 0), ((1, 2, 0), 0), ((2, 0, 1), 0), ((0, 2, 1), 1), ((2, 1, 0), 1), ((1, 0, 2), 1)):
            p, cell = list(start), [number(start)]
            for axis in order:
                p[axis] += 1
                cell.append(number(p))
            if odd:
                cell[2], cell[3] = cell[3], cell[2]
            cells.append(cell)
    return positions, cells


def write(path, positions, cells):
    with open(path, "w", encoding="ascii") as file:
        file.write(f"MeshVersionFormatted 2\nDimension 3\nVertices\n{len(positions)}\n")
        file.writelines(f"{x!r} {y!r} {z!r} 0\n" for x, y, z in positions)
        file.write(f"Tetrahedra\n{len(cells)}\n")
        file.writelines(" ".join(str(v + 1) for v in cell) + " 0\n" for cell in cells)
        file.write("End\n")


def determinant(positions, cell):
    a, b, c, d = ([Fraction(x) for x in positions[v]] for v in cell)
    u, v, w = ([p[i] - a[i] for i in range(3)] for p in (b, c, d))
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
            + u[2] * (v[0] * w[1] - v[1] * w[0]))


def read(path):
    with open(path, encoding="ascii") as file:
        words = file.read().split()
    start = words.index("Vertices") + 2
    positions = [[float(c) for c in words[start + 4 * i:start + 4 * i + 3]] for i in range(int(words[start - 1]))]
    start = words.index("Tetrahedra") + 2
    return positions, [[int(v) - 1 for v in words[start + 5 * i:start + 5 * i + 4]] for i in range(int(words[start - 1]))]


with tempfile.TemporaryDirectory() as folder:
    tangled, rest, out = (os.path.join(folder, name) for name in ("tangled.mesh", "rest.mesh", "out.mesh"))
    positions, cells = cube(4)
    write(rest, positions, cells)
    inside = [all(0 < x < 1 for x in p) for p in positions]
    write(tangled, [[0.9 - 0.8 * p[1], p[0], p[2] * p[2]] if i else p for p, i in zip(positions, inside)], cells)
    before, _ = read(tangled)
    assert any(determinant(before, cell) <= 0 for cell in cells)
    done = run("untangle", tangled, "-o", out, "--rest", rest, "--solver", "petsc")
    assert done.returncode == 0, done.stderr
    assert done.stdout.count("wrote") == 1, done.stdout  # by one process only
    after, same = read(out)
    assert same == cells
    assert all(determinant(after, cell) > 0 for cell in cells)
    assert all(p == q for p, q, i in zip(positions, after, inside) if not i)
    done = run("untangle", os.path.join(folder, "missing.mesh"), "-o", out, "--solver", "petsc")
    assert done.returncode == 2, (done.returncode, done.stderr)
    assert "missing.mesh: io" in done.stderr, done.stderr
    print("ok")
