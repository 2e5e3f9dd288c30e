"""The table of the problems with bounds only: this library, NLopt's L-BFGS and SciPy's L-BFGS-B (10 pairs), each until
the projected gradient is at most 1e-6 or f within 1e-6 (relative) of the known minimum; and ASA_CG's published counts
where a file of them is given.

Usage: bound_problems.py BENCH_BOUND_PROBLEMS LIBBOUND_PROBLEMS [ASA_CG_RESULTS]

Prints Markdown: evaluations of value and gradient and seconds, "-" where a solver ended unsolved. Needs numpy and scipy."""
import math
import os
import pathlib
import subprocess
import sys
import time

import numpy
import scipy.optimize

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from programs import load_problems, pointer  # noqa: E402

LIMIT = 50000


class Solved(Exception):
    pass


def run_scipy(library, index):
    """Returns the name, and (evaluations, seconds), or None where it ended unsolved."""
    problem = library.bound_make(index)
    n = library.bound_size(problem)
    optimum, tolerance = library.bound_optimum(problem), library.bound_tolerance(problem)
    start, lower, upper = numpy.empty(n), numpy.empty(n), numpy.empty(n)
    library.bound_data(problem, pointer(start), pointer(lower), pointer(upper))
    count = 0

    def evaluate(x):
        nonlocal count
        count += 1
        x = numpy.ascontiguousarray(x)
        gradient = numpy.empty(n)
        value = library.bound_evaluate(problem, pointer(x), pointer(gradient))
        near = optimum != 0 and value <= optimum + 1e-6 * abs(optimum)
        if near or numpy.abs(numpy.clip(x - gradient, lower, upper) - x).max() <= tolerance:
            raise Solved
        return value, gradient

    began = time.perf_counter()
    outcome = None
    try:
        scipy.optimize.minimize(evaluate, numpy.clip(start, lower, upper), jac=True, method="L-BFGS-B",
                                bounds=scipy.optimize.Bounds(lower, upper),
                                options=dict(maxcor=10, ftol=0, gtol=0, maxfun=LIMIT, maxiter=LIMIT))
    except Solved:
        outcome = (count, time.perf_counter() - began)
    name = library.bound_name(problem).decode()
    library.bound_free(problem)
    return name, outcome


def published(path):
    counts = {}
    for line in pathlib.Path(path).read_text().splitlines():
        words = line.split()
        if len(words) == 9 and words[1].isdigit() and words[5] == "0":
            counts[words[0]] = f"{words[3]} + {words[4]} (n={words[1]})"
    return counts


def cell(outcome):
    return f"{outcome[0]} | {outcome[1]:.3f}" if outcome else "- | -"


def main(program, module, counts=None):
    library = load_problems(module, "bound", sizes=("size",), numbers=("optimum", "tolerance"), arrays={"data": 3})
    asa = published(counts) if counts else {}
    runs = {}
    for line in subprocess.run([program], capture_output=True, text=True, check=True).stdout.splitlines():
        name, n, solver, solved, evaluations, seconds, *_ = line.split("\t")
        runs[name, solver] = (int(evaluations), float(seconds)) if solved == "1" else None
        runs[name, "n"] = n
    print("| problem | n | default | seconds | L-BFGS-B | seconds | NLopt L-BFGS | seconds | ratio | ASA_CG, f + gradient |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    ratios, solved = [], {"ours": 0, "SciPy": 0, "NLopt": 0}
    for index in range(library.bound_count()):
        name, scipy_run = run_scipy(library, index)
        ours, nlopt = runs[name, "ours"], runs.get((name, "NLopt"))
        for solver, outcome in (("ours", ours), ("SciPy", scipy_run), ("NLopt", nlopt)):
            solved[solver] += outcome is not None
        ratio = ours[0] / scipy_run[0] if ours and scipy_run else math.nan
        if ratio == ratio:
            ratios.append(ratio)
        print(f"| {name} | {runs[name, 'n']} | {cell(ours)} | {cell(scipy_run)} | {cell(nlopt)} | {ratio:.2f} |"
              f" {asa.get(name.split(' ')[0], '')} |", flush=True)
    mean = math.exp(sum(map(math.log, ratios)) / len(ratios))
    print(f"\nSolved of {library.bound_count()}: default {solved['ours']}, L-BFGS-B {solved['SciPy']}, NLopt {solved['NLopt']}. "
          f"Evaluations over those of L-BFGS-B: geometric mean {mean:.3f}, largest {max(ratios):.2f}.")


if __name__ == "__main__":
    main(*sys.argv[1:])
