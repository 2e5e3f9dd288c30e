// Draws meshes with WebGL 2, each in a view of its own that the same camera looks at, and finds what is at a place.

import {meshColorShader, meshNumberShader, meshVertexShader} from "./mesh_shaders.js";
import {Views} from "./viewer/webgl.js";

const attributes = {position: [3, "FLOAT", false], normal: [4, "BYTE", true], value: [1, "FLOAT", false], flags: [1, "UNSIGNED_BYTE", false]};
const programs = {color: meshColorShader, number: meshNumberShader};

export class MeshRenderer extends Views {
  /**
   * `look`: coloring of each view (0 base, 1 scale, 2 categories), range, edges, markInverted, base, inverted and none (colors from 0 to
   * 1), planes (of each view, four numbers). `narrow`: width of the canvas in CSS pixels below which views are above each
   * other. Throws when the browser has no WebGL 2.
   */
  constructor(canvas, camera, look, {views, narrow = 620, bottom = 0}) {
    super(canvas, camera);
    Object.assign(this, {look, narrow, bottom, coarse: false, items: Array.from({length: views}, () => ({layers: {}}))});
    const names = Object.keys(attributes);
    this.programs = Object.fromEntries(Object.entries(programs).map(([name, text]) => [name, this.program(meshVertexShader, text, names)]));
    this.setColors([[128, 128, 128]]);
  }

  setColors(colors) {
    this.colors = this.setColorRow(this.colors, colors);
  }

  /**
   * Sets a layer of a view: "main", "coarse" (drawn in its place while `coarse` holds), "ghost" (transparent) or the tubes,
   * with a color of their own. Attributes that are not given are 0. null: there is none.
   */
  setLayer(index, name, arrays) {
    const gl = this.gl, {layers} = this.items[index], old = layers[name];
    if (old) {
      Object.values(old.buffers).forEach(buffer => gl.deleteBuffer(buffer));
      gl.deleteVertexArray(old.array);
      delete layers[name];
    }
    if (!arrays || arrays.positions.length === 0) return;
    const layer = layers[name] = {count: arrays.positions.length / 3, color: arrays.color, buffers: {}, array: gl.createVertexArray()};
    this.setAttribute(layer, "position", arrays.positions);
    this.setAttribute(layer, "normal", arrays.normals);
    if (arrays.values) this.setAttribute(layer, "value", arrays.values);
    if (arrays.flags) this.setAttribute(layer, "flags", arrays.flags);
  }

  setValues(index, name, values) {
    const layer = this.items[index].layers[name];
    if (layer) this.setAttribute(layer, "value", values);
  }

  setAttribute(layer, name, data) {
    const gl = this.gl, [size, type, normalized] = attributes[name], place = Object.keys(attributes).indexOf(name);
    layer.buffers[name] ??= gl.createBuffer();
    gl.bindVertexArray(layer.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, layer.buffers[name]);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, size, gl[type], normalized, 0, 0);
  }

  get mesh() {
    return this.items.some(({layers}) => layers.main || layers.ghost);
  }

  /** The number of columns and rows in which views are nearest to squares. */
  grid(width, height) {
    const views = this.items.length;
    if (width < this.narrow) return views < 5 ? [1, views] : [2, Math.ceil(views / 2)];
    let [best, columns] = [0, 1];
    for (let tried = 1; tried <= views; ++tried) {
      const side = Math.min(width / tried, height / Math.ceil(views / tried));
      if (side > best * 1.001) [best, columns] = [side, tried];
    }
    return [columns, Math.ceil(views / columns)];
  }

  /** Where the views are, in CSS pixels from the canvas's top left. */
  views() {
    const width = this.canvas.clientWidth, height = Math.max(1, this.canvas.clientHeight - this.bottom);
    const [columns, rows] = this.grid(width, height);
    return this.items.map((_, i) => ({x: i % columns * width / columns, y: Math.floor(i / columns) * height / rows,
                                      width: width / columns, height: height / rows}));
  }

  viewAt(x, y) {
    const found = this.views().findIndex(view => x < view.x + view.width && y < view.y + view.height);
    return found < 0 ? this.items.length - 1 : found;
  }

  useScene(program, index, lens, shift) {
    const place = this.useCamera(program, lens, shift);
    this.gl.uniform4fv(place("plane"), this.look.planes[index] ?? [0, 0, 0, 1]);
    return place;
  }

  shownLayer({layers}) {
    return (this.coarse && layers.coarse) || layers.main;
  }

  draw() {
    const gl = this.gl;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.colors);
    this.drawViews((view, index) => this.drawView(index, view));
  }

  drawView(index, view) {
    const gl = this.gl, look = this.look, {layers} = this.items[index];
    const place = this.useScene(this.programs.color, index, this.lens(view), this.camera.shifts[index]);
    gl.uniform2fv(place("range"), look.range);
    for (const name of ["inverted", "none"]) gl.uniform3fv(place(name), look[name]);
    gl.uniform1i(place("markInverted"), look.markInverted ? 1 : 0);
    gl.uniform1i(place("ghost"), 0);
    const drawLayer = (layer, coloring, edges, color) => {
      if (!layer) return;
      gl.uniform1i(place("coloring"), coloring);
      gl.uniform1i(place("edges"), edges ? 1 : 0);
      gl.uniform3fv(place("base"), color);
      gl.bindVertexArray(layer.array);
      gl.drawArrays(gl.TRIANGLES, 0, layer.count);
    };
    drawLayer(this.shownLayer(this.items[index]), look.coloring[index] ?? 0, look.edges, look.base);
    gl.uniform4fv(place("plane"), [0, 0, 0, 1]);
    for (const [name, layer] of Object.entries(layers)) if (layer.color) drawLayer(layer, 0, false, layer.color);
    if (!layers.ghost) return;
    gl.uniform1i(place("ghost"), 1);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    drawLayer(layers.ghost, 0, false, look.base);
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  }

  /** What is seen at a place of the canvas: view and triangle of its main layer; null for nothing. */
  pick(x, y) {
    const gl = this.gl, index = this.viewAt(x, y), view = this.views()[index], layer = this.items[index].layers.main;
    if (!layer) return null;
    const triangle = this.numberAt(index, view, this.placeIn(view, x, y), (lens, shift) => {
      this.useScene(this.programs.number, index, lens, shift);
      gl.bindVertexArray(layer.array);
      gl.drawArrays(gl.TRIANGLES, 0, layer.count);
    });
    return triangle < 0 ? null : {index, triangle};
  }

  /** Where a point of the frame is seen in a view, in CSS pixels. */
  seenAt(index, point) {
    const [x, y, w] = this.seen(index, point);
    return this.pixelIn(this.views()[index], x / w, y / w);
  }
}
