#!/usr/bin/env python3
"""`--solver petsc` loads the module that belongs to the command, and no other: hostile ones lie on every path that the caller's
surroundings could lead to.

    module_test.py COMMAND MODULE

A hostile module leaves a file where it is loaded. The command is tried where it was built, and copied to a prefix of its own.
"""
import os
import shutil
import subprocess
import sys
import tempfile

COMMAND, MODULE = (os.path.abspath(path) for path in sys.argv[1:3])
HOSTILE = r"""
#include <stdio.h>
#include <stdlib.h>
__attribute__((constructor)) static void loaded(void) { fclose(fopen(MARK, "w")); }
void *orbicube_petsc_start(void) { exit(77); }
"""
SOLID = """MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nTetrahedra\n1\n1 2 3 4 0\nEnd\n"""


def prefix_at(folder, with_module=True):
    """The command and its module as they are installed."""
    os.makedirs(os.path.join(folder, "bin"))
    command = shutil.copy2(COMMAND, os.path.join(folder, "bin"))
    for library in LIBRARY_FOLDERS:
        os.makedirs(os.path.join(folder, library, "orbicube"), exist_ok=True)
        if with_module:
            shutil.copy2(MODULE, os.path.join(folder, library, "orbicube"))
    return command


# Where meson installs modules depends on the system; all that it may be.
LIBRARY_FOLDERS = ["lib", "lib64", "lib/" + os.uname().machine + "-linux-gnu"]

with tempfile.TemporaryDirectory() as top:
    solid, mark, hostile = (os.path.join(top, name) for name in ("solid.mesh", "mark", "hostile.so"))
    with open(solid, "w", encoding="ascii") as file:
        file.write(SOLID)
    with open(os.path.join(top, "hostile.c"), "w", encoding="ascii") as file:
        file.write(HOSTILE.replace("MARK", '"' + mark + '"'))
    subprocess.run(["cc", "-shared", "-fPIC", os.path.join(top, "hostile.c"), "-o", hostile], check=True)

    def surroundings(folder):
        """Hostile modules in a folder under all names and subfolders that were ever looked at."""
        for place in ("", "distributed", "orbicube", "lib/orbicube", "../lib/orbicube"):
            os.makedirs(os.path.join(folder, place), exist_ok=True)
            shutil.copy(hostile, os.path.join(folder, place, "orbicube-petsc.so"))
        with open(os.path.join(folder, ".petscrc"), "w", encoding="ascii") as file:
            file.write(f"-dll_append {hostile}\n")

    here = os.path.join(top, "here", "work")
    surroundings(here)
    prefix = os.path.join(top, "prefix")
    installed = prefix_at(prefix)
    without = prefix_at(os.path.join(top, "without"), with_module=False)
    link = os.path.join(here, "orbi")
    variables = {name: here for name in ("LD_LIBRARY_PATH", "ORBICUBE_MODULES", "ORBICUBE_LIBRARIES", "ORBICUBE_PREFIX", "PWD",
                                         "HOME", "PETSC_DIR", "OMPI_MCA_mca_base_component_path_unused")}
    alone = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")

    def run(words, environment, executable=None):
        out = os.path.join(top, "out.mesh")
        done = subprocess.run([*words, "untangle", solid, "-o", out, "--solver", "petsc"], executable=executable, cwd=here,
                              env=environment, capture_output=True, text=True, timeout=100, check=False)
        assert not os.path.exists(mark), (words, environment, "the hostile module was loaded")
        return done

    for command in (COMMAND, installed):
        if os.path.exists(link):
            os.remove(link)
        os.symlink(command, link)
        for what, words, environment, executable in (
                ("the current folder", [command], alone, None),
                ("variables", [command], {**alone, **variables}, None),
                ("a relative name", [os.path.relpath(command, here)], alone, None),
                ("another name", ["./orbi"], alone, command),
                ("an empty name", [""], alone, command),
                ("a link in a hostile folder", [link], alone, None),
                ("PATH", ["orbi"], {**alone, "PATH": here + ":" + alone["PATH"]}, None)):
            done = run(words, environment, executable)
            assert done.returncode == 0, (what, done.stderr)
    # A command without its module says so, whatever lies around.
    done = run([without], {**alone, **variables})
    assert done.returncode == 2 and "PETSc" in done.stderr, (done.returncode, done.stderr)
    # A module that all users can write is refused, and so is one of another user.
    for library in LIBRARY_FOLDERS:
        os.chmod(os.path.join(prefix, library, "orbicube", "orbicube-petsc.so"), 0o777)
    done = run([installed], alone)
    assert done.returncode == 2 and "written by all users" in done.stderr, (done.returncode, done.stderr)
    # PETSc itself is not instructed to load anything.
    done = run([COMMAND], {**alone, "PETSC_OPTIONS": f"-dll_append {hostile}"})
    assert done.returncode != 0 and "-dll_append" in done.stderr, (done.returncode, done.stderr)
print("ok")
