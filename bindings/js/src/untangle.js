// Meshes without inverted elements: docs/untangle.md.
import { call, object, options, scratched, view, withHost } from './module.js';
import { split } from './volume_map.js';

/**
 * Moves vertices until every tetrahedron is positive: `positions`, and a `report`. `rest`: positions in which each has its target
 * shape; `fixed`: a flag a vertex, or a coordinate, otherwise boundary vertices are fixed; `ties`: a group a coordinate, whose
 * coordinates are kept equal, or 2^32 - 1. Options: maxSteps, maxPolishSteps, freeBoundary, volumeWeight, tolerance. If some remain
 * inverted, what is thrown has the best that was found as its `best`.
 */
export function untangle({ positions, tetrahedra }, given = {}) {
  const [host, { rest, fixed, ties, ...chosen }] = split(given);
  const length = positions.length;
  const each = fixed && fixed.length * 3 === length ? 'fixed' : 'fixed_coordinates';
  return withHost(host, (lent) => scratched((scratch) => {
    const problem = scratch.struct('obc_untangle_tetrahedra_problem', {
      positions: scratch.array('f64', positions, length), vertex_count: length / 3,
      tetrahedra: scratch.array('u32', tetrahedra, tetrahedra.length), tetrahedron_count: tetrahedra.length / 4,
      ...(rest && { rest: scratch.array('f64', rest, length, 'rest') }),
      ...(fixed && { [each]: scratch.array('u8', Uint8Array.from(fixed, Number), each === 'fixed' ? length / 3 : length, 'fixed') }),
      ...(ties && { ties: scratch.array('u32', ties, length, 'ties') }),
    });
    const picked = options(scratch, 'obc_untangle_options', chosen);
    const result = scratch.room('f64', length);
    const report = scratch.struct('obc_untangle_report');
    const found = () => ({ positions: view('f64', result, length).slice(), report: object('obc_untangle_report', report) });
    try {
      call('obc_untangle_tetrahedra', problem, picked, lent, result, report);
    } catch (problem) {
      if (problem.kind === 'no-valid-result') problem.best = found();
      throw problem;
    }
    return found();
  }));
}
