"""Installs the add-on in Blender, runs its operators on shapes, and saves the scene.

    blender --background --factory-startup --python make_scene.py -- ADDON.zip SCENE.blend
"""

import os
import sys

import bpy
import numpy as np

addon, scene = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.preferences.addon_install(filepath=addon)
assert bpy.ops.preferences.addon_enable(module="orbicube_blender") == {"FINISHED"}

import orbicube  # noqa: E402: of the add-on
from orbicube import mesh  # noqa: E402

assert os.path.join("orbicube_blender", "packages") in orbicube.__file__, orbicube.__file__


def add(name, positions, polygons, location=(0, 0, 0)):
    made = bpy.data.meshes.new(name)
    made.from_pydata(np.asarray(positions).tolist(), [], np.asarray(polygons).tolist())
    made.update()
    shown = bpy.data.objects.new(name, made)
    shown.location = location
    bpy.context.collection.objects.link(shown)
    return shown


def add_made(shape, triangles, location):
    made = mesh.make(shape, triangles)
    return add(shape, made.positions, made.triangles, location)


def run(operator, *objects, **options):
    """Runs an operator on objects, of which the first is the active one, and returns the active object after it."""
    bpy.ops.object.select_all(action="DESELECT")
    for shown in objects:
        shown.select_set(True)
    bpy.context.view_layer.objects.active = objects[0]
    bpy.context.view_layer.update()
    assert getattr(bpy.ops.object, operator)(**options) == {"FINISHED"}, operator
    return bpy.context.object


def refusal(operator, *objects, **options):
    try:
        run(operator, *objects, **options)
    except RuntimeError as error:
        return str(error)
    raise AssertionError(operator + " refused nothing")


creature, bracket = add_made("creature", 2000, (0, 0, 0)), add_made("bracket", 2000, (5, 0, 0))
star = add_made("star", 1000, (0, 5, 0))
star.rotation_euler, star.scale = (0.3, 0.2, 1), (1.5, 1.5, 1.5)
for material in ("steel", "paint"):
    creature.data.materials.append(bpy.data.materials.new(material))
materials = np.arange(len(creature.data.polygons)) % 2
creature.data.polygons.foreach_set("material_index", materials.astype(np.int32))

assert run("orbicube_sphere_map", creature) is creature
assert run("orbicube_sphere_map", creature, angle_weight=1) is creature  # in place of the first
run("orbicube_polycube_uvs", bracket, size=512, padding=6)
# Quads and a modifier: what the object shows is mapped, and materials are kept.
bpy.ops.mesh.primitive_cube_add(location=(10, 0, 0))
cube = bpy.context.object
cube.name = "cube"
cube.modifiers.new("finer", "SUBSURF").levels = 3
cube.data.materials.append(bpy.data.materials.new("wood"))
run("orbicube_polycube_uvs", cube)
run("orbicube_morph", creature, star)
run("orbicube_morph", star, creature, via="polycube", at_origins=False).name = "star morph by polycube"
run("orbicube_hexahedra", bracket, cells=500, max_hausdorff_percent=0)

# What the library refuses is an error, and leaves the scene as it was.
before = len(bpy.data.objects)
square = add("square", [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2, 3)])
for operator in ("orbicube_sphere_map", "orbicube_polycube_uvs", "orbicube_hexahedra"):
    assert "closed" in refusal(operator, square), operator
assert not square.data.shape_keys
assert "genus" in refusal("orbicube_sphere_map", bracket)
assert len(bpy.data.objects) == before + 1
bpy.ops.object.select_all(action="DESELECT")
bpy.context.view_layer.objects.active = creature
creature.select_set(True)
assert not bpy.ops.object.orbicube_morph.poll()

bpy.ops.wm.save_as_mainfile(filepath=scene)
assert bpy.ops.preferences.addon_disable(module="orbicube_blender") == {"FINISHED"}
assert not hasattr(bpy.types, "OBJECT_MT_orbicube")
print("make_scene.py has passed")
