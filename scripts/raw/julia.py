"""The raw layer of Julia: a file of ccalls a library, and a test of the layouts."""

from raw.c_types import in_order
from raw.python_options import words_by_option

NUMBERS = {"char": "UInt8", "int8_t": "Int8", "uint8_t": "UInt8", "int16_t": "Int16", "uint16_t": "UInt16",
           "int32_t": "Int32", "uint32_t": "UInt32", "int64_t": "Int64", "uint64_t": "UInt64", "float": "Float32",
           "double": "Float64", "size_t": "Csize_t", "void": "Cvoid"}
KEYWORDS = {"end", "begin", "function", "module", "type", "using", "import", "export", "let", "for", "quote"}
FOLDER = "bindings/julia/"


def safe(name):
    return name + "_" if name in KEYWORDS else name


def julia_type(api, entry):
    if "function" in entry:
        return "Ptr{Cvoid}"
    kind = api.type(entry["type"])
    if kind.is_string and not entry.get("lengths"):
        return "Cstring"
    text = NUMBERS.get(kind.name, "Cvoid" if kind.name in api.handles else kind.name)
    if kind.name in api.callbacks:
        text = "Ptr{Cvoid}"
    for _ in kind.stars:
        text = f"Ptr{{{text}}}"
    for length in reversed(entry.get("lengths", [])):
        text = f"NTuple{{{length}, {text}}}"
    return text


def grows(struct):
    """Structs that a function fills, or that have a size of their own, are passed by reference and changed in place."""
    return struct["fields"][0]["name"] == "struct_size" or struct["name"] == "obc_error"


def argument_type(api, parameter):
    if parameter.get("lengths"):
        parameter = dict(parameter, type=parameter["type"] + " *", lengths=[])
    return julia_type(api, parameter)


def module(api, name):
    library = api.libraries[name]
    out = [f"# What <orbicube/{name}.h> declares. Written by scripts/bindings.py; not to be edited.\n"]
    for enumeration in library["constants"]:
        out.append("\n" + "".join(f"const {v['name']} = Int32({v['value']})\n" for v in enumeration["values"]))
    for struct in in_order(library["structs"], api):
        fields = "".join(f"    {safe(f['name'])}::{julia_type(api, f)}\n" for f in struct["fields"])
        if grows(struct):
            out.append(f"\nmutable struct {struct['name']} <: CStruct\n{fields}    {struct['name']}() = zeroed!(new())\nend\n")
        else:
            out.append(f"\nstruct {struct['name']}\n{fields}end\n")
    for function in library["functions"]:
        names = [safe(p["name"] or f"argument_{i}") for i, p in enumerate(function["parameters"])]
        types = ", ".join(argument_type(api, p) for p in function["parameters"]) + ("," if len(names) == 1 else "")
        arguments = ", ".join(names)
        out.append(f"\nconst address_{function['name']} = Ref(C_NULL)\n"
                   f"{function['name']}({arguments}) =\n"
                   f"    ccall(symbol(address_{function['name']}, :{name}, :{function['name']}), "
                   f"{julia_type(api, {'type': function['returns']})}, ({types}){', ' if names else ''}{arguments})\n")
    return "".join(out)


def layouts(api):
    rows = ""
    for name, library in api.libraries.items():
        for struct in library["structs"]:
            size, _, offsets = api.layout(struct["name"])
            values = ", ".join(str(offset) for _, offset in offsets)
            rows += f"    (Orbicube.Raw.{struct['name']}, {size}, [{values}]),\n"
    return ("# How the structs of the C headers lie in memory on 64-bit machines. Written by scripts/bindings.py; not to be edited.\n"
            f"const layouts = [\n{rows}]\n")


def libraries(api):
    """In an order in which they can be loaded."""
    order = []
    for name in api.libraries:
        order += [used for used in api.used(name) + [name] if used not in order]
    rows = "".join(f"    :{name} => Symbol[{', '.join(':' + used for used in api.used(name))}],\n" for name in order)
    return ("# Each library with those that it uses. Written by scripts/bindings.py; not to be edited.\n"
            f"const libraries = [\n{rows}]\n")


def words(api):
    """The symbols that options take."""
    rows = "".join(f"    (:{struct}, :{option}) => [" + ", ".join(f":{word.replace('-', '_')} => {number}" for word, number in found.items()) +
                   "],\n" for struct, options in words_by_option(api).items() for option, found in options.items())
    return ("# The words that options take, and their constants. Written by scripts/bindings.py; not to be edited.\n"
            f"const words = Dict{{Tuple{{Symbol,Symbol}},Vector{{Pair{{Symbol,Int}}}}}}(\n{rows})\n")


def files(api):
    result = {FOLDER + f"src/raw/{name}.jl": module(api, name) for name in api.libraries}
    result[FOLDER + "src/raw/libraries.jl"] = libraries(api)
    result[FOLDER + "src/raw/words.jl"] = words(api)
    result[FOLDER + "test/layouts.jl"] = layouts(api)
    return result
