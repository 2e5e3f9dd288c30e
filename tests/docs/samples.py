"""The fenced code of a page. A comment <!-- not run: WHY --> on the line before a block says that it is only to be read."""

import os
import re

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def blocks(page, language):
    """(line, text) of each block of a language that is to be tried."""
    with open(page, encoding="utf-8") as file:
        text = file.read()
    for found in re.finditer(r"^(<!-- not run: [^\n]+ -->\n)?```(\w*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        if found.group(2) == language and not found.group(1):
            yield text.count("\n", 0, found.start(3)) + 1, found.group(3)


def pages():
    """All pages of docs/ and the README."""
    folder = os.path.join(ROOT, "docs")
    return sorted(os.path.join(folder, name) for name in os.listdir(folder) if name.endswith(".md")) + [os.path.join(ROOT, "README.md")]
