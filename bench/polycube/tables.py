#!/usr/bin/env python3
"""Makes the dissertation's Tables 4.1 to 4.3 again, printed figures beside ours: docs/polycube_tables.md.

    bench/polycube/tables.py BUILD MODELS [--again]

BUILD    a build folder set up with -Dbench=true, in which bench-polycube is built
MODELS   a folder with max-planck.obj, bimba.obj, cow.off and horse.ply
--again  measure again though BUILD holds the figures of a former run

Needs nothing else. Five minutes; times are of CPU, one thread.
"""
import argparse
import os
import platform
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from programs import measured  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

# As printed: triangles, corners, angle and area before, angle and area after, seconds of domain and of map optimization; and our
# file, where there is a mesh of the shape.
TABLE_4_2 = (
    ("Isis", None, "5K", 8, (1.261, 1.429), (1.134, 1.385), 0.52, 112),
    ("Beethoven", None, "21K", 20, (1.387, 1.563), (1.215, 1.236), 7.74, 504),
    ("Max-Planck", "max-planck.obj", "10K", 8, (1.104, 1.477), (1.060, 1.395), 1.36, 33),
    ("Bimba", "bimba.obj", "30K", 20, (1.292, 1.243), (1.283, 1.209), 10.62, 744),
    ("horse", "horse.ply", "16K", 60, (1.352, 1.302), (1.258, 1.229), 11.72, 1842),
    ("cow", "cow.off", "39K", 60, (1.198, 1.210), (1.191, 1.161), 21.21, 2898),
    ("goat", None, "21K", 60, (1.359, 1.304), (1.241, 1.190), 10.83, 2032),
)
# Of the Beethoven, with 20 corners.
TABLE_4_3 = ((0.1, 1.219, 1.380), (0.5, 1.235, 1.316), (1.0, 1.253, 1.292), (1.5, 1.264, 1.281))

HEAD = """\
# The dissertation's Tables 4.1 to 4.3

Made by `bench/polycube/tables.py`, {where}. Seconds are of the processor, one thread. Means over triangles of the distortion of
angles and of areas, each 1 for an isometry: half of what section 4.6 prints as formulas, whose minimum is 2, which is how
the printed figures are meant. The meshes are of the same shapes, from other sources and of other sizes; Isis, Beethoven and goat are not available.

## Table 4.1: methods

As printed, with a row for this library. *Construction*: whether the polycube is found without a user; *optimal*: whether its shape is optimized;
*singularities*: whether their number can be bounded; *common*: whether several shapes can share one.

| method | construction | optimal | singularities | common |
|---|---|---|---|---|
| Tarini et al. 2004 | manual | no | manual | no |
| Wang et al. 2007 | manual | no | manual | no |
| Wang et al. 2008 | manual | no | manual | no |
| Lin et al. 2008 | automatic | no | no | no |
| He et al. 2009 | automatic | no | yes | no |
| the dissertation | automatic | yes | yes | yes |
| this library | automatic or supplied, with features | yes | at most N | up to ten shapes |

## Table 4.2: distortion and time

*As printed*: the dissertation's method here, `--method dissertation --corners N`, with the seconds of all of it beside the triangles; or why it has no map. On Bimba the command, which scales surfaces first, ends at 1.109 / 1.140.
*Corners* are vertices with three patches or more, *corner points* those of the merged rectangles, which the printed figures count. Ours: *before*, by `--construct auto --corners N`, which includes smoothing; *after*, by `--optimize all --corner-search gradient`. T1
is the optimization of the domain, T2 that of domain and map in turn; the construction's seconds are beside the triangles.

"""


def measured_rows(build, models, again):
    files = [f"{os.path.join(models, row[1])}:{row[3]}" for row in TABLE_4_2 if row[1]]
    command = [os.path.join(build, "bench", "polycube", "bench-polycube"), "tables", *files]
    text = measured(os.path.join(build, "bench", "polycube", "tables.tsv"), command, again)
    return [line.split("\t") for line in text.splitlines()]


def pair(angle, area):
    return f"{float(angle):.3f} / {float(area):.3f}"


def table_4_2(rows):
    ours = {row[1]: row[2:] for row in rows if row[0] == "map"}
    lines = ["| model | | triangles | corners | corner points | before: angle / area | after | T1 | T2 |", "|---|---|---|---|---|---|---|---|---|"]
    for name, file, triangles, corners, before, after, domain, mapping in TABLE_4_2:
        lines.append(f"| {name} | printed | {triangles} | | {corners} | {pair(*before)} | {pair(*after)} | {domain:g} | {mapping} |")
        stem = file.split(".")[0] if file else None
        for row in rows:
            if row[:2] == ["as printed", stem]:
                count, points, had, a0, r0, a, r, seconds = row[2:]
                # Zeros: the initial map folds over.
                first = pair(a0, r0) if float(a0) > 0 else "folds over"
                lines.append(f"| | as printed | {count}, {float(seconds):.1f} s | {had} | {points} | {first} | {pair(a, r)} | | |")
            elif row[:2] == ["not printed", stem]:
                reason = row[3].split("; ")[0].split(", and at")[0].split(": ", 1)[-1]
                lines.append(f"| | as printed | {float(row[2]):.1f} s | | | no map: {reason} | | | |")
        if stem in ours:
            count, _, had, a0, r0, a, r, made, t1, t2, points = ours[stem]
            lines.append(f"| | ours | {int(count)}, {float(made):.1f} s | {had} | {points} | {pair(a0, r0)} | {pair(a, r)} | {float(t1):.2f} | {float(t2):.1f} |")
    return "\n".join(lines) + "\n"


def table_4_3(rows):
    ours = {}
    for row in rows:
        if row[0] == "weight":
            ours.setdefault(row[1], {})[float(row[2])] = row[3:]
    weights = [row[0] for row in TABLE_4_3]
    lines = ["| | " + " | ".join(f"{w:g}" for w in weights) + " |", "|---" * (len(weights) + 1) + "|",
             "| printed, Beethoven | " + " | ".join(pair(*row[1:]) for row in TABLE_4_3) + " |"]
    printed = {}
    for row in rows:
        if row[0] == "printed weight":  # zeros: no map
            printed.setdefault(row[1], {})[float(row[2])] = pair(*row[3:]) if float(row[3]) > 0 else "no map"
    for name, values in ours.items():
        if name in printed:
            lines.append(f"| as printed, {name} | " + " | ".join(printed[name][w] for w in weights) + " |")
        lines.append(f"| ours, {name} | " + " | ".join(pair(*values[w][:2]) for w in weights) + " |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("models")
    parser.add_argument("--again", action="store_true")
    arguments = parser.parse_args()
    rows = measured_rows(arguments.build, arguments.models, arguments.again)
    for row in rows:
        if row[0] == "failed":
            raise SystemExit("tables.py: " + " ".join(row[1:]))
    text = HEAD.format(where=f"{platform.machine()}, {os.cpu_count()} cores") + table_4_2(rows)
    text += "\n## Table 4.3: the weight of areas\n\nAngle / area for each weight (alpha in eq. 4.4), after the same optimization, with the corners of Table 4.2; *as printed* by the dissertation's method here, of which only Bimba has a map.\n\n"
    text += table_4_3(rows)
    path = os.path.join(ROOT, "docs", "polycube_tables.md")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    print("wrote", path)


if __name__ == "__main__":
    main()
