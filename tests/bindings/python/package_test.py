"""pip makes a wheel that carries the libraries, for any Python 3, and what it installs works without the tree."""

import glob
import os
import shutil
import subprocess
import sys
import tempfile
import zipfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))


def main():
    for needed in ("pip", "setuptools", "wheel"):
        if subprocess.run([sys.executable, "-c", "import " + needed], capture_output=True, check=False).returncode != 0:
            print(f"Python has no {needed}: a wheel cannot be made")
            sys.exit(77)  # what Meson takes for "skipped"
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, "source")
        shutil.copytree(os.path.join(ROOT, "bindings", "python"), source,
                        ignore=shutil.ignore_patterns("build", "*.egg-info", "__pycache__"))
        pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--quiet"]
        subprocess.run(pip + ["wheel", "--no-deps", "--no-build-isolation", "--no-index", "--wheel-dir", folder, source],
                       check=True)
        wheels = glob.glob(os.path.join(folder, "*.whl"))
        assert len(wheels) == 1 and "-py3-none-" in wheels[0] and "any" not in wheels[0], wheels
        with zipfile.ZipFile(wheels[0]) as wheel:
            names = wheel.namelist()
        assert "orbicube/lib/liborbicube-trust-region.so.0" in names, names
        assert "orbicube/py.typed" in names and "orbicube/raw/mesh.pyi" in names, names
        assert not [name for name in names if "tetrahedra.so" in name], "TetGen binds its users: not in the wheel"
        target = os.path.join(folder, "installed")
        subprocess.run(pip + ["install", "--no-deps", "--no-index", "--target", target, wheels[0]], check=True)
        environment = {name: value for name, value in os.environ.items() if name != "ORBICUBE_LIBRARIES"}
        program = ("import orbicube, os; from orbicube import mesh, sphere_map; "
                   "print(os.path.dirname(orbicube.__file__)); "
                   "assert sphere_map.compute(mesh.make('sphere', 200)).report.bijective; "
                   "maps = open('/proc/self/maps').read(); assert maps.count('installed/orbicube/lib/liborbicube') > 2")
        said = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, text=True, cwd=folder,
                              env={**environment, "PYTHONPATH": target}).stdout
        assert said.strip() == os.path.join(target, "orbicube"), said


if __name__ == "__main__":
    main()
