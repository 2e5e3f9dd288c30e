// What the elements of a mesh can be colored by. A quantity has: key, title, unit; compute(), a value for each element, done
// when it is first chosen; range(values), the ends of the scale; text(value); map, the name of its color map where the
// reader does not choose it; categories, names by value, in place of a scale.

import {distortions, edgeRatios, facings, partsOf, scaledJacobians, triangleAreas, triangleShapes, volumes} from "./measures.js";

export const figureOf = value => (Number.isFinite(value) ? value.toLocaleString("en", {maximumSignificantDigits: 5}) : "none");
const factorOf = value => (!Number.isFinite(value) ? "none" : value < -0.001 ? `1/${figureOf(2 ** -value)}` : figureOf(2 ** value));

const unitRange = () => [0, 1];

// All but the outermost hundredths.
function commonRange(values) {
  const step = Math.max(1, Math.floor(values.length / 20000)), sample = [];
  for (let i = 0; i < values.length; i += step) if (Number.isFinite(values[i])) sample.push(values[i]);
  sample.sort((a, b) => a - b);
  if (sample.length === 0) return [0, 1];
  const at = part => sample[Math.round(part * (sample.length - 1))], [low, high] = [at(0.01), at(0.99)];
  return high > low ? [low, high] : [low - 0.5 * Math.abs(low) - 1e-300, high + 0.5 * Math.abs(high) + 1e-300];
}

const quantity = more => ({unit: "", range: commonRange, text: figureOf, ...more});

function surfaceQuantities({positions, triangles, targets}) {
  const facing = facings(positions, triangles);
  const parts = () => partsOf(positions.length / 3, triangles).parts;
  const found = [
    quantity({key: "shape", title: "Triangle shape", unit: "1: equilateral", range: unitRange,
              compute: () => triangleShapes(positions, triangles)}),
    quantity({key: "area", title: "Triangle area", unit: "unit of the file, squared", compute: () => triangleAreas(positions, triangles)}),
    quantity({key: "facing", title: "Nearest axis of the normal", categories: ["+x", "−x", "+y", "−y", "+z", "−z"],
              compute: () => facing.axes}),
    quantity({key: "part", title: "Connected part", categories: i => `part ${i + 1}`, compute: parts}),
  ];
  targets.forEach(({name, positions: image}, i) => {
    let both = null;
    const of = which => () => (both ??= distortions(positions, image, triangles))[which];
    found.push(
        quantity({key: `angle${i}`, title: `Quasi-conformal distortion, ${name}`, unit: "ratio, 1: conformal", text: factorOf,
                  range: values => [0, commonRange(values)[1]], compute: of("angle")}),
        quantity({key: `ratio${i}`, title: `Area ratio, ${name}`, unit: "map over shape", text: factorOf, map: "diverging",
                  range: values => {
                    const end = Math.max(...commonRange(values).map(Math.abs));
                    return [-end, end];
                  },
                  compute: of("area")}));
  });
  return {quantities: found, first: targets.length ? "angle0" : facing.exact ? "facing" : "plain"};
}

function cellQuantities(mesh) {
  const kinds = [[mesh.tetrahedra, 4], [mesh.hexahedra, 8]].filter(([cells]) => cells.length > 0);
  const all = measure => () => {
    const lists = kinds.map(([cells, corners]) => measure(mesh.positions, cells, corners));
    const joined = new Float32Array(lists.reduce((sum, list) => sum + list.length, 0));
    lists.reduce((at, list) => (joined.set(list, at), at + list.length), 0);
    return joined;
  };
  const found = [
    quantity({key: "jacobian", title: "Scaled Jacobian", unit: "1: ideal, 0 and less: inverted", range: unitRange, inverted: true,
              compute: all(scaledJacobians)}),
    quantity({key: "volume", title: "Volume of a cell", unit: "unit of the file, cubed", compute: all(volumes)}),
    quantity({key: "edges", title: "Longest over shortest edge", unit: "ratio", compute: all(edgeRatios)}),
  ];
  if (kinds.length > 1) {
    found.push(quantity({key: "kind", title: "Kind of cell", categories: ["tetrahedron", "hexahedron"], compute: () =>
        Float32Array.from({length: mesh.tetrahedra.length / 4 + mesh.hexahedra.length / 8}, (_, i) => (i < mesh.tetrahedra.length / 4 ? 0 : 1))}));
  }
  return {quantities: found, first: "jacobian"};
}

/** Returns the quantities of a mesh, each with values(), and the key of the one to begin with. */
export function meshQuantities(mesh) {
  const cells = mesh.tetrahedra.length + mesh.hexahedra.length > 0;
  const {quantities, first} = cells ? cellQuantities(mesh) : surfaceQuantities(mesh);
  for (const each of quantities) {
    let values = null;
    each.values = () => values ??= each.compute();
  }
  return {quantities, first};
}
