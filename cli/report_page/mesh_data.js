// Reads the results as packed_mesh.cpp wrote them.

import {bytesOf} from "./base64.js";
import {frameOf, framed, normalsOf} from "./viewer/surface.js";

// The walk over the triangles, see walk() in packed_mesh.cpp.
function trianglesOf(codes, triangleCount) {
  const triangles = new Uint32Array(3 * triangleCount);
  const from = new Uint32Array(3 * triangleCount);  // the queue of edges, from start to end
  const to = new Uint32Array(3 * triangleCount);
  let read = 0, vertices = 0, written = 0, first = 0, last = 0;
  const number = () => {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      const byte = codes[read++];
      value |= (byte & 127) << shift;
      if (byte < 128) return value;
    }
  };
  const corner = code => (code === 1 ? vertices++ : vertices - (code - 1));
  const push = (start, end) => {
    from[last] = start;
    to[last++] = end;
  };
  const add = (a, b, c) => {
    triangles[written++] = a;
    triangles[written++] = b;
    triangles[written++] = c;
  };
  while (written < triangles.length) {
    if (first === last) {
      const a = corner(number()), b = corner(number()), c = corner(number());
      add(a, b, c);
      push(a, b);
      push(b, c);
      push(c, a);
    }
    while (first < last && written < triangles.length) {
      const start = from[first], end = to[first++];
      const code = number();
      if (code === 0) continue;
      const third = corner(code);
      add(end, start, third);
      push(start, third);
      push(third, end);
    }
  }
  return triangles;
}

// Four floats a vertex, as a texture takes them, and the frame.
function positionsOf(result) {
  const bytes = bytesOf(result.positions);
  const raw = new Float64Array(3 * result.vertices);
  for (let i = 0; i < raw.length; ++i) raw[i] = bytes[2 * i] | bytes[2 * i + 1] << 8;
  const frame = frameOf(raw);
  return {positions: framed(raw, frame), frame};
}

function directionsOf(result) {
  const bytes = bytesOf(result.directions);
  const directions = new Float32Array(4 * result.vertices);
  const coordinate = at => 2 * (bytes[at] | bytes[at + 1] << 8 | bytes[at + 2] << 16) / 0xffffff - 1;
  for (let v = 0; v < result.vertices; ++v) {
    let x = coordinate(6 * v), y = coordinate(6 * v + 3);
    const z = 1 - Math.abs(x) - Math.abs(y);
    if (z < 0) {
      const folded = (1 - Math.abs(y)) * (x < 0 ? -1 : 1);
      y = (1 - Math.abs(x)) * (y < 0 ? -1 : 1);
      x = folded;
    }
    const length = Math.hypot(x, y, z);
    directions.set([x / length, y / length, z / length], 4 * v);
  }
  return directions;
}

// The polycube in the frame of the page: scaled as a shape is, turned (facing, by columns) as the shape stands.
function polycubeOf({positions, facing}, vertices) {
  const plain = positionsOf({positions, vertices}).positions;
  const turned = new Float32Array(plain.length);
  for (let v = 0; v < plain.length; v += 4) {
    for (let k = 0; k < 3; ++k) {
      turned[v + k] = facing[k] * plain[v] + facing[3 + k] * plain[v + 1] + facing[6 + k] * plain[v + 2];
    }
  }
  return turned;
}

export function meshOf(result) {
  const triangles = trianglesOf(bytesOf(result.connections), result.triangles);
  const {positions, frame} = positionsOf(result);
  const quasiConformal = bytesOf(result.quasiConformal), area = bytesOf(result.areaRatio);
  const levels = new Uint8Array(2 * result.triangles);
  for (let t = 0; t < result.triangles; ++t) {
    levels[2 * t] = quasiConformal[t];
    levels[2 * t + 1] = area[t];
  }
  const directions = result.polycube ? polycubeOf(result.polycube, result.vertices) : directionsOf(result);
  return {triangles, positions, frame, directions, normals: normalsOf(positions, triangles), levels,
          ...(result.polycube && {facing: result.polycube.facing})};
}
