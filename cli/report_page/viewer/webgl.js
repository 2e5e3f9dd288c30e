// What the viewers that draw with WebGL 2 share: the camera's projection, programs, views side by side, and the number of
// the triangle at a place.

import {matrixOf} from "./camera.js";

export const eyeDistance = 5;

// For vertex shaders: `place` is relative to the eye, `lens` and `shift` are the scale of the picture and the place of its
// center, from -1 to 1.
export const projection = `
vec4 projected(vec3 place, vec2 lens, vec2 shift) {
  float near = ${eyeDistance - 1.75}, far = ${eyeDistance + 1.75};
  return vec4(lens * place.xy - shift * place.z,
              (-place.z * (far + near) - 2.0 * far * near) / (far - near), -place.z);
}`;

// For fragment shaders: how much of a line there is on the sides of a triangle, where `weights` are 0; 0 where the
// triangle is too small for lines. `width`: from where to where a line fades, in pixels; `size`: the same of triangles.
export const edgeLines = `
float lineOfEdges(vec3 weights, vec2 width, vec2 size) {
  vec3 across = fwidth(weights);
  vec3 lines = 1.0 - smoothstep(width.x * across, width.y * across, weights);
  float fade = 1.0 - smoothstep(size.x, size.y, max(across.x, max(across.y, across.z)));
  return fade * max(lines.x, max(lines.y, lines.z));
}`;

// For fragment shaders: the color by which Views.numberAt reads the number of a triangle.
export const numberColor = `
vec4 colorOfNumber(uint triangle) {
  uint n = triangle + 1u;
  return vec4(n & 255u, n >> 8 & 255u, n >> 16 & 255u, n >> 24) / 255.0;
}`;

/** A canvas with views that one camera looks at. A class of it has views() and viewAt(x, y). */
export class Views {
  // Throws when the browser has no WebGL 2.
  constructor(canvas, camera) {
    Object.assign(this, {canvas, camera});
    // The picture is kept, so that it is also there when the page is printed and when it is saved.
    const gl = this.gl = canvas.getContext("webgl2", {antialias: true, preserveDrawingBuffer: true});
    if (!gl) throw new Error("no WebGL 2");
    gl.enable(gl.DEPTH_TEST);
    this.makePickTarget();
  }

  // `attributes`: names of the vertex shader's, in the order of their numbers.
  program(vertexText, fragmentText, attributes = []) {
    const gl = this.gl, program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertexText], [gl.FRAGMENT_SHADER, fragmentText]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    attributes.forEach((name, i) => gl.bindAttribLocation(program, i, name));
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

  // Colors in a row of a texture, which is made where there is none; returns it.
  setColorRow(texture, colors) {
    const gl = this.gl, row = texture ?? gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, row);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB8, colors.length, 1, 0, gl.RGB, gl.UNSIGNED_BYTE, new Uint8Array(colors.flat()));
    for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, wrap, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
    return row;
  }

  // A place of the canvas in a view, from -1 to 1, y up.
  placeIn(view, x, y) {
    return [2 * (x - view.x) / view.width - 1, 1 - 2 * (y - view.y) / view.height];
  }

  // Where clip coordinates x / w and y / w are in a view, in CSS pixels.
  pixelIn(view, x, y) {
    return {x: view.x + (0.5 + 0.5 * x) * view.width, y: view.y + (0.5 - 0.5 * y) * view.height};
  }

  // The unit sphere fills 84 % of the shorter side.
  lens(view) {
    const scale = 0.84 * this.camera.zoom * Math.sqrt(eyeDistance ** 2 - 1), shorter = Math.min(view.width, view.height);
    return [scale * shorter / view.width, scale * shorter / view.height];
  }

  // Sets what `projection` takes, and returns where the program's uniforms are.
  useCamera(program, lens, shift) {
    const gl = this.gl, place = name => gl.getUniformLocation(program, name);
    gl.useProgram(program);
    gl.uniformMatrix3fv(place("turn"), false, matrixOf(this.camera.turn));
    gl.uniform2fv(place("lens"), lens);
    gl.uniform2fv(place("shift"), shift);
    return place;
  }

  // A point of the frame in clip coordinates x, y and w, as the vertex shaders make them.
  seen(index, point) {
    const m = matrixOf(this.camera.turn), lens = this.lens(this.views()[index]), shift = this.camera.shifts[index];
    const [x, y, z] = [0, 1, 2].map(k => m[k] * point[0] + m[3 + k] * point[1] + m[6 + k] * point[2]), w = eyeDistance - z;
    return [lens[0] * x + shift[0] * w, lens[1] * y + shift[1] * w, w];
  }

  // Clears the canvas, in the size that it has on the page, and calls `draw` for each view with its place set.
  drawViews(draw) {
    const gl = this.gl, canvas = this.canvas, ratio = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.SCISSOR_TEST);
    this.views().forEach((view, index) => {
      const box = [view.x * ratio, height - (view.y + view.height) * ratio, view.width * ratio, view.height * ratio];
      gl.viewport(...box);
      gl.scissor(...box);
      draw(view, index);
    });
    gl.disable(gl.SCISSOR_TEST);
  }

  // The number of the triangle at a place (from -1 to 1) of a view, where `draw(lens, shift)` draws numbers; -1 for nothing.
  numberAt(index, view, place, draw) {
    const gl = this.gl, lens = this.lens(view), shift = this.camera.shifts[index];
    // The picture magnified until one pixel of it fills the target.
    const magnified = [view.width, view.height];
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.pickTarget);
    gl.viewport(0, 0, 1, 1);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    draw(lens.map((value, k) => value * magnified[k]), shift.map((value, k) => (value - place[k]) * magnified[k]));
    const pixel = new Uint8Array(4);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return (pixel[0] | pixel[1] << 8 | pixel[2] << 16 | pixel[3] << 24) - 1;
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
