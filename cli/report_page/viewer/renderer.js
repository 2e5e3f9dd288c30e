// Draws a shape and its map with WebGL 2: in one view as a morph, or in two side by side; and finds what is at a place.

import {colorShader, modes, numberShader, textureWidth, vertexShader} from "./shaders.js";
import {normalsOf} from "./surface.js";
import {Views} from "./webgl.js";

export class Renderer extends Views {
  // `look`: morph, from 0 for the shape to 1 for its map; mode, one of modes; edges; for the modes of quantities also
  // coding and bounds. With two views the second one is of the map. `bottom`: height in CSS pixels that two views above
  // each other leave free. Throws when the browser has no WebGL 2.
  constructor(canvas, camera, look, {views = 1, bottom = 0} = {}) {
    super(canvas, camera);
    Object.assign(this, {look, bottom, viewCount: views, mesh: null});
    this.colorProgram = this.program(vertexShader, colorShader);
    this.numberProgram = this.program(vertexShader, numberShader);
    this.textures = {};
    this.vertexArray = this.gl.createVertexArray();
    this.gl.bindVertexArray(this.vertexArray);
    this.setColors([[128, 128, 128]]);
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
    this.textures.colors = this.setColorRow(this.textures.colors, colors);
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

  morphOf(index) {
    return index === 1 ? 1 : this.look.morph;
  }

  useScene(program, index, lens, shift) {
    const gl = this.gl, place = this.useCamera(program, lens, shift);
    Object.keys(this.textures).forEach((name, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, this.textures[name]);
      gl.uniform1i(place(name), unit);
    });
    gl.uniform1f(place("morph"), this.morphOf(index));
    gl.uniform1i(place("polycube"), this.mesh.facing ? 1 : 0);
    gl.uniformMatrix3fv(place("facing"), false, this.mesh.facing ?? [1, 0, 0, 0, 1, 0, 0, 0, 1]);
    return place;
  }

  draw() {
    const gl = this.gl, {mode, coding, bounds, edges} = this.look;
    this.drawViews((view, index) => {
      const place = this.useScene(this.colorProgram, index, this.lens(view), this.camera.shifts[index]);
      gl.uniform1i(place("mode"), modes.indexOf(mode));
      if (coding) gl.uniform4f(place("coding"), coding.zero, coding.span, coding.octaves, coding.none);
      if (bounds) gl.uniform2fv(place("bounds"), bounds);
      gl.uniform1i(place("edges"), edges ? 1 : 0);
      gl.drawArrays(gl.TRIANGLES, 0, this.mesh.triangles.length);
    });
  }

  // Where a point of a triangle, given by weights of its corners, is seen in a view: CSS pixels and distance.
  seenAt(index, triangle, weights) {
    const corners = this.cornersSeen(index, triangle);
    const [x, y, distance] = [0, 1, 2].map(k => corners.reduce((sum, corner, i) => sum + weights[i] * corner[k], 0));
    return {...this.pixelIn(this.views()[index], x / distance, y / distance), distance};
  }

  // A triangle's corners in clip coordinates x, y and w.
  cornersSeen(index, triangle) {
    const morph = this.morphOf(index), {positions, directions, triangles} = this.mesh;
    return [0, 1, 2].map(corner => {
      const at = 4 * triangles[3 * triangle + corner];
      return this.seen(index, [0, 1, 2].map(k => (1 - morph) * positions[at + k] + morph * directions[at + k]));
    });
  }

  // What is seen at a place of the canvas: view, triangle, weights of its corners, distance; null for nothing.
  pick(x, y, index = this.viewAt(x, y)) {
    const view = this.views()[index], at = this.placeIn(view, x, y);
    const triangle = this.numberAt(index, view, at, (lens, shift) => {
      this.useScene(this.numberProgram, index, lens, shift);
      this.gl.drawArrays(this.gl.TRIANGLES, 0, this.mesh.triangles.length);
    });
    if (triangle < 0) return null;
    const corners = this.cornersSeen(index, triangle);
    const flat = corners.map(([cx, cy, w]) => [cx / w - at[0], cy / w - at[1]]);
    const weights = [0, 1, 2].map(k => {
      const [a, b] = [flat[(k + 1) % 3], flat[(k + 2) % 3]];
      return Math.max(0, (a[0] * b[1] - a[1] * b[0]) * this.facing(flat)) / corners[k][2];
    });
    const sum = weights[0] + weights[1] + weights[2];
    const normalized = sum > 0 ? weights.map(weight => weight / sum) : [1 / 3, 1 / 3, 1 / 3];
    return {index, triangle, weights: normalized, distance: this.seenAt(index, triangle, normalized).distance};
  }

  facing([a, b, c]) {
    return Math.sign((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }
}
