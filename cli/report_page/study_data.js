// Reads the data of a study as study_page.cpp wrote it, and moves the mean shape.

import {bytesOf} from "./base64.js";
import {quantitiesOf} from "./colors.js";
import {frameOf, framed, normalsOf} from "./viewer/surface.js";

/** Returns numbers that were written as steps of 16 bits. */
export function numbersOf({low, step, values}) {
  const bytes = bytesOf(values), numbers = new Float64Array(bytes.length / 2);
  for (let i = 0; i < numbers.length; ++i) numbers[i] = low + step * (bytes[2 * i] | bytes[2 * i + 1] << 8);
  return numbers;
}

function cornersOf(text) {
  const bytes = bytesOf(text), corners = new Uint32Array(bytes.length / 4);
  for (let i = 0; i < corners.length; ++i) {
    corners[i] = (bytes[4 * i] | bytes[4 * i + 1] << 8 | bytes[4 * i + 2] << 16 | bytes[4 * i + 3] << 24) >>> 0;
  }
  return corners;
}

/** The mean shape and what it is moved by: `shifts` of the data, each with an amount. */
export class MovedMean {
  constructor(data) {
    this.mean = numbersOf(data.mean);
    this.triangles = cornersOf(data.triangles);
    this.shifts = data.shifts.map(numbersOf);
    this.frame = frameOf(this.mean);
    const positions = framed(this.mean, this.frame);
    this.normals = normalsOf(positions, this.triangles);
    this.mesh = {triangles: this.triangles, positions, directions: positions, normals: this.normals};
  }

  /** Returns what all points are moved by, three numbers each. */
  displacement(amounts) {
    const sum = new Float64Array(this.mean.length);
    this.shifts.forEach((shift, k) => {
      if (amounts[k] !== 0) for (let i = 0; i < sum.length; ++i) sum[i] += amounts[k] * shift[i];
    });
    return sum;
  }

  /** Returns the moved positions in the frame of the mean, four floats a vertex. */
  positionsAt(amounts) {
    return framed(this.displacement(amounts).map((value, i) => value + this.mean[i]), this.frame);
  }

  /** Returns the part of vectors along the outward normals of the mean. */
  alongNormals(vectors) {
    return Float64Array.from({length: vectors.length / 3}, (_, v) => vectors[3 * v] * this.normals[4 * v] +
        vectors[3 * v + 1] * this.normals[4 * v + 1] + vectors[3 * v + 2] * this.normals[4 * v + 2]);
  }
}

export const level = 0.05;  // of significance
const leastProbability = 0.001;
const {quasiConformal: {colors: rising}, area: {colors: bothWays}} = quantitiesOf({quasiConformal: {}, area: {}});
export const shortText = value => value.toLocaleString("en", {maximumSignificantDigits: 3});

/**
 * Returns the color scale of values: `at`, the place of a value from 0 to 1, or NaN for gray; colors; ticks, places with
 * texts. Kinds: "size" from 0, "signed" about 0, "probability" below the level.
 */
export function scaleOf(kind, values) {
  let most = 0;
  for (const value of values) most = Math.max(most, Math.abs(value));
  most ||= 1;
  if (kind === "probability") {
    const span = Math.log(level / leastProbability);
    const at = value => (value > level ? NaN : Math.min(1, Math.log(level / Math.max(value, 1e-300)) / span));
    return {at, colors: rising, ticks: [level, 0.01, leastProbability].map(value => [at(value), String(value)])};
  }
  if (kind === "signed") {
    return {at: value => (value / most + 1) / 2, colors: bothWays, ticks: [[0, shortText(-most)], [0.5, "0"], [1, shortText(most)]]};
  }
  return {at: value => value / most, colors: rising, ticks: [[0, "0"], [0.5, shortText(most / 2)], [1, shortText(most)]]};
}

// Levels that the shader squares; 255: none.
export const coding = {zero: 0, span: 254, octaves: 1, none: 255};

/** Returns the levels of triangles, two bytes each, from values of their vertices. */
export function levelsOf(values, triangles, {at}) {
  const levels = new Uint8Array(2 * triangles.length / 3);
  for (let t = 0; t < levels.length / 2; ++t) {
    const mean = (values[triangles[3 * t]] + values[triangles[3 * t + 1]] + values[triangles[3 * t + 2]]) / 3;
    const place = at(mean);
    levels[2 * t] = Number.isNaN(place) ? coding.none : Math.round(coding.span * Math.sqrt(Math.min(1, Math.max(0, place))));
  }
  return levels;
}
