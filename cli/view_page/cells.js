// Faces of tetrahedra and hexahedra, and which of them are seen when only some of the cells are shown.

// Counter-clockwise seen from outside.
const faceCorners = {
  4: [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]],
  8: [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]],
};

/** Cells of one kind, `corners` vertices each. */
export class Cells {
  constructor(vertices, corners) {
    this.vertices = vertices;
    this.corners = corners;
    this.count = vertices.length / corners;
    this.faces = faceCorners[corners];
    this.#connect();
  }

  // The three lowest vertices of a face, which no other face of a mesh has.
  #keyOf(face, key) {
    const sides = this.faces.length, cell = Math.floor(face / sides), at = cell * this.corners;
    const list = this.faces[face % sides];
    let [a, b, c] = [Infinity, Infinity, Infinity];
    for (const corner of list) {
      const v = this.vertices[at + corner];
      if (v < a) [a, b, c] = [v, a, b];
      else if (v < b) [b, c] = [v, b];
      else if (v < c) c = v;
    }
    key[0] = a;
    key[1] = b;
    key[2] = c;
  }

  // The cell across each face, -1 for none.
  #connect() {
    const total = this.count * this.faces.length, sides = this.faces.length;
    this.across = new Int32Array(total).fill(-1);
    let size = 1;
    while (size < 2 * total) size *= 2;
    const table = new Int32Array(size).fill(-1), keys = new Uint32Array(3 * total), key = [0, 0, 0];
    for (let face = 0; face < total; ++face) {
      this.#keyOf(face, key);
      const [a, b, c] = key;
      keys.set(key, 3 * face);
      let slot = (Math.imul(a, 73856093) ^ Math.imul(b, 19349663) ^ Math.imul(c, 83492791)) & (size - 1);
      for (; table[slot] >= 0; slot = (slot + 1) & (size - 1)) {
        const other = table[slot];
        if (keys[3 * other] !== a || keys[3 * other + 1] !== b || keys[3 * other + 2] !== c) continue;
        this.across[face] = Math.floor(other / sides);
        this.across[other] = Math.floor(face / sides);
        break;
      }
      if (table[slot] < 0) table[slot] = face;
    }
  }

  /** Calls see(cell, corners of the face, whether it is of the boundary) for each face of shown cells that nothing covers. */
  seen(shown, see) {
    const sides = this.faces.length;
    for (let cell = 0; cell < this.count; ++cell) {
      if (!shown[cell]) continue;
      for (let side = 0; side < sides; ++side) {
        const other = this.across[cell * sides + side];
        if (other < 0 || !shown[other]) see(cell, this.faces[side], other < 0);
      }
    }
  }
}
