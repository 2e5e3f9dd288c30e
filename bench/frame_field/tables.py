#!/usr/bin/env python3
"""Makes the dissertation's Tables 6.1 to 6.7 and Figure 6.3 again, with the methods `dissertation` and the default, and tables of all
meshes and of iterations by size: docs/frame_field_tables.md and its picture.

    bench/frame_field/tables.py BUILD MESH... [--again PART]

BUILD    a build folder set up with -Dbench=true, in which bench-frame-field is built
MESH     meshes of tetrahedra; those named rod, tet-bunny, fertility, joint, hanger and rockerarm stand for the dissertation's
PART     `fields` or `scaling` (--again may be given several times): measured again though BUILD holds its figures of a former run

Needs nothing else. Some 0.3 ms a tetrahedron; times are of CPU, one thread.
"""
import argparse
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from programs import measured, processor  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

# Printed: mean, standard deviation and largest angle and seconds of the compared method and of the dissertation's, and the number
# of curves and nodes of the latter.
PRINTED = (
    ("6.1", "rod", "Rod", "41K", (59.95, 57.49, 180.00, 7.9), (11.52, 21.56, 102.27, 3.2), 946),
    ("6.2", "tet-bunny", "Bunny", "153K", (96.79, 61.07, 180.00, 33.0), (7.26, 20.09, 108.70, 13.4), 2563),
    ("6.3", "fertility", "Fertility", "179K", (100.30, 57.00, 180.00, 35.0), (10.49, 23.10, 109.80, 14.1), 3552),
    ("6.4", "joint", "Joint", "187K", (87.92, 70.32, 180.00, 34.4), (7.47, 23.30, 100.21, 12.71), 397),
    ("6.5", "hanger", "Hanger", "215K", (105.73, 63.11, 180.00, 40.7), (11.75, 26.32, 101.13, 28.7), 1250),
    ("6.6", "rockerarm", "Rocker arm", "254K", (54.97, 53.70, 180.00, 46.9), (2.97, 13.24, 105.88, 4.2), 663),
)

# Columns of bench-frame-field fields, behind the mesh and the method.
FIELDS = ("tets", "faces", "E", "mean", "sd", "median", "p99", "max", "plain_mean", "plain_sd", "plain_median", "plain_p99",
          "plain_max", "above_30", "edges", "quarter_turns", "curves", "nodes", "length_share", "off_normals", "seconds")

MODELS_TEXT = """\
The meshes here are of the same shapes as those of the dissertation, by other programs, of other sizes. Its boundary frames
came from the data of another program, whose fields were smooth: method `dissertation` has those of identity, rotated to the normals, and in the rows
`seed, boundary of default` those of the default field, fixed, as in the printed experiments.
"""

ANGLES_TEXT = """\
## What the printed angles are

Up to the 24 rotations no two frames are more than 62.80 degrees apart. The printed maximum angles of 100 to 110 degrees, and of 180, are
therefore not angles between frames but between the quaternions or labeled axes that stand for them, under matchings that were
frozen or left out. `without` is that: the angle between the quaternions as they stand, up to their sign.

- `dissertation` starts all frames inside as identity and never changes the name of a frame, so that its angles without symmetry are close to
  those with it, and of the printed kind: a small mean, and a maximum of about 90 degrees.
- The default writes each frame as whichever of the 24 quaternions comes out, and neighbors often by different ones. Its angles without
  symmetry are far on the way to those of random rotations (126.5 degrees on average), and say nothing about the field. The compared
  method's printed means of 55 to 106 degrees are of this kind: names, not smoothness.

The columns with symmetry are the ones to compare by. Where those without would call `dissertation` the smoother one on every mesh, by these it is
the other way round but for what is said under [all meshes](#all-meshes).
"""


METHODS = ("dissertation", "seed, boundary of default", "default")


def read_fields(text):
    fields, angles = {}, {}
    for line in text.splitlines():
        kind, mesh, method, *values = line.split("\t")
        if kind == "angles":
            angles[mesh, method] = [float(value) for value in values]
            continue
        if values[-1] != "valid":
            raise SystemExit(f"tables.py: the field of {mesh} by {method} is not valid")
        fields[mesh, method] = dict(zip(FIELDS, map(float, values)))
    return fields, angles


def three(f, prefix=""):
    return " / ".join(f"{f[prefix + key]:.2f}" for key in ("mean", "sd", "max"))


def printed_tables(fields):
    lines = ["| table | model | | tetrahedra | with symmetry: mean / sd / max | without: mean / sd / max | s |", "|---|---|---|---|---|---|---|"]
    for number, name, title, tets, compared, own, _ in PRINTED:
        for row, (who, values) in enumerate((("printed, compared method", compared), ("printed, dissertation", own))):
            lines.append(f"| {number if row == 0 else ''} | {title if row == 0 else ''} | {who} | {tets} | not reported | "
                         + " / ".join(f"{v:.2f}" for v in values[:3]) + f" | {values[3]:g} |")
        for method in METHODS:
            if (name, method) in fields:
                f = fields[name, method]
                lines.append(f"| | | our `{method}` | {f['tets'] / 1000:.0f}K | {three(f)} | {three(f, 'plain_')} | {f['seconds']:.1f} |")
    return "\n".join(lines) + "\n"


def slower_than_printed(fields):
    lines = ["Slower than printed, whatever the sizes of the meshes:", ""]
    for method in METHODS:
        found = [f"{title} ({fields[name, method]['seconds']:.1f} s, printed {own[3]:g})"
                 for _, name, title, _, _, own, _ in PRINTED
                 if (name, method) in fields and fields[name, method]["seconds"] > own[3]]
        lines.append(f"- `{method}`: " + (", ".join(found) or "none"))
    return "\n".join(lines) + "\n"


def structure_table(fields):
    lines = ["| | " + " | ".join(row[2] for row in PRINTED) + " |", "|---" * (len(PRINTED) + 1) + "|",
             "| printed, curves + nodes | " + " | ".join(str(row[6]) for row in PRINTED) + " |"]
    for method in METHODS:
        cells = []
        for row in PRINTED:
            f = fields.get((row[1], method))
            cells.append(f"{f['curves']:.0f} + {f['nodes']:.0f}" if f else "")
        lines.append(f"| our `{method}` | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def all_table(fields, names):
    lines = ["| mesh | tetrahedra | | E | mean / sd / median / p99 / max | above 30 | singular edges (quarter turns) | share of length | curves + nodes | CPU s |",
             "|---|---|---|---|---|---|---|---|---|---|"]
    for name in names:
        for method in METHODS:
            f = fields[name, method]
            first = method == METHODS[0]
            angles = " / ".join(f"{f[key]:.2f}" for key in ("mean", "sd", "median", "p99", "max"))
            lines.append(f"| {name if first else ''} | {f['tets']:.0f} | `{method}` | {f['E']:.1f} | {angles} | {f['above_30']:.0f} | "
                         f"{f['edges']:.0f} ({f['quarter_turns']:.0f}) | {100 * f['length_share']:.2f} % | "
                         f"{f['curves']:.0f} + {f['nodes']:.0f} | {f['seconds']:.1f} |")
    summary = ""
    for method in METHODS[:2]:
        energies, structures = [], []
        for name in names:
            seed, ours = fields[name, method], fields[name, "default"]
            energies.append(ours["E"] / seed["E"] if seed["E"] > 0 else 1)
            before, after = (f["curves"] + f["nodes"] for f in (seed, ours))
            structures.append(after / before if before else 1)
        summary += (f"The default's E is {min(energies):.2f} to {max(energies):.2f} times that of `{method}`; at most half of it on "
                    f"{sum(e <= 0.5 for e in energies)} of {len(names)} meshes. Its curves and nodes are {min(structures):.2f} to {max(structures):.2f} "
                    f"times as many; at most an eighth on {sum(s <= 0.125 for s in structures)} of {len(names)}.\n")
    for key, title in (("mean", "The mean angle"), ("sd", "The standard deviation"), ("p99", "The angle at 99 %"),
                       ("max", "The maximum angle"), ("edges", "The number of singular edges")):
        worse = [name for name in names if fields[name, "default"][key] > fields[name, "dissertation"][key]]
        summary += f"{title} is " + (f"larger than that of `dissertation` on {', '.join(worse)}." if worse else "nowhere larger than that of `dissertation`.") + "\n"
    return "\n".join(lines) + "\n", summary


def scaling_table(text):
    rows = [line.split("\t") for line in text.splitlines()]
    lines = ["| " + " | ".join(rows[0]) + " |", "|---" * len(rows[0]) + "|"]
    lines += ["| " + " | ".join(row) + " |" for row in rows[1:]]
    return "\n".join(lines) + "\n"


def angle_picture(angles, path):
    """Figure 6.3: the share of inner faces with angles up to the abscissa in degrees; red the default, blue `dissertation`."""
    width, height, left, top, gap = 240, 170, 40, 30, 46
    shown = [row for row in PRINTED if (row[1], "default") in angles]
    columns = 3
    lines = []
    for i, (_, name, title, *_) in enumerate(shown):
        x0, y0 = left + i % columns * (width + gap), top + i // columns * (height + gap + 10)

        def at(degrees, share, x0=x0, y0=y0):
            return f"{x0 + degrees / 64 * width:.1f},{y0 + (1 - share) * height:.1f}"
        lines.append(f'<text x="{x0 + width / 2}" y="{y0 - 8}" text-anchor="middle" font-weight="bold">{title}</text>')
        for percent in range(0, 101, 25):
            y = y0 + (1 - percent / 100) * height
            lines.append(f'<path d="M{x0},{y}h{width}" stroke="#ddd"/><text x="{x0 - 5}" y="{y + 4}" text-anchor="end">{percent}</text>')
        for degrees in range(0, 61, 20):
            x = x0 + degrees / 64 * width
            lines.append(f'<text x="{x}" y="{y0 + height + 15}" text-anchor="middle">{degrees}</text>')
        for method, color in (("dissertation", "#2060c0"), ("default", "#c02020")):
            points = " ".join([at(0, 0)] + [at(d + 1, share) for d, share in enumerate(angles[name, method])])
            lines.append(f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="1.5"/>')
        lines.append(f'<rect x="{x0}" y="{y0}" width="{width}" height="{height}" fill="none" stroke="#444"/>')
    rows = (len(shown) + columns - 1) // columns
    size = (left + columns * (width + gap), top + rows * (height + gap + 10))
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{size[0]}" height="{size[1]}" font-family="sans-serif" '
                   'font-size="11"><rect width="100%" height="100%" fill="#fff"/>\n' + "\n".join(lines) + "\n</svg>\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("meshes", nargs="+")
    parser.add_argument("--again", action="append", default=[], choices=("fields", "scaling"))
    options = parser.parse_args()
    program = os.path.join(options.build, "bench", "frame_field", "bench-frame-field")

    def kept(name):
        return os.path.join(options.build, "bench", "frame_field", name)

    fields, angles = read_fields(measured(kept("fields.tsv"), [program, "fields", *options.meshes], "fields" in options.again))
    small = [path for path in options.meshes if fields[stem(path), "default"]["tets"] < 40000]
    scaling = measured(kept("scaling.tsv"), [program, "scaling", *small], "scaling" in options.again)
    angle_picture(angles, os.path.join(ROOT, "docs", "images", "frame_field_angles.svg"))
    whole, summary = all_table(fields, [stem(path) for path in options.meshes])
    page = f"""# The dissertation's frame field tables, recomputed

`bench/frame_field/tables.py BUILD MESH...` measures, writes this page and draws its picture. `dissertation` is chapter 6 as printed
([frame_field](frame_field.md#the-dissertations-tables)), `default` what `orbicube frames` does without options. Angles are
between the frames on both sides of the inner faces, in degrees. Printed times are of an Intel Core i3 at 2.1 GHz, ours CPU seconds of one core
of: {processor()}.

{MODELS_TEXT}
## Tables 6.1 to 6.6: smoothness

{printed_tables(fields)}
{slower_than_printed(fields)}
{ANGLES_TEXT}
## Table 6.7: singularities

Numbers of singular curves and nodes:

{structure_table(fields)}
## Figure 6.3: distribution of angles

![Cumulative share of inner faces by angle](images/frame_field_angles.svg)

Per cent of inner faces with an angle (up to the 24 rotations) up to the abscissa in degrees: red the default, blue `dissertation`. The picture that
`orbicube frames --plot` draws of one field has the same curve.

## All meshes

{summary}

Every field has an axis along the normal to 1e-6 degrees at every tetrahedron of the boundary, no curve that ends inside,
and boundary indices that add up to the Euler characteristic.

{whole}
## Iterations by size

Harmonic start and smoothing with one start (`bench-frame-field scaling MESH...`): iterations of the solver, which has nine unknowns a tetrahedron for the
start and three for smoothing. Refined: each tetrahedron split into eight.

{scaling_table(scaling)}"""
    path = os.path.join(ROOT, "docs", "frame_field_tables.md")
    with open(path, "w", encoding="utf-8") as file:
        file.write(page)
    print("wrote", path)


def stem(path):
    return os.path.splitext(os.path.basename(path))[0]


main()
