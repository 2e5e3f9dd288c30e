#!/usr/bin/env python3
"""Every link of the tree's Markdown pages to a file of the tree leads somewhere.

    links.py ROOT
"""

import os
import re
import subprocess
import sys


def pages(root):
    listed = subprocess.run(["git", "-C", root, "ls-files", "*.md"], capture_output=True, text=True, check=False)
    if listed.returncode != 0:
        print("not a git tree: the pages are not known")
        sys.exit(77)  # what Meson takes for "skipped"
    return listed.stdout.split("\n")[:-1]


def broken_links(root):
    for page in pages(root):
        with open(os.path.join(root, page), encoding="utf-8") as file:
            text = re.sub(r"^```.*?^```", "", file.read(), flags=re.MULTILINE | re.DOTALL)
        for link in re.findall(r"\]\(([^)\s]+)\)", text):
            path = link.split("#")[0]
            if path and "://" not in path and not os.path.exists(os.path.join(root, os.path.dirname(page), path)):
                yield f"{page}: {link} leads nowhere"


if __name__ == "__main__":
    found = list(broken_links(sys.argv[1]))
    if found:
        sys.exit("\n".join(found))
