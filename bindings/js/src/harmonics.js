// Spherical harmonics of scattered samples and of shapes: docs/harmonics.md.
//
// Coefficients are an array of (degree + 1)^2 rows, Y_lm in row l*l + l + m, with a column a channel: for a shape x, y and z.
import { call, object, options, raw, scratched, view, withHost } from './module.js';
import { written } from './mesh.js';

const split = ({ onProgress, signal, ...chosen }) => [{ onProgress, signal }, chosen];

/** From the length of the array. */
export function degreeOf(coefficients, channels) {
  const degree = Math.round(Math.sqrt(coefficients.length / channels)) - 1;
  if (degree < 0 || (degree + 1) ** 2 * channels !== coefficients.length) {
    throw new RangeError(`${coefficients.length} coefficients of ${channels} channels are of no degree`);
  }
  return degree;
}

const answer = (address, length) => view('f64', address, length).slice();

/** Y_lm at each direction: a row of (degree + 1)^2 numbers a direction. */
export function evaluate(directions, degree, host = {}) {
  const count = directions.length / 3;
  const length = count * (degree + 1) ** 2;
  return withHost(host, (lent) => scratched((scratch) => {
    const rows = scratch.room('f64', length);
    call('obc_harmonics_evaluate', scratch.array('f64', directions, 3 * count), count, degree, lent, rows);
    return answer(rows, length);
  }));
}

/**
 * The coefficients that fit values at scattered directions best, and a report. `channels`: values a direction, 3 if it is not said;
 * `weights`: one a direction, as vertexAreas() has them; degree, method ("automatic", "dense", "iterative") and regularization.
 */
export function fit(directions, values, given = {}) {
  const [host, { channels = 3, weights, ...chosen }] = split(given);
  const count = directions.length / 3;
  return withHost(host, (lent) => scratched((scratch) => {
    const picked = options(scratch, 'obc_harmonics_fit_options', chosen);
    const degree = view('u32', picked, 2)[1];
    const length = raw('obc_harmonics_size', degree) * channels;
    const coefficients = scratch.room('f64', length);
    const report = scratch.struct('obc_harmonics_fit_report');
    call('obc_harmonics_fit', scratch.array('f64', directions, 3 * count), weights ? scratch.array('f64', weights, count, 'weights') : 0,
      scratch.array('f64', values, channels * count, 'values'), count, channels, picked, lent, coefficients, report);
    return { coefficients: answer(coefficients, length), report: object('obc_harmonics_fit_report', report) };
  }));
}

/**
 * A sphere map moved to where the surface of the degree comes nearest to the vertices, and a report; `rounds`: 10 if it is not said,
 * the others as those of fit().
 */
export function refineMap(surface, directions, given = {}) {
  const [host, { rounds = 10, weights, ...chosen }] = split(given);
  return onSurface(surface, host, (scratch, at, lent) => {
    const [positions, vertices, triangles, count] = view('u32', at, 4).slice();
    const moved = scratch.array('f64', directions, 3 * vertices, 'directions');
    const report = scratch.struct('obc_harmonics_refinement_report');
    call('obc_harmonics_refine_map', positions, vertices, triangles, count, weights ? scratch.array('f64', weights, vertices, 'weights') : 0,
      options(scratch, 'obc_harmonics_fit_options', chosen), rounds, lent, moved, report);
    return { directions: answer(moved, 3 * vertices), report: object('obc_harmonics_refinement_report', report) };
  });
}

/** The functions at the directions, and with `gradients` their gradients on the sphere (x y z a channel and direction). */
export function synthesize(coefficients, directions, given = {}) {
  const [host, { channels = 3, gradients = false }] = split(given);
  const count = directions.length / 3;
  return withHost(host, (lent) => scratched((scratch) => {
    const values = scratch.room('f64', channels * count);
    const slopes = gradients ? scratch.room('f64', 3 * channels * count) : 0;
    call('obc_harmonics_synthesize', scratch.array('f64', coefficients, coefficients.length), degreeOf(coefficients, channels), channels,
      scratch.array('f64', directions, 3 * count), count, lent, values, slopes);
    return { values: answer(values, channels * count), gradients: gradients ? answer(slopes, 3 * channels * count) : null };
  }));
}

/** The norm of each degree, which rotations do not change. */
export function degreeNorms(coefficients, channels = 3) {
  const degree = degreeOf(coefficients, channels);
  return scratched((scratch) => {
    const norms = scratch.room('f64', degree + 1);
    call('obc_harmonics_degree_norms', scratch.array('f64', coefficients, coefficients.length), degree, channels, norms);
    return answer(norms, degree + 1);
  });
}

/** The distance of two shapes by the norms of their degrees from `first` to `last`. */
export function shapeDistance(f, g, { channels = 3, first = 0, last } = {}) {
  const [df, dg] = [degreeOf(f, channels), degreeOf(g, channels)];
  return scratched((scratch) => {
    const distance = scratch.room('f64', 1);
    call('obc_harmonics_shape_distance', scratch.array('f64', f, f.length), df, scratch.array('f64', g, g.length), dg, channels, first,
      last ?? Math.max(df, dg), distance);
    return view('f64', distance, 1)[0];
  });
}

/** A copy of which the degrees from `low` to `high` stay. */
export function filter(coefficients, low, high, { channels = 3, width = 0, keepMean = false } = {}) {
  const degree = degreeOf(coefficients, channels);
  return scratched((scratch) => {
    const kept = scratch.room('f64', coefficients.length);
    view('f64', kept, coefficients.length).set(coefficients);
    call('obc_harmonics_filter', kept, degree, channels, low, high, width, keepMean ? 1 : 0);
    return answer(kept, coefficients.length);
  });
}

/** The functions turned with the sphere by a matrix (nine numbers, row by row). */
export const rotate = (coefficients, rotation, { channels = 3, ...host } = {}) => withHost(host, (lent) => scratched((scratch) => {
  const turned = scratch.room('f64', coefficients.length);
  call('obc_harmonics_rotate', scratch.array('f64', coefficients, coefficients.length), degreeOf(coefficients, channels), channels,
    scratch.array('f64', rotation, 9, 'rotation'), lent, turned);
  return answer(turned, coefficients.length);
}));

/** The rotation that brings `moving` best into line with `fixed`. Options: turnValues, searchDegree. */
export function align(fixed, moving, given = {}) {
  const [host, { channels = 3, turnValues, ...chosen }] = split(given);
  return withHost(host, (lent) => scratched((scratch) => {
    const picked = options(scratch, 'obc_harmonics_align_options', { ...chosen, turnValues: turnValues ? 1 : 0 });
    const found = scratch.struct('obc_harmonics_alignment');
    call('obc_harmonics_align', scratch.array('f64', fixed, fixed.length), degreeOf(fixed, channels),
      scratch.array('f64', moving, moving.length), degreeOf(moving, channels), channels, picked, lent, found);
    return object('obc_harmonics_alignment', found);
  }));
}

/** The bytes of a file: "sh" as SHTOOLS has them, "coef" as SPHARM-PDM has them. */
export const writeCoefficients = (coefficients, ending = 'sh', channels = 3) => scratched((scratch) =>
  written(ending, (path) => call('obc_harmonics_write', scratch.text(path), 0, scratch.array('f64', coefficients, coefficients.length),
    degreeOf(coefficients, channels), channels)));
