#!/usr/bin/env python3
"""Every glTF file that a verb of the command writes, in other programs: see tests/gltf/engines.py.

    engines_test.py COMMAND ENGINES.py WRITE_SAMPLES
"""
import os
import subprocess
import sys
import tempfile

from command import run


def write_tetrahedra(path):
    """Eight cubes, each cut into six tetrahedra."""
    vertices = [(x, y, z) for x in range(3) for y in range(3) for z in range(3)]
    cells = []
    for corner in [v for v in vertices if max(v) < 2]:
        for order, odd in (((0, 1, 2), 0), ((1, 2, 0), 0), ((2, 0, 1), 0), ((0, 2, 1), 1), ((2, 1, 0), 1), ((1, 0, 2), 1)):
            way, cell = list(corner), [vertices.index(corner)]
            for axis in order:
                way[axis] += 1
                cell.append(vertices.index(tuple(way)))
            if odd:
                cell[2], cell[3] = cell[3], cell[2]
            cells.append(cell)
    with open(path, "w", encoding="ascii") as file:
        file.write(f"MeshVersionFormatted 2\nDimension 3\nVertices\n{len(vertices)}\n")
        file.writelines(f"{x} {y} {z} 0\n" for x, y, z in vertices)
        file.write(f"Tetrahedra\n{len(cells)}\n")
        file.writelines(" ".join(str(v + 1) for v in cell) + " 0\n" for cell in cells)
        file.write("End\n")


def main():
    _, engines, write_samples = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        def at(name):
            return os.path.join(folder, name)

        def verb(*arguments):
            done = run(*arguments, "--quiet")
            if done.returncode != 0:
                sys.exit(f"{' '.join(map(str, arguments))}: {done.stderr}")

        write_tetrahedra(at("solid.mesh"))
        verb("make", "creature", "-o", at("one.ply"), "--resolution", 800)
        verb("make", "creature", "-o", at("two.ply"), "--resolution", 800, "--seed", 1)
        verb("make", "cube", "-o", at("cube.obj"), "--resolution", 300)
        verb("make", "bracket", "-o", at("bracket.obj"), "--resolution", 600)
        verb("make", "torus", "-o", at("made.glb"), "--resolution", 300)
        verb("make", "star", "-o", at("made.gltf"), "--resolution", 300)
        verb("convert", at("one.ply"), at("converted.glb"))
        verb("sphere", at("one.ply"), "-o", at("sphere.glb"), "--remesh", at("remeshed.glb"), "--grid", "icosphere:3")
        verb("sphere", at("one.ply"), "-o", at("sphere.gltf"))
        verb("sphere", at("one.ply"), "-o", at("map.obj"))
        verb("morph", at("one.ply"), at("two.ply"), "-o", at("morph.glb"), "--steps", 1)
        verb("morph", at("cube.obj"), at("cube.obj"), "-o", at("through.glb"), "--polycube", "--corners", 8)
        verb("polycube", at("bracket.obj"), "-o", at("polycube.obj"), "--glb", at("polycube.glb"))
        verb("hex", at("cube.obj"), "-o", at("hexes.mesh"), "--cells", 200, "--glb", at("hexes.glb"))
        verb("frames", at("solid.mesh"), "-o", at("solid.frames"), "--start", "identity", "--glb", at("frames.glb"))
        verb("harmonics", at("one.ply"), "--sphere", at("map.obj"), "--degree", 8, "-o", at("one.coef"), "--reconstruct", at("smooth.glb"))
        files = sorted(at(name) for name in os.listdir(folder) if name.endswith((".glb", ".gltf")))
        print(len(files), "files of the command")
        return subprocess.run([sys.executable, engines, write_samples, *files], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
