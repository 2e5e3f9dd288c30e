#!/usr/bin/env python3
"""Recomputes the figures of the tables in docs/ and README.md by the benches that they come from, and fails on a difference.

    figures.py BUILD MODELS [--only WORD] [--timeout SECONDS]   runs the benches whose page or heading has WORD, compares, and restores pages
    figures.py --list                                           prints each table with what recomputes it
    figures.py --check                                          fails where a table with figures is not listed, or a listed one is not there

BUILD is set up with -Dbench=true, MODELS has the folders dev, tets and hexme. A page that a script writes is written again and compared cell by
cell; a table that was pasted is compared by rows: each of its figures has to be in the lines of the bench that begin with the name of the
row. Figures agree where they differ by at most one in the last digit that the page has. Times, speeds and memory of a machine, and columns of other
programs, are not compared. Exit code 1 where something differs, fails or is not listed.
"""

import argparse
import glob
import os
import re
import shlex
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PYTHON = shlex.quote(sys.executable)
COMMAND = "{build}/cli/orbicube"
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w.]*\w)")
# Heads of columns, and names of rows, with what depends on the machine.
MACHINE = re.compile(r"\b(s|ms|us|seconds|microseconds|time|times less|speed|MB|MB/s|GB|memory|bytes|gain|T1|T2|cells/s|tets/s|a second|building)\b")
SECONDS = re.compile(r"[-+]?\d+(?:\.\d+)? (?:s|ms|MB)\b")


class Written:
    """Pages that a script writes; {build}, {models} and {command} stand in its command."""

    def __init__(self, pages, command):
        self.pages, self.command = pages.split(), command


class Pasted:
    """A table of a page: by its heading and how its head begins; what prints it; columns that are not compared, or pairs of how a row and
    a column begin."""

    def __init__(self, page, heading, head, command, skip=()):
        self.page, self.heading, self.head, self.command, self.skip = page, heading, head, command, skip


class Other:
    """A table without figures that a bench of ours prints, and why."""

    def __init__(self, page, heading, reason, head=""):
        self.page, self.heading, self.head, self.reason = page, heading, head, reason


BENCH = "{build}/bench/"
TETRAHEDRA = "{models}/tets/*.mesh {models}/dev/tet-*.mesh"
WRITTEN = (
    Written("dissertation.md", PYTHON + " scripts/dissertation.py --write"),
    Written("frame_field_tables.md", PYTHON + " bench/frame_field/tables.py {build} " + TETRAHEDRA + " --again fields --again scaling"),
    Written("harmonics_figures.md", "rm -f {build}/bench/harmonics/errors.txt && " + PYTHON + " bench/harmonics/figures.py {build} {models}/dev"),
    Written("linear_tables.md", PYTHON + " bench/linear/multigrid.py {build}"),
    Written("polycube_figures.md", PYTHON + " bench/polycube/figures.py " + COMMAND + " {models}/dev"),
    Written("polycube_tables.md", PYTHON + " bench/polycube/tables.py {build} {models}/dev --again"),
    Written("sphere_map_figures.md", PYTHON + " bench/sphere_map/figures.py " + COMMAND + " {models}/dev"),
    Written("sphere_map_tables.md", PYTHON + " bench/sphere_map/tables.py {build} {models}/dev --again maps --again harmonics --again scaling"),
    Written("study_figures.md", PYTHON + " bench/correspondence/studies.py " + COMMAND + " --write"),
    Written("untangle_tables.md", PYTHON + " bench/untangle/tables.py {build} --again"),
    Written("volume_map_figures.md", PYTHON + " bench/volume_map/figures.py " + COMMAND + " {models}/dev --write && " + PYTHON +
            " bench/volume_map/guided.py " + COMMAND + " {models} --write"),
)
PASTED = (
    Pasted("frame_field.md", "Results", "| mesh | tets", BENCH + "frame_field/bench-frame-field targets {models}/tets", ("best known",)),
    Pasted("frame_field.md", "Results", "| mesh | E | quotient", BENCH + "frame_field/bench-frame-field repairs {models}/tets"),
    Pasted("hexmesh.md", "On polycubes", "| solid | genus", BENCH + "hexmesh/bench-hexahedra {models}/dev 11000"),
    Pasted("hexmesh.md", "Along frames", "| solid | tetrahedra", BENCH + "hexmesh/bench-frames 2000"),
    Pasted("polycube.md", "Results within 60 corners", "| shape", BENCH + "polycube/bench-polycube --corners 60 {models}/dev/*.o* {models}/dev/*.ply"),
    Pasted("polycube.md", "Optimization of proportions", "| map", BENCH + "polycube/bench-polycube domain {models}/dev/bunny.ply "
           "{models}/dev/max-planck.obj {models}/dev/rocker-arm.obj"),
    Pasted("polycube.md", "One polycube for several shapes", "| shape", BENCH + "polycube/bench-polycube common {models}/dev/horse.ply {models}/dev/cow.off"),
    Pasted("polycube.md", "Factors that follow a moved edge", "| map", BENCH + "polycube/bench-polycube factors --corners 60 {models}/dev/cow.off "
           "{models}/dev/max-planck.obj {models}/dev/bimba.obj", ("fresh, Eigen", "fresh, CHOLMOD", "updated")),
    Pasted("projected_gradient.md", "Results", "| problem | default | DISSERTATION", BENCH + "projected_gradient/bench-projected-gradient 20 ours",
           ("L-BFGS-B (SciPy 1.17, m = 10)", "NLopt 2.7", "IPOPT 3.11, limited memory",
            *((row, "DISSERTATION") for row in ("NNLS", "SVM", "transport")))),  # these runs end after 20 s
    Pasted("sphere_map.md", "Results: quality", "| model | vertices", BENCH + "sphere_map/bench-sphere-map quality {models}/dev", ("theirs",)),
    Pasted("sphere_map.md", "Results: quality", "| model | theirs", "for m in angle-area stretch conformal; do " + BENCH +
           "sphere_map/bench-sphere-map quality {models}/dev $m; done", ("theirs: E", "theirs: stretch efficiency", "`conformal`: E_D / 16 pi")),
    Pasted("sphere_optimizer.md", "Results", "| problem | default | BARZ", BENCH + "sphere_optimizer/bench-sphere-optimizer",
           ("Pymanopt 2.2, CG", "Pymanopt 2.2, trust regions", "L-BFGS on the angles")),
    Pasted("untangle.md", "Figures", "| kind | cases | maximum tetrahedra", BENCH + "untangle/bench-untangle-tetrahedra"),
    Pasted("untangle.md", "Figures", "| kind | cases | maximum triangles", BENCH + "untangle/bench-untangle-triangles"),
    Pasted("volume_map.md", "Solids on polycubes", "| solid", BENCH + "volume_map/bench-solids {models}/dev"),
    Pasted("volume_map.md", "Large solids", "| tetrahedra | seconds", BENCH + "volume_map/bench-large-solids"),
)
TIMES = "times and memory of a machine alone"
PEERS = "other programs, which are not there on every machine, are beside it"
RUNS = "single runs of the command; its text has the options"
OTHER = (
    Other("command.md", "make", "no measurement: what the shapes are"),
    Other("error_kinds.md", "Statuses", "no measurement: numbers of the C interface"),
    Other("finite_elements.md", "Finite elements", "examples/study and its test print these figures"),
    Other("gltf.md", "Results", TIMES),
    Other("harmonics.md", "Results", PEERS + " (bench/harmonics/peers.py)"),
    Other("hexmesh.md", "On polycubes", RUNS, "| solid | hexahedra"),
    Other("hexmesh.md", "On polycubes", RUNS, "| solid, `--cells`"),
    Other("hexmesh.md", "Sharp edges kept", "hours: bench-features CELLS auto FILE for each group of its rows"),
    Other("hexmesh.md", "Regions", "needs gmsh (bench/hexmesh/assemblies.py)"),
    Other("hexmesh.md", "Along frames", RUNS, "| `make bracket"),
    Other("install.md", "Packages", "printed by the scripts of packaging/"),
    Other("linear.md", "Engines compared", TIMES),
    Other("mesh.md", "Guarantees and limits", TIMES),
    Other("mesh_formats.md", "Speed", TIMES),
    Other("polycube.md", "Points, curves and sharp edges", RUNS),
    Other("polycube.md", "Optimization of corners", "needs the files of bench-polycube -o and NLopt (bench-polycube corners)"),
    Other("polycube.md", "The dissertation's method", "rows of Table 4.2 in scripts/dissertation.py run two of them; the others are single runs"),
    Other("projected_gradient.md", "Results", PEERS + " (bound_problems.py)", "| problem | n"),
    Other("projected_gradient.md", "Results", TIMES, "| n | default"),
    Other("projected_gradient.md", "Results", TIMES, "| projection"),
    Other("python.md", "Results", TIMES),
    Other("quaternion.md", "Results", TIMES),
    Other("repair.md", "", "needs judges beside the tree (label_images.py, peers.py)"),
    Other("repair_figures.md", "", "needs judges beside the tree (label_images.py --write, damaged_scans.py --write)"),
    Other("sphere_map.md", "Results: time", TIMES),
    Other("sphere_map_uses.md", "The inverse", TIMES),
    Other("sphere_map_uses.md", "Remeshing", "no measurement: numbers of vertices by formula"),
    Other("sphere_optimizer.md", "Results", PEERS, "| weights"),
    Other("sphere_optimizer.md", "Results", "max_cut.py and single runs of the bench", "| problem | default | queue"),
    Other("tetrahedra.md", "Results", TIMES),
    Other("trust.md", "Any input", TIMES),
    Other("trust.md", "Tests, and how", "no measurement: which test looks at what"),
    Other("trust_region.md", "Results", PEERS + " (bench-trust-region with each set, compare.py)"),
    Other("volume_map.md", "Large solids", "single runs of the rod, and of two processes with PETSc", "| tetrahedra | inverted"),
    Other("volume_map.md", "Large solids", "needs PETSc (bench-weak-scaling)", "| processes"),
)


def cells_of(line):
    return [word.strip() for word in re.split(r"(?<!\\)\|", line.strip().strip("|"))]


class Table:
    def __init__(self, page, heading, lines):
        self.page, self.heading = page, heading
        self.head, self.rows = cells_of(lines[0]), [cells_of(line) for line in lines[2:]]
        self.text = lines[0]

    def has_figures(self):
        return sum(bool(re.match(r"[-+<]?\d", cell)) for row in self.rows for cell in row[1:]) > 2

    def name(self):
        return f"{self.page}: {self.heading}: {self.text[:40]}"


def tables_of(page, text):
    tables, heading, code, lines = [], "", False, text.splitlines()
    for i, line in enumerate(lines):
        code ^= line.startswith("```")
        if code:
            continue
        if line.startswith("#"):
            heading = line.lstrip("# ")
        if line.startswith("|") and i + 1 < len(lines) and re.fullmatch(r"\|[-:| ]+", lines[i + 1]) and not lines[i - 1].startswith("|"):
            end = i
            while end < len(lines) and lines[end].startswith("|"):
                end += 1
            tables.append(Table(page, heading, lines[i:end]))
    return tables


def all_tables():
    found = []
    for path in sorted(glob.glob(os.path.join(ROOT, "docs", "*.md"))) + [os.path.join(ROOT, "README.md")]:
        with open(path, encoding="utf-8") as file:
            found += [table for table in tables_of(os.path.basename(path), file.read()) if table.has_figures()]
    return found


def matches(entry, table):
    if isinstance(entry, Written):
        return table.page in entry.pages
    return entry.page == table.page and entry.heading in table.heading and table.text.startswith(entry.head)


def entry_of(table):
    return next((entry for entry in (*WRITTEN, *PASTED, *OTHER) if matches(entry, table)), None)


def check():
    """What is wrong with the lists, or an empty text."""
    tables = all_tables()
    missing = [table.name() for table in tables if entry_of(table) is None]
    stale = [f"{entry.page}: {entry.heading} {entry.head}" for entry in (*PASTED, *OTHER) if not any(matches(entry, table) for table in tables)]
    return "\n".join(["not listed: " + name for name in missing] + ["listed, but not there: " + name for name in stale])


def numbers_of(cell):
    """Of a cell the numbers with the worth of one in their last digits, without times."""
    found = []
    for text in NUMBER.findall(SECONDS.sub("", cell.replace("\u2212", "-"))):
        mantissa, _, exponent = text.partition("e")
        digits = len(mantissa.partition(".")[2])
        found.append((float(text), 10.0 ** ((int(exponent) if exponent else 0) - digits)))
    return found


def is_near(expected, unit, found):
    return abs(expected - found) <= 1.001 * unit


def compared_columns(table, skip=()):
    return [k for k, head in enumerate(table.head) if k > 0 and head not in skip and not MACHINE.search(head)]


def differences_of_tables(before, after):
    """Of a page that was written again: where a cell has other numbers, or other words."""
    if (before.head, len(before.rows)) != (after.head, len(after.rows)):
        return [f"another head, or {len(after.rows)} rows, not {len(before.rows)}"]
    found = []
    for old, new in zip(before.rows, after.rows):
        if old[0] != new[0] or len(old) != len(new):
            found.append(f"row {old[0]!r} is {new[0]!r}")
            continue
        for k in compared_columns(before):
            if MACHINE.search(old[0]):
                break
            ours, theirs = numbers_of(old[k]), numbers_of(new[k])
            same = len(ours) == len(theirs) and all(is_near(x, unit, y) for (x, unit), (y, _) in zip(ours, theirs))
            if not same:
                found.append(f"{old[0]}, {before.head[k]}: {old[k]}, now {new[k]}")
    return found


def differences_of_rows(table, output, skip=()):
    """Of a pasted table: the figures of a row that none of the lines of its name has."""
    columns, name, found = compared_columns(table, skip), "", []
    lines = [line for line in output.splitlines() if line.strip()]
    for row in table.rows:
        name = row[0].strip("`") or name
        words = re.findall(r"[\w.-]+", name.lower())
        own = [line for line in lines if words and all(word in line.lower() for word in words)]
        there = [value for line in own for value, _ in numbers_of(line)]
        if not own:
            found.append(f"no line has {name!r}")
            continue
        for k in columns:
            if k >= len(row) or any(name.startswith(pair[0]) and table.head[k].startswith(pair[1]) for pair in skip if isinstance(pair, tuple)):
                continue
            for value, unit in numbers_of(row[k]):
                if not any(is_near(value, unit, other) for other in there):
                    found.append(f"{name}, {table.head[k]}: {value:g} is not there")
    return found


def read(page):
    with open(os.path.join(ROOT, "docs", page), encoding="utf-8") as file:
        return file.read()


class Runner:
    def __init__(self, build, models, timeout):
        self.words = {"build": shlex.quote(os.path.abspath(build)), "models": shlex.quote(os.path.abspath(models))}
        self.timeout, self.known = timeout, {}

    def run(self, command):
        """Its output, or why there is none."""
        if command not in self.known:
            program = re.search(r"\{build\}/(\S+)", command)
            if program and "bench-" in program[1] and not os.path.exists(os.path.join(self.words["build"].strip("'"), program[1])):
                return None, "skipped: not built: " + program[1]
            try:
                done = subprocess.run(["sh", "-c", command.format(**self.words)], cwd=ROOT, capture_output=True, text=True, timeout=self.timeout)
            except subprocess.TimeoutExpired:
                return None, f"failed: not done after {self.timeout:g} s"
            if done.returncode != 0:
                return None, "failed: " + (done.stderr.strip().splitlines() or ["exit code " + str(done.returncode)])[-1]
            self.known[command] = done.stdout
        return self.known[command], ""

    def written(self, entry):
        before = {page: read(page) for page in entry.pages}
        try:
            _, reason = self.run(entry.command)
            after = {page: read(page) for page in entry.pages}
        finally:
            for page, text in before.items():
                with open(os.path.join(ROOT, "docs", page), "w", encoding="utf-8") as file:
                    file.write(text)
        if reason:
            return [reason]
        found = []
        for page in entry.pages:
            old, new = tables_of(page, before[page]), tables_of(page, after[page])
            if len(old) != len(new):
                found.append(f"{page} has {len(new)} tables, not {len(old)}")
            for ours, theirs in zip(old, new):
                found += [f"{ours.heading}: {text}" for text in differences_of_tables(ours, theirs)]
        return found

    def pasted(self, entry):
        output, reason = self.run(entry.command)
        if reason:
            return [reason]
        table = next(table for table in tables_of(entry.page, read(entry.page)) if matches(entry, table))
        return differences_of_rows(table, output, entry.skip)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?")
    parser.add_argument("models", nargs="?")
    parser.add_argument("--only", default="")
    parser.add_argument("--timeout", type=float, help="seconds that a bench may take [default: no limit]")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if options.check:
        sys.exit(check() or 0)
    if options.list:
        for table in all_tables():
            entry = entry_of(table)
            print(f"{table.name():90} {getattr(entry, 'command', '') or 'not recomputed: ' + getattr(entry, 'reason', 'not listed')}")
        return
    if not options.models:
        parser.error("BUILD and MODELS are required")
    runner, wrong = Runner(options.build, options.models, options.timeout), 0
    for entry in (*WRITTEN, *PASTED):
        name = " ".join(entry.pages) if isinstance(entry, Written) else f"{entry.page}: {entry.heading}: {entry.head}"
        if options.only not in name:
            continue
        found = runner.written(entry) if isinstance(entry, Written) else runner.pasted(entry)
        skipped = found and found[0].startswith("skipped")
        wrong += bool(found) and not skipped
        print(f"{name}: " + ("ok" if not found else found[0] if skipped else "; ".join(found)), flush=True)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
