"""Pymanopt's conjugate gradients and steepest descent on the problems of the table.
Usage: compare.py PATH/TO/libsphere-optimizer-problems.so

Prints one line a problem: evaluations (points at which the value was requested, with or without gradient) and the longest
tangent gradient of a block reached. Needs numpy and pymanopt."""
import os
import sys

import numpy
import pymanopt
from pymanopt.manifolds import Oblique, Sphere
from pymanopt.optimizers import ConjugateGradient, SteepestDescent

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from programs import load_problems, pointer  # noqa: E402


class Counted:
    """f with gradient, blocks as rows; two calls at the same point evaluate it once."""

    def __init__(self, library, problem):
        self.library, self.problem, self.count, self.last = library, problem, 0, None

    def __call__(self, rows):
        rows = numpy.ascontiguousarray(rows)
        if self.last is None or not numpy.array_equal(self.last[0], rows):
            self.count += 1
            gradient = numpy.empty_like(rows)
            value = self.library.bench_evaluate(self.problem, pointer(rows), pointer(gradient))
            self.last = rows.copy(), value, gradient
        return self.last[1:]


def run(library, index, tolerance=1e-6, limit=20000, seconds=60):
    problem = library.bench_make(index)
    count, dimension = library.bench_count(problem), library.bench_dimension(problem)
    start = numpy.empty((count, dimension))
    library.bench_start(problem, pointer(start))
    start /= numpy.linalg.norm(start, axis=1, keepdims=True)
    one = count == 1
    manifold = Sphere(dimension) if one else Oblique(dimension, count)  # Oblique has its blocks in columns

    def rows_of(point):
        return point.reshape(1, -1) if one else point.T

    for solver in (ConjugateGradient, SteepestDescent):
        f = Counted(library, problem)

        @pymanopt.function.numpy(manifold)
        def cost(point):
            return f(rows_of(point))[0]

        @pymanopt.function.numpy(manifold)
        def gradient(point):
            answer = f(rows_of(point))[1]
            return answer.ravel() if one else answer.T

        optimizer = solver(max_iterations=limit, max_time=seconds, min_gradient_norm=tolerance, min_step_size=1e-14,
                           max_cost_evaluations=limit, verbosity=0)
        result = optimizer.run(pymanopt.Problem(manifold, cost, euclidean_gradient=gradient),
                               initial_point=start.ravel() if one else numpy.ascontiguousarray(start.T))
        used = f.count
        rows = rows_of(result.point)
        value, slope = f(rows)
        tangent = slope - (slope * rows).sum(axis=1, keepdims=True) * rows
        longest = numpy.linalg.norm(tangent, axis=1).max()
        print(f"{library.bench_name(problem).decode():34s} {solver.__name__:18s} evaluations {used:6d}  "
              f"gradient {longest:8.1e}  f {value:.12g}", flush=True)
    library.bench_free(problem)


if __name__ == "__main__":
    module = load_problems(sys.argv[1], sizes=("count", "dimension"), arrays={"start": 1})
    for number in range(module.bench_problems()):
        run(module, number)
