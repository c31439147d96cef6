import { type Color, type InstancedBufferGeometry, Mesh, PlaneGeometry, ShaderMaterial } from "three";
import { instanced } from "./bodies";
import type { Instances } from "./instances";

/** How far a mark reaches around its agent, in radii: room for the soft edge and the ring. */
const REACH = 2.2;

const VERTEX = /* glsl */ `
attribute vec3 place;
attribute float chosen;
attribute float presence;
attribute float share;
uniform float radius;
varying vec2 vFrom;
varying float vChosen;
varying float vHeight;
varying float vPresence;

void main() {
  vFrom = position.xy * 2.0 * ${REACH.toFixed(1)};
  vChosen = chosen;
  vPresence = presence;
  vHeight = place.z / (radius * share);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(vFrom * radius * share + place.xy, 0.0, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
uniform vec3 shadow;
uniform float darkness;
uniform vec3 you;
varying vec2 vFrom;
varying float vChosen;
varying float vHeight;
varying float vPresence;

void main() {
  float away = length(vFrom);
  float pixel = fwidth(away);
  // The higher somebody is, the softer and fainter is the shadow.
  float softness = 0.55 + 0.12 * min(vHeight, 8.0);
  float dark = darkness * (1.0 - smoothstep(1.15 - softness, 1.15 + softness, away)) / (1.0 + 0.12 * vHeight);
  float band = vChosen * (1.0 - smoothstep(0.11, 0.11 + pixel, abs(away - 1.62)));
  float alpha = vPresence * max(dark, band);
  gl_FragColor = vec4(mix(shadow, you, band), alpha);
}
`;

/** What agents leave on the ground under them: a soft shadow, and the person's ring around who is selected. */
export interface Marks {
  readonly mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  setRadius(radius: number): void;
  setTheme(shadow: Color, darkness: number, you: Color): void;
  dispose(): void;
}

export function createMarks(instances: Instances): Marks {
  const uniforms = {
    radius: { value: 1 },
    darkness: { value: 0 },
    shadow: { value: null as Color | null },
    you: { value: null as Color | null },
  };
  const material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms,
    transparent: true,
    depthWrite: false,
  });
  const mesh = new Mesh(instanced(new PlaneGeometry(1, 1), instances), material);
  mesh.frustumCulled = false;
  mesh.renderOrder = 1;
  return {
    mesh,
    setRadius(radius) {
      uniforms.radius.value = radius;
    },
    setTheme(shadow, darkness, you) {
      uniforms.shadow.value = shadow;
      uniforms.darkness.value = darkness;
      uniforms.you.value = you;
    },
    dispose() {
      mesh.geometry.dispose();
      material.dispose();
    },
  };
}
