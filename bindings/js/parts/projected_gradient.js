// orbicube/projected_gradient: what of the package is for one solver, over a module of its own.
import * as projectedGradient from './projected_gradient.js';

export { OrbicubeError } from './errors.js';
export { HeapArray, ready } from './module.js';
export { EvaluationFailed, StopRun } from './solver.js';
export { ProjectedGradient } from './projected_gradient.js';
export { projectedGradient };
