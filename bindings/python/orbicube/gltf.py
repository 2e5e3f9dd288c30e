"""Surfaces from glTF 2.0 files and to them.

    surface = read("shape.glb")
    write("out.glb", surface, morph_targets={"sphere": directions}, checker_texture=1, texture_coordinates=uv)
"""

from __future__ import annotations

import ctypes
import json
from ctypes import byref
from typing import Any, Mapping, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, Indices, address, floats, indices, surface_of
from ._call import HOST, Handle, Progress, call, filled, path_bytes, text
from .raw import gltf as raw


class Surface:
    """What was read: positions and triangles in world coordinates, how many vertices were joined, and notes."""

    def __init__(self, positions: Doubles, triangles: Indices, welded_vertex_count: int, notes: list[str]) -> None:
        self.positions, self.triangles = positions, triangles
        self.welded_vertex_count, self.notes = welded_vertex_count, notes


def _taken(handle: Handle) -> Surface:
    try:
        positions = np.empty((raw.obc_gltf_surface_vertex_count(handle), 3))
        triangles = np.empty((raw.obc_gltf_surface_triangle_count(handle), 3), dtype=np.uint32)
        call(raw.obc_gltf_surface_copy, handle, address(positions), address(triangles))
        notes = [text(raw.obc_gltf_surface_note(handle, i)) or "" for i in range(raw.obc_gltf_surface_note_count(handle))]
        return Surface(positions, triangles, raw.obc_gltf_surface_welded_vertex_count(handle), notes)
    finally:
        handle.close()


def _options(weld_identical: bool, morph_target: Optional[str]) -> Any:
    options = filled(raw.obc_gltf_read_options, raw.obc_gltf_read_options_init, {"weld_identical": int(weld_identical)})
    if morph_target is not None:
        options.morph_target = morph_target.encode()
    return options


def read(path: Any, *, weld_identical: bool = True, morph_target: Optional[str] = None,
         progress: Progress = None) -> Surface:
    """Reads .glb and .gltf; with the name of a morph target, that shape of it."""
    handle, options = Handle(raw.obc_gltf_surface_destroy), _options(weld_identical, morph_target)
    call(raw.obc_gltf_read, path_bytes(path), byref(options), HOST, byref(handle), progress=progress)
    return _taken(handle)


def read_memory(data: bytes, folder: Any = None, *, weld_identical: bool = True, morph_target: Optional[str] = None,
                progress: Progress = None) -> Surface:
    """The same from bytes; buffers in files of their own lie in `folder`, None refuses them."""
    handle, options = Handle(raw.obc_gltf_surface_destroy), _options(weld_identical, morph_target)
    call(raw.obc_gltf_read_memory, data, len(data), None if folder is None else path_bytes(folder), byref(options), HOST,
         byref(handle), progress=progress)
    return _taken(handle)


def write(path: Any, surface: Any, *, morph_targets: Optional[Mapping[str, ArrayLike]] = None,
          normals: Optional[ArrayLike] = None, texture_coordinates: Optional[ArrayLike] = None,
          colors: Optional[ArrayLike] = None, edges: Optional[ArrayLike] = None, texture: Optional[bytes] = None,
          translation: Optional[ArrayLike] = None, base_color: Optional[ArrayLike] = None, name: Optional[str] = None,
          extras: Any = None, progress: Progress = None, **members: Any) -> None:
    """Writes a surface as GLB, or as .gltf by the ending. Positions are stored as 32-bit floats. morph_targets: where the
    vertices are in each. members: smooth_normals (1 unless normals are given), scale, checker_texture, morph_normals,
    morph_seconds. extras: whatever JSON can hold."""
    positions, triangles = surface_of(surface)
    n = len(positions)
    kept: list[Any] = []

    def keep(values: Any, array: Any) -> Any:
        kept.append(array)
        return address(array) if values is not None else None

    members.setdefault("smooth_normals", int(normals is None))
    scene = filled(raw.obc_gltf_scene, raw.obc_gltf_scene_init, members)
    scene.positions, scene.vertex_count = keep(positions, floats(positions, 3)), n
    scene.triangles, scene.triangle_count = keep(triangles, triangles), len(triangles)
    if normals is not None:
        scene.normals = keep(normals, floats(normals, 3, n, "normals"))
    if texture_coordinates is not None:
        scene.texture_coordinates = keep(texture_coordinates, floats(texture_coordinates, 2, n, "texture_coordinates"))
    if colors is not None:
        given = np.asarray(colors)
        if given.shape != (n, 4):
            raise ValueError(f"colors: shape ({n}, 4) is needed, not {given.shape}")
        if given.dtype.kind not in "iu" or (given.size and (given.min() < 0 or given.max() > 255)):
            raise ValueError("colors: integers from 0 to 255 are needed")
        scene.colors = keep(colors, np.ascontiguousarray(given, dtype=np.uint8))
    if edges is not None:
        pairs = indices(edges, 2, name="edges")
        scene.edges, scene.edge_count = keep(edges, pairs), len(pairs)
    if morph_targets:
        targets = (raw.obc_gltf_morph_target * len(morph_targets))()
        for target, (title, places) in zip(targets, morph_targets.items()):
            target.name = title.encode()
            target.positions = keep(places, floats(places, 3, n, title))
        kept.append(targets)
        scene.morph_targets, scene.morph_target_count = ctypes.addressof(targets), len(targets)
    if translation is not None:
        scene.translation[:] = [float(value) for value in np.ravel(translation)]
    if base_color is not None:
        scene.base_color[:] = [float(value) for value in np.ravel(base_color)]
    if texture is not None:
        kept.append(ctypes.create_string_buffer(texture, len(texture)))
        scene.texture, scene.texture_size = ctypes.addressof(kept[-1]), len(texture)
    if name is not None:
        scene.name = name.encode()
    if extras is not None:
        scene.extras = json.dumps(extras).encode()
    call(raw.obc_gltf_write, path_bytes(path), byref(scene), HOST, progress=progress)


def delta(base: float, wanted: float) -> float:
    """What a file stores for a base and a wanted coordinate of a morph target."""
    return raw.obc_gltf_delta(base, wanted)


def reconstructed(base: float, stored: float) -> float:
    """What a renderer makes of base and delta in 32-bit floats."""
    return raw.obc_gltf_reconstructed(base, stored)


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_gltf_version()
