// What must hold in every JavaScript engine: run by node_test.mjs in node and by page.html in a browser. A check receives the
// package and, by lines, what the C program problems.c ends in.

export function assert(condition, message = 'it does not hold') {
  if (!condition) throw new Error(message);
}

function same(a, b, what = 'values') {
  const [x, y] = [JSON.stringify(a), JSON.stringify(b)];
  assert(x === y, `${what}: ${x} is not ${y}`);
}

const sameBits = (a, b, what = 'numbers') => {
  same(a.length, b.length, `${what}, their count`);
  for (let i = 0; i < a.length; ++i) assert(Object.is(a[i], b[i]), `${what}: at ${i} ${a[i]} is not ${b[i]}`);
};

function failure(body) {
  try {
    body();
  } catch (problem) {
    return problem;
  }
  throw new Error('nothing was thrown');
}

async function rejection(promise) {
  try {
    await promise;
  } catch (problem) {
    return problem;
  }
  throw new Error('nothing was thrown');
}

/** A box of unit cubes, each of them six tetrahedra around its diagonal. */
function boxOfTetrahedra([nx, ny, nz]) {
  const at = (i, j, k) => i + (nx + 1) * (j + (ny + 1) * k);
  const positions = [];
  for (let k = 0; k <= nz; ++k) for (let j = 0; j <= ny; ++j) for (let i = 0; i <= nx; ++i) positions.push(i, j, k);
  const tetrahedra = [];
  for (let k = 0; k < nz; ++k) for (let j = 0; j < ny; ++j) for (let i = 0; i < nx; ++i) {
    for (const [a, b, even] of [[0, 1, true], [1, 2, true], [2, 0, true], [1, 0, false], [2, 1, false], [0, 2, false]]) {
      const corner = (...axes) => at(...[i, j, k].map((start, axis) => start + (axes.includes(axis) ? 1 : 0)));
      const middle = [corner(a), corner(a, b)];
      tetrahedra.push(corner(), ...(even ? middle : middle.reverse()), corner(0, 1, 2));
    }
  }
  return { positions: Float64Array.from(positions), tetrahedra: Uint32Array.from(tetrahedra) };
}

function countInverted(positions, tetrahedra) {
  let count = 0;
  for (let t = 0; t < tetrahedra.length; t += 4) {
    const [o, a, b, c] = [0, 1, 2, 3].map((k) => positions.subarray(3 * tetrahedra[t + k], 3 * tetrahedra[t + k] + 3));
    const [u, v, w] = [a, b, c].map((p) => [p[0] - o[0], p[1] - o[1], p[2] - o[2]]);
    count += u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]) > 0 ? 0 : 1;
  }
  return count;
}

/** A line as problems.c prints it. */
function line(name, evaluations, x) {
  const memory = new DataView(new ArrayBuffer(8));
  const bits = Array.from(x, (value) => {
    memory.setFloat64(0, value);
    return memory.getBigUint64(0).toString(16).padStart(16, '0');
  });
  return [name, evaluations, ...bits].join(' ');
}

// ---- the problems of problems.c ---------------------------------------------------------------------------------------

const model = (x, i) => x[0] / (1 + x[1] * (0.5 * i)) + x[2];
const truth = [2.5, 0.7, 0.4];
const misfit = (x) => Array.from({ length: 8 }, (_, i) => model(x, i) - model(truth, i));
const decayBounds = { lower: [0, 0, -1], upper: [10, 2, 1] };

const price = [0.9, 0.3, 0.5, 1.4, 0.2];
const usual = [0.2, 0.3, 0.2, 0.1, 0.2];
const weight = [2, 1, 3, 1, 4];
const feeds = { lower: 0, upper: 0.6, A: [[1, 1, 1, 1, 1], [0.12, 0.09, 0.35, 0.44, 0.05]], b: [1, 0.2] };

function cost(x, gradient) {
  let sum = 0;
  for (let j = 0; j < 5; ++j) {
    const away = x[j] - usual[j];
    sum += price[j] * x[j] + 0.5 * weight[j] * away * away;
    gradient[j] = price[j] + weight[j] * away;
  }
  return sum;
}

function charges(x, gradient) {
  let sum = 0;
  gradient.fill(0);
  for (let i = 0; i < x.length / 3; ++i) {
    for (let j = 0; j < i; ++j) {
      const away = [0, 1, 2].map((k) => x[3 * i + k] - x[3 * j + k]);
      let square = 0;
      for (const a of away) square += a * a;
      const term = 1 / square;
      sum += term;
      away.forEach((a, k) => {
        const pull = 2 * term * term * a;
        gradient[3 * i + k] -= pull;
        gradient[3 * j + k] += pull;
      });
    }
  }
  return sum;
}

const chargesStart = Float64Array.from({ length: 36 }, (_, i) => (i * i * 7 % 37) / 37 - 0.5);

const cube = {
  positions: Float64Array.from([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1]),
  triangles: Uint32Array.from([0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5]),
};

/** Of each triangle of a map whether it is counter-clockwise seen from outside, in doubles. */
function countTurned(directions, triangles) {
  let turned = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => directions.subarray(3 * triangles[t + k], 3 * triangles[t + k] + 3));
    const det = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    if (!(det > 0)) ++turned;
  }
  return turned;
}

// ---- checks ------------------------------------------------------------------------------------------------------------

export const checks = {
  async 'the module has every function of the raw layer'(o) {
    const { constants, functions } = o.raw;
    const names = Object.keys(functions);
    assert(names.length > 200);
    same(names.filter((name) => typeof o.c[name] !== 'function'), []);
    same(o.c.obc_base_version(), o.version());
    same(constants.OBC_NOT_CLOSED, -3);
  },

  'solvers end in the bits of C'(o, lines) {
    const wanted = new Map(lines.map((text) => [text.split(' ')[0], text]));
    const decay = o.trustRegion.leastSquares(misfit, [1, 0.1, 0], 8, decayBounds);
    same(line('decay', decay.evaluations, decay.x), wanted.get('decay'));
    const mix = o.projectedGradient.minimize(cost, [0, 0, 0, 0, 0], feeds);
    same(line('feeds', mix.evaluations, mix.x), wanted.get('feeds'));
    const points = o.sphereOptimizer.minimize(charges, chargesStart);
    same(line('icosahedron', points.evaluations, points.x), wanted.get('icosahedron'));
    assert(decay.converged && mix.converged && points.converged);
  },

  'products of the Hessian lower a quotient to its least value'(o) {
    const stiffness = [3, 1, 2, 5]; // the minimum is 1
    const quotient = (x, gradient) => stiffness.reduce((sum, k, i) => {
      gradient[i] = 2 * k * x[i];
      return sum + k * x[i] * x[i];
    }, 0);
    const hessianProduct = (x, direction, product) => stiffness.forEach((k, i) => { product[i] = 2 * k * direction[i]; });
    const end = o.sphereOptimizer.minimize(quotient, [1, 1, 1, 1], { dimension: 4, hessianProduct });
    assert(end.converged && Math.abs(end.value - 1) < 1e-12 && end.report.products > 0);
    const run = new o.SphereOptimizer([1, 1, 1, 1], { dimension: 4, method: 'truncatedNewton', hessianProducts: true });
    const numbers = new Float64Array(4);
    for (let x; (x = run.ask()) !== null;) {
      const { direction } = run;
      if (direction) {
        hessianProduct(x, direction, numbers);
        run.tellProduct(numbers);
      } else run.tell(quotient(x, numbers), numbers);
    }
    sameBits(run.result.x, end.x);
    run.close();
  },

  'questions and answers end in the same bits, also through save and load'(o) {
    const wanted = o.trustRegion.leastSquares(misfit, [1, 0.1, 0], 8, decayBounds);
    let solver = new o.TrustRegion([1, 0.1, 0], { residuals: 8, ...decayBounds });
    for (let asked = 0, x; (x = solver.ask()) !== null; ++asked) {
      solver.tell(misfit(x));
      if (asked % 7 === 3) {
        const saved = solver.save();
        solver.close();
        solver = o.TrustRegion.load(saved, [0, 0, 0], { residuals: 8, ...decayBounds });
      }
    }
    sameBits(solver.result.x, wanted.x);
    solver.close();
    const sphere = new o.SphereOptimizer(chargesStart);
    const gradient = new Float64Array(36);
    for (let x; (x = sphere.ask()) !== null;) sphere.tell(charges(x, gradient), gradient);
    sameBits(sphere.result.x, o.sphereOptimizer.minimize(charges, chargesStart).x);
    const mix = new o.ProjectedGradient([0, 0, 0, 0, 0], feeds);
    for (let x, g = new Float64Array(5); (x = mix.ask()) !== null;) mix.tell(cost(x, g), g);
    same(mix.multipliers.length, 2);
    const { x } = o.projectedGradient.project(mix.result.x, feeds);
    assert(x.every((value, i) => Math.abs(value - mix.result.x[i]) < 1e-14), 'a solution is its own projection');
  },

  'a wrong option or word gets the nearest one, and those that there are'(o) {
    const said = (options) => failure(() => o.trustRegion.minimize((x) => x[0] ** 2, [1], options)).message;
    assert(said({ radiusEnde: 1 }).includes("no option radiusEnde; did you mean 'radiusEnd'? There are: method, start"));
    same(said({ method: 'two-radi' }), "method: one of 'two-radii', 'dissertation' is needed, not 'two-radi'; did you mean 'two-radii'?");
    assert(said({ method: 'cross' }).startsWith("method: one of")); // a word of `start`
    same(said({ restarts: 'many' }), "restarts: a number is needed, not 'many'");
  },

  'what a callback throws comes out, a failed evaluation does not, and a run can be stopped'(o) {
    const mine = new Error('mine');
    same(failure(() => o.trustRegion.minimize(() => { throw mine; }, [1])) === mine, true);
    const f = (x) => {
      if (x[0] < 0) throw new o.EvaluationFailed();
      return (x[0] - 0.1) ** 2;
    };
    const end = o.trustRegion.minimize(f, [0.5], { radiusBegin: 1 });
    assert(Math.abs(end.x[0] - 0.1) < 1e-6 && end.report.failedEvaluations > 0);
    let count = 0;
    const stopped = o.trustRegion.minimize((x) => {
      if (++count > 5) throw new o.StopRun();
      return x[0] ** 2 + x[1] ** 2;
    }, [1, 2]);
    assert(!stopped.converged && stopped.stop === 'cancelled' && Number.isFinite(stopped.value));
    const near = (x) => {
      const value = (x[0] - 1) ** 2 + (x[1] - 1) ** 2;
      if (value < 1e-3) throw new o.StopRun('good enough', { value });
      return value;
    };
    const told = o.trustRegion.minimize(near, [0, 0]);
    assert(told.stop === 'cancelled' && told.value < 1e-3 && told.value === (told.x[0] - 1) ** 2 + (told.x[1] - 1) ** 2);
    const slopes = (x, g) => {
      g.set([2 * (x[0] - 1), 2 * (x[1] - 1)]);
      return near(x);
    };
    assert(o.projectedGradient.minimize(slopes, [0, 0]).value < 1e-3);
    const ended = o.projectedGradient.minimize(cost, [0, 0, 0, 0, 0], { ...feeds, onProgress: () => false });
    same(ended.stop, 'cancelled');
  },

  'options are checked by name and by value'(o) {
    assert(failure(() => o.trustRegion.minimize((x) => x[0] ** 2, [1], { radius: 1 })) instanceof TypeError);
    const problem = failure(() => o.trustRegion.minimize((x) => x[0] ** 2, [1], { radiusEnd: -1 }));
    assert(problem instanceof o.OrbicubeError && problem.kind === 'invalid-argument' && problem.message.length > 10, String(problem));
    assert(failure(() => o.trustRegion.minimize((x) => x[0] ** 2, [1, 2], { lower: [0] })) instanceof RangeError);
    assert(failure(() => new o.TrustRegion([1]).tell(3)) instanceof o.OrbicubeError);
    same(o.trustRegion.minimize((x) => x[0] ** 2, [1], { start: 'cross', target: 1e-3 }).stop, 'target reached');
  },

  'errors have the kind and the message of C'(o) {
    const torus = o.Mesh.make('torus', 300);
    const problem = failure(() => o.sphereMap(torus));
    assert(problem instanceof o.OrbicubeError, String(problem));
    same([problem.kind, problem.status], ['wrong-genus', -5]);
    same(failure(() => o.Mesh.read(new TextEncoder().encode('OFF\n3 1 0\n0 0 0\n'), 'off')).status, -2);
    same(failure(() => o.sphereMap({ positions: [0, 0, NaN], triangles: [0, 0, 0] })).kind, 'invalid-argument');
    torus.close();
    assert(/closed/.test(failure(() => torus.vertexCount).message));
  },

  'files of every format are read back to the same mesh'(o) {
    const mesh = o.Mesh.make('creature', 200);
    const { positions, triangles } = mesh.arrays;
    for (const ending of ['obj', 'off', 'ply', 'vtk', 'mesh']) {
      for (const binary of [true, false]) {
        const bytes = o.writeMesh(mesh, ending, { binary });
        const again = o.Mesh.read(bytes, o.formatOf(`a.${ending}`));
        sameBits(again.positions, positions, `positions of ${ending}`);
        same([...again.triangles], [...triangles], ending);
        again.close();
      }
    }
    same(o.formats().filter((one) => one.cells).map((one) => one.ending), ['.mesh', '.vtk']);
    const marked = o.Mesh.from({ ...cube, regions: cube.triangles.slice(0, cube.triangles.length / 3).map((v, i) => i % 5) });
    same([mesh.regions, [...marked.regions].slice(0, 6)], [null, [0, 1, 2, 3, 4, 0]]);
    const stl = o.Mesh.read(o.writeMesh(mesh, 'stl'), 'stl');
    same([stl.vertexCount, stl.triangleCount], [mesh.vertexCount, mesh.triangleCount]);
    const { genus, closed } = o.topology(stl);
    same([genus, closed], [0, 1]);
    const mirrored = { positions: cube.positions, triangles: cube.triangles.slice().reverse() };
    assert(o.topology({ ...mirrored, triangles: o.orient(mirrored) }).volume === 1);
  },

  'numbers are written with the fewest digits that read back, as by C++'(o) {
    const positions = Float64Array.from([0.1, -1 / 3, 5e-324, 1e21, 123456789, 1e-7, 1e5, 1e6, 0.00012, 4.35, 1.7976931348623157e308, 2 ** 60]);
    const text = new TextDecoder().decode(o.writeMesh({ positions, triangles: [0, 1, 2] }, 'obj'));
    const written = [...text.matchAll(/^v (.*)$/gm)].flatMap((match) => match[1].split(' '));
    same(written, ['0.1', '-0.3333333333333333', '5e-324', '1e+21', '123456789', '1e-07', '1e+05', '1e+06', '0.00012', '4.35',
      '1.7976931348623157e+308', '1152921504606846976']);
  },

  'a sphere map is a bijection and near that of C'(o, lines) {
    const mesh = o.Mesh.make('creature', 400);
    const { directions, report } = o.sphereMap(mesh);
    same([report.bijective, report.flipped], [1, 0]);
    same(countTurned(directions, mesh.triangles), 0);
    sameBits(o.sphereMap(mesh.arrays).directions, directions, 'from plain arrays');
    // The C library's functions differ in last bits, and so does the course of the method: near, not the same.
    const [, count, ...bits] = lines.find((text) => text.startsWith('creature')).split(' ');
    same(directions.length / 3, Number(count));
    const memory = new DataView(new ArrayBuffer(8));
    const wanted = bits.slice(0, 6).map((each) => {
      memory.setBigUint64(0, BigInt(`0x${each}`));
      return memory.getFloat64(0);
    });
    [...directions.slice(0, 3), ...directions.slice(-3)].forEach((x, i) =>
      assert(Math.abs(x - wanted[i]) < 0.1, `${x} where C has ${wanted[i]}`));
  },

  'what a sphere map is for: inverse, remeshing, rounding'(o) {
    const mesh = o.Mesh.make('creature', 400);
    const { positions } = mesh.arrays;
    const { directions } = o.sphereMap(mesh);
    const locator = new o.Locator(mesh, directions);
    sameBits(locator.sample(directions, positions), positions, 'a vertex has its own position');
    const { weights } = locator.locate([0, 0, 1, 1, 1, 1]);
    assert(Math.abs(weights[0] + weights[1] + weights[2] - 1) < 1e-15);
    const regular = locator.remesh(positions, 'icosphere', 3);
    same([regular.vertexCount, o.topology(regular).genus], [642, 0]);
    same(countTurned(o.roundToFloat(mesh, directions), mesh.triangles), 0);
    const { quasiConformal } = o.faceDistortion(mesh, directions);
    assert(quasiConformal.length === mesh.triangleCount && quasiConformal.every((x) => x >= 1));
    for (const each of [locator, regular, mesh]) each.close();
  },

  'progress is told, and cancels at once and at every report'(o) {
    const mesh = o.Mesh.make('creature', 2000);
    const seen = [];
    o.sphereMap(mesh, { onProgress: (at) => { seen.push(at); } });
    assert(seen.length > 3 && seen.every((at) => typeof at.phase === 'string' && at.done >= 0), `${seen.length} reports`);
    for (const last of [1, Math.ceil(seen.length / 2)]) {
      let count = 0;
      const problem = failure(() => o.sphereMap(mesh, { onProgress: () => ++count < last }));
      same([problem.kind, count], ['cancelled', last]);
    }
    const mine = new Error('mine');
    assert(failure(() => o.sphereMap(mesh, { onProgress() { throw mine; } })) === mine);
    const given = AbortSignal.abort();
    failure(() => o.sphereMap(mesh, { signal: given }));
  },

  'a million vertices pass without a copy'(o) {
    const { mesh: { positions, triangles } } = { mesh: o.grid('octahedron', 1000).arrays };
    const count = positions.length / 3;
    assert(count > 1e6);
    const held = new o.HeapArray('float64', positions.length);
    const corners = new o.HeapArray('uint32', triangles.length);
    held.array.set(positions);
    corners.array.set(triangles);
    o.topology({ positions: held.array, triangles: corners.array }); // takes the memory it needs
    const before = o.c.memory.byteLength;
    const report = o.topology({ positions: held.array, triangles: corners.array });
    same([report.vertices, report.genus], [count, 0]);
    same(o.c.memory.byteLength, before, 'bytes of memory');
    const mesh = o.Mesh.from({ positions: held.array, triangles: corners.array });
    assert(mesh.positions.buffer === o.c.memory && mesh.positions.length === positions.length, 'a view');
    held.close();
    corners.close();
    mesh.close();
  },

  'a polycube is certified: every triangle in a plane across an axis'(o) {
    const mesh = o.Mesh.make('cube', 300);
    const map = o.polycube(mesh);
    const { positions, polycube, triangles } = map.arrays;
    const { labels } = map.triangleParts;
    same(map.corners, 8);
    sameBits(positions.subarray(0, 3 * mesh.vertexCount), mesh.positions, 'the vertices of the surface come first');
    labels.forEach((label, t) => {
      const [a, b, c] = [0, 1, 2].map((k) => polycube[3 * triangles[3 * t + k] + (label >> 1)]);
      assert(a === b && b === c, `triangle ${t} is in no plane`);
    });
    const better = map.optimizeDomain();
    same(better.corners, 8);
    same(failure(() => o.polycube(mesh, { onProgress: () => false })).kind, 'cancelled');
    for (const each of [map, better, mesh]) each.close();
  },

  'an atlas: the texels of a patch have the weights that their middles have in their triangles'(o) {
    const mesh = o.Mesh.make('cube', 300);
    const map = o.polycube(mesh);
    const atlas = map.atlas({ size: 64, padding: 2 });
    const { size, coordinates, texelsPerUnit, coverage } = atlas;
    same([size, coordinates.length], [64, 6 * map.triangleCount]);
    const { triangles, weights, covered } = atlas.sample();
    covered.forEach((inside, i) => {
      const [a, b, c] = weights.subarray(3 * i);
      assert(Math.abs(a + b + c - 1) < 1e-12, `weights of texel ${i}`);
      const at = (k) => [a, b, c].reduce((sum, w, j) => sum + w * coordinates[6 * triangles[i] + 2 * j + k], 0);
      if (inside) assert(Math.hypot(64 * at(0) - (i % 64) - 0.5, 64 * at(1) - Math.floor(i / 64) - 0.5) < 1e-9, `texel ${i}`);
    });
    // Middles in six rectangles: each has as many as its area says, up to one along each side.
    const count = covered.reduce((sum, inside) => sum + inside, 0);
    assert(texelsPerUnit > 0 && Math.abs(count - 64 * 64 * coverage) < 6 * 2 * 32, `${count} texels for a coverage of ${coverage}`);
    same(failure(() => map.atlas({ size: 0 })).kind, 'invalid-argument');
    same(failure(() => atlas.sample({ onProgress: () => false })).kind, 'cancelled');
    for (const each of [atlas, map, mesh]) each.close();
  },

  'harmonics: known functions, gradients by differences, a shape and its turned self'(o) {
    const h = o.harmonics;
    const { positions: at, triangles } = o.grid('icosphere', 3).arrays;
    const count = at.length / 3;
    const c = Math.sqrt(3 / (4 * Math.PI)); // Y_1m are y, z and x times this
    const rows = h.evaluate(at, 1);
    for (let i = 0; i < count; ++i) {
      const [x, y, z] = at.subarray(3 * i, 3 * i + 3);
      [Math.sqrt(0.25 / Math.PI), c * y, c * z, c * x].forEach((value, j) => assert(Math.abs(rows[4 * i + j] - value) < 1e-14));
    }
    const weights = o.vertexAreas({ positions: at, triangles });
    assert(Math.abs(weights.reduce((sum, area) => sum + area) - o.topology({ positions: at, triangles }).area) < 1e-12);
    const { coefficients, report } = h.fit(at, at, { degree: 4, weights });
    same([report.unknowns, report.rank, h.degreeOf(coefficients, 3)], [25, 25, 4]);
    [[3, 0], [1, 1], [2, 2]].forEach(([row, k]) => assert(Math.abs(coefficients[3 * row + k] - 1 / c) < 1e-12));
    const shape = coefficients.map((value, i) => value + Math.sin(i));
    const turn = [0, -1, 0, 1, 0, 0, 0, 0, 1];
    const turned = h.rotate(shape, turn);
    const one = h.synthesize(shape, [0.6, 0, 0.8], { gradients: true });
    h.synthesize(turned, [0, 0.6, 0.8]).values.forEach((value, k) => assert(Math.abs(value - one.values[k]) < 1e-13));
    const step = 1e-6; // towards +y, which is tangent there
    h.synthesize(shape, [0.6, step, 0.8]).values.forEach((value, k) =>
      assert(Math.abs((value - one.values[k]) / step - one.gradients[3 * k + 1]) < 1e-4));
    assert(h.shapeDistance(shape, turned) < 1e-20 && h.degreeNorms(shape).length === 5);
    const found = h.align(turned, shape);
    assert(found.correlation > 1 - 1e-9, `correlation ${found.correlation}`);
    found.rotation.forEach((value, i) => assert(Math.abs(value - turn[i]) < 1e-6));
    assert(h.filter(shape, 1, 2).every((value, i) => value === (i < 3 || i >= 27 ? 0 : shape[i])));
    same(o.meanDistance(at, at), 0);
    assert(new TextDecoder().decode(h.writeCoefficients(shape, 'coef')).startsWith('{ 25,'));
    same(failure(() => h.fit(at, at, { degree: 1001 })).status, -1);
  },

  'a field of frames in a box is that of its axes, and what is held stays to the bit'(o) {
    const box = boxOfTetrahedra([4, 3, 2]);
    const { frames, report } = o.frameField(box);
    assert(report.energy < 1e-12 && report.singularEdges === 0 && report.locallyMeshable === 1, JSON.stringify(report));
    const held = Float64Array.of(Math.cos(0.2), 0, 0, Math.sin(0.2));
    const other = o.frameField(box, { alignBoundary: false, heldFrames: { tetrahedra: [7], frames: held } });
    sameBits(other.frames.subarray(28, 32), held, 'what is held');
    assert(Math.abs(o.measureFrames(box, other.frames).energy - other.report.energy) < 1e-15);
    same([...o.matchings(box, frames)].length, box.tetrahedra.length);
    const places = o.singularities(box, frames);
    same([places.edges.length, places.curves.length, places.turns.length], [0, 0, 0]);
    same(failure(() => o.frameField({ ...box, tetrahedra: [0, 0, 1, 2] })).kind, 'degenerate-cell');
    same(failure(() => o.frameField(box, { onProgress: () => false })).kind, 'cancelled');
  },

  'a bar folded flat is untangled, and what cannot be is told with the best'(o) {
    const rest = boxOfTetrahedra([6, 2, 2]);
    const flat = rest.positions.map((x, i) => (i % 3 === 0 && x > 3 ? 6 - x : x));
    const fixed = Array.from({ length: flat.length / 3 }, (_, v) => rest.positions[3 * v] === 0);
    const { positions, report } = o.untangle({ positions: flat, tetrahedra: rest.tetrahedra }, { rest: rest.positions, fixed });
    same([report.inverted, countInverted(positions, rest.tetrahedra)], [0, 0]);
    assert(report.invertedBefore > 0 && report.minDeterminant > 0);
    fixed.forEach((held, v) => held && sameBits(positions.subarray(3 * v, 3 * v + 3), flat.subarray(3 * v, 3 * v + 3), 'fixed'));
    const none = failure(() => o.untangle({ positions: flat, tetrahedra: rest.tetrahedra },
      { rest: rest.positions, fixed: new Uint8Array(flat.length).fill(1), maxSteps: 2 }));
    same([none.kind, none.best.report.inverted], ['no-valid-result', report.invertedBefore]);
  },

  'hexahedra fill a cube, each positive, with its volume'(o) {
    const cube = o.Mesh.make('cube', 300);
    const { positions, hexahedra, quads, quadPatches, report } = o.hexahedra(cube, { cells: 64 });
    same([quads.length / 4, report.polycubeCorners], [quadPatches.length, 8]);
    assert(hexahedra.length % 8 === 0 && report.minScaledJacobian > 0.5, `${report.minScaledJacobian}`);
    const { volume } = o.topology(cube);
    assert(Math.abs(report.volume - volume) < 0.01 * volume, `volumes ${report.volume} and ${volume}`);
    assert(quads.every((v) => v < positions.length / 3));
    same(o.hexahedra(cube, { cells: 64, method: 'grid' }).report.gridBased, 1);
    same(failure(() => o.hexahedra(cube, { onProgress: () => false })).kind, 'cancelled');
  },

  'solids are mapped to polycubes'(o) {
    const map = o.solidMap(boxOfTetrahedra([2, 2, 2]), { corners: 8 });
    same([countInverted(map.positions, map.tetrahedra), countInverted(map.polycube, map.tetrahedra)], [0, 0]);
  },

  'morphs are GLB files whose targets read back'(o) {
    const [a, b] = [o.Mesh.make('creature', 3000), o.Mesh.make('creature', 3000, { seed: 3 })];
    const [da, db] = [o.sphereMap(a).directions, o.sphereMap(b).directions];
    const { first, second, triangles } = o.morph(a, da, b, db);
    sameBits(first.subarray(0, 3 * a.vertexCount), a.positions, 'the first shape is as it was');
    same([o.topology({ positions: first, triangles }).genus, first.length], [0, second.length]);
    const volume = ({ volume: v }) => v;
    for (const [made, given] of [[first, a], [second, b]]) {
      const [v, w] = [volume(o.topology({ positions: made, triangles })), volume(o.topology(given))];
      assert(Math.abs(v - w) < 0.05 * w, `volumes ${v} and ${w}`);
    }
    const bytes = o.writeGlb({ positions: first, triangles, morphTargets: [{ name: 'other', positions: second }], morphSeconds: 2 });
    const back = o.readGltf(bytes, { morphTarget: 'other', weldIdentical: false });
    same([...back.triangles], [...triangles]);
    assert(back.positions.every((x, i) => Math.abs(x - second[i]) < 1e-5));
    const sphere = o.readGltf(o.sphereGlb(a, da), { morphTarget: 'sphere', weldIdentical: false });
    same(countTurned(sphere.positions, sphere.triangles), 0);
  },

  'a worker answers the same, tells of progress and can be cancelled'(o) {
    return (async () => {
      const worker = new o.OrbicubeWorker();
      const surface = await worker.run('make', { shape: 'creature', triangles: 2000 });
      const seen = [];
      const { directions } = await worker.run('sphereMap', { surface }, { onProgress: (at) => seen.push(at.phase) });
      assert(seen.length > 2, 'progress');
      sameBits(directions, o.sphereMap(surface).directions);
      const problem = await rejection(worker.run('sphereMap', { surface: await worker.run('make', { shape: 'torus', triangles: 300 }) }));
      assert(problem instanceof o.OrbicubeError && problem.kind === 'wrong-genus');
      const control = new AbortController();
      const big = await worker.run('make', { shape: 'creature', triangles: 60000 });
      const began = Date.now();
      const work = worker.run('sphereMap', { surface: big }, { signal: control.signal, onProgress: () => control.abort() });
      same((await rejection(work)).name, 'AbortError');
      assert(Date.now() - began < 10000, `cancelled after ${Date.now() - began} ms`);
      const { bytes } = await worker.run('sphereGlb', { surface, directions });
      same(new TextDecoder().decode(bytes.subarray(0, 4)), 'glTF');
      worker.terminate();
    })();
  },
};
