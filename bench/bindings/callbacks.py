#!/usr/bin/env python3
"""What a call of the user's function costs through Python; see callbacks.c, which does the same.

    ORBICUBE_LIBRARIES=build/capi PYTHONPATH=bindings/python bench/bindings/callbacks.py
"""

import time

import numpy as np
from orbicube import projected_gradient, sphere_optimizer

UNKNOWNS, RUNS = 10, 1500
START = [-1.2 if i % 2 == 0 else 1.0 for i in range(UNKNOWNS)]


def rosenbrock(x):
    total, gradient = 0.0, [0.0] * len(x)
    for i in range(len(x) - 1):
        a, b = x[i + 1] - x[i] * x[i], 1 - x[i]
        total = total + (100 * a * a + b * b)
        gradient[i] = gradient[i] - (400 * x[i] * a + 2 * b)
        gradient[i + 1] = gradient[i + 1] + 200 * a
    return total, np.array(gradient)


def solver():
    recorded = []

    def record(x):
        recorded.append(rosenbrock(x))
        return recorded[-1]

    projected_gradient.minimize(record, START)
    best = np.inf
    for _ in range(RUNS):
        answer = iter(recorded).__next__
        run = projected_gradient.Solver(START)  # once a run, not once an evaluation
        begin = time.perf_counter()
        run.run(lambda x: answer())
        best = min(best, (time.perf_counter() - begin) / len(recorded))
    print(f"Python: {1e9 * best:.0f} ns an evaluation, {len(recorded)} evaluations a run")


def callbacks():
    """The relaxation, whose function C calls: with the shortest function, everything included."""
    calls = [0]
    gradient = np.array([1.0, 0.0, 0.0])

    def part(block, place, points, derivatives):
        calls[0] += 1
        return -place[0], -gradient

    points = np.random.default_rng(1).normal(size=(100, 3))
    neighbors = [[] for _ in points]
    best = np.inf
    for _ in range(RUNS // 5):
        calls[0] = 0
        begin = time.perf_counter()
        sphere_optimizer.relax(part, points, neighbors)
        best = min(best, (time.perf_counter() - begin) / calls[0])
    print(f"Python, block by block: {1e9 * best:.0f} ns an evaluation with the function itself")


if __name__ == "__main__":
    solver()
    callbacks()
