#!/usr/bin/env python3
"""Makes the dissertation's Tables 3.1 to 3.5 and Figure 3.2 again, with the methods `dissertation`, `balanced` and `angle-area`
beside the printed figures, and the table of time and memory by size: docs/sphere_map_tables.md and its pictures.

    bench/sphere_map/tables.py BUILD MODELS [--again PART]

BUILD    a build folder set up with -Dbench=true, in which the programs bench-sphere-map... are built
MODELS   a folder with cow.off, frog.obj, bunny.ply, horse.ply, david.obj, venus.ply, gargoyle.ply and armadillo.ply
PART     `maps`, `harmonics` or `scaling` (--again may be given several times): measured again though BUILD holds its figures of a former run

Needs chromium for the pictures and nothing else. `maps` and `harmonics` take two minutes, `scaling` five. Times are of CPU, one thread:
for the final figures the machine should do nothing else.
"""
import argparse
import os
import sys

sys.path[:0] = [os.path.dirname(os.path.abspath(__file__)), os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")]
import chart  # noqa: E402
from programs import measured, processor  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
METHODS = ("dissertation", "balanced", "angle-area")
# Columns of Tables 3.1 to 3.3: the head, and the printed method or ours.
COLUMNS = (("harmonic [3]", 0), ("harmonic, here", "harmonic"), ("our `conformal`", "conformal"), ("curvilinear [1]", 1),
           ("curvilinear, here", "curvilinear"), ("Praun-Hoppe [2]", 2), ("dissertation", 3),
           *((f"our `{method}`", method) for method in METHODS))

# As printed: harmonic [3], curvilinear [1], Praun and Hoppe [2], the dissertation's own; rows as in the text.
DISTORTION = {
    "3.1": ("bunny", "Bunny, 34K vertices",
            {"flips": (2585, 0, 3, 0), "E_D": (50.79, 63.57, 78.07, 61.37), "E_A": (22.80, 25.46, 14.01, 14.24),
             "seconds": (2397, 91, 600, 58)}),
    "3.2": ("cow", "Cow, 11K vertices",
            {"flips": (2536, 2, 0, 0), "E_D": (51.19, 73.15, 117.32, 69.92), "E_A": (32.85, 23.79, 14.35, 15.49),
             "seconds": (224, 28, 420, 21)}),
    "3.3": ("gargoyle", "Gargoyle, 100K vertices",
            {"flips": (6106, 9, 0, 0), "E_D": (51.66, 78.80, 81.17, 81.79), "E_A": (93.61, 141.66, 41.48, 47.70),
             "seconds": (24393, 1151.4, 1380, 193)}),
}
TIMES = (("Cow", "cow", "11K", 21), ("Frog", "frog", "25K", 48), ("Bunny", "bunny", "34K", 58),
         ("Horse", "horse", "48K", 89), ("David", "david", "50K", 111), ("Venus", "venus", "50K", 70),
         ("Gargoyle", "gargoyle", "100K", 193), ("Armadillo", "armadillo", "106K", 250), ("Buddha", None, "400K", 526))

# As printed: bands, then harmonic [3], curvilinear [1], the dissertation's own.
RECONSTRUCTION = (
    ("Bunny", "bunny", ((6, 0.1190, 0.1028, 0.0891), (16, 0.0709, 0.0730, 0.0424), (32, 0.0643, 0.0669, 0.0247))),
    ("Venus", "venus", ((6, 0.0299, 0.0455, 0.0279), (16, 0.0117, 0.0160, 0.0113), (32, 0.0088, 0.0102, 0.0083))),
    ("Cow", "cow", ((6, 0.3480, 0.2424, 0.1474), (16, 0.2317, 0.1547, 0.0813), (32, 0.1470, 0.1161, 0.0591))),
    ("Horse", "horse", ((6, 0.3236, 0.2698, 0.1653), (16, 0.2440, 0.1792, 0.0740), (32, 0.1976, 0.1401, 0.0563))),
    ("Armadillo", "armadillo",
     ((6, 0.3151, 0.1962, 0.1260), (16, 0.2127, 0.1106, 0.0309), (32, 0.1725, 0.0900, 0.0222))),
)

RECONSTRUCTION_TEXT = """\
## Table 3.5: reconstruction from spherical harmonics

e(M, M^) of section 3.3.2 from vertices to vertices, the surface scaled to area 4 pi; 6 bands are 6 x 6 coefficients of each
coordinate. The models without splits; the fit is by least squares weighted by area.

"""

STANDS_FOR = """\
| dissertation | here | the same model? |
|---|---|---|
| Bunny, 34K | `bunny.ply` | yes, the Stanford bunny with its holes closed |
| Cow, 11K | `cow.off` (2904 vertices), each triangle split in four | the same cow; the source of the dissertation's vertices is not stated |
| Gargoyle, 100K | `gargoyle.ply` (24992), each triangle split in four | by name only: the printed E_A of every method, at least three times the minimum, is of a shape with far longer protrusions |
| Frog, 25K | `frog.obj` (9555), each triangle split in four | by name only |
| Horse, 48K | `horse.ply` | yes, by its number of vertices |
| David, 50K | `david.obj` (10671), each triangle split in four | by name only: a head |
| Venus, 50K | `venus.ply` | yes, by its number of vertices |
| Armadillo, 106K | `armadillo.ply` (43243), each triangle split in four | the same shape at another resolution |
| Buddha, 400K | none | the available Buddha has genus 6 |
"""


def read_maps(text):
    maps, traces = {}, {}
    for line in text.splitlines():
        kind, *fields = line.split("\t")
        if kind == "map":
            keys = ("vertices", "flips", "E_D", "E_A", "E", "quasi_conformal", "stretch", "seconds", "bytes")
            maps[fields[0], fields[1]] = dict(zip(keys, map(float, fields[2:])))
        else:
            traces.setdefault(fields[0], []).append((int(fields[1]), int(fields[2]), float(fields[3])))
    return maps, traces


def distortion_table(number, maps):
    model, title, printed = DISTORTION[number]
    lines = [f"### Table {number}: {title}", "", "| | " + " | ".join(head for head, _ in COLUMNS) + " |",
             "|---" * (len(COLUMNS) + 1) + "|",
             "| vertices | " + " | ".join(f"{maps[model, c]['vertices']:.0f}" if isinstance(c, str) else "" for _, c in COLUMNS) + " |"]
    total = tuple(0.1 * d + a for d, a in zip(printed["E_D"], printed["E_A"]))
    rows = (("flipped triangles", "flips", "{:.0f}", printed["flips"]), ("E_D", "E_D", "{:.2f}", printed["E_D"]),
            ("E_A", "E_A", "{:.2f}", printed["E_A"]), ("0.1 E_D + E_A", "E", "{:.2f}", total),
            ("maximum quasi-conformal distortion", "quasi_conformal", "{:.3g}", ("",) * 4),
            ("CPU seconds", "seconds", "{:.1f}", printed["seconds"]))
    for name, key, form, values in rows:
        own = "{:.2f}" if key in ("E_D", "E_A", "E") else "{:g}"
        cells = [form.format(maps[model, c][key]) if isinstance(c, str) else "" if values[c] == "" else own.format(values[c])
                 for _, c in COLUMNS]
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def time_table(maps):
    lines = ["### Table 3.4: execution time", "",
             "| model | vertices, printed | s, printed | vertices here | `dissertation`, CPU s | `balanced`, CPU s | "
             "us a vertex: printed | `dissertation` | `balanced` |", "|---|---|---|---|---|---|---|---|---|"]
    for title, model, vertices, seconds in TIMES:
        each = 1e6 * seconds / (1000 * float(vertices[:-1]))
        if model is None:
            lines.append(f"| {title} | {vertices} | {seconds} | none | | | {each:.0f} | | |")
            continue
        seed, balanced = maps[model, "dissertation"], maps[model, "balanced"]
        count = seed["vertices"]
        lines.append(f"| {title} | {vertices} | {seconds} | {count:.0f} | {seed['seconds']:.1f} | "
                     f"{balanced['seconds']:.1f} | {each:.0f} | {1e6 * seed['seconds'] / count:.0f} | "
                     f"{1e6 * balanced['seconds'] / count:.0f} |")
    return "\n".join(lines) + "\n"


def reconstruction_table(text):
    errors, vertices = {}, {}
    for line in text.splitlines():
        name, method, count, bands, error, *_ = line.split("\t")
        errors[name, method, int(bands)] = float(error)
        vertices[name] = int(count)
    heads = ("model", "vertices here", "bands", "harmonic [3]", "harmonic, here", "our `conformal`", "curvilinear [1]", "curvilinear, here",
             "dissertation", "our `dissertation`", "our `balanced`", "our `stretch`")
    lines = ["| " + " | ".join(heads) + " |", "|---" * len(heads) + "|"]
    for title, model, rows in RECONSTRUCTION:
        for i, (bands, *printed) in enumerate(rows):
            cells = [title if i == 0 else "", str(vertices[model]) if i == 0 else "", str(bands)]
            cells += [f"{c:.4f}" if isinstance(c, float) else f"{errors[model, c, bands]:.4f}" for c in (
                printed[0], "harmonic", "conformal", printed[1], "curvilinear", printed[2], "dissertation", "balanced", "stretch")]
            lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def energy_picture(traces, path):
    names = [name for name in ("bunny", "cow", "horse", "venus", "gargoyle", "armadillo") if name in traces]
    whole = [(name, [(i, energy / count) for i, count, energy in traces[name]]) for name in names]
    # As the dissertation does: the beginning with its large energies is left out.
    sums = [(name, [(i, energy) for i, count, energy in traces[name] if count >= 150]) for name in names]
    chart.write(path, [
        chart.panel("Energy per vertex", "iterations", "E of the mesh so far / its vertices", whole, True, True),
        chart.panel("Energy", "iterations", "E of the mesh so far", sums, True)])


def scaling_table(text):
    rows = [line.split() for line in text.splitlines()]
    lines = ["| vertices | CPU s, one thread | us a vertex | peak memory, MB | bytes a vertex | s, one thread | s, two threads | gain |",
             "|---|---|---|---|---|---|---|---|"]
    for vertices, valid, cpu, each, peak, bytes_each, one, two, gain, same in rows[1:-1]:
        if valid != "yes" or same != "yes":
            raise SystemExit(f"tables.py: the map of {vertices} vertices is not valid, or not the same with two threads")
        lines.append(f"| {vertices} | {cpu} | {each} | {peak} | {bytes_each} | {one} | {two} | {gain} |")
    return "\n".join(lines) + f"\n\nFitted: {text.splitlines()[-1]}.\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("models")
    parser.add_argument("--again", action="append", default=[], choices=("maps", "harmonics", "scaling"))
    options = parser.parse_args()
    program = os.path.join(options.build, "bench", "sphere_map", "bench-sphere-map")

    def kept(name):
        return os.path.join(options.build, "bench", "sphere_map", name)

    maps, traces = read_maps(measured(kept("maps.tsv"), [program + "-tables", options.models],
                                      "maps" in options.again))
    reconstruction = ""
    if os.path.exists(program + "-reconstruction"):
        reconstruction = RECONSTRUCTION_TEXT + reconstruction_table(
            measured(kept("harmonics.tsv"), [program + "-reconstruction", options.models],
                     "harmonics" in options.again)) + "\n"
    else:
        print("Table 3.5 is left out: the build has no library harmonics")
    scaling = measured(kept("scaling.txt"), [program, "scaling"], "scaling" in options.again)
    energy_picture(traces, os.path.join(ROOT, "docs", "images", "sphere_map_energy.png"))
    bunny = maps["bunny", "dissertation"]
    page = f"""# The dissertation's sphere map tables, recomputed

`bench/sphere_map/tables.py BUILD MODELS` measures, writes this page and draws its picture. Weights are the dissertation's,
(0.1, 1). Energies are of the surface scaled to area 4 pi, with eq. 3.3 read so that E_D(T) is a density (as printed it vanishes
under refinement): E_D is at least 50.27, E_A at least 12.57, 0.1 E_D + E_A at least 17.59. Flips are counted exactly. Printed
times are of an AMD Athlon X2 at 2.9 GHz, ours of one core of: {processor()}.

`dissertation` is chapter 3 as printed, corrected only where it would fail: [corrections](sphere_map.md#the-dissertations-method). `balanced` is
the default; `angle-area` minimizes the same energy as `dissertation` with the methods of this library.

*Here* are baselines of the bench (`bench/sphere_map/baselines.h`), which prevent no flips: the harmonic map by its flow, and a map after the curvilinear one by
quasi-harmonic latitude and longitude, whose details are not the published ones. `conformal` is this library's map of minimum E_D that flips nothing. Praun and Hoppe's program is not
available: figures of its maps elsewhere in these pages were measured once, and are frozen in the benches.

## Which model stands for which

{STANDS_FOR}
## Distortion

{distortion_table("3.1", maps)}
{distortion_table("3.2", maps)}
{distortion_table("3.3", maps)}
On the bunny, where both have the same surface, `dissertation` reaches E_D {bunny["E_D"]:.2f} and E_A {bunny["E_A"]:.2f}; printed are 61.37
and 14.24. The dissertation's energy has no barrier: its best maps have needles, as their maximum quasi-conformal distortions show.

## Time

{time_table(maps)}
## Figure 3.2: energy by iteration

![Energy of the dissertation's method by iteration](images/sphere_map_energy.png)

An iteration is one search of Algorithm 2. On the left the energy per vertex of the mesh as it is refined, which is what the
dissertation draws; on the right E itself, from 150 vertices on. Most iterations are on coarse meshes: one or two
rounds over all vertices at the end change E in its fifth digit.

{reconstruction}## Time and memory by size

The default method on the shape of `orbicube make creature` (`bench-sphere-map scaling`), bit-identical with one and two threads:

{scaling_table(scaling)}"""
    path = os.path.join(ROOT, "docs", "sphere_map_tables.md")
    with open(path, "w", encoding="utf-8") as file:
        file.write(page)
    print("wrote", path)


main()
