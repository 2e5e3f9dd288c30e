// What a call of the user's function costs through JavaScript; see callbacks.c, which does the same.
//
//   node bench/bindings/callbacks.mjs build-js/orbicube
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const { HeapArray, c, ProjectedGradient, projectedGradient, ready } =
  await import(pathToFileURL(join(resolve(process.argv[2] ?? 'build-js/orbicube'), 'index.js')));
await ready;

const unknowns = 10;
const runs = 1500;
const start = Float64Array.from({ length: unknowns }, (_, i) => (i % 2 === 0 ? -1.2 : 1));

function rosenbrock(x, gradient) {
  let sum = 0;
  gradient.fill(0);
  for (let i = 0; i + 1 < x.length; ++i) {
    const [a, b] = [x[i + 1] - x[i] * x[i], 1 - x[i]];
    sum += 100 * a * a + b * b;
    gradient[i] -= 400 * x[i] * a + 2 * b;
    gradient[i + 1] += 200 * a;
  }
  return sum;
}

const recorded = [];
projectedGradient.minimize((x, gradient) => {
  const value = rosenbrock(x, gradient);
  recorded.push([value, gradient.slice()]);
  return value;
}, start);

/** The fastest run of body, nanoseconds an evaluation. */
function fastest(body) {
  let best = Infinity;
  for (let i = 0; i < runs; ++i) {
    const begin = performance.now();
    body();
    best = Math.min(best, performance.now() - begin);
  }
  return Math.round(1e6 * best / recorded.length);
}

const through = fastest(() => {
  let next = 0;
  projectedGradient.minimize((x, gradient) => {
    const [value, slopes] = recorded[next++];
    gradient.set(slopes);
    return value;
  }, start);
});

// The same by the C functions as they are, which nothing can be faster than.
const [out, slopes] = [new HeapArray('uint32', 1), new HeapArray('float64', unknowns)];
const { array } = slopes;
const [step, tell] = [c.obc_projected_gradient_step, c.obc_projected_gradient_tell];
const bare = fastest(() => {
  const solver = new ProjectedGradient(start);
  for (let next = 0, request; (request = step(solver.address, out.address)) !== 3;) {
    if (request !== 1) continue;
    array.set(recorded[next][1]);
    tell(solver.address, recorded[next++][0], slopes.address, 0);
  }
  solver.close();
});
console.log(`JavaScript: ${through} ns an evaluation, ${bare} of them in the C functions, ${recorded.length} evaluations a run`);
