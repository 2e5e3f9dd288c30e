"""Puts the shared libraries into the package. They are those of the folder named by ORBICUBE_LIBRARIES, or else built by
Meson from the tree that this folder lies in: all, or those that ORBICUBE_BUILD lists (trust_region,mesh) with what they
use. Without either the package has none, and uses those that are installed. Where Meson or ninja are not installed, pip fetches
them for the build alone.

TetGen's license, the AGPL 3, binds those who link it: the library `tetrahedra` is only put in with ORBICUBE_TETGEN=1.
"""

import glob
import os
import shutil
import subprocess
import sys

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:
    from wheel.bdist_wheel import bdist_wheel

HERE = os.path.dirname(os.path.abspath(__file__))
TREE = os.path.dirname(os.path.dirname(HERE))


def built_libraries(folder):
    """The folder with the libraries, made in `folder` if it must be."""
    named = os.environ.get("ORBICUBE_LIBRARIES")
    if named:
        return named.split(os.pathsep)[0]
    if not builds_libraries():
        return None
    build = os.path.join(folder, "orbicube-libraries")
    if not os.path.exists(os.path.join(build, "build.ninja")):
        options = ["--prefix", os.path.join(build, "prefix"), "--libdir", "lib", "-Dtests=false", "-Dexamples=false",
                   "-Dcli=disabled", "-Ddefault_library=shared"]
        if not with_tetgen():
            options.append("-Dtetgen=disabled")
        if os.environ.get("ORBICUBE_BUILD"):
            options.append("-Dlibraries=" + os.environ["ORBICUBE_BUILD"])
        run(["meson", "setup", build, TREE] + options)
    run(["ninja", "-C", build])
    run(["meson", "install", "-C", build, "--no-rebuild", "--quiet"])
    return os.path.join(build, "prefix", "lib")


def run(command):
    if shutil.which(command[0]) is None:
        sys.exit(f"orbicube: {command[0]} is needed to build the libraries, and is not on the path. Install it (pip install {command[0]}), "
                 "let pip build without --no-build-isolation, or name a folder of built libraries by ORBICUBE_LIBRARIES")
    subprocess.run(command, check=True)


def tools_to_fetch():
    """Those of the build that are missing, which pip puts on the path of an isolated build."""
    if os.environ.get("ORBICUBE_LIBRARIES") or not builds_libraries():
        return []
    return [tool for tool in ("meson", "ninja") if shutil.which(tool) is None]


def builds_libraries():
    return os.path.exists(os.path.join(TREE, "capi", "meson.build"))


def with_tetgen():
    return os.environ.get("ORBICUBE_TETGEN") == "1"


def make_viewer(target):
    """The page that shows meshes, where the tree is there that it is made of."""
    pages = os.path.join(TREE, "cli", "view_page")
    if not os.path.isdir(pages):
        return
    with open(os.path.join(pages, "parts.txt"), encoding="utf-8") as file:
        parts = [os.path.join(pages, line) for line in file.read().split()]
    embed = os.path.join(TREE, "cli", "report_page", "embed.py")
    subprocess.run([sys.executable, embed, os.path.join(target, "viewer.html"), "-", *parts], check=True)


class WithLibraries(build_py):
    def run(self):
        super().run()
        make_viewer(os.path.join(self.build_lib, "orbicube"))
        source = built_libraries(os.path.abspath(self.get_finalized_command("build").build_temp))
        if source is None:
            return
        target = os.path.join(self.build_lib, "orbicube", "lib")
        os.makedirs(target, exist_ok=True)
        for path in glob.glob(os.path.join(source, "liborbicube-*.so.0")):
            if with_tetgen() or "tetrahedra" not in path:
                shutil.copy(os.path.realpath(path), os.path.join(target, os.path.basename(path)))


class OfThisPlatform(Distribution):
    def has_ext_modules(self):
        return True


class AnyPython(bdist_wheel):
    """For any Python 3 on this platform: nothing is compiled against it."""

    def get_tag(self):
        return ("py3", "none", super().get_tag()[2])


setup(distclass=OfThisPlatform, cmdclass={"build_py": WithLibraries, "bdist_wheel": AnyPython},
      setup_requires=tools_to_fetch())
