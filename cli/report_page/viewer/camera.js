// Where a viewer looks from: a rotation and a magnification that its views share, and a shift of each view's picture
// in halves of the view, x to the right and y up.

/** Returns the rotation matrix, by columns, of a unit quaternion x, y, z, w. */
export function matrixOf([x, y, z, w]) {
  return [
    1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w),
    2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w),
    2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y),
  ];
}

/** Returns the rotation by the second quaternion, then by the first. */
export function product([ax, ay, az, aw], [bx, by, bz, bw]) {
  const q = [aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
             aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz];
  const length = Math.hypot(...q);
  return q.map(value => value / length);
}

/** Returns the rotation about an axis by an angle in radians. */
export function rotation(axis, angle) {
  const sine = Math.sin(angle / 2) / (Math.hypot(...axis) || 1);
  return [...axis.map(value => value * sine), Math.cos(angle / 2)];
}

export class Camera {
  #home;

  /** The first rotation, a quaternion, magnification and shift of each view, which reset() restores. */
  constructor(turn = [0, 0, 0, 1], zoom = 1, shift = [0, 0], views = 2) {
    this.#home = {turn, zoom, shift, views};
    this.reset();
  }

  /** Rotates to another quaternion, which is the first one from now on. */
  lookFrom(turn) {
    this.#home.turn = this.turn = turn;
  }

  reset() {
    const {turn, zoom, shift, views} = this.#home;
    Object.assign(this, {turn, zoom, shifts: Array.from({length: views}, () => [...shift])});
  }

  /** Rotates about an axis of the picture, by an angle in radians. */
  turnBy(axis, angle) {
    this.turn = product(rotation(axis, angle), this.turn);
  }

  /** Magnifies every view about its center, or view `index` about a place of it, from -1 to 1. */
  zoomBy(factor, index = -1, place = [0, 0]) {
    const zoom = Math.min(400, Math.max(0.3, this.zoom * factor)), actual = zoom / this.zoom;
    this.zoom = zoom;
    this.shifts = this.shifts.map((shift, i) => shift.map((value, k) => {
      const fixed = i === index ? place[k] : 0;
      return fixed + (value - fixed) * actual;
    }));
  }

  shiftBy(index, dx, dy) {
    this.shifts[index][0] += dx;
    this.shifts[index][1] += dy;
  }
}
