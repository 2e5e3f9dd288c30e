#!/usr/bin/env python3
"""Draws what the libraries are for, as the figures of the dissertation show it, into PNG files. Needs matplotlib.

    gallery.py [FOLDER] [--triangles N]

sphere_map.png     a shape and its map to the sphere, colored by the distortion of angles
energy.png         how the energy falls while the method `dissertation` maps a shape (Figure 3.2)
harmonics.png      the shape from its harmonics up to degrees 2, 6 and 12
spectrum.png       norms of the degrees of several shapes, by which they are compared (section 3.3.3)
polycube.png       a shape and its polycube, colored by the directions of the faces
frames.png         angles between neighboring frames of a field (chapter 6); needs the library tetrahedra
"""

import argparse
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # noqa: E402
from orbicube import frame_field, harmonics, mesh, polycube, sphere_map  # noqa: E402


def draw(axes, positions, triangles, values=None, colors=None, title=""):
    """Triangles in perspective, shaded; colored by values from 0 to 1 or by colors."""
    corners = positions[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    light = 0.55 + 0.45 * np.clip(normals @ np.array([0.3, -0.6, 0.74]), 0, 1)
    base = colors if colors is not None else plt.cm.viridis(values if values is not None else np.full(len(triangles), 0.6))
    faces = np.clip(base[:, :3] * light[:, None], 0, 1)
    axes.add_collection3d(Poly3DCollection(corners, facecolors=faces, edgecolors="none"))
    low, high = positions.min(axis=0), positions.max(axis=0)
    middle, half = (low + high) / 2, (high - low).max() / 2
    axes.set(xlim=(middle[0] - half, middle[0] + half), ylim=(middle[1] - half, middle[1] + half),
             zlim=(middle[2] - half, middle[2] + half), title=title)
    axes.set_box_aspect((1, 1, 1))
    axes.set_axis_off()


def save(figure, folder, name):
    path = os.path.join(folder, name)
    figure.savefig(path, dpi=110, bbox_inches="tight")
    plt.close(figure)
    print("wrote", path)


def row(count):
    return plt.subplots(1, count, figsize=(4 * count, 4), subplot_kw={"projection": "3d"})


def sphere_maps(folder, n):
    shape = mesh.make("creature", n)
    result = sphere_map.compute(shape)
    quasi_conformal, _ = sphere_map.face_distortion(shape, result.directions)
    values = np.clip((quasi_conformal - 1) / 2, 0, 1)
    figure, (left, right) = row(2)
    draw(left, shape.positions, shape.triangles, values, title="surface")
    draw(right, result.directions, shape.triangles, values, title=f"mean quasi-conformal distortion {result.report.mean_quasi_conformal:.2f}")
    save(figure, folder, "sphere_map.png")

    told = []
    sphere_map.compute(mesh.make("creature", min(n, 1000)), method="dissertation", trace=lambda *what: told.append(what))
    figure, axes = plt.subplots(figsize=(6, 4))
    axes.plot([vertices for _, vertices, _ in told], [energy for *_, energy in told], ".-")
    axes.set(xlabel="vertices of the mesh so far", ylabel="energy", title="the method of the dissertation", yscale="log")
    save(figure, folder, "energy.png")
    return shape, result


def spectra(folder, n, shape, result):
    degrees = (2, 6, 12)
    figure, axes = row(len(degrees) + 1)
    draw(axes[0], shape.positions, shape.triangles, title="surface")
    weights = mesh.vertex_areas(shape)
    for degree, place in zip(degrees, axes[1:]):
        a, _ = harmonics.fit(result.directions, shape.positions, weights, degree=degree)
        draw(place, harmonics.synthesize(a, result.directions), shape.triangles, title=f"degree {degree}")
    save(figure, folder, "harmonics.png")

    figure, axes = plt.subplots(figsize=(6, 4))
    for seed in range(3):
        other = mesh.make("creature", n, seed=seed)
        at = sphere_map.compute(other).directions
        a, _ = harmonics.fit(at, other.positions, mesh.vertex_areas(other), degree=12)
        axes.semilogy(range(1, 13), harmonics.degree_norms(a)[1:], ".-", label=f"creature {seed}")
    axes.set(xlabel="degree", ylabel="norm")
    axes.legend()
    save(figure, folder, "spectrum.png")


def polycubes(folder, n):
    map = polycube.compute(mesh.make("bracket", n)).optimize_domain()
    colors = np.array([[0.86, 0.37, 0.34], [0.97, 0.7, 0.65], [0.35, 0.65, 0.4], [0.7, 0.88, 0.7], [0.3, 0.5, 0.8],
                       [0.68, 0.8, 0.95]])[map.of_triangles()[0]]
    figure, (left, right) = row(2)
    draw(left, map.positions, map.triangles, colors=colors, title="surface")
    draw(right, map.polycube, map.triangles, colors=colors, title=f"polycube, {map.corner_count} corners")
    save(figure, folder, "polycube.png")


def frames(folder, n):
    from orbicube import quaternion, tetrahedra

    try:
        solid = tetrahedra.fill(mesh.make("sphere", n))
    except ImportError as error:
        print("no frames.png:", error)
        return
    field, report = frame_field.compute(solid)
    faces = {}
    for cell, corners in enumerate(solid.tetrahedra):
        for k in range(4):
            faces.setdefault(tuple(sorted(np.delete(corners, k))), []).append(cell)
    pairs = np.array([cells for cells in faces.values() if len(cells) == 2])
    angles = np.degrees(quaternion.symmetric_distance(field[pairs[:, 0]], field[pairs[:, 1]]))
    figure, axes = plt.subplots(figsize=(6, 4))
    axes.hist(angles, bins=60, range=(0, 63), log=True)
    axes.set(xlabel="angle between neighboring frames, degrees", ylabel="faces", title=f"mean {report.symmetric_mean:.1f}")
    assert abs(angles.mean() - report.symmetric_mean) < 1e-6
    save(figure, folder, "frames.png")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", default="gallery")
    parser.add_argument("--triangles", type=int, default=6000)
    arguments = parser.parse_args()
    os.makedirs(arguments.folder, exist_ok=True)
    shape, result = sphere_maps(arguments.folder, arguments.triangles)
    spectra(arguments.folder, arguments.triangles, shape, result)
    polycubes(arguments.folder, arguments.triangles)
    frames(arguments.folder, min(arguments.triangles, 2000))


if __name__ == "__main__":
    main()
