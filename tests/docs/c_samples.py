#!/usr/bin/env python3
"""The C of all pages: programs are compiled and run, lists of functions compared with api.json, and what is between compiled
within a function that declares the names it uses.

    c_samples.py LIBRARIES
"""

import glob
import json
import os
import re
import subprocess
import sys
import tempfile

from samples import ROOT, blocks, pages

STRICT = ["cc", "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-I", os.path.join(ROOT, "capi", "include")]
# What the pieces take for granted: of each page the names that it uses and does not declare.
COMMON = "obc_error error; "
ARRAYS = "double *positions = 0; uint32_t *triangles = 0, *tetrahedra = 0; size_t vertex_count = 0, triangle_count = 0, tetrahedron_count = 0; "
NAMES = {
    "frame_field": ARRAYS + "double *frames = 0; ",
    "gltf": "float *moved = 0; obc_gltf_surface *surface; obc_gltf_scene scene; obc_gltf_read_options options; ",
    "harmonics": ARRAYS + "double *areas = 0, *directions = 0, *coefficients = 0; ",
    "hexmesh": "obc_surface surface = {0, 0, 0, 0}; ",
    "correspondence": "obc_surface surfaces[2] = {{0}}; double *positions = 0; ",
    "linear": "double *b = 0, *x = 0; obc_linear_matrix matrix = {0}; ",
    "mesh": ARRAYS,
    "projected_gradient": "double lower[2], x0[2], best[2], gradient[2]; const double *x; obc_projected_gradient *solver; int32_t request; "
                          "obc_projected_gradient_result result; result.struct_size = sizeof result; ",
    "quaternion": "double from[4], next[4]; ",
    "sphere_map": ARRAYS + "double *directions = 0; ",
    "sphere_map_uses": ARRAYS + "double *map = 0, *directions = 0, *points = 0; size_t count = 0; obc_mesh *mesh; "
                                "obc_surface surface = {positions, vertex_count, triangles, triangle_count}; ",
    "sphere_optimizer": "size_t count = 1; double x0[3], best[3], gradient[3]; const double *x; obc_sphere_optimizer *solver; int32_t request; "
                        "obc_sphere_optimizer_result result; result.struct_size = sizeof result; ",
    "tetrahedra": ARRAYS,
    "untangle": "double *positions = 0; uint32_t *tetrahedra = 0; uint8_t *fixed = 0; size_t n = 0, m = 0; ",
    "volume_map": "double *positions = 0; uint32_t *tetrahedra = 0; size_t n = 0, m = 0; ",
}
QUIET = ["-Wno-unused-variable", "-Wno-unused-but-set-variable", "-Wno-maybe-uninitialized", "-Wno-uninitialized", "-Wno-unused-parameter",
         "-Wno-unused-function", "-Wno-unused-but-set-parameter", "-fsyntax-only"]


def compiled(text, folder, *options):
    source = os.path.join(folder, "sample.c")
    with open(source, "w", encoding="utf-8") as file:
        file.write(text)
    subprocess.run([*STRICT, source, *options], check=True)


def functions_of_list(text, where, api):
    """Declarations of C, or of names of parameters only; comments and `...` say what is left out."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    found = list(re.finditer(r"([\w ]+?[ *]+)(obc_\w+)\(([^()]*)\);", text))
    left = text
    for one in found:
        left = left.replace(one.group(0), "", 1)
    if left.strip():
        sys.exit(f"{where}: not understood: {left.strip()[:80]}")
    for one in found:
        returns, name, parameters = " ".join(one.group(1).split()), one.group(2), one.group(3)
        function = api.get(name)
        if function is None:
            sys.exit(f"{where}: there is no {name}")
        if returns.replace(" *", "*") != function["returns"].replace(" *", "*"):
            sys.exit(f"{where}: {name} answers {function['returns']}, not {returns}")
        names = [re.search(r"(\w+)(\[\d*\])?$", part.strip()).group(1) if part.strip() not in ("...", "void", "") else part.strip()
                 for part in parameters.split(",")]
        wanted = [parameter["name"] for parameter in function["parameters"]]
        if names[-1] == "...":
            names, wanted = names[:-1], wanted[:len(names) - 1]
        if [part for part in names if part not in ("void", "")] != wanted:
            sys.exit(f"{where}: {name} takes {', '.join(wanted)}, not {', '.join(names)}")
    return len(found)


def main():
    libraries = os.path.abspath(sys.argv[1])
    with open(os.path.join(ROOT, "api.json"), encoding="utf-8") as file:
        api = {function["name"]: function for library in json.load(file)["libraries"].values() for function in library["functions"]}
    shared = sorted(glob.glob(os.path.join(libraries, "liborbicube-*.so")))
    programs = listed = pieces = 0
    with tempfile.TemporaryDirectory() as folder:
        for page in pages():
            name = os.path.splitext(os.path.basename(page))[0]
            for line, text in blocks(page, "c"):
                where = f"{os.path.basename(page)}:{line}"
                print(where, flush=True)
                if "int main" in text:
                    executable = os.path.join(folder, "sample")
                    compiled(text, folder, "-o", executable, *shared, "-Wl,-rpath," + libraries, "-lm")
                    subprocess.run([executable], check=True, cwd=folder)
                    programs += 1
                elif re.match(r"(const )?\w+ [ *]*obc_\w+\([\w, *.\[\]\n]*\);", text):
                    listed += functions_of_list(text, where, api)
                else:
                    includes = "".join(re.findall(r"#include.*\n", text))
                    body = re.sub(r"#include.*\n", "", text)
                    header = f"#include <orbicube/{name if os.path.exists(os.path.join(STRICT[-1], 'orbicube', name + '.h')) else 'sphere_map'}.h>\n"
                    value = "static double value_at(const double *x, double *gradient) { return gradient[0] = x[0]; }\n"
                    compiled(f"#include <stdio.h>\n#include <stdlib.h>\n{header}{includes}{value}"
                             f"int f(void);\nint f(void) {{ {COMMON}{NAMES.get(name, '')}\n{{ {body} }}\nreturn 0; }}\n", folder, *QUIET)
                    pieces += 1
    print(f"{programs} programs ran, {listed} functions are as they are listed, {pieces} pieces compile")
    if not (programs and listed and pieces):
        sys.exit("some kind of sample was not found")


if __name__ == "__main__":
    main()
