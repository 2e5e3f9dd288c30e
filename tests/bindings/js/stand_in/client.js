// In place of the package, for tests of the page alone: every shape is a bump on a cube, whose maps are known.

/** A cube with `count` squares along each side, welded: positions on it, three numbers a vertex, and triangles. */
function cube(count) {
  const positions = [];
  const triangles = [];
  const known = new Map();
  const vertex = (place) => {
    const key = place.join();
    if (!known.has(key)) {
      known.set(key, positions.length / 3);
      positions.push(...place.map((steps) => 2 * steps / count - 1));
    }
    return known.get(key);
  };
  for (let axis = 0; axis < 3; ++axis) {
    for (const end of [0, count]) {
      for (let i = 0; i < count; ++i) {
        for (let j = 0; j < count; ++j) {
          const corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(([di, dj]) => {
            const place = [];
            place[axis] = end;
            place[(axis + 1) % 3] = i + di;
            place[(axis + 2) % 3] = j + dj;
            return vertex(place);
          });
          const [a, b, c, d] = end ? corners : corners.reverse();
          triangles.push(a, b, c, a, c, d);
        }
      }
    }
  }
  return { positions: Float64Array.from(positions), triangles: Uint32Array.from(triangles) };
}

const made = cube(24);
const each = (place) => {
  const values = new Float64Array(made.positions.length);
  for (let i = 0; i < values.length; i += 3) values.set(place(...made.positions.subarray(i, i + 3)), i);
  return values;
};
const directions = each((x, y, z) => [x, y, z].map((value) => value / Math.hypot(x, y, z)));
const surface = { triangles: made.triangles, positions: each((x, y, z) => {
  const length = Math.hypot(x, y, z);
  return [x / length * 1.6, y / length * (y > 0 ? 1.5 : 0.8), z / length * (1 + 0.3 * Math.cos(3 * x))];
}) };
const results = {
  make: surface,
  read: surface,
  sphereMap: { directions, report: { flipped: 0, meanQuasiConformal: 1.2, maxQuasiConformal: 2 } },
  polycube: { positions: surface.positions, polycube: made.positions, triangles: made.triangles, corners: 8 },
};

export class OrbicubeWorker {
  async run(work) {
    if (!results[work]) throw new Error(`${work} is not done here`);
    return results[work];
  }
}
