import { BufferAttribute, BufferGeometry, type Color, DynamicDrawUsage, LineSegments, ShaderMaterial } from "three";
import { INVISIBLE, presence } from "../layers/ties";
import type { TieBundle } from "../ties";

const VERTEX = /* glsl */ `
attribute float firmness;
varying float vFirmness;

void main() {
  vFirmness = firmness;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
uniform vec3 ink;
varying float vFirmness;

void main() {
  gl_FragColor = vec4(ink, vFirmness);
}
`;

/** The graphics card draws lines one pixel wide: what would be wider is as much firmer. */
const MOST_FIRMNESS = 0.95;

/** Ties as lines from foot to foot. */
export interface TieLines {
  readonly lines: LineSegments<BufferGeometry, ShaderMaterial>;
  /**
   * Ties of agents at `place` (x, y, z an agent), `t` of the way through the transition; allocates nothing while the
   * bundles are the same. `room` is 1, or less where they crowd; those of marked agents (1) show at any.
   */
  update(
    bundles: readonly TieBundle[],
    place: Float32Array,
    t: number,
    room: number,
    isMarked: Uint8Array | null,
  ): void;
  setColor(ink: Color): void;
  dispose(): void;
}

export function createTieLines(): TieLines {
  const geometry = new BufferGeometry();
  const uniforms = { ink: { value: null as Color | null } };
  const material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms,
    transparent: true,
    depthWrite: false,
  });
  const lines = new LineSegments(geometry, material);
  lines.frustumCulled = false;
  let ends = new BufferAttribute(new Float32Array(0), 3);
  let firmnesses = new BufferAttribute(new Float32Array(0), 1);
  let held: readonly TieBundle[] | null = null;

  function makeRoom(bundles: readonly TieBundle[]): void {
    held = bundles;
    const count = bundles.reduce((sum, { pairs }) => sum + pairs.length, 0);
    if (firmnesses.count >= count) return;
    // What the card holds of a geometry that grows is given back first.
    geometry.dispose();
    ends = new BufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage);
    firmnesses = new BufferAttribute(new Float32Array(count), 1).setUsage(DynamicDrawUsage);
    geometry.setAttribute("position", ends);
    geometry.setAttribute("firmness", firmnesses);
  }

  return {
    lines,
    update(bundles, place, t, room, isMarked) {
      if (bundles !== held) makeRoom(bundles);
      const into = ends.array;
      const firm = firmnesses.array;
      let end = 0;
      for (let which = 0; which < bundles.length; which += 1) {
        const bundle = bundles[which];
        if (!bundle) continue;
        const { pairs } = bundle;
        const alpha = Math.min(bundle.alpha * Math.max(1, bundle.width), MOST_FIRMNESS) * presence(bundle.phase, t);
        for (let k = 0; k + 1 < pairs.length; k += 2) {
          const a = pairs[k] ?? 0;
          const b = pairs[k + 1] ?? 0;
          const isAlways = isMarked !== null && (isMarked[a] === 1 || isMarked[b] === 1);
          const firmness = isAlways ? alpha : alpha * room;
          if (firmness < INVISIBLE) continue;
          for (let axis = 0; axis < 3; axis += 1) {
            into[3 * end + axis] = place[3 * a + axis] ?? 0;
            into[3 * end + 3 + axis] = place[3 * b + axis] ?? 0;
          }
          firm[end] = firmness;
          firm[end + 1] = firmness;
          end += 2;
        }
      }
      lines.visible = end > 0;
      geometry.setDrawRange(0, end);
      ends.needsUpdate = true;
      firmnesses.needsUpdate = true;
    },
    setColor(ink) {
      uniforms.ink.value = ink;
    },
    dispose() {
      geometry.dispose();
      material.dispose();
    },
  };
}
