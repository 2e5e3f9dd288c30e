// Maps of solids to polycubes without inverted tetrahedra: docs/volume_map.md.
import { call, make, options, raw, scratched, view, withHost } from './module.js';

export const split = ({ onProgress, signal, ...chosen }) => [{ onProgress, signal }, chosen];

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
