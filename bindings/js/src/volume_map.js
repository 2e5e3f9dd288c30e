// Maps of solids without inverted tetrahedra: docs/volume_map.md.
import { call, make, object, options, raw, scratched, view, withHost } from './module.js';

export const split = ({ onProgress, signal, ...chosen }) => [{ onProgress, signal }, chosen];

/**
 * Moves vertices until every tetrahedron is positive: `positions`, and a `report`. `rest`: positions where each has the shape that it
 * should have; `fixed`: a flag a coordinate, or a vertex; `ties`: a group a coordinate, of which all are to be equal, or 2^32 - 1.
 * Options: steps, polishSteps, volumeWeight. When some stay inverted, what is thrown has the best that was found as its `best`.
 */
export function untangle({ positions, tetrahedra }, given = {}) {
  const [host, { rest, fixed, ties, ...chosen }] = split(given);
  const length = positions.length;
  const flags = fixed && fixed.length * 3 === length ? Uint8Array.from({ length }, (_, i) => Number(fixed[Math.floor(i / 3)])) : fixed;
  return withHost(host, (lent) => scratched((scratch) => {
    const problem = scratch.struct('obc_volume_map_untangle_problem', {
      positions: scratch.array('f64', positions, length), vertex_count: length / 3,
      tetrahedra: scratch.array('u32', tetrahedra, tetrahedra.length), tetrahedron_count: tetrahedra.length / 4,
      ...(rest && { rest: scratch.array('f64', rest, length, 'rest') }),
      ...(flags && { fixed: scratch.array('u8', flags, length, 'fixed') }),
      ...(ties && { ties: scratch.array('u32', ties, length, 'ties') }),
    });
    const picked = options(scratch, 'obc_volume_map_untangle_options', chosen);
    const result = scratch.room('f64', length);
    const report = scratch.struct('obc_volume_map_untangle_report');
    const found = () => ({ positions: view('f64', result, length).slice(), report: object('obc_volume_map_untangle_report', report) });
    try {
      call('obc_volume_map_untangle', problem, picked, lent, result, report);
    } catch (problem) {
      if (problem.kind === 'no-valid-result') problem.best = found();
      throw problem;
    }
    return found();
  }));
}

/**
 * A map of a solid of tetrahedra to a polycube, one to one: `positions` in space, where they are on the `polycube`, and the
 * `tetrahedra`, more of them where the map needs that. Options: corners, seed.
 */
export function solidMap({ positions, tetrahedra }, given = {}) {
  const [host, chosen] = split(given);
  return withHost(host, (lent) => scratched((scratch) => {
    const solid = make('obc_volume_map_solid_compute', scratch.array('f64', positions, positions.length), positions.length / 3,
      scratch.array('u32', tetrahedra, tetrahedra.length), tetrahedra.length / 4, options(scratch, 'obc_volume_map_solid_options', chosen), lent);
    try {
      const vertices = 3 * raw('obc_volume_map_solid_vertex_count', solid);
      const cells = 4 * raw('obc_volume_map_solid_tetrahedron_count', solid);
      const rooms = [scratch.room('f64', vertices), scratch.room('f64', vertices), scratch.room('u32', cells)];
      call('obc_volume_map_solid_copy', solid, ...rooms);
      return { positions: view('f64', rooms[0], vertices).slice(), polycube: view('f64', rooms[1], vertices).slice(),
        tetrahedra: view('u32', rooms[2], cells).slice() };
    } finally {
      raw('obc_volume_map_solid_destroy', solid);
    }
  }));
}
