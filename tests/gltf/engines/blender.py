# Imports each file into Blender and prints one line of JSON for it: what is in its first mesh with triangles.
#
#   blender --background --factory-startup --python blender.py -- FILE...
import json
import sys

import bpy
import numpy

# The importer of Blender 3.4 asks for a name that Debian 12's numpy has no longer.
if "bool" not in vars(numpy):
    numpy.bool = bool
for path in sys.argv[sys.argv.index("--") + 1:]:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=path)
    mesh = next(o.data for o in bpy.context.scene.objects if o.type == "MESH" and o.data.polygons)
    keys = mesh.shape_keys.key_blocks[1:] if mesh.shape_keys else []
    print("IMPORTED " + json.dumps({
        "path": path,
        "vertices": len(mesh.vertices),
        "triangles": len(mesh.polygons),
        "morphTargets": [key.name for key in keys],
        "moved": [max((a.co - b.co).length for a, b in zip(key.data, mesh.vertices)) for key in keys],
        "uv": len(mesh.uv_layers) > 0,
    }))
