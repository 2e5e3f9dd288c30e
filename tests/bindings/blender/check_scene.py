"""Opens the scene that make_scene.py saved, without the add-on, and checks what its objects hold.

    blender --background --factory-startup --python check_scene.py -- SCENE.blend
"""

import sys
from fractions import Fraction

import bpy
import numpy as np

bpy.ops.wm.open_mainfile(filepath=sys.argv[sys.argv.index("--") + 1])
FLOAT = 2.0 ** -23  # relative distance of neighboring floats: Blender stores coordinates as floats


def points(data, member="co", width=3):
    values = np.empty(width * len(data), np.float32)
    data.foreach_get(member, values)
    return values.reshape(-1, width).astype(float)


def integers(data, member):
    values = np.empty(len(data), np.int32)
    data.foreach_get(member, values)
    return values


def triangles(mesh):
    assert all(polygon.loop_total == 3 for polygon in mesh.polygons)
    return integers(mesh.loops, "vertex_index").reshape(-1, 3)


def keys(shown):
    return {key.name: points(key.data) for key in shown.data.shape_keys.key_blocks}


def volume(positions, corners):
    a, b, c = (positions[corners[:, k]] for k in range(3))
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


def exact_sign(rows):
    """The sign of the determinant of three rows."""
    m = [[Fraction(float(x)) for x in row] for row in rows]
    value = sum(m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3]) for i in range(3))
    return (value > 0) - (value < 0)


def check_sphere():
    shown = bpy.data.objects["creature"]
    corners, held = triangles(shown.data), keys(shown)
    assert list(held) == ["Basis", "Sphere"], list(held)
    assert np.array_equal(held["Basis"], points(shown.data.vertices))
    directions = points(shown.data.attributes["sphere_direction"].data, "vector")
    assert np.abs(np.linalg.norm(directions, axis=1) - 1).max() < 2 * FLOAT
    for triangle in corners:
        assert exact_sign(directions[triangle]) > 0, "a triangle is flipped on the sphere"
    # The sphere has the area of the surface, and its center.
    a, b, c = (held["Basis"][corners[:, k]] for k in range(3))
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    radius, center = np.sqrt(areas.sum() / (4 * np.pi)), areas @ (a + b + c) / (3 * areas.sum())
    off = held["Sphere"] - center - radius * directions
    assert np.abs(off).max() < 8 * FLOAT * (radius + np.abs(center).max())


def check_polycube(name, size, padding):
    """Each patch of the polycube is in the texture at one scale, unmirrored, apart from the others."""
    shown = bpy.data.objects[name + " polycube"]
    mesh, held = shown.data, keys(shown)
    corners, on_polycube = triangles(mesh), held["Polycube"]
    patches = integers(mesh.attributes["polycube_patch"].data, "value")
    uv = points(mesh.uv_layers["Polycube"].data, "uv", 2).reshape(-1, 3, 2)
    assert uv.min() >= 0.5 * padding / size - FLOAT and uv.max() <= 1 - 0.5 * padding / size + FLOAT
    extent = np.ptp(on_polycube, axis=0).max()
    scales, flipped = [], 0
    for triangle, texture in zip(corners, uv):
        # Each coordinate is rounded by up to FLOAT / 4, which may flip a triangle that is thinner than that, and no other.
        (a, b), (c, d) = texture[1] - texture[0], texture[2] - texture[0]
        longest = max(np.linalg.norm(texture[i] - texture[i - 1]) for i in range(3))
        assert a * d - b * c >= -2 * FLOAT * longest, "a triangle is flipped in the texture"
        flipped += a * d - b * c <= 0
        at = on_polycube[triangle]
        flat = np.ptp(at, axis=0).min()
        assert flat <= 4 * FLOAT * extent, f"a triangle of the polycube is not parallel to two axes: {flat}"
        for i in range(3):
            length = np.linalg.norm(at[i] - at[i - 1])
            if length > 1e-3 * extent:  # of shorter ones roundoff decides
                scales.append(np.linalg.norm(texture[i] - texture[i - 1]) / length)
    assert flipped <= 0.005 * len(corners), f"{flipped} of {len(corners)} triangles are flipped in the texture"
    assert max(scales) / min(scales) < 1 + 1e-3, (min(scales), max(scales))
    # Patches are apart: no texel, at which a texture is painted, is near two of them.
    owner = np.full((size, size), -1)
    for patch, texture in zip(patches, uv):
        low, high = np.floor(texture.min(axis=0) * size - 1).astype(int), np.ceil(texture.max(axis=0) * size + 1).astype(int)
        for y in range(max(low[1], 0), min(high[1], size)):
            for x in range(max(low[0], 0), min(high[0], size)):
                middle = (np.array([x, y]) + 0.5) / size
                if all(_side(texture[i - 1], texture[i], middle) >= 0 for i in range(3)):
                    assert owner[y, x] in (-1, patch), "two patches share a texel"
                    owner[y, x] = patch
    assert len(np.unique(owner)) == patches.max() + 2
    # Seams are the edges of the polycube: between patches.
    of_edges = {}
    for triangle, patch in zip(corners, patches):
        for i in range(3):
            of_edges.setdefault(frozenset((triangle[i], triangle[i - 1])), set()).add(patch)
    for edge in mesh.edges:
        assert edge.use_seam == (len(of_edges[frozenset(edge.vertices)]) == 2)
    return shown, corners, held


def _side(a, b, p):
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def check_polycubes():
    shown, corners, held = check_polycube("bracket", 512, 6)
    bracket = bpy.data.objects["bracket"]
    whole = volume(points(bracket.data.vertices), triangles(bracket.data))
    assert abs(volume(held["Basis"], corners) / whole - 1) < 1e-5
    # The vertices of the surface come first.
    assert np.array_equal(held["Basis"][:len(bracket.data.vertices)], points(bracket.data.vertices))
    assert tuple(shown.location) == (5, 0, 0)
    assert shown.data.materials[0].node_tree and bpy.data.images["bracket polycube"].generated_type == "UV_GRID"

    shown, corners, held = check_polycube("cube", 1024, 4)
    assert len(held["Basis"]) >= 386, "the modifier's vertices are missing"
    assert [material.name for material in shown.data.materials] == ["wood"]


def check_morphs():
    creature, star = bpy.data.objects["creature"], bpy.data.objects["star"]
    for name, first, second, joined in (("creature morph", creature, star, True), ("star morph by polycube", star, creature, False)):
        shown = bpy.data.objects[name]
        corners, held = triangles(shown.data), keys(shown)
        assert list(held) == ["Basis", second.name], list(held)
        to_first = np.array(first.matrix_world.inverted() @ second.matrix_world)
        to_first[:3, 3] *= not joined
        of_second = points(second.data.vertices) @ to_first[:3, :3].T + to_first[:3, 3]
        # Vertices are on the surfaces. Through the sphere the triangulation is that of both, but for the library's tolerance of .2
        # percent of the diagonal; the grid of a polycube is coarser than the creature.
        for positions, surface, faces in ((held["Basis"], keys(creature)["Basis"] if first is creature else points(first.data.vertices),
                                           triangles(first.data)), (held[second.name], of_second, triangles(second.data))):
            exact = volume(surface, faces)
            assert abs(volume(positions, corners) / exact - 1) < (0.01 if joined else 0.1), name
            low, high = surface.min(axis=0), surface.max(axis=0)
            assert (positions >= low - 1e-5).all() and (positions <= high + 1e-5).all()


def check_hexahedra():
    shown = bpy.data.objects["bracket hexahedra"]
    mesh = shown.data
    assert shown.display_type == "WIRE"
    cells, quads = shown["hexahedra"], integers(mesh.loops, "vertex_index").reshape(-1, 4)
    assert len(quads) == len(mesh.polygons) and cells > 0
    # The Euler characteristic of a solid is half of that of its boundary.
    boundary = len(np.unique(quads)) - 2 * len(quads) + len(quads)
    solid = len(mesh.vertices) - len(mesh.edges) + (6 * cells + len(quads)) // 2 - cells
    assert 2 * solid == boundary == 2 - 2 * 4, (solid, boundary)
    surface = bpy.data.objects["bracket"]
    halves = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    whole = volume(points(surface.data.vertices), triangles(surface.data))
    assert abs(volume(points(mesh.vertices), halves) / whole - 1) < 0.02
    quality = points(mesh.attributes["scaled_jacobian"].data, "value", 1)
    assert 0 < quality.min() and quality.max() <= 1


check_sphere()
check_polycubes()
check_morphs()
check_hexahedra()
print("check_scene.py has passed")
