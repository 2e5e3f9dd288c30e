#!/usr/bin/env python3
"""Installs into a staging folder as a distribution does, and runs the examples of all languages against it by
scripts/examples, as the README says.

    examples_test.py BUILD
"""

import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def main():
    with tempfile.TemporaryDirectory() as folder:
        staging = os.path.join(folder, "staging")
        subprocess.run(["meson", "install", "-C", sys.argv[1], "--no-rebuild", "--quiet", "--destdir", staging], check=True)
        packages = [path for path, _, _ in os.walk(staging) if os.path.basename(path) == "pkgconfig"][0]
        libraries = os.path.dirname(packages)
        # A library that another one needs is looked for where the linker looks, since it is not where the system looks.
        environment = dict(os.environ, PKG_CONFIG_LIBDIR=packages, PKG_CONFIG_SYSROOT_DIR=staging, LIBRARY_PATH=libraries,
                           LD_LIBRARY_PATH=libraries, LDFLAGS="-Wl,-rpath-link," + libraries, ORBICUBE_LIBRARIES=libraries)
        done = subprocess.run([os.path.join(ROOT, "scripts", "examples")], env=environment, stdout=subprocess.PIPE, text=True,
                              check=False)
    print(done.stdout)
    assert done.returncode == 0 and done.stdout.count(": ran\n") >= 4, done.returncode


if __name__ == "__main__":
    main()
