#!/usr/bin/env python3
"""The example problems of examples/c in Python: a fit without derivatives, a mix of feeds, points that repel each other."""

import numpy as np
from orbicube import projected_gradient, sphere_optimizer, trust_region


def decay():
    """Fits a / (1 + b t) + c to eight measurements, within bounds."""
    t, truth = 0.5 * np.arange(8), np.array([2.5, 0.7, 0.4])

    def model(x):
        return x[0] / (1 + x[1] * t) + x[2]

    result = trust_region.least_squares(lambda x: model(x) - model(truth), [1, 0.1, 0], 8, lower=[0, 0, -1],
                                        upper=[10, 2, 1])
    print(f"decay: {result.stop} after {result.evaluations} evaluations, {result.x}")
    assert np.abs(result.x - truth).max() < 1e-7


def feeds():
    """The cheapest mix of five feeds that reaches a given share of protein."""
    price, usual = np.array([0.9, 0.3, 0.5, 1.4, 0.2]), np.array([0.2, 0.3, 0.2, 0.1, 0.2])
    weight, protein = np.array([2, 1, 3, 1, 4]), np.array([0.12, 0.09, 0.35, 0.44, 0.05])

    def cost(x):
        away = x - usual
        return price @ x + 0.5 * weight @ away**2, price + weight * away

    rows = np.array([np.ones(5), protein])
    solver = projected_gradient.Solver(np.zeros(5), lower=0, upper=0.6, A=rows, b=[1, 0.2])
    result = solver.run(cost)
    slope = cost(result.x)[1] - solver.multipliers @ rows
    print(f"feeds: {result.stop} after {result.evaluations} evaluations, {result.x}")
    assert np.abs(slope[(result.x > 0) & (result.x < 0.6)]).max() < 1e-7 and np.all(slope[result.x == 0] >= 0)


def charges():
    """Twelve points on a sphere that repel each other settle at the corners of an icosahedron."""

    def energy(x):
        away = x[:, None] - x
        square = (away**2).sum(axis=2) + np.eye(len(x))
        term = (1 - np.eye(len(x))) / square
        return 0.5 * term.sum(), -2 * (term[..., None] * away / square[..., None]).sum(axis=1)

    start = np.random.default_rng(5).normal(size=(12, 3))
    result = sphere_optimizer.minimize(energy, start)
    print(f"charges: {result.stop} after {result.evaluations} evaluations, energy {result.value:.9f}")
    assert abs(result.value - 39) < 1e-9


if __name__ == "__main__":
    decay()
    feeds()
    charges()
