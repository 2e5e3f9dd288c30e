#!/usr/bin/env python3
"""The binary interface of the C libraries, recorded for a release and compared with libabigail (Debian: abigail-tools).

    scripts/abi.py            compares the headers with capi/abi/0.1.0/*.abi; fails where a program that was built against the
                              record would break and the soname is the same
    scripts/abi.py --write    records what the headers declare as the release of the version in meson.build

The interface is that of the headers: each is compiled into a library of empty functions, with what a debugger wants to know of
types. That the libraries themselves export these functions and no others is what the tests `symbols of ...` look at. What only
a compiler sees, names and values of constants, is in capi/abi/released.json (scripts/api.py).

Functions may be added, and members at the end of structs that begin with struct_size.
"""

import argparse
import glob
import json
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
RECORDS = os.path.join(ROOT, "capi", "abi")


def version():
    with open(os.path.join(ROOT, "meson.build"), encoding="utf-8") as file:
        return re.search(r"^  version: '([\d.]+)'", file.read(), re.MULTILINE).group(1)


def empty_function(function):
    parameters = []
    for parameter in function["parameters"]:
        kind, name = parameter["type"], parameter["name"]
        lengths = "".join(f"[{length}]" for length in parameter.get("lengths", []))
        parameters.append(f"{kind} {name}{lengths}")
    used = "".join(f"(void){parameter['name']};" for parameter in function["parameters"])
    answer = "" if function["returns"] == "void" else "return 0;"
    return f"{function['returns']} {function['name']}({', '.join(parameters) or 'void'}) {{{used}{answer}}}\n"


def compiled(name, library, folder, include):
    """A shared library with the functions of one header, and its types in debugging information."""
    source, result = os.path.join(folder, name + ".c"), os.path.join(folder, "lib" + name + ".so")
    with open(source, "w", encoding="utf-8") as file:
        file.write(f"#include <orbicube/{name}.h>\n")
        file.writelines(empty_function(function) for function in library["functions"])
    soname = f"liborbicube-{name.replace('_', '-')}.so.{library['soversion']}"
    subprocess.run(["cc", "-std=c99", "-g", "-O0", "-fPIC", "-shared", "-fno-eliminate-unused-debug-types", "-I", include,
                    "-Wl,-soname," + soname, source, "-o", result], check=True)
    return result


def written(name, library, folder, include):
    """The XML that abidw makes of it, without places of this computer."""
    path = os.path.join(folder, name + ".abi")
    subprocess.run(["abidw", "--no-show-locs", "--no-corpus-path", "--no-comp-dir-path", "--no-elf-needed", "--out-file", path,
                    compiled(name, library, folder, include)], check=True)
    with open(path, encoding="utf-8") as file:
        text = file.read()
    with open(path, "w", encoding="utf-8") as file:
        file.write(re.sub(r" path='[^']*/(\w+\.c)'", r" path='\1'", text))
    return path


# What abidiff says of a struct that has grown at its end, line by line, besides the line that names the struct, that of its
# size and those of its new members.
HARMLESS = re.compile(
    r"$|(Functions|Variables) changes summary: 0 Removed|\d+ functions? with some indirect sub-type change|"
    r"\[C\] 'function .*' has some indirect sub-type changes:$|parameter \d+ of type '.*' has sub-type changes:$|"
    r"in pointed to type '.*'( at .*)?:$|in unqualified underlying type '.*'( at .*)?:$|\d+ data member insertions?:$")


def only_grown(text, library):
    """Whether nothing has changed but structs that begin with their size, which have more members at their ends. (abidiff's
    own has_data_member_inserted_at lets members in the middle pass as well.)"""
    names = {struct["name"] for struct in library["structs"] if struct["fields"][0]["name"] == "struct_size"}
    size = None
    for line in (line.strip() for line in text.splitlines()):
        if found := re.match(r"underlying type 'struct (\w+)'.* changed:$", line):
            if found.group(1) not in names:
                return False
        elif found := re.match(r"type size changed from (\d+) to \d+ \(in bits\)$", line):
            size = int(found.group(1))
        elif found := re.match(r"'.*', at offset (\d+) \(in bits\)", line):
            if size is None or int(found.group(1)) < size:
                return False
        elif not HARMLESS.match(line):
            return False
    return True


def differences(old, name, library, folder, include):
    """What abidiff finds that programs trip over; its result has bits: 4 for a change, 8 for what it knows to be incompatible."""
    said = subprocess.run(["abidiff", "--no-added-syms", old, written(name, library, folder, include)], capture_output=True,
                          text=True, check=False)
    if said.returncode == 0 or (said.returncode == 4 and only_grown(said.stdout, library)):
        return None
    return f"{name}: abidiff returns {said.returncode}\n{said.stdout}{said.stderr}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--records", help="the folder of the record, by default capi/abi/VERSION, the newest that is there")
    parser.add_argument("--api", default=os.path.join(ROOT, "api.json"), help="what the headers declare")
    parser.add_argument("--include", default=os.path.join(ROOT, "capi", "include"), help="the folder of the headers")
    arguments = parser.parse_args()
    for tool in ("abidw", "abidiff", "cc"):
        if shutil.which(tool) is None:
            print(f"{tool} is missing (Debian: abigail-tools)")
            sys.exit(77)  # what Meson takes for "skipped"
    if platform.machine() != "x86_64":
        print(f"the record is that of x86-64, this is {platform.machine()}")
        sys.exit(77)
    with open(arguments.api, encoding="utf-8") as file:
        libraries = json.load(file)["libraries"]
    with tempfile.TemporaryDirectory() as folder:
        if arguments.write:
            records = arguments.records or os.path.join(RECORDS, version())
            os.makedirs(records, exist_ok=True)
            for name, library in libraries.items():
                shutil.copy(written(name, library, folder, arguments.include), os.path.join(records, name + ".abi"))
            print(f"wrote {len(libraries)} records to {os.path.relpath(records)}")
            return
        found = sorted(glob.glob(os.path.join(RECORDS, "[0-9]*")), key=lambda path: [int(n) for n in re.findall(r"\d+", os.path.basename(path))])
        records = arguments.records or (found[-1] if found else None)
        if records is None:
            print("nothing is recorded yet")
            sys.exit(77)
        broken = []
        for path in sorted(glob.glob(os.path.join(records, "*.abi"))):
            name = os.path.splitext(os.path.basename(path))[0]
            library = libraries.get(name)
            if library is None:
                broken.append(f"{name}: the library is gone")
                continue
            with open(path, encoding="utf-8") as file:
                soname = re.search(r"soname='([^']*)'", file.read()).group(1)
            if not soname.endswith(".so." + str(library["soversion"])):
                print(f"{name}: another soname, {soname} then")
                continue
            text = differences(path, name, library, folder, arguments.include)
            if text is not None:
                broken.append(text)
        if broken:
            sys.exit("\n".join(broken) + "\nwhat was released may only be added to (CONTRIBUTING.md, Compatibility)")
        print(f"{len(libraries)} libraries are compatible with {os.path.relpath(records)}")


if __name__ == "__main__":
    main()
