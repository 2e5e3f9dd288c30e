"""What <orbicube/gltf.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

class obc_gltf_read_options(Struct):
    struct_size: int
    weld_identical: int
    morph_target: bytes | None
    keep: int
    reserved: int
    def __init__(self, struct_size: int = ..., weld_identical: int = ..., morph_target: bytes | None = ..., keep: int = ..., reserved: int = ...) -> None: ...

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
    kept: Any
    kept_positions: Any
    def __init__(self, struct_size: int = ..., smooth_normals: int = ..., positions: Any = ..., vertex_count: int = ..., triangles: Any = ..., triangle_count: int = ..., normals: Any = ..., texture_coordinates: Any = ..., colors: Any = ..., morph_targets: Any = ..., morph_target_count: int = ..., edges: Any = ..., edge_count: int = ..., translation: Any = ..., scale: float = ..., base_color: Any = ..., texture: Any = ..., texture_size: int = ..., checker_texture: int = ..., morph_normals: int = ..., name: bytes | None = ..., extras: bytes | None = ..., morph_seconds: float = ..., kept: Any = ..., kept_positions: Any = ...) -> None: ...

def obc_gltf_read_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_gltf_read(path: bytes | None, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Reads the file at `path` (bytes in the encoding of the system). options and host may be NULL; the allocator of the host must remain valid
    until _surface_destroy. O(n). Errors: io; malformed file (the kind says how: truncated, parse, index-range, accessor-range,
    unsafe-path, ...); unsupported; degenerate (a transform or welding flattens everything); out of memory; cancelled."""
    ...

def obc_gltf_read_memory(bytes: Pointer, size: int, folder: bytes | None, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Reads a GLB or JSON file from `size` bytes in memory, which are not kept. `folder` contains buffers in separate files; NULL refuses
    them. Otherwise as obc_gltf_read."""
    ...

def obc_gltf_surface_vertex_count(surface: Pointer) -> int:
    """Return the numbers of vertices, triangles, welded vertices, and notes on changed or omitted contents of a surface; 0 for NULL."""
    ...

def obc_gltf_surface_triangle_count(surface: Pointer) -> int:
    """Return the numbers of vertices, triangles, welded vertices, and notes on changed or omitted contents of a surface; 0 for NULL."""
    ...

def obc_gltf_surface_welded_vertex_count(surface: Pointer) -> int:
    """Return the numbers of vertices, triangles, welded vertices, and notes on changed or omitted contents of a surface; 0 for NULL."""
    ...

def obc_gltf_surface_note_count(surface: Pointer) -> int:
    """Return the numbers of vertices, triangles, welded vertices, and notes on changed or omitted contents of a surface; 0 for NULL."""
    ...

def obc_gltf_surface_note(surface: Pointer, index: int) -> bytes | None:
    """Returns the index-th note, UTF-8, valid until the surface is destroyed; NULL from the number of notes on."""
    ...

def obc_gltf_surface_keeps(surface: Pointer) -> int:
    """Returns 1 if the handle keeps what the file has besides the surface, 0 otherwise: without the option `keep`, for NULL, and where the file does
    not allow it; a note gives the reason then."""
    ...

def obc_gltf_surface_copy(surface: Pointer, positions: Pointer, triangles: Pointer, error: Pointer) -> int:
    """Copies positions (3 * vertex_count, or NULL) and triangles (3 * triangle_count indices, or NULL; counter-clockwise seen from outside)
    to arrays of the caller. Errors: invalid argument."""
    ...

def obc_gltf_surface_destroy(surface: Pointer) -> None:
    """Destroys a surface; NULL is allowed."""
    ...

def obc_gltf_scene_init(scene: Pointer, struct_size: int) -> int:
    """Fills a scene with the defaults and an empty surface."""
    ...

def obc_gltf_write(path: bytes | None, scene: Pointer, host: Pointer, error: Pointer) -> int:
    """Writes to `path`: JSON with an embedded buffer for the ending "gltf", otherwise GLB. The file appears when it is complete; after an error the
    previous file remains. host may be NULL. O(n). Errors: invalid argument (sizes, indices, numbers that are not finite, texts),
    unsupported (4 GiB or more), io, out of memory, cancelled."""
    ...

def obc_gltf_write_kept(path: bytes | None, surface: Pointer, host: Pointer, error: Pointer) -> int:
    """Writes the file of a surface that keeps it again, with all that it has; buffers and images of separate files come into this one. Otherwise as
    obc_gltf_write. Errors: also invalid argument (the surface keeps nothing)."""
    ...

def obc_gltf_write_surface(path: bytes | None, positions: Pointer, vertex_count: int, triangles: Pointer, triangle_count: int, host: Pointer, error: Pointer) -> int:
    """Writes a surface alone, with smooth normals: positions 3 * vertex_count, triangles 3 * triangle_count. Otherwise as obc_gltf_write."""
    ...

def obc_gltf_delta(base: float, target: float) -> float:
    """Compute exact morph targets of finite numbers. _delta returns the stored delta for a base and a target coordinate; _reconstructed returns
    base + delta in float32, as a renderer adds them, which equals the target whenever some delta reaches it."""
    ...

def obc_gltf_reconstructed(base: float, delta: float) -> float:
    """Compute exact morph targets of finite numbers. _delta returns the stored delta for a base and a target coordinate; _reconstructed returns
    base + delta in float32, as a renderer adds them, which equals the target whenever some delta reaches it."""
    ...

def obc_gltf_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
