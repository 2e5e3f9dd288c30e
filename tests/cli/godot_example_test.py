#!/usr/bin/env python3
"""The scene of examples/godot, played by Godot 3 without a display: godot_example_test.py COMMAND EXAMPLE GLTF_TESTS

Its file is made as the example's README says, but from boxes. Returns 77 where there is no godot3-server.
"""
import json
import os
import shutil
import subprocess
import sys
import tempfile

from command import run


def main():
    example, gltf_tests = sys.argv[2:]
    sys.path.insert(0, gltf_tests)
    from engines import described, import_into
    godot = shutil.which("godot3-server")
    if not godot:
        print("skipped: godot3-server is not there")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        project = os.path.join(folder, "project")
        shutil.copytree(example, project)
        glb = os.path.join(project, "morph.glb")
        for name, resolution in (("one", 200), ("other", 400)):
            assert run("make", "cube", "-o", os.path.join(folder, name + ".ply"), "--resolution", resolution).returncode == 0
        done = run("morph", os.path.join(folder, "one.ply"), os.path.join(folder, "other.ply"), "--polycube",
                   "--show-polycube", "-o", glb)
        assert done.returncode == 0, done.stderr
        shutil.copy(os.path.join(gltf_tests, "engines", "scene_check.gd"), project)
        environment = dict(os.environ, HOME=folder, XDG_DATA_HOME=folder, XDG_CONFIG_HOME=folder, XDG_CACHE_HOME=folder)
        import_into(project, ["morph.glb"], [godot, "--path", project, "--editor", "--quit"], environment)
        answer = subprocess.run([godot, "--path", project, "--script", "scene_check.gd"], stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True, timeout=120, env=environment, check=False)
        lines = [line for line in answer.stdout.splitlines() if line.startswith("SCENE ")]
        assert lines, answer.stdout
        print(lines[0])
        found = json.loads(lines[0][6:])
        file = described(glb)
        assert (found["names"], found["vertices"]) == (["polycube", "other"], file.vertices)
        # The first shape becomes the polycube, that the other one, and that the first again.
        halves = [[0, 0], [0.5, 0], [1, 0], [0.5, 0.5], [0, 1], [0, 0.5], [0, 0]]
        assert found["shown"] == halves, found["shown"]
        assert found["moved"][0] > 0 and abs(found["size"] - 2) < 1e-3
    return 0


if __name__ == "__main__":
    sys.exit(main())
