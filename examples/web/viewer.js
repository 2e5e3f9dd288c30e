// Shows a surface on its way to another one with the same triangles, in WebGL 2. Nothing here knows of files or workers.

const vertexShader = `#version 300 es
in vec3 from, to, fromNormal, toNormal;
uniform mat3 turn;
uniform float share, distance, aspect;
out vec3 normal, place, seen;
void main() {
  vec3 p = turn * mix(from, to, share);
  normal = turn * mix(fromNormal, toNormal, share);
  place = to;
  seen = p - vec3(0, 0, distance);
  gl_Position = vec4(p.x / aspect * 2.2, p.y * 2.2, (distance - p.z) * 1.02 - 0.6, distance - p.z);
}`;

const fragmentShader = `#version 300 es
precision highp float;
in vec3 normal, place, seen;
uniform int pattern;   // 0 none, 1 of a sphere, 2 of a polycube
uniform float share, flatness, squares;
out vec4 color;

float checker(vec2 at, vec2 width) {
  vec2 blurred = clamp((abs(fract(at * 0.5) - 0.5) * 2.0 - 0.5) / width * 1.2, -0.5, 0.5);
  return 0.5 - 2.0 * blurred.x * blurred.y;
}

void main() {
  vec3 n = normalize(normal);
  if (flatness > 0.0) {
    vec3 flatNormal = normalize(cross(dFdx(seen), dFdy(seen)));
    n = normalize(mix(n, flatNormal, flatness));
  }
  vec3 one = vec3(0.93, 0.90, 0.83), other = vec3(0.09, 0.47, 0.53);
  vec3 base = mix(vec3(0.80, 0.82, 0.83), one, 0.5);
  if (pattern > 0) {
    vec3 q = place;
    vec3 across = pattern == 1 ? q : cross(dFdx(q), dFdy(q));
    vec3 size = abs(across);
    int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    vec3 change = fwidth(q);
    vec2 at = axis == 0 ? q.yz : axis == 1 ? q.zx : q.xy;
    vec2 width = axis == 0 ? change.yz : axis == 1 ? change.zx : change.xy;
    if (pattern == 1) {
      at = atan(at / size[axis]) * 1.2732395;
      width *= 1.5;
    }
    base = mix(one, other, checker(at * squares, max(width * squares, 1e-4)));
    // Sides of the cube apart from each other.
    base *= axis == 0 ? vec3(1.0, 0.97, 0.94) : axis == 1 ? vec3(0.97, 1.0, 0.97) : vec3(1.0);
  }
  vec3 view = normalize(-seen);
  if (dot(n, view) < 0.0) n = -n;
  vec3 key = normalize(vec3(0.45, 0.75, 0.7)), fill = normalize(vec3(-0.8, 0.1, 0.4));
  float light = 0.34 + 0.12 * n.y + 0.56 * max(dot(n, key), 0.0) + 0.26 * max(dot(n, fill), 0.0);
  float shine = pow(max(dot(n, normalize(key + view)), 0.0), 48.0) * 0.22;
  float rim = pow(1.0 - max(dot(n, view), 0.0), 3.0) * 0.18;
  color = vec4(pow(clamp(base * light + shine + rim, 0.0, 1.0), vec3(0.92)), 1.0);
}`;

/** Of each vertex the sum of the normals of its triangles, each as long as its triangle is large. */
export function smoothNormals(positions, triangles) {
  const normals = new Float32Array(positions.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const [ux, uy, uz] = [positions[b] - positions[a], positions[b + 1] - positions[a + 1], positions[b + 2] - positions[a + 2]];
    const [vx, vy, vz] = [positions[c] - positions[a], positions[c + 1] - positions[a + 1], positions[c + 2] - positions[a + 2]];
    const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    for (const v of [a, b, c]) for (let k = 0; k < 3; ++k) normals[v + k] += n[k];
  }
  for (let v = 0; v < normals.length; v += 3) {
    const length = Math.hypot(normals[v], normals[v + 1], normals[v + 2]) || 1;
    for (let k = 0; k < 3; ++k) normals[v + k] /= length;
  }
  return normals;
}

export class Viewer {
  share = 0;
  pattern = 1;
  #canvas;
  #gl;
  #program;
  #count = 0;
  #targetKind = 1;
  #turn = [1, 0, 0, 0, 1, 0, 0, 0, 1];
  #distance = 3.5;
  #wanted = false;

  constructor(canvas) {
    this.#canvas = canvas;
    const gl = canvas.getContext('webgl2', { antialias: true, alpha: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error('this browser has no WebGL 2');
    this.#gl = gl;
    this.#program = this.#linked();
    gl.useProgram(this.#program);
    gl.enable(gl.DEPTH_TEST);
    this.reset();
    this.#listen();
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  /** As at the beginning. */
  reset() {
    this.#turn = [1, 0, 0, 0, 1, 0, 0, 0, 1];
    this.#distance = 3.5;
    this.#rotate(0.45, 0.25);
  }

  #linked() {
    const gl = this.#gl;
    const program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
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

  /** `kind` is 1 for spheres and 2 for polycubes. */
  show(from, to, triangles, kind) {
    const gl = this.#gl;
    const arrays = {
      from: Float32Array.from(from), to: Float32Array.from(to),
      fromNormal: smoothNormals(from, triangles), toNormal: smoothNormals(to, triangles),
    };
    for (const [name, values] of Object.entries(arrays)) {
      const place = gl.getAttribLocation(this.#program, name);
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 0, 0);
    }
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STATIC_DRAW);
    this.#count = triangles.length;
    this.#targetKind = kind;
    this.draw();
  }

  #rotate(aboutY, aboutX) {
    const [c, s, d, e] = [Math.cos(aboutY), Math.sin(aboutY), Math.cos(aboutX), Math.sin(aboutX)];
    // Columns of the turn about the screen's axes, times what there is.
    const step = [c, s * e, -s * d, 0, d, e, s, -c * e, c * d];
    const old = this.#turn;
    this.#turn = old.map((_, i) => {
      const [column, row] = [Math.floor(i / 3), i % 3];
      return step[row] * old[3 * column] + step[3 + row] * old[3 * column + 1] + step[6 + row] * old[3 * column + 2];
    });
    this.draw();
  }

  #zoom(factor) {
    this.#distance = Math.min(12, Math.max(2.2, this.#distance * factor));
    this.draw();
  }

  #listen() {
    const canvas = this.#canvas;
    canvas.addEventListener('pointerdown', (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener('pointermove', (event) => {
      if (canvas.hasPointerCapture(event.pointerId)) this.#rotate(event.movementX * 0.01, event.movementY * 0.01);
    });
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.#zoom(Math.exp(event.deltaY * 0.001));
    }, { passive: false });
    canvas.addEventListener('keydown', (event) => {
      const step = 0.12;
      const moves = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] };
      if (event.key in moves) this.#rotate(...moves[event.key]);
      else if (event.key === '+' || event.key === '=') this.#zoom(0.9);
      else if (event.key === '-') this.#zoom(1.1);
      else return;
      event.preventDefault();
    });
  }

  /** Draws soon; as often as requested. */
  draw() {
    if (this.#wanted) return;
    this.#wanted = true;
    requestAnimationFrame(() => {
      this.#wanted = false;
      this.#drawNow();
    });
  }

  #drawNow() {
    const gl = this.#gl;
    const canvas = this.#canvas;
    const scale = Math.min(devicePixelRatio, 2);
    canvas.width = Math.max(1, Math.round(canvas.clientWidth * scale));
    canvas.height = Math.max(1, Math.round(canvas.clientHeight * scale));
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    if (this.#count === 0) return;
    const place = (name) => gl.getUniformLocation(this.#program, name);
    const wide = canvas.width / canvas.height;
    gl.uniformMatrix3fv(place('turn'), false, this.#turn);
    gl.uniform1f(place('share'), this.share);
    gl.uniform1f(place('distance'), wide < 1 ? this.#distance / wide : this.#distance);
    gl.uniform1f(place('aspect'), wide);
    gl.uniform1f(place('flatness'), this.#targetKind === 2 ? this.share : 0);
    gl.uniform1f(place('squares'), this.#targetKind === 2 ? 10 : 5);
    gl.uniform1i(place('pattern'), this.pattern ? this.#targetKind : 0);
    gl.drawElements(gl.TRIANGLES, this.#count, gl.UNSIGNED_INT, 0);
  }
}
