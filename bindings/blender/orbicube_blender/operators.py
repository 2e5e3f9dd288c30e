"""The operators, their menu and their panel."""

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty

from .meshes import Shape, basis_of, loop_triangles, new_object, set_attribute, set_shape_key

SPHERE_DIRECTION, PATCH, SCALED_JACOBIAN = "sphere_direction", "polycube_patch", "scaled_jacobian"


class _Operator:
    """Runs `work` with the library, and shows what it refuses as an error of Blender."""

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT" and context.object is not None and context.object.type == "MESH"

    def execute(self, context):
        try:
            import orbicube
        except ImportError as error:
            self.report({"ERROR"}, f"The Python package orbicube cannot be imported: {error}")
            return {"CANCELLED"}
        window = context.window_manager
        window.progress_begin(0, 1)

        def progress(phase, done, total, best):
            window.progress_update(done / total if total else 0)

        try:
            self.report({"INFO"}, self.work(context, progress))
            return {"FINISHED"}
        except (orbicube.Error, ImportError, ValueError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        finally:
            window.progress_end()


class SphereMap(_Operator, bpy.types.Operator):
    """Map a closed surface of genus 0 to a sphere, as a shape key and an attribute of its vertices"""

    bl_idname, bl_label = "object.orbicube_sphere_map", "Sphere Map"
    angle_weight: FloatProperty(name="Angle Weight", default=0.1, min=0, soft_max=10,
                                description="Weight of angles against that of areas, which is 1; 0 for areas alone")

    def work(self, context, progress):
        from orbicube import sphere_map

        shown, mesh = context.object, context.object.data
        positions, (triangles, _) = basis_of(mesh), loop_triangles(mesh)
        result = sphere_map.compute((positions, triangles), angle_weight=self.angle_weight, progress=progress)
        directions = sphere_map.round_to_float((positions, triangles), result.directions)
        a, b, c = (positions[triangles[:, k]] for k in range(3))
        areas = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
        center = areas @ (a + b + c) / (3 * areas.sum())
        set_shape_key(shown, "Sphere", center + np.sqrt(areas.sum() / (4 * np.pi)) * directions)
        set_attribute(mesh, SPHERE_DIRECTION, "FLOAT_VECTOR", "POINT", "vector", directions)
        mesh.update()
        return f"Sphere map: mean quasi-conformal distortion {result.report.mean_quasi_conformal:.3f}"


def _add_grid_material(made, size):
    """Adds a material that shows a numbered grid, by which a person sees how textures lie."""
    image = bpy.data.images.new(made.name, size, size)
    image.generated_type = "UV_GRID"
    material = bpy.data.materials.new(made.name)
    material.use_nodes = True
    nodes = material.node_tree.nodes
    texture = nodes.new("ShaderNodeTexImage")
    texture.image, texture.location = image, (-300, 300)
    shader = next(node for node in nodes if node.type == "BSDF_PRINCIPLED")
    material.node_tree.links.new(texture.outputs["Color"], shader.inputs["Base Color"])
    made.data.materials.append(material)


class PolycubeUVs(_Operator, bpy.types.Operator):
    """Add an object with texture coordinates by a polycube: its patches packed into the square, and the polycube as a shape key"""

    bl_idname, bl_label = "object.orbicube_polycube_uvs", "Polycube UVs"
    corners: IntProperty(name="Corners", default=100, min=0, description="Maximum number of corners of the polycube; 0 for no limit")
    size: IntProperty(name="Texels", default=1024, min=1, max=16384, description="Texels along each side of the texture")
    padding: FloatProperty(name="Padding", default=4, min=0, description="Minimum distance of two patches in texels")
    grid: BoolProperty(name="Grid Texture", default=True, description="Add a material with a numbered grid, where the object has none")

    def work(self, context, progress):
        from orbicube import polycube

        source = context.object
        shape = Shape(context, source)
        map = polycube.compute((shape.positions, shape.triangles), corners=self.corners, progress=progress)
        atlas = map.atlas(size=self.size, padding=self.padding, progress=progress)
        _, patches, sources = map.of_triangles()
        made = new_object(context, source, source.name + " polycube", map.positions, map.triangles)
        mesh = made.data
        # Blender's v goes up.
        layer = mesh.uv_layers.new(name="Polycube")
        layer.data.foreach_set("uv", (atlas.coordinates * (1, -1) + (0, 1)).astype(np.float32).ravel())
        set_attribute(mesh, PATCH, "INT", "FACE", "value", patches.astype(np.int32))
        mesh.polygons.foreach_set("material_index", shape.materials[sources])
        mesh.polygons.foreach_set("use_smooth", shape.smooth[sources])
        _mark_seams(mesh, patches)
        set_shape_key(made, "Polycube", map.polycube)
        for slot in source.material_slots:
            mesh.materials.append(slot.material)
        if self.grid and not source.material_slots:
            _add_grid_material(made, self.size)
        mesh.update()
        return f"Polycube: {map.corner_count} corners, {map.patch_count} patches, {100 * atlas.coverage:.0f} % of the texture used"


def _mark_seams(mesh, patches):
    """Marks the edges between two patches as seams."""
    edges = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get("edge_index", edges)
    low, high = np.full(len(mesh.edges), np.iinfo(np.int32).max), np.full(len(mesh.edges), -1)
    of_loops = np.repeat(patches.astype(np.int64), 3)
    np.minimum.at(low, edges, of_loops)
    np.maximum.at(high, edges, of_loops)
    mesh.edges.foreach_set("use_seam", low < high)


class Morph(_Operator, bpy.types.Operator):
    """Add an object that morphs from the active object to the other selected ones, by shape keys on one triangulation"""

    bl_idname, bl_label = "object.orbicube_morph", "Morph"
    via: EnumProperty(name="Through", default="sphere", items=[
        ("sphere", "Sphere", "Surfaces of genus 0"), ("polycube", "Polycube", "Surfaces of one genus, up to ten")])
    at_origins: BoolProperty(name="Join Origins", default=True,
                             description="Move the origins of all objects to that of the active one, so that a morph stays in its place")

    @classmethod
    def poll(cls, context):
        return super().poll(context) and sum(shown.type == "MESH" for shown in context.selected_objects) >= 2

    def work(self, context, progress):
        from orbicube import correspondence

        first = context.object
        shapes = [first] + [shown for shown in context.selected_objects if shown.type == "MESH" and shown != first]
        surfaces = [self.surface_of(context, shown, first) for shown in shapes]
        both = correspondence.Correspondence(surfaces, via=self.via, progress=progress)
        made = new_object(context, first, first.name + " morph", both.positions(0), both.triangles)
        for i, shown in enumerate(shapes[1:], 1):
            set_shape_key(made, shown.name, both.positions(i))
        return f"Morph: {len(shapes)} shapes, {len(both.triangles)} triangles"

    def surface_of(self, context, shown, first):
        """Returns positions, in the space of the first object, and triangles."""
        shape = Shape(context, shown)
        if shown == first:
            return shape.positions, shape.triangles
        to_first = np.array(first.matrix_world.inverted() @ shown.matrix_world)
        positions = shape.positions @ to_first[:3, :3].T
        return positions if self.at_origins else positions + to_first[:3, 3], shape.triangles


class Hexahedra(_Operator, bpy.types.Operator):
    """Add an object with a hexahedral mesh of the solid that a closed surface bounds, shown as wires"""

    bl_idname, bl_label = "object.orbicube_hexahedra", "Hexahedra"
    cells: IntProperty(name="Hexahedra", default=2000, min=1, soft_max=100000, description="Approximate number of hexahedra")
    max_hausdorff_percent: FloatProperty(name="Distance", default=1, min=0, max=100, description=(
        "Maximum distance to the surface in percent of the diagonal, for which more hexahedra are tried; 0 for any distance"))

    def work(self, context, progress):
        from orbicube import hexmesh

        source = context.object
        shape = Shape(context, source)
        result = hexmesh.fill_with_hexahedra((shape.positions, shape.triangles), cells=self.cells,
                                             max_hausdorff_percent=self.max_hausdorff_percent, progress=progress)
        made = new_object(context, source, source.name + " hexahedra", result.positions, result.quads,
                          _edges_of(result.hexahedra))
        made.display_type = "WIRE"
        made["hexahedra"] = len(result.hexahedra)
        set_attribute(made.data, SCALED_JACOBIAN, "FLOAT", "POINT", "value", _corner_quality(result).astype(np.float32))
        made.data.update()
        return f"{len(result.hexahedra)} hexahedra, minimum scaled Jacobian {result.report.min_scaled_jacobian:.3f}"


def _edges_of(hexahedra):
    """Returns each edge of hexahedra once."""
    ends = np.concatenate([hexahedra[:, [i, j]] for i, j in
                           ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))])
    return np.unique(np.sort(ends, axis=1), axis=0)


# The neighbors of each corner of a hexahedron, counter-clockwise seen from outside.
_NEIGHBORS = ((1, 3, 4), (2, 0, 5), (3, 1, 6), (0, 2, 7), (7, 5, 0), (4, 6, 1), (5, 7, 2), (6, 4, 3))


def _corner_quality(result):
    """Returns the least scaled Jacobian of the corners at each vertex."""
    least = np.ones(len(result.positions))
    for corner, neighbors in enumerate(_NEIGHBORS):
        at = result.positions[result.hexahedra[:, corner]]
        edges = np.stack([result.positions[result.hexahedra[:, k]] - at for k in neighbors], axis=1)
        scaled = np.linalg.det(edges) / np.prod(np.linalg.norm(edges, axis=2), axis=1)
        np.minimum.at(least, result.hexahedra[:, corner], scaled)
    return least


_OPERATORS = (SphereMap, PolycubeUVs, Morph, Hexahedra)


def _draw(self, context):
    for operator in _OPERATORS:
        self.layout.operator(operator.bl_idname)


class Menu(bpy.types.Menu):
    bl_idname, bl_label = "OBJECT_MT_orbicube", "Orbicube"
    draw = _draw


class Panel(bpy.types.Panel):
    bl_idname, bl_label = "VIEW3D_PT_orbicube", "Orbicube"
    bl_space_type, bl_region_type, bl_category = "VIEW_3D", "UI", "Orbicube"
    draw = _draw


def _draw_menu(self, context):
    self.layout.menu(Menu.bl_idname)


def register():
    for registered in (*_OPERATORS, Menu, Panel):
        bpy.utils.register_class(registered)
    bpy.types.VIEW3D_MT_object.append(_draw_menu)


def unregister():
    bpy.types.VIEW3D_MT_object.remove(_draw_menu)
    for registered in reversed((*_OPERATORS, Menu, Panel)):
        bpy.utils.unregister_class(registered)
