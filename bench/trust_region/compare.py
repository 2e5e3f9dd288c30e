"""The peers of PyPI on the 53 cases: DFO-LS and POUNDERS (ibcdfo) with the residuals; Powell's UOBYQA, NEWUOA and BOBYQA
(pdfo), Py-BOBYQA and SciPy's COBYQA and Nelder-Mead without. Needs numpy (below 2 for pdfo) and any of those (POUNDERS also minq5 of
POptUS/MINQ on the path); says which are missing.

Usage: compare.py PATH/TO/libtrust-region-problems.so BENCH [plain|bounded|radius|magnitudes|largest|TRANSFORMS] [--reference]
                  [--budget KAPPA] [--only NAME,...]

BENCH is the program bench-trust-region: what f the solvers must reach is its frozen table (`BENCH --lowest`). `radius` has start radius 1,
`magnitudes` and `largest` sum and maximum of |residuals|. TRANSFORMS, such as 1-10, gives means over rotated and permuted variables.
--reference prints the lowest f of each case instead, to freeze. --budget: evaluations / (n + 1), 500 without. --only: solvers whose
names contain one of the words."""
import contextlib
import ctypes
import io
import logging
import math
import os
import subprocess
import sys
import warnings

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from programs import load_problems, pointer  # noqa: E402

KAPPAS = (10, 25, 50, 100, 200, 500)
TAUS = (1e-1, 1e-3, 1e-5, 1e-7)
MODES = {"plain": 0, "bounded": -1, "radius": -2, "magnitudes": -3, "largest": -4}


class Budget(Exception):
    pass


class Case:
    """One case with a record of the values of f, which stops the solver at the budget."""
    kappa = 500

    def __init__(self, library, index, transform):
        self.library = library
        self.handle = library.bench_make(index, transform)
        self.n = library.bench_size(self.handle)
        self.m = library.bench_residuals(self.handle)
        self.radius = library.bench_radius(self.handle)
        self.start, self.lower, self.upper = (numpy.empty(self.n) for _ in range(3))
        library.bench_data(self.handle, pointer(self.start), pointer(self.lower), pointer(self.upper))
        self.norm = {-3: lambda r: numpy.abs(r).sum(), -4: lambda r: numpy.abs(r).max()}.get(transform, lambda r: r @ r)
        self.budget = Case.kappa * (self.n + 1)
        self.values = []
        self.breaches = 0

    def bounded(self):
        return bool(numpy.isfinite(self.lower).any())

    def residuals(self, x):
        if len(self.values) >= self.budget:
            raise Budget
        x = numpy.ascontiguousarray(x, dtype=float).ravel()
        found = numpy.empty(self.m)
        self.library.bench_evaluate(self.handle, pointer(x), pointer(found))
        self.breaches += bool((x < self.lower).any() or (x > self.upper).any())
        with numpy.errstate(all="ignore"):
            value = float(self.norm(found))
        self.values.append(value if math.isfinite(value) and not self.breaches else math.inf)
        return found

    def value(self, x):
        residuals = self.residuals(x)
        with numpy.errstate(all="ignore"):
            return float(min(self.norm(residuals), 1e300))

    def close(self):
        self.library.bench_free(self.handle)


def run_dfols(case):
    import dfols
    logging.disable(logging.CRITICAL)
    bounds = (case.lower, case.upper) if case.bounded() else None
    dfols.solve(case.residuals, case.start, bounds=bounds, rhobeg=case.radius, rhoend=1e-8, maxfun=case.budget,
                do_logging=False, print_progress=False)


def run_pounders(case):
    import ibcdfo
    ibcdfo.run_pounders(lambda x: case.residuals(x), case.start, case.n, case.budget, 1e-13, case.radius, case.m,
                        case.lower, case.upper)


def run_powell(name):
    def run(case):
        import pdfo
        options = {"radius_init": case.radius, "radius_final": 1e-8, "maxfev": case.budget, "quiet": True}
        if name != "uobyqa":
            options["npt"] = 2 * case.n + 1
        bounds = {"bounds": list(zip(case.lower, case.upper))} if name == "bobyqa" else {}
        getattr(pdfo, name)(case.value, case.start, options=options, **bounds)
    return run


def run_nelder_mead(case):
    import scipy.optimize
    bounds = list(zip(case.lower, case.upper)) if case.bounded() else None
    scipy.optimize.minimize(case.value, case.start, method="Nelder-Mead", bounds=bounds,
                            options=dict(maxfev=case.budget, maxiter=10 ** 9, xatol=1e-10, fatol=1e-15))


def run_pybobyqa(case):
    import pybobyqa
    logging.disable(logging.CRITICAL)
    bounds = (case.lower, case.upper) if case.bounded() else None
    pybobyqa.solve(case.value, case.start, bounds=bounds, rhobeg=case.radius, rhoend=1e-8, maxfun=case.budget, do_logging=False,
                   print_progress=False)


def run_cobyqa(case):
    import scipy.optimize
    bounds = list(zip(case.lower, case.upper)) if case.bounded() else None
    scipy.optimize.minimize(case.value, case.start, method="COBYQA", bounds=bounds,
                            options=dict(maxfev=case.budget, initial_tr_radius=case.radius, final_tr_radius=1e-8))


SOLVERS = [("DFO-LS", run_dfols, True), ("POUNDERS", run_pounders, True), ("UOBYQA (PDFO)", run_powell("uobyqa"), False),
           ("NEWUOA (PDFO)", run_powell("newuoa"), False), ("BOBYQA (PDFO)", run_powell("bobyqa"), True),
           ("Py-BOBYQA", run_pybobyqa, True), ("COBYQA (SciPy)", run_cobyqa, True), ("Nelder-Mead (SciPy)", run_nelder_mead, True)]


def record(library, run, index, transform):
    case = Case(library, index, transform)
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            run(case)
        except ImportError:
            raise
        except SystemExit as error:  # POUNDERS ends the process where MINQ is missing
            raise ImportError(error) from error
        except BaseException as error:  # a peer's crash counts as its end; Budget may come back wrapped
            if isinstance(error, KeyboardInterrupt):
                raise
    values, n, breaches = case.values, case.n, case.breaches
    case.close()
    return values, n, breaches


def main(arguments):
    library = load_problems(arguments[0], make=(ctypes.c_int,), sizes=("size", "residuals"), numbers=("radius",), arrays={"data": 3})
    mode = arguments[2] if len(arguments) > 2 else "plain"
    Case.kappa = int(arguments[arguments.index("--budget") + 1]) if "--budget" in arguments else 500
    only = arguments[arguments.index("--only") + 1].split(",") if "--only" in arguments else [""]
    if mode in MODES:
        transforms = [MODES[mode]]
    else:
        first, last = mode.split("-")
        transforms = list(range(int(first), int(last) + 1))
    reference = "--reference" in arguments
    count = library.bench_count()
    lowest = [math.inf] * count
    if not reference:
        flag = f"--lowest-{mode}" if mode in ("bounded", "magnitudes", "largest") else "--lowest"
        text = subprocess.run([arguments[1], flag], capture_output=True, text=True, check=True).stdout
        lowest = [float(line) for line in text.split()]
    for name, run, bounds in SOLVERS:
        if mode == "bounded" and not bounds or mode in ("magnitudes", "largest") and run in (run_dfols, run_pounders):
            continue
        if not any(word in name for word in only):
            continue
        solved = {(tau, kappa): 0 for tau in TAUS for kappa in KAPPAS}
        breached = 0
        try:
            for transform in transforms:
                for index in range(count):
                    values, n, breaches = record(library, run, index, transform)
                    breached += breaches
                    if reference:
                        lowest[index] = min([lowest[index]] + values)
                        continue
                    for tau in TAUS:
                        goal = lowest[index] + tau * (values[0] - lowest[index])
                        at = next((k + 1 for k, value in enumerate(values) if value <= goal), math.inf)
                        for kappa in KAPPAS:
                            solved[tau, kappa] += at <= kappa * (n + 1)
        except ImportError as error:
            print(f"{name}: not found ({error})")
            continue
        if reference:
            print(name, file=sys.stderr, flush=True)
            continue
        for tau in TAUS:
            cells = " | ".join(f"{solved[tau, kappa] / len(transforms):g}" for kappa in KAPPAS)
            print(f"| {name} | {tau:g} | {cells} | {breached} |", flush=True)
    if reference:
        print("\n".join(f"{value!r}" for value in lowest))


if __name__ == "__main__":
    main(sys.argv[1:])
