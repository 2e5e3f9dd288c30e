# How Sphinx makes a site of these pages: scripts/docs.
import os
import re

project = "Orbicube"
author = "the authors of Orbicube"
with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "meson.build"), encoding="utf-8") as file:
    version = release = re.search(r"^  version: '([\d.]+)'", file.read(), re.MULTILINE).group(1)
copyright = author  # noqa: A001: what Sphinx calls it
extensions = ["myst_parser"]
root_doc = "index"  # the gallery, then what there is to read
myst_heading_anchors = 4
html_theme = "alabaster"
html_theme_options = {"description": "maps of shapes to spheres and polycubes, and the solvers underneath", "fixed_sidebar": True,
                      "page_width": "min(72em, 100%)", "body_max_width": "none", "show_powered_by": False}
html_sidebars = {"**": ["about.html", "searchbox.html", "navigation.html"]}
html_static_path = ["site"]  # custom.css, which the theme names
html_copy_source = False
html_show_sphinx = False

# The menu: every page, in this order; what is not named comes at the end of its part.
PARTS = {
    "Guides": ["guide_solvers", "guide_shapes", "guide_engines", "finite_elements"],
    "The command": ["command", "file_formats", "mesh_formats", "error_kinds"],
    "Libraries": ["base", "quaternion", "sphere_optimizer", "trust_region", "projected_gradient", "linear", "linear_tables", "harmonics", "harmonics_figures",
                  "mesh", "gltf", "repair", "repair_figures", "frame_field", "frame_field_tables", "sphere_map", "sphere_map_tables", "sphere_map_figures", "sphere_map_uses",
                  "tetrahedra", "untangle", "untangle_tables", "polycube", "polycube_tables", "polycube_figures", "correspondence", "study", "study_figures", "volume_map", "volume_map_figures",
                  "hexmesh"],
    "Languages": ["cpp", "python", "rust", "julia", "javascript", "blender"],
    "How it is kept": ["architecture", "abi", "trust"],
}


def menu(folder):
    pages = sorted(name[:-3] for name in os.listdir(folder) if name.endswith(".md") and name != "index.md")
    named = {page for part in PARTS.values() for page in part}
    parts = {title: [page for page in part if page in pages] for title, part in PARTS.items()}
    parts["How it is kept"] += [page for page in pages if page not in named]
    return "".join("\n```{toctree}\n:hidden:\n:caption: " + title + "\n\n" + "\n".join(part) + "\n```\n"
                   for title, part in parts.items())


def prepared(app, name, source):
    """Pages are read in the tree as well: links to what lies outside of docs/ become words here, and the menu is added."""
    parts = re.split(r"(^```.*?^```)", source[0], flags=re.MULTILINE | re.DOTALL)
    for i in range(0, len(parts), 2):
        parts[i] = re.sub(r"(?<!!)\[([^\]]*)\]\(\.\./[^)]*\)", r"\1", parts[i])
    source[0] = "".join(parts) + (menu(app.srcdir) if name == "index" else "")


def setup(app):
    app.connect("source-read", prepared)
