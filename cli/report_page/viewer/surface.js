// Surfaces as the viewer takes them: four floats a vertex, of which the fourth is 0.

export const shapeRadius = 1.15;  // of a shape's bounding sphere: a little larger than the unit sphere, which no shape fills so well

/** Returns the frame of positions, three numbers a vertex: framed position = scale * (position - center). */
export function frameOf(positions) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  const center = low.map((value, k) => (value + high[k]) / 2);
  let radius = 0;
  for (let i = 0; i < positions.length; i += 3) {
    radius = Math.max(radius, Math.hypot(...center.map((value, k) => positions[i + k] - value)));
  }
  return {center, scale: shapeRadius / (radius || 1)};
}

/** Returns positions, three numbers a vertex, in a frame; four floats a vertex. */
export function framed(positions, {center, scale} = {center: [0, 0, 0], scale: 1}) {
  const made = new Float32Array(positions.length / 3 * 4);
  for (let i = 0, at = 0; i < positions.length; i += 3, at += 4) {
    for (let k = 0; k < 3; ++k) made[at + k] = scale * (positions[i + k] - center[k]);
  }
  return made;
}

/** Returns the normals of the vertices, the mean over their triangles weighted by area; four floats a vertex. */
export function normalsOf(positions, triangles) {
  const normals = new Float32Array(positions.length);
  for (let i = 0; i < triangles.length; i += 3) {
    const a = 4 * triangles[i], b = 4 * triangles[i + 1], c = 4 * triangles[i + 2];
    const ux = positions[b] - positions[a], uy = positions[b + 1] - positions[a + 1];
    const uz = positions[b + 2] - positions[a + 2];
    const vx = positions[c] - positions[a], vy = positions[c + 1] - positions[a + 1];
    const vz = positions[c + 2] - positions[a + 2];
    for (const v of [a, b, c]) {
      normals[v] += uy * vz - uz * vy;
      normals[v + 1] += uz * vx - ux * vz;
      normals[v + 2] += ux * vy - uy * vx;
    }
  }
  for (let v = 0; v < normals.length; v += 4) {
    const length = Math.hypot(normals[v], normals[v + 1], normals[v + 2]) || 1;
    for (let k = 0; k < 3; ++k) normals[v + k] /= length;
  }
  return normals;
}
