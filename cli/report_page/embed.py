#!/usr/bin/env python3
"""Puts the page's style and scripts into its HTML and writes the whole as a C++ source or as HTML.

    embed.py OUT.cpp FUNCTION page.html STYLE.css ... SCRIPT.js ...
    embed.py OUT.html - page.html STYLE.css ... SCRIPT.js ...

FUNCTION is what the C++ source defines, declared in report_page/template.h. page.html has the buttons of the page's header, and
from <main> on its own contents; what pages share is in frame.html, where `@TITLE@` and `@RESULTS@` are left for the program to fill.
The scripts are modules, each after those that it imports. They become one module, since a page that stands alone has no
addresses to import from: their imports and the word `export` are left out, and no two may declare the same name.
"""
import os
import re
import sys


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def bare(script, known):
    """The text of a module without imports and exports; adds the names that it declares to `known`."""
    text = read(script)
    for names in re.findall(r"^import \{([^}]*)\} from .*;$", text, re.M):
        missing = [name for name in names.split(", ") if not known.get(name)]
        if missing:
            sys.exit(f"embed.py: {script} imports {', '.join(missing)}, which no script before it exports")
    text = re.sub(r"^import \{.*\} from .*;\n", "", text, flags=re.M)
    declared = re.findall(r"^(export )?(?:async )?(?:function|class|const|let) (\w+)", text, re.M)
    for exported, name in declared:
        if name in known:
            sys.exit(f"embed.py: {script} declares {name}, as a script before it does")
        known[name] = bool(exported)
    text = re.sub(r"^export (?=function|class|const)", "", text, flags=re.M)
    if re.search(r"^\s*(import|export)\b", text, re.M):
        sys.exit(f"embed.py: {script} has an import or export in a form that is not known here")
    return text.strip()


def main(out, function, html, *parts):
    known = {}
    scripts = [part for part in parts if part.endswith(".js")]
    page = read(os.path.join(os.path.dirname(os.path.abspath(__file__)), "frame.html"))
    buttons, main_text = read(html).split("<main>")
    page = page.replace("@BUTTONS@", buttons.rstrip()).replace("@MAIN@", "<main>" + main_text.rstrip())
    page = page.replace("@STYLE@", "\n".join(read(part).strip() for part in parts if part not in scripts))
    page = page.replace("@SCRIPT@", "\n".join(bare(script, known) for script in scripts))
    if out.endswith(".html"):
        with open(out, "w", encoding="utf-8") as file:
            file.write(page)
        return
    # In pieces, since compilers limit the length of a literal.
    pieces = [page[i:i + 8000] for i in range(0, len(page), 8000)]
    if any(')page"' in piece for piece in pieces):
        sys.exit('embed.py: the page contains )page"')
    with open(out, "w", encoding="utf-8") as file:
        file.write('#include "report_page/template.h"\n\nnamespace orbicube::cli {\n\n')
        file.write(f"std::string {function}() {{\n  std::string page;\n")
        file.writelines(f'  page += R"page({piece})page";\n' for piece in pieces)
        file.write("  return page;\n}\n\n}  // namespace orbicube::cli\n")


main(*sys.argv[1:])
