// Draws shape and map side by side with WebGL 2. Meshes are in textures that the vertex shader reads by number,
// so each triangle has its own color without a copy of its vertices.

const textureWidth = 4096;
const eyeDistance = 5;
const legendHeight = 56;  // in CSS pixels, kept free below two views above each other
const modes = ["quasiConformal", "area", "checker", "plain"];

const vertexShader = `#version 300 es
precision highp float;
precision highp int;
precision highp usampler2D;
uniform usampler2D corners, levels;
uniform highp sampler2D positions, directions, normals;
uniform mat3 turn;
uniform vec2 lens, shift;  // of the picture: scale and place of its centre, from -1 to 1
uniform float morph;
uniform bool polycube;  // the map is one to a polycube, and directions are positions on it
flat out uint triangle;
flat out uvec2 level;
out vec3 place, normal, direction, weights;

ivec2 cell(int i) { return ivec2(i % ${textureWidth}, i / ${textureWidth}); }

void main() {
  int t = gl_VertexID / 3, corner = gl_VertexID % 3;
  int v = int(texelFetch(corners, cell(gl_VertexID), 0).r);
  triangle = uint(t);
  level = texelFetch(levels, cell(t), 0).rg;
  weights = vec3(corner == 0, corner == 1, corner == 2);
  direction = texelFetch(directions, cell(v), 0).xyz;
  normal = texelFetch(normals, cell(v), 0).xyz;
  normal = turn * (polycube ? normal : mix(normal, direction, morph));
  place = turn * mix(texelFetch(positions, cell(v), 0).xyz, direction, morph) - vec3(0, 0, ${eyeDistance});
  float near = ${eyeDistance - 1.75}, far = ${eyeDistance + 1.75};
  gl_Position = vec4(lens * place.xy - shift * place.z,
                     (-place.z * (far + near) - 2.0 * far * near) / (far - near), -place.z);
}`;

const colorShader = `#version 300 es
precision highp float;
precision highp int;
flat in uvec2 level;
in vec3 place, normal, direction, weights;
uniform sampler2D colors;
uniform int mode;
uniform vec4 coding;  // of values as levels: zero, span, octaves, none (packed_mesh.h)
uniform vec2 bounds;  // of the color scale, in octaves
uniform bool edges, polycube;
uniform float morph;
uniform mat3 facing;  // that turned the polycube
out vec4 color;

const vec3 tints[6] = vec3[](vec3(0.80, 0.33, 0.24), vec3(0.18, 0.55, 0.53), vec3(0.87, 0.62, 0.18),
                             vec3(0.36, 0.38, 0.70), vec3(0.25, 0.48, 0.75), vec3(0.58, 0.36, 0.60));

vec3 fields(vec2 at, float blur, vec3 tint) {
  vec2 wave = cos(3.14159265 * at) / (3.14159265 * blur);
  vec2 sides = 2.0 * clamp(wave, -0.5, 0.5);
  float field = 0.5 + 0.5 * sides.x * sides.y * (1.0 - smoothstep(0.6, 1.0, blur));
  return mix(tint, vec3(0.97, 0.96, 0.93), field);
}

// Fields along the polycube's axes, tinted by where its faces look.
vec3 checkerOnFaces(vec3 d, bool front) {
  vec3 at = d * facing, across = cross(dFdx(at), dFdy(at)) * (front ? 1.0 : -1.0), a = abs(across);
  float blur = clamp(12.0 * length(fwidth(at)), 0.02, 1.0);
  if (a.x > a.y && a.x > a.z) return fields(12.0 * at.yz + 0.5, blur, tints[across.x > 0.0 ? 0 : 1]);
  if (a.y > a.z) return fields(12.0 * at.zx + 0.5, blur, tints[across.y > 0.0 ? 2 : 3]);
  return fields(12.0 * at.xy + 0.5, blur, tints[across.z > 0.0 ? 4 : 5]);
}

// Eight by eight fields on each face of the cube round the sphere, tinted by face. The cosines are even, so that fields
// go on across the cube's edges.
vec3 checker(vec3 d) {
  vec3 a = abs(d);
  vec2 onFace = a.x > a.y && a.x > a.z ? d.yz / a.x : a.y > a.z ? d.zx / a.y : d.xy / a.z;
  vec3 tint = a.x > a.y && a.x > a.z ? tints[d.x > 0.0 ? 0 : 1] : a.y > a.z ? tints[d.y > 0.0 ? 2 : 3]
                                                                        : tints[d.z > 0.0 ? 4 : 5];
  return fields(atan(onFace) * (16.0 / 3.14159265), clamp(6.0 * length(fwidth(d)), 0.02, 1.0), tint);
}

void main() {
  vec3 facet = normalize(cross(dFdx(place), dFdy(place)));
  vec3 n = normalize(normal);
  if (!gl_FrontFacing) n = -n;
  if (!(dot(n, facet) > 0.8) || (polycube && morph > 0.0)) n = facet;  // creases stay sharp
  vec3 base = vec3(0.80, 0.81, 0.83);
  if (mode < 2) {
    float value = float(mode == 0 ? level.x : level.y);
    float part = (value - coding.x) / coding.y;
    float at = (coding.z * part * abs(part) - bounds.x) / (bounds.y - bounds.x);
    base = value == coding.w ? vec3(0.5) : texture(colors, vec2(clamp(at, 0.0, 1.0), 0.5)).rgb;
  } else if (mode == 2) {
    base = polycube ? checkerOnFaces(direction, gl_FrontFacing) : checker(normalize(direction));
  }
  vec3 towards = normalize(-place);
  float key = max(0.0, dot(n, normalize(vec3(-0.4, 0.65, 0.65))));
  float fill = 0.5 + 0.5 * dot(n, vec3(0.25, 0.9, -0.35));
  float rim = pow(1.0 - max(0.0, dot(n, towards)), 3.0);
  vec3 lit = base * (0.64 + 0.30 * key + 0.14 * fill) * (1.0 - 0.22 * rim);
  lit += 0.07 * pow(max(0.0, dot(n, normalize(normalize(vec3(-0.4, 0.65, 0.65)) + towards))), 40.0);
  if (edges) {
    vec3 across = fwidth(weights);
    vec3 lines = 1.0 - smoothstep(0.3 * across, 1.1 * across, weights);
    float fade = 1.0 - smoothstep(0.05, 0.55, max(across.x, max(across.y, across.z)));
    lit = mix(lit, 0.2 * lit, 0.75 * fade * max(lines.x, max(lines.y, lines.z)));
  }
  color = vec4(lit, 1.0);
}`;

const numberShader = `#version 300 es
precision highp float;
precision highp int;
flat in uint triangle;
out vec4 color;
void main() {
  uint n = triangle + 1u;
  color = vec4(n & 255u, n >> 8 & 255u, n >> 16 & 255u, n >> 24) / 255.0;
}`;

// Rotation matrix, by columns, of a unit quaternion x, y, z, w.
function matrixOf([x, y, z, w]) {
  return [
    1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w),
    2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w),
    2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y),
  ];
}

function product([ax, ay, az, aw], [bx, by, bz, bw]) {
  const q = [aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
             aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz];
  const length = Math.hypot(...q);
  return q.map(value => value / length);
}

function rotation(axis, angle) {
  const sine = Math.sin(angle / 2) / (Math.hypot(...axis) || 1);
  return [...axis.map(value => value * sine), Math.cos(angle / 2)];
}

class Viewer {
  // Throws when the browser has no WebGL 2.
  constructor(canvas) {
    this.canvas = canvas;
    const gl = this.gl = canvas.getContext("webgl2", {antialias: true, alpha: true, premultipliedAlpha: true});
    if (!gl) throw new Error("no WebGL 2");
    this.colorProgram = this.program(vertexShader, colorShader);
    this.numberProgram = this.program(vertexShader, numberShader);
    this.textures = {};
    this.vertexArray = gl.createVertexArray();
    gl.bindVertexArray(this.vertexArray);
    gl.enable(gl.DEPTH_TEST);
    this.makePickTarget();
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

  setMesh(mesh) {
    const gl = this.gl, vertices = mesh.positions.length / 4, corners = mesh.triangles.length;
    this.mesh = mesh;
    this.setTexture("corners", mesh.triangles, corners, gl.R32UI, gl.RED_INTEGER, gl.UNSIGNED_INT);
    this.setTexture("levels", mesh.levels, corners / 3, gl.RG8UI, gl.RG_INTEGER, gl.UNSIGNED_BYTE);
    for (const name of ["positions", "directions", "normals"]) {
      this.setTexture(name, mesh[name], vertices, gl.RGBA32F, gl.RGBA, gl.FLOAT);
    }
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
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB8, 256, 1, 0, gl.RGB, gl.UNSIGNED_BYTE, new Uint8Array(colors.flat()));
    for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, wrap, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
  }

  // Where the two views are, in CSS pixels from the canvas's top left: beside each other, or the shape above the sphere.
  views() {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight - (this.stacked ? legendHeight : 0);
    const second = this.stacked ? {x: 0, y: height / 2} : {x: width / 2, y: 0};
    const size = this.stacked ? {width, height: height / 2} : {width: width / 2, height};
    return [{x: 0, y: 0, ...size}, {...second, ...size}];
  }

  viewAt(x, y) {
    return (this.stacked ? y > (this.canvas.clientHeight - legendHeight) / 2 : x > this.canvas.clientWidth / 2) ? 1 : 0;
  }

  // The unit sphere fills 84 % of the shorter side.
  lens(view, zoom) {
    const scale = 0.84 * zoom * Math.sqrt(eyeDistance ** 2 - 1), shorter = Math.min(view.width, view.height);
    return [scale * shorter / view.width, scale * shorter / view.height];
  }

  useScene(program, state, index, lens, shift) {
    const gl = this.gl, place = name => gl.getUniformLocation(program, name);
    gl.useProgram(program);
    Object.keys(this.textures).forEach((name, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, this.textures[name]);
      gl.uniform1i(place(name), unit);
    });
    gl.uniformMatrix3fv(place("turn"), false, matrixOf(state.turn));
    gl.uniform2fv(place("lens"), lens);
    gl.uniform2fv(place("shift"), shift);
    gl.uniform1f(place("morph"), index === 1 ? 1 : state.morph);
    gl.uniform1i(place("polycube"), this.mesh.facing ? 1 : 0);
    gl.uniformMatrix3fv(place("facing"), false, this.mesh.facing ?? [1, 0, 0, 0, 1, 0, 0, 0, 1]);
  }

  // state: turn, zoom, shifts (two), morph, mode, coding and bounds of the quantity shown, edges.
  draw(state) {
    const gl = this.gl, canvas = this.canvas, ratio = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.views().forEach((view, index) => {
      gl.viewport(view.x * ratio, height - (view.y + view.height) * ratio, view.width * ratio, view.height * ratio);
      gl.enable(gl.SCISSOR_TEST);
      gl.scissor(view.x * ratio, height - (view.y + view.height) * ratio, view.width * ratio, view.height * ratio);
      this.useScene(this.colorProgram, state, index, this.lens(view, state.zoom), state.shifts[index]);
      const place = name => gl.getUniformLocation(this.colorProgram, name), {zero, span, octaves, none} = state.coding;
      gl.uniform1i(place("mode"), modes.indexOf(state.mode));
      gl.uniform4f(place("coding"), zero, span, octaves, none);
      gl.uniform2fv(place("bounds"), state.bounds);
      gl.uniform1i(place("edges"), state.edges ? 1 : 0);
      gl.drawArrays(gl.TRIANGLES, 0, this.mesh.triangles.length);
      gl.disable(gl.SCISSOR_TEST);
    });
  }

  // Where a point of a triangle, given by weights of its corners, is seen in a view: CSS pixels and distance.
  seenAt(state, index, triangle, weights) {
    const corners = this.cornersSeen(state, index, triangle);
    const clip = [0, 1, 3].map(k => corners.reduce((sum, corner, i) => sum + weights[i] * corner[k], 0));
    const view = this.views()[index];
    return {
      x: view.x + (0.5 + 0.5 * clip[0] / clip[2]) * view.width,
      y: view.y + (0.5 - 0.5 * clip[1] / clip[2]) * view.height,
      distance: clip[2],
    };
  }

  // A triangle's corners in clip coordinates x, y, -, w, as the vertex shader makes them.
  cornersSeen(state, index, triangle) {
    const m = matrixOf(state.turn), morph = index === 1 ? 1 : state.morph, {positions, directions} = this.mesh;
    const lens = this.lens(this.views()[index], state.zoom), shift = state.shifts[index];
    return [0, 1, 2].map(corner => {
      const at = 4 * this.mesh.triangles[3 * triangle + corner];
      const p = [0, 1, 2].map(k => (1 - morph) * positions[at + k] + morph * directions[at + k]);
      const [x, y, z] = [0, 1, 2].map(k => m[k] * p[0] + m[3 + k] * p[1] + m[6 + k] * p[2]);
      const w = eyeDistance - z;
      return [lens[0] * x + shift[0] * w, lens[1] * y + shift[1] * w, 0, w];
    });
  }

  // What is seen at a place of the canvas: view, triangle, weights of its corners, distance; null for nothing.
  pick(state, x, y, index = this.viewAt(x, y)) {
    const gl = this.gl, view = this.views()[index];
    const at = [2 * (x - view.x) / view.width - 1, 1 - 2 * (y - view.y) / view.height];
    const lens = this.lens(view, state.zoom), shift = state.shifts[index];
    // The picture magnified until one pixel of it fills the target.
    const magnified = [view.width, view.height];
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.pickTarget);
    gl.viewport(0, 0, 1, 1);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.useScene(this.numberProgram, state, index, lens.map((value, k) => value * magnified[k]),
                  shift.map((value, k) => (value - at[k]) * magnified[k]));
    gl.drawArrays(gl.TRIANGLES, 0, this.mesh.triangles.length);
    const pixel = new Uint8Array(4);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const triangle = (pixel[0] | pixel[1] << 8 | pixel[2] << 16 | pixel[3] << 24) - 1;
    if (triangle < 0) return null;
    const corners = this.cornersSeen(state, index, triangle);
    const flat = corners.map(([cx, cy, , w]) => [cx / w - at[0], cy / w - at[1]]);
    const weights = [0, 1, 2].map(k => {
      const [a, b] = [flat[(k + 1) % 3], flat[(k + 2) % 3]];
      return Math.max(0, (a[0] * b[1] - a[1] * b[0]) * this.facing(flat)) / corners[k][3];
    });
    const sum = weights[0] + weights[1] + weights[2];
    const normalized = sum > 0 ? weights.map(weight => weight / sum) : [1 / 3, 1 / 3, 1 / 3];
    return {index, triangle, weights: normalized, distance: this.seenAt(state, index, triangle, normalized).distance};
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
