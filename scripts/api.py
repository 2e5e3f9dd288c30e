#!/usr/bin/env python3
"""What the C headers declare, for everything that must agree with them.

    scripts/api.py              writes api.json and capi/abi/<library>.map from capi/include/orbicube/*.h, and by
                                scripts/bindings.py what other languages see of them
    scripts/api.py --check      changes nothing; fails when writing would change something
    scripts/api.py --abi-check  fails when the headers changed what capi/abi/released.json records without a new soname
    scripts/api.py --release    records what the headers declare as capi/abi/released.json

Each of them first checks the rules of the C interface that a script can see and lists every breach with file and line.

api.json holds, for each library: header, soversion, uses (libraries whose headers it includes), constants (enumerations:
name, doc, values with name, value and doc), aliases, handles (opaque structs), structs (fields in order), callbacks (function
pointer types) and functions (returns, parameters, doc). A type is C text in one spelling ("const double *"); `lengths` are
those of an array; a field or parameter that is a function pointer has `function` (returns, parameters) in place of `type`.
"""

import argparse
import json
import os
import re
import subprocess
import sys

from c_header import Header, HeaderError

VERSIONED = ("_options", "_result", "_report", "_problem")  # structs that callers and libraries of other ages exchange


def library_of(path):
    return os.path.splitext(os.path.basename(path))[0]


def read_headers(root):
    """name -> Header of every public header; what a header includes is read before it."""
    folder = os.path.join(root, "capi", "include", "orbicube")
    texts = {}
    for name in sorted(os.listdir(folder)):
        if name.endswith(".h"):
            with open(os.path.join(folder, name), encoding="utf-8") as file:
                texts[library_of(name)] = file.read()
    headers = {}

    def read(name, line_of_use):
        if name in headers:
            return
        if name not in texts:
            raise HeaderError(line_of_use, 1, f"includes orbicube/{name}.h, which does not exist")
        path = os.path.join("capi", "include", "orbicube", name + ".h")
        for used in re.findall(r"^[ \t]*#\s*include\s*[<\"]orbicube/(\w+)\.h", texts[name], re.MULTILINE):
            read(used, path)
        headers[name] = Header(path, texts[name], headers)

    for name in texts:
        read(name, name)
    return dict(sorted(headers.items()))


# -- the rules of the C interface --------------------------------------------------------------------------------------

def breaches(name, header, headers):
    """Texts `file:line: what` for each rule that the header does not keep."""
    found = []

    def breach(line, message):
        found.append(f"{header.path}:{line}: {message}")

    values = {s["name"] for h in headers.values() for s in h.structs} | {h["name"] for x in headers.values() for h in x.handles}
    functions = {f["name"] for f in header.functions}

    def check_signature(what, returns, parameters, line, callback):
        for entry in [{"type": returns, "name": "its result"}] + parameters:
            if entry.get("type", "").replace("const ", "") in values:
                breach(line, f"{what}: {entry['name']} is a struct passed by value")
            if "function" in entry:
                check_signature(f"{what}: {entry['name']}", entry["function"]["returns"],
                                entry["function"]["parameters"], line, True)
        errors = [i for i, p in enumerate(parameters) if p.get("type") == "obc_error *"]
        # Callbacks, and functions that are such, have user after it.
        has_user = bool(parameters) and (parameters[-1].get("type"), parameters[-1].get("name")) == ("void *", "user")
        if errors and errors != [len(parameters) - 1 - has_user]:
            breach(line, f"{what}: obc_error * is the last parameter, or stands before user")
        if callback and (not parameters or parameters[-1].get("type") != "void *"):
            breach(line, f"{what}: a callback takes void *user last")

    prefix = "obc_" if name == "base" else f"obc_{name}_"
    for function in header.functions:
        if not function["name"].startswith(prefix):
            breach(function["line"], f"{function['name']} does not start with {prefix}")
        if not function["doc"]:
            breach(function["line"], f"{function['name']} is not documented")
        check_signature(function["name"], function["returns"], function["parameters"], function["line"], False)
    for callback in header.callbacks:
        check_signature(callback["name"], callback["returns"], callback["parameters"], callback["line"], True)
    for struct in header.structs:
        first = struct["fields"][0] if struct["fields"] else {}
        versioned = first.get("name") == "struct_size"
        if struct["name"].endswith(VERSIONED) and not (versioned and first.get("type") == "uint32_t"):
            breach(struct["line"], f"{struct['name']} does not start with uint32_t struct_size")
        if struct["name"].endswith("_options") and struct["name"] + "_init" not in functions:
            breach(struct["line"], f"{struct['name']} has no function {struct['name']}_init")
        for field in struct["fields"]:
            if "function" in field:
                check_signature(f"{struct['name']}.{field['name']}", field["function"]["returns"],
                                field["function"]["parameters"], field["line"], True)
    for handle in header.handles:
        if handle["name"] + "_destroy" not in functions:
            breach(1, f"the handle {handle['name']} has no function {handle['name']}_destroy")
    for entry in header.aliases + header.handles + header.structs + header.callbacks:
        if not entry["name"].startswith("obc_"):
            breach(entry.get("line", 1), f"type {entry['name']} does not start with obc_")
    for enumeration in header.constants:
        for value in enumeration["values"]:
            if not value["name"].startswith("OBC_"):
                breach(value["line"], f"constant {value['name']} does not start with OBC_")
            if not -2**31 <= value["value"] < 2**31:
                breach(value["line"], f"constant {value['name']} does not fit int32_t")
    if functions and f"obc_{name}_version" not in functions:
        breach(1, f"there is no function obc_{name}_version")
    return found


def declared_twice(headers):
    """Names that two headers declare, which then cannot be included together."""
    owner, found = {}, []
    for header in headers.values():
        entries = header.aliases + header.handles + header.structs + header.callbacks + header.functions
        for entry in entries + [value for enumeration in header.constants for value in enumeration["values"]]:
            if entry["name"] in owner:
                found.append(f"{header.path}:{entry.get('line', 1)}: {entry['name']} is declared in {owner[entry['name']]} too")
            owner[entry["name"]] = header.path
    return found


# -- what is generated ---------------------------------------------------------------------------------------------------

def without_lines(value):
    """The same without the places in the header, which change with every edit."""
    if isinstance(value, dict):
        return {key: without_lines(item) for key, item in value.items() if key not in ("line", "last_line")}
    return [without_lines(item) for item in value] if isinstance(value, list) else value


def read_soversion(root):
    with open(os.path.join(root, "capi", "meson.build"), encoding="utf-8") as file:
        return re.search(r"^soversion = '(\w+)'", file.read(), re.MULTILINE).group(1)


def description(headers, soversion):
    libraries = {}
    for name, header in headers.items():
        libraries[name] = without_lines({
            "header": f"orbicube/{name}.h", "soversion": soversion, "uses": header.includes, "constants": header.constants,
            "aliases": header.aliases, "handles": header.handles, "structs": header.structs,
            "callbacks": header.callbacks, "functions": header.functions})
    return {"libraries": libraries}


def version_script(header, soversion):
    names = sorted(function["name"] for function in header.functions)
    exported = "".join(f"    {name};\n" for name in names)
    return f"ORBICUBE_{soversion} {{\n" + (f"  global:\n{exported}" if names else "") + "  local:\n    *;\n};\n"


def as_json(value):
    return json.dumps(value, indent=1, ensure_ascii=False) + "\n"


def generated_files(root, headers):
    """path -> text of everything that follows from the headers."""
    soversion = read_soversion(root)
    files = {os.path.join("capi", "abi", name + ".map"): version_script(header, soversion)
             for name, header in headers.items()}
    files["api.json"] = as_json(description(headers, soversion))
    return files


# -- compatibility with the last release -----------------------------------------------------------------------------------

def shape(entry):
    """What a compiler sees of a declaration: types, not names of parameters nor documentation."""
    if "function" in entry:
        return {"function": shape(entry["function"])}
    if "parameters" in entry:
        return {"returns": entry["returns"], "parameters": [shape(p) for p in entry["parameters"]]}
    return {"type": entry["type"], "lengths": entry.get("lengths", [])}


def incompatible_changes(old, new):
    """Texts for each thing that a program built against `old` (one library of api.json) can trip over with `new`."""
    found = []
    for kind in ("functions", "callbacks", "aliases"):
        current = {entry["name"]: entry for entry in new[kind]}
        for entry in old[kind]:
            if entry["name"] not in current:
                found.append(f"{entry['name']} is gone")
            elif shape(entry) != shape(current[entry["name"]]):
                found.append(f"{entry['name']} has another signature")
    current = {value["name"]: value["value"] for enumeration in new["constants"] for value in enumeration["values"]}
    for value in (value for enumeration in old["constants"] for value in enumeration["values"]):
        if current.get(value["name"]) != value["value"]:
            found.append(f"{value['name']} was {value['value']} and is now {current.get(value['name'], 'gone')}")
    names = {handle["name"] for handle in new["handles"]}
    found += [f"{handle['name']} is gone" for handle in old["handles"] if handle["name"] not in names]
    structs = {struct["name"]: struct["fields"] for struct in new["structs"]}
    for struct in old["structs"]:
        fields = [(field["name"], shape(field)) for field in struct["fields"]]
        now = [(field["name"], shape(field)) for field in structs.get(struct["name"], [])]
        may_grow = fields[0][0] == "struct_size"
        if now[:len(fields)] != fields or (len(now) > len(fields) and not may_grow):
            found.append(f"struct {struct['name']} has another layout")
    return found


def abi_breaches(released, current):
    found = []
    for name, old in released["libraries"].items():
        new = current["libraries"].get(name)
        if new is None:
            found.append(f"{name}: the library is gone")
        elif new["soversion"] == old["soversion"]:
            found += [f"{name}: {change}, and the soname is still {old['soversion']}"
                      for change in incompatible_changes(old, new)]
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--root", default=os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    group = parser.add_mutually_exclusive_group()
    for option in ("--check", "--abi-check", "--release"):
        group.add_argument(option, action="store_true")
    arguments = parser.parse_args()
    root = arguments.root
    try:
        headers = read_headers(root)
    except HeaderError as error:
        sys.exit(str(error))
    problems = [line for name, header in headers.items() for line in breaches(name, header, headers)]
    problems += declared_twice(headers)
    files = generated_files(root, headers)
    record = os.path.join(root, "capi", "abi", "released.json")
    if arguments.release:
        files = {os.path.relpath(record, root): files["api.json"]}
    if arguments.abi_check:
        if not os.path.exists(record):
            print("nothing has been released yet: there is no capi/abi/released.json to compare with")
            sys.exit(77)  # what Meson takes for "skipped"
        with open(record, encoding="utf-8") as file:
            problems += abi_breaches(json.load(file), json.loads(files["api.json"]))
        files = {}
    for path, text in files.items():
        full = os.path.join(root, path)
        old = None
        if os.path.exists(full):
            with open(full, encoding="utf-8") as file:
                old = file.read()
        if old == text:
            continue
        if arguments.check:
            problems.append(f"{path}: not what the headers say; run scripts/api.py")
        elif not problems:
            with open(full, "w", encoding="utf-8") as file:
                file.write(text)
            print(f"wrote {path}")
    if problems:
        sys.exit("\n".join(problems))
    bindings = os.path.join(root, "scripts", "bindings.py")
    if not (arguments.check or arguments.abi_check or arguments.release) and os.path.exists(bindings):
        subprocess.run([sys.executable, bindings, "--root", root], check=True)


if __name__ == "__main__":
    main()
