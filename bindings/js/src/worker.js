// The worker's side of client.js: one piece of work after the other, with progress and cancellation.
import { ready } from './module.js';
import { Mesh, formatOf } from './mesh.js';
import { sphereMap } from './sphere_map.js';
import { polycube } from './polycube.js';
import { readGltf, writeGlb } from './gltf.js';
import { facing, morph, sphereGlb } from './morph.js';
import { ofNode } from './node.js';

/** What a worker can do; results are plain objects with arrays, which are moved and not copied. */
const works = {
  read({ bytes, name, ...given }, host) {
    if (/\.(glb|gltf)$/i.test(name)) return readGltf(bytes, { ...given, ...host });
    const mesh = Mesh.read(bytes, formatOf(name), { ...given, ...host });
    const result = { ...mesh.arrays, notes: mesh.notes };
    mesh.close();
    return result;
  },
  make({ shape, triangles, seed }, host) {
    const mesh = Mesh.make(shape, triangles, { seed, ...host });
    const result = mesh.arrays;
    mesh.close();
    return result;
  },
  sphereMap({ surface, facing: turn = false, ...given }, host) {
    const { directions, report } = sphereMap(surface, { ...given, ...host });
    return { directions: turn ? facing(surface, directions, host) : directions, report };
  },
  polycube({ surface, ...given }, host) {
    const map = polycube(surface, { ...given, ...host });
    const result = { ...map.arrays, ...map.triangleParts, corners: map.corners };
    map.close();
    return result;
  },
  morph: ({ first, firstDirections, second, secondDirections }, host) =>
    morph(first, firstDirections, second, secondDirections, host),
  sphereGlb: ({ surface, directions, name }, host) => ({ bytes: sphereGlb(surface, directions, { name, ...host }) }),
  glb: ({ scene }, host) => ({ bytes: writeGlb(scene, host) }),
};

const inNode = typeof self === 'undefined';
const port = inNode ? (await ofNode('worker_threads')).parentPort : self;
const listen = (listener) => (inNode ? port.on('message', listener) : port.addEventListener('message', (event) => listener(event.data)));

listen(async ({ id, work, given, cancel }) => {
  try {
    await ready;
    const flag = cancel ? new Int32Array(cancel) : null;
    const onProgress = (at) => {
      if (flag && Atomics.load(flag, 0) === 1) return false;
      port.postMessage({ id, progress: at });
      return true;
    };
    if (!(work in works)) throw new TypeError(`a worker does not know "${work}"`);
    const result = works[work](given, { onProgress });
    port.postMessage({ id, result }, Object.values(result).filter(ArrayBuffer.isView).map((array) => array.buffer));
  } catch (problem) {
    const { name, message, kind, status } = problem;
    port.postMessage({ id, problem: { name, message, kind, status } });
  }
});
