#!/usr/bin/env python3
"""Sums of spherical harmonics at scattered points, and the transpose, beside ducc0 (PyPI: ducc0), in one run on one core.

    ORBICUBE_LIBRARIES=BUILD/capi PYTHONPATH=bindings/python bench/harmonics/peers.py [POINTS]

Prints a table in Markdown. Times are the minimum CPU time of five calls, each from coefficients and directions to values with
nothing kept between them. Errors are to sums in long double at 40 points, relative to the largest value. ducc0 runs with
epsilon 1e-12 and 1e-13, and without it the table has one row a degree.
"""
import sys
import time

import numpy as np

from orbicube import harmonics

try:
    import ducc0
except ImportError:
    ducc0 = None

DEGREES = (100, 250, 500, 1000)
EXACT_POINTS = 40


def cpu_milliseconds(work):
    least = float("inf")
    for _ in range(5):
        start = time.process_time()
        work()
        least = min(least, 1e3 * (time.process_time() - start))
    return least


def exact_sums(coefficients, directions):
    """The sums in long double, by the recurrence in the degree."""
    degree = harmonics.degree_of(coefficients)
    d = directions.astype(np.longdouble)
    d /= np.sqrt(np.sum(d * d, axis=1))[:, None]
    turn, z = d[:, 0] + 1j * d[:, 1], d[:, 2]
    c = coefficients[:, 0].astype(np.longdouble)
    total, power, product = np.zeros(len(d), np.longdouble), np.ones(len(d), np.clongdouble), np.longdouble(1)
    pi = 4 * np.arctan(np.longdouble(1))
    for m in range(degree + 1):
        if m > 0:
            product *= np.longdouble(2 * m - 1) / (2 * m)
            power = power * turn
        value = np.full(len(d), np.sqrt((2 if m > 0 else 1) * np.longdouble(2 * m + 1) / (4 * pi) * product))
        before, last = np.zeros_like(value), np.longdouble(1)
        cosine, sine = c[m * m + 2 * m] * value, c[m * m] * value
        for l in range(m + 1, degree + 1):
            factor = np.sqrt(np.longdouble(4 * l * l - 1) / ((l - m) * (l + m)))
            value, before, last = factor * (z * value - before / last), value, factor
            cosine += c[l * l + l + m] * value
            sine += c[l * l + l - m] * value
        total += cosine * power.real + (sine * power.imag if m > 0 else 0)
    return total.astype(float)


def to_ducc0(coefficients):
    """Complex, with the Condon-Shortley phase, order by order."""
    degree = harmonics.degree_of(coefficients)
    c, parts = coefficients[:, 0], []
    for m in range(degree + 1):
        l = np.arange(m, degree + 1)
        cosine, sine = c[l * l + l + m], c[l * l + l - m]
        parts.append(cosine + 0j if m == 0 else (-1) ** m * (cosine - 1j * sine) / np.sqrt(2))
    return np.concatenate(parts)[None]


def rows_of(degree, count):
    """Lines of the table of a degree: library, synthesis, transpose, error."""
    random = np.random.default_rng(degree)
    directions = random.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    coefficients, values = random.uniform(-1, 1, ((degree + 1) ** 2, 1)), random.uniform(-1, 1, (count, 1))
    exact = exact_sums(coefficients, directions[:EXACT_POINTS])

    def error(found):
        return np.max(np.abs(found - exact)) / np.max(np.abs(exact))

    yield ("orbicube", cpu_milliseconds(lambda: harmonics.synthesize(coefficients, directions, threads=1)),
           cpu_milliseconds(lambda: harmonics.analyze(directions, values, degree, threads=1)),
           error(harmonics.synthesize(coefficients, directions)[:EXACT_POINTS, 0]))
    if ducc0 is None:
        return
    angles = np.stack([np.arctan2(np.hypot(directions[:, 0], directions[:, 1]), directions[:, 2]),
                       np.arctan2(directions[:, 1], directions[:, 0]) % (2 * np.pi)], axis=1)
    alm = to_ducc0(coefficients)
    for epsilon in (1e-12, 1e-13):
        common = {"spin": 0, "lmax": degree, "loc": angles, "epsilon": epsilon, "nthreads": 1}
        yield (f"ducc0 {ducc0.__version__}, {epsilon:g}",
               cpu_milliseconds(lambda: ducc0.sht.synthesis_general(alm=alm, **common)),
               cpu_milliseconds(lambda: ducc0.sht.adjoint_synthesis_general(map=values.T.copy(), **common)),
               error(ducc0.sht.synthesis_general(alm=alm, **common)[0, :EXACT_POINTS]))


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 50000
    print(f"{count} points, one core, CPU time\n\n| degree | library | synthesis, ms | transpose, ms | largest error |\n|---|---|---|---|---|")
    for degree in DEGREES:
        for name, forward, backward, error in rows_of(degree, count):
            print(f"| {degree} | {name} | {forward:.1f} | {backward:.1f} | {error:.1e} |", flush=True)


main()
