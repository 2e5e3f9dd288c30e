#!/usr/bin/env python3
"""Checks written glTF files with other programs: Khronos's validator and three.js (both in node), Godot 3 and
Blender.

    engines.py WRITE_SAMPLES [--modules FOLDER] [--install] [FILE...]

WRITE_SAMPLES is the program of write_samples.cpp. More files may be named: they are validated and
must be imported as what their own JSON says.
FOLDER is where engines/package.json was installed (npm install); without the option, the variable
ORBICUBE_NODE_MODULES, else engines/ itself. --install does it, in a temporary folder, from the network. What is not there
is skipped, saying so; answers 77 when everything is.
"""

import argparse
import glob
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time

HERE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "engines")


class Sample:
    """A file and what must be found in it; `everything` for one with all that can be in it."""

    def __init__(self, path, vertices, triangles, edges, targets, everything=False):
        self.path, self.vertices, self.triangles, self.edges, self.targets = path, vertices, triangles, edges, targets
        self.everything = everything

    def differences(self, found):
        wanted = {"vertices": self.vertices, "triangles": self.triangles, "morphTargets": self.targets}
        for key, value in wanted.items():
            if found[key] != value:
                yield f"{os.path.basename(self.path)}: {key} {found[key]}, not {value}"


def write_samples(program, folder):
    samples = []
    for line in subprocess.run([program, folder], check=True, capture_output=True, text=True).stdout.splitlines():
        name, vertices, triangles, edges, *targets = line.split(" ")
        names = targets[0].split(",") if targets and targets[0] else []
        samples.append(Sample(os.path.join(folder, name), int(vertices), int(triangles), int(edges), names, True))
    return samples


def described(path):
    """What the JSON of a file says of its first mesh."""
    with open(path, "rb") as file:
        data = file.read()
    if data[:4] == b"glTF":
        data = data[20:20 + int.from_bytes(data[12:16], "little")]
    scene = json.loads(data)
    mesh = scene["meshes"][0]
    count = {mode: 0 for mode in (1, 4)}
    for primitive in mesh["primitives"]:
        count[primitive.get("mode", 4)] += scene["accessors"][primitive["indices"]]["count"]
    vertices = scene["accessors"][mesh["primitives"][0]["attributes"]["POSITION"]]["count"]
    return Sample(path, vertices, count[4] // 3, count[1] // 2, mesh.get("extras", {}).get("targetNames", []))


def run(command, **options):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300, **options)


def check_validator(modules, samples):
    answer = run(["node", os.path.join(HERE, "validate.mjs"), modules] + [sample.path for sample in samples])
    print(answer.stdout, end="")
    return [] if answer.returncode == 0 else ["the validator has errors or warnings"]


def check_three(modules, samples):
    answer = run(["node", os.path.join(HERE, "three.mjs"), modules] + [sample.path for sample in samples])
    print(answer.stdout, end="")
    lines = [json.loads(line) for line in answer.stdout.splitlines() if line.startswith("{")]
    if answer.returncode != 0 or len(lines) != len(samples):
        return ["three.js did not load every file"]
    problems = []
    for sample, found in zip(samples, lines):
        problems += sample.differences(found)
        problems += [f"a morph target of {count} vertices" for count in found["morphVertices"] if count != found["vertices"]]
        if found["edges"] != sample.edges:
            problems.append(f"{found['edges']} edges, not {sample.edges}")
        if sample.everything and sample.targets and not (found["texture"] and {"uv", "normal", "color"} <= set(found["attributes"])):
            problems.append("texture, texture coordinate, normals or colors are missing")
    return problems


def import_into(project, names, command, environment):
    """Runs the editor until it has imported the files. Without a display Godot 3.2 does not always end by itself."""
    editor = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    end = time.monotonic() + 60
    while editor.poll() is None and time.monotonic() < end:
        if all(glob.glob(os.path.join(project, ".import", name + "-*.md5")) for name in names):
            break
        time.sleep(0.1)
    editor.kill()
    editor.wait()


def check_godot(godot, samples, folder):
    project = os.path.join(folder, "project")
    shutil.copytree(os.path.join(HERE, "godot"), project)
    names = []
    for number, sample in enumerate(samples):
        names.append(f"file{number}{os.path.splitext(sample.path)[1]}")
        shutil.copy(sample.path, os.path.join(project, names[-1]))
    environment = dict(os.environ, HOME=folder, XDG_DATA_HOME=folder, XDG_CONFIG_HOME=folder, XDG_CACHE_HOME=folder)
    import_into(project, names, [godot, "--path", project, "--editor", "--quit"], environment)
    answer = run([godot, "--path", project, "--script", "describe.gd"] + [f"res://{name}" for name in names],
                 env=environment)
    lines = [json.loads(line[9:]) for line in answer.stdout.splitlines() if line.startswith("IMPORTED ")]
    for line in lines:
        print(json.dumps(line))
    found = {line["path"]: line for line in lines}
    problems = []
    for name, sample in zip(names, samples):
        if f"res://{name}" not in found:
            problems.append(f"Godot did not import {sample.path}:\n{answer.stdout}")
            continue
        line = found[f"res://{name}"]
        problems += sample.differences(line)
        if sample.targets == ["thin", "same"] and not (line["uv"] and line["normals"] and line["moved"][0] > 0.01):
            problems.append("texture coordinate, normals or the morph are missing")
    return problems


def check_blender(blender, samples, folder):
    # Its Python looks for modules beside the first python3 of PATH, which must be the system's.
    environment = dict(os.environ, HOME=folder, PATH=os.path.dirname(blender) + os.pathsep + os.environ["PATH"])
    answer = run([blender, "--background", "--factory-startup", "--python", os.path.join(HERE, "blender.py"), "--"]
                 + [sample.path for sample in samples], env=environment)
    lines = [json.loads(line[9:]) for line in answer.stdout.splitlines() if line.startswith("IMPORTED ")]
    problems = [] if len(lines) == len(samples) else [f"Blender did not import every file:\n{answer.stdout}"]
    for sample, line in zip(samples, lines):
        print(json.dumps(line))
        if sample.edges:
            line["vertices"] //= 2  # lines get vertices of their own
        problems += sample.differences(line)
        if sample.everything and sample.targets and not (line["uv"] and line["moved"][0] > 0.01):
            problems.append("texture coordinate or the morph are missing in Blender")
    return problems


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("write_samples")
    parser.add_argument("files", nargs="*")
    parser.add_argument("--modules", default=os.environ.get("ORBICUBE_NODE_MODULES", HERE))
    parser.add_argument("--install", action="store_true")
    options = parser.parse_args()

    problems, ran = [], 0
    with tempfile.TemporaryDirectory() as folder:
        samples = write_samples(options.write_samples, folder) + [described(path) for path in options.files]
        modules = options.modules
        if options.install:
            modules = os.path.join(folder, "modules")
            os.mkdir(modules)
            shutil.copy(os.path.join(HERE, "package.json"), modules)
            subprocess.run(["npm", "install", "--ignore-scripts", "--no-audit", "--no-fund"], cwd=modules, check=True)
        for name, package, check in (("Khronos's validator", "gltf-validator", check_validator),
                                     ("three.js", "three", check_three)):
            if shutil.which("node") and os.path.isdir(os.path.join(modules, "node_modules", package)):
                print(f"{name}:")
                problems += check(modules, samples)
                ran += 1
            else:
                print(f"{name}: skipped, node or the package {package} is not there")
        godot = shutil.which("godot3-server")
        if godot:
            print("Godot:")
            problems += check_godot(godot, samples, folder)
            ran += 1
        else:
            print("Godot: skipped, godot3-server is not there")
        blender = shutil.which("blender")
        if blender:
            print("Blender:")
            problems += check_blender(blender, samples, folder)
            ran += 1
        else:
            print("Blender: skipped, it is not there")
    for problem in problems:
        print("FAILED:", problem)
    return 1 if problems else 0 if ran else 77


if __name__ == "__main__":
    sys.exit(main())
