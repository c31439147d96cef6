import { HEIGHTS, LIMB } from "./figure";

/**
 * How bodies are drawn: all agents of a kind at once. Turns come as cosines and sines, so that a corner costs little.
 *
 * `place` is where an agent is, `ahead` and `left` are its directions; `size` scales the body's geometry, and `share` the agent's.
 */
const PLACED = /* glsl */ `
attribute vec3 place;
attribute vec3 ahead;
attribute vec3 left;
attribute vec3 tint;
attribute float presence;
attribute float share;
uniform float size;
/** Where the body's own origin is above its place, in sizes. */
uniform float lift;
varying vec3 vTint;
varying vec3 vNormal;
varying float vPresence;

void set(vec3 corner, vec3 outward) {
  mat3 body = mat3(ahead, left, cross(ahead, left));
  vNormal = body * outward;
  vTint = tint;
  vPresence = presence;
  vec3 at = place + size * share * (body * corner + vec3(0.0, 0.0, lift));
  gl_Position = projectionMatrix * modelViewMatrix * vec4(at, 1.0);
}
`;

export const SOLID_VERTEX = `${PLACED}
void main() {
  set(position, normal);
}
`;

const decimal = (value: number) => value.toFixed(4);

export const FIGURE_VERTEX = `${PLACED}
/** Which limb, and whether its lower part. */
attribute vec2 part;
/** Cosine and sine of the upper and the lower part. */
attribute vec4 leftLeg;
attribute vec4 rightLeg;
attribute vec4 leftArm;
attribute vec4 rightArm;
/** How far down the hip is, and cosine and sine of the lean. */
attribute vec3 posture;

vec2 turned(vec2 v, vec2 by) {
  return vec2(v.x * by.x - v.y * by.y, v.x * by.y + v.y * by.x);
}

void main() {
  vec4 limb = vec4(posture.yz, 1.0, 0.0);
  vec2 joints = vec2(${decimal(HEIGHTS.hip)}, ${decimal(HEIGHTS.knee)});
  if (part.x >= ${decimal(LIMB.leftArm)}) joints = vec2(${decimal(HEIGHTS.shoulder)}, ${decimal(HEIGHTS.elbow)});
  if (part.x == ${decimal(LIMB.leftLeg)}) limb = leftLeg;
  else if (part.x == ${decimal(LIMB.rightLeg)}) limb = rightLeg;
  else if (part.x == ${decimal(LIMB.leftArm)}) limb = leftArm;
  else if (part.x == ${decimal(LIMB.rightArm)}) limb = rightArm;
  vec3 corner = position;
  vec3 outward = normal;
  vec2 by = limb.xy;
  float pivot = joints.x;
  if (part.y > 0.5) {
    by = limb.zw;
    pivot = joints.y;
  }
  corner.xz = turned(corner.xz - vec2(0.0, pivot), by);
  if (part.y > 0.5) corner.xz += turned(vec2(0.0, joints.y - joints.x), limb.xy);
  corner.z += joints.x - posture.x;
  outward.xz = turned(outward.xz, by);
  set(corner, outward);
}
`;

/** Matte, lit from the upper left behind the audience; what turns away is shaded, never black. */
export const BODY_FRAGMENT = /* glsl */ `
uniform float shade;
varying vec3 vTint;
varying vec3 vNormal;
varying float vPresence;
const vec3 LIGHT = vec3(-0.36, -0.48, 0.8);

/** Interleaved gradient noise, 0..1 (Jimenez 2014): bodies need not be sorted when their pixels are left out. */
float grain() {
  return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
}

void main() {
  if (vPresence < 1.0 && grain() >= vPresence) discard;
  float lit = 0.5 + 0.5 * dot(normalize(vNormal), LIGHT);
  gl_FragColor = vec4(mix(vTint * shade, mix(vTint, vec3(1.0), 0.1), lit), 1.0);
}
`;
