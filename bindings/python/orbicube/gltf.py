"""Surfaces from glTF 2.0 files and to them.

    surface = read("shape.glb")
    decorated = read("textured.glb", keep=True)
    write("moved.glb", (1.1 * decorated.positions, decorated.triangles), kept=decorated)
    write("out.glb", surface, morph_targets={"sphere": directions}, checker_texture=1, texture_coordinates=uv)
"""

from __future__ import annotations

import ctypes
import json
from ctypes import byref
from typing import Any, Mapping, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, Indices, address, doubles, floats, indices, numbers
from ._call import HOST, Handle, Progress, call, filled, path_bytes, text, with_options
from ._checks import PathLike, public, text as checked_text
from ._foreign import surface_of
from ._records import Record
from .raw import gltf as raw


class Surface(Record):
    """What was read: positions and triangles in world coordinates, how many vertices were joined, and notes. `keeps`: whether the
    rest of the file is kept (read with keep=True) for `write` and `write_kept`; a note gives the reason where it could not be."""

    def __init__(self, positions: Doubles, triangles: Indices, welded_vertex_count: int, notes: list[str],
                 handle: Optional[Handle] = None) -> None:
        self.positions, self.triangles = positions, triangles
        self.welded_vertex_count, self.notes = welded_vertex_count, notes
        self._handle = handle

    @property
    def keeps(self) -> bool:
        return self._handle is not None


def _keeping(surface: Any, name: str) -> Handle:
    """The handle of a surface that keeps the rest of its file."""
    if not isinstance(surface, Surface):
        raise TypeError(f"{name}: a surface of gltf.read(..., keep=True) is needed, not {type(surface).__name__}")
    if surface._handle is None:
        raise ValueError(f"{name}: the surface keeps nothing of its file: it was read without keep=True, or a note gives the reason")
    return surface._handle


def _taken(handle: Handle) -> Surface:
    keeps = False
    try:
        positions = np.empty((raw.obc_gltf_surface_vertex_count(handle), 3))
        triangles = np.empty((raw.obc_gltf_surface_triangle_count(handle), 3), dtype=np.uint32)
        call(raw.obc_gltf_surface_copy, handle, address(positions), address(triangles))
        notes = [text(raw.obc_gltf_surface_note(handle, i)) or "" for i in range(raw.obc_gltf_surface_note_count(handle))]
        keeps = bool(raw.obc_gltf_surface_keeps(handle))
        return Surface(positions, triangles, raw.obc_gltf_surface_welded_vertex_count(handle), notes, handle if keeps else None)
    finally:
        if not keeps:
            handle.close()


@with_options("obc_gltf_read_options")
def read(path: PathLike, *,
         # options of obc_gltf_read_options, written by scripts/bindings.py
         weld_identical: bool = True, morph_target: Optional[str] = None, keep: bool = False,
         # end of options
         progress: Progress = None) -> Surface:
    """Reads GLB and glTF in JSON; with the name of a morph target, that shape of it. keep: what the file has besides the surface
    stays with it (materials, textures, texture coordinates, nodes, skins, animations, extras), for `write` and `write_kept`."""
    options = filled(raw.obc_gltf_read_options, raw.obc_gltf_read_options_init, locals())
    handle = Handle(raw.obc_gltf_surface_destroy)
    call(raw.obc_gltf_read, path_bytes(path), byref(options), HOST, byref(handle), progress=progress)
    return _taken(handle)


@with_options("obc_gltf_read_options")
def read_memory(data: bytes, folder: Optional[PathLike] = None, *,
                # options of obc_gltf_read_options, written by scripts/bindings.py
                weld_identical: bool = True, morph_target: Optional[str] = None, keep: bool = False,
                # end of options
                progress: Progress = None) -> Surface:
    """The same from bytes; buffers in files of their own lie in `folder`, None refuses them."""
    options = filled(raw.obc_gltf_read_options, raw.obc_gltf_read_options_init, locals())
    handle = Handle(raw.obc_gltf_surface_destroy)
    call(raw.obc_gltf_read_memory, data, len(data), None if folder is None else path_bytes(folder), byref(options), HOST,
         byref(handle), progress=progress)
    return _taken(handle)


def _colors(colors: ArrayLike, n: int) -> Any:
    given = numbers(colors, "colors")
    if given.shape != (n, 4):
        raise ValueError(f"colors: shape ({n}, 4) is needed, not {given.shape}")
    if given.dtype.kind not in "iu" or (given.size and (given.min() < 0 or given.max() > 255)):
        raise ValueError("colors: integers from 0 to 255 are needed")
    return np.ascontiguousarray(given, dtype=np.uint8)


def _json(extras: Any) -> bytes:
    try:
        return json.dumps(extras).encode()
    except (TypeError, ValueError) as error:
        raise type(error)(f"extras: {error}") from None


@with_options("obc_gltf_scene")
def write(path: PathLike, surface: Any, *, morph_targets: Optional[Mapping[str, ArrayLike]] = None,
          normals: Optional[ArrayLike] = None, texture_coordinates: Optional[ArrayLike] = None,
          colors: Optional[ArrayLike] = None, edges: Optional[ArrayLike] = None, texture: Optional[bytes] = None,
          translation: Optional[ArrayLike] = None, base_color: Optional[ArrayLike] = None, name: Optional[str] = None,
          extras: Any = None, smooth_normals: Optional[bool] = None, kept: Optional[Surface] = None,
          kept_positions: Optional[ArrayLike] = None,
          # options of obc_gltf_scene: scale, checker_texture, morph_normals, morph_seconds, written by scripts/bindings.py
          scale: float = 1.0, checker_texture: bool = False, morph_normals: bool = False, morph_seconds: float = 0.0,
          # end of options
          progress: Progress = None) -> None:
    """Writes a surface as GLB, or as JSON with the ending "gltf". Positions are stored as 32-bit floats. morph_targets: where the
    vertices are in each. smooth_normals: unless normals are given. extras: whatever JSON can hold. kept: a surface
    read with keep=True, whose materials, textures and so on the file gets; the triangles are its own, or lie on it where
    kept_positions are, a point a vertex."""
    scene = filled(raw.obc_gltf_scene, raw.obc_gltf_scene_init, locals())
    scene.smooth_normals = int(normals is None if smooth_normals is None else smooth_normals)
    positions, triangles = surface_of(surface)
    n = len(positions)
    held: list[Any] = []

    def hold(values: Any, array: Any) -> Any:
        held.append(array)
        return address(array) if values is not None else None

    scene.positions, scene.vertex_count = hold(positions, floats(positions, 3, name="surface: positions")), n
    scene.triangles, scene.triangle_count = hold(triangles, triangles), len(triangles)
    if normals is not None:
        scene.normals = hold(normals, floats(normals, 3, n, "normals", each="vertex"))
    if texture_coordinates is not None:
        scene.texture_coordinates = hold(texture_coordinates, floats(texture_coordinates, 2, n, "texture_coordinates", each="vertex"))
    if colors is not None:
        scene.colors = hold(colors, _colors(colors, n))
    if edges is not None:
        pairs = indices(edges, 2, name="edges", below=n, of="vertices")
        scene.edges, scene.edge_count = hold(edges, pairs), len(pairs)
    if morph_targets:
        targets = (raw.obc_gltf_morph_target * len(morph_targets))()
        for target, (title, places) in zip(targets, morph_targets.items()):
            target.name = checked_text(title, "morph_targets: the name of each").encode()
            target.positions = hold(places, floats(places, 3, n, f"morph_targets[{title!r}]", each="vertex"))
        held.append(targets)
        scene.morph_targets, scene.morph_target_count = ctypes.addressof(targets), len(targets)
    if translation is not None:
        scene.translation[:] = list(doubles(translation, rows=3, name="translation"))
    if base_color is not None:
        scene.base_color[:] = list(doubles(base_color, rows=4, name="base_color"))
    if texture is not None:
        held.append(ctypes.create_string_buffer(texture, len(texture)))
        scene.texture, scene.texture_size = ctypes.addressof(held[-1]), len(texture)
    if name is not None:
        scene.name = name.encode()
    if extras is not None:
        scene.extras = _json(extras)
    if kept is not None:
        scene.kept = _keeping(kept, "kept").value
    if kept_positions is not None:
        scene.kept_positions = hold(kept_positions, doubles(kept_positions, 3, n, "kept_positions", each="vertex"))
    call(raw.obc_gltf_write, path_bytes(path), byref(scene), HOST, progress=progress)


@public
def write_kept(path: PathLike, surface: Surface, *, progress: Progress = None) -> None:
    """Writes the file of a surface read with keep=True again, with all that it has."""
    call(raw.obc_gltf_write_kept, path_bytes(path), _keeping(surface, "surface"), HOST, progress=progress)


@public
def delta(base: float, wanted: float) -> float:
    """What a file stores for a base and a wanted coordinate of a morph target."""
    return raw.obc_gltf_delta(base, wanted)


@public
def reconstructed(base: float, stored: float) -> float:
    """What a renderer makes of base and delta in 32-bit floats."""
    return raw.obc_gltf_reconstructed(base, stored)


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_gltf_version()
