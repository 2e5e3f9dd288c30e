"""The options of the C structs as typed arguments of Python: a table that the package reads, and the signatures.

A function of bindings/python/orbicube/*.py that takes options has between its parameters

    # options of obc_sphere_map_options, written by scripts/bindings.py
    # end of options

(or `# options of STRUCT: a, b, written by ...` for some of them only), and what lies between is written here. Defaults are
those that the libraries fill in, recorded in defaults.json by `scripts/bindings.py --defaults FOLDER`; an option that is not
recorded is None, which stands for the library's own.
"""

import glob
import json
import os
import re
import sys
import types
from ctypes import byref, sizeof
from importlib import import_module

FOLDER = "bindings/python/orbicube/"
HERE = os.path.dirname(os.path.abspath(__file__))
DEFAULTS = os.path.join(HERE, "defaults.json")
HEAD = ('"""The options of the C structs: kind, default, range or words, and what the headers say. Written by '
        'scripts/bindings.py; not\nto be edited."""\n\nfrom __future__ import annotations\n\nfrom ._option import Option\n\n')
REGION = re.compile(r"^( *)# options of (\w+)(?:: ([\w, ]+?))?, written by scripts/bindings\.py\n(.*?)^ *# end of options\n",
                    re.MULTILINE | re.DOTALL)
WIDTH = 125
INTEGERS = {"int32_t": (-2**31, 2**31 - 1), "uint32_t": (0, 2**32 - 1), "uint64_t": (0, 2**64 - 1), "size_t": (0, 2**64 - 1)}
# Constants that a member takes: all of the enumeration that has the one named, or those listed.
WORDS = {
    "obc_correspondence_options.via": "OBC_CORRESPONDENCE_SPHERE",
    "obc_correspondence_options.align": "OBC_CORRESPONDENCE_ALIGN_SHAPE",
    "obc_correspondence_options.grid": "OBC_CORRESPONDENCE_GRID_BOTH",
    "obc_correspondence_options.placement": "OBC_CORRESPONDENCE_KEPT",
    "obc_frame_field_options.start": "OBC_FRAME_FIELD_AUTO",
    "obc_frame_field_options.method": "OBC_FRAME_FIELD_SMOOTH",
    "obc_frame_field_options.weighting": "OBC_FRAME_FIELD_UNIFORM",
    "obc_frame_field_options.repair": "OBC_FRAME_FIELD_NO_REPAIR",
    "obc_harmonics_fit_options.method": "OBC_HARMONICS_AUTOMATIC",
    "obc_linear_direct_options.method": "OBC_LINEAR_AUTO",
    "obc_linear_iterative_options.method": "OBC_LINEAR_ITERATIVE_AUTO",
    "obc_polycube_options.construction": "OBC_POLYCUBE_AUTO",
    "obc_polycube_domain_options.measure": "OBC_POLYCUBE_SURFACE_MEAN",
    "obc_polycube_corner_options.method": "OBC_POLYCUBE_TRUST_REGION",
    "obc_projected_gradient_options.method": "OBC_PROJECTED_GRADIENT_FACE",
    "obc_projected_gradient_options.line_search": "OBC_PROJECTED_GRADIENT_MAX_OF_LAST",
    "obc_sphere_map_options.method": "OBC_SPHERE_MAP_BALANCED",
    "obc_sphere_optimizer_options.method": "OBC_SPHERE_OPTIMIZER_LIMITED_MEMORY",
    "obc_sphere_optimizer_relaxation_options.method": ["OBC_SPHERE_OPTIMIZER_GREAT_CIRCLE", "OBC_SPHERE_OPTIMIZER_DISSERTATION"],
    "obc_sphere_optimizer_relaxation_options.order": "OBC_SPHERE_OPTIMIZER_AUTOMATIC",
    "obc_trust_region_options.method": "OBC_TRUST_REGION_TWO_RADII",
    "obc_trust_region_options.start": "OBC_TRUST_REGION_AUTOMATIC",
    "obc_hexmesh_options.padding": "OBC_HEXMESH_PADDING_AUTO",
    "obc_hexmesh_options.method": "OBC_HEXMESH_METHOD_AUTO",
    "obc_hexmesh_options.features": "OBC_HEXMESH_FEATURES_MACHINED",
}
OTHERS = ["obc_gltf_scene"]  # filled like options


class Row:
    """One option: name, kind ("int", "float", "bool", "word", "text"), default, words (text -> number) or range, doc."""

    def __init__(self, library, struct, field, api, defaults):
        self.name, self.doc = field["name"], " ".join(field["doc"].split())
        kind, key = api.type(field["type"]), f"{struct}.{field['name']}"
        self.words, self.range = {}, None
        if key in WORDS:
            self.kind, self.words = "word", words(library, field["name"], WORDS[key], key)
        elif self.doc.startswith("OBC_"):
            raise SystemExit(f"{key} takes constants: name the first of them in WORDS of scripts/raw/python_options.py")
        elif kind.is_string:
            self.kind = "text"
        elif kind.name in ("double", "float"):
            self.kind = "float"
        elif kind.name == "int32_t" and re.search(r"(^|\W)1: ", self.doc):
            self.kind = "bool"
        else:
            self.kind, self.range = "int", INTEGERS[kind.name]
        self.default = None
        if self.name in defaults:
            value = defaults[self.name]
            if self.kind == "word":
                value = {number: word for word, number in self.words.items()}[value]
            self.default = bool(value) if self.kind == "bool" else value

    def parameter(self):
        hint = {"word": "Literal[" + ", ".join(f'"{word}"' for word in self.words) + "]", "text": "str"}.get(self.kind, self.kind)
        default = text_of(self.default)
        return f"{self.name}: {hint if self.default is not None else f'Optional[{hint}]'} = {default}"

    def entry(self):
        """Text for the table."""
        about = f"words={quoted(self.words)}" if self.words else f"low={self.range[0]}, high={self.range[1]}" if self.range else ""
        parts = [f'"{self.name}"', f'"{self.kind}"', text_of(self.default)] + ([about] if about else [])
        lines = [f"        Option({', '.join(parts)},"]
        if len(lines[0]) > WIDTH:
            lines = [f"        Option({', '.join(parts[:3])},", f"               {about},"]
        return "\n".join(lines) + f"\n               doc={doc_text(self.doc, 19)}),\n"


def words(library, field, found, key):
    """Word -> number: "angle-area" for OBC_SPHERE_MAP_ANGLE_AREA, "with" for OBC_VOLUME_MAP_PADDING_WITH of `padding`, and "auto" for
    OBC_LINEAR_ITERATIVE_AUTO of obc_linear_iterative_options."""
    values = [v for e in library["constants"] for v in e["values"]
              if v["name"] in found or (isinstance(found, str) and any(w["name"] == found for w in e["values"]))]
    if not values:
        raise ValueError(f"{key}: there is no constant {found}; mend WORDS in scripts/raw/python_options.py")
    prefix = re.match(r"orbicube/(\w+)\.h", library["header"]).group(1).upper()
    kind = key.split(".")[0].upper()[len(f"OBC_{prefix}_"):-len("OPTIONS")]
    return {re.sub(f"^OBC_{prefix}_({field.upper()}_|{kind})?", "", v["name"]).lower().replace("_", "-"): v["value"] for v in values}


def quoted(mapping):
    return "{" + ", ".join(f'"{word}": {number}' for word, number in mapping.items()) + "}"


def text_of(value):
    if isinstance(value, str):
        return f'"{value}"'
    if value in (float("inf"), float("-inf")):
        return f'float("{value}")'
    return repr(value)


def doc_text(doc, indent):
    """A string in as many lines as it takes."""
    lines, line = [], ""
    for word in doc.replace("\\", "\\\\").replace('"', "'").split():
        if len(line) + len(word) + indent + 4 > WIDTH:
            lines.append(line)
            line = ""
        line += word + " "
    lines.append(line.rstrip())
    return ("\n" + " " * indent).join(f'"{part}"' for part in lines)


def is_option(field):
    """Sizes, arrays and callbacks have parameters of their own, written by hand."""
    if "function" in field or field.get("lengths") or field["name"].startswith(("struct_size", "reserved")):
        return False
    return "*" not in field["type"] or field["type"] == "const char *"


def is_length(field):
    """Of an array; but block_size of obc_linear_iterative_options is an option."""
    return field["name"].endswith(("_count", "_size")) and field["type"] == "size_t"


def tables(api):
    """Struct -> rows."""
    with open(DEFAULTS, encoding="utf-8") as file:
        defaults = json.load(file)
    result = {}
    for library in api.libraries.values():
        for struct in library["structs"]:
            if struct["name"].endswith("_options") or struct["name"] in OTHERS:
                fields = [f for f in struct["fields"] if is_option(f) and not is_length(f) and
                          api.type(f["type"]).name not in api.callbacks]
                if struct["name"] in OTHERS:
                    fields = [f for f in fields if "*" not in f["type"]]
                result[struct["name"]] = [Row(library, struct["name"], f, api, defaults.get(struct["name"], {})) for f in fields]
    return result


def words_by_option(api):
    """Struct -> option -> words with their numbers, for the other languages as well."""
    return {struct: {row.name: row.words for row in rows if row.words}
            for struct, rows in tables(api).items() if any(row.words for row in rows)}


def region(match, rows):
    indent, struct, only = match.group(1), match.group(2), match.group(3)
    if struct not in rows:
        raise ValueError(f"no options are known of {struct}")
    chosen = {row.name: row for row in rows[struct]}
    names = [name.strip() for name in only.split(",")] if only else list(chosen)
    lines, line = [], indent
    for name in names:
        parameter = chosen[name].parameter() + ","
        if line.strip() and len(line) + 1 + len(parameter) > WIDTH:
            lines.append(line)
            line = indent
        line += (" " if line.strip() else "") + parameter
    lines.append(line)
    head = f"{indent}# options of {struct}{': ' + only if only else ''}, written by scripts/bindings.py\n"
    return head + "".join(line + "\n" for line in lines if line.strip()) + f"{indent}# end of options\n"


def files(api, root):
    rows = tables(api)
    text = HEAD + "OPTIONS: dict[str, tuple[Option, ...]] = {\n"
    for struct, options in rows.items():
        text += f'    "{struct}": (\n' + "".join(row.entry() for row in options) + "    ),\n"
    result = {FOLDER + "_options.py": text + "}\n"}
    for path in sorted(glob.glob(os.path.join(root, FOLDER, "*.py"))):
        with open(path, encoding="utf-8") as file:
            old = file.read()
        if REGION.search(old):
            result[os.path.relpath(path, root)] = REGION.sub(lambda match: region(match, rows), old)
    return result


def record_defaults(api, root, folder):
    """Reads from the libraries in a folder what their _init functions fill in."""
    os.environ["ORBICUBE_LIBRARIES"] = folder
    package = sys.modules["orbicube"] = types.ModuleType("orbicube")  # without numpy, which all but its raw layer needs
    package.__path__ = [os.path.join(root, FOLDER)]
    found = {}
    for name, library in api.libraries.items():
        module = import_module("orbicube.raw." + name)
        for struct in library["structs"]:
            if struct["name"].endswith("_options") or struct["name"] in OTHERS:
                filled = getattr(module, struct["name"])()
                if getattr(module, struct["name"] + "_init")(byref(filled), sizeof(filled)):
                    raise ValueError(f"{struct['name']} is not what the library in {folder} has; build it")
                found[struct["name"]] = {
                    f["name"]: getattr(filled, f["name"]) for f in struct["fields"]
                    if is_option(f) and "*" not in f["type"] and not is_length(f) and
                    api.type(f["type"]).name not in api.callbacks}
    with open(DEFAULTS, "w", encoding="utf-8") as file:
        json.dump(found, file, indent=1)
        file.write("\n")
