// The example problems of examples/c in JavaScript: a fit without derivatives, a mix of feeds, points that repel each other.
//
//   node solvers.mjs PACKAGE        the folder that bindings/js/build has made; in a project of yours: import 'orbicube'
import assert from 'node:assert/strict';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const { ready, trustRegion, projectedGradient, sphereOptimizer } =
  await import(pathToFileURL(join(resolve(process.argv[2] ?? 'build-js/orbicube'), 'index.js')));
await ready;

/** Fits a / (1 + b t) + c to eight measurements, within bounds. */
function decay() {
  const times = Array.from({ length: 8 }, (_, i) => 0.5 * i);
  const model = ([a, b, c]) => times.map((t) => a / (1 + b * t) + c);
  const truth = [2.5, 0.7, 0.4];
  const measured = model(truth);
  const end = trustRegion.leastSquares((x) => model(x).map((y, i) => y - measured[i]), [1, 0.1, 0], 8,
    { lower: [0, 0, -1], upper: [10, 2, 1] });
  console.log(`decay: ${end.stop} after ${end.evaluations} evaluations,`, end.x);
  assert(end.x.every((x, i) => Math.abs(x - truth[i]) < 1e-7));
}

/** The cheapest mix of five feeds that reaches a given share of protein. */
function feeds() {
  const price = [0.9, 0.3, 0.5, 1.4, 0.2];
  const usual = [0.2, 0.3, 0.2, 0.1, 0.2];
  const weight = [2, 1, 3, 1, 4];
  const protein = [0.12, 0.09, 0.35, 0.44, 0.05];
  const cost = (x, gradient) => x.reduce((sum, share, i) => {
    const away = share - usual[i];
    gradient[i] = price[i] + weight[i] * away;
    return sum + price[i] * share + 0.5 * weight[i] * away * away;
  }, 0);
  const end = projectedGradient.minimize(cost, [0, 0, 0, 0, 0],
    { lower: 0, upper: 0.6, A: [[1, 1, 1, 1, 1], protein], b: [1, 0.2] });
  console.log(`feeds: ${end.stop} after ${end.evaluations} evaluations,`, end.x);
  assert(end.converged && Math.abs(end.x.reduce((a, b) => a + b) - 1) < 1e-14);
}

/** Twelve points on a sphere that repel each other settle at the corners of an icosahedron. */
function charges() {
  function energy(x, gradient) {
    let value = 0;
    gradient.fill(0);
    for (let i = 0; i < x.length; i += 3) {
      for (let j = 0; j < i; j += 3) {
        const away = [x[i] - x[j], x[i + 1] - x[j + 1], x[i + 2] - x[j + 2]];
        const term = 1 / away.reduce((sum, a) => sum + a * a, 0);
        value += term;
        away.forEach((a, k) => {
          gradient[i + k] -= 2 * term * term * a;
          gradient[j + k] += 2 * term * term * a;
        });
      }
    }
    return value;
  }
  const start = Float64Array.from({ length: 36 }, (_, i) => (i * i * 7 % 37) / 37 - 0.5);
  const end = sphereOptimizer.minimize(energy, start);
  console.log(`charges: ${end.stop} after ${end.evaluations} evaluations, energy ${end.value}`);
  assert(Math.abs(end.value - 39) < 1e-9);
}

decay();
feeds();
charges();
