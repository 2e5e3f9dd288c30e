// orbicube/sphere_optimizer: what of the package is for one solver, over a module of its own.
import * as sphereOptimizer from './sphere_optimizer.js';

export { OrbicubeError } from './errors.js';
export { HeapArray, ready } from './module.js';
export { EvaluationFailed, StopRun } from './solver.js';
export { SphereOptimizer } from './sphere_optimizer.js';
export { sphereOptimizer };
