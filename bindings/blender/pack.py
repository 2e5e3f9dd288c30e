#!/usr/bin/env python3
"""Makes the zip file that Blender installs: the add-on with the Python package that it uses.

    pack.py OUT.zip --wheel WHEEL               the package of a wheel of packaging/wheel
    pack.py OUT.zip --libraries FOLDER          the package of this tree, with built libraries (build/capi)
"""

import argparse
import glob
import os
import re
import sys
import zipfile

HERE = os.path.dirname(os.path.abspath(__file__))
ADDON = "orbicube_blender"


def add_folder(archive, folder, under, endings):
    for path, folders, files in sorted(os.walk(folder)):
        folders.sort()
        for file in sorted(files):
            if file.endswith(endings):
                whole = os.path.join(path, file)
                archive.write(whole, os.path.join(under, os.path.relpath(whole, folder)))


def add_wheel(archive, wheel, under):
    """Modules and libraries; the command and its pages stay in the wheel."""
    with zipfile.ZipFile(wheel) as packed:
        for name in packed.namelist():
            # The wheel holds folders of Python's (NAME.data/purelib/...), or what belongs there at its top.
            inside = re.sub(r"^[^/]*\.data/(purelib|platlib)/", "", name)
            if not name.endswith("/") and inside.startswith(("orbicube/", ".orbicube.mesonpy.libs/")):
                archive.writestr(os.path.join(under, inside), packed.read(name))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out")
    source = parser.add_mutually_exclusive_group(required=True)
    source.add_argument("--wheel")
    source.add_argument("--libraries")
    options = parser.parse_args()
    packages = os.path.join(ADDON, "packages")
    with zipfile.ZipFile(options.out, "w", zipfile.ZIP_DEFLATED) as archive:
        add_folder(archive, os.path.join(HERE, ADDON), ADDON, (".py",))
        archive.write(os.path.join(HERE, "..", "..", "LICENSE"), os.path.join(ADDON, "LICENSE"))
        if options.wheel:
            add_wheel(archive, options.wheel, packages)
        else:
            add_folder(archive, os.path.join(HERE, "..", "python", "orbicube"), os.path.join(packages, "orbicube"), (".py",))
            libraries = glob.glob(os.path.join(options.libraries, "liborbicube-*.so.0"))
            for library in sorted(libraries):
                archive.write(library, os.path.join(packages, "orbicube", "lib", os.path.basename(library)))
            if not libraries:
                parser.error(f"{options.libraries} has no libraries")
    return 0


if __name__ == "__main__":
    sys.exit(main())
