//! Surfaces from glTF 2.0 files and to them.

use std::path::Path;

use crate::call::{c_path, c_string, call, checked, expect_length, pointer, rows, text, Error, Host};
use crate::sys::base::{obc_error, obc_host};
use crate::sys::gltf::*;

filled!(/// Options of reading; a morph target is named in [`read`].
    ReadOptions, obc_gltf_read_options, obc_gltf_read_options_init);

/// What was read. `kept`: with the option `keep`, the rest of the file, for [`Scene::kept`] and [`write_kept`]; none where the file
/// does not allow it, with a note.
#[derive(Clone, Default)]
pub struct Surface {
    pub positions: Vec<f64>,
    pub triangles: Vec<u32>,
    pub welded_vertex_count: usize,
    pub notes: Vec<String>,
    pub kept: Option<std::rc::Rc<Kept>>,
}

handle!(/// What a file has besides its surface: materials, textures, texture coordinates, nodes, skins, animations, extras.
    Kept, obc_gltf_surface, obc_gltf_surface_destroy);

/// Reads GLB and glTF in JSON; with the name of a morph target, that shape of it.
pub fn read(path: impl AsRef<Path>, morph_target: Option<&str>, options: &ReadOptions, host: &mut Host) -> Result<Surface, Error> {
    let path = c_path(path.as_ref())?;
    taken(morph_target, options, host, |options, host, out, error| unsafe { obc_gltf_read(path.as_ptr(), options, host, out, error) })
}

/// The same from bytes; buffers in files of their own lie in `folder`, without one they are refused.
pub fn read_memory(bytes: &[u8], folder: Option<&Path>, morph_target: Option<&str>, options: &ReadOptions,
                   host: &mut Host) -> Result<Surface, Error> {
    let folder = folder.map(c_path).transpose()?;
    let folder = folder.as_ref().map_or(std::ptr::null(), |name| name.as_ptr());
    taken(morph_target, options, host, |options, host, out, error| unsafe {
        obc_gltf_read_memory(bytes.as_ptr() as *const _, bytes.len(), folder, options, host, out, error)
    })
}

fn taken(morph_target: Option<&str>, options: &ReadOptions, host: &mut Host,
         f: impl FnOnce(*const obc_gltf_read_options, *const obc_host, *mut *mut obc_gltf_surface, *mut obc_error) -> i32) -> Result<Surface, Error> {
    let target = morph_target.map(c_string).transpose()?;
    let mut options = options.0;
    options.morph_target = target.as_ref().map_or(std::ptr::null(), |name| name.as_ptr());
    let mut out = std::ptr::null_mut();
    call(host, |host, error| f(&options, host, &mut out, error))?;
    let handle = Kept::own(out);
    let out = handle.as_ptr();
    let mut surface = Surface::default();
    unsafe {
        surface.positions.resize(3 * obc_gltf_surface_vertex_count(out), 0.0);
        surface.triangles.resize(3 * obc_gltf_surface_triangle_count(out), 0);
        surface.welded_vertex_count = obc_gltf_surface_welded_vertex_count(out);
        surface.notes = (0..obc_gltf_surface_note_count(out)).map(|i| text(obc_gltf_surface_note(out, i))).collect();
        checked(|error| obc_gltf_surface_copy(out, surface.positions.as_mut_ptr(), surface.triangles.as_mut_ptr(), error))?;
    }
    if unsafe { obc_gltf_surface_keeps(out) } != 0 {
        surface.kept = Some(std::rc::Rc::new(handle));
    }
    Ok(surface)
}

/// What to write: arrays, and what engines show besides. Empty: none.
#[derive(Clone, Copy, Default)]
pub struct Scene<'a> {
    pub positions: &'a [f32],
    pub triangles: &'a [u32],
    pub normals: &'a [f32],
    pub texture_coordinates: &'a [f32],
    /// Names, and where the vertices are.
    pub morph_targets: &'a [(&'a str, &'a [f32])],
    pub name: Option<&'a str>,
    pub smooth_normals: bool,
    pub checker_texture: bool,
    /// Red, green, blue and alpha a vertex.
    pub colors: &'a [[u8; 4]],
    pub edges: &'a [[u32; 2]],
    /// A PNG or JPEG file.
    pub texture: &'a [u8],
    pub translation: Option<[f64; 3]>,
    pub scale: Option<f64>,
    pub base_color: Option<[f64; 4]>,
    /// JSON.
    pub extras: Option<&'a str>,
    pub morph_normals: bool,
    /// So long an animation to the first target and back takes.
    pub morph_seconds: Option<f64>,
    /// The rest of a file that was read, with which this surface is written.
    pub kept: Option<&'a Kept>,
    /// Where the vertices lie on the surface that was read, for other triangles than its own.
    pub kept_positions: &'a [f64],
}

/// Writes GLB, or JSON with the ending `gltf`.
pub fn write(path: impl AsRef<Path>, scene: &Scene, host: &mut Host) -> Result<(), Error> {
    let path = c_path(path.as_ref())?;
    let n = rows(scene.positions.len(), 3, "positions")?;
    let mut c: obc_gltf_scene = unsafe { std::mem::zeroed() };
    unsafe { obc_gltf_scene_init(&mut c, std::mem::size_of::<obc_gltf_scene>()) };
    c.positions = pointer(scene.positions);
    c.vertex_count = n;
    c.triangles = pointer(scene.triangles);
    c.triangle_count = rows(scene.triangles.len(), 3, "triangles")?;
    for (array, width, what, to) in [(scene.normals, 3, "normals", &mut c.normals),
                                     (scene.texture_coordinates, 2, "texture_coordinates", &mut c.texture_coordinates)] {
        if !array.is_empty() {
            expect_length(array.len(), width * n, what)?;
            *to = array.as_ptr();
        }
    }
    let mut names = vec![];
    for (name, positions) in scene.morph_targets {
        expect_length(positions.len(), 3 * n, name)?;
        names.push(c_string(name)?);
    }
    let targets: Vec<obc_gltf_morph_target> = scene.morph_targets.iter().zip(&names)
        .map(|((_, positions), name)| obc_gltf_morph_target { name: name.as_ptr(), positions: positions.as_ptr() }).collect();
    c.morph_targets = pointer(&targets);
    c.morph_target_count = targets.len();
    let name = scene.name.map(c_string).transpose()?;
    if let Some(name) = &name {
        c.name = name.as_ptr();
    }
    if !scene.colors.is_empty() {
        expect_length(scene.colors.len(), n, "colors")?;
        c.colors = scene.colors.as_ptr() as *const u8;
    }
    c.edges = pointer(scene.edges) as *const u32;
    c.edge_count = scene.edges.len();
    c.texture = pointer(scene.texture) as *const _;
    c.texture_size = scene.texture.len();
    let extras = scene.extras.map(c_string).transpose()?;
    if let Some(extras) = &extras {
        c.extras = extras.as_ptr();
    }
    c.translation = scene.translation.unwrap_or(c.translation);
    c.scale = scene.scale.unwrap_or(c.scale);
    c.base_color = scene.base_color.unwrap_or(c.base_color);
    c.morph_normals = i32::from(scene.morph_normals);
    c.morph_seconds = scene.morph_seconds.unwrap_or(c.morph_seconds);
    c.smooth_normals = i32::from(scene.smooth_normals);
    c.checker_texture = i32::from(scene.checker_texture);
    c.kept = scene.kept.map_or(std::ptr::null(), |kept| kept.as_ptr() as *const _);
    if !scene.kept_positions.is_empty() {
        expect_length(scene.kept_positions.len(), 3 * n, "kept_positions")?;
        c.kept_positions = scene.kept_positions.as_ptr();
    }
    call(host, |host, error| unsafe { obc_gltf_write(path.as_ptr(), &c, host, error) })
}

/// Writes the file of a surface read with the option `keep` again, with all that it has.
pub fn write_kept(path: impl AsRef<Path>, kept: &Kept, host: &mut Host) -> Result<(), Error> {
    let path = c_path(path.as_ref())?;
    call(host, |host, error| unsafe { obc_gltf_write_kept(path.as_ptr(), kept.as_ptr(), host, error) })
}
