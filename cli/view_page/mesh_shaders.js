// The shaders of the page of meshes. Every corner of a triangle has its own attributes, so that triangles have their own
// colors and edges.

import {edgeLines, eyeDistance, numberColor, projection} from "./viewer/webgl.js";

export const meshVertexShader = `#version 300 es
precision highp float;
in vec3 position, normal;
in float value, flags;
uniform mat3 turn;
uniform vec2 lens, shift;  // of the picture: scale and place of its center, from -1 to 1
flat out uint triangle;
out vec3 place, seenNormal, weights, inFrame;
out float shownValue;
flat out float faceFlags;
${projection}

void main() {
  int corner = gl_VertexID % 3, bits = int(flags);
  triangle = uint(gl_VertexID / 3);
  faceFlags = flags;
  // Sides that are no edges of the mesh have a weight that is never small.
  weights = vec3(corner == 0, corner == 1, corner == 2) + vec3(bits & 1, bits >> 1 & 1, bits >> 2 & 1);
  seenNormal = turn * normal;
  inFrame = position;
  shownValue = value;
  place = turn * position - vec3(0, 0, ${eyeDistance});
  gl_Position = projected(place, lens, shift);
}`;

export const meshColorShader = `#version 300 es
precision highp float;
flat in uint triangle;
flat in float faceFlags;
in vec3 place, seenNormal, weights, inFrame;
in float shownValue;
uniform sampler2D colors;
uniform int coloring;  // 0: base, 1: a scale, 2: categories
uniform vec2 range;
uniform vec3 base, inverted, none;
uniform bool edges, ghost, markInverted;
uniform vec4 plane;  // what is beyond it is not drawn; 0: everything is
out vec4 color;
${edgeLines}

void main() {
  if (dot(plane.xyz, inFrame) > plane.w) discard;
  vec3 facet = normalize(cross(dFdx(place), dFdy(place)));
  vec3 n = dot(seenNormal, seenNormal) > 0.1 ? normalize(seenNormal) : facet;
  if (!gl_FrontFacing) n = -n;
  if (!(dot(n, facet) > 0.75)) n = facet;  // creases stay sharp
  vec3 tint = base;
  if (coloring == 1) {
    float at = (shownValue - range.x) / (range.y - range.x);
    tint = shownValue != shownValue ? none : markInverted && shownValue <= 0.0 ? inverted : texture(colors, vec2(clamp(at, 0.002, 0.998), 0.5)).rgb;
  } else if (coloring == 2) {
    tint = texelFetch(colors, ivec2(int(shownValue + 0.5) % 8, 0), 0).rgb;
  }
  // The inside of a surface, as seen through its holes and where it is cut.
  if (!gl_FrontFacing && !ghost) tint = mix(tint, vec3(0.55, 0.42, 0.5), 0.6);
  vec3 towards = normalize(-place);
  float rim = 1.0 - max(0.0, dot(n, towards));
  if (ghost) {
    color = vec4(base, 1.0) * (0.06 + 0.42 * rim * rim);
    return;
  }
  vec3 lamp = normalize(vec3(-0.4, 0.65, 0.65));
  float key = max(0.0, dot(n, lamp)), fill = 0.5 + 0.5 * dot(n, vec3(0.25, 0.9, -0.35));
  vec3 lit = tint * (0.62 + 0.32 * key + 0.14 * fill) * (1.0 - 0.22 * rim * rim * rim);
  lit += 0.05 * pow(max(0.0, dot(n, normalize(lamp + towards))), 40.0);
  if (edges) lit = mix(lit, 0.18 * lit, 0.8 * lineOfEdges(weights, vec2(0.4, 1.3), vec2(0.08, 0.6)));
  color = vec4(lit, 1.0);
}`;

export const meshNumberShader = `#version 300 es
precision highp float;
precision highp int;
flat in uint triangle;
in vec3 inFrame;
uniform vec4 plane;
out vec4 color;
${numberColor}

void main() {
  if (dot(plane.xyz, inFrame) > plane.w) discard;
  color = colorOfNumber(triangle);
}`;
