// What the solvers have in common: reverse communication, callbacks, saved runs.
import { constants } from './raw/raw.js';
import { Handle, allocate, call, module, object, raw, scratched, text, view } from './module.js';

/** Throw it in a function that a solver calls where it has no value: the method goes on elsewhere. */
export class EvaluationFailed extends Error {
  constructor(message = 'there is no value here') {
    super(message);
    this.name = 'EvaluationFailed';
  }
}

/**
 * Throw it in a function that a solver calls to end the run; the best point so far is handed out. `value`, or the residuals,
 * at x count.
 */
export class StopRun extends Error {
  constructor(message = 'the run was stopped', { value } = {}) {
    super(message);
    this.name = 'StopRun';
    this.value = value;
  }
}

const NEED = 1; // of every solver
const NEED_PRODUCT = 4;
const DONE = 3;

/** One number for all, or one each. */
export function spread(scratch, value, length, name) {
  if (value === undefined || value === null) return 0;
  return scratch.array('f64', typeof value === 'number' ? new Float64Array(length).fill(value) : value, length, name);
}

/** A run of a solver; `prefix` is the beginning of its C names, `outputs` the number of values of an evaluation besides gradients. */
export class Run extends Handle {
  #prefix;
  #step;
  #tell;
  #out;
  #answers;
  #seen = null;
  #put = null;
  #stopped = false;
  /** Whether a product of the Hessian is requested, not a value. */
  wantsProduct = false;

  constructor(prefix, address, n, outputs) {
    const [out, answers] = [allocate(8), allocate(8 * outputs)];
    super(address, `${prefix}_destroy`, [out, answers]);
    this.#prefix = prefix;
    this.#step = module()[`_${prefix}_step`];
    this.#tell = module()[`_${prefix}_tell`];
    this.n = n;
    this.#out = out;
    this.#answers = answers;
    this.outputs = outputs;
  }

  /** Goes on to the next question; null when the run has ended. The view is the solver's own memory. */
  next(report, limit) {
    for (;;) {
      const request = this.#step(this.address, this.#out, this.#out + 4);
      if (request === DONE) return null;
      if (request < 0) throw new Error(`${this.#prefix}_step returned ${request}`);
      if (request === NEED || request === NEED_PRODUCT) {
        this.wantsProduct = request === NEED_PRODUCT;
        const address = view('u32', this.#out, 1)[0];
        if (this.#seen?.byteOffset !== address || this.#seen.length === 0) this.#seen = view('f64', address, this.n);
        return this.#seen;
      }
      if (report) {
        const { evaluations, value } = this.report();
        if (report({ phase: 'minimize', done: evaluations, total: limit, best: value }) === false) {
          this.#stopped = true;
          return null;
        }
      }
    }
  }

  /** Points that wait for values, where there may be several. */
  get waiting() {
    return view('u32', this.#out + 4, 1)[0];
  }

  /** Where numbers are stored before tell. */
  get answers() {
    if (this.#put === null || this.#put.length === 0) this.#put = view('f64', this.answersAt, this.outputs);
    return this.#put;
  }

  get answersAt() {
    return this.#answers;
  }

  /** The arguments of _tell but for handle and error. */
  answer(...given) {
    if (this.#tell(this.address, ...given, 0) !== 0) call(`${this.#prefix}_tell`, this.address, ...given);
  }

  stop() {
    this.#stopped = true;
  }

  /** Calls `evaluate(x)` for each point until the run has ended; `fail()` where there is no value, `told(value)` at the last. */
  drive(evaluate, fail, told, { onProgress, signal, limit = 0 } = {}) {
    const report = onProgress || signal ? (at) => !signal?.aborted && onProgress?.(at) !== false : null;
    for (let x; !this.#stopped && (x = this.next(report, limit)) !== null;) {
      try {
        evaluate(x);
      } catch (problem) {
        if (problem instanceof EvaluationFailed) fail();
        else if (problem instanceof StopRun) {
          if (problem.value !== undefined) told(problem.value);
          this.#stopped = true;
        } else throw problem;
      }
    }
    return this.result;
  }

  resultArguments(x) {
    return [x];
  }

  report() {
    const struct = `${this.#prefix}_result`;
    return scratched((scratch) => {
      const result = scratch.struct(struct);
      call(`${this.#prefix}_get_result`, this.address, result, ...this.resultArguments(0));
      return object(struct, result);
    });
  }

  /** What is known now, at any time: the point `x`, the `value` there, why the run stopped, and all figures. */
  get result() {
    return scratched((scratch) => {
      const struct = `${this.#prefix}_result`;
      const result = scratch.struct(struct);
      const x = scratch.room('f64', this.n);
      call(`${this.#prefix}_get_result`, this.address, result, ...this.resultArguments(x));
      const report = object(struct, result);
      if (this.#stopped) report.stop = constants[`${this.#prefix.toUpperCase()}_CANCELLED`];
      return endOf(this.#prefix, view('f64', x, this.n).slice(), report);
    });
  }

  /** The run as bytes, from which `load` goes on to the same bits. */
  save() {
    return scratched((scratch) => {
      const size = raw(`${this.#prefix}_save_size`, this.address);
      const blob = scratch.bytes(size);
      call(`${this.#prefix}_save`, this.address, blob, size);
      return view('u8', blob, size).slice();
    });
  }
}

/** A run of a solver that wants a gradient with each value. */
export class GradientRun extends Run {
  /** The point at which value and gradient are requested next; null when the run has ended. */
  ask() {
    return this.next()?.slice() ?? null;
  }

  /** Value and gradient at the point requested; a value that is not finite: there is none. */
  tell(value, gradient) {
    if (!Number.isFinite(value) || !gradient) return this.answer(NaN, 0);
    if (gradient !== this.answers) this.answers.set(gradient);
    return this.answer(value, this.answersAt);
  }

  /** Calls f(x, gradient) until the run has ended; it writes the gradient and returns the value. */
  run(f, host) {
    return this.drive((x) => {
      const { answers } = this;
      const value = f(x, answers);
      if (answers.length === 0) throw new Error('the memory grew within f: the gradient is lost');
      this.tell(value, answers);
    }, () => this.tell(NaN), (value) => this.tell(value, new Float64Array(this.n)), host);
  }
}

/** The minimum value of f that a run of the class finds from x0. */
export function minimizeWithGradients(Solver, f, x0, { onProgress, signal, ...given }, more = {}) {
  const solver = new Solver(x0, given);
  try {
    return solver.run(f, { ...more, onProgress, signal, limit: given.maxEvaluations ?? 100000 });
  } finally {
    solver.close();
  }
}

function endOf(prefix, x, report) {
  const stop = text(raw(`${prefix}_stop_name`, report.stop));
  return { x, value: report.value, stop, converged: stop === 'converged', evaluations: report.evaluations, report };
}
