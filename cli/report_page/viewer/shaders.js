// The shaders of the viewer. Meshes are in textures that the vertex shader reads by number, so each triangle has its own
// color without a copy of its vertices.

import {edgeLines, eyeDistance, numberColor, projection} from "./webgl.js";

export const textureWidth = 4096;
export const modes = ["quasiConformal", "area", "checker", "plain"];

export const vertexShader = `#version 300 es
precision highp float;
precision highp int;
precision highp usampler2D;
uniform usampler2D corners, levels;
uniform highp sampler2D positions, directions, normals;
uniform mat3 turn;
uniform vec2 lens, shift;  // of the picture: scale and place of its center, from -1 to 1
uniform float morph;
uniform bool polycube;  // the map is one to a polycube, and directions are positions on it
flat out uint triangle;
flat out uvec2 level;
out vec3 place, normal, direction, weights;
${projection}

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
  gl_Position = projected(place, lens, shift);
}`;

export const colorShader = `#version 300 es
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
${edgeLines}

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
  if (!(dot(n, facet) > 0.8)) n = facet;  // creases stay sharp
  if (polycube) n = normalize(mix(n, facet, smoothstep(0.0, 0.2, morph)));
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
  if (edges) lit = mix(lit, 0.2 * lit, 0.75 * lineOfEdges(weights, vec2(0.3, 1.1), vec2(0.05, 0.55)));
  color = vec4(lit, 1.0);
}`;

export const numberShader = `#version 300 es
precision highp float;
precision highp int;
flat in uint triangle;
out vec4 color;
${numberColor}

void main() { color = colorOfNumber(triangle); }`;
