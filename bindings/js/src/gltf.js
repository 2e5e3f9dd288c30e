// glTF 2.0: surfaces from GLB files and glTF in JSON, and GLB files with morph targets for engines. docs/gltf.md.
import { layouts } from './raw/raw.js';
import { call, make, raw, scratched, setField, text, view, withHost } from './module.js';
import { written } from './mesh.js';

/** Any list of numbers as float32. */
const floats = (scratch, values, length, name) =>
  scratch.array('f32', values instanceof Float32Array ? values : Float32Array.from(values), length, name);

/**
 * The bytes of a GLB file. `scene.positions` and `scene.triangles` are needed; `morphTargets` are objects {name, positions} with
 * where the vertices are (not deltas), `textureCoordinates` two a vertex, `colors` four bytes a vertex.
 */
export function writeGlb(scene, host = {}) {
  const { positions, triangles, normals, textureCoordinates, colors, morphTargets = [], edges, translation, scale, baseColor,
    texture, checker = false, smoothNormals = !normals, morphNormals = morphTargets.length > 0, name, extras,
    morphSeconds } = scene;
  const vertices = positions.length / 3;
  return withHost(host, (lent) => scratched((scratch) => {
    const members = {
      positions: floats(scratch, positions, 3 * vertices), vertex_count: vertices,
      triangles: scratch.array('u32', triangles, triangles.length), triangle_count: triangles.length / 3,
      smooth_normals: smoothNormals ? 1 : 0, morph_normals: morphNormals ? 1 : 0, checker_texture: checker ? 1 : 0,
    };
    if (normals) members.normals = floats(scratch, normals, 3 * vertices, 'normals');
    if (textureCoordinates) members.texture_coordinates = floats(scratch, textureCoordinates, 2 * vertices, 'textureCoordinates');
    if (colors) members.colors = scratch.array('u8', colors, 4 * vertices, 'colors');
    if (edges) Object.assign(members, { edges: scratch.array('u32', edges, edges.length), edge_count: edges.length / 2 });
    if (texture) Object.assign(members, { texture: scratch.array('u8', texture, texture.length), texture_size: texture.length });
    if (translation) members.translation = translation;
    if (scale !== undefined) members.scale = scale;
    if (baseColor) members.base_color = baseColor;
    if (name !== undefined) members.name = scratch.text(name);
    if (extras) members.extras = scratch.text(typeof extras === 'string' ? extras : JSON.stringify(extras));
    if (morphSeconds) members.morph_seconds = morphSeconds;
    if (morphTargets.length > 0) {
      const { size } = layouts.obc_gltf_morph_target;
      const at = scratch.bytes(size * morphTargets.length);
      morphTargets.forEach((target, i) => {
        setField('obc_gltf_morph_target', at + size * i, 'name', scratch.text(target.name));
        setField('obc_gltf_morph_target', at + size * i, 'positions', floats(scratch, target.positions, 3 * vertices, target.name));
      });
      Object.assign(members, { morph_targets: at, morph_target_count: morphTargets.length });
    }
    return written('glb', (path) => call('obc_gltf_write', scratch.text(path), scratch.struct('obc_gltf_scene', members), lent));
  }));
}

/** The triangles of a file of GLB or glTF in JSON as a surface, with notes on what was changed or left out. */
export function readGltf(bytes, { weldIdentical = true, morphTarget, ...host } = {}) {
  const content = bytes instanceof Uint8Array ? bytes : new Uint8Array(bytes.buffer ?? bytes);
  return withHost(host, (lent) => scratched((scratch) => {
    const chosen = scratch.struct('obc_gltf_read_options', {
      weld_identical: weldIdentical ? 1 : 0, morph_target: scratch.text(morphTarget),
    });
    const surface = make('obc_gltf_read_memory', scratch.array('u8', content, content.length), content.length, 0, chosen, lent);
    try {
      const vertices = 3 * raw('obc_gltf_surface_vertex_count', surface);
      const corners = 3 * raw('obc_gltf_surface_triangle_count', surface);
      const positions = scratch.room('f64', vertices);
      const triangles = scratch.room('u32', corners);
      call('obc_gltf_surface_copy', surface, positions, triangles);
      const notes = Array.from({ length: raw('obc_gltf_surface_note_count', surface) },
        (_, i) => text(raw('obc_gltf_surface_note', surface, i)));
      return { positions: view('f64', positions, vertices).slice(), triangles: view('u32', triangles, corners).slice(), notes };
    } finally {
      raw('obc_gltf_surface_destroy', surface);
    }
  }));
}
