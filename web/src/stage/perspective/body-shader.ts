import { HEIGHTS, JOINT } from "./figure";

/**
 * How bodies are drawn: one program for each kind, all agents at once.
 *
 * `place` is x, y, z and the heading; `attitude` is pitch and bank of a cone, or phase and reach of a figure: strides
 * walked, and how far a foot reaches forward as a share of the figure's height. `size` scales the body's geometry.
 */
const PLACED = /* glsl */ `
attribute vec4 place;
attribute vec2 attitude;
attribute vec3 tint;
uniform float size;
varying vec3 vTint;
varying vec3 vNormal;

vec2 turned(vec2 v, float angle) {
  float s = sin(angle), c = cos(angle);
  return vec2(v.x * c - v.y * s, v.x * s + v.y * c);
}

void set(vec3 corner, vec3 outward) {
  vec3 body = vec3(turned(corner.xy, place.w), corner.z) * size;
  vNormal = vec3(turned(outward.xy, place.w), outward.z);
  vTint = tint;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(body + place.xyz, 1.0);
}
`;

export const DISC_VERTEX = `${PLACED}
void main() {
  set(position, normal);
}
`;

export const CONE_VERTEX = `${PLACED}
/** Where the cone's axis is when it lies on the ground. */
uniform float axle;

vec3 flown(vec3 v) {
  vec3 banked = vec3(v.x, v.y * cos(attitude.y) + v.z * sin(attitude.y), v.z * cos(attitude.y) - v.y * sin(attitude.y));
  vec2 pitched = turned(banked.xz, attitude.x);
  return vec3(pitched.x, banked.y, pitched.y);
}

void main() {
  set(flown(position) + vec3(0.0, 0.0, axle), flown(normal));
}
`;

const decimal = (value: number) => value.toFixed(4);

export const FIGURE_VERTEX = `${PLACED}
/** Side and joint. */
attribute vec2 part;
const float TURN = 6.2831853;
const float HIP = ${decimal(HEIGHTS.hip)};
const float KNEE = ${decimal(HEIGHTS.knee)};
const float SHOULDER = ${decimal(HEIGHTS.shoulder)};
const float ELBOW = ${decimal(HEIGHTS.elbow)};

/** How far forward a foot is and how much its knee bends: on the ground it stays, then it swings through. */
vec2 footing(float stride, float reach) {
  float u = fract(stride + 0.25);
  if (u < 0.5) return vec2(reach * (1.0 - 4.0 * u), 0.0);
  return vec2(-reach * cos(TURN * (u - 0.5)), sin(TURN * (u - 0.5)));
}

void bend(inout vec3 corner, inout vec3 outward, float height, float angle) {
  corner.z -= height;
  corner.xz = turned(corner.xz, angle);
  corner.z += height;
  outward.xz = turned(outward.xz, angle);
}

void main() {
  vec3 corner = position;
  vec3 outward = normal;
  float reach = attitude.y;
  float stride = attitude.x + (part.x < 0.0 ? 0.5 : 0.0);
  vec2 foot = footing(stride, reach);
  float knee = 5.0 * reach * foot.y;
  if (part.y == ${decimal(JOINT.shin)}) bend(corner, outward, KNEE, -knee);
  if (part.y == ${decimal(JOINT.thigh)} || part.y == ${decimal(JOINT.shin)}) {
    bend(corner, outward, HIP, asin(foot.x / HIP) + 0.5 * knee);
  }
  if (part.y == ${decimal(JOINT.forearm)}) bend(corner, outward, ELBOW, 0.15 + 2.0 * reach);
  if (part.y >= ${decimal(JOINT.upperArm)}) bend(corner, outward, SHOULDER, 2.2 * reach * sin(TURN * stride));
  if (part.y == ${decimal(JOINT.trunk)}) bend(corner, outward, HIP, -0.3 * reach);
  // The leg that stands carries the hip along an arc.
  vec2 left = footing(attitude.x, reach);
  float stance = left.y > 0.0 ? footing(attitude.x + 0.5, reach).x : left.x;
  corner.z -= HIP - sqrt(HIP * HIP - stance * stance);
  set(corner, outward);
}
`;

/** Matte, lit from the upper left behind the audience; what turns away is shaded, never black. */
export const BODY_FRAGMENT = /* glsl */ `
uniform float shade;
varying vec3 vTint;
varying vec3 vNormal;
const vec3 LIGHT = vec3(-0.36, -0.48, 0.8);

void main() {
  float lit = 0.5 + 0.5 * dot(normalize(vNormal), LIGHT);
  gl_FragColor = vec4(mix(vTint * shade, mix(vTint, vec3(1.0), 0.1), lit), 1.0);
}
`;
