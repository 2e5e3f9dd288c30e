#!/usr/bin/env python3
"""Builds and installs one library alone, then uses it as a program elsewhere would: found by pkg-config, from C and C++.

    consume.py --library NAME --uses A,B --folder BUILD [--kind both|shared|static]

Checks that the build says no warning, that nothing but the library and those that it uses is installed, that the installed
files name no build folder, that each library can be loaded by its path alone, and that examples/c/NAME.c, compiled as C99 against the shared and against the static libraries,
runs and prints the same, and that its header works from C++.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def run(command, **options):
    done = subprocess.run(command, capture_output=True, text=True, check=False, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\nanswered {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done.stdout + done.stderr


def installed_files(prefix):
    return {os.path.relpath(os.path.join(folder, name), prefix) for folder, _, names in os.walk(prefix) for name in names}


def expected_files(libraries, kind, version):
    expected = {"lib/cmake/orbicube/orbicube-config.cmake", "lib/cmake/orbicube/orbicube-config-version.cmake"}
    for library in libraries:
        dashed = "orbicube-" + library.replace("_", "-")
        expected |= {f"include/orbicube/{library}.h", f"include/orbicube/{library}.hpp", f"lib/pkgconfig/{dashed}.pc",
                     f"lib/cmake/orbicube/orbicube-{library}.cmake"}
        if kind != "static":
            expected |= {f"lib/lib{dashed}.so{end}" for end in ("", ".0", "." + version)}
        if kind != "shared":
            expected.add(f"lib/lib{dashed}.a")
    return expected


def check_installed(prefix, folder):
    """Installed shared libraries look for others in their own folder only, and no pkg-config file names the build folder."""
    for name in sorted(installed_files(prefix)):
        path = os.path.join(prefix, name)
        if ".so." in name:
            searched = re.findall(r"\((R(?:UN)?PATH)\).*\[(.*)\]", run(["readelf", "-dW", path]))
            if searched != [("RUNPATH", "$ORIGIN")]:
                sys.exit(f"{name} looks for libraries in {searched}")
        if name.endswith((".pc", ".cmake")):
            with open(path, encoding="utf-8") as file:
                text = file.read().replace(prefix, "")
            if folder in text or ROOT in text:
                sys.exit(f"{name} names a folder of the build:\n{text}")


def check_loads_alone(prefix, folder):
    """Each library is loaded by its path, as languages with a foreign-function interface do, also where the prefix was moved to."""
    moved = os.path.join(folder, "moved")
    os.rename(prefix, moved)
    environment = {key: value for key, value in os.environ.items() if key != "LD_LIBRARY_PATH"}
    for file in sorted(os.listdir(os.path.join(moved, "lib"))):
        if ".so" in file:
            path = os.path.join(moved, "lib", file)
            run([sys.executable, "-c", "import ctypes, os, sys; ctypes.CDLL(sys.argv[1], mode=os.RTLD_NOW)", path],
                env=environment, cwd="/")
    os.rename(moved, prefix)


def compiled_and_run(compiler, source, prefix, name, static, output):
    environment = dict(os.environ, PKG_CONFIG_LIBDIR=os.path.join(prefix, "lib", "pkgconfig"))
    # What the system has (header-only libraries that a .pc file might require) must not be needed by the shared library.
    flags = run(["pkg-config", "--cflags", "--libs"] + (["--static"] if static else []) + [name], env=environment).split()
    run(compiler + ["-Wall", "-Wextra", "-Werror", source, "-o", output] + flags + ["-lm"])
    needed = run(["readelf", "-dW", output])
    if static == ("liborbicube-" in needed):
        sys.exit(f"{output} is linked to the wrong kind of library:\n{needed}")
    with open(output + ".out", "w", encoding="utf-8") as file:
        text = run([output], env=dict(os.environ, LD_LIBRARY_PATH=os.path.join(prefix, "lib")), cwd=os.path.dirname(output))
        file.write(text)
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--library", required=True)
    parser.add_argument("--uses", default="", help="the libraries that it uses, with commas")
    parser.add_argument("--folder", required=True, help="where to build; emptied first")
    parser.add_argument("--kind", default="both", choices=["both", "shared", "static"])
    parser.add_argument("--unity", default="off", choices=["on", "off", "subprojects"],
                        help="compile several files of a library as one")
    parser.add_argument("--version", required=True)
    arguments = parser.parse_args()
    folder = os.path.abspath(arguments.folder)
    shutil.rmtree(folder, ignore_errors=True)
    prefix, build = os.path.join(folder, "prefix"), folder

    said = run(["meson", "setup", build, ROOT, "--prefix", prefix, "--libdir", "lib",
                "-Dlibraries=" + arguments.library, "-Ddefault_library=" + arguments.kind, "-Dtests=false",
                "-Dexamples=false", "-Dcli=disabled", "-Dwerror=true", "-Dunity=" + arguments.unity])
    said += run(["ninja", "-C", build, "-j1"])
    warnings = [line for line in said.splitlines() if "warning:" in line.lower()]
    if warnings:
        sys.exit("the build warns:\n" + "\n".join(warnings))
    run(["meson", "install", "-C", build, "--no-rebuild"])

    libraries = [name for name in arguments.uses.split(",") if name] + [arguments.library]
    installed, expected = installed_files(prefix), expected_files(libraries, arguments.kind, arguments.version)
    if installed != expected:
        sys.exit(f"installed but not expected: {sorted(installed - expected)}\n"
                 f"expected but not installed: {sorted(expected - installed)}")
    check_installed(prefix, build)
    if arguments.kind != "static":
        check_loads_alone(prefix, folder)

    example = os.path.join(ROOT, "examples", "c", arguments.library + ".c")
    name = "orbicube-" + arguments.library.replace("_", "-")
    cpp = os.path.join(folder, "use.cpp")
    with open(cpp, "w", encoding="utf-8") as file:
        file.write(f"#include <orbicube/{arguments.library}.hpp>\n"
                   f"int main() {{ return obc_{arguments.library}_version() > 0 ? 0 : 1; }}\n")
    printed = {}
    for static in (False, True):
        if arguments.kind == ("shared" if static else "static"):
            continue
        if static:  # a prefix without the shared libraries, which the linker would prefer
            for file in installed_files(prefix):
                if ".so" in os.path.basename(file):
                    os.remove(os.path.join(prefix, file))
        kind = "static" if static else "shared"
        printed[kind] = compiled_and_run(["cc", "-std=c99", "-pedantic"], example, prefix, name, static,
                                         os.path.join(folder, kind + "-c"))
        compiled_and_run(["c++", "-std=c++17", "-pedantic"], cpp, prefix, name, static, os.path.join(folder, kind + "-cpp"))
    if not all(printed.values()) or len(set(printed.values())) != 1:
        sys.exit(f"the example does not print the same with shared and static libraries: {printed}")


if __name__ == "__main__":
    main()
