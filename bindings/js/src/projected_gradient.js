// Minimizes f with gradients, subject to bounds and linear equations: docs/projected_gradient.md.
import { call, make, object, options, raw, scratched, text, view } from './module.js';
import { GradientRun, minimizeWithGradients, spread } from './solver.js';

const PREFIX = 'obc_projected_gradient';

/** Rows [[...], ...] without their zeros, as C takes them. */
function problemOf(scratch, n, { lower, upper, A, b }) {
  const members = { n, lower: spread(scratch, lower, n, 'lower'), upper: spread(scratch, upper, n, 'upper') };
  if (A) {
    const starts = [0];
    const columns = [];
    const values = [];
    for (const row of A) {
      if (row.length !== n) throw new RangeError(`a row of A has ${row.length} numbers, not ${n}`);
      row.forEach((x, j) => {
        if (x !== 0) {
          columns.push(j);
          values.push(x);
        }
      });
      starts.push(values.length);
    }
    Object.assign(members, {
      m: A.length, row_start: scratch.array('u32', starts, starts.length), column: scratch.array('u32', columns, columns.length),
      value: scratch.array('f64', values, values.length), b: scratch.array('f64', b, A.length, 'b'),
    });
  }
  return scratch.struct(`${PREFIX}_problem`, members);
}

/** A run by reverse communication. */
export class ProjectedGradient extends GradientRun {
  constructor(x0, { lower, upper, A, b, saved, ...chosen } = {}) {
    const n = x0.length;
    const address = scratched((scratch) => {
      const problem = problemOf(scratch, n, { lower, upper, A, b });
      if (saved) return make(`${PREFIX}_load`, problem, scratch.array('u8', saved, saved.length), saved.length, 0);
      const picked = options(scratch, `${PREFIX}_options`, chosen);
      return make(`${PREFIX}_create`, problem, picked, scratch.array('f64', x0, n, 'x0'), 0);
    });
    super(PREFIX, address, n, n);
    this.rows = A?.length ?? 0;
  }

  /** Goes on with a run that was saved, of the same problem; of x0 only the length counts. */
  static load(saved, x0, problem = {}) {
    return new ProjectedGradient(x0, { ...problem, saved });
  }

  /** Of each row its multiplier at the current iterate. */
  get multipliers() {
    return scratched((scratch) => {
      const out = scratch.room('f64', this.rows);
      call(`${PREFIX}_multipliers`, this.address, out);
      return view('f64', out, this.rows).slice();
    });
  }
}

/** The minimum value of f(x, gradient) that is found from x0. What f gets is used again: copy what you keep. */
export function minimize(f, x0, given = {}) {
  return minimizeWithGradients(ProjectedGradient, f, x0, given);
}

/** The feasible point nearest to y, with how that ended. */
export function project(y, problem) {
  return scratched((scratch) => {
    const n = y.length;
    const x = scratch.room('f64', n);
    const result = scratch.struct(`${PREFIX}_result`);
    call(`${PREFIX}_project`, problemOf(scratch, n, problem), scratch.array('f64', y, n), x, 0, result, 0);
    const report = object(`${PREFIX}_result`, result);
    return { x: view('f64', x, n).slice(), stop: text(raw(`${PREFIX}_stop_name`, report.stop)), report };
  });
}
