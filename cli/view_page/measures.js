// Figures of triangles and cells, from positions in doubles.

const minus = (p, a, b) => [p[3 * a] - p[3 * b], p[3 * a + 1] - p[3 * b + 1], p[3 * a + 2] - p[3 * b + 2]];
const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
const cross = (u, v) => [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
const length = u => Math.hypot(u[0], u[1], u[2]);

function forEach(list, corners, measure) {
  const values = new Float32Array(list.length / corners);
  for (let i = 0; i < values.length; ++i) values[i] = measure(list.subarray(corners * i, corners * (i + 1)));
  return values;
}

export function triangleAreas(p, triangles) {
  return forEach(triangles, 3, ([a, b, c]) => length(cross(minus(p, b, a), minus(p, c, a))) / 2);
}

/** 4 sqrt(3) area over the sum of squared edges: 1 for equilateral triangles, 0 for those without area. */
export function triangleShapes(p, triangles) {
  return forEach(triangles, 3, ([a, b, c]) => {
    const u = minus(p, b, a), v = minus(p, c, a), w = minus(p, c, b), sum = dot(u, u) + dot(v, v) + dot(w, w);
    return sum > 0 ? 2 * Math.sqrt(3) * length(cross(u, v)) / sum : 0;
  });
}

/** The axis that a triangle's normal is nearest to, 0 to 5 for +x, -x, +y, -y, +z, -z, and whether all lie along theirs. */
export function facings(p, triangles) {
  let exact = true;
  const axes = forEach(triangles, 3, ([a, b, c]) => {
    const n = cross(minus(p, b, a), minus(p, c, a)), size = n.map(Math.abs), largest = Math.max(...size);
    const axis = size.indexOf(largest);
    if (length(n) > largest * 1.00002) exact = false;
    return 2 * axis + (n[axis] < 0 ? 1 : 0);
  });
  return {axes, exact};
}

/** The part of the surface that each triangle belongs to, the largest first, and their number. */
export function partsOf(vertexCount, triangles) {
  const parent = Uint32Array.from({length: vertexCount}, (_, i) => i);
  const root = v => {
    while (parent[v] !== v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (let i = 0; i < triangles.length; ++i) {
    const a = root(triangles[i]), b = root(triangles[i - i % 3]);
    parent[Math.max(a, b)] = Math.min(a, b);
  }
  const sizes = new Map();
  for (let i = 0; i < triangles.length; i += 3) {
    const part = root(triangles[i]);
    sizes.set(part, (sizes.get(part) ?? 0) + 1);
  }
  const order = new Map([...sizes].sort((a, b) => b[1] - a[1] || a[0] - b[0]).map(([part], i) => [part, i]));
  return {parts: forEach(triangles, 3, ([a]) => order.get(root(a))), count: order.size};
}

// The three neighbors of each corner, whose edges have a positive determinant in a good cell.
const neighbors = {
  4: [[1, 2, 3], [2, 0, 3], [0, 1, 3], [1, 0, 2]],
  8: [[1, 3, 4], [2, 0, 5], [3, 1, 6], [0, 2, 7], [7, 5, 0], [4, 6, 1], [5, 7, 2], [6, 4, 3]],
};

/**
 * The smallest determinant of the three edges at a corner over the product of their lengths, times sqrt(2) for tetrahedra:
 * 1 for boxes and regular tetrahedra, at most 0 for inverted cells.
 */
export function scaledJacobians(p, cells, corners) {
  const regular = corners === 4 ? Math.SQRT2 : 1;
  return forEach(cells, corners, cell => {
    let smallest = Infinity;
    neighbors[corners].forEach((others, i) => {
      const [u, v, w] = others.map(other => minus(p, cell[other], cell[i])), size = length(u) * length(v) * length(w);
      smallest = Math.min(smallest, size > 0 ? regular * dot(cross(u, v), w) / size : 0);
    });
    return smallest;
  });
}

// A hexahedron's volume as the sum over six tetrahedra round a diagonal; that of planar faces is exact.
const pieces = {4: [[0, 1, 2, 3]], 8: [[0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6], [0, 5, 1, 6]]};

export function volumes(p, cells, corners) {
  return forEach(cells, corners, cell => pieces[corners].reduce((sum, [a, b, c, d]) => sum +
      dot(cross(minus(p, cell[b], cell[a]), minus(p, cell[c], cell[a])), minus(p, cell[d], cell[a])) / 6, 0));
}

const edgesOf = {
  4: [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]],
  8: [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]],
};

export function edgeRatios(p, cells, corners) {
  return forEach(cells, corners, cell => {
    const lengths = edgesOf[corners].map(([a, b]) => length(minus(p, cell[a], cell[b])));
    const shortest = Math.min(...lengths);
    return shortest > 0 ? Math.max(...lengths) / shortest : Infinity;
  });
}

/** Of a map of a surface: log2 of sigma_max / sigma_min, and log2 of area over area with both wholes equal. */
export function distortions(p, q, triangles) {
  const before = triangleAreas(p, triangles), after = triangleAreas(q, triangles), sum = values => values.reduce((a, b) => a + b, 0);
  const whole = sum(after) / sum(before);
  const angle = forEach(triangles, 3, ([a, b, c]) => {
    // Cotangent weights: the Dirichlet energy of the affine map over its area is (s + 1 / s) / 2.
    const at = (m, i, j, k) => dot(minus(m, j, i), minus(m, k, i));
    const area = 2 * length(cross(minus(p, b, a), minus(p, c, a))), image = length(cross(minus(q, b, a), minus(q, c, a)));
    if (!(area > 0) || !(image > 0)) return NaN;
    const squared = (i, j) => { const u = minus(q, i, j); return dot(u, u); };
    const energy = (at(p, a, b, c) * squared(b, c) + at(p, b, c, a) * squared(c, a) + at(p, c, a, b) * squared(a, b)) / area;
    const half = Math.max(1, energy / image);
    return Math.log2(half + Math.sqrt(half * half - 1));
  });
  return {angle, area: before.map((area, i) => (area > 0 && after[i] > 0 ? Math.log2(after[i] / area / whole) : NaN))};
}
