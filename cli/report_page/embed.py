#!/usr/bin/env python3
"""Puts the page's style and scripts into its HTML and writes the whole as a C++ source.

    embed.py OUT.cpp page.html STYLE.css SCRIPT.js ...

The HTML has one line `@STYLE@` and one line `@SCRIPT@`; `@TITLE@` and `@RESULTS@` are left for the program to fill.
"""
import sys


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def main(out, html, style, *scripts):
    page = read(html).replace("@STYLE@", read(style).strip())
    page = page.replace("@SCRIPT@", "\n".join(read(script).strip() for script in scripts))
    for mark in ("@TITLE@", "@RESULTS@"):
        if page.count(mark) < 1:
            sys.exit(f"embed.py: {html} has no {mark}")
    # In pieces, since compilers limit the length of a literal.
    pieces = [page[i:i + 8000] for i in range(0, len(page), 8000)]
    if any(')page"' in piece for piece in pieces):
        sys.exit('embed.py: the page contains )page"')
    with open(out, "w", encoding="utf-8") as file:
        file.write('#include "report_page/template.h"\n\nnamespace orbicube::cli {\n\n')
        file.write("std::string page_template() {\n  std::string page;\n")
        file.writelines(f'  page += R"page({piece})page";\n' for piece in pieces)
        file.write("  return page;\n}\n\n}  // namespace orbicube::cli\n")


main(*sys.argv[1:])
