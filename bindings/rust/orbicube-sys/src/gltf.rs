//! What `<orbicube/gltf.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use std::os::raw::{c_char, c_void};

/// A surface read from a file.
#[repr(C)]
pub struct obc_gltf_surface {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Options of reading. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_gltf_read_options {
    pub struct_size: u32,
    /// 1: welds vertices at identical positions where triangles have no indices or the surface is not closed as stored (exporters split
    /// vertices along seams of normals and texture coordinates); 0: preserves the vertices and their order. Default: 1.
    pub weld_identical: i32,
    /// Name of a morph target to apply with weight 1 (base + delta, added as doubles); NULL: none. Default: NULL.
    pub morph_target: *const c_char,
    /// 1: keeps what the file has besides the surface in the handle, for obc\_gltf\_scene.kept and obc\_gltf\_write\_kept; 0: leaves it out, with a note
    /// that counts it. Default: 0.
    pub keep: i32,
    pub reserved: i32,
}

/// Another shape of the same surface, for obc\_gltf\_scene.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_gltf_morph_target {
    /// name, UTF-8; stored in mesh.extras.targetNames, where engines find it
    pub name: *const c_char,
    /// positions of the vertices, 3 \* vertex\_count; stored as deltas, see obc\_gltf\_delta
    pub positions: *const f32,
}

/// Contents of a file. Arrays are not kept after the call. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_gltf_scene {
    pub struct_size: u32,
    /// 1: computes area-weighted normals if \`normals\` is NULL; 0: does not. Default: 0.
    pub smooth_normals: i32,
    /// 3 \* vertex\_count, stored bit for bit. Default: NULL.
    pub positions: *const f32,
    /// number of vertices. Default: 0.
    pub vertex_count: usize,
    /// 3 \* triangle\_count vertices. Default: NULL.
    pub triangles: *const u32,
    /// number of triangles. Default: 0.
    pub triangle_count: usize,
    /// 3 \* vertex\_count, unit vectors; NULL: none. Default: NULL.
    pub normals: *const f32,
    /// 2 \* vertex\_count, v pointing down; NULL: none. Default: NULL.
    pub texture_coordinates: *const f32,
    /// 4 \* vertex\_count, linear red, green, blue, opacity; NULL: none. Default: NULL.
    pub colors: *const u8,
    /// morph targets; NULL: none. Default: NULL.
    pub morph_targets: *const obc_gltf_morph_target,
    /// number of morph targets. Default: 0.
    pub morph_target_count: usize,
    /// 2 \* edge\_count vertices, drawn as dark lines; NULL: none. Default: NULL.
    pub edges: *const u32,
    /// number of edges. Default: 0.
    pub edge_count: usize,
    /// translation of the node: world = translation + scale \* position. Default: 0.
    pub translation: [f64; 3],
    /// scale of the node, positive. Default: 1.
    pub scale: f64,
    /// color of the material, linear, 0 to 1. Default: 0.8 gray, opaque.
    pub base_color: [f64; 4],
    /// contents of a PNG file, requires texture\_coordinates; NULL: none. Default: NULL.
    pub texture: *const c_void,
    /// number of bytes of the PNG file. Default: 0.
    pub texture_size: usize,
    /// 1: a checker pattern of 32 by 16 squares if \`texture\` is NULL; 0: none. Default: 0.
    pub checker_texture: i32,
    /// 1: stores normals of morph targets, requires normals; 0: does not. Default: 0.
    pub morph_normals: i32,
    /// name of node and mesh, UTF-8; NULL: "surface". Default: "surface".
    pub name: *const c_char,
    /// JSON object for the extras of the scene; NULL: none. Default: NULL.
    pub extras: *const c_char,
    /// Duration, in seconds, from one shape to the next of an animation from the surface to each morph target in turn and back; 0: no
    /// animation. Default: 0.
    pub morph_seconds: f64,
    /// Surface that keeps the rest of its file (obc\_gltf\_surface\_keeps), with which the scene is written: materials, textures, texture
    /// coordinates, colors, nodes, skins, animations, extras. It is not changed and must remain valid during the call. The scene has no
    /// normals, colors, edges or extras of its own then, and its texture and base\_color apply to parts without a material. Without
    /// kept\_positions, the triangles are those of the surface in their order, and the positions at least its vertices. NULL: none.
    /// Default: NULL.
    pub kept: *const obc_gltf_surface,
    /// For other triangles than those of \`kept\`: the place of each vertex on the surface that was read, 3 \* vertex\_count, of which the nearest
    /// point of the surface counts. Each triangle takes its material from the place of its centroid. NULL: the triangles of \`kept\`.
    /// Default: NULL.
    pub kept_positions: *const f64,
}

extern "C" {
    /// Fills options with the defaults.
    pub fn obc_gltf_read_options_init(options: *mut obc_gltf_read_options, struct_size: usize) -> i32;
    /// Reads the file at \`path\` (bytes in the encoding of the system). options and host may be NULL; the allocator of the host must remain valid
    /// until \_surface\_destroy. O(n). Errors: io; malformed file (the kind says how: truncated, parse, index-range, accessor-range,
    /// unsafe-path, ...); unsupported; degenerate (a transform or welding flattens everything); out of memory; cancelled.
    pub fn obc_gltf_read(path: *const c_char, options: *const obc_gltf_read_options, host: *const obc_host, out: *mut *mut obc_gltf_surface, error: *mut obc_error) -> i32;
    /// Reads a GLB or JSON file from \`size\` bytes in memory, which are not kept. \`folder\` contains buffers in separate files; NULL refuses
    /// them. Otherwise as obc\_gltf\_read.
    pub fn obc_gltf_read_memory(bytes: *const c_void, size: usize, folder: *const c_char, options: *const obc_gltf_read_options, host: *const obc_host, out: *mut *mut obc_gltf_surface, error: *mut obc_error) -> i32;
    /// Return the numbers of vertices, triangles, welded vertices, and notes on changed or omitted contents of a surface; 0 for NULL.
    pub fn obc_gltf_surface_vertex_count(surface: *const obc_gltf_surface) -> usize;
    /// Return the numbers of vertices, triangles, welded vertices, and notes on changed or omitted contents of a surface; 0 for NULL.
    pub fn obc_gltf_surface_triangle_count(surface: *const obc_gltf_surface) -> usize;
    /// Return the numbers of vertices, triangles, welded vertices, and notes on changed or omitted contents of a surface; 0 for NULL.
    pub fn obc_gltf_surface_welded_vertex_count(surface: *const obc_gltf_surface) -> usize;
    /// Return the numbers of vertices, triangles, welded vertices, and notes on changed or omitted contents of a surface; 0 for NULL.
    pub fn obc_gltf_surface_note_count(surface: *const obc_gltf_surface) -> usize;
    /// Returns the index-th note, UTF-8, valid until the surface is destroyed; NULL from the number of notes on.
    pub fn obc_gltf_surface_note(surface: *const obc_gltf_surface, index: usize) -> *const c_char;
    /// Returns 1 if the handle keeps what the file has besides the surface, 0 otherwise: without the option \`keep\`, for NULL, and where the file does
    /// not allow it; a note gives the reason then.
    pub fn obc_gltf_surface_keeps(surface: *const obc_gltf_surface) -> i32;
    /// Copies positions (3 \* vertex\_count, or NULL) and triangles (3 \* triangle\_count indices, or NULL; counter-clockwise seen from outside)
    /// to arrays of the caller. Errors: invalid argument.
    pub fn obc_gltf_surface_copy(surface: *const obc_gltf_surface, positions: *mut f64, triangles: *mut u32, error: *mut obc_error) -> i32;
    /// Destroys a surface; NULL is allowed.
    pub fn obc_gltf_surface_destroy(surface: *mut obc_gltf_surface);
    /// Fills a scene with the defaults and an empty surface.
    pub fn obc_gltf_scene_init(scene: *mut obc_gltf_scene, struct_size: usize) -> i32;
    /// Writes to \`path\`: JSON with an embedded buffer for the ending "gltf", otherwise GLB. The file appears when it is complete; after an error the
    /// previous file remains. host may be NULL. O(n). Errors: invalid argument (sizes, indices, numbers that are not finite, texts),
    /// unsupported (4 GiB or more), io, out of memory, cancelled.
    pub fn obc_gltf_write(path: *const c_char, scene: *const obc_gltf_scene, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Writes the file of a surface that keeps it again, with all that it has; buffers and images of separate files come into this one. Otherwise as
    /// obc\_gltf\_write. Errors: also invalid argument (the surface keeps nothing).
    pub fn obc_gltf_write_kept(path: *const c_char, surface: *const obc_gltf_surface, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Writes a surface alone, with smooth normals: positions 3 \* vertex\_count, triangles 3 \* triangle\_count. Otherwise as obc\_gltf\_write.
    pub fn obc_gltf_write_surface(path: *const c_char, positions: *const f32, vertex_count: usize, triangles: *const u32, triangle_count: usize, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Compute exact morph targets of finite numbers. \_delta returns the stored delta for a base and a target coordinate; \_reconstructed returns
    /// base + delta in float32, as a renderer adds them, which equals the target whenever some delta reaches it.
    pub fn obc_gltf_delta(base: f32, target: f32) -> f32;
    /// Compute exact morph targets of finite numbers. \_delta returns the stored delta for a base and a target coordinate; \_reconstructed returns
    /// base + delta in float32, as a renderer adds them, which equals the target whenever some delta reaches it.
    pub fn obc_gltf_reconstructed(base: f32, delta: f32) -> f32;
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_gltf_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_gltf_read_options>(), align_of::<obc_gltf_read_options>()), (24, 8));
        let it = MaybeUninit::<obc_gltf_read_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_gltf_read_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).weld_identical) } as usize - start as usize, 4, "obc_gltf_read_options.weld_identical");
        assert_eq!(unsafe { addr_of!((*start).morph_target) } as usize - start as usize, 8, "obc_gltf_read_options.morph_target");
        assert_eq!(unsafe { addr_of!((*start).keep) } as usize - start as usize, 16, "obc_gltf_read_options.keep");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 20, "obc_gltf_read_options.reserved");
        assert_eq!((size_of::<obc_gltf_morph_target>(), align_of::<obc_gltf_morph_target>()), (16, 8));
        let it = MaybeUninit::<obc_gltf_morph_target>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).name) } as usize - start as usize, 0, "obc_gltf_morph_target.name");
        assert_eq!(unsafe { addr_of!((*start).positions) } as usize - start as usize, 8, "obc_gltf_morph_target.positions");
        assert_eq!((size_of::<obc_gltf_scene>(), align_of::<obc_gltf_scene>()), (224, 8));
        let it = MaybeUninit::<obc_gltf_scene>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_gltf_scene.struct_size");
        assert_eq!(unsafe { addr_of!((*start).smooth_normals) } as usize - start as usize, 4, "obc_gltf_scene.smooth_normals");
        assert_eq!(unsafe { addr_of!((*start).positions) } as usize - start as usize, 8, "obc_gltf_scene.positions");
        assert_eq!(unsafe { addr_of!((*start).vertex_count) } as usize - start as usize, 16, "obc_gltf_scene.vertex_count");
        assert_eq!(unsafe { addr_of!((*start).triangles) } as usize - start as usize, 24, "obc_gltf_scene.triangles");
        assert_eq!(unsafe { addr_of!((*start).triangle_count) } as usize - start as usize, 32, "obc_gltf_scene.triangle_count");
        assert_eq!(unsafe { addr_of!((*start).normals) } as usize - start as usize, 40, "obc_gltf_scene.normals");
        assert_eq!(unsafe { addr_of!((*start).texture_coordinates) } as usize - start as usize, 48, "obc_gltf_scene.texture_coordinates");
        assert_eq!(unsafe { addr_of!((*start).colors) } as usize - start as usize, 56, "obc_gltf_scene.colors");
        assert_eq!(unsafe { addr_of!((*start).morph_targets) } as usize - start as usize, 64, "obc_gltf_scene.morph_targets");
        assert_eq!(unsafe { addr_of!((*start).morph_target_count) } as usize - start as usize, 72, "obc_gltf_scene.morph_target_count");
        assert_eq!(unsafe { addr_of!((*start).edges) } as usize - start as usize, 80, "obc_gltf_scene.edges");
        assert_eq!(unsafe { addr_of!((*start).edge_count) } as usize - start as usize, 88, "obc_gltf_scene.edge_count");
        assert_eq!(unsafe { addr_of!((*start).translation) } as usize - start as usize, 96, "obc_gltf_scene.translation");
        assert_eq!(unsafe { addr_of!((*start).scale) } as usize - start as usize, 120, "obc_gltf_scene.scale");
        assert_eq!(unsafe { addr_of!((*start).base_color) } as usize - start as usize, 128, "obc_gltf_scene.base_color");
        assert_eq!(unsafe { addr_of!((*start).texture) } as usize - start as usize, 160, "obc_gltf_scene.texture");
        assert_eq!(unsafe { addr_of!((*start).texture_size) } as usize - start as usize, 168, "obc_gltf_scene.texture_size");
        assert_eq!(unsafe { addr_of!((*start).checker_texture) } as usize - start as usize, 176, "obc_gltf_scene.checker_texture");
        assert_eq!(unsafe { addr_of!((*start).morph_normals) } as usize - start as usize, 180, "obc_gltf_scene.morph_normals");
        assert_eq!(unsafe { addr_of!((*start).name) } as usize - start as usize, 184, "obc_gltf_scene.name");
        assert_eq!(unsafe { addr_of!((*start).extras) } as usize - start as usize, 192, "obc_gltf_scene.extras");
        assert_eq!(unsafe { addr_of!((*start).morph_seconds) } as usize - start as usize, 200, "obc_gltf_scene.morph_seconds");
        assert_eq!(unsafe { addr_of!((*start).kept) } as usize - start as usize, 208, "obc_gltf_scene.kept");
        assert_eq!(unsafe { addr_of!((*start).kept_positions) } as usize - start as usize, 216, "obc_gltf_scene.kept_positions");
    }
}
