// Minimises f over products of unit spheres: docs/sphere_optimizer.md.
import { make, options, scratched } from './module.js';
import { Run } from './solver.js';

const PREFIX = 'obc_sphere_optimizer';

/** A run by questions and answers over unit vectors of `dimension` numbers, one after the other in x0. */
export class SphereOptimizer extends Run {
  constructor(x0, { dimension = 3, saved, ...chosen } = {}) {
    const n = x0.length;
    const address = scratched((scratch) => {
      if (saved) return make(`${PREFIX}_load`, scratch.array('u8', saved, saved.length), saved.length, 0);
      const picked = options(scratch, `${PREFIX}_options`, chosen, 'OBC_SPHERE_OPTIMIZER_');
      if (n % dimension !== 0) throw new RangeError(`${n} numbers are not vectors of ${dimension}`);
      return make(`${PREFIX}_create`, n / dimension, dimension, picked, scratch.array('f64', x0, n), 0);
    });
    super(PREFIX, address, n, n);
  }

  /** Goes on with a run that was saved; of x0 only the length counts. */
  static load(saved, x0) {
    return new SphereOptimizer(x0, { saved });
  }

  /** The point at which value and gradient are wanted next; null when the run has ended. */
  ask() {
    return this.next()?.slice() ?? null;
  }

  /** Value and gradient at the point asked for; a value that is not finite: there is none. */
  tell(value, gradient) {
    if (!Number.isFinite(value) || !gradient) return this.answer(NaN, 0);
    if (gradient !== this.answers) this.answers.set(gradient);
    return this.answer(value, this.answersAt);
  }

  /** Asks f(x, gradient) until the run has ended; it writes the gradient and answers the value. */
  run(f, host) {
    return this.drive((x) => {
      const { answers } = this;
      const value = f(x, answers);
      if (answers.length === 0) throw new Error('the memory grew within f: the gradient is lost');
      this.tell(value, answers);
    }, () => this.tell(NaN), host);
  }
}

/** The least value of f(x, gradient) that is found from x0. What f gets is used again: copy what you keep. */
export function minimize(f, x0, { onProgress, signal, ...given } = {}) {
  const solver = new SphereOptimizer(x0, given);
  try {
    return solver.run(f, { onProgress, signal, limit: given.maxEvaluations ?? 100000 });
  } finally {
    solver.close();
  }
}
