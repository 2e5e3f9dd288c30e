// Hexahedral meshes: docs/hexmesh.md.
import { call, make, object, options, raw, view } from './module.js';
import { onSurface } from './mesh.js';
import { split } from './volume_map.js';

/**
 * Fills a closed surface with hexahedra, certified: `positions`, `hexahedra` (eight vertices each, as VTK orders them), the `quads` of
 * the boundary, of each the patch of the polycube that it lies on, and a `report`. Options: method ("auto", "polycube",
 * "grid"), cells, padding ("auto", "with", "without"), maxHausdorffPercent (more cells where a mesh is farther), maxCells, featureAngle, corners, triangles, seed, rounds.
 */
export function hexahedra(surface, given = {}) {
  const [host, chosen] = split(given);
  return onSurface(surface, host, (scratch, at, lent) => {
    const picked = options(scratch, 'obc_hexmesh_options', chosen);
    const report = scratch.struct('obc_hexmesh_report');
    const hexes = make('obc_hexmesh_compute', at, picked, lent, report);
    try {
      const count = (of) => raw(`obc_hexmesh_${of}count`, hexes);
      const [vertices, cells, quads] = ['vertex_', '', 'quad_'].map(count);
      const parts = { positions: ['f64', 3 * vertices], hexahedra: ['u32', 8 * cells], quads: ['u32', 4 * quads], quadPatches: ['u32', quads] };
      const rooms = Object.values(parts).map(([type, length]) => scratch.room(type, length));
      call('obc_hexmesh_copy', hexes, ...rooms);
      return { ...Object.fromEntries(Object.entries(parts).map(([name, [type, length]], i) => [name, view(type, rooms[i], length).slice()])),
        report: object('obc_hexmesh_report', report) };
    } finally {
      raw('obc_hexmesh_destroy', hexes);
    }
  });
}
