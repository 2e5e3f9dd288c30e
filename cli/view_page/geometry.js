// The triangles that are drawn of a mesh, with what each corner needs.

import {Cells} from "./cells.js";
import {normalsOf} from "./viewer/surface.js";

// Bits of a triangle's flags: sides that are no edge of the mesh, by the corner across; a face that is inside the solid.
const inner = 8;

/** A list of triangles that grows. */
class Drawn {
  constructor() {
    this.corners = [];   // vertices, three a triangle
    this.elements = [];  // the triangle or cell of the mesh
    this.flags = [];
  }

  add(element, a, b, c, flags) {
    this.corners.push(a, b, c);
    this.elements.push(element);
    this.flags.push(flags);
  }
}

/** What can be drawn of a mesh. Elements are its triangles, or its tetrahedra and then its hexahedra. */
export class Geometry {
  #groups = [];

  constructor(mesh) {
    this.mesh = mesh;
    for (const [name, corners] of [["tetrahedra", 4], ["hexahedra", 8]]) {
      if (mesh[name].length > 0) this.#groups.push(new Cells(mesh[name], corners));
    }
    this.elementCount = this.ofCells ? this.#groups.reduce((sum, group) => sum + group.count, 0) : mesh.triangles.length / 3;
  }

  get ofCells() {
    return this.#groups.length > 0;
  }

  /** The vertices of an element. */
  verticesOf(element) {
    if (!this.ofCells) return this.mesh.triangles.subarray(3 * element, 3 * element + 3);
    for (const group of this.#groups) {
      if (element < group.count) return group.vertices.subarray(element * group.corners, (element + 1) * group.corners);
      element -= group.count;
    }
    return [];
  }

  /** The name of an element with its number within its kind. */
  nameOf(element) {
    if (!this.ofCells) return `Triangle ${element}`;
    for (const group of this.#groups) {
      if (element < group.count) return `${group.corners === 4 ? "Tetrahedron" : "Hexahedron"} ${element}`;
      element -= group.count;
    }
    return "";
  }

  /** Centers of the elements in the frame, three numbers each. */
  centers() {
    if (this.#centers) return this.#centers;
    const made = this.#centers = new Float32Array(3 * this.elementCount), p = this.mesh.framedPositions;
    for (let i = 0; i < this.elementCount; ++i) {
      const vertices = this.verticesOf(i);
      for (const v of vertices) for (let k = 0; k < 3; ++k) made[3 * i + k] += p[4 * v + k] / vertices.length;
    }
    return made;
  }
  #centers = null;

  /**
   * Triangles to draw: corners, elements and flags. Of cells, the faces of those that `keeps` (by element; none: all) and
   * that no other kept cell covers.
   */
  drawn(keeps) {
    const {mesh} = this;
    if (!this.ofCells) {
      const count = mesh.triangles.length / 3;
      return {corners: mesh.triangles, elements: Uint32Array.from({length: count}, (_, i) => i), flags: new Uint8Array(count)};
    }
    const drawn = new Drawn();
    let first = 0;
    for (const group of this.#groups) {
      const shown = new Uint8Array(group.count), start = first;
      for (let i = 0; i < group.count; ++i) shown[i] = !keeps || keeps[start + i] ? 1 : 0;
      group.seen(shown, (cell, face, boundary) => {
        const [a, b, c, d] = face.map(corner => group.vertices[cell * group.corners + corner]), flag = boundary ? 0 : inner;
        if (d === undefined) {
          drawn.add(start + cell, a, b, c, flag);
        } else {
          drawn.add(start + cell, a, b, c, flag | 2);  // not the side a, c, across from b
          drawn.add(start + cell, a, c, d, flag | 4);  // across from d, the third corner
        }
      });
      first += group.count;
    }
    return {corners: Uint32Array.from(drawn.corners), elements: Uint32Array.from(drawn.elements), flags: Uint8Array.from(drawn.flags)};
  }
}

/** Returns positions and normals of the corners of drawn triangles; `smooth`: with the normals of vertices. */
export function cornersOf({corners}, framedPositions, smooth) {
  const positions = new Float32Array(3 * corners.length), normals = new Int8Array(4 * corners.length);
  const ofVertices = smooth ? normalsOf(framedPositions, corners) : null;
  for (let i = 0; i < corners.length; ++i) {
    const v = 4 * corners[i];
    for (let k = 0; k < 3; ++k) {
      positions[3 * i + k] = framedPositions[v + k];
      if (smooth) normals[4 * i + k] = Math.round(127 * ofVertices[v + k]);
    }
  }
  return {positions, normals};
}

/**
 * Returns fewer triangles that look alike from afar: vertices are merged within the cells of a grid (Rossignac, Borrel
 * 1993), `cells` along the unit. Positions are those of one vertex of each cell, so that elements keep their values.
 */
export function coarser({corners, elements, flags}, framedPositions, cells) {
  const first = new Map(), merged = new Uint32Array(framedPositions.length / 4).fill(0xffffffff);
  const kept = {corners: [], elements: [], flags: []};
  const of = v => {
    if (merged[v] !== 0xffffffff) return merged[v];
    const [x, y, z] = [0, 1, 2].map(k => Math.floor((framedPositions[4 * v + k] + 2) * cells)), key = (x * 4096 + y) * 4096 + z;
    if (!first.has(key)) first.set(key, v);
    return merged[v] = first.get(key);
  };
  for (let t = 0; t < elements.length; ++t) {
    const a = of(corners[3 * t]), b = of(corners[3 * t + 1]), c = of(corners[3 * t + 2]);
    if (a === b || b === c || c === a) continue;
    kept.corners.push(a, b, c);
    kept.elements.push(elements[t]);
    kept.flags.push(flags[t] | 7);
  }
  return {corners: Uint32Array.from(kept.corners), elements: Uint32Array.from(kept.elements), flags: Uint8Array.from(kept.flags)};
}

const sides = 6;

/** Returns drawn tubes along edges between vertices: positions and normals, three corners a triangle. */
export function tubesOf(edges, framedPositions, radius) {
  const positions = [], normals = [];
  for (let e = 0; e < edges.length; e += 2) {
    const [p, q] = [edges[e], edges[e + 1]].map(v => [0, 1, 2].map(k => framedPositions[4 * v + k]));
    const along = q.map((value, k) => value - p[k]), axis = [0, 0, 0];
    axis[along.map(Math.abs).indexOf(Math.min(...along.map(Math.abs)))] = 1;
    const cross = (u, v) => [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const unit = u => u.map(value => value / (Math.hypot(...u) || 1));
    const u = unit(cross(along, axis)), w = unit(cross(along, u));
    const ring = Array.from({length: sides + 1}, (_, i) => {
      const angle = 2 * Math.PI * i / sides;
      return u.map((value, k) => Math.cos(angle) * value + Math.sin(angle) * w[k]);
    });
    const put = (end, n) => {
      positions.push(...end.map((value, k) => value + radius * n[k]));
      normals.push(...n.map(value => Math.round(127 * value)), 0);
    };
    for (let i = 0; i < sides; ++i) {
      for (const [end, n] of [[p, ring[i]], [q, ring[i]], [q, ring[i + 1]], [p, ring[i]], [q, ring[i + 1]], [p, ring[i + 1]]]) put(end, n);
    }
  }
  return {positions: Float32Array.from(positions), normals: Int8Array.from(normals)};
}
