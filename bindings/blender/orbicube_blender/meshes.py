"""Arrays of mesh objects, and objects made of arrays."""

import bpy
import numpy as np


def loop_triangles(mesh):
    """Returns the triangles that Blender draws a mesh with, and the polygon that each is of."""
    mesh.calc_loop_triangles()
    count = len(mesh.loop_triangles)
    triangles, polygons = np.empty(3 * count, np.int32), np.empty(count, np.int32)
    mesh.loop_triangles.foreach_get("vertices", triangles)
    mesh.loop_triangles.foreach_get("polygon_index", polygons)
    return triangles.reshape(-1, 3).astype(np.uint32), polygons


def positions_of(points):
    """Returns the coordinates of vertices, or of the points of a shape key, as doubles."""
    positions = np.empty(3 * len(points), np.float32)
    points.foreach_get("co", positions)
    return positions.reshape(-1, 3).astype(float)


def basis_of(mesh):
    """Returns the positions of a mesh without its shape keys."""
    return positions_of(mesh.shape_keys.reference_key.data if mesh.shape_keys else mesh.vertices)


class Shape:
    """The surface that an object shows, with its modifiers: positions, triangles, and the material and shading of each triangle."""

    def __init__(self, context, shown):
        evaluated = shown.evaluated_get(context.evaluated_depsgraph_get())
        mesh = evaluated.to_mesh()
        try:
            self.positions = positions_of(mesh.vertices)
            self.triangles, polygons = loop_triangles(mesh)
            materials, smooth = np.empty(len(mesh.polygons), np.int32), np.empty(len(mesh.polygons), bool)
            mesh.polygons.foreach_get("material_index", materials)
            mesh.polygons.foreach_get("use_smooth", smooth)
            self.materials, self.smooth = materials[polygons], smooth[polygons]
        finally:
            evaluated.to_mesh_clear()


def new_object(context, source, name, positions, polygons, edges=()):
    """Adds an object beside its source, selects it and makes it active. Returns it; its vertices are numbered as the positions."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(np.asarray(positions).tolist(), np.asarray(edges).tolist(), np.asarray(polygons).tolist())
    mesh.update()
    made = bpy.data.objects.new(name, mesh)
    made.matrix_world = source.matrix_world
    (source.users_collection[0] if source.users_collection else context.collection).objects.link(made)
    for other in context.selected_objects:
        other.select_set(False)
    made.select_set(True)
    context.view_layer.objects.active = made
    return made


def set_shape_key(shown, name, positions):
    """Sets a shape key of an object, which is added where it has none of that name, and returns it."""
    if not shown.data.shape_keys:
        shown.shape_key_add(name="Basis", from_mix=False)
    key = shown.data.shape_keys.key_blocks.get(name) or shown.shape_key_add(name=name, from_mix=False)
    key.data.foreach_set("co", np.asarray(positions, np.float32).ravel())
    return key


def set_attribute(mesh, name, kind, domain, member, values):
    """Sets an attribute of a mesh, in place of one of that name."""
    if name in mesh.attributes:
        mesh.attributes.remove(mesh.attributes[name])
    attribute = mesh.attributes.new(name, kind, domain)
    attribute.data.foreach_set(member, np.ravel(values))
