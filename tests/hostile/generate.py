#!/usr/bin/env python3
"""Writes the table of hostile calls from api.json: every C function, with each parameter drawn by its kind.

    generate.py API.json OUT.cpp LIBRARY...

Kinds follow from types and from names that the headers use everywhere (see kind_of_parameter). A function with a parameter
of no known kind ends the build, so that a new function is either covered or refused here.
"""

import json
import re
import sys

INTEGERS = {"size_t", "uint64_t", "uint32_t", "int32_t", "int64_t", "uint8_t", "int8_t"}
NUMBERS = INTEGERS | {"double", "float"}
# Integers that are lengths of arrays. All other integers are wishes, choices or numbers of things, which may have any value.
COUNT = re.compile(r"(.*_)?(count|size|degree)|n|m|residuals|capacity|channels|columns|components|dimension|resolution")
CORNERS = {"triangles": 3, "tetrahedra": 4, "hexahedra": 8}
TEXTS = {"path": "path", "folder": "path", "shape": "shape", "name": "text", "extras": "text", "morph_target": "text"}
# Outputs of callbacks with as many entries as the callback's own counts say; of all others, one entry is written.
FULL_OUTPUTS = {"gradient", "x"}


class Unknown(Exception):
    pass


class Api:
    def __init__(self, description, selected):
        self.libraries = {name: library for name, library in description["libraries"].items() if name in selected}
        everything = self.libraries.values()
        self.structs = {s["name"]: s for library in everything for s in library["structs"]}
        self.handles = {h["name"] for library in everything for h in library["handles"]}
        self.callbacks = {c["name"]: c for library in everything for c in library["callbacks"]}
        self.functions = [f for library in everything for f in library["functions"]]
        self.names = {f["name"] for f in self.functions}

    def versioned(self, struct):
        return self.structs[struct]["fields"][0]["name"] == "struct_size"


def split(kind):
    """The base of a pointer type, whether it is const, and the number of stars."""
    stars = kind.count("*")
    base = re.sub(r"\bconst\b|\*", "", kind).strip()
    return base, kind.startswith("const "), stars


def shape_part(name, others):
    """What a member is of the small mesh that the call works on, where vertices and their number stand side by side."""
    if "vertex_count" not in others:
        return None
    if name == "positions":
        return "c.positions<{t}>()"
    if name in CORNERS:
        return f"c.cells({CORNERS[name]})"
    if name == "vertex_count":
        return "c.vertex_count()"
    match = re.fullmatch(r"(triangle|tetrahedron|hexahedron)_count", name)
    if match:
        corners = {"triangle": 3, "tetrahedron": 4, "hexahedron": 8}[match.group(1)]
        return f"c.cell_count({corners})"
    return None


def array_of_structs(api, index, entries):
    """A struct or handle pointer that the following count makes an array: `surfaces, count`, `morph_targets, morph_target_count`."""
    name = entries[index]["name"]
    following = entries[index + 1]["name"] if index + 1 < len(entries) else ""
    return name.endswith("s") and following in ("count", name[:-1] + "_count")


def value_of(api, index, entries, where, library):
    """A C++ expression that draws the parameter or field entries[index]."""
    entry = entries[index]
    name, kind = entry["name"], entry.get("type")
    others = {e["name"] for e in entries}
    if kind is None:
        raise Unknown(f"{where}: {name} is a function pointer without a name")
    base, const, stars = split(kind)
    part = shape_part(name, others)
    if stars == 0 and "lengths" not in entry:
        if base in api.callbacks:
            return f"c.optional(&answer_{base})"
        if base == "obc_status":
            return "c.wish<int32_t>()"
        if part is not None:
            return part
        if base in INTEGERS:
            return f"c.count<{base}>(\"{name}\")" if COUNT.fullmatch(name) else f"c.wish<{base}>()"
        if base in ("double", "float"):
            return f"static_cast<{base}>(c.number())"
        raise Unknown(f"{where}: {name} is a {kind}")
    if stars == 0:
        return f"c.output<{base}>()"
    if base == "obc_error":
        return "c.error()"
    if base == "obc_host" and const:
        return "c.host()"
    if base == "char" and stars == 1 and const:
        if name not in TEXTS:
            raise Unknown(f"{where}: {name} is a text of unknown meaning")
        return f"c.path(\"{library}\")" if TEXTS[name] == "path" else f"c.{TEXTS[name]}()"
    if base == "void" and stars == 1:
        if name == "user" or name.endswith("_user"):
            return "static_cast<void*>(nullptr)"  # kept by handles: callbacks belong to the current call
        return "c.bytes()" if const else "c.output<char>()"
    if base in api.handles:
        if stars == 1:
            return f"c.handle<{base}>()"
        if stars == 2 and "const *" in kind:
            return f"c.handles<{base}>()"
        if stars == 2 and not const:
            return f"c.handle_out<{base}>()"
    if base in api.structs:
        if stars != 1:
            raise Unknown(f"{where}: {name} is a {kind}")
        if const and array_of_structs(api, index, entries):
            return f"c.structs<{base}>([](Call& d, {base}& t) {{ fill(d, t); }})"
        init = f"{base}_init" if f"{base}_init" in api.names else "nullptr"
        sized = "true" if api.versioned(base) else "false"
        if const:
            # A saved run is only loaded for the problem that it is of.
            draw = "problem" if base.endswith(("_problem", "_blocks")) and where.endswith(("_create", "_load")) else "given"
            return f"c.{draw}<{base}>({init}, {sized}, [](Call& d, {base}& t) {{ fill(d, t); }})"
        if "struct_size" in others:
            return f"c.uninitialized<{base}>()"
        return f"c.result<{base}>({init}, {sized})"
    if base in NUMBERS:
        if stars == 2 and const:
            return f"c.shown<{base}>()"
        if stars == 1 and const:
            return part.format(t=base) if part else f"c.input<{base}>(\"{name}\")"
        if stars == 1:
            return "c.cells_in_place(3)" if name == "triangles" and "vertex_count" in others else f"c.output<{base}>()"
    raise Unknown(f"{where}: {name} is a {kind}")


def fill_function(api, struct, library):
    lines, name = [], struct["name"]
    fields = struct["fields"]
    for i, field in enumerate(fields):
        base, _, stars = split(field.get("type", ""))
        member = f"s.{field['name']}"
        if field["name"] == "struct_size":
            continue
        if "lengths" in field:
            lines.append(f"  if (c.changes()) {member}[0] = static_cast<{base}>({'c.number()' if base in ('double', 'float') else 'c.wish<int32_t>()'});")
            continue
        value = value_of(api, i, fields, name, library)
        # Most programs give few of the arrays and callbacks that they could give.
        if (stars == 1 or base in api.callbacks) and base in NUMBERS | set(api.callbacks) and "positions" not in value and "cells" not in value:
            if api.versioned(name) or "or NULL" in field["doc"]:
                value = f"c.spared() ? nullptr : {value}"
        if field["name"] == "texture_size":
            value = "c.bytes_size()"
        plain = stars == 0 and base in NUMBERS and not COUNT.fullmatch(field["name"]) and "vertex_count()" not in value
        # Numbers keep their defaults most of the time, arrays and their lengths are always drawn.
        lines.append(f"  if (c.changes()) {member} = {value};" if plain and api.versioned(name) else f"  {member} = {value};")
    body = "\n".join(lines)
    return f"[[maybe_unused]] void fill(Call& c, {name}& s) {{\n  static_cast<void>(c), static_cast<void>(s);\n{body}\n}}\n"


def callback_function(callback):
    """A callback that writes what it should, or what it should not, and answers anything."""
    parameters, name = callback["parameters"], callback["name"]
    counts = [p["name"] for p in parameters if p.get("type") == "size_t" and COUNT.fullmatch(p["name"])]
    declared = ", ".join(f"{p['type']} {p['name']}".replace("* ", "*") if "type" in p else "FUNCTION" for p in parameters)
    if "FUNCTION" in declared:
        return ""  # obc_parallel_for_function, which the host of the driver has
    lines = ["  static_cast<void>(user);", "  Call& c = Call::at_hand();", "  c.enter_callback();"]
    inputs = [p for p in parameters if p["type"] == "const double *"]
    for p in parameters:
        base, const, stars = split(p["type"])
        if p["name"] == "user":
            continue
        if stars == 1 and not const and base == "double":
            length = " * ".join(counts) if p["name"] in FULL_OUTPUTS and counts else "1"
            source = f"{inputs[0]['name']}, {' * '.join(counts) or '1'}" if inputs else "nullptr, 0"
            lines.append(f"  c.write_answer({p['name']}, {length}, {source});")
        else:
            lines.append(f"  static_cast<void>({p['name']});")
    lines.append("  return c.answer();" if callback["returns"] != "void" else "")
    return f"[[maybe_unused]] {callback['returns']} answer_{name}({declared}) {{\n" + "\n".join(lines) + "\n}\n"


def call_function(api, function, library):
    parameters, name = function["parameters"], function["name"]
    lines, arguments = [], []
    for i, parameter in enumerate(parameters):
        value = value_of(api, i, parameters, name, library)
        if name.endswith("_destroy"):
            value = value.replace("c.handle<", "c.take_handle<")
        if name.endswith("_load") and parameter["name"] in ("blob", "size"):
            value = f"c.saved_{parameter['name']}(\"{name[:-len('_load')]}\")"
        if name.endswith("_save") and parameter["name"] == "capacity":
            value = f"c.capacity({name}_size(arg0))"
        if name == "obc_mesh_read_memory" and parameter["name"] == "size":
            value = "c.bytes_size()"
        if parameter["name"] == "size" and name.endswith("_memory"):
            value = "c.bytes_size()"
        lines.append(f"  const auto arg{i} = {value};")
        arguments.append(f"arg{i}")
    call = f"{name}({', '.join(arguments)})"
    # The clock runs while the library works, not while arguments are drawn.
    returns = function["returns"]
    if returns == "void":
        lines.append(f"  c.start();\n  {call};\n  c.end();")
    elif returns == "obc_status":
        reported = any(p.get("type") == "obc_error *" for p in parameters)
        lines.append(f"  c.start();\n  const obc_status status = {call};\n  c.end();")
        lines.append(f"  c.check(status, {'true' if reported else 'false'});")
        if name.endswith("_save"):
            lines.append(f"  if (status == OBC_OK) c.keep(\"{name[:-len('_save')]}\", arg1, {name}_size(arg0));")
    elif returns == "const char *":
        lines.append(f"  c.start();\n  const char* text = {call};\n  c.end();\n  c.look_at(text);")
    elif returns in NUMBERS:
        lines.append(f"  c.start();\n  const volatile auto result = {call};\n  c.end();\n  static_cast<void>(result);")
    else:
        raise Unknown(f"{name} returns {returns}")
    return f"void call_{name}(Call& c) {{\n  static_cast<void>(c);\n" + "\n".join(lines) + "\n}\n"


def main():
    source, target, *selected = sys.argv[1:]
    with open(source, encoding="utf-8") as file:
        description = json.load(file)
    api = Api(description, selected)
    text = ["// Written by tests/hostile/generate.py.", '#include "call.h"']
    text += [f"#include <{library['header']}>" for library in api.libraries.values()]
    text += ["", "using hostile::Call;", "", "namespace {", ""]
    try:
        text += [callback_function(c) for c in api.callbacks.values()]
        # Only structs that callers fill; declared first, since structs hold arrays of others.
        skipped = {"obc_error", "obc_host", "obc_allocator"}
        filled = [(s, name) for name, library in api.libraries.items() for s in library["structs"] if s["name"] not in skipped]
        text += [f"void fill(Call& c, {s['name']}& s);" for s, _ in filled] + [""]
        text += [fill_function(api, s, name) for s, name in filled]
        text += [call_function(api, f, name) for name, library in api.libraries.items() for f in library["functions"]]
    except Unknown as unknown:
        sys.exit(f"tests/hostile/generate.py: no kind for {unknown}")
    text += ["}  // namespace", "", "namespace hostile {", "const std::vector<Function>& functions() {",
             "  static const auto& all = *new std::vector<Function>{"]
    for function in api.functions:
        cancels = any(p.get("type") == "const obc_host *" for p in function["parameters"])
        text.append(f"      {{\"{function['name']}\", call_{function['name']}, {'true' if cancels else 'false'}}},")
    text += ["  };", "  return all;", "}", "", "void release_handles() {"]
    # Handles are released in an order of their own; they do not depend on each other.
    text += [f"  for ({name}* handle : Call::pool<{name}>()) {name}_destroy(handle);\n  Call::pool<{name}>().clear();"
             for name in sorted(api.handles)]
    text += ["}", "}  // namespace hostile", ""]
    with open(target, "w", encoding="utf-8") as file:
        file.write("\n".join(text))


if __name__ == "__main__":
    main()
