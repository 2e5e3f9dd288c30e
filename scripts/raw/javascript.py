"""The raw layer of JavaScript: constants, layouts of structs and types of functions in a 32-bit WebAssembly module."""

from raw.c_types import in_order
from raw.python_options import words_by_option

FIELDS = {"char": "char", "int8_t": "i8", "uint8_t": "u8", "int16_t": "i16", "uint16_t": "u16", "int32_t": "i32",
          "uint32_t": "u32", "int64_t": "i64", "uint64_t": "u64", "float": "f32", "double": "f64", "size_t": "u32"}
# The letters of emscripten's signatures.
LETTERS = {"void": "v", "int64_t": "j", "uint64_t": "j", "float": "f", "double": "d"}
FOLDER = "bindings/js/raw/"
HEAD = "// What the C headers declare, {0}. Written by scripts/bindings.py; not to be edited.\n"
POINTER = 4
# Not in the module: a library whose license would bind users, and those that would make pages load more than 3 MB:
# one for programs that assemble large systems (what polycubes and hexahedra use of it is in it), correspondences, repairs.
LEFT_OUT = ["correspondence", "linear", "repair", "tetrahedra"]
# Functions left out for their size: JavaScript reads and writes surfaces of glTF, keeps nothing else of a file, untangles
# tetrahedra only and without splits, and has no parameterizations along frames.
LEFT_OUT_FUNCTIONS = ["obc_gltf_surface_keeps", "obc_gltf_write_kept", "obc_untangle_triangles", "obc_untangle_triangles_problem_init"] + [
    "obc_untangle_" + name for name in (
        "refine_tetrahedra", "refine_triangles", "refined_destroy", "refined_vertex_count", "refined_element_count", "refined_copy")] + [
    "obc_volume_map_" + name for name in (
        "frame_map_options_init", "frame_map_report_init", "frame_map_compute", "frame_map_destroy", "frame_map_tetrahedron_count",
        "frame_map_singular_edge_count", "frame_map_copy", "locator_create", "locator_destroy", "locator_locate", "locator_interpolate")]


def parts(api):
    return [library for name, library in api.libraries.items() if name not in LEFT_OUT]


def functions(library):
    return [function for function in library["functions"] if function["name"] not in LEFT_OUT_FUNCTIONS]


def field_type(api, field):
    if "function" in field:
        return "u32"
    kind = api.type(field["type"])
    if kind.is_pointer or kind.name in api.callbacks:
        return "u32"
    return FIELDS.get(kind.name, kind.name)


def letter(api, entry):
    if "function" in entry or entry.get("lengths"):
        return "i"
    kind = api.type(entry["type"])
    if kind.is_pointer or kind.name in api.callbacks:
        return "i"
    return LETTERS.get(kind.name, "i")


def signature(api, function):
    return "".join(letter(api, e) for e in [{"type": function["returns"]}] + function["parameters"])


def module(api):
    out = [HEAD.format("for a module of 32-bit WebAssembly"),
           "\n/** Constants by their names in C. */\nexport const constants = {\n"]
    for library in parts(api):
        for enumeration in library["constants"]:
            out += [f"  {value['name']}: {value['value']},\n" for value in enumeration["values"]]
    out.append("};\n\n/** Of each struct its size in bytes, and of each member [type, offset, length of an array]. */\n"
               "export const layouts = {\n")
    for library in parts(api):
        for struct in in_order(library["structs"], api):
            size, _, offsets = api.layout(struct["name"], POINTER)
            out.append(f"  {struct['name']}: {{\n    size: {size},\n    fields: {{\n")
            for field, (name, offset) in zip(struct["fields"], offsets):
                length = 1
                for each in field.get("lengths", []):
                    length *= each
                tail = f", {length}" if field.get("lengths") else ""
                out.append(f"      {name}: ['{field_type(api, field)}', {offset}{tail}],\n")
            out.append("    },\n  },\n")
    out.append("};\n\n/** Types of callbacks, result first: i 32-bit numbers and pointers, j BigInts of 64 bits, d doubles, v nothing. */\n"
               "export const callbacks = {\n")
    for library in parts(api):
        out += [f"  {callback['name']}: '{signature(api, callback)}',\n" for callback in library["callbacks"]]
    out.append("};\n\n/** Types of functions, in the same letters. */\nexport const functions = {\n")
    for library in parts(api):
        out += [f"  {function['name']}: '{signature(api, function)}',\n" for function in functions(library)]
    out.append("};\n")
    return "".join(out)


def hint(api, entry):
    text = {"v": "void", "j": "bigint"}.get(letter(api, entry), "number")
    if text == "number" and "type" in entry and (api.type(entry["type"]).is_pointer or entry.get("lengths")):
        return "Pointer"
    return text


def documentation(text, indent):
    if not text:
        return ""
    return f"{indent}/** " + ("\n" + indent + " * ").join(line.strip() for line in text.replace("*/", "* /").split("\n")) + " */\n"


def types(api):
    out = [HEAD.format("with the parameters of their functions"),
           "\n/** An address in the module's memory. */\nexport type Pointer = number;\n"
           "\nexport const constants: {\n"]
    for library in parts(api):
        for enumeration in library["constants"]:
            out += [f"  readonly {value['name']}: {value['value']};\n" for value in enumeration["values"]]
    out.append("};\n\nexport interface Layout {\n  readonly size: number;\n"
               "  readonly fields: Readonly<Record<string, readonly (string | number)[]>>;\n}\n"
               "export const layouts: {\n")
    for library in parts(api):
        out += [f"  readonly {struct['name']}: Layout;\n" for struct in in_order(library["structs"], api)]
    out.append("};\nexport const callbacks: Readonly<Record<string, string>>;\n"
               "export const functions: Readonly<Record<keyof RawFunctions, string>>;\n"
               "\n/** The C functions as they are. Functions and structs are given by their addresses. */\n"
               "export interface RawFunctions {\n")
    for library in parts(api):
        for function in functions(library):
            arguments = ", ".join(f"{safe(p['name'] or f'argument{i}')}: {hint(api, p)}"
                                  for i, p in enumerate(function["parameters"]))
            result = hint(api, {"type": function["returns"]})
            out.append(f"{documentation(function['doc'], '  ')}  {function['name']}({arguments}): {result};\n")
    out.append("}\n")
    return "".join(out)


def safe(name):
    return name + "_" if name in ("function", "in", "new", "with", "default", "export", "import", "void") else name


def words(api):
    """The words that options take."""
    known = {struct["name"] for library in parts(api) for struct in library["structs"]}
    rows = "".join(
        f"  {struct}: {{\n" + "".join(f"    {option}: {{ " + ", ".join(f"'{word}': {number}" for word, number in found.items()) + " },\n"
                                    for option, found in options.items()) + "  },\n"
        for struct, options in words_by_option(api).items() if struct in known)
    return f"\n/** The words that options take, and their constants. */\nexport const words = {{\n{rows}}};\n"


def files(api):
    more = "\nexport const words: Readonly<Record<string, Readonly<Record<string, Readonly<Record<string, number>>>>>>;\n"
    return {FOLDER + "raw.js": module(api) + words(api), FOLDER + "raw.d.ts": types(api) + more}
