// Orbicube in JavaScript: everything that docs/javascript.md shows.
import * as trustRegion from './trust_region.js';
import * as projectedGradient from './projected_gradient.js';
import * as harmonics from './harmonics.js';
import * as sphereOptimizer from './sphere_optimizer.js';
import { module, raw as invoke } from './module.js';

export { OrbicubeError } from './errors.js';
export { HeapArray, ready } from './module.js';
export { EvaluationFailed, StopRun } from './solver.js';
export { trustRegion, projectedGradient, sphereOptimizer, harmonics };
export { TrustRegion } from './trust_region.js';
export { ProjectedGradient } from './projected_gradient.js';
export { SphereOptimizer } from './sphere_optimizer.js';
export { Mesh, checkClosedGenusZero, formatOf, formats, meanDistance, orient, topology, vertexAreas, vertexNormals, writeMesh } from './mesh.js';
export { Locator, bestRotation, faceDistortion, grid, measure, overlay, roundToFloat, sphereMap } from './sphere_map.js';
export { Atlas, Polycube, commonPolycube, polycube } from './polycube.js';
export { frameField, matchings, measureFrames, singularities } from './frame_field.js';
export { hexahedra } from './hexmesh.js';
export { untangle } from './untangle.js';
export { solidMap } from './volume_map.js';
export { readGltf, writeGlb } from './gltf.js';
export { boxOf, facing, morph, normalized, octahedronCoordinates, sphereGlb } from './morph.js';
export { OrbicubeWorker } from './client.js';

export * as raw from './raw/raw.js';

/** The C functions as they are, by their names, and the memory they work on: raw/raw.d.ts. */
export const c = new Proxy({}, {
  get: (_, name) => (name === 'memory' ? module().HEAPU8.buffer : module()[`_${name}`]),
});

/** major * 10000 + minor * 100 + patch of the libraries. */
export const version = () => invoke('obc_base_version');
