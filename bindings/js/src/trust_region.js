// Minimizes f(x), or a sum of squares of residuals, within bounds, from values alone: docs/trust_region.md.
import { call, make, options, scratched, view } from './module.js';
import { Run, spread } from './solver.js';

function problemOf(scratch, n, residuals, { lower, upper, scale, sign }) {
  return scratch.struct('obc_trust_region_problem', {
    n, residuals,
    lower: spread(scratch, lower, n, 'lower'), upper: spread(scratch, upper, n, 'upper'),
    scale: spread(scratch, scale, n, 'scale'), sign: spread(scratch, sign, residuals, 'sign'),
  });
}

/** A run by reverse communication. */
export class TrustRegion extends Run {
  constructor(x0, { residuals = 0, lower, upper, scale, sign, saved, ...chosen } = {}) {
    const n = x0.length;
    const address = scratched((scratch) => {
      const problem = problemOf(scratch, n, residuals, { lower, upper, scale, sign });
      if (saved) return make('obc_trust_region_load', problem, scratch.array('u8', saved, saved.length), saved.length, 0);
      const picked = options(scratch, 'obc_trust_region_options', chosen);
      return make('obc_trust_region_create', problem, picked, scratch.array('f64', x0, n, 'x0'), 0);
    });
    super('obc_trust_region', address, n, Math.max(1, residuals));
  }

  /** Goes on with a run that was saved, of the same problem; of x0 only the length counts. */
  static load(saved, x0, problem = {}) {
    return new TrustRegion(x0, { ...problem, saved });
  }

  /** The point at which f, or the residuals, are requested next; null when the run has ended. */
  ask() {
    return this.next()?.slice() ?? null;
  }

  /** All points that may be evaluated at the same time; tell each in order. */
  askAll() {
    const first = this.next();
    if (first === null) return null;
    return Array.from({ length: this.waiting }, (_, i) => view('f64', first.byteOffset + 8 * i * this.n, this.n).slice());
  }

  /** The value, or the residuals, at the first point requested; null: there is none. */
  tell(outputs) {
    if (outputs === null || outputs === undefined) return this.answer(0);
    const { answers } = this;
    if (typeof outputs === 'number' && this.outputs === 1) answers[0] = outputs;
    else if (outputs.length === this.outputs) answers.set(outputs);
    else throw new RangeError(`${outputs.length ?? 1} outputs, not ${this.outputs}`);
    return this.answer(this.answersAt);
  }

  /** Evaluations made before: points with their outputs; before the first question. */
  give(points, outputs) {
    scratched((scratch) => {
      const count = points.length;
      const rows = scratch.array('f64', points.flatMap((point) => [...point]), count * this.n, 'points');
      const values = scratch.array('f64', outputs.flat(), count * this.outputs, 'outputs');
      call('obc_trust_region_give', this.address, rows, values, count);
    });
  }

  resultArguments(x) {
    return [x, 0];
  }

  /** Calls f until the run has ended. */
  run(f, host) {
    return this.drive((x) => this.tell(f(x)), () => this.tell(null), (outputs) => this.tell(outputs), host);
  }
}

function run(f, x0, given) {
  const { onProgress, signal, ...chosen } = given;
  const solver = new TrustRegion(x0, chosen);
  try {
    return solver.run(f, { onProgress, signal, limit: chosen.maxEvaluations ?? 500 * (x0.length + 1) });
  } finally {
    solver.close();
  }
}

/** The minimum value of f that is found from x0. The x that f gets is used again: copy what you keep. */
export const minimize = (f, x0, given = {}) => run(f, x0, given);

/** The minimum sum of squares of `count` residuals; f returns them. */
export const leastSquares = (f, x0, count, given = {}) => run(f, x0, { ...given, residuals: count });
