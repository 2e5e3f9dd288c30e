#!/usr/bin/env python3
"""Every glTF file that a verb of the command writes, in other programs: see tests/gltf/engines.py.

    engines_test.py COMMAND ENGINES.py WRITE_SAMPLES
"""
import os
import subprocess
import sys
import tempfile

from command import run
from tetrahedra import box, write_medit


def main():
    _, engines, write_samples = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        def at(name):
            return os.path.join(folder, name)

        def verb(*arguments):
            done = run(*arguments, "--quiet")
            if done.returncode != 0:
                sys.exit(f"{' '.join(map(str, arguments))}: {done.stderr}")

        write_medit(at("solid.mesh"), *box(2))
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
        verb("morph", at("one.ply"), at("two.ply"), "-o", at("morph.glb"), "--intermediates", 1)
        verb("morph", at("cube.obj"), at("cube.obj"), "-o", at("through.glb"), "--polycube", "--corners", 8)
        verb("morph", at("cube.obj"), at("cube.obj"), "-o", at("shown.glb"), "--polycube", "--show-polycube", "--corners", 8)
        verb("polycube", at("bracket.obj"), "-o", at("polycube.obj"), "--glb", at("polycube.glb"), "--atlas", at("atlas.glb"))
        verb("hex", at("cube.obj"), "-o", at("hexes.mesh"), "--cells", 200, "--glb", at("hexes.glb"))
        verb("hex", at("cube.obj"), "-o", at("cut.mesh"), "--cells", 200, "--glb", at("cut.glb"), "--cut", "half")
        verb("hex", at("solid.mesh"), "-o", at("along.mesh"), "--method", "frames", "--cells", 64, "--glb", at("along.glb"))
        verb("frames", at("solid.mesh"), "-o", at("solid.frames"), "--start", "identity", "--glb", at("frames.glb"))
        verb("harmonics", at("one.ply"), "--sphere", at("map.obj"), "--degree", 8, "-o", at("one.coef"), "--reconstruct", at("smooth.glb"))
        files = sorted(at(name) for name in os.listdir(folder) if name.endswith((".glb", ".gltf")))
        print(len(files), "files of the command")
        return subprocess.run([sys.executable, engines, write_samples, *files], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
