#!/usr/bin/env python3
"""Multigrid of the library beside peers, on six generated systems in one run; writes docs/linear_tables.md.

    bench/linear/multigrid.py BUILD [SIZE]

BUILD  a build folder set up with -Dbench=true and -Dpetsc=enabled, in which bench-linear-multigrid is built
SIZE   scales the edges of the grids [default: 1]; the page is written for 1 only

Needs numpy, and SciPy and PyAMG for the rows of PyAMG. About a minute.
"""
import ctypes
import os
import subprocess
import sys
import tempfile
import time

for threads in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ[threads] = "1"

import numpy as np  # noqa: E402

try:
    import pyamg
    import scipy.sparse
except ImportError:
    pyamg = None

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from programs import processor  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PAGE = os.path.join(ROOT, "docs", "linear_tables.md")
TOLERANCE = 1e-8
HEAD = """\
# Multigrid compared

Written by `bench/linear/multigrid.py BUILD`. Conjugate gradients to a residual of 1e-8 of that of zero, preconditioned by the multigrid of this library, by GAMG of {petsc},
by BoomerAMG of {hypre} through PETSc, and by smoothed aggregation of {pyamg}, all with their default options, on one process of one thread. Seconds of the
processor, a core of {processor} on a machine that did other work; the smallest sum of each system in bold. `residual`: of the result, computed by the bench. For three unknowns a
vertex the peers know the size of the blocks. The solutions of the library with one and two threads have the same bits on {same} of {count} systems.

| system | unknowns | entries | engine | setup | solution | sum | iterations | residual |
|---|---|---|---|---|---|---|---|---|
"""
TAIL = """
The grids have zero around them; coefficients of the system with jumps are those of blocks of 8 x 8 x 8 vertices, from 1e-3 to 1e3 at random. The triangles of the harmonic map are numbered at
random, and only a millionth of the diagonal keeps its matrix from being singular, as that of the springs.
"""


def versions():
    """Returns those of the peers, as the page names them."""
    major, minor, patch, release = (ctypes.c_int() for _ in range(4))
    petsc = ctypes.CDLL("libpetsc.so")
    petsc.PetscGetVersionNumber(*map(ctypes.byref, (major, minor, patch, release)))
    names = {"petsc": f"PETSc {major.value}.{minor.value}.{patch.value}",
             "pyamg": "PyAMG " + pyamg.__version__ if pyamg else "PyAMG, which is not installed here"}
    hypre, text = ctypes.CDLL("libHYPRE.so"), ctypes.c_char_p()
    hypre.HYPRE_Version(ctypes.byref(text))
    names["hypre"] = "hypre " + next(word for word in text.value.decode().split() if word[0].isdigit())
    return names


def read_system(path):
    """Returns the matrix and the right side of a file of bench-linear-multigrid."""
    with open(path, "rb") as file:
        n, entries, block = np.fromfile(file, np.int64, 3)
        begin, column = np.fromfile(file, np.int32, n + 1), np.fromfile(file, np.int32, entries)
        value, right = np.fromfile(file, np.float64, entries), np.fromfile(file, np.float64, n)
    matrix = scipy.sparse.csr_matrix((value, column, begin), shape=(n, n))
    matrix.sort_indices()
    return (matrix.tobsr((block, block)) if block > 1 else matrix), right


def by_pyamg(path):
    """Returns seconds of setup and solution, iterations and the residual."""
    matrix, right = read_system(path)
    start, residuals = time.process_time(), []
    solver = pyamg.smoothed_aggregation_solver(matrix)
    made = time.process_time()
    x = solver.solve(right, tol=TOLERANCE, maxiter=2000, accel="cg", residuals=residuals)
    solved = time.process_time()
    return made - start, solved - made, len(residuals) - 1, np.linalg.norm(right - matrix @ x) / np.linalg.norm(right)


def main():
    program = os.path.join(os.path.abspath(sys.argv[1]), "bench", "linear", "bench-linear-multigrid")
    size = sys.argv[2] if len(sys.argv) > 2 else "1"
    systems = {}
    with tempfile.TemporaryDirectory() as folder:
        output = subprocess.run([program, folder, size], check=True, capture_output=True, text=True).stdout
        for line in output.splitlines():
            name, unknowns, entries, engine, setup, solve, iterations, residual, same = line.split("\t")
            systems.setdefault(name, []).append(
                (unknowns, entries, engine, float(setup), float(solve), int(iterations), float(residual), same))
        for number, rows in enumerate(systems.values()):
            if pyamg:
                rows.append((*rows[0][:2], "PyAMG", *by_pyamg(os.path.join(folder, f"{number}.system")), ""))
    same = sum(row[-1] == "same" for rows in systems.values() for row in rows)
    text = HEAD.format(processor=processor(), same=same, count=len(systems), **versions())
    for name, rows in systems.items():
        least = min(setup + solve for _, _, _, setup, solve, *_ in rows)
        for unknowns, entries, engine, setup, solve, iterations, residual, _ in rows:
            total = f"{setup + solve:.3f}"
            text += (f"| {name} | {unknowns} | {entries} | {engine} | {setup:.3f} | {solve:.3f} | "
                     f"{'**' + total + '**' if setup + solve == least else total} | {iterations} | {residual:.0e} |\n")
    text += TAIL
    print(text, end="")
    if size == "1":
        with open(PAGE, "w", encoding="utf-8") as page:
            page.write(text)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    main()
