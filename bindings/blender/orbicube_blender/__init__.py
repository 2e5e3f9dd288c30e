"""Orbicube in Blender: maps to the sphere, texture coordinates through polycubes, morphs and hexahedra of mesh objects.

Operators are in the menu Object > Orbicube and in the sidebar of the 3D view. docs/blender.md of Orbicube describes them.
"""

import os
import sys

bl_info = {
    "name": "Orbicube",
    "description": "Sphere maps, polycube texture coordinates, morphs and hexahedral meshes",
    "author": "The Orbicube authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "Object > Orbicube, and 3D View > Sidebar > Orbicube",
    "category": "Object",
}

# The Python package that the zip file of the add-on carries; one that Blender's Python has already comes after it, since its version
# may be another.
_packages = os.path.join(os.path.dirname(os.path.abspath(__file__)), "packages")
if os.path.isdir(_packages) and _packages not in sys.path:
    sys.path.insert(0, _packages)

from . import operators  # noqa: E402: it needs the path


def register():
    operators.register()


def unregister():
    operators.unregister()
