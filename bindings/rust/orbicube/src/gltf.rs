//! Surfaces from glTF 2.0 files and to them.

use std::path::Path;

use crate::call::{c_path, c_string, call, checked, expect_length, pointer, rows, text, Error, Host};
use crate::sys::gltf::*;

filled!(/// Options of reading; a morph target is named in [`read`].
    ReadOptions, obc_gltf_read_options, obc_gltf_read_options_init);

/// What was read.
#[derive(Clone, Debug, Default)]
pub struct Surface {
    pub positions: Vec<f64>,
    pub triangles: Vec<u32>,
    pub welded_vertex_count: usize,
    pub notes: Vec<String>,
}

handle!(Handle, obc_gltf_surface, obc_gltf_surface_destroy);

/// Reads .glb and .gltf; with the name of a morph target, that shape of it.
pub fn read(path: impl AsRef<Path>, morph_target: Option<&str>, options: &ReadOptions, host: &mut Host) -> Result<Surface, Error> {
    let path = c_path(path.as_ref())?;
    let target = morph_target.map(c_string).transpose()?;
    let mut options = options.0;
    options.morph_target = target.as_ref().map_or(std::ptr::null(), |name| name.as_ptr());
    let mut out = std::ptr::null_mut();
    call(host, |host, error| unsafe { obc_gltf_read(path.as_ptr(), &options, host, &mut out, error) })?;
    let handle = Handle::own(out);
    let out = handle.as_ptr();
    let mut surface = Surface::default();
    unsafe {
        surface.positions.resize(3 * obc_gltf_surface_vertex_count(out), 0.0);
        surface.triangles.resize(3 * obc_gltf_surface_triangle_count(out), 0);
        surface.welded_vertex_count = obc_gltf_surface_welded_vertex_count(out);
        surface.notes = (0..obc_gltf_surface_note_count(out)).map(|i| text(obc_gltf_surface_note(out, i))).collect();
        checked(|error| obc_gltf_surface_copy(out, surface.positions.as_mut_ptr(), surface.triangles.as_mut_ptr(), error))?;
    }
    Ok(surface)
}

/// What to write: arrays, and what engines show besides. Empty: none.
#[derive(Clone, Copy, Debug, Default)]
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
}

/// Writes GLB, or .gltf by the ending.
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
    c.smooth_normals = i32::from(scene.smooth_normals);
    c.checker_texture = i32::from(scene.checker_texture);
    call(host, |host, error| unsafe { obc_gltf_write(path.as_ptr(), &c, host, error) })
}
