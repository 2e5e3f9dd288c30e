// Minimizes f over products of unit spheres: docs/sphere_optimizer.md.
import { make, options, scratched } from './module.js';
import { GradientRun, minimizeWithGradients } from './solver.js';

const PREFIX = 'obc_sphere_optimizer';

/** A run by reverse communication over unit vectors of `dimension` numbers, one after the other in x0. */
export class SphereOptimizer extends GradientRun {
  constructor(x0, { dimension = 3, saved, ...chosen } = {}) {
    const n = x0.length;
    const address = scratched((scratch) => {
      if (saved) return make(`${PREFIX}_load`, scratch.array('u8', saved, saved.length), saved.length, 0);
      const picked = options(scratch, `${PREFIX}_options`, chosen);
      if (n % dimension !== 0) throw new RangeError(`${n} numbers are not vectors of ${dimension}`);
      return make(`${PREFIX}_create`, n / dimension, dimension, picked, scratch.array('f64', x0, n), 0);
    });
    super(PREFIX, address, n, n);
  }

  /** Goes on with a run that was saved; of x0 only the length counts. */
  static load(saved, x0) {
    return new SphereOptimizer(x0, { saved });
  }
}

/** The minimum value of f(x, gradient) that is found from x0. What f gets is used again: copy what you keep. */
export function minimize(f, x0, given = {}) {
  return minimizeWithGradients(SphereOptimizer, f, x0, given);
}
