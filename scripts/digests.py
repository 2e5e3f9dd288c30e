#!/usr/bin/env python3
"""Prints the SHA-256 of what a fixed set of commands writes, a line a file, to compare results before and after a change.

    digests.py COMMAND [--models FOLDER] [--only VERB] [--against FILE]

COMMAND is the orbicube command. The set has every verb and method, on shapes of `make` and, where FOLDER (ORBICUBE_MODELS) is
there, on real models. With --only, the outputs of that verb alone; what they are made of is made as well. With --against it
compares with an earlier output. Exits with 1, and says why, where a command fails, and where an output differs or was not
compared. Everything runs in a temporary folder; it takes about three minutes.
"""

import argparse
import hashlib
import os
import subprocess
import sys
import tempfile

# NAME: the arguments of the command that writes it. Files of --models are given as models/...
MADE = """
creature.obj: make creature -o creature.obj --resolution 4000
blob.ply: make blob -o blob.ply --resolution 3000
star.off: make star -o star.off --resolution 3000
ball.stl: make sphere -o ball.stl --resolution 2000
cube.obj: make cube -o cube.obj --resolution 1200
torus.obj: make torus -o torus.obj --resolution 2000
three.obj: make three-holes -o three.obj --resolution 1500
bracket.obj: make bracket -o bracket.obj --resolution 2500
l.obj: make l-shape -o l.obj --resolution 900
cylinder.mesh: make cylinder -o cylinder.mesh --resolution 1200
vase.vtk: make vase -o vase.vtk --resolution 1200
convert.ply: convert creature.obj convert.ply
convert.vtk: convert creature.obj convert.vtk --text
convert.glb: convert creature.obj convert.glb
convert.gltf: convert blob.ply convert.gltf
sphere.obj: sphere creature.obj -o sphere.obj
sphere-blob.obj: sphere blob.ply -o sphere-blob.obj
sphere-angle-area.obj: sphere creature.obj -o sphere-angle-area.obj --method angle-area
sphere-stretch.obj: sphere creature.obj -o sphere-stretch.obj --method stretch
sphere-isometric.obj: sphere blob.ply -o sphere-isometric.obj --method isometric
sphere-conformal.obj: sphere blob.ply -o sphere-conformal.obj --method conformal
sphere-dissertation.obj: sphere blob.ply -o sphere-dissertation.obj --method dissertation
sphere.glb: sphere blob.ply -o sphere.glb
remesh.obj: sphere creature.obj -o r.obj --remesh remesh.obj --grid icosphere:4
remesh-cube.obj: sphere creature.obj -o r.obj --remesh remesh-cube.obj --grid cube:16
image.pfm: sphere creature.obj -o r.obj --image image.pfm --image-grid octahedron:64
image.png: sphere creature.obj -o r.obj --image image.png --image-grid cube:32
harmonics.sh: harmonics creature.obj --sphere sphere.obj --degree 16 -o harmonics.sh
harmonics.coef: harmonics blob.ply --sphere sphere-blob.obj --degree 12 -o harmonics.coef --method dense
iterative.sh: harmonics creature.obj --sphere sphere.obj --degree 16 -o iterative.sh --method iterative
low.obj: harmonics creature.obj --sphere sphere.obj --degree 16 -o low.sh --low 8 --width 2 --reconstruct low.obj
aligned.sh: harmonics creature.obj --sphere sphere.obj --degree 12 -o aligned.sh --align-to harmonics.coef
compare.txt: compare harmonics.sh iterative.sh low.sh -o compare.txt
morph.glb: morph creature.obj blob.ply -o morph.glb
morph-first.glb: morph creature.obj blob.ply -o morph-first.glb --grid first --align rotation
morph-polycube.glb: morph torus.obj --polycube --grid first --placement scaled torus.obj -o morph-polycube.glb
polycube.obj: polycube bracket.obj -o polycube.obj --surface surface.obj --quads quads.obj --cells 3000
surface.obj: =
quads.obj: =
polycube-blob.obj: polycube blob.ply -o polycube-blob.obj --domain domain.json
domain.json: =
polycube-labels.obj: polycube bracket.obj -o polycube-labels.obj --construct labels
polycube-voxels.obj: polycube torus.obj -o polycube-voxels.obj --construct voxels
polycube-from.obj: polycube blob.ply -o polycube-from.obj --from domain.json
optimized.obj: polycube l.obj -o optimized.obj --optimize domain
optimized-corners.obj: polycube l.obj -o optimized-corners.obj --optimize corners
optimized-gradient.obj: polycube l.obj -o optimized-gradient.obj --optimize corners --corner-search gradient
harmonic.obj: polycube l.obj -o harmonic.obj --optimize domain --measure harmonic
sharp.obj: polycube bracket.obj -o sharp.obj --feature-angle 40
torus.mesh: tetrahedralize torus.obj -o torus.mesh
l.mesh: tetrahedralize l.obj -o l.mesh --edge-length .3
l.frames: frames l.mesh -o l.frames --vtk l.vtk
l.vtk: =
torus.frames: frames torus.mesh -o torus.frames --feature-angle 40
dissertation.frames: frames l.mesh -o dissertation.frames --method dissertation --start identity
repaired.frames: frames torus.mesh -o repaired.frames --locally-meshable
volume.mesh: volume l.mesh -o volume.mesh
volume-torus.mesh: volume torus.obj -o volume-torus.mesh
hex-l.mesh: hex l.obj -o hex-l.mesh --cells 400
hex-torus.vtk: hex torus.obj -o hex-torus.vtk --cells 800 --method polycube --text
hex-grid.mesh: hex blob.ply -o hex-grid.mesh --cells 400 --method grid
hex-frames.mesh: hex l.mesh -o hex-frames.mesh --cells 300 --method frames
"""

REAL = """
sphere-cow.obj: sphere models/dev/cow.off -o sphere-cow.obj
sphere-spot.obj: sphere models/dev/spot.obj -o sphere-spot.obj --method stretch
cow.sh: harmonics models/dev/cow.off --sphere sphere-cow.obj --degree 20 -o cow.sh
morph-cow.glb: morph models/dev/cow.off models/dev/spot.obj -o morph-cow.glb
polycube-anchor.obj: polycube models/dev/anchor.off -o polycube-anchor.obj
polycube-cow.obj: polycube models/dev/cow.off -o polycube-cow.obj
octopus.frames: frames models/dev/tet-octopus-low.mesh -o octopus.frames
sphere.frames: frames models/dev/tet-sphere.mesh -o sphere.frames
volume-sphere.mesh: volume models/dev/tet-sphere.mesh -o volume-sphere.mesh
hex-rod.mesh: hex models/dev/rod.obj -o hex-rod.mesh --cells 800
"""


def digest(path):
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def commands(lines):
    """Pairs of the arguments of a command and the files that it writes; "=" stands for the command of the line before."""
    result = []
    for line in lines.strip().splitlines():
        name, arguments = line.split(": ", 1)
        if arguments == "=":
            result[-1][1].append(name)
        else:
            result.append((arguments.split(), [name]))
    return result


def needed_for(verb, given):
    """The commands of a verb and those whose outputs they read, in their order."""
    needed, files = [], set()
    for words, names in reversed(given):
        if words[0] == verb or files & {*names, words[words.index("-o") + 1] if "-o" in words else ""}:
            needed.append((words, names))
            files |= set(words)
    return needed[::-1]


def run(command, given, folder):
    """Triples of verb, name and digest of each output; None where its command failed."""
    for words, names in given:
        done = subprocess.run([command, *words, "--quiet"], cwd=folder, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            print(f"failed: orbicube {' '.join(words)}: {done.stderr.strip()}", file=sys.stderr)
        for name in names:
            path = os.path.join(folder, name)
            yield words[0], name, digest(path) if done.returncode == 0 and os.path.exists(path) else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command")
    parser.add_argument("--models", default=os.environ.get("ORBICUBE_MODELS"))
    parser.add_argument("--only", metavar="VERB", help="outputs of this verb alone")
    parser.add_argument("--against", metavar="FILE", help="an earlier output")
    options = parser.parse_args()
    expected = {}
    if options.against:
        with open(options.against, encoding="utf-8") as file:
            expected = {name: found for found, name in map(str.split, file)}
    given = commands(MADE + (REAL.lstrip() if options.models else ""))
    if options.only:
        given = needed_for(options.only, given)
        if not given:
            sys.exit(f"digests.py: no command of the set has the verb {options.only}")
    compared, faults = set(), 0
    with tempfile.TemporaryDirectory() as folder:
        if options.models:
            os.symlink(os.path.abspath(options.models), os.path.join(folder, "models"))
        for verb, name, found in run(os.path.abspath(options.command), given, folder):
            if found is None:
                faults += 1
            elif options.only in (None, verb):
                compared.add(name)
                if not options.against:
                    print(found, name, flush=True)
                elif expected.get(name) != found:
                    faults += 1
                    print("differs:", name, flush=True)
    if options.against:
        left = set() if options.only else expected.keys() - compared
        faults += len(left)
        for name in sorted(left):
            print("not compared:", name)
        print(f"{len(compared)} compared, {faults} faults")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
