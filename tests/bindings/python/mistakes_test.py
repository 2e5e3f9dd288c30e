"""Every public function refuses the mistakes that people make, by the name that its argument has in the signature."""

import importlib
import inspect
import math
import os
import re
import tempfile
import unittest

import numpy as np
import orbicube
from solids import HAS_TETRAHEDRA, box_of_tetrahedra
from orbicube import (correspondence, frame_field, gltf, harmonics, hexmesh, linear, mesh, polycube, projected_gradient, quaternion,
                      repair, sphere_map, sphere_optimizer, trust_region, untangle, volume_map)
from orbicube._options import OPTIONS

FOLDER = tempfile.TemporaryDirectory()
CUBE = mesh.make("cube", 100)
SURFACE = (np.array(CUBE.positions), np.array(CUBE.triangles))
DIRECTIONS = SURFACE[0] / np.linalg.norm(SURFACE[0], axis=1)[:, None]
SOLID = box_of_tetrahedra(1)
FLAT = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
Q, V = np.array([1.0, 0, 0, 0]), np.array([1.0, 2, 3])
COEFFICIENTS = np.ones((9, 3)) + np.arange(27).reshape(9, 3)
MAP = polycube.compute(CUBE)
ATLAS = MAP.atlas(size=16)
BOTH = correspondence.Correspondence([CUBE, CUBE], align="none")
LOCATOR = sphere_map.Locator(SURFACE, DIRECTIONS)
PIXELS = LOCATOR.image(SURFACE[0], "octahedron", 4)
WARP = sphere_map.Warp([[0, 0, 1.0]], [[0, 0.1, 1.0]])
SEARCH = mesh.Search(SURFACE)
IN_SOLID = volume_map.Locator(SOLID)
MAP_OF_SOLID = volume_map.PiecewiseLinearMap(SOLID[0], 2 * SOLID[0], SOLID[1])
FRAMES = np.tile(Q, (len(SOLID[1]), 1))
ROWS = np.eye(3)[:2]
SYSTEM = [[2.0, -1.0], [-1.0, 2.0]]


def path(name):
    return os.path.join(FOLDER.name, name)


mesh.write(path("a.ply"), SURFACE)
gltf.write(path("a.glb"), SURFACE)
sphere_map.write_image(path("a.pfm"), PIXELS, "octahedron", 4)
harmonics.write(path("a.coef"), COEFFICIENTS)


def contents(name):
    with open(path(name), "rb") as file:
        return file.read()


def square(x):
    return float((x ** 2).sum()), 2 * x


def height(i, place, points, derivatives):
    return (place[0], np.array([1.0, 0, 0])) if derivatives else place[0]


# "module.function": (function, arguments that are fine, without options)
CALLS = {
    "frame_field.compute": (frame_field.compute, {"solid": SOLID, "held_frames": ([0], [Q]), "held_axes": ([1], [Q[:3]])}),
    "frame_field.measure": (frame_field.measure, {"solid": SOLID, "frames": FRAMES}),
    "frame_field.matchings": (frame_field.matchings, {"solid": SOLID, "frames": FRAMES}),
    "frame_field.Singularities": (frame_field.Singularities, {"solid": SOLID, "frames": FRAMES}),
    "gltf.read": (gltf.read, {"path": path("a.glb")}),
    "gltf.read_memory": (gltf.read_memory, {"data": contents("a.glb"), "folder": FOLDER.name}),
    "gltf.write_kept": (gltf.write_kept, {"path": path("c.glb"), "surface": gltf.read(path("a.glb"), keep=True)}),
    "gltf.write": (gltf.write, {
        "path": path("b.glb"), "surface": SURFACE, "morph_targets": {"sphere": DIRECTIONS}, "normals": DIRECTIONS,
        "texture_coordinates": DIRECTIONS[:, :2], "colors": np.full((len(DIRECTIONS), 4), 9), "edges": [[0, 1]],
        "translation": V, "base_color": Q, "name": "a", "extras": {}}),
    "gltf.delta": (gltf.delta, {"base": 1.0, "wanted": 2.0}),
    "gltf.reconstructed": (gltf.reconstructed, {"base": 1.0, "stored": 2.0}),
    "harmonics.degree_of": (harmonics.degree_of, {"coefficients": COEFFICIENTS}),
    "harmonics.evaluate": (harmonics.evaluate, {"directions": DIRECTIONS, "degree": 3}),
    "harmonics.fit": (harmonics.fit, {"directions": DIRECTIONS, "values": SURFACE[0], "weights": np.ones(len(DIRECTIONS)),
                                      "degree": 2}),
    "harmonics.refine_map": (harmonics.refine_map, {"surface": SURFACE, "directions": DIRECTIONS, "weights": np.ones(len(DIRECTIONS)),
                                                    "rounds": 1, "degree": 2}),
    "harmonics.synthesize": (harmonics.synthesize, {"coefficients": COEFFICIENTS, "directions": DIRECTIONS}),
    "harmonics.analyze": (harmonics.analyze, {"directions": DIRECTIONS, "values": SURFACE[0], "degree": 3,
                                              "weights": np.ones(len(DIRECTIONS))}),
    "harmonics.gradients": (harmonics.gradients, {"coefficients": COEFFICIENTS, "directions": DIRECTIONS}),
    "mesh.vertex_areas": (mesh.vertex_areas, {"surface": SURFACE}),
    "harmonics.degree_norms": (harmonics.degree_norms, {"coefficients": COEFFICIENTS}),
    "harmonics.shape_distance": (harmonics.shape_distance, {"f": COEFFICIENTS, "g": COEFFICIENTS, "first": 0, "last": 2}),
    "harmonics.filter": (harmonics.filter, {"coefficients": COEFFICIENTS, "low": 0, "high": 1}),
    "mesh.mean_distance": (mesh.mean_distance, {"a": DIRECTIONS, "b": DIRECTIONS}),
    "harmonics.rotate": (harmonics.rotate, {"coefficients": COEFFICIENTS, "rotation": np.eye(3)}),
    "harmonics.align": (harmonics.align, {"fixed": COEFFICIENTS, "moving": COEFFICIENTS}),
    "harmonics.write": (harmonics.write, {"path": path("b.coef"), "coefficients": COEFFICIENTS}),
    "harmonics.read": (harmonics.read, {"path": path("a.coef")}),
    "linear.Direct": (linear.Direct, {"A": SYSTEM}),
    "linear.Direct.solve": (lambda: linear.Direct(SYSTEM).solve, {"b": [1.0, 2.0]}),
    "linear.Direct.refactor": (lambda: linear.Direct(SYSTEM).refactor, {"A": SYSTEM}),
    "linear.Direct.remove_row": (lambda: linear.Direct(SYSTEM).remove_row, {"row": 1}),
    "linear.Direct.update": (lambda: linear.Direct(SYSTEM).update, {"rows": [0, 1], "values": [1.0, 2.0]}),
    "linear.Iterative": (linear.Iterative, {"A": SYSTEM}),
    "linear.Iterative.solve": (lambda: linear.Iterative(SYSTEM).solve, {"b": [1.0, 2.0]}),
    "mesh.Mesh": (mesh.Mesh, {"positions": SOLID[0], "triangles": [[0, 1, 2]], "tetrahedra": SOLID[1],
                              "hexahedra": [[0, 1, 3, 2, 4, 5, 7, 6]]}),
    "mesh.Mesh.boundary": (mesh.Mesh(SOLID[0], tetrahedra=SOLID[1]).boundary, {}),
    "correspondence.Correspondence.positions": (BOTH.positions, {"shape": 0}),
    "correspondence.Correspondence.map": (BOTH.map, {"source": 0, "target": 1, "triangles": [0, 1], "weights": [[0.2, 0.3, 0.5], [1, 0, 0]]}),
    "correspondence.Correspondence.blend": (BOTH.blend, {"weights": [0.5, 0.5]}),
    "mesh.Search": (mesh.Search, {"surface": SURFACE}),
    "mesh.Search.vertices": (SEARCH.vertices, {"points": DIRECTIONS}),
    "mesh.Search.surface": (SEARCH.surface, {"points": DIRECTIONS}),
    "mesh.make": (mesh.make, {"shape": "torus", "triangle_count": 100}),
    "mesh.read": (mesh.read, {"path": path("a.ply")}),
    "mesh.read_memory": (mesh.read_memory, {"data": contents("a.ply"), "format": "ply"}),
    "mesh.write": (mesh.write, {"path": path("b.ply"), "mesh": SURFACE}),
    "mesh.topology": (mesh.topology, {"surface": SURFACE}),
    "mesh.check_closed_genus_zero": (mesh.check_closed_genus_zero, {"surface": SURFACE}),
    "mesh.check_cells": (mesh.check_cells, {"mesh": SURFACE}),
    "mesh.tetrahedron_quality": (mesh.tetrahedron_quality, {"mesh": SURFACE}),
    "mesh.orient": (mesh.orient, {"surface": SURFACE}),
    "mesh.first_at_same_position": (mesh.first_at_same_position, {"positions": SURFACE[0]}),
    "mesh.intersections": (mesh.intersections, {"surface": SURFACE, "capacity": 10}),
    "mesh.orientation_2d": (mesh.orientation_2d, {"a": V[:2], "b": V[:2], "c": V[:2]}),
    "mesh.orientation_3d": (mesh.orientation_3d, {"a": V, "b": V, "c": V, "d": V}),
    "mesh.orientation_from_origin": (mesh.orientation_from_origin, {"p": V, "q": V, "r": V}),
    "polycube.Polycube.optimize_domain": (MAP.optimize_domain, {}),
    "polycube.Polycube.optimize_corners": (MAP.optimize_corners, {"rounds": 1}),
    "polycube.Polycube.align_features": (MAP.align_features, {
        "vertices": [0], "targets": MAP.polycube[:1], "weights": [1.0], "curves": []}),
    "polycube.Polycube.graph": (MAP.graph, {}),
    "polycube.Polycube.quads": (MAP.quads, {"quads": 50}),
    "polycube.Polycube.atlas": (MAP.atlas, {"size": 32}),
    "polycube.Atlas.sample": (ATLAS.sample, {}),
    "polycube.Atlas.texture": (ATLAS.texture, {"values": MAP.positions}),
    "polycube.Graph": (polycube.Graph, {"map": MAP}),
    "polycube.compute": (polycube.compute, {"surface": SURFACE}),
    "polycube.certify": (polycube.certify, {"surface": (MAP.positions, MAP.triangles), "polycube": MAP.polycube}),
    "polycube.map_to_domain": (polycube.map_to_domain, {"surface": SURFACE, "polycube": (MAP.polycube, MAP.triangles)}),
    "polycube.compute_common": (polycube.compute_common, {"surfaces": [SURFACE, SURFACE], "domain": {"area_weight": 1.0}}),
    "polycube.optimize_common_domain": (polycube.optimize_common_domain, {"maps": [MAP]}),
    "projected_gradient.minimize": (projected_gradient.minimize, {
        "f": square, "x0": [1.0, 2.0], "lower": [-1, -1], "upper": [4, 4], "A": [[1.0, 1.0]], "b": [3.0]}),
    "projected_gradient.check_gradient": (projected_gradient.check_gradient, {
        "f": square, "x0": [1.0, 2.0], "lower": [-1, -1], "upper": [4, 4]}),
    "projected_gradient.project": (projected_gradient.project, {
        "y": [1.0, 2.0], "lower": [-1, -1], "upper": [4, 4], "A": [[1.0, 1.0]], "b": [3.0]}),
    "projected_gradient.Solver": (projected_gradient.Solver, {
        "x0": [1.0, 2.0], "lower": [-1, -1], "upper": [4, 4], "A": [[1.0, 1.0]], "b": [3.0]}),
    "repair.repair": (repair.repair, {"surface": SURFACE}),
    "repair.surface_of_label": (repair.surface_of_label, {"labels": np.pad(np.ones((3, 3, 3), dtype=np.int32), 1)}),
    "projected_gradient.Solver.load": (projected_gradient.Solver.load, {
        "blob": projected_gradient.Solver([1.0, 2.0], lower=[-1, -1], upper=4, A=[[1.0, 1.0]], b=[3.0]).save(),
        "x0": [1.0, 2.0], "lower": [-1, -1], "upper": [4, 4], "A": [[1.0, 1.0]], "b": [3.0]}),
    "projected_gradient.Solver.run": (lambda: projected_gradient.Solver([1.0, 2.0]).run, {"f": square}),
    "sphere_map.compute": (sphere_map.compute, {"surface": SURFACE}),
    "sphere_map.compute_partial": (sphere_map.compute_partial, {"surface": SURFACE}),
    "sphere_map.measure": (sphere_map.measure, {"surface": SURFACE, "directions": DIRECTIONS}),
    "sphere_map.face_distortion": (sphere_map.face_distortion, {"surface": SURFACE, "directions": DIRECTIONS}),
    "sphere_map.round_to_float": (sphere_map.round_to_float, {"surface": SURFACE, "directions": DIRECTIONS}),
    "mesh.vertex_normals": (mesh.vertex_normals, {"surface": SURFACE}),
    "sphere_map.grid": (sphere_map.grid, {"name": "icosphere", "resolution": 2}),
    "mesh.surface_distance": (mesh.surface_distance, {"first": SURFACE, "second": SURFACE}),
    "sphere_map.image_size": (sphere_map.image_size, {"layout": "octahedron", "resolution": 4}),
    "sphere_map.image_surface": (sphere_map.image_surface, {"pixels": PIXELS, "layout": "octahedron", "resolution": 4}),
    "sphere_map.write_image": (sphere_map.write_image, {"path": path("b.pfm"), "pixels": PIXELS, "layout": "octahedron",
                                                        "resolution": 4}),
    "sphere_map.read_image": (sphere_map.read_image, {"path": path("a.pfm")}),
    "sphere_map.best_rotation": (sphere_map.best_rotation, {"start": DIRECTIONS, "end": DIRECTIONS}),
    "sphere_map.overlay": (sphere_map.overlay, {"first": SURFACE, "first_directions": DIRECTIONS, "second": SURFACE,
                                                "second_directions": DIRECTIONS}),
    "sphere_map.Locator": (sphere_map.Locator, {"surface": SURFACE, "directions": DIRECTIONS}),
    "sphere_map.Locator.locate": (LOCATOR.locate, {"directions": DIRECTIONS}),
    "sphere_map.Locator.sample": (LOCATOR.sample, {"directions": DIRECTIONS, "values": SURFACE[0]}),
    "sphere_map.Locator.remesh": (LOCATOR.remesh, {"positions": SURFACE[0], "grid": "cube", "resolution": 4}),
    "sphere_map.Locator.image": (LOCATOR.image, {"positions": SURFACE[0], "layout": "cube", "resolution": 4}),
    "sphere_map.Warp": (sphere_map.Warp, {"start": [[0, 0, 1.0]], "end": [[0, 0.1, 1.0]]}),
    "sphere_map.Warp.apply": (WARP.apply, {"directions": DIRECTIONS}),
    "sphere_optimizer.minimize": (sphere_optimizer.minimize, {"f": lambda x: (x[:, 2].sum(), np.tile([0, 0, 1.0], (2, 1))),
                                                              "x0": ROWS}),
    "sphere_optimizer.Solver": (sphere_optimizer.Solver, {"x0": ROWS}),
    "sphere_optimizer.Solver.load": (sphere_optimizer.Solver.load, {"blob": sphere_optimizer.Solver(ROWS).save()}),
    "sphere_optimizer.Solver.run": (lambda: sphere_optimizer.Solver(ROWS).run, {
        "f": lambda x: (x[:, 2].sum(), np.tile([0, 0, 1.0], (2, 1)))}),
    "sphere_optimizer.relax": (sphere_optimizer.relax, {"f": height, "x0": ROWS, "neighbors": [[1], [0]]}),
    "sphere_optimizer.Relaxation": (sphere_optimizer.Relaxation, {"x0": ROWS, "neighbors": [[1], [0]]}),
    "sphere_optimizer.Relaxation.load": (sphere_optimizer.Relaxation.load, {
        "blob": sphere_optimizer.Relaxation(ROWS, [[1], [0]]).save(), "x0": ROWS, "neighbors": [[1], [0]]}),
    "sphere_optimizer.Relaxation.run": (lambda: sphere_optimizer.Relaxation(ROWS, [[1], [0]]).run, {"f": height, "steps": 3}),
    "trust_region.minimize": (trust_region.minimize, {"f": lambda x: float(x @ x), "x0": [1.0, 2.0], "lower": [-1, -1],
                                                      "upper": [4, 4], "scale": [1, 2]}),
    "trust_region.least_squares": (trust_region.least_squares, {
        "residuals": lambda x: x, "x0": [1.0, 2.0], "count": 2, "lower": [-1, -1], "upper": [4, 4], "scale": [1, 2],
        "sign": [1, 1]}),
    "trust_region.minimize_residuals": (trust_region.minimize_residuals, {
        "residuals": lambda x: x, "x0": [1.0, 2.0], "count": 2, "objective": "max-magnitude", "lower": [-1, -1], "upper": [4, 4],
        "scale": [1, 2]}),
    "trust_region.Solver": (trust_region.Solver, {"x0": [1.0, 2.0], "residuals": 2, "lower": [-1, -1], "upper": [4, 4],
                                                  "scale": [1, 2], "sign": [1, 1]}),
    "trust_region.Solver.load": (trust_region.Solver.load, {
        "blob": trust_region.Solver([1.0, 2.0], lower=-1, upper=4, scale=[1, 2]).save(), "x0": [1.0, 2.0],
        "lower": [-1, -1], "upper": [4, 4], "scale": [1, 2]}),
    "trust_region.Solver.give": (lambda: trust_region.Solver([1.0, 2.0]).give, {"points": [[0, 0], [1, 1]], "outputs": [1, 2]}),
    "trust_region.Solver.run": (lambda: trust_region.Solver([1.0, 2.0]).run, {"f": lambda x: float(x @ x)}),
    "untangle.refine_tetrahedra": (untangle.refine_tetrahedra, {
        "solid": SOLID, "rest": SOLID[0], "fixed": np.ones(len(SOLID[0]), bool),
        "ties": np.full((len(SOLID[0]), 3), 2**32 - 1)}),
    "untangle.refine_triangles": (untangle.refine_triangles, {
        "positions": FLAT, "triangles": [[0, 1, 2], [0, 2, 3]], "rest": FLAT, "fixed": np.ones(4, bool),
        "ties": np.full((4, 2), 2**32 - 1)}),
    "untangle.tetrahedra": (untangle.tetrahedra, {
        "solid": SOLID, "rest": SOLID[0], "fixed": np.ones(len(SOLID[0]), bool),
        "ties": np.full((len(SOLID[0]), 3), 2**32 - 1)}),
    "untangle.triangles": (untangle.triangles, {
        "positions": FLAT, "triangles": [[0, 1, 2], [0, 2, 3]], "rest": FLAT, "fixed": np.ones(4, bool),
        "ties": np.full((4, 2), 2**32 - 1)}),
    "volume_map.map_to_polycube": (volume_map.map_to_polycube, {"solid": SOLID}),
    "volume_map.parameterize": (volume_map.parameterize, {"solid": SOLID, "frames": FRAMES, "cell_length": 0.5}),
    "volume_map.Locator": (volume_map.Locator, {"solid": SOLID}),
    "volume_map.Locator.locate": (IN_SOLID.locate, {"points": SOLID[0]}),
    "volume_map.Locator.sample": (IN_SOLID.sample, {"points": SOLID[0], "values": SOLID[0]}),
    "volume_map.PiecewiseLinearMap": (volume_map.PiecewiseLinearMap, {"positions": SOLID[0], "image": 2 * SOLID[0],
                                                                      "tetrahedra": SOLID[1]}),
    "volume_map.PiecewiseLinearMap.inverse": (MAP_OF_SOLID.inverse, {"points": SOLID[0]}),
    "hexmesh.fill_with_hexahedra": (hexmesh.fill_with_hexahedra, {"shape": SOLID, "frames": FRAMES, "cells": 8}),
}
for name in ("inverse", "normalize", "exponential", "logarithm", "to_axis_angle", "to_rotation_vector", "to_matrix", "average"):
    CALLS["quaternion." + name] = getattr(quaternion, name), {"q": Q}
for name in ("multiply", "symmetric_distance", "symmetric_sine_square"):
    CALLS["quaternion." + name] = getattr(quaternion, name), {"p": Q, "q": Q}
CALLS.update({
    "quaternion.slerp": (quaternion.slerp, {"p": Q, "q": Q, "t": 0.5}),
    "quaternion.rotate": (quaternion.rotate, {"q": Q, "v": V}),
    "quaternion.from_axis_angle": (quaternion.from_axis_angle, {"axis": V, "angle": 0.5}),
    "quaternion.from_rotation_vector": (quaternion.from_rotation_vector, {"v": V}),
    "quaternion.from_matrix": (quaternion.from_matrix, {"matrix": np.eye(3)}),
    "quaternion.nearest_to_matrix": (quaternion.nearest_to_matrix, {"matrix": np.eye(3)}),
    "quaternion.cube_element": (quaternion.cube_element, {"number": 3}),
    "quaternion.cube_matrix": (quaternion.cube_matrix, {"number": 3}),
    "quaternion.cube_product": (quaternion.cube_product, {"a": 3, "b": 4}),
    "quaternion.cube_inverse": (quaternion.cube_inverse, {"a": 3}),
    "quaternion.cube_class": (quaternion.cube_class, {"number": 3}),
    "quaternion.cube_nearest": (quaternion.cube_nearest, {"r": Q}),
    "quaternion.symmetric_matching": (quaternion.symmetric_matching, {"start": Q, "end": Q}),
})
if HAS_TETRAHEDRA:
    CALLS["tetrahedra.fill"] = orbicube.tetrahedra.fill, {"surface": SURFACE, "size_positions": [V], "size_lengths": [1.0]}
    CALLS["tetrahedra.check_surface"] = orbicube.tetrahedra.check_surface, {"surface": SURFACE}

# Classes of results, which people do not make; what is called for each evaluation, and looks at its arguments alone; and
# conversions for packages that need not be there. scipy.optimize calls the methods for it, with its own arguments (scipy_test.py).
NOT_WALKED = {"projected_gradient.scipy_method", "trust_region.scipy_least_squares", "trust_region.scipy_method", "correspondence.Correspondence", "mesh.Format", "mesh.Format.count", "mesh.Format.index", "mesh.Surface", "mesh.adopt", "mesh.handle_of",
              "mesh.to_pyvista", "mesh.Mesh.to_pyvista", "mesh.to_trimesh", "mesh.to_polyscope", "mesh.show", "mesh.Mesh.show", "gltf.Surface", "polycube.Atlas", "polycube.Polycube", "polycube.Quads",
              "projected_gradient.GradientCheck", "projected_gradient.Projection", "repair.LabelSurface", "repair.Repaired", "sphere_map.SphereMap",
              "sphere_optimizer.Relaxed", "tetrahedra.Solid", "untangle.Refined", "volume_map.FrameMap", "volume_map.Solid",
              "hexmesh.Hexes", "hexmesh.MissingFeature"}
EACH_EVALUATION = ("ask", "ask_all", "tell", "tell_product", "save", "close")
NO_MISTAKE = object()


def public_names():
    """All that the modules define and people call, by "module.function" and "module.Class.method"."""
    for library in orbicube._LIBRARIES:
        if library == "tetrahedra" and not HAS_TETRAHEDRA:
            continue
        module = importlib.import_module("orbicube." + library)
        for name, value in vars(module).items():
            if name.startswith("_") or getattr(value, "__module__", "") != module.__name__ or name == "version":
                continue
            if inspect.isclass(value):
                yield f"{library}.{name}"
                for method, function in inspect.getmembers(value, callable):
                    if not method.startswith("_") and method not in EACH_EVALUATION and \
                            len(inspect.signature(function).parameters) > (0 if inspect.ismethod(function) else 1):
                        yield f"{library}.{name}.{method}"
            elif inspect.isfunction(value) and inspect.signature(value).parameters:
                yield f"{library}.{name}"


def surface_mistakes(cells):
    positions, corners = (SURFACE if cells == 3 else SOLID)
    nan = positions.copy()
    nan[1, 2] = math.nan
    empty = np.empty((0, 3)), np.empty((0, cells), int)
    return [None, 3, "shape.obj", empty, (positions, empty[1]), (positions[:, :2], corners), (positions, corners[:, :2]),
            (positions, corners.astype(float)), (positions, corners + 1000), (positions, corners.astype(int) - 1),
            (nan, corners), (positions, corners, corners), (None, corners), ("abc", corners)]


# Of parameters that may be anything, and of arrays of unlike kinds.
BY_NAME = {
    "surface": surface_mistakes(3), "first": surface_mistakes(3), "second": surface_mistakes(3), "mesh": surface_mistakes(3),
    "solid": surface_mistakes(4), "polycube": surface_mistakes(3), "extras": [{1, 2}, object()], "A": ["rows", [[1, 2, 3]], [[1, None]], [[1], [2, 3]],
    [[math.nan, 1]], ([0, 3], [0, 1], [1.0, 1.0]), ([0, 1], [7], [1.0])], "held_frames": [3, ([0],), ([99], [Q]), ([0], [V]), ([0.5], [Q])],
    "held_axes": [3, ([0],), ([99], [V]), ([0], [Q]), ([0], [V], ["much"])], "surfaces": [[], [None], [SURFACE, 3]],
    "maps": [[], [None], [SURFACE]], "domain": [{"measur": "harmonic"}, {"area_weight": "much"}, {"measure": "mean"}],
    "morph_targets": [{"a": "text"}, {"a": V}, {3: DIRECTIONS}], "neighbors": [[[1]], [[1], [2]], [[1], [0.5]], [[1], None]],
    "curves": [[3], [([0, 1], V)], [([0, 99999], V, V)], [([0, 1], V, "there")]], "map": [SURFACE, 3],
}
INTEGERS = {"edges", "colors", "rows", "ties", "vertices", "corners", "triangles", "tetrahedra", "hexahedra"}
ANY_SHAPE = {"x0", "y", "t", "angle", "values", "outputs", "fixed"}


def mistakes(name, annotation):
    """Values that are wrong for a parameter."""
    inner = annotation
    wrong = []
    if annotation.startswith("Optional["):
        inner = annotation[len("Optional["):-1]
    elif annotation not in ("Any", "Progress"):
        wrong.append(None)
    wrong += BY_NAME.get(name, []) if inner.startswith(("Any", "Sequence", "Mapping", "tuple", "Polycube")) else []
    if name == "threads":
        wrong += [-1, 2**32]
    if inner == "int":
        wrong += ["three", 1.5, math.nan, math.inf, [1, 2], 2j, True]
    elif inner == "float":
        wrong += ["much", math.nan, [1.0, 2.0], np.ones(2), 2j, True]
    elif inner == "bool":
        wrong += ["yes", 2, 0.5, [True, False]]
    elif inner == "str":
        wrong += [3, b"bytes", "a\0b"]
    elif inner == "bytes":
        wrong += ["text", 3, [1, 2]]
    elif inner.startswith("Literal["):
        word = re.findall(r"'([^']+)'", inner)[-1]
        wrong += [word[:-1], word + "s", "nothing-like-it", 3, [word]]
    elif inner == "Progress":
        wrong += [3, "yes"]
    elif inner == "PathLike":
        wrong += [3.5, ["a.ply"], "a\0.ply"]
    elif inner.startswith("Callable"):
        wrong += [3, "f", [1.0]]
    elif inner.startswith("Mapping"):
        wrong += [3, [1, 2]]
    elif inner.startswith("Sequence"):
        wrong += [3, "text"]
    elif inner == "ArrayLike":
        wrong += ["text", [[1, 2], [3]], [None, None], [1j, 2j], object(), {"a": 1}, np.array(["2020-01-01"], "M8[D]")]
        if name not in ANY_SHAPE:
            wrong.append(np.zeros((2, 2, 2, 2)))
        wrong += [[0.5, 1.5, 2.5], [-1, -1, -1], [2**40] * 3] if name in INTEGERS else [[math.nan] * 12]
    return wrong


class Mistakes(unittest.TestCase):
    def test_every_public_function_is_walked(self):
        self.assertEqual(sorted(set(public_names()) - set(CALLS) - NOT_WALKED), [])
        self.assertEqual(sorted(set(CALLS) - set(public_names())), [])

    def bound(self, name):
        function, arguments = CALLS[name]
        return (function() if getattr(function, "__name__", "") == "<lambda>" else function), dict(arguments)

    def test_the_arguments_that_mistakes_are_put_into_are_fine(self):
        for name in CALLS:
            with self.subTest(name):
                function, arguments = self.bound(name)
                function(**arguments)

    def test_a_mistake_is_refused_by_the_name_of_the_argument(self):
        tried = 0
        for name in CALLS:
            for parameter in inspect.signature(self.bound(name)[0]).parameters.values():
                for wrong in mistakes(parameter.name, str(parameter.annotation)):
                    if name.endswith(".load") and parameter.name == "x0" and isinstance(wrong, list) and wrong == [math.nan] * 12:
                        continue  # only its length counts
                    tried += 1
                    function, arguments = self.bound(name)
                    with self.subTest(f"{name}({parameter.name}={wrong!r})"), \
                            self.assertRaises((TypeError, ValueError), msg="was accepted") as caught:
                        function(**{**arguments, parameter.name: wrong})
                    if hasattr(caught, "exception"):
                        said = str(caught.exception)
                        with self.subTest(f"{name}({parameter.name}={wrong!r}) says {said}"):
                            self.assertRegex(said, rf"\b{parameter.name}\b")
                            self.assertNotIsInstance(caught.exception, (UnicodeError, RecursionError))
        self.assertGreater(tried, 2000)

    def test_an_unknown_argument_gets_the_nearest_ones(self):
        for name in CALLS:
            function, arguments = self.bound(name)
            for known in list(inspect.signature(function).parameters)[-1:]:
                with self.subTest(name), self.assertRaisesRegex(
                        TypeError, rf"no argument '{known}x'.*(did you mean|There are:).*\b{known}\b"):
                    function(**{**arguments, known + "x": 1})

    def test_integers_may_be_written_as_floats(self):
        self.assertEqual(len(mesh.make("torus", 1e3)), len(mesh.make("torus", np.float64(1000))))
        self.assertEqual(trust_region.minimize(lambda x: float(abs(x).sum()), [1.0, 2.0], max_evaluations=2e1).evaluations, 20)
        polycube.compute(CUBE, corners=np.int16(0), seed=np.uint64(3), threads=1.0)

    def test_a_wrong_word_lists_those_allowed(self):
        for name, (function, arguments) in CALLS.items():
            for parameter in inspect.signature(function).parameters.values():
                words = re.findall(r"'([^']+)'", str(parameter.annotation)) if "Literal[" in str(parameter.annotation) else []
                for word in words:
                    with self.subTest(f"{name}({parameter.name}={word!r})"), self.assertRaises(ValueError) as caught:
                        function(**{**arguments, parameter.name: word + "q"})
                    self.assertTrue(all(repr(one) in str(caught.exception) for one in words))
                    if len(word) > 3:
                        self.assertRegex(str(caught.exception), f"did you mean .*{word!r}")
        with self.assertRaisesRegex(ValueError, "shape='tors'.*did you mean 'torus'"):
            mesh.make("tors")


class Callbacks(unittest.TestCase):
    """What a function of the user's returned is named as that."""

    def test_of_one_number(self):
        for wrong, kind in ((None, TypeError), ("text", TypeError), (1j, TypeError), ([1.0, 2.0], ValueError), ([None], TypeError),
                            ((1.0, [2.0]), ValueError), ({}, TypeError)):
            with self.subTest(wrong), self.assertRaisesRegex(kind, r"\bf returned"):
                trust_region.minimize(lambda x: wrong, [1.0, 2.0])
        for wrong, kind in ((None, TypeError), (1.0, ValueError), ([1.0, None], TypeError), ([[1.0]], ValueError)):
            with self.subTest(wrong), self.assertRaisesRegex(kind, r"\bresiduals returned"):
                trust_region.least_squares(lambda x: wrong, [1.0, 2.0], 2)

    def test_of_a_value_and_its_gradient(self):
        for solver, x in ((projected_gradient, [1.0, 2.0]), (sphere_optimizer, ROWS)):
            for wrong, kind in ((None, TypeError), (1.0, TypeError), ((1.0,), ValueError), ((1.0, 2.0, 3.0), ValueError),
                                ((None, x), TypeError), ((1.0, None), TypeError), ((1.0, [1.0]), ValueError), (("a", x), TypeError),
                                (([1.0, 2.0], x), ValueError), ((1.0, "a"), TypeError), ((1j, x), TypeError)):
                with self.subTest(wrong), self.assertRaisesRegex(kind, r"\bf returned"):
                    solver.minimize(lambda x: wrong, x)

    def test_of_a_block(self):
        for wrong in (None, 1.0, (1.0,), (1.0, 2.0), ("a", V), (1.0, None)):
            with self.subTest(wrong), self.assertRaisesRegex((TypeError, ValueError), r"\bf returned"):
                sphere_optimizer.relax(lambda *_: wrong, ROWS, [[1], [0]])

    def test_of_a_projection(self):
        for wrong in (None, 1.0, "a", [1.0, None], [[1.0], [2.0, 3.0]]):
            with self.subTest(wrong), self.assertRaisesRegex((TypeError, ValueError), r"\bproject returned"):
                projected_gradient.minimize(square, [1.0, 2.0], project=lambda y: wrong)

    def test_what_a_function_raises_itself_stays_as_it_is(self):
        def f(x):
            return x + "text"

        for solver, x in ((trust_region, [1.0]), (projected_gradient, [1.0]), (sphere_optimizer, ROWS)):
            with self.assertRaises(TypeError) as caught:
                solver.minimize(f, x)
            self.assertNotIn("returned", str(caught.exception))


class Values(unittest.TestCase):
    def test_bounds_are_named_with_their_place(self):
        for said, lower, upper in ((r"lower\[1\] is None", [0, None], None), (r"upper\[0\] is nan", 0, [math.nan, 1]),
                                   (r"lower\[1\] = 3.0 is above upper\[1\] = 2.0", [0, 3], [1, 2]),
                                   (r"lower: one number or 2 are needed", [1, 2, 3], None)):
            with self.assertRaisesRegex((TypeError, ValueError), said):
                trust_region.minimize(square, [1.0, 1.0], lower=lower, upper=upper)

    def test_rows_and_their_right_sides_belong_together(self):
        for said, more in (("b is needed with A", {"A": [[1, 1]]}), ("b without A", {"b": [1]}),
                           ("b: 1 rows are needed, one for each row of A", {"A": [[1, 1]], "b": [1, 2]}),
                           (r"A\[0, 1\] is nan", {"A": [[1, math.nan]], "b": [1]}),
                           (r"b\[0\] is nan", {"A": [[1, 1]], "b": [math.nan]}), ("project stands", {"project": abs, "lower": 0})):
            with self.assertRaisesRegex((TypeError, ValueError), said):
                projected_gradient.minimize(square, [1.0, 1.0], **more)


class Signatures(unittest.TestCase):
    def test_options_are_arguments_with_types_and_the_libraries_defaults(self):
        from ctypes import byref, sizeof
        checked = 0
        for struct, options in OPTIONS.items():
            library = next(name for name in sorted(orbicube._LIBRARIES, key=len, reverse=True) if struct.startswith(f"obc_{name}_"))
            if library == "tetrahedra" and not HAS_TETRAHEDRA:
                continue
            raw = importlib.import_module("orbicube.raw." + library)
            filled = getattr(raw, struct)()
            self.assertEqual(getattr(raw, struct + "_init")(byref(filled), sizeof(filled)), 0)
            for option in options:
                if option.kind == "text" or option.default is None:
                    continue
                value = option.words[option.default] if option.kind == "word" else option.default
                self.assertEqual(getattr(filled, option.name), value,
                                 f"{struct}.{option.name}: run scripts/bindings.py --defaults build/capi")
                checked += 1
        self.assertGreater(checked, 60)

    def test_no_function_takes_whatever_it_is_given(self):
        for name in CALLS:
            signature = inspect.signature(self.bound(name))
            for parameter in signature.parameters.values():
                self.assertNotIn(parameter.kind, (parameter.VAR_KEYWORD, parameter.VAR_POSITIONAL), name)
                self.assertNotEqual(parameter.annotation, parameter.empty, f"{name}({parameter.name})")
        words = inspect.signature(sphere_map.compute).parameters["method"]
        self.assertIn("Literal['balanced', 'angle-area'", str(words.annotation))
        self.assertEqual((words.default, words.kind), ("balanced", words.KEYWORD_ONLY))
        self.assertIn("angle_weight: weight of E_D (lambda of the dissertation's eq. 3.5), nonnegative", sphere_map.compute.__doc__)

    bound = staticmethod(lambda name: Mistakes.bound(None, name)[0])


if __name__ == "__main__":
    unittest.main()
