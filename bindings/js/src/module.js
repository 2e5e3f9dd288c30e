// The WebAssembly module, and the way into it: memory, structs, texts, errors, callbacks. Everything else is made of these.
import create from './wasm.mjs';
import { OrbicubeError } from './errors.js';
import { ofNode } from './node.js';
import { callbacks, constants, layouts, words } from './raw/raw.js';

let wasm = null;

async function bytesOf(url) {
  if (url.protocol === 'file:') {
    const { readFile } = await ofNode('fs/promises');
    return readFile(url);
  }
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`${url}: ${answer.status} ${answer.statusText}`);
  return answer.arrayBuffer();
}

/** Fulfilled once the module can be used; nothing else of the package can be used before. */
export const ready = (async () => {
  const wasmBinary = await bytesOf(new URL('./wasm.wasm', import.meta.url));
  wasm = await create({ wasmBinary });
})();

export function module() {
  if (!wasm) throw new Error('Orbicube is not ready yet: await ready first');
  return wasm;
}

// ---- memory ------------------------------------------------------------------------------------------------------------

const views = { f64: 'HEAPF64', f32: 'HEAPF32', u32: 'HEAPU32', i32: 'HEAP32', u8: 'HEAPU8', u16: 'HEAPU16' };
export const arrayTypes = { f64: Float64Array, f32: Float32Array, u32: Uint32Array, i32: Int32Array, u8: Uint8Array };

/** A view of the module's memory. It ends (its length becomes 0) when that memory grows. */
export function view(type, address, length) {
  const heap = module()[views[type]];
  const start = (address >>> 0) / heap.BYTES_PER_ELEMENT;
  return heap.subarray(start, start + length);
}

export function allocate(bytes) {
  const address = module()._malloc(Math.max(bytes, 1)) >>> 0;
  if (address === 0) throw new OrbicubeError(constants.OBC_OUT_OF_MEMORY, 'out-of-memory', `there is no room for ${bytes} bytes`);
  return address;
}

export const release = (address) => module()._free(address);

export function text(address) {
  if (!address) return null;
  const heap = module().HEAPU8;
  const start = address >>> 0;
  return new TextDecoder().decode(heap.slice(start, heap.indexOf(0, start)));
}

/** Room for one call: whatever is taken here goes at its end. Arrays that lie in the module's memory are not copied. */
export class Scratch {
  #taken = [];

  bytes(size) {
    const address = allocate(size);
    this.#taken.push(address);
    return address;
  }

  room(type, length) {
    return this.bytes(length * arrayTypes[type].BYTES_PER_ELEMENT);
  }

  array(type, values, length, name = 'array') {
    const Type = arrayTypes[type];
    if (values.length !== length) throw new RangeError(`${name} has ${values.length} numbers, not ${length}`);
    if (values instanceof Type && values.buffer === module().HEAPU8.buffer) return values.byteOffset;
    const address = this.room(type, length);
    view(type, address, length).set(values);
    return address;
  }

  text(value) {
    if (value === null || value === undefined) return 0;
    const encoded = new TextEncoder().encode(value);
    const address = this.bytes(encoded.length + 1);
    const heap = module().HEAPU8;
    heap.set(encoded, address);
    heap[address + encoded.length] = 0;
    return address;
  }

  /** A struct with zeros, or with what its _init function fills in. */
  struct(name, values) {
    const { size, fields } = layouts[name];
    const address = this.bytes(size);
    module().HEAPU8.fill(0, address, address + size);
    const init = module()[`_${name}_init`];
    if (init) init(address, size);
    else if (fields.struct_size) setField(name, address, 'struct_size', size);
    for (const [key, value] of Object.entries(values ?? {})) setField(name, address, key, value);
    return address;
  }

  free() {
    for (const address of this.#taken) release(address);
    this.#taken = [];
  }
}

/** Runs body(scratch) and releases what it took. */
export function scratched(body) {
  const scratch = new Scratch();
  try {
    return body(scratch);
  } finally {
    scratch.free();
  }
}

// ---- structs -----------------------------------------------------------------------------------------------------------

const scalars = {
  i32: ['getInt32', 'setInt32'], u32: ['getUint32', 'setUint32'], f64: ['getFloat64', 'setFloat64'],
  i64: ['getBigInt64', 'setBigInt64'], u64: ['getBigUint64', 'setBigUint64'], f32: ['getFloat32', 'setFloat32'],
};
const sizes = { i32: 4, u32: 4, f32: 4, i64: 8, u64: 8, f64: 8 };

export function setField(struct, address, name, value) {
  const [type, offset, length] = layouts[struct].fields[name];
  const memory = new DataView(module().HEAPU8.buffer);
  const set = (at, x) => memory[scalars[type][1]](at, type.endsWith('64') && type[0] !== 'f' ? BigInt(x) : Number(x), true);
  if (length === undefined) set(address + offset, value);
  else for (let i = 0; i < length; ++i) set(address + offset + i * sizes[type], value[i]);
}

export function getField(struct, address, name) {
  const [type, offset, length] = layouts[struct].fields[name];
  const memory = new DataView(module().HEAPU8.buffer);
  if (type === 'char') return text(address + offset);
  const get = (at) => Number(memory[scalars[type][0]](at, true));
  if (length === undefined) return get(address + offset);
  return Array.from({ length }, (_, i) => get(address + offset + i * sizes[type]));
}

export const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());
export const snake = (name) => name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);

/** A result or report as an object: its members in camel case, without what only C needs. */
export function object(struct, address) {
  const result = {};
  for (const name of Object.keys(layouts[struct].fields)) {
    if (name !== 'struct_size' && name !== 'reserved') result[camel(name)] = getField(struct, address, name);
  }
  return result;
}

// Of the known names the one most like a wrong one, as the end of a sentence.
function nearest(wrong, known) {
  const distance = (a, b) => {
    const row = Array.from({ length: b.length + 1 }, (_, j) => j);
    for (let i = 1; i <= a.length; ++i) {
      let corner = row[0];
      row[0] = i;
      for (let j = 1; j <= b.length; ++j) {
        const kept = corner + (a[i - 1] === b[j - 1] ? 0 : 1);
        corner = row[j];
        row[j] = Math.min(row[j] + 1, row[j - 1] + 1, kept);
      }
    }
    return row[b.length];
  };
  const found = known.map((name) => ({ name, far: distance(wrong, name) })).sort((a, b) => a.far - b.far)[0];
  return found && found.far <= Math.max(1, found.name.length / 3) ? `; did you mean '${found.name}'?` : '';
}

// "voxels" among the words of an option.
function wordAmong(allowed, key, word) {
  const found = Object.keys(allowed).find((known) => wordOf(known) === wordOf(word));
  if (found === undefined) {
    const all = Object.keys(allowed).map((known) => `'${known}'`).join(', ');
    throw new TypeError(`${key}: one of ${all} is needed, not '${word}'${nearest(word, Object.keys(allowed))}`);
  }
  return allowed[found];
}

/** An options struct: names in camel case, constants as words ("dissertation" for OBC_SPHERE_MAP_DISSERTATION). */
export function options(scratch, struct, given) {
  const address = scratch.struct(struct);
  for (const [key, value] of Object.entries(given ?? {})) {
    if (value === undefined) continue;
    const name = snake(key);
    if (!(name in layouts[struct].fields) || name === 'struct_size') {
      const known = Object.keys(layouts[struct].fields).filter((field) => field !== 'struct_size' && field !== 'reserved').map(camel);
      throw new TypeError(`there is no option ${key}${nearest(key, known) || '.'} There are: ${known.join(', ')}`);
    }
    const allowed = words[struct]?.[name];
    if (typeof value === 'string' && !allowed) throw new TypeError(`${key}: a number is needed, not '${value}'`);
    setField(struct, address, name, typeof value === 'string' ? wordAmong(allowed, key, value) : value);
  }
  return address;
}

const wordOf = (word) => snake(word).replace(/[- ]/g, '_').toUpperCase();

export function constant(prefix, word) {
  const name = prefix + wordOf(word);
  if (!(name in constants)) throw new TypeError(`'${word}' is none of the words that are known here`);
  return constants[name];
}

// ---- calls -------------------------------------------------------------------------------------------------------------

/** A function without a status. */
export const raw = (name, ...given) => module()[`_${name}`](...given);

function failure(error, status) {
  return new OrbicubeError(status, getField('obc_error', error, 'kind'), getField('obc_error', error, 'message'));
}

/** A function that returns a status and takes an obc_error last. */
export function call(name, ...given) {
  const error = allocate(layouts.obc_error.size);
  try {
    const status = raw(name, ...given, error);
    if (status !== constants.OBC_OK) throw failure(error, status);
  } finally {
    release(error);
  }
}

/** The same for a function that makes a handle: `given` get its place put in before the error. */
export function make(name, ...given) {
  return scratched((scratch) => {
    const out = scratch.bytes(4);
    call(name, ...given, out);
    return view('u32', out, 1)[0];
  });
}

// ---- callbacks ---------------------------------------------------------------------------------------------------------
// A function of the table for each type of callback; `user`, its last argument, is the number of the closure that is called.

const closures = new Map();
const trampolines = new Map();
let lastClosure = 0;

/** Runs body(address of a C function, its user argument); `closure` is what the C function calls meanwhile. */
export function withCallback(type, closure, body) {
  let trampoline = trampolines.get(type);
  if (trampoline === undefined) {
    trampoline = module().addFunction((...given) => closures.get(given[given.length - 1])(...given), callbacks[type]);
    trampolines.set(type, trampoline);
  }
  const user = ++lastClosure;
  closures.set(user, closure);
  try {
    return body(trampoline, user);
  } finally {
    closures.delete(user);
  }
}

/**
 * Runs body(host) with an obc_host, or 0 when nothing is lent. `onProgress({phase, done, total, best})` cancels by returning
 * false, an aborted `signal` does as well. What it throws comes out of here.
 */
export function withHost({ onProgress, signal } = {}, body) {
  signal?.throwIfAborted?.();
  if (!onProgress && !signal) return body(0);
  let thrown = null;
  const report = (phase, done, total, best) => {
    if (signal?.aborted) return 1;
    try {
      return onProgress?.({ phase: text(phase), done: Number(done), total: Number(total), best }) === false ? 1 : 0;
    } catch (problem) {
      thrown = { problem };
      return 1;
    }
  };
  try {
    return withCallback('obc_progress_function', report, (progress, user) =>
      scratched((scratch) => body(scratch.struct('obc_host', { progress, progress_user: user }))));
  } catch (problem) {
    throw thrown ? thrown.problem : problem;
  }
}

/** Releases what handles hold that were not closed, when they are collected. */
function end([destroy, address, rooms]) {
  raw(destroy, address);
  rooms.forEach(release);
}
const registry = new FinalizationRegistry(end);

/** A handle of C, with rooms in memory of its own. close() releases it at once; else that happens some time after nothing refers to it. */
export class Handle {
  #address;
  #held;

  constructor(address, destroy, rooms = []) {
    this.#address = address;
    this.#held = [destroy, address, rooms];
    registry.register(this, this.#held, this);
  }

  get address() {
    if (this.#address === 0) throw new Error('it was closed');
    return this.#address;
  }

  close() {
    if (this.#address === 0) return;
    registry.unregister(this);
    end(this.#held);
    this.#address = 0;
  }
}

/**
 * An array in the module's memory, which calls take without a copy: fill `array`, or have calls fill it. `array` is recreated at
 * each use, as views end when that memory grows.
 */
export class HeapArray extends Handle {
  constructor(type, length) {
    const types = { float64: 'f64', float32: 'f32', uint32: 'u32', uint8: 'u8' };
    if (!(type in types)) throw new TypeError(`there are no arrays of ${type} here`);
    super(allocate(length * arrayTypes[types[type]].BYTES_PER_ELEMENT), 'free');
    this.type = types[type];
    this.length = length;
  }

  get array() {
    return view(this.type, this.address, this.length);
  }
}
