#!/usr/bin/env python3
"""Runs the benchmarks of the engines beside their peers, in one run on one machine, and prints their tables with the peers' versions.

    bench/engines.py BUILD [--only ENGINE,...] [--list]

BUILD   a build folder set up with -Dbench=true
--only  engines of trust_region, projected_gradient, sphere_optimizer, harmonics, linear, untangle
--list  prints the commands and runs none

Programs that BUILD lacks and peers that Python lacks are named at the end, and their tables left out; so are commands that fail, and the
exit code is then 1. trust_region takes about a minute without peers of Python, everything about half an hour.
"""
import argparse
import importlib.metadata
import importlib.util
import os
import platform
import subprocess
import sys

from programs import processor

HERE = os.path.dirname(os.path.abspath(__file__))
PEERS = ("scipy", "Py-BOBYQA", "DFO-LS", "ibcdfo", "pdfo", "pymanopt", "ducc0", "pyamg")
LIBRARIES = ("nlopt", "ipopt", "petsc")  # of which pkg-config knows the version
TRUST_REGION = ("plain", "radius", "transformed", "bounded", "signed", "nonsmooth", "noise", "suite", "suite-noise", "large", "domain", "cost")


class Table:
    """What prints tables: a program of the build, or a script of this folder, with arguments in which {build} stands for the build folder, and the
    modules of Python that it needs."""

    def __init__(self, engine, title, command, needs=()):
        self.engine, self.title, self.command, self.needs = engine, title, command.split(), needs

    def words(self, build):
        words = [word.format(build=build) for word in self.command]
        return [sys.executable, os.path.join(HERE, words[0]), *words[1:]] if words[0].endswith(".py") else [os.path.join(build, "bench", words[0]), *words[1:]]

    def missing(self, build):
        """Returns files and modules that are not there."""
        files = [word for word in self.words(build) if word.startswith((build, HERE)) and word != build and not os.path.exists(word)]
        return files + [name for name in self.needs if importlib.util.find_spec(name) is None]


def tables():
    modules = "{build}/bench/"
    for name in TRUST_REGION:
        yield Table("trust_region", f"{name}, NLopt beside", f"trust_region/bench-trust-region {name}")
    for name in ("plain", "radius", "bounded"):
        yield Table("trust_region", f"{name}, peers of Python", f"trust_region/compare.py {modules}trust_region/libtrust-region-problems.so "
                    f"{modules}trust_region/bench-trust-region {name} --budget 100", ["numpy", "scipy"])
    pairs = modules + "projected_gradient/"
    yield Table("projected_gradient", "bounds and equations", "projected_gradient/bench-projected-gradient 20")
    yield Table("projected_gradient", "the same by SciPy", f"projected_gradient/compare.py {pairs}libprojected-gradient-problems.so", ["scipy"])
    yield Table("projected_gradient", "bounds only", f"projected_gradient/bound_problems.py {pairs}bench-bound-problems {pairs}libbound-problems.so",
                ["scipy"])
    yield Table("projected_gradient", "time an evaluation", "projected_gradient/bench-gradient-overhead")
    yield Table("sphere_optimizer", "eight problems", "sphere_optimizer/bench-sphere-optimizer")
    yield Table("sphere_optimizer", "the same by Pymanopt", f"sphere_optimizer/compare.py {modules}sphere_optimizer/libsphere-optimizer-problems.so",
                ["pymanopt"])
    yield Table("sphere_optimizer", "max-cut", "sphere_optimizer/max_cut.py", ["scipy", "pymanopt"])
    yield Table("sphere_optimizer", "Thomson energies", "sphere_optimizer/bench-thomson-energies")
    yield Table("harmonics", "scattered points", "harmonics/peers.py", ["numpy"])
    yield Table("linear", "multigrid on six systems", "linear/bench-linear-multigrid")
    yield Table("untangle", "a thousand cases", "untangle/bench-untangle-cases")


def print_versions():
    print(f"Processor: {processor()}, {os.cpu_count()} of them; {platform.system()} {platform.machine()}; Python {platform.python_version()}.\n")
    print("| peer | version |\n|---|---|")
    for name in PEERS:
        try:
            print(f"| {name} | {importlib.metadata.version(name)} |")
        except importlib.metadata.PackageNotFoundError:
            print(f"| {name} | not found |")
    for name in LIBRARIES:
        try:
            said = subprocess.run(["pkg-config", "--modversion", name], capture_output=True, text=True, check=False).stdout.strip()
        except FileNotFoundError:
            said = ""
        print(f"| {name} (C) | {said or 'not found'} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=os.path.abspath)
    parser.add_argument("--only", default="")
    parser.add_argument("--list", action="store_true")
    given = parser.parse_args()
    wanted = [table for table in tables() if not given.only or table.engine in given.only.split(",")]
    if not wanted:
        parser.error(f"--only: no engine of {', '.join(sorted({table.engine for table in tables()}))} in {given.only}")
    if given.list:
        for table in wanted:
            print(f"{table.engine}, {table.title}: {' '.join(table.words(given.build))}")
        return 0
    package = os.path.join(os.path.dirname(HERE), "bindings", "python")
    environment = {**os.environ, "ORBICUBE_LIBRARIES": os.path.join(given.build, "capi"), "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1",
                   "PYTHONPATH": os.pathsep.join(filter(None, [package, os.environ.get("PYTHONPATH")]))}
    print_versions()
    failed = []
    for table in wanted:
        name, missing = f"{table.engine}, {table.title}", table.missing(given.build)
        if missing:
            failed.append(f"{name}: without {', '.join(missing)}")
            continue
        print(f"\n## {name}\n", flush=True)
        if subprocess.run(table.words(given.build), env=environment, check=False).returncode != 0:
            failed.append(f"{name}: failed")
    for line in failed:
        print(line, file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
