// The viewer of all pages and of examples/web: draws when something has changed, and follows mouse, touch and keys.
// The pages of the command and of the Python package embed these modules (embed.py), bindings/js/build puts them beside the page of the example.

import {listenToKeys, listenToPointers} from "./controls.js";

export class Viewer {
  #waiting = false;
  #stale = false;
  #mouse = null;

  /**
   * The renderer's canvas, camera and look (see Renderer) belong to the page, which calls redraw() after it has changed
   * them. Options: keys, functions by the name of the key that calls them; onLayout, called before the views are drawn;
   * onDraw, called after it; onMove, called when somebody turns, zooms or moves; onPoint, called with what the mouse points
   * at (see Renderer.pick) or null; onLost, called when the graphics unit was lost.
   */
  constructor(renderer, {keys = {}, onLayout, onDraw, onMove, onPoint, onLost} = {}) {
    const {canvas, camera} = renderer;
    Object.assign(this, {renderer, canvas, camera, onLayout, onDraw, onMove, onPoint});
    listenToPointers(this);
    listenToKeys(this, keys);
    new ResizeObserver(() => this.drawNow()).observe(canvas);
    this.#listenToResolution();
    canvas.addEventListener("webglcontextlost", event => {
      event.preventDefault();
      onLost?.();
    });
  }

  // The canvas keeps its size where a window is moved to a screen with other pixels.
  #listenToResolution() {
    matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`).addEventListener("change", () => {
      this.redraw();
      this.#listenToResolution();
    }, {once: true});
  }

  /** Shows a mesh (see Renderer.setMesh). Throws when it is too large for the graphics unit. */
  setMesh(mesh) {
    this.#mouse = null;
    this.renderer.setMesh(mesh);
    this.redraw();
  }

  /** Draws with the browser's next picture, however often it is called. */
  redraw() {
    this.#stale = true;
    this.#update();
  }

  /** Points at a place of the canvas, in CSS pixels, or at none. */
  point(place) {
    this.#mouse = place;
    this.#update();
  }

  drawNow() {
    this.#stale = false;
    if (!this.renderer.mesh) return;
    this.onLayout?.();
    this.renderer.draw();
    this.onDraw?.();
    this.#find();
  }

  #update() {
    if (this.#waiting) return;
    this.#waiting = true;
    requestAnimationFrame(() => {
      this.#waiting = false;
      if (this.#stale) this.drawNow();
      else this.#find();
    });
  }

  #find() {
    if (!this.onPoint || !this.renderer.mesh) return;
    this.onPoint(this.#mouse && this.renderer.pick(this.#mouse.x, this.#mouse.y));
  }

  #moved() {
    this.onMove?.();
    this.redraw();
  }

  turnBy(axis, angle) {
    this.camera.turnBy(axis, angle);
    this.#moved();
  }

  /** Zooms about a place of the canvas, or about the center of each view. */
  zoomBy(factor, x, y) {
    if (x === undefined) {
      this.camera.zoomBy(factor);
    } else {
      const index = this.renderer.viewAt(x, y);
      this.camera.zoomBy(factor, index, this.renderer.placeIn(this.renderer.views()[index], x, y));
    }
    this.#moved();
  }

  /** Moves the picture of a view, by CSS pixels. */
  shiftBy(index, dx, dy) {
    const view = this.renderer.views()[index];
    this.camera.shiftBy(index, 2 * dx / view.width, -2 * dy / view.height);
    this.#moved();
  }

  reset() {
    this.camera.reset();
    this.redraw();
  }
}
