//! What `<orbicube/gltf.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use std::os::raw::{c_char, c_void};

/// A surface that was read.
#[repr(C)]
pub struct obc_gltf_surface {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_gltf_read_options {
    pub struct_size: u32,
    /// 1: joins vertices at identical positions where triangles have no indices, or where the
    /// surface is not closed as it stands (exporters split vertices along seams of normals and
    /// texture coordinates); 0: vertices and their order are those of the file. Default 1
    pub weld_identical: i32,
    /// name of a morph target that is applied in full (base + delta, added as doubles), or NULL
    pub morph_target: *const c_char,
}

/// Another shape of the same surface, for obc\_gltf\_scene.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_gltf_morph_target {
    /// UTF-8; stored in mesh.extras.targetNames, where engines look for it
    pub name: *const c_char,
    /// 3 \* vertex\_count: where the vertices are, not deltas; stored as obc\_gltf\_delta says
    pub positions: *const f32,
}

/// What to write. Fill with \_init, then set what there is; nothing is kept after the call.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_gltf_scene {
    pub struct_size: u32,
    /// 1: makes area-weighted normals when \`normals\` is NULL. Default 0
    pub smooth_normals: i32,
    /// 3 \* vertex\_count; stored bit for bit
    pub positions: *const f32,
    pub vertex_count: usize,
    /// 3 \* triangle\_count
    pub triangles: *const u32,
    pub triangle_count: usize,
    /// 3 \* vertex\_count unit vectors, or NULL
    pub normals: *const f32,
    /// 2 \* vertex\_count, v going down, or NULL
    pub texture_coordinates: *const f32,
    /// 4 \* vertex\_count: linear red, green, blue, opacity; or NULL
    pub colors: *const u8,
    /// or NULL
    pub morph_targets: *const obc_gltf_morph_target,
    pub morph_target_count: usize,
    /// 2 \* edge\_count vertices, drawn as dark lines; or NULL
    pub edges: *const u32,
    pub edge_count: usize,
    /// of the node: world = translation + scale \* position. Default 0
    pub translation: [f64; 3],
    /// positive. Default 1
    pub scale: f64,
    /// of the material: linear, 0 to 1. Default 0.8 grey, opaque
    pub base_color: [f64; 4],
    /// bytes of a PNG file, or NULL; needs texture\_coordinates
    pub texture: *const c_void,
    pub texture_size: usize,
    /// 1: a checker pattern of 32 by 16 squares when \`texture\` is NULL. Default 0
    pub checker_texture: i32,
    /// 1: morph targets have normals as well; needs normals. Default 0
    pub morph_normals: i32,
    /// UTF-8, of node and mesh. Default "surface"
    pub name: *const c_char,
    /// a JSON object that the scene carries, or NULL
    pub extras: *const c_char,
    /// above 0: an animation from the surface to each morph target in turn and back to it,
    /// so many seconds from one to the next. Default 0: none
    pub morph_seconds: f64,
}

extern "C" {
    /// The defaults, which the members' comments give.
    pub fn obc_gltf_read_options_init(options: *mut obc_gltf_read_options, struct_size: usize) -> i32;
    /// Reads the file at \`path\` (bytes as the system takes them). options and host may be NULL; the host's allocator must stay
    /// valid until \_surface\_destroy. Errors: io, malformed file (its kind says how: truncated, parse, index-range,
    /// accessor-range, unsafe-path, ...), unsupported, degenerate (a transform or welding flattens everything), out of memory,
    /// cancelled. O(n).
    pub fn obc_gltf_read(path: *const c_char, options: *const obc_gltf_read_options, host: *const obc_host, out: *mut *mut obc_gltf_surface, error: *mut obc_error) -> i32;
    /// The same from \`size\` bytes of a GLB or .gltf file, which are not kept; \`folder\` is where buffers in files of their own
    /// lie, NULL refuses them.
    pub fn obc_gltf_read_memory(bytes: *const c_void, size: usize, folder: *const c_char, options: *const obc_gltf_read_options, host: *const obc_host, out: *mut *mut obc_gltf_surface, error: *mut obc_error) -> i32;
    /// Numbers of a surface; 0 for NULL. Notes are what was changed or left out in reading.
    pub fn obc_gltf_surface_vertex_count(surface: *const obc_gltf_surface) -> usize;
    /// Numbers of a surface; 0 for NULL. Notes are what was changed or left out in reading.
    pub fn obc_gltf_surface_triangle_count(surface: *const obc_gltf_surface) -> usize;
    /// Numbers of a surface; 0 for NULL. Notes are what was changed or left out in reading.
    pub fn obc_gltf_surface_welded_vertex_count(surface: *const obc_gltf_surface) -> usize;
    /// Numbers of a surface; 0 for NULL. Notes are what was changed or left out in reading.
    pub fn obc_gltf_surface_note_count(surface: *const obc_gltf_surface) -> usize;
    /// The index-th note, UTF-8, of the surface's; NULL when there is none.
    pub fn obc_gltf_surface_note(surface: *const obc_gltf_surface, index: usize) -> *const c_char;
    /// Copies positions (3 \* vertex\_count, or NULL) and triangles (3 \* triangle\_count indices below vertex\_count, or NULL;
    /// counter-clockwise seen from outside) to the caller's arrays. Errors: invalid argument.
    pub fn obc_gltf_surface_copy(surface: *const obc_gltf_surface, positions: *mut f64, triangles: *mut u32, error: *mut obc_error) -> i32;
    /// Releases a surface; NULL is fine.
    pub fn obc_gltf_surface_destroy(surface: *mut obc_gltf_surface);
    /// The defaults, which the members' comments give, and an empty surface.
    pub fn obc_gltf_scene_init(scene: *mut obc_gltf_scene, struct_size: usize) -> i32;
    /// Writes to \`path\`: .gltf with the buffer inside when it ends so, GLB otherwise. The file appears once it is whole; after
    /// an error the old one is still there. host may be NULL. Errors: invalid argument (sizes, indices, numbers that are not
    /// finite, texts), unsupported (4 GiB or more), io, out of memory, cancelled. O(n).
    pub fn obc_gltf_write(path: *const c_char, scene: *const obc_gltf_scene, host: *const obc_host, error: *mut obc_error) -> i32;
    /// A surface alone, with smooth normals: positions 3 \* vertex\_count, triangles 3 \* triangle\_count.
    pub fn obc_gltf_write_surface(path: *const c_char, positions: *const f32, vertex_count: usize, triangles: *const u32, triangle_count: usize, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Morph targets to the bit. \_delta is what is stored for a base and a wanted coordinate; \_reconstructed is what a renderer
    /// makes of base and delta in float32, and is the wanted one whenever any delta gives it. Finite numbers.
    pub fn obc_gltf_delta(base: f32, wanted: f32) -> f32;
    /// Morph targets to the bit. \_delta is what is stored for a base and a wanted coordinate; \_reconstructed is what a renderer
    /// makes of base and delta in float32, and is the wanted one whenever any delta gives it. Finite numbers.
    pub fn obc_gltf_reconstructed(base: f32, delta: f32) -> f32;
    /// Version of this library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_gltf_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_gltf_read_options>(), align_of::<obc_gltf_read_options>()), (16, 8));
        let it = MaybeUninit::<obc_gltf_read_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_gltf_read_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).weld_identical) } as usize - start as usize, 4, "obc_gltf_read_options.weld_identical");
        assert_eq!(unsafe { addr_of!((*start).morph_target) } as usize - start as usize, 8, "obc_gltf_read_options.morph_target");
        assert_eq!((size_of::<obc_gltf_morph_target>(), align_of::<obc_gltf_morph_target>()), (16, 8));
        let it = MaybeUninit::<obc_gltf_morph_target>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).name) } as usize - start as usize, 0, "obc_gltf_morph_target.name");
        assert_eq!(unsafe { addr_of!((*start).positions) } as usize - start as usize, 8, "obc_gltf_morph_target.positions");
        assert_eq!((size_of::<obc_gltf_scene>(), align_of::<obc_gltf_scene>()), (208, 8));
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
    }
}
