// Minimizes f over products of unit spheres: docs/sphere_optimizer.md.
import { call, make, options, scratched, view } from './module.js';
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

  /** With hessianProducts, the vector whose product with the Hessian at the point is requested; null: value and gradient are. */
  get direction() {
    if (!this.wantsProduct) return null;
    return scratched((scratch) => {
      const out = scratch.room('u32', 1);
      call(`${PREFIX}_get_direction`, this.address, out);
      return view('f64', view('u32', out, 1)[0], this.n).slice();
    });
  }

  /** That product; null, or an entry that is not finite: there is none. */
  tellProduct(product) {
    if (!product) return call(`${PREFIX}_tell_product`, this.address, 0);
    if (product !== this.answers) this.answers.set(product);
    return call(`${PREFIX}_tell_product`, this.address, this.answersAt);
  }

  /** Calls f(x, gradient) and hessianProduct(x, direction, product), which writes the product, until the run has ended. */
  run(f, { hessianProduct, ...host } = {}) {
    if (!hessianProduct) return super.run(f, host);
    return this.drive((x) => {
      const { answers, direction } = this;
      if (!direction) return this.tell(f(x, answers), answers);
      hessianProduct(x, direction, answers);
      return this.tellProduct(answers);
    }, () => (this.wantsProduct ? this.tellProduct(null) : this.tell(NaN)), (value) => {
      if (!this.wantsProduct) this.tell(value, new Float64Array(this.n));
    }, host);
  }

  /** Goes on with a run that was saved; of x0 only the length counts. */
  static load(saved, x0) {
    return new SphereOptimizer(x0, { saved });
  }
}

/**
 * The minimum value of f(x, gradient) that is found from x0. What f gets is used again: copy what you keep. With
 * hessianProduct(x, direction, product) the method is truncatedNewton.
 */
export function minimize(f, x0, { hessianProduct, ...given } = {}) {
  if (!hessianProduct) return minimizeWithGradients(SphereOptimizer, f, x0, given);
  return minimizeWithGradients(SphereOptimizer, f, x0, { ...given, method: 'truncatedNewton', hessianProducts: true }, { hessianProduct });
}
