// One mesh of the page in its view: what of it is shown, its colors, and what is known of a place that is picked.

import {Geometry, coarser, cornersOf, tubesOf} from "./geometry.js";
import {meshPartsOf} from "./mesh_parts.js";
import {figureOf, meshQuantities} from "./quantities.js";

const coarseGrid = 40;  // cells along the unit, some 30,000 triangles
export const curveColors = [[0.80, 0.15, 0.12], [0.10, 0.35, 0.85], [0.95, 0.62, 0.10]];

export class MeshView {
  constructor(renderer, index, item) {
    Object.assign(this, {renderer, index, item, mesh: meshPartsOf(item), morphed: null});
    this.geometry = new Geometry(this.mesh);
    this.shown = this.mesh.framedPositions;
    Object.assign(this, meshQuantities(this.mesh));
    this.ghosted = false;
    this.#addCurves();
  }

  get ofCells() {
    return this.geometry.ofCells;
  }

  /** The quantity of that key, undefined where this mesh has none. */
  quantity(key) {
    return this.quantities.find(each => each.key === key);
  }

  #addCurves() {
    const {curves, framedPositions} = this.mesh;
    curves.forEach(({edges}, kind) => {
      this.renderer.setLayer(this.index, `curves ${kind}`, {...tubesOf(edges, framedPositions, 0.008), color: curveColors[kind]});
    });
    this.hasCurves = curves.some(({edges}) => edges.length > 0);
  }

  /** Takes the surface between its shape (0) and its first target (1), which show() then shows. */
  morph(part) {
    const [target] = this.mesh.targets;
    if (!target) return;
    const from = this.mesh.framedPositions, to = target.framedPositions;
    this.shown = part === 0 ? from : from.map((value, i) => (1 - part) * value + part * to[i]);
  }

  /**
   * Shows the elements whose center is on the near side of a plane, {normal, at} in the frame, or null, and whose quality is
   * within [low, high], null for all. A surface is cut by the plane itself.
   */
  show(plane, quality = null) {
    const {geometry, renderer, index} = this;
    let keeps = null;
    if (this.ofCells && (plane || quality)) {
      const centers = geometry.centers(), values = quality && this.quantity("jacobian").values();
      keeps = Uint8Array.from({length: geometry.elementCount}, (_, i) => {
        const beyond = plane && [0, 1, 2].reduce((sum, k) => sum + plane.normal[k] * centers[3 * i + k], 0) > plane.at;
        return beyond || (quality && !(values[i] >= quality[0] && values[i] <= quality[1])) ? 0 : 1;
      });
    }
    renderer.look.planes[index] = plane && !this.ofCells ? [...plane.normal, plane.at] : [0, 0, 0, 1];
    const only = this.hasCurves && !keeps;  // the solid is transparent, so that its curves are seen
    this.drawn = geometry.drawn(keeps);
    const smooth = !this.ofCells;
    renderer.setLayer(index, "main", only ? null : {...cornersOf(this.drawn, this.shown, smooth), flags: this.#perCorner(this.drawn.flags, Uint8Array)});
    this.#addGhost(only || (keeps && (quality !== null || this.hasCurves)));
    renderer.setLayer(index, "coarse", null);
    this.coarse = null;
    this.#color();
  }

  // The whole boundary, transparent.
  #addGhost(wanted) {
    if (wanted === this.ghosted) return;
    this.ghosted = wanted;
    const whole = wanted && this.geometry.drawn(null);
    this.renderer.setLayer(this.index, "ghost", wanted ? {...cornersOf(whole, this.shown, true), flags: this.#perCorner(whole.flags, Uint8Array)} : null);
  }

  /** Makes what is drawn while a mesh of `limit` triangles or more is turned. */
  prepareCoarse(limit) {
    if (this.coarse || this.drawn.elements.length < limit) return;
    this.coarse = coarser(this.drawn, this.shown, coarseGrid);
    this.renderer.setLayer(this.index, "coarse", {...cornersOf(this.coarse, this.shown, !this.ofCells),
                                                  flags: this.#perCorner(this.coarse.flags, Uint8Array)});
    this.#color();
  }

  color(key) {
    this.key = key;
    this.#color();
  }

  #color() {
    const quantity = this.quantity(this.key);
    if (!quantity) return;
    const values = quantity.values();
    for (const [name, {elements}] of [["main", this.drawn], ["coarse", this.coarse ?? {}]]) {
      if (elements) this.renderer.setValues(this.index, name, this.#perCorner(elements, Float32Array, values));
    }
  }

  #perCorner(list, Numbers, values = null) {
    const made = new Numbers(3 * list.length);
    for (let t = 0; t < list.length; ++t) made.fill(values ? values[list[t]] : list[t], 3 * t, 3 * t + 3);
    return made;
  }

  pointOf(vertex) {
    return [0, 1, 2].map(k => this.shown[4 * vertex + k]);
  }

  /** The vertex of an element that is seen nearest to a place of the canvas. */
  nearestVertex(element, x, y) {
    const away = vertex => {
      const seen = this.renderer.seenAt(this.index, this.pointOf(vertex));
      return Math.hypot(seen.x - x, seen.y - y);
    };
    return [...this.geometry.verticesOf(element)].reduce((best, vertex) => (away(vertex) < away(best) ? vertex : best));
  }

  /** Lines about an element and one of its vertices. */
  describe(element, vertex) {
    const {positions} = this.mesh, vertices = this.geometry.verticesOf(element);
    const at = [0, 1, 2].map(k => figureOf(positions[3 * vertex + k])).join(", ");
    return [
      `${this.geometry.nameOf(element)} of ${this.item.name}: vertices ${[...vertices].join(", ")}`,
      ...this.quantities.filter(({key}) => key !== "part" || key === this.key).map(quantity => {
        const value = quantity.values()[element], names = quantity.categories;
        return `${quantity.title}: ${names ? (typeof names === "function" ? names(value) : names[value]) : quantity.text(value)}`;
      }),
      `Vertex ${vertex}: ${at}`,
    ];
  }
}
