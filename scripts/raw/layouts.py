"""What the raw layers assume of the layouts of structs, as a C file that only compiles when it holds."""


def rows(api, pointer):
    result = ""
    for library in api.libraries.values():
        for struct in library["structs"]:
            size, _, offsets = api.layout(struct["name"], pointer)
            result += f'_Static_assert(sizeof({struct["name"]}) == {size}, "{struct["name"]}");\n'
            for field, offset in offsets:
                result += (f'_Static_assert(offsetof({struct["name"]}, {field}) == {offset}, '
                           f'"{struct["name"]}.{field}");\n')
    return result


def files(api):
    includes = "".join(f"#include <orbicube/{name}.h>\n" for name in api.libraries)
    return {"tests/bindings/layouts.c":
            "/* How structs lie in memory on 64-bit machines and in WebAssembly. Written by scripts/bindings.py; not to be edited. */\n"
            f"/* clang-format off */\n{includes}\n#if UINTPTR_MAX == 0xFFFFFFFFFFFFFFFF\n{rows(api, 8)}"
            f"#elif defined(__wasm32__)\n{rows(api, 4)}#endif\ntypedef int not_empty;\n"}
