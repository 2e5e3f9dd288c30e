// Draws a shape and its map with WebGL 2: in one view as a morph, or in two side by side; and finds what is at a place.

import {matrixOf} from "./camera.js";
import {colorShader, eyeDistance, modes, numberShader, textureWidth, vertexShader} from "./shaders.js";
import {normalsOf} from "./surface.js";

export class Renderer {
  // `look`: morph, from 0 for the shape to 1 for its map; mode, one of modes; edges; for the modes of quantities also
  // coding and bounds. With two views the second one is of the map. `bottom`: height in CSS pixels that two views above
  // each other leave free. Throws when the browser has no WebGL 2.
  constructor(canvas, camera, look, {views = 1, bottom = 0} = {}) {
    Object.assign(this, {canvas, camera, look, bottom, viewCount: views, mesh: null});
    // The picture is kept, so that it is also there when the page is printed.
    const gl = this.gl = canvas.getContext("webgl2", {antialias: true, preserveDrawingBuffer: true});
    if (!gl) throw new Error("no WebGL 2");
    this.colorProgram = this.program(vertexShader, colorShader);
    this.numberProgram = this.program(vertexShader, numberShader);
    this.textures = {};
    this.vertexArray = gl.createVertexArray();
    gl.bindVertexArray(this.vertexArray);
    gl.enable(gl.DEPTH_TEST);
    this.makePickTarget();
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

  setTexture(name, data, count, internalFormat, format, type) {
    const gl = this.gl, height = Math.max(1, Math.ceil(count / textureWidth));
    if (height > gl.getParameter(gl.MAX_TEXTURE_SIZE)) throw new Error("the mesh is too large for this graphics unit");
    const padded = new data.constructor(data.length / count * textureWidth * height);
    padded.set(data);
    this.textures[name] ??= gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.textures[name]);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texImage2D(gl.TEXTURE_2D, 0, internalFormat, textureWidth, height, 0, format, type, padded);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  }

  // positions, directions (on the sphere, or positions on the polycube) and normals: four floats a vertex; triangles;
  // levels, two bytes a triangle, or none; facing, of a polycube only: the rotation, by columns, that its axes have.
  setMesh(mesh) {
    const gl = this.gl, vertices = mesh.positions.length / 4, corners = mesh.triangles.length;
    this.mesh = null;
    this.setTexture("corners", mesh.triangles, corners, gl.R32UI, gl.RED_INTEGER, gl.UNSIGNED_INT);
    this.setTexture("levels", mesh.levels ?? new Uint8Array(2 * corners / 3), corners / 3, gl.RG8UI, gl.RG_INTEGER, gl.UNSIGNED_BYTE);
    for (const name of ["positions", "directions", "normals"]) {
      this.setTexture(name, mesh[name], vertices, gl.RGBA32F, gl.RGBA, gl.FLOAT);
    }
    this.mesh = mesh;
  }

  // Another shape in place of the mesh's own, with the same triangles.
  setShape(positions) {
    const normals = normalsOf(positions, this.mesh.triangles);
    this.mesh = {...this.mesh, positions, normals};
    for (const name of ["positions", "normals"]) {
      this.setTexture(name, this.mesh[name], positions.length / 4, this.gl.RGBA32F, this.gl.RGBA, this.gl.FLOAT);
    }
  }

  setColors(colors) {
    const gl = this.gl;
    this.textures.colors ??= gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.textures.colors);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB8, colors.length, 1, 0, gl.RGB, gl.UNSIGNED_BYTE, new Uint8Array(colors.flat()));
    for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, wrap, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
  }

  // Two views are above each other on a narrow canvas.
  get stacked() {
    return this.viewCount === 2 && this.canvas.clientWidth < 620;
  }

  // Where the views are, in CSS pixels from the canvas's top left: beside each other, or the shape above its map.
  views() {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight - (this.stacked ? this.bottom : 0);
    if (this.viewCount === 1) return [{x: 0, y: 0, width, height}];
    const second = this.stacked ? {x: 0, y: height / 2} : {x: width / 2, y: 0};
    const size = this.stacked ? {width, height: height / 2} : {width: width / 2, height};
    return [{x: 0, y: 0, ...size}, {...second, ...size}];
  }

  viewAt(x, y) {
    const [first] = this.views();
    return this.viewCount === 2 && (this.stacked ? y > first.height : x > first.width) ? 1 : 0;
  }

  // A place of the canvas in a view, from -1 to 1, y up.
  placeIn(view, x, y) {
    return [2 * (x - view.x) / view.width - 1, 1 - 2 * (y - view.y) / view.height];
  }

  morphOf(index) {
    return index === 1 ? 1 : this.look.morph;
  }

  // The unit sphere fills 84 % of the shorter side.
  lens(view) {
    const scale = 0.84 * this.camera.zoom * Math.sqrt(eyeDistance ** 2 - 1), shorter = Math.min(view.width, view.height);
    return [scale * shorter / view.width, scale * shorter / view.height];
  }

  useScene(program, index, lens, shift) {
    const gl = this.gl, place = name => gl.getUniformLocation(program, name);
    gl.useProgram(program);
    Object.keys(this.textures).forEach((name, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, this.textures[name]);
      gl.uniform1i(place(name), unit);
    });
    gl.uniformMatrix3fv(place("turn"), false, matrixOf(this.camera.turn));
    gl.uniform2fv(place("lens"), lens);
    gl.uniform2fv(place("shift"), shift);
    gl.uniform1f(place("morph"), this.morphOf(index));
    gl.uniform1i(place("polycube"), this.mesh.facing ? 1 : 0);
    gl.uniformMatrix3fv(place("facing"), false, this.mesh.facing ?? [1, 0, 0, 0, 1, 0, 0, 0, 1]);
  }

  draw() {
    const gl = this.gl, canvas = this.canvas, ratio = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.views().forEach((view, index) => {
      gl.viewport(view.x * ratio, height - (view.y + view.height) * ratio, view.width * ratio, view.height * ratio);
      gl.enable(gl.SCISSOR_TEST);
      gl.scissor(view.x * ratio, height - (view.y + view.height) * ratio, view.width * ratio, view.height * ratio);
      this.useScene(this.colorProgram, index, this.lens(view), this.camera.shifts[index]);
      const place = name => gl.getUniformLocation(this.colorProgram, name), {mode, coding, bounds, edges} = this.look;
      gl.uniform1i(place("mode"), modes.indexOf(mode));
      if (coding) gl.uniform4f(place("coding"), coding.zero, coding.span, coding.octaves, coding.none);
      if (bounds) gl.uniform2fv(place("bounds"), bounds);
      gl.uniform1i(place("edges"), edges ? 1 : 0);
      gl.drawArrays(gl.TRIANGLES, 0, this.mesh.triangles.length);
      gl.disable(gl.SCISSOR_TEST);
    });
  }

  // Where a point of a triangle, given by weights of its corners, is seen in a view: CSS pixels and distance.
  seenAt(index, triangle, weights) {
    const corners = this.cornersSeen(index, triangle);
    const clip = [0, 1, 3].map(k => corners.reduce((sum, corner, i) => sum + weights[i] * corner[k], 0));
    const view = this.views()[index];
    return {
      x: view.x + (0.5 + 0.5 * clip[0] / clip[2]) * view.width,
      y: view.y + (0.5 - 0.5 * clip[1] / clip[2]) * view.height,
      distance: clip[2],
    };
  }

  // A triangle's corners in clip coordinates x, y, -, w, as the vertex shader makes them.
  cornersSeen(index, triangle) {
    const m = matrixOf(this.camera.turn), morph = this.morphOf(index), {positions, directions} = this.mesh;
    const lens = this.lens(this.views()[index]), shift = this.camera.shifts[index];
    return [0, 1, 2].map(corner => {
      const at = 4 * this.mesh.triangles[3 * triangle + corner];
      const p = [0, 1, 2].map(k => (1 - morph) * positions[at + k] + morph * directions[at + k]);
      const [x, y, z] = [0, 1, 2].map(k => m[k] * p[0] + m[3 + k] * p[1] + m[6 + k] * p[2]);
      const w = eyeDistance - z;
      return [lens[0] * x + shift[0] * w, lens[1] * y + shift[1] * w, 0, w];
    });
  }

  // What is seen at a place of the canvas: view, triangle, weights of its corners, distance; null for nothing.
  pick(x, y, index = this.viewAt(x, y)) {
    const gl = this.gl, view = this.views()[index];
    const at = this.placeIn(view, x, y);
    const lens = this.lens(view), shift = this.camera.shifts[index];
    // The picture magnified until one pixel of it fills the target.
    const magnified = [view.width, view.height];
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.pickTarget);
    gl.viewport(0, 0, 1, 1);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.useScene(this.numberProgram, index, lens.map((value, k) => value * magnified[k]),
                  shift.map((value, k) => (value - at[k]) * magnified[k]));
    gl.drawArrays(gl.TRIANGLES, 0, this.mesh.triangles.length);
    const pixel = new Uint8Array(4);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const triangle = (pixel[0] | pixel[1] << 8 | pixel[2] << 16 | pixel[3] << 24) - 1;
    if (triangle < 0) return null;
    const corners = this.cornersSeen(index, triangle);
    const flat = corners.map(([cx, cy, , w]) => [cx / w - at[0], cy / w - at[1]]);
    const weights = [0, 1, 2].map(k => {
      const [a, b] = [flat[(k + 1) % 3], flat[(k + 2) % 3]];
      return Math.max(0, (a[0] * b[1] - a[1] * b[0]) * this.facing(flat)) / corners[k][3];
    });
    const sum = weights[0] + weights[1] + weights[2];
    const normalized = sum > 0 ? weights.map(weight => weight / sum) : [1 / 3, 1 / 3, 1 / 3];
    return {index, triangle, weights: normalized, distance: this.seenAt(index, triangle, normalized).distance};
  }

  facing([a, b, c]) {
    return Math.sign((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }

  // For tests: the fraction of a view that is drawn on and how many colors it has. Call right after draw.
  statistics(index) {
    const gl = this.gl, ratio = this.canvas.width / this.canvas.clientWidth, view = this.views()[index];
    const width = Math.floor(view.width * ratio), height = Math.floor(view.height * ratio);
    const pixels = new Uint8Array(4 * width * height), colors = new Set();
    gl.readPixels(view.x * ratio, this.canvas.height - (view.y + view.height) * ratio, width, height, gl.RGBA,
                  gl.UNSIGNED_BYTE, pixels);
    let drawn = 0;
    for (let i = 0; i < pixels.length; i += 4) {
      if (pixels[i + 3] === 0) continue;
      ++drawn;
      colors.add(pixels[i] << 16 | pixels[i + 1] << 8 | pixels[i + 2]);
    }
    return {drawn: drawn / (width * height), colors: colors.size};
  }
}
