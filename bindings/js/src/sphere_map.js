// Maps of closed surfaces of genus 0 to the unit sphere, and what they are for: docs/sphere_map.md, docs/sphere_map_uses.md.
import { Handle, call, constant, make, object, options, scratched, view, withHost } from './module.js';
import { Mesh, onSurface, surfaceAt } from './mesh.js';

const OPTIONS = 'obc_sphere_map_options';
const REPORT = 'obc_sphere_map_report';
const PREFIX = 'OBC_SPHERE_MAP_';

const lengthOf = (surface) => (surface instanceof Mesh ? 3 * surface.vertexCount : surface.positions.length);

const split = ({ onProgress, signal, ...chosen }) => [{ onProgress, signal }, chosen];

/** Where `out` is written to: an array in the module's memory that the caller gave, or room for a copy. */
function target(scratch, type, length, out) {
  if (!out) return [scratch.room(type, length), (address) => view(type, address, length).slice()];
  if (out.length !== length) throw new RangeError(`out has ${out.length} numbers, not ${length}`);
  const address = scratch.array(type, out, length);
  if (address !== out.byteOffset) throw new TypeError('out is not an array of HeapArray');
  return [address, () => view(type, address, length)];
}

/**
 * A bijective map with little distortion: `directions`, unit vectors in the order of the vertices, and a `report` of figures. `out`
 * is the array of a HeapArray that gets the directions, rather than a new one.
 */
export function sphereMap(surface, { out, ...given } = {}) {
  const [host, chosen] = split(given);
  return onSurface(surface, host, (scratch, at, lent) => {
    const [directions, answer] = target(scratch, 'f64', lengthOf(surface), out);
    const report = scratch.struct(REPORT);
    call('obc_sphere_map_compute', at, options(scratch, OPTIONS, chosen), lent, directions, report);
    return { directions: answer(directions), report: object(REPORT, report) };
  });
}

/** The figures of a map, also of one that is no bijection. */
export function measure(surface, directions, given = {}) {
  const [host, chosen] = split(given);
  return onSurface(surface, host, (scratch, at, lent) => {
    const report = scratch.struct(REPORT);
    call('obc_sphere_map_measure', at, scratch.array('f64', directions, lengthOf(surface), 'directions'),
      options(scratch, OPTIONS, chosen), lent, report);
    return object(REPORT, report);
  });
}

/** Of each triangle its quasi-conformal distortion and area ratio, for coloring. */
export function faceDistortion(surface, directions, host = {}) {
  const count = surface instanceof Mesh ? surface.triangleCount : surface.triangles.length / 3;
  return onSurface(surface, host, (scratch, at, lent) => {
    const quasiConformal = scratch.room('f64', count);
    const areaRatio = scratch.room('f64', count);
    call('obc_sphere_map_face_distortion', at, scratch.array('f64', directions, lengthOf(surface), 'directions'), lent,
      quasiConformal, areaRatio);
    return { quasiConformal: view('f64', quasiConformal, count).slice(), areaRatio: view('f64', areaRatio, count).slice() };
  });
}

/** The map in float32, the precision of engines, still with every triangle positive. */
export function roundToFloat(surface, directions, host = {}) {
  return onSurface(surface, host, (scratch, at, lent) => {
    const rounded = scratch.room('f32', lengthOf(surface));
    call('obc_sphere_map_round_to_float', at, scratch.array('f64', directions, lengthOf(surface), 'directions'), lent, rounded);
    return view('f32', rounded, lengthOf(surface)).slice();
  });
}

/** The inverse of a map: which triangle of the surface a direction lies in, and what the surface has there. */
export class Locator extends Handle {
  constructor(surface, directions, host = {}) {
    super(onSurface(surface, host, (scratch, at, lent) => make('obc_sphere_map_locator_create', at,
      scratch.array('f64', directions, lengthOf(surface), 'directions'), lent)), 'obc_sphere_map_locator_destroy');
    this.vertexCount = lengthOf(surface) / 3;
  }

  /** Of each direction its triangle and the weights of that one's corners. */
  locate(directions, host = {}) {
    const count = directions.length / 3;
    return withHost(host, (lent) => scratched((scratch) => {
      const triangles = scratch.room('u32', count);
      const weights = scratch.room('f64', 3 * count);
      call('obc_sphere_map_locate', this.address, scratch.array('f64', directions, 3 * count), count, lent, triangles, weights);
      return { triangles: view('u32', triangles, count).slice(), weights: view('f64', weights, 3 * count).slice() };
    }));
  }

  /** Values of the vertices (any number of components each), interpolated at each direction. */
  sample(directions, values, { unit = false, ...host } = {}) {
    const count = directions.length / 3;
    const components = values.length / this.vertexCount;
    return withHost(host, (lent) => scratched((scratch) => {
      const sampled = scratch.room('f64', components * count);
      call('obc_sphere_map_sample', this.address, scratch.array('f64', directions, 3 * count), count,
        scratch.array('f64', values, values.length), components, unit ? 1 : 0, lent, sampled);
      return view('f64', sampled, components * count).slice();
    }));
  }

  /** The surface on a regular triangulation: grid "icosphere", "cube", "latitude" or "octahedron". */
  remesh(positions, grid, resolution, host = {}) {
    return withHost(host, (lent) => scratched((scratch) => new Mesh(make('obc_sphere_map_remesh', this.address,
      scratch.array('f64', positions, 3 * this.vertexCount, 'positions'), constant(PREFIX, grid), resolution, lent))));
  }
}

/** A regular triangulation of the sphere. */
export const grid = (kind, resolution, host = {}) =>
  withHost(host, (lent) => new Mesh(make('obc_sphere_map_grid', constant(PREFIX, kind), resolution, lent)));

/** The rotation, row by row, that takes `from` nearest to `to`. */
export function bestRotation(from, to) {
  return scratched((scratch) => {
    const rotation = scratch.room('f64', 9);
    const count = from.length / 3;
    call('obc_sphere_map_best_rotation', scratch.array('f64', from, 3 * count), scratch.array('f64', to, 3 * count), count, rotation);
    return view('f64', rotation, 9).slice();
  });
}

/** One triangulation of the sphere with the vertices of two maps; of the second ones `secondVertex` says where they are. */
export function overlay(first, firstDirections, second, secondDirections, host = {}) {
  return onSurface(first, host, (scratch, at, lent) => {
    const count = lengthOf(second) / 3;
    const secondVertex = scratch.room('u32', count);
    const out = scratch.bytes(4);
    call('obc_sphere_map_overlay', at, scratch.array('f64', firstDirections, lengthOf(first)), surfaceAt(scratch, second),
      scratch.array('f64', secondDirections, 3 * count), lent, out, secondVertex);
    return { mesh: new Mesh(view('u32', out, 1)[0]), secondVertex: view('u32', secondVertex, count).slice() };
  });
}
