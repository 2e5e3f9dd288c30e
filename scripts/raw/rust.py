"""The raw layer of Rust: a module of orbicube-sys a library, with tests of the layouts."""

import re

from raw.c_types import in_order

NUMBERS = {"char": "c_char", "int8_t": "i8", "uint8_t": "u8", "int16_t": "i16", "uint16_t": "u16", "int32_t": "i32",
           "uint32_t": "u32", "int64_t": "i64", "uint64_t": "u64", "float": "f32", "double": "f64", "size_t": "usize",
           "void": "c_void"}
KEYWORDS = {"type", "box", "fn", "in", "loop", "match", "mod", "move", "ref", "self", "static", "use", "where", "yield"}
FOLDER = "bindings/rust/orbicube-sys/src/"
NOT_DEFAULT = {"tetrahedra"}  # TetGen's license, the AGPL 3, binds programs that use it
MANIFEST = """# Written by scripts/bindings.py; not to be edited.
[package]
name = "orbicube-sys"
version = "0.1.0"
edition = "2021"
rust-version = "1.63"
description = "The C functions of the Orbicube libraries: maps of surfaces to spheres and polycubes, frame fields, solvers"
license = "Apache-2.0"
readme = "README.md"
links = "orbicube"
build = "build.rs"
include = ["/src", "/build.rs", "/README.md", "/vendor"]
"""


def safe(name):
    return "r#" + name if name in KEYWORDS else name


def rust_type(api, entry):
    if "function" in entry:
        return function_type(api, entry["function"])
    kind = api.type(entry["type"])
    text = NUMBERS.get(kind.name, kind.name)
    if kind.name == "void" and not kind.is_pointer:
        return "()"
    constant = kind.constant
    for star in kind.stars:
        text = f"*{'const' if constant else 'mut'} {text}"
        constant = star
    for length in reversed(entry.get("lengths", [])):
        text = f"[{text}; {length}]"
    return text


def arguments(api, function):
    rows = []
    for i, parameter in enumerate(function["parameters"]):
        if parameter.get("lengths"):
            parameter = dict(parameter, type=parameter["type"] + " *", lengths=[])
        rows.append(f"{safe(parameter['name'] or f'argument_{i}')}: {rust_type(api, parameter)}")
    return ", ".join(rows)


def result(api, function):
    text = rust_type(api, {"type": function["returns"]})
    return "" if text == "()" else f" -> {text}"


def function_type(api, function):
    return f"Option<unsafe extern \"C\" fn({arguments(api, function)}){result(api, function)}>"


def comment(text, indent=""):
    """What the header says, with what Markdown would take for its own escaped."""
    lines = [re.sub(r"([\\\[\]<>*_`#])", r"\\\1", line.strip()) for line in text.split("\n")] if text else []
    return "".join(f"{indent}/// {line}".rstrip() + "\n" for line in lines)


def module(api, name):
    library = api.libraries[name]
    out = [f"//! What `<orbicube/{name}.h>` declares. Written by scripts/bindings.py; not to be edited.\n",
           "#![allow(non_camel_case_types, non_upper_case_globals)]\n\n"]
    used = api.imports(name)
    text_of_types = []
    for enumeration in library["constants"]:
        text_of_types += [comment(v["doc"]) + f"pub const {v['name']}: i32 = {v['value']};\n" for v in enumeration["values"]]
        text_of_types.append("\n")
    for alias in library["aliases"]:
        text_of_types.append(comment(alias["doc"]) + f"pub type {alias['name']} = {rust_type(api, alias)};\n\n")
    for handle in library["handles"]:
        text_of_types.append(comment(handle["doc"]) + f"#[repr(C)]\npub struct {handle['name']} {{\n    _private: [u8; 0],\n"
                             "    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,\n}\n\n")
    for callback in library["callbacks"]:
        text_of_types.append(comment(callback["doc"]) + f"pub type {callback['name']} = {function_type(api, callback)};\n\n")
    for struct in in_order(library["structs"], api):
        fields = "".join(comment(f["doc"], "    ") + f"    pub {safe(f['name'])}: {rust_type(api, f)},\n" for f in struct["fields"])
        text_of_types.append(comment(struct["doc"]) + f"#[repr(C)]\n#[derive(Clone, Copy)]\npub struct {struct['name']} {{\n{fields}}}\n\n")
    functions = "".join(comment(f["doc"], "    ") + f"    pub fn {f['name']}({arguments(api, f)}){result(api, f)};\n"
                        for f in library["functions"])
    body = "".join(text_of_types) + (f"extern \"C\" {{\n{functions}}}\n" if functions else "") + layout_tests(api, library)
    raw_types = [t for t in ("c_char", "c_void") if t in body]
    if raw_types:
        out.append(f"use std::os::raw::{{{', '.join(raw_types)}}};\n")
    out[2:2] = [f"use crate::{owner}::{names[0] if len(names) == 1 else '{' + ', '.join(names) + '}'};\n"
                for owner, names in used.items()]
    return "".join(out) + "\n" + body


def layout_tests(api, library):
    if not library["structs"]:
        return ""
    rows = ""
    for struct in library["structs"]:
        size, alignment, offsets = api.layout(struct["name"])
        rows += f"        assert_eq!((size_of::<{struct['name']}>(), align_of::<{struct['name']}>()), ({size}, {alignment}));\n"
        rows += f"        let it = MaybeUninit::<{struct['name']}>::uninit();\n        let start = it.as_ptr();\n"
        for field, offset in offsets:
            rows += (f"        assert_eq!(unsafe {{ addr_of!((*start).{safe(field)}) }} as usize - start as usize, {offset}, "
                     f"\"{struct['name']}.{field}\");\n")
    return ("\n#[cfg(all(test, target_pointer_width = \"64\"))]\nmod layout {\n    use super::*;\n"
            "    use std::mem::{align_of, size_of, MaybeUninit};\n    use std::ptr::addr_of;\n\n"
            "    #[test]\n    fn structs_lie_in_memory_as_in_c() {\n" + rows + "    }\n}\n")


def root(api):
    modules = "".join(("" if name == "base" else f'#[cfg(feature = "{name}")]\n') + f"pub mod {name};\n" for name in api.libraries)
    return ("//! The C functions of the Orbicube libraries as they are, a module and a cargo feature a library, written from the C\n"
            "//! headers by scripts/bindings.py. The documentation is that of the headers. People use the crate `orbicube`.\n\n" + modules)


def manifest(api):
    """A feature a library; those whose licenses bind programs that use them are not among the default ones."""
    features = {name: [used for used in library["uses"] if used != "base"]
                for name, library in api.libraries.items() if name != "base"}
    default = ", ".join(f'"{name}"' for name in features if name not in NOT_DEFAULT)
    rows = "".join(f"{name} = [{', '.join(repr(used) for used in uses)}]\n".replace("'", '"')
                   for name, uses in features.items())
    return MANIFEST + f"\n[features]\ndefault = [{default}]\n{rows}"


def files(api):
    result = {FOLDER + name + ".rs": module(api, name) for name in api.libraries}
    result[FOLDER + "lib.rs"] = root(api)
    result["bindings/rust/orbicube-sys/Cargo.toml"] = manifest(api)
    return result
