#!/usr/bin/env python3
"""assemblies.py FOLDER [--command build/cli/orbicube] [--cells N]: hexahedra of solids in several regions.

Writes assemblies as tetrahedra with a region number each (FOLDER/NAME.vtk), runs `hex` on them, and prints for each
whether faces of hexahedra are where its regions meet, how far these are from there by the report, the scaled Jacobians,
and by arithmetic of its own the largest error of the volume of a region, in percent. Shapes: boxes whose regions meet in a
plane, a sloping plane or three planes, a ball and a cube in a box, a pillar on a plate, layers, nested balls, a wedge of a
cylinder, a pin through a plate. Open CASCADE makes them, Gmsh fills them (both in the package gmsh; also needs numpy).
"""
import argparse
import json
import os
import resource
import subprocess

import gmsh
import numpy as np


def box(*measures):
    return (3, gmsh.model.occ.addBox(*measures))


def ball(*measures):
    return (3, gmsh.model.occ.addSphere(*measures))


def cylinder(*measures):
    return (3, gmsh.model.occ.addCylinder(*measures))


def sloping():
    part, half = box(0, 0, 0, 2, 1, 1), box(.9, -2, -2, 4, 5, 5)
    gmsh.model.occ.rotate([half], 1, .5, .5, 0, .3, 1, .35)
    beyond = gmsh.model.occ.copy([half])
    inside = gmsh.model.occ.intersect([part], [half], removeObject=False)[0]
    outside = gmsh.model.occ.cut([part], beyond)[0]
    return inside + outside


SHAPES = {
    "plane": lambda: [box(0, 0, 0, .93, 1, 1), box(.93, 0, 0, 1.07, 1, 1)],
    "sloping": sloping,
    "three": lambda: [box(0, 0, 0, .8, 1, 1), box(.8, 0, 0, 1, .55, 1), box(.8, .55, 0, 1, .45, 1)],
    "ball": lambda: [box(0, 0, 0, 1, 1, 1), ball(.5, .5, .5, .3)],
    "cube": lambda: [box(0, 0, 0, 1, 1, 1), box(.3, .3, .3, .4, .4, .4)],
    "pillar": lambda: [box(0, 0, 0, 1, 1, .3), cylinder(.5, .5, .3, 0, 0, .7, .25)],
    "layers": lambda: [box(0, 0, z, 1, 1, h) for z, h in ((0, .3), (.3, .08), (.38, .42))],
    "nested": lambda: [ball(0, 0, 0, 1), ball(0, 0, 0, .7), ball(.1, 0, 0, .35)],
    "wedge": lambda: [cylinder(0, 0, 0, 0, 0, 1, .6), box(0, 0, 0, 2, 2, 2)],
    "pin": lambda: [box(0, 0, 0, 1, 1, .5), cylinder(.5, .5, -.2, 0, 0, .9, .2)],
}


def make(name, path, size):
    """Returns the volumes of the regions, by their numbers."""
    gmsh.clear()
    parts = SHAPES[name]()
    gmsh.model.occ.fragment(parts[:1], parts[1:])
    if name == "wedge":  # what of the box is beyond the cylinder
        gmsh.model.occ.synchronize()
        gmsh.model.occ.remove([v for v in gmsh.model.getEntities(3) if max(gmsh.model.getBoundingBox(*v)) > 1.5], recursive=True)
    gmsh.model.occ.synchronize()
    gmsh.option.setNumber("Mesh.MeshSizeMax", size)
    gmsh.model.mesh.generate(3)
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    number = np.zeros(int(tags.max()) + 1, dtype=int)
    number[tags.astype(int)] = np.arange(len(tags))
    cells, regions = [], []
    for region, (_, volume) in enumerate(gmsh.model.getEntities(3), 1):
        _, nodes = gmsh.model.mesh.getElementsByType(4, volume)
        cells.append(number[nodes.astype(int)].reshape(-1, 4))
        regions += [region] * len(cells[-1])
    cells, positions = np.concatenate(cells), coordinates.reshape(-1, 3)
    used, cells = np.unique(cells, return_inverse=True)
    positions, cells, regions = positions[used], cells.reshape(-1, 4), np.array(regions)
    with open(path, "w", encoding="ascii") as file:
        file.write(f"# vtk DataFile Version 3.0\n{name}\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {len(positions)} double\n")
        np.savetxt(file, positions, "%.17g")
        file.write(f"CELLS {len(cells)} {5 * len(cells)}\n")
        np.savetxt(file, np.c_[np.full(len(cells), 4), cells], "%d")
        file.write(f"CELL_TYPES {len(cells)}\n" + "10\n" * len(cells))
        file.write(f"CELL_DATA {len(cells)}\nSCALARS CellEntityIds int 1\nLOOKUP_TABLE default\n")
        np.savetxt(file, regions, "%d")
    a, b, c, d = (positions[cells[:, k]] for k in range(4))
    volumes = np.abs(np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a)) / 6
    return {r: volumes[regions == r].sum() for r in np.unique(regions)}


def read_hexahedra(path):
    """Positions, hexahedra and their regions of a MEDIT file in ASCII."""
    with open(path, encoding="ascii") as file:
        words = file.read().split()
    at = words.index("Vertices")
    count = int(words[at + 1])
    positions = np.array(words[at + 2:at + 2 + 4 * count], dtype=float).reshape(-1, 4)[:, :3]
    at = words.index("Hexahedra")
    count = int(words[at + 1])
    rows = np.array(words[at + 2:at + 2 + 9 * count], dtype=int).reshape(-1, 9)
    return positions, rows[:, :8] - 1, rows[:, 8]


def volume_of(positions, hexahedra):
    """Of trilinear cells, by two Gauss points along each axis, which is exact."""
    total = np.zeros(len(hexahedra))
    signs = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)])
    gauss = (.5 - .5 / 3 ** .5, .5 + .5 / 3 ** .5)
    for at in ((x, y, z) for x in gauss for y in gauss for z in gauss):
        value = np.where(signs == 1, at, 1 - np.array(at))
        slope = np.where(signs == 1, 1., -1.)
        columns = []
        for axis in range(3):
            factors = value.copy()
            factors[:, axis] = slope[:, axis]
            columns.append(np.einsum("k,nki->ni", factors.prod(axis=1), positions[hexahedra]))
        total += np.einsum("ni,ni->n", columns[0], np.cross(columns[1], columns[2])) / 8
    return total


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--command", default="build/cli/orbicube")
    parser.add_argument("--cells", type=int, default=5000)
    parser.add_argument("--size", type=float, default=.08, help="of the edges of tetrahedra [default: .08]")
    options = parser.parse_args()
    os.makedirs(options.folder, exist_ok=True)
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    print("| assembly | regions | hexahedra | follows them | distance, % | scaled Jacobian min / mean | volume of a region, % | s |")
    print("|---|---|---|---|---|---|---|---|")
    for name in SHAPES:
        base = os.path.join(options.folder, name)
        volumes = make(name, base + ".vtk", options.size)
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        done = subprocess.run([options.command, "hex", base + ".vtk", "-o", base + ".mesh", "--text", "--quiet", "--cells",
                               str(options.cells), "--report", base + ".json"], capture_output=True, text=True, check=False)
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        if done.returncode:
            print(f"| {name} | {len(volumes)} | exit {done.returncode}: {done.stderr.strip()} | | | | | {seconds:.0f} |", flush=True)
            continue
        with open(base + ".json", encoding="utf-8") as file:
            report = json.load(file)
        regions = report["regions"]
        positions, hexahedra, numbers = read_hexahedra(base + ".mesh")
        cells = volume_of(positions, hexahedra)
        error = max(abs(cells[numbers == r].sum() / v - 1) for r, v in volumes.items())
        print(f"| {name} | {len(volumes)} | {len(hexahedra)} | {'yes' if regions['conforming'] else 'no'} | {regions['hausdorff_percent']:.2f} | "
              f"{report['min_scaled_jacobian']:.3f} / {report['mean_scaled_jacobian']:.3f} | {100 * error:.2f} | {seconds:.0f} |", flush=True)
    gmsh.finalize()


if __name__ == "__main__":
    main()
