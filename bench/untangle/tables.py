#!/usr/bin/env python3
"""Untangles a thousand generated meshes and writes docs/untangle_tables.md: solved cases, beside what peers have published.

    bench/untangle/tables.py BUILD [--again]

BUILD    a build folder set up with -Dbench=true, in which bench-untangle-cases is built
--again  measured again though BUILD holds the figures of a former run

Fails where a case is not solved, or differs with two threads. About two minutes.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from programs import measured, processor  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PAGE = os.path.join(ROOT, "docs", "untangle_tables.md")

HEAD = """\
# Generated meshes untangled

Written by `bench/untangle/tables.py BUILD`, which runs `bench-untangle-cases`: a hundred cases of each family, of random size and strength, whose fixed boundary allows positive
elements. All with the default options and `refine`. `solved`: all elements of the result are positive and all fixed vertices unchanged, by exact signs that the program computes
itself. `without splits`: cases that `obc_untangle_triangles` or `obc_untangle_tetrahedra` solves. `split`: cases whose result has more elements, by at most the factor `maximum growth`.
Seconds are of one core of a shared machine: {processor}.

- **twist**: rings, and bars, of which one end is turned against the other; **fold**: bent strips and bars whose inner vertices are folded back and forth; **handle**:
  plates, blocks and rings with a protrusion or handle that is 2 to 40 times as thin in the map; **star**: disks and balls whose boundary is a star with radii of up to 1 to 15. A positive
  map of each is known. Inner vertices start at random, in one point, at rest, or folded.
- **star split**: squares, strips and T-shapes onto polygons of 3 to 12 corners, and blocks onto octahedra, all star-shaped: most have elements or edges that cannot be positive without splits, or only by rounding,
  in which case they are split too.

"""

PUBLISHED = """
## Published

On other meshes, each as printed by the authors. The set of Du et al. has 10743 triangle meshes and 904 tetrahedral meshes with fixed boundaries.

| method | set | solved |
|---|---|---|
| total content of elements in more dimensions (Du, Aigerman, Zhou, Kovalsky, Yan, Kaufman and Ju 2020) | 11647 meshes of their own | 11647 |
| foldover-free maps (Garanzha, Kaporin, Kudryavtseva, Protais, Ray and Sokolov 2021) | the same | all |
| Expansion Cones (Nigolian, Campen and Bommes 2023) | balls onto star-shaped polyhedra | all, by construction, with splits and rational coordinates |
| Advancing Front Mapping (Livesu 2024) | 36000 maps of disks onto star-shaped polygons | all, by construction, with splits |
"""


def main():
    build = os.path.abspath(sys.argv[1])
    program = os.path.join(build, "bench", "untangle", "bench-untangle-cases")
    output = measured(os.path.join(build, "untangle-cases.txt"), [program], "--again" in sys.argv[2:])
    with open(PAGE, "w", encoding="utf-8") as page:
        page.write(HEAD.format(processor=processor()) + output + PUBLISHED)
    print(output, end="")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    main()
