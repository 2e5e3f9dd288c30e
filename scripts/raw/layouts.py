"""What the raw layers assume of the layouts of structs, as a C file that only compiles when it holds."""


def files(api):
    rows = ""
    for library in api.libraries.values():
        for struct in library["structs"]:
            size, _, offsets = api.layout(struct["name"])
            rows += f'_Static_assert(sizeof({struct["name"]}) == {size}, "{struct["name"]}");\n'
            for field, offset in offsets:
                rows += (f'_Static_assert(offsetof({struct["name"]}, {field}) == {offset}, '
                         f'"{struct["name"]}.{field}");\n')
    includes = "".join(f"#include <orbicube/{name}.h>\n" for name in api.libraries)
    return {"tests/bindings/layouts.c":
            "/* How structs lie in memory on 64-bit machines, for every language. Written by scripts/bindings.py; not to be\n"
            f" * edited. */\n/* clang-format off */\n{includes}\n#if UINTPTR_MAX == 0xFFFFFFFFFFFFFFFF\n{rows}#endif\n"
            "typedef int not_empty;\n"}
