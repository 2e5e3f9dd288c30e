"""What <orbicube/gltf.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

class obc_gltf_read_options(Struct):
    struct_size: int
    weld_identical: int
    morph_target: bytes | None
    def __init__(self, struct_size: int = ..., weld_identical: int = ..., morph_target: bytes | None = ...) -> None: ...

class obc_gltf_morph_target(Struct):
    name: bytes | None
    positions: Any
    def __init__(self, name: bytes | None = ..., positions: Any = ...) -> None: ...

class obc_gltf_scene(Struct):
    struct_size: int
    smooth_normals: int
    positions: Any
    vertex_count: int
    triangles: Any
    triangle_count: int
    normals: Any
    texture_coordinates: Any
    colors: Any
    morph_targets: Any
    morph_target_count: int
    edges: Any
    edge_count: int
    translation: Any
    scale: float
    base_color: Any
    texture: Any
    texture_size: int
    checker_texture: int
    morph_normals: int
    name: bytes | None
    extras: bytes | None
    morph_seconds: float
    def __init__(self, struct_size: int = ..., smooth_normals: int = ..., positions: Any = ..., vertex_count: int = ..., triangles: Any = ..., triangle_count: int = ..., normals: Any = ..., texture_coordinates: Any = ..., colors: Any = ..., morph_targets: Any = ..., morph_target_count: int = ..., edges: Any = ..., edge_count: int = ..., translation: Any = ..., scale: float = ..., base_color: Any = ..., texture: Any = ..., texture_size: int = ..., checker_texture: int = ..., morph_normals: int = ..., name: bytes | None = ..., extras: bytes | None = ..., morph_seconds: float = ...) -> None: ...

def obc_gltf_read_options_init(options: Pointer, struct_size: int) -> int:
    """The defaults, which the members' comments give."""
    ...

def obc_gltf_read(path: bytes | None, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Reads the file at `path` (bytes as the system takes them). options and host may be NULL; the host's allocator must stay
    valid until _surface_destroy. Errors: io, malformed file (its kind says how: truncated, parse, index-range,
    accessor-range, unsafe-path, ...), unsupported, degenerate (a transform or welding flattens everything), out of memory,
    cancelled. O(n)."""
    ...

def obc_gltf_read_memory(bytes: Pointer, size: int, folder: bytes | None, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """The same from `size` bytes of a GLB or .gltf file, which are not kept; `folder` is where buffers in files of their own
    lie, NULL refuses them."""
    ...

def obc_gltf_surface_vertex_count(surface: Pointer) -> int:
    """Numbers of a surface; 0 for NULL. Notes are what was changed or left out in reading."""
    ...

def obc_gltf_surface_triangle_count(surface: Pointer) -> int:
    """Numbers of a surface; 0 for NULL. Notes are what was changed or left out in reading."""
    ...

def obc_gltf_surface_welded_vertex_count(surface: Pointer) -> int:
    """Numbers of a surface; 0 for NULL. Notes are what was changed or left out in reading."""
    ...

def obc_gltf_surface_note_count(surface: Pointer) -> int:
    """Numbers of a surface; 0 for NULL. Notes are what was changed or left out in reading."""
    ...

def obc_gltf_surface_note(surface: Pointer, index: int) -> bytes | None:
    """The index-th note, UTF-8, of the surface's; NULL when there is none."""
    ...

def obc_gltf_surface_copy(surface: Pointer, positions: Pointer, triangles: Pointer, error: Pointer) -> int:
    """Copies positions (3 * vertex_count, or NULL) and triangles (3 * triangle_count indices below vertex_count, or NULL;
    counter-clockwise seen from outside) to the caller's arrays. Errors: invalid argument."""
    ...

def obc_gltf_surface_destroy(surface: Pointer) -> None:
    """Releases a surface; NULL is fine."""
    ...

def obc_gltf_scene_init(scene: Pointer, struct_size: int) -> int:
    """The defaults, which the members' comments give, and an empty surface."""
    ...

def obc_gltf_write(path: bytes | None, scene: Pointer, host: Pointer, error: Pointer) -> int:
    """Writes to `path`: .gltf with the buffer inside when it ends so, GLB otherwise. The file appears once it is whole; after
    an error the old one is still there. host may be NULL. Errors: invalid argument (sizes, indices, numbers that are not
    finite, texts), unsupported (4 GiB or more), io, out of memory, cancelled. O(n)."""
    ...

def obc_gltf_write_surface(path: bytes | None, positions: Pointer, vertex_count: int, triangles: Pointer, triangle_count: int, host: Pointer, error: Pointer) -> int:
    """A surface alone, with smooth normals: positions 3 * vertex_count, triangles 3 * triangle_count."""
    ...

def obc_gltf_delta(base: float, wanted: float) -> float:
    """Morph targets to the bit. _delta is what is stored for a base and a wanted coordinate; _reconstructed is what a renderer
    makes of base and delta in float32, and is the wanted one whenever any delta gives it. Finite numbers."""
    ...

def obc_gltf_reconstructed(base: float, delta: float) -> float:
    """Morph targets to the bit. _delta is what is stored for a base and a wanted coordinate; _reconstructed is what a renderer
    makes of base and delta in float32, and is the wanted one whenever any delta gives it. Finite numbers."""
    ...

def obc_gltf_version() -> int:
    """Version of this library, major * 10000 + minor * 100 + patch."""
    ...
