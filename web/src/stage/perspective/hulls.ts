import {
  Color,
  DynamicDrawUsage,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  LessDepth,
  Mesh,
  PlaneGeometry,
  ShaderMaterial,
} from "three";
import { coverOf, type HullShape } from "../layers/hulls";

const VERTEX = /* glsl */ `
attribute vec4 span;
attribute vec4 hull;
uniform float reach;
varying vec2 vAt;
varying vec4 vSpan;
varying vec4 vHull;

void main() {
  vec2 along = span.zw - span.xy;
  float way = length(along);
  vec2 ahead = way > 0.0 ? along / way : vec2(1.0, 0.0);
  vec2 reaches = vec2(way / 2.0 + reach, reach);
  vec2 from = position.xy * 2.0 * reaches;
  vAt = (span.xy + span.zw) / 2.0 + from.x * ahead + from.y * vec2(-ahead.y, ahead.x);
  vSpan = span;
  vHull = hull;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(vAt, 0.0, 1.0);
}
`;

/** Everything of one hull is equally deep, behind all else but the ground: where its parts overlap only the first is drawn. */
const FRAGMENT = /* glsl */ `
uniform float reach;
uniform float alpha;
varying vec2 vAt;
varying vec4 vSpan;
varying vec4 vHull;

void main() {
  vec2 along = vSpan.zw - vSpan.xy;
  vec2 from = vAt - vSpan.xy;
  float t = clamp(dot(from, along) / max(dot(along, along), 1e-9), 0.0, 1.0);
  if (distance(from, along * t) > reach) discard;
  gl_FragDepth = 1.0 - (floor(vHull.w + 0.5) + 1.0) * 1e-6;
  gl_FragColor = vec4(vHull.rgb, alpha);
}
`;

/** Soft areas on the ground under the groups, of one tone however their parts overlap. */
export interface Hulls {
  readonly mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  /**
   * Discs of `reach` meters about the agents at `place` (x, y, z an agent), and bands as wide along the ties that are
   * short for a `spacing` in meters, as on the plan; allocates nothing while the shapes are the same.
   */
  update(shapes: readonly HullShape[], place: Float32Array, reach: number, spacing: number, alpha: number): void;
  dispose(): void;
}

export function createHulls(): Hulls {
  const quad = new PlaneGeometry(1, 1);
  const geometry = new InstancedBufferGeometry();
  geometry.setIndex(quad.getIndex());
  geometry.setAttribute("position", quad.getAttribute("position"));
  const uniforms = { reach: { value: 1 }, alpha: { value: 0 } };
  const material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms,
    transparent: true,
    depthFunc: LessDepth,
  });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  let spans = new InstancedBufferAttribute(new Float32Array(0), 4);
  /** Of each part, the agent it starts at and the one it leads to: the same for a disc. */
  let parts = new Uint32Array(0);
  let held: readonly HullShape[] | null = null;

  function take(shapes: readonly HullShape[]): void {
    held = shapes;
    const count = shapes.reduce((sum, { agents, pairs }) => sum + agents.length + pairs.length, 0);
    parts = new Uint32Array(2 * count);
    const hulls = new Float32Array(4 * count);
    let part = 0;
    const put = (from: number, to: number, look: ArrayLike<number>) => {
      parts[2 * part] = from;
      parts[2 * part + 1] = to;
      hulls.set(look, 4 * part);
      part += 1;
    };
    shapes.forEach(({ color, agents, pairs }, layer) => {
      const { r, g, b } = new Color(color);
      const look = [r, g, b, layer];
      for (const agent of agents) put(agent, agent, look);
      // Each end sends out half a band: while a tie is too long they do not meet.
      for (let k = 0; k + 1 < pairs.length; k += 2) {
        put(pairs[k] ?? 0, pairs[k + 1] ?? 0, look);
        put(pairs[k + 1] ?? 0, pairs[k] ?? 0, look);
      }
    });
    // What the card holds of a geometry that changes its size is given back first.
    geometry.dispose();
    spans = new InstancedBufferAttribute(new Float32Array(4 * count), 4).setUsage(DynamicDrawUsage);
    geometry.setAttribute("span", spans);
    geometry.setAttribute("hull", new InstancedBufferAttribute(hulls, 4));
    geometry.instanceCount = count;
  }

  return {
    mesh,
    update(shapes, place, reach, spacing, alpha) {
      if (shapes !== held) take(shapes);
      mesh.visible = alpha > 0.004 && parts.length > 0;
      if (!mesh.visible) return;
      uniforms.reach.value = reach;
      uniforms.alpha.value = alpha;
      const into = spans.array;
      for (let k = 0; k < parts.length; k += 2) {
        const from = 3 * (parts[k] ?? 0);
        const to = 3 * (parts[k + 1] ?? 0);
        const x = place[from] ?? 0;
        const y = place[from + 1] ?? 0;
        const dx = (place[to] ?? 0) - x;
        const dy = (place[to + 1] ?? 0) - y;
        const cover = coverOf(Math.sqrt(dx * dx + dy * dy) / spacing) / 2;
        into[2 * k] = x;
        into[2 * k + 1] = y;
        into[2 * k + 2] = x + dx * cover;
        into[2 * k + 3] = y + dy * cover;
      }
      spans.needsUpdate = true;
    },
    dispose() {
      quad.dispose();
      geometry.dispose();
      material.dispose();
    },
  };
}
