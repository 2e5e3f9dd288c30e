"""The raw layer of Python: a module of ctypes declarations a library, and its type stubs."""

from raw.c_types import in_order

NUMBERS = {"char": "c_char", "int8_t": "c_int8", "uint8_t": "c_uint8", "int16_t": "c_int16", "uint16_t": "c_uint16",
           "int32_t": "c_int32", "uint32_t": "c_uint32", "int64_t": "c_int64", "uint64_t": "c_uint64", "float": "c_float",
           "double": "c_double", "size_t": "c_size_t"}
FOLDER = "bindings/python/orbicube/raw/"
HEAD = '"""What <orbicube/{0}.h> declares. Written by scripts/bindings.py; not to be edited."""\n'


def ctype(api, entry):
    """The ctypes type, as text, of a parameter, field or result. Pointers to data are plain addresses."""
    if "function" in entry:
        return function_type(api, entry["function"])
    kind = api.type(entry["type"])
    if kind.is_string:
        text = "_c.c_char_p"
    elif kind.is_pointer:
        text = "_c.c_void_p"
    elif kind.name == "void":
        return "None"
    elif kind.name in NUMBERS:
        text = "_c." + NUMBERS[kind.name]
    else:
        text = kind.name
    for length in reversed(entry.get("lengths", [])):
        text += f" * {length}"
    return text


def function_type(api, function):
    types = [ctype(api, {"type": function["returns"]})] + [ctype(api, p) for p in parameters(function)]
    return f"_c.CFUNCTYPE({', '.join(types)})"


def parameters(function):
    """Array parameters are pointers."""
    return [dict(p, type=p["type"] + " *", lengths=[]) if p.get("lengths") else p for p in function["parameters"]]


def docstring(text, indent):
    if not text:
        return ""
    lines = text.replace("\\", "\\\\").replace('"""', "'''").split("\n")
    quoted = ("\n" + indent).join(line.strip() if i == 0 else line for i, line in enumerate(lines))
    return f'{indent}"""{quoted}{" " if quoted.endswith(chr(34)) else ""}"""\n'


def module(api, name):
    library = api.libraries[name]
    out = [HEAD.format(name), "import ctypes as _c\n\nfrom .._library import bind as _bind\nfrom .._library import Struct as _Struct\n"]
    for owner, names in api.imports(name).items():
        names = [n for n in names if n not in api.handles and needed_at_run_time(api, library, n)]
        if names:
            out.append(f"from .{owner} import {', '.join(names)}\n")
    for enumeration in library["constants"]:
        out.append("\n" + "".join(f"{value['name']} = {value['value']}\n" for value in enumeration["values"]))
    for callback in library["callbacks"]:
        out.append(f"\n{callback['name']} = {function_type(api, callback)}\n")
    for struct in in_order(library["structs"], api):
        fields = "".join(f'        ("{f["name"]}", {ctype(api, f)}),\n' for f in struct["fields"])
        out.append(f"\n\nclass {struct['name']}(_Struct):\n" + docstring(struct["doc"], "    ") + f"    _fields_ = [\n{fields}    ]\n")
    rows = ""
    for function in library["functions"]:
        types = ", ".join(ctype(api, p) for p in parameters(function))
        rows += f'    ("{function["name"]}", {ctype(api, {"type": function["returns"]})}, [{types}]),\n'
    uses = ", ".join(f'"{used}"' for used in api.used(name))
    out.append(f"\n\n_functions = [\n{rows}]\n\n\ndef __getattr__(name):\n"
               f'    """A function; the shared library is loaded at the first use."""\n'
               f'    return _bind("{name}", [{uses}], _functions, globals(), name)\n')
    return "".join(out)


def needed_at_run_time(api, library, name):
    """Pointers to structs are addresses, so only structs that are members or passed by value are needed."""
    def used(entry):
        if "function" in entry:
            return any(used(p) for p in entry["function"]["parameters"])
        kind = api.type(entry["type"])
        return kind.name == name and not kind.is_pointer

    fields = [field for struct in library["structs"] for field in struct["fields"]]
    return any(used(e) for e in fields + [p for f in library["functions"] + library["callbacks"] for p in f["parameters"]])


# -- stubs -----------------------------------------------------------------------------------------------------------------

def hint(api, entry):
    """The type that Python sees of a parameter, field or result."""
    if "function" in entry:
        return "Any"
    kind = api.type(entry["type"])
    if entry.get("lengths"):
        return "bytes" if kind.name == "char" else "Any"
    if kind.is_string:
        return "bytes | None"
    if kind.is_pointer:
        return "Pointer"
    if kind.name == "void":
        return "None"
    if kind.name in ("double", "float"):
        return "float"
    return "int" if kind.name in NUMBERS else "Any"


def stub(api, name):
    library = api.libraries[name]
    out = [HEAD.format(name), "from typing import Any\n\nfrom .._library import Pointer, Struct\n"]
    for enumeration in library["constants"]:
        out.append("\n" + "".join(f"{value['name']}: int\n" for value in enumeration["values"]))
    for callback in library["callbacks"]:
        out.append(f"\n{callback['name']}: Any\n")
    for struct in in_order(library["structs"], api):
        hints = {f["name"]: hint(api, f).replace("Pointer", "Any") for f in struct["fields"]}  # read and written as a number
        fields = "".join(f"    {name}: {kind}\n" for name, kind in hints.items())
        arguments = "".join(f", {name}: {kind} = ..." for name, kind in hints.items())
        out.append(f"\nclass {struct['name']}(Struct):\n{fields}    def __init__(self{arguments}) -> None: ...\n")
    for function in library["functions"]:
        arguments = ", ".join(f"{safe(p['name'])}: {hint(api, p)}" for p in parameters(function))
        result = hint(api, {"type": function["returns"]})
        out.append(f"\ndef {function['name']}({arguments}) -> {result}:\n{docstring(function['doc'], '    ')}    ...\n")
    return "".join(out)


def safe(name):
    return name + "_" if name in ("from", "in", "is", "lambda", "not", "pass", "with") else name


def files(api):
    result = {FOLDER + "__init__.py": '"""The C functions as they are, a module a library. Written by scripts/bindings.py."""\n'}
    for name in api.libraries:
        result[FOLDER + name + ".py"] = module(api, name)
        result[FOLDER + name + ".pyi"] = stub(api, name)
    return result
