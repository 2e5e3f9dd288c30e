// Shapes into one another: through their spheres, or a shape into its sphere or polycube, as morph targets of one mesh.
import { Mesh } from './mesh.js';
import { Locator, bestRotation, grid, measure, overlay, roundToFloat } from './sphere_map.js';
import { writeGlb } from './gltf.js';

const arraysOf = (surface) => (surface instanceof Mesh ? surface.arrays : surface);

/** The middle of the bounding box of the vertices, and half its longest side. */
export function boxOf(positions) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  const centre = low.map((x, k) => 0.5 * (x + high[k]));
  return { centre, halfSize: 0.5 * Math.max(...high.map((x, k) => x - low[k])) || 1 };
}

/** Around the origin and two units in size, so that shapes can be shown beside each other. */
export function normalized(positions, { centre, halfSize } = boxOf(positions)) {
  return Float64Array.from(positions, (x, i) => (x - centre[i % 3]) / halfSize);
}

const turned = (vectors, rotation, back) => {
  const result = new Float64Array(vectors.length);
  for (let i = 0; i < vectors.length; i += 3) {
    for (let r = 0; r < 3; ++r) {
      for (let c = 0; c < 3; ++c) result[i + r] += (back ? rotation[3 * c + r] : rotation[3 * r + c]) * vectors[i + c];
    }
  }
  return result;
};

/**
 * The map turned so that its directions are near those in which their points are seen from the middle of the shape: then the straight
 * way from the shape to the sphere crosses itself as little as it can. Still a bijection, or the map as it was.
 */
export function facing(surface, directions, host = {}) {
  const { positions, triangles } = arraysOf(surface);
  const toShape = bestRotation(directions, normalized(positions));
  const result = turned(directions, toShape, false);
  return measure({ positions, triangles }, result, host).bijective === 1 ? result : directions;
}

/** How a map lies to its shape in space: the rotation that takes directions nearest to where their points are seen. */
function pose(positions, locator, sphere) {
  const seen = locator.sample(sphere, normalized(positions));
  return bestRotation(sphere, seen);
}

/**
 * Two shapes with their sphere maps as one mesh that is each of them in turn: `first` and `second` are positions of the same
 * vertices. Shapes that stand alike in space are brought into line by how their maps lie to them.
 */
export function morph(first, firstDirections, second, secondDirections, host = {}) {
  const [a, b] = [arraysOf(first), arraysOf(second)];
  const handles = [];
  const kept = (handle) => {
    handles.push(handle);
    return handle;
  };
  try {
    const [of, to] = [kept(new Locator(a, firstDirections, host)), kept(new Locator(b, secondDirections, host))];
    const sphere = kept(grid('icosphere', 4)).arrays.positions;
    // From the second map into space, and from there into the first one.
    const placed = turned(turned(secondDirections, pose(b.positions, to, sphere)), pose(a.positions, of, sphere), true);
    const { mesh, secondVertex } = overlay(a, firstDirections, b, placed, host);
    const { positions: directions, triangles } = kept(mesh).arrays;
    const back = (vectors) => turned(turned(vectors, pose(a.positions, of, sphere)), pose(b.positions, to, sphere), true);
    const firstPositions = of.sample(directions, a.positions, host);
    const secondPositions = to.sample(back(directions), b.positions, host);
    firstPositions.set(a.positions);
    secondVertex.forEach((at, v) => {
      if (at !== 0xffffffff) secondPositions.set(b.positions.subarray(3 * v, 3 * v + 3), 3 * at);
    });
    return { first: firstPositions, second: secondPositions, directions, triangles };
  } finally {
    for (const handle of handles) handle.close();
  }
}

/** Where a point of the sphere is in a picture of the whole sphere: the octahedron, folded open; v goes down. */
export function octahedronCoordinates(directions) {
  const result = new Float32Array(2 * directions.length / 3);
  for (let i = 0; i < directions.length / 3; ++i) {
    const [x, y, z] = directions.subarray(3 * i, 3 * i + 3);
    const size = Math.abs(x) + Math.abs(y) + Math.abs(z);
    result[2 * i] = 0.5 + 0.5 * x / size;
    result[2 * i + 1] = 0.5 - 0.5 * y / size;
  }
  return result;
}

/** A GLB file of a shape, two units in size, with its sphere as a morph target and a checker that both share. */
export function sphereGlb(surface, directions, { name = 'surface', ...host } = {}) {
  const { positions, triangles } = arraysOf(surface);
  const sphere = roundToFloat({ positions, triangles }, directions, host);
  return writeGlb({
    name, positions: normalized(positions), triangles, morphTargets: [{ name: 'sphere', positions: sphere }],
    textureCoordinates: octahedronCoordinates(directions), checker: true, baseColor: [1, 1, 1, 1],
  }, host);
}
