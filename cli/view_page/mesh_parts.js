// The meshes of a page as view_data.cpp and the Python package write them: numbers of a fixed width in base64.

import {bytesOf} from "./base64.js";
import {frameOf, framed} from "./viewer/surface.js";

/** Returns whole numbers of `width` bytes each, low byte first. */
export function numbersOf(base64, width) {
  const bytes = bytesOf(base64 ?? ""), numbers = new Uint32Array(bytes.length / width);
  for (let i = 0, at = 0; i < numbers.length; ++i) {
    let value = 0;
    for (let k = 0; k < width; ++k, ++at) value |= bytes[at] << 8 * k;
    numbers[i] = value;  // without sign
  }
  return numbers;
}

const positionWidth = 3;

/** Returns positions in the unit of the file, three doubles a vertex. */
export function positionsOf({low, step, positions}) {
  const numbers = numbersOf(positions, positionWidth), made = new Float64Array(numbers.length);
  for (let i = 0; i < made.length; ++i) made[i] = low[i % 3] + step * numbers[i];
  return made;
}

/**
 * Returns a mesh to draw: positions in the file's unit, triangles, tetrahedra and hexahedra as flat arrays, and the frame
 * and framed positions (viewer/surface.js). Positions in the frame come from the whole numbers, which have no offset that
 * would cost digits.
 */
export function meshPartsOf(item) {
  const list = name => numbersOf(item[name], item.width), steps = numbersOf(item.positions, positionWidth);
  const frame = frameOf(steps);
  return {
    positions: positionsOf(item), framedPositions: framed(steps, frame),
    frame: {center: frame.center.map((value, k) => item.low[k] + item.step * value), scale: frame.scale / item.step},
    triangles: list("triangles"), tetrahedra: list("tetrahedra"), hexahedra: list("hexahedra"),
    targets: (item.targets ?? []).map(target => {
      const numbers = numbersOf(target.positions, positionWidth);
      return {name: target.name, positions: positionsOf(target), framedPositions: framed(numbers, frameOf(numbers))};
    }),
    curves: (item.curves ?? []).map(({name, edges}) => ({name, edges: numbersOf(edges, item.width)})),
  };
}
