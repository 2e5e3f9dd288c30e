// Work in a thread of its own: a page stays alive meanwhile, receives progress, and can end it.
import { OrbicubeError } from './errors.js';
import { ofNode } from './node.js';

const aborted = () => new DOMException('the work was cancelled', 'AbortError');

async function startWorker() {
  const url = new URL('./worker.js', import.meta.url);
  if (typeof Worker === 'undefined') {
    const { Worker: Thread } = await ofNode('worker_threads');
    return new Thread(url);
  }
  return new Worker(url, { type: 'module' });
}

/**
 * A worker with a module of its own. `run(work, given, { onProgress, signal })` returns a promise; works are read, make, sphereMap,
 * polycube, morph, sphereGlb and glb, one at a time. An aborted signal ends the work: at once by its next report where memory can
 * be shared (node, and pages that are cross-origin isolated), else by ending the thread, and the next work starts another one.
 */
export class OrbicubeWorker {
  #thread = null;
  #jobs = new Map();
  #last = 0;

  /** Whether cancelled work leaves its thread alive. */
  get sharesMemory() {
    return typeof SharedArrayBuffer !== 'undefined' && globalThis.crossOriginIsolated !== false;
  }

  async #start() {
    const thread = await startWorker();
    const failed = (problem) => this.#fail(problem instanceof Error ? problem : new Error(problem.message ?? 'the worker failed'));
    if (thread.on) {
      thread.on('message', (message) => this.#receive(message));
      thread.on('error', failed);
      thread.unref();
    } else {
      thread.onmessage = ({ data }) => this.#receive(data);
      thread.onerror = failed;
    }
    return thread;
  }

  #receive({ id, progress, result, problem }) {
    const job = this.#jobs.get(id);
    if (!job) return;
    if (progress) {
      job.onProgress?.(progress);
      return;
    }
    this.#jobs.delete(id);
    if (result) job.resolve(result);
    else if (problem.kind === 'cancelled') job.reject(aborted());
    else if (problem.kind) job.reject(new OrbicubeError(problem.status, problem.kind, problem.message));
    else job.reject(Object.assign(new Error(problem.message), { name: problem.name }));
  }

  #fail(problem) {
    const jobs = [...this.#jobs.values()];
    this.#jobs.clear();
    this.terminate();
    for (const job of jobs) job.reject(problem);
  }

  async run(work, given, { onProgress, signal, transfer = [] } = {}) {
    if (signal?.aborted) throw aborted();
    this.#thread ??= this.#start();
    const thread = await this.#thread;
    if (signal?.aborted) throw aborted();
    const id = ++this.#last;
    thread.ref?.();
    const flag = signal && this.sharesMemory ? new Int32Array(new SharedArrayBuffer(4)) : null;
    const cancel = () => {
      if (flag) Atomics.store(flag, 0, 1);
      else this.#fail(aborted());
    };
    try {
      return await new Promise((resolve, reject) => {
        this.#jobs.set(id, { resolve, reject, onProgress });
        signal?.addEventListener('abort', cancel);
        thread.postMessage({ id, work, given, cancel: flag?.buffer }, transfer);
      });
    } finally {
      signal?.removeEventListener('abort', cancel);
      if (this.#jobs.size === 0) thread.unref?.();
    }
  }

  /** Ends the thread; the next work starts another one. */
  terminate() {
    const thread = this.#thread;
    this.#thread = null;
    thread?.then((ended) => ended.terminate());
  }
}
