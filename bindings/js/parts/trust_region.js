// orbicube/trust_region: what of the package is for one solver, over a module of its own.
import * as trustRegion from './trust_region.js';

export { OrbicubeError } from './errors.js';
export { HeapArray, ready } from './module.js';
export { EvaluationFailed, StopRun } from './solver.js';
export { TrustRegion } from './trust_region.js';
export { trustRegion };
