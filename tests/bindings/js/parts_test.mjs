// Parts of the package: modules of a few libraries that return the bits of the whole one (environment: ORBICUBE_JS).
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';

const folder = process.env.ORBICUBE_JS;
const open = (...path) => import(pathToFileURL(join(folder, ...path, 'index.js')));
const whole = await open();
await whole.ready;

const valley = ([x, y]) => 100 * (y - x * x) ** 2 + (1 - x) ** 2;
function valleyWithGradient([x, y], gradient) {
  gradient[0] = -400 * x * (y - x * x) - 2 * (1 - x);
  gradient[1] = 200 * (y - x * x);
  return valley([x, y]);
}
const poles = (x, gradient) => {
  gradient.set([0, 0, 1, 0, 2, 0]);
  return x[2] + 2 * x[4];
};
const runs = {
  trust_region: (o) => o.trustRegion.minimize(valley, [-1.2, 1], { lower: -2, upper: 2 }),
  projected_gradient: (o) => o.projectedGradient.minimize(valleyWithGradient, [-1.2, 1], { lower: -2, upper: 2 }),
  sphere_optimizer: (o) => o.sphereOptimizer.minimize(poles, [1, 0, 0, 0, 0, 1]),
  sphere_map: (o) => {
    const { directions, report } = o.sphereMap(o.Mesh.make('creature', 500));
    return { x: directions, value: report.energy };
  },
};

for (const [part, run] of Object.entries(runs)) {
  test(`orbicube/${part} returns the bits of the whole package`, async () => {
    const small = await open(part);
    await small.ready;
    const [expected, found] = [run(whole), run(small)];
    assert.equal(found.value, expected.value);
    assert.deepEqual(Array.from(found.x), Array.from(expected.x));
    for (const name of Object.keys(small)) assert.ok(name in whole, name);
  });
}

test('a part for one solver loads less than 100 KB from servers that compress', () => {
  for (const part of ['trust_region', 'projected_gradient', 'sphere_optimizer']) {
    const files = readdirSync(join(folder, part), { recursive: true }).filter((name) => /[.](m?js|wasm)$/.test(name));
    assert.ok(files.length > 5);
    const bytes = files.reduce((sum, name) => sum + gzipSync(readFileSync(join(folder, part, name)), { level: 9 }).length, 0);
    assert.ok(bytes < 100000, `${part}: ${bytes}`);
  }
});
