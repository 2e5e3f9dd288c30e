// Polycubes of closed surfaces, and certified maps to them: docs/polycube.md.
import { Handle, call, make, options, raw, scratched, view, withHost } from './module.js';
import { onSurface, surfaceAt } from './mesh.js';

const split = ({ onProgress, signal, ...chosen }) => [{ onProgress, signal }, chosen];

/** A texture atlas: the patches of a polycube packed into a square. */
export class Atlas extends Handle {
  constructor(address) {
    super(address, 'obc_polycube_atlas_destroy');
  }

  /** Texels along each side. */
  get size() {
    return raw('obc_polycube_atlas_size', this.address);
  }

  /** u and v of the three corners of each triangle, 0 to 1, from the top left. */
  get coordinates() {
    const length = 6 * raw('obc_polycube_atlas_triangle_count', this.address);
    return scratched((scratch) => {
      const room = scratch.room('f64', length);
      call('obc_polycube_atlas_copy', this.address, room, 0, 0);
      return view('f64', room, length).slice();
    });
  }

  get #figures() {
    return scratched((scratch) => {
      const room = scratch.room('f64', 2);
      call('obc_polycube_atlas_copy', this.address, 0, room, room + 8);
      return view('f64', room, 2).slice();
    });
  }

  /** Texels along a unit of the polycube. */
  get texelsPerUnit() {
    return this.#figures[0];
  }

  /** The fraction of the square in patches. */
  get coverage() {
    return this.#figures[1];
  }

  /**
   * What each texel shows, row by row from the top: a triangle of the map (0xFFFFFFFF: none), the weights of its corners, and whether it
   * has the middle of the texel (1); others show the nearest texel in a patch.
   */
  sample(host = {}) {
    return withHost(host, (lent) => scratched((scratch) => {
      const count = this.size ** 2;
      const triangles = scratch.room('u32', count);
      const weights = scratch.room('f64', 3 * count);
      const covered = scratch.bytes(count);
      call('obc_polycube_atlas_sample', this.address, lent, triangles, weights, covered);
      return { triangles: view('u32', triangles, count).slice(), weights: view('f64', weights, 3 * count).slice(),
        covered: view('u8', covered, count).slice() };
    }));
  }
}

/** A certified polycube map. */
export class Polycube extends Handle {
  constructor(address) {
    super(address, 'obc_polycube_destroy');
  }

  get corners() {
    return raw('obc_polycube_corner_count', this.address);
  }

  get patches() {
    return raw('obc_polycube_patch_count', this.address);
  }

  get vertexCount() {
    return raw('obc_polycube_vertex_count', this.address);
  }

  get triangleCount() {
    return raw('obc_polycube_triangle_count', this.address);
  }

  /** `positions` in space, the surface's vertices first, where they are on the `polycube`, and the triangles of both. */
  get arrays() {
    const [vertices, triangles] = [3 * this.vertexCount, 3 * this.triangleCount];
    return scratched((scratch) => {
      const positions = scratch.room('f64', vertices);
      const polycube = scratch.room('f64', vertices);
      const corners = scratch.room('u32', triangles);
      call('obc_polycube_copy', this.address, positions, polycube, corners);
      return {
        positions: view('f64', positions, vertices).slice(), polycube: view('f64', polycube, vertices).slice(),
        triangles: view('u32', corners, triangles).slice(),
      };
    });
  }

  /** Of each triangle the direction it looks in (0 to 5: +x -x +y -y +z -z), its face, and the surface's triangle it lies in. */
  get triangleParts() {
    const count = this.triangleCount;
    return scratched((scratch) => {
      const labels = scratch.bytes(count);
      const patches = scratch.room('u32', count);
      const sources = scratch.room('u32', count);
      call('obc_polycube_copy_triangles', this.address, labels, patches, sources);
      return { labels: view('u8', labels, count).slice(), patches: view('u32', patches, count).slice(),
        sources: view('u32', sources, count).slice() };
    });
  }

  /** The patches packed into a square, for textures. */
  atlas(given = {}) {
    const [host, chosen] = split(given);
    return withHost(host, (lent) => scratched((scratch) =>
      new Atlas(make('obc_polycube_atlas_create', this.address, options(scratch, 'obc_polycube_atlas_options', chosen), lent))));
  }

  /** A mesh of about the given number of quads, the same for maps to one polycube: where its vertices are on surface and polycube. */
  quads(count = 10000, host = {}) {
    return withHost(host, (lent) => scratched((scratch) => {
      const quads = make('obc_polycube_quads_create', this.address, options(scratch, 'obc_polycube_quads_options', { quads: count }), lent);
      try {
        const [vertices, cells] = [raw('obc_polycube_quads_vertex_count', quads), raw('obc_polycube_quads_quad_count', quads)];
        const parts = { positions: ['f64', 3 * vertices], polycube: ['f64', 3 * vertices], corners: ['u32', 4 * cells], patches: ['u32', cells] };
        const rooms = Object.values(parts).map(([type, length]) => scratch.room(type, length));
        call('obc_polycube_quads_copy', quads, ...rooms);
        return Object.fromEntries(Object.entries(parts).map(([name, [type, length]], i) => [name, view(type, rooms[i], length).slice()]));
      } finally {
        raw('obc_polycube_quads_destroy', quads);
      }
    }));
  }

  /** The same with the proportions of minimum distortion. */
  optimizeDomain(given = {}) {
    const [host, chosen] = split(given);
    return withHost(host, (lent) => scratched((scratch) => {
      const out = scratch.bytes(4);
      const picked = options(scratch, 'obc_polycube_domain_options', chosen);
      call('obc_polycube_optimize_domain', this.address, picked, lent, 0, out);
      return new Polycube(view('u32', out, 1)[0]);
    }));
  }
}

/** Finds a polycube of a closed surface of any genus, and a map to it. */
export function polycube(surface, given = {}) {
  const [host, chosen] = split(given);
  return onSurface(surface, host, (scratch, at, lent) => {
    const picked = options(scratch, 'obc_polycube_options', chosen);
    return new Polycube(make('obc_polycube_compute', at, picked, lent));
  });
}

/** One polycube for several shapes of one genus and kind: a map to it of each. */
export function commonPolycube(surfaces, given = {}) {
  const [host, { construction, corners, seed, ...domain }] = split(given);
  return withHost(host, (lent) => scratched((scratch) => {
    const count = surfaces.length;
    const size = 16;
    const at = scratch.bytes(size * count);
    surfaces.forEach((surface, i) =>
      view('u32', at + size * i, 4).set(view('u32', surfaceAt(scratch, surface), 4)));
    const out = scratch.room('u32', count);
    call('obc_polycube_compute_common', at, count,
      options(scratch, 'obc_polycube_options', { construction, corners, seed }),
      options(scratch, 'obc_polycube_domain_options', domain), lent, 0, out);
    return Array.from(view('u32', out, count).slice(), (address) => new Polycube(address));
  }));
}

