// Surfaces: files in and out, shapes by name, what kind of surface one is. docs/mesh.md.
//
// A surface is any object with `positions` (x y z a vertex, Float64Array) and `triangles` (three indices each,
// Uint32Array); arrays that lie in the module's memory are passed as they are. A Mesh is one in the library's own memory.
import { constants } from './raw/raw.js';
import { Handle, call, constant, getField, make, module, object, options, raw, scratched, text, view, withHost } from './module.js';

/** The address of an obc_surface. */
export function surfaceAt(scratch, surface) {
  if (surface instanceof Mesh) {
    const at = scratch.struct('obc_surface');
    call('obc_mesh_surface', surface.address, at);
    return at;
  }
  const { positions, triangles } = surface;
  if (positions.length % 3 !== 0 || triangles.length % 3 !== 0) throw new RangeError('positions and triangles come in threes');
  return scratch.struct('obc_surface', {
    positions: scratch.array('f64', positions, positions.length), vertex_count: positions.length / 3,
    triangles: scratch.array('u32', triangles, triangles.length), triangle_count: triangles.length / 3,
  });
}

/** Runs body(scratch, surface, host) for functions of a surface. */
export const onSurface = (surface, host, body) =>
  withHost(host, (lent) => scratched((scratch) => body(scratch, surfaceAt(scratch, surface), lent)));

/** The formats of files: `format` for Mesh.read, the `ending`, and whether files hold polygons, cells and binary contents. */
export function formats() {
  const found = [];
  for (let name; (name = text(raw('obc_mesh_format_name', found.length))) !== null;) {
    const held = raw('obc_mesh_format_contents', found.length);
    found.push({
      format: name.toLowerCase(), ending: text(raw('obc_mesh_format_ending', found.length)),
      polygons: (held & constants.OBC_MESH_HOLDS_POLYGONS) !== 0, cells: (held & constants.OBC_MESH_HOLDS_CELLS) !== 0,
      binary: (held & constants.OBC_MESH_HOLDS_BINARY) !== 0, regions: (held & constants.OBC_MESH_HOLDS_REGIONS) !== 0,
    });
  }
  return found;
}

/** The format that a file's name requires. */
export function formatOf(name) {
  const ending = `.${name.toLowerCase().split('.').pop()}`;
  const known = formats();
  const format = known.find((one) => one.ending === ending);
  if (!format) throw new TypeError(`the ending ${ending} is none of ${known.map((one) => one.ending).join(' ')}`);
  return format.format;
}

export class Mesh extends Handle {
  constructor(address) {
    super(address, 'obc_mesh_destroy');
  }

  /** From the bytes of a file in a `format` of formats(). */
  static read(bytes, format, { weldIdentical, ...host } = {}) {
    const content = bytes instanceof Uint8Array ? bytes : new Uint8Array(bytes.buffer ?? bytes);
    return withHost(host, (lent) => scratched((scratch) => {
      const chosen = options(scratch, 'obc_mesh_read_options', { weldIdentical: weldIdentical ? 1 : 0 });
      const at = scratch.array('u8', content, content.length);
      return new Mesh(make('obc_mesh_read_memory', at, content.length, constant('OBC_MESH_', format), chosen, lent));
    }));
  }

  /** A closed surface by name, of about the given number of triangles. */
  static make(shape, triangles, { seed = 0, ...host } = {}) {
    return withHost(host, (lent) => scratched((scratch) =>
      new Mesh(make('obc_mesh_make', scratch.text(shape), triangles, BigInt(seed), lent))));
  }

  /** From arrays, which are copied. `regions`: the number of the region of each triangle, if there are any. */
  static from({ positions, triangles, regions = null }) {
    if (regions && regions.length !== triangles.length / 3)
      throw new RangeError(`${regions.length} region numbers of ${triangles.length / 3} triangles`);
    return scratched((scratch) => new Mesh(make('obc_mesh_create', scratch.struct('obc_mesh_cells', {
      positions: scratch.array('f64', positions, positions.length), vertex_count: positions.length / 3,
      triangles: scratch.array('u32', triangles, triangles.length), triangle_count: triangles.length / 3,
      triangle_regions: regions ? scratch.array('i32', regions, regions.length) : 0,
    }), 0)));
  }

  /** The names that make() knows. */
  static get shapes() {
    const names = [];
    for (let name; (name = text(raw('obc_mesh_shape_name', names.length))) !== null;) names.push(name);
    return names;
  }

  get vertexCount() {
    return raw('obc_mesh_vertex_count', this.address);
  }

  get triangleCount() {
    return raw('obc_mesh_triangle_count', this.address);
  }

  #part(member, type, length) {
    return scratched((scratch) => view(type, getField('obc_surface', surfaceAt(scratch, this), member), length));
  }

  /** A view of the library's memory: it ends when that memory grows, slice() it to keep it. */
  get positions() {
    return this.#part('positions', 'f64', 3 * this.vertexCount);
  }

  /** A view, as `positions`. */
  get triangles() {
    return this.#part('triangles', 'u32', 3 * this.triangleCount);
  }

  /** The number of the region of each triangle, 0 for none, as a copy that stays; null if there are none. */
  get regions() {
    if ((raw('obc_mesh_region_kinds', this.address) & constant('OBC_MESH_', 'triangle_regions')) === 0) return null;
    return scratched((scratch) => {
      const numbers = scratch.room('i32', this.triangleCount);
      call('obc_mesh_copy_regions', this.address, numbers, 0, 0);
      return view('i32', numbers, this.triangleCount).slice();
    });
  }

  /** Copies that stay and that can be sent to a worker. */
  get arrays() {
    return { positions: this.positions.slice(), triangles: this.triangles.slice() };
  }

  get tetrahedronCount() {
    return raw('obc_mesh_tetrahedron_count', this.address);
  }

  /** The solid that its tetrahedra fill, as copies that stay: `positions` and `tetrahedra`, four vertices each. */
  get solid() {
    const [vertices, corners] = [3 * this.vertexCount, 4 * this.tetrahedronCount];
    return scratched((scratch) => {
      const [positions, tetrahedra] = [scratch.room('f64', vertices), scratch.room('u32', corners)];
      call('obc_mesh_copy', this.address, positions, 0, tetrahedra, 0);
      return { positions: view('f64', positions, vertices).slice(), tetrahedra: view('u32', tetrahedra, corners).slice() };
    });
  }

  /** The format that was read, as "PLY, binary, big-endian"; empty for other meshes. */
  get format() {
    return text(raw('obc_mesh_format', this.address));
  }

  /** What was changed or left out in reading. */
  get notes() {
    const notes = [];
    for (let note; (note = text(raw('obc_mesh_note', this.address, notes.length))) !== null;) notes.push(note);
    return notes;
  }
}

const lengthOf = (surface) => (surface instanceof Mesh ? 3 * surface.vertexCount : surface.positions.length);

/** Unit normals of the vertices. */
export const vertexNormals = (surface, host = {}) => onSurface(surface, host, (scratch, at, lent) => {
  const normals = scratch.room('f64', lengthOf(surface));
  call('obc_mesh_vertex_normals', at, lent, normals);
  return view('f64', normals, lengthOf(surface)).slice();
});

/** A third of the area of its triangles for each vertex: the usual weights of a fit by harmonics. */
export const vertexAreas = (surface, host = {}) => onSurface(surface, host, (scratch, at, lent) => {
  const areas = scratch.room('f64', lengthOf(surface) / 3);
  call('obc_mesh_vertex_areas', at, lent, areas);
  return view('f64', areas, lengthOf(surface) / 3).slice();
});

/** The mean distance from points to the nearest of the others, the greater of both ways: the reconstruction error. */
export const meanDistance = (a, b, host = {}) => withHost(host, (lent) => scratched((scratch) => {
  const distance = scratch.room('f64', 1);
  call('obc_mesh_mean_distance', scratch.array('f64', a, a.length), a.length / 3, scratch.array('f64', b, b.length), b.length / 3, lent,
    distance);
  return view('f64', distance, 1)[0];
}));

/** Runs body(path) on a file of its own in the module's memory, and returns what it wrote. */
export function written(ending, body) {
  const { FS } = module();
  const path = `/written.${ending}`;
  try {
    body(path);
    return FS.readFile(path);
  } finally {
    if (FS.analyzePath(path).exists) FS.unlink(path);
  }
}

/** The bytes of a file: obj, off, ply, stl, mesh or vtk. */
export function writeMesh(surface, ending, { binary = true, ...host } = {}) {
  return onSurface(surface, host, (scratch, at, lent) => written(ending, (path) => call('obc_mesh_write_surface',
    scratch.text(path), at, options(scratch, 'obc_mesh_write_options', { binary: binary ? 1 : 0 }), lent)));
}

/** Closed, manifold, genus, area, defects with their locations: the members of obc_mesh_topology_report. */
export function topology(surface, host = {}) {
  return onSurface(surface, host, (scratch, at, lent) => {
    const report = scratch.struct('obc_mesh_topology_report');
    call('obc_mesh_topology', at, lent, report);
    return object('obc_mesh_topology_report', report);
  });
}

/** Throws an OrbicubeError unless the surface is what sphere maps need. */
export function checkClosedGenusZero(surface, host = {}) {
  onSurface(surface, host, (scratch, at, lent) => call('obc_mesh_check_closed_genus_zero', at, lent));
}

/** Triangles turned so that neighbors agree and the surface is outward-oriented, as a new array. */
export function orient({ positions, triangles }, host = {}) {
  return withHost(host, (lent) => scratched((scratch) => {
    const turned = scratch.room('u32', triangles.length);
    view('u32', turned, triangles.length).set(triangles);
    const at = scratch.array('f64', positions, positions.length);
    call('obc_mesh_orient', at, positions.length / 3, turned, triangles.length / 3, lent, 0);
    return view('u32', turned, triangles.length).slice();
  }));
}
