"""pip makes a wheel that carries the libraries, those of a build or by building them, for any Python 3, and what it installs
works without the tree."""

import glob
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import zipfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))


PIP = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--quiet"]
WHEEL = PIP + ["wheel", "--no-deps", "--no-build-isolation", "--no-index"]
LEFT_OUT = shutil.ignore_patterns("build", "*.egg-info", "__pycache__")


def without_libraries(**more):
    environment = {name: value for name, value in os.environ.items() if name not in ("ORBICUBE_LIBRARIES", "PYTHONPATH")}
    return {**environment, **more}


def installed(folder, wheel):
    target = os.path.join(folder, "installed")
    subprocess.run(PIP + ["install", "--no-deps", "--no-index", "--target", target, wheel], check=True)
    return target


def names_in(wheel):
    with zipfile.ZipFile(wheel) as archive:
        return archive.namelist()


def wheel_of_built_libraries(folder):
    source = os.path.join(folder, "source")
    shutil.copytree(os.path.join(ROOT, "bindings", "python"), source, ignore=LEFT_OUT)
    subprocess.run(WHEEL + ["--wheel-dir", folder, source], check=True)
    wheels = glob.glob(os.path.join(folder, "*.whl"))
    assert len(wheels) == 1 and "-py3-none-" in wheels[0] and "any" not in wheels[0], wheels
    names = names_in(wheels[0])
    assert "orbicube/lib/liborbicube-trust-region.so.0" in names, names
    assert "orbicube/py.typed" in names and "orbicube/raw/mesh.pyi" in names, names
    assert not [name for name in names if "tetrahedra.so" in name], "TetGen binds its users: not in the wheel"
    target = installed(folder, wheels[0])
    program = ("import orbicube, os; from orbicube import mesh, sphere_map; "
               "print(os.path.dirname(orbicube.__file__)); "
               "assert sphere_map.compute(mesh.make('sphere', 200)).report.bijective; "
               "maps = open('/proc/self/maps').read(); assert maps.count('installed/orbicube/lib/liborbicube') > 2")
    said = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, text=True, cwd=folder,
                          env=without_libraries(PYTHONPATH=target)).stdout
    assert said.strip() == os.path.join(target, "orbicube"), said


def wheel_that_builds_one_library(folder):
    """As `pip install bindings/python`, with Meson, of one solver alone. The tree around the package is one of links, for what
    setuptools writes is beside its sources."""
    if not (shutil.which("meson") and shutil.which("ninja")):
        print("there is no meson to build the libraries with: left out")
        return
    tree = os.path.join(folder, "tree")
    bindings = os.path.join(tree, "bindings")
    os.makedirs(bindings)
    for entry in os.listdir(ROOT):
        if entry != "bindings" and not entry.startswith(("build", ".")):
            os.symlink(os.path.join(ROOT, entry), os.path.join(tree, entry))
    shutil.copytree(os.path.join(ROOT, "bindings", "python"), os.path.join(bindings, "python"), ignore=LEFT_OUT)
    subprocess.run(WHEEL + ["--wheel-dir", folder, os.path.join(bindings, "python")], check=True,
                   env=without_libraries(ORBICUBE_BUILD="trust_region"))
    wheel, = glob.glob(os.path.join(folder, "*.whl"))
    carried = sorted(name for name in names_in(wheel) if name.startswith("orbicube/lib/"))
    assert carried == ["orbicube/lib/liborbicube-base.so.0", "orbicube/lib/liborbicube-trust-region.so.0"], carried
    program = ("from orbicube import trust_region; "
               "result = trust_region.minimize(lambda x: (x[0] - 3) ** 2 + (x[1] + 1) ** 4, [0.0, 0.0]); "
               "assert abs(result.x[0] - 3) < 1e-4, result.x")
    subprocess.run([sys.executable, "-c", program], check=True, cwd=folder,
                   env=without_libraries(PYTHONPATH=installed(folder, wheel)))


def one_package_in_both_declarations():
    """pyproject.toml in the top folder (Meson, with the command) and bindings/python/pyproject.toml (setuptools)."""
    projects = []
    for folder in (ROOT, os.path.join(ROOT, "bindings", "python")):
        with open(os.path.join(folder, "pyproject.toml"), "rb") as file:
            projects.append({**tomllib.load(file)["project"], "readme": None})
    assert projects[0] == projects[1], projects


def every_module_in_the_file_of_meson():
    """bindings/python/meson.build names the modules that are of no library; the others have the names of libraries."""
    with open(os.path.join(ROOT, "bindings", "python", "meson.build"), encoding="utf-8") as file:
        named = set(re.findall(r"'orbicube/(\w+\.\w+)'", file.read()))
    package = os.path.join(ROOT, "bindings", "python", "orbicube")
    libraries = {name.replace(".pyi", ".py") for name in os.listdir(os.path.join(package, "raw")) if name.endswith(".pyi")}
    there = {name for name in os.listdir(package) if name.endswith((".py", ".typed"))}
    assert named == there - libraries, (named, there - libraries)


def main():
    for needed in ("pip", "setuptools", "wheel"):
        if subprocess.run([sys.executable, "-c", "import " + needed], capture_output=True, check=False).returncode != 0:
            print(f"Python has no {needed}: a wheel cannot be made")
            sys.exit(77)  # what Meson takes for "skipped"
    one_package_in_both_declarations()
    every_module_in_the_file_of_meson()
    for case in (wheel_of_built_libraries, wheel_that_builds_one_library):
        with tempfile.TemporaryDirectory() as folder:
            case(folder)


if __name__ == "__main__":
    main()
