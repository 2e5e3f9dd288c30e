// The shape as its spherical harmonics give it, to any degree up to that of the coefficients: sums of
//   Y_lm = P_l|m|(z) { sqrt 2 Re, 1, sqrt 2 Im } (x + iy)^|m|    for m > 0, m = 0, m < 0
// with the normalized P_lm of the recurrence in z (as in libs/harmonics), the factor sin^m put with x + iy.

import {bytesOf} from "./base64.js";
import {shapeRadius} from "./viewer/surface.js";

export class Reconstruction {
  // `mesh` as meshOf() makes it; result.harmonics: degree, coefficients (float32; x, y, z for each l, m) and facing, the
  // rotation by columns that the directions of the page have been turned by.
  constructor(result, mesh) {
    const {degree, facing} = result.harmonics;
    this.degree = degree;
    this.mesh = mesh;
    this.frame = mesh.frame;
    this.shape = mesh.positions;
    this.coefficients = new Float32Array(bytesOf(result.harmonics.coefficients).buffer);
    this.directions = new Float64Array(3 * result.vertices);
    for (let v = 0; v < result.vertices; ++v) {
      const d = mesh.directions.subarray(4 * v, 4 * v + 3);
      for (let k = 0; k < 3; ++k) {
        this.directions[3 * v + k] = facing[3 * k] * d[0] + facing[3 * k + 1] * d[1] + facing[3 * k + 2] * d[2];
      }
    }
    this.known = new Map();
  }

  // For each m and l up to the degree in the order of the sums: the factors of the recurrence, then the coefficients of
  // the cosines and of the sines.
  table(degree) {
    const rows = [];
    for (let m = 0; m <= degree; ++m) {
      for (let l = m; l <= degree; ++l) {
        const factor = l === m ? 0 : Math.sqrt((4 * l * l - 1) / (l * l - m * m));
        const before = l < m + 2 ? 0 : Math.sqrt(((l - 1) ** 2 - m * m) / (4 * (l - 1) ** 2 - 1));
        const of = order => [0, 1, 2].map(k => (m > 0 ? Math.SQRT2 : 1) * this.coefficients[3 * (l * l + l + order) + k]);
        rows.push(factor, before, ...of(m), ...(m > 0 ? of(-m) : [0, 0, 0]));
      }
    }
    return new Float64Array(rows);
  }

  // Positions as positionsOf() makes them.
  at(degree) {
    if (this.known.has(degree)) return this.known.get(degree);
    const table = this.table(degree), {center, scale} = this.frame, count = this.directions.length / 3;
    const positions = new Float32Array(4 * count), diagonal = [Math.sqrt(0.25 / Math.PI)];
    for (let m = 1; m <= degree; ++m) diagonal.push(diagonal[m - 1] * Math.sqrt((2 * m + 1) / (2 * m)));
    for (let v = 0; v < count; ++v) {
      const x = this.directions[3 * v], y = this.directions[3 * v + 1], z = this.directions[3 * v + 2];
      let real = 1, imaginary = 0, row = 0, sx = 0, sy = 0, sz = 0;
      for (let m = 0; m <= degree; ++m) {
        let now = diagonal[m], last = 0, cx = 0, cy = 0, cz = 0, ix = 0, iy = 0, iz = 0;
        for (let l = m; l <= degree; ++l, row += 8) {
          if (l > m) {
            const next = table[row] * (z * now - table[row + 1] * last);
            last = now;
            now = next;
          }
          cx += now * table[row + 2];
          cy += now * table[row + 3];
          cz += now * table[row + 4];
          ix += now * table[row + 5];
          iy += now * table[row + 6];
          iz += now * table[row + 7];
        }
        sx += real * cx + imaginary * ix;
        sy += real * cy + imaginary * iy;
        sz += real * cz + imaginary * iz;
        const turned = real * x - imaginary * y;
        imaginary = real * y + imaginary * x;
        real = turned;
      }
      positions[4 * v] = scale * (sx - center[0]);
      positions[4 * v + 1] = scale * (sy - center[1]);
      positions[4 * v + 2] = scale * (sz - center[2]);
    }
    if (positions.length * (this.known.size + 1) > 1.6e7) this.known.clear();  // 64 MB
    this.known.set(degree, positions);
    return positions;
  }

  // Root of the mean squared distance from the shape's vertices, over the diameter of its bounding sphere.
  distance(degree) {
    const positions = this.at(degree);
    let sum = 0;
    for (let i = 0; i < positions.length; ++i) sum += (positions[i] - this.shape[i]) ** 2;
    return Math.sqrt(sum / (positions.length / 4)) / (2 * shapeRadius);
  }
}
