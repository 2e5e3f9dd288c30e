#!/usr/bin/env python3
"""The add-on of Blender: its zip file is installed in a new profile, every operator runs in the background, and the file that is saved
holds what it should when another Blender opens it.

    addon_test.py PACK LIBRARIES      bindings/blender/pack.py, and the folder of the built libraries (or a wheel)

Returns 77 where there is no Blender.
"""

import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))


def run(blender, home, script, *arguments):
    # Its Python looks for modules beside the first python3 of PATH, which must be the system's.
    environment = dict(os.environ, HOME=home, XDG_CONFIG_HOME=os.path.join(home, "config"),
                       PATH=os.path.dirname(blender) + os.pathsep + os.environ["PATH"])
    for name in ("ORBICUBE_LIBRARIES", "PYTHONPATH"):
        environment.pop(name, None)
    ran = subprocess.run([blender, "--background", "--factory-startup", "--python-exit-code", "1", "--python",
                          os.path.join(HERE, script), "--", *arguments], env=environment, cwd=home, text=True, timeout=600,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    print(ran.stdout, end="")
    # A script that cannot be read ends Blender with 0.
    return ran.returncode == 0 and f"{script} has passed" in ran.stdout


def main():
    pack, libraries = map(os.path.abspath, sys.argv[1:])
    blender = shutil.which("blender")
    if not blender:
        print("skipped: there is no Blender (Debian: blender)")
        return 77
    with tempfile.TemporaryDirectory() as home:
        addon, scene = os.path.join(home, "orbicube_blender.zip"), os.path.join(home, "scene.blend")
        source = "--wheel" if libraries.endswith(".whl") else "--libraries"
        subprocess.run([sys.executable, pack, addon, source, libraries], check=True)
        if not run(blender, home, "make_scene.py", addon, scene):
            return 1
        return 0 if run(blender, home, "check_scene.py", scene) else 1


if __name__ == "__main__":
    sys.exit(main())
