// Draws meshes with WebGL 2, each in a view of its own that the same camera looks at, and finds what is at a place.

import {eyeDistance, meshColorShader, meshNumberShader, meshVertexShader} from "./mesh_shaders.js";
import {matrixOf} from "./viewer/camera.js";

const attributes = {position: [3, "FLOAT", false], normal: [4, "BYTE", true], value: [1, "FLOAT", false], flags: [1, "UNSIGNED_BYTE", false]};
const programs = {color: meshColorShader, number: meshNumberShader};

export class MeshRenderer {
  /**
   * `look`: coloring of each view (0 base, 1 scale, 2 categories), range, edges, markInverted, base, inverted and none (colors from 0 to
   * 1), planes (of each view, four numbers). `narrow`: width of the canvas in CSS pixels below which views are above each
   * other. Throws when the browser has no WebGL 2.
   */
  constructor(canvas, camera, look, {views, narrow = 620, bottom = 0}) {
    Object.assign(this, {canvas, camera, look, narrow, bottom, coarse: false, items: Array.from({length: views}, () => ({layers: {}}))});
    // The picture is kept, so that it is also there when the page is printed and when it is saved.
    const gl = this.gl = canvas.getContext("webgl2", {antialias: true, preserveDrawingBuffer: true});
    if (!gl) throw new Error("no WebGL 2");
    this.programs = Object.fromEntries(Object.entries(programs).map(([name, text]) => [name, this.program(meshVertexShader, text)]));
    gl.enable(gl.DEPTH_TEST);
    this.makePickTarget();
    this.colors = gl.createTexture();
    this.setColors([[128, 128, 128]]);
  }

  program(vertexText, fragmentText) {
    const gl = this.gl, program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertexText], [gl.FRAGMENT_SHADER, fragmentText]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    Object.keys(attributes).forEach((name, i) => gl.bindAttribLocation(program, i, name));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
  }

  // One pixel that holds the number of the triangle drawn there.
  makePickTarget() {
    const gl = this.gl;
    this.pickTarget = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.pickTarget);
    for (const [attachment, format] of [[gl.COLOR_ATTACHMENT0, gl.RGBA8], [gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24]]) {
      const buffer = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
      gl.renderbufferStorage(gl.RENDERBUFFER, format, 1, 1);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, buffer);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  setColors(colors) {
    const gl = this.gl;
    gl.bindTexture(gl.TEXTURE_2D, this.colors);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB8, colors.length, 1, 0, gl.RGB, gl.UNSIGNED_BYTE, new Uint8Array(colors.flat()));
    for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, wrap, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
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

  // A place of the canvas in a view, from -1 to 1, y up.
  placeIn(view, x, y) {
    return [2 * (x - view.x) / view.width - 1, 1 - 2 * (y - view.y) / view.height];
  }

  // The unit sphere fills 84 % of the shorter side.
  lens(view) {
    const scale = 0.84 * this.camera.zoom * Math.sqrt(eyeDistance ** 2 - 1), shorter = Math.min(view.width, view.height);
    return [scale * shorter / view.width, scale * shorter / view.height];
  }

  useScene(program, index, lens, shift) {
    const gl = this.gl, place = name => gl.getUniformLocation(program, name);
    gl.useProgram(program);
    gl.uniformMatrix3fv(place("turn"), false, matrixOf(this.camera.turn));
    gl.uniform2fv(place("lens"), lens);
    gl.uniform2fv(place("shift"), shift);
    gl.uniform4fv(place("plane"), this.look.planes[index] ?? [0, 0, 0, 1]);
    return place;
  }

  shownLayer({layers}) {
    return (this.coarse && layers.coarse) || layers.main;
  }

  draw() {
    const gl = this.gl, canvas = this.canvas, ratio = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.colors);
    gl.enable(gl.SCISSOR_TEST);
    this.views().forEach((view, index) => {
      const box = [view.x, canvas.clientHeight - view.y - view.height, view.width, view.height].map(value => value * ratio);
      gl.viewport(...box);
      gl.scissor(...box);
      this.drawView(index, view);
    });
    gl.disable(gl.SCISSOR_TEST);
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
    const at = this.placeIn(view, x, y), lens = this.lens(view), shift = this.camera.shifts[index];
    // The picture magnified until one pixel of it fills the target.
    const magnified = [view.width, view.height];
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.pickTarget);
    gl.viewport(0, 0, 1, 1);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.useScene(this.programs.number, index, lens.map((value, k) => value * magnified[k]),
                  shift.map((value, k) => (value - at[k]) * magnified[k]));
    gl.bindVertexArray(layer.array);
    gl.drawArrays(gl.TRIANGLES, 0, layer.count);
    const pixel = new Uint8Array(4);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const triangle = (pixel[0] | pixel[1] << 8 | pixel[2] << 16 | pixel[3] << 24) - 1;
    return triangle < 0 ? null : {index, triangle};
  }

  /** Where a point of the frame is seen in a view, in CSS pixels. */
  seenAt(index, point) {
    const m = matrixOf(this.camera.turn), view = this.views()[index], lens = this.lens(view), shift = this.camera.shifts[index];
    const [x, y, z] = [0, 1, 2].map(k => m[k] * point[0] + m[3 + k] * point[1] + m[6 + k] * point[2]), w = eyeDistance - z;
    return {x: view.x + (0.5 + 0.5 * (lens[0] * x / w + shift[0])) * view.width,
            y: view.y + (0.5 - 0.5 * (lens[1] * y / w + shift[1])) * view.height};
  }

  /** For tests: the fraction of a view that is drawn on and how many colors it has. Call right after draw. */
  statistics(index) {
    const gl = this.gl, ratio = this.canvas.width / this.canvas.clientWidth, view = this.views()[index];
    const width = Math.floor(view.width * ratio), height = Math.floor(view.height * ratio);
    const pixels = new Uint8Array(4 * width * height), colors = new Set();
    gl.readPixels(view.x * ratio, this.canvas.height - (view.y + view.height) * ratio, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    let drawn = 0;
    for (let i = 0; i < pixels.length; i += 4) {
      if (pixels[i + 3] === 0) continue;
      ++drawn;
      colors.add(pixels[i] << 16 | pixels[i + 1] << 8 | pixels[i + 2]);
    }
    return {drawn: drawn / (width * height), colors: colors.size};
  }
}
