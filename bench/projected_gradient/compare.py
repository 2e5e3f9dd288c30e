"""SciPy on the problems of the table: L-BFGS-B (m=10) where there are only bounds, else SLSQP (up to 200 unknowns) and
trust-constr (up to 2000). Usage: compare.py PATH/TO/libprojected-gradient-problems.so

Prints one line a problem: evaluations of value and gradient and the projected gradient reached. Needs numpy and scipy."""
import os
import sys

import numpy
import scipy.optimize

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from programs import load_problems, pointer  # noqa: E402


def run(library, index):
    problem = library.bench_make(index)
    n, m = library.bench_size(problem), library.bench_rows(problem)
    name = library.bench_name(problem).decode()
    start, lower, upper = numpy.empty(n), numpy.empty(n), numpy.empty(n)
    library.bench_data(problem, pointer(start), pointer(lower), pointer(upper))
    count = 0

    def evaluate(x):
        nonlocal count
        count += 1
        x = numpy.ascontiguousarray(x)
        gradient = numpy.empty(n)
        return library.bench_evaluate(problem, pointer(x), pointer(gradient)), gradient

    bounds = scipy.optimize.Bounds(lower, upper)
    limit = 30000
    if m == 0:
        solver = "L-BFGS-B"
        answer = scipy.optimize.minimize(
            evaluate, numpy.clip(start, lower, upper), jac=True, method="L-BFGS-B", bounds=bounds,
            options=dict(maxcor=10, ftol=0, gtol=1e-8, maxfun=limit, maxiter=limit))
    elif n <= 200:
        solver = "SLSQP"
        matrix, rhs = numpy.empty((m, n)), numpy.empty(m)
        library.bench_linear(problem, pointer(matrix), pointer(rhs))
        answer = scipy.optimize.minimize(
            evaluate, start, jac=True, method="SLSQP", bounds=bounds, options=dict(ftol=1e-16, maxiter=1000),
            constraints=dict(type="eq", fun=lambda x: matrix @ x - rhs, jac=lambda x: matrix))
    else:
        print(f"{name:28s} {'-':12s} SciPy's solvers with linear rows are dense: not run")
        library.bench_free(problem)
        return
    f, gradient = evaluate(answer.x)
    measure = numpy.abs(numpy.clip(answer.x - gradient, lower, upper) - answer.x).max() if m == 0 else float("nan")
    print(f"{name:28s} {solver:12s} evaluations {count - 1:6d}  projected gradient {measure:9.2e}  f {f:.15g}", flush=True)
    library.bench_free(problem)


if __name__ == "__main__":
    module = load_problems(sys.argv[1], sizes=("size", "rows"), arrays={"data": 3, "linear": 2})
    for number in range(module.bench_count()):
        run(module, number)
