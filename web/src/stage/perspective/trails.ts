import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Mesh, ShaderMaterial } from "three";
import type { SegmentMotion } from "../../playback/motion";
import { outlineInto, trailAlphaAt } from "../ribbon";
import type { Instances } from "./instances";

/** Places along a trail. */
const PLACES = 19;

/** Share of a transition that trails reach back: less in a crowd, where they would cover the ground. */
const REACH = { few: 0.8, many: 0.5 } as const;
const MANY = 300;

/** Widths at the tail and at the agent, in radii of its disc. */
const TAIL = 0.12;
const HEAD = 0.85;

const VERTEX = /* glsl */ `
attribute vec2 edge;
attribute float rise;
attribute float firmness;
attribute vec3 tint;
varying vec4 vColor;

void main() {
  vColor = vec4(tint, firmness);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(edge, rise, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
uniform float strength;
varying vec4 vColor;

void main() {
  gl_FragColor = vec4(vColor.rgb, vColor.a * strength);
}
`;

/** Ribbons from where the agents were to where they are, thin and faint to thick and firm. */
export interface Trails {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  /** Trails of `motion` at `now`, scene seconds, for discs of `radius` meters; `strength` is 1, or less while they fade. */
  update(motion: SegmentMotion, now: number, radius: number, strength: number): void;
  /** Takes the agents' colors as they are now, and how firm a trail is at its head. */
  paint(headAlpha: number): void;
  dispose(): void;
}

export function createTrails({ count, tint, share: sizes }: Instances): Trails {
  const edge = new Float32Array(4 * PLACES * count);
  const rise = new Float32Array(2 * PLACES * count);
  const firmness = new Float32Array(2 * PLACES * count);
  const color = new Float32Array(6 * PLACES * count);
  const line = new Float32Array(2 * PLACES);
  const samples = new Int32Array(PLACES);
  const shares = new Float32Array(PLACES);
  const edges = new BufferAttribute(edge, 2).setUsage(DynamicDrawUsage);
  const rises = new BufferAttribute(rise, 1).setUsage(DynamicDrawUsage);
  const firmnesses = new BufferAttribute(firmness, 1);
  const colors = new BufferAttribute(color, 3);
  const geometry = new BufferGeometry();
  geometry.setAttribute("edge", edges);
  geometry.setAttribute("rise", rises);
  geometry.setAttribute("firmness", firmnesses);
  geometry.setAttribute("tint", colors);
  geometry.setIndex(new BufferAttribute(stripsOf(count), 1));
  const uniforms = { strength: { value: 1 } };
  const material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms,
    transparent: true,
    depthWrite: false,
  });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  let isLifted = false;

  /** Which samples of the motion each place lies between. */
  function locate(motion: SegmentMotion, from: number, to: number): void {
    for (let place = 0; place < PLACES; place += 1) {
      const time = from + ((to - from) * place) / (PLACES - 1);
      const sample = Math.min(motion.sampleBefore(time), motion.times.length - 2);
      const start = motion.times[sample] ?? 0;
      const length = (motion.times[sample + 1] ?? 0) - start;
      samples[place] = sample;
      shares[place] = length > 0 ? (time - start) / length : 0;
    }
  }

  /** The heights of all trails; on the ground there is nothing to do again and again. */
  function lift(heights: Float32Array | null): void {
    if (!heights && !isLifted) return;
    isLifted = heights !== null;
    for (let corner = 0; corner < rise.length; corner += 2) {
      const place = (corner >> 1) % PLACES;
      const agent = Math.floor((corner >> 1) / PLACES);
      const at = (samples[place] ?? 0) * count + agent;
      const low = heights?.[at] ?? 0;
      const height = low + ((heights?.[at + count] ?? 0) - low) * (shares[place] ?? 0);
      rise[corner] = height;
      rise[corner + 1] = height;
    }
    rises.needsUpdate = true;
  }

  return {
    mesh,
    update(motion, now, radius, strength) {
      const duration = motion.end - motion.start;
      const from = Math.max(motion.start, now - duration * (count > MANY ? REACH.many : REACH.few));
      mesh.visible = motion.times.length > 1 && strength > 0 && now - from > 1e-3;
      if (!mesh.visible) return;
      uniforms.strength.value = strength;
      locate(motion, from, Math.min(now, motion.end));
      const { xy } = motion;
      for (let agent = 0; agent < count; agent += 1) {
        for (let place = 0; place < PLACES; place += 1) {
          const at = 2 * ((samples[place] ?? 0) * count + agent);
          const next = at + 2 * count;
          const share = shares[place] ?? 0;
          line[2 * place] = (xy[at] ?? 0) + ((xy[next] ?? 0) - (xy[at] ?? 0)) * share;
          line[2 * place + 1] = (xy[at + 1] ?? 0) + ((xy[next + 1] ?? 0) - (xy[at + 1] ?? 0)) * share;
        }
        const disc = radius * (sizes[agent] ?? 1);
        outlineInto(line, PLACES, TAIL * disc, HEAD * disc, edge, 4 * PLACES * agent);
      }
      edges.needsUpdate = true;
      lift(motion.heights);
    },
    paint(headAlpha) {
      for (let corner = 0; corner < firmness.length; corner += 1) {
        const place = (corner >> 1) % PLACES;
        const agent = Math.floor(corner / (2 * PLACES));
        firmness[corner] = trailAlphaAt(place / (PLACES - 1), headAlpha);
        color.set(tint.subarray(3 * agent, 3 * agent + 3), 3 * corner);
      }
      firmnesses.needsUpdate = true;
      colors.needsUpdate = true;
    },
    dispose() {
      geometry.dispose();
      material.dispose();
    },
  };
}

/** Two triangles between each place and the next. */
function stripsOf(count: number): Uint32Array {
  const corners = new Uint32Array(6 * (PLACES - 1) * count);
  let at = 0;
  for (let agent = 0; agent < count; agent += 1) {
    for (let place = 0; place + 1 < PLACES; place += 1) {
      const left = 2 * (agent * PLACES + place);
      corners.set([left, left + 1, left + 2, left + 2, left + 1, left + 3], at);
      at += 6;
    }
  }
  return corners;
}
