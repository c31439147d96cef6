import { BufferAttribute, BufferGeometry, type Color, LineBasicMaterial, LineSegments, ShaderMaterial } from "three";
import type { Bounds } from "../camera";
import { instanced } from "./bodies";
import type { Instances } from "./instances";

const DROP_VERTEX = /* glsl */ `
attribute vec3 place;

void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(place.xy, place.z * position.z, 1.0);
}
`;

const DROP_FRAGMENT = /* glsl */ `
uniform vec3 ink;

void main() {
  gl_FragColor = vec4(ink, 0.35);
}
`;

/** A line of the graphics card's own, one pixel wide. */
export interface Lines {
  readonly lines: LineSegments;
  setColor(color: Color): void;
  dispose(): void;
}

/** A line from everybody straight down to the ground: without it nobody sees where in the air somebody is. */
export function createDrops(instances: Instances): Lines {
  const line = new BufferGeometry();
  line.setAttribute("position", new BufferAttribute(Float32Array.of(0, 0, 0, 0, 0, 1), 3));
  const uniforms = { ink: { value: null as Color | null } };
  const material = new ShaderMaterial({
    vertexShader: DROP_VERTEX,
    fragmentShader: DROP_FRAGMENT,
    uniforms,
    transparent: true,
    depthWrite: false,
  });
  const lines = new LineSegments(instanced(line, instances), material);
  lines.frustumCulled = false;
  return {
    lines,
    setColor(color) {
      uniforms.ink.value = color;
    },
    dispose() {
      lines.geometry.dispose();
      material.dispose();
    },
  };
}

/** Edges of the air over the stage, where it has a height. */
export function createAirspace(): Lines & { fit(sheet: Bounds, height: number): void } {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(boxEdges(), 3));
  const material = new LineBasicMaterial();
  const lines = new LineSegments(geometry, material);
  return {
    lines,
    setColor(color) {
      material.color = color;
    },
    fit(sheet, height) {
      lines.visible = height > 0;
      lines.position.set(sheet.minX, sheet.minY, 0);
      lines.scale.set(sheet.maxX - sheet.minX, sheet.maxY - sheet.minY, Math.max(height, 1e-3));
    },
    dispose() {
      geometry.dispose();
      material.dispose();
    },
  };
}

/** The posts and the upper edges of a box from 0 to 1: two ends of x, y, z a line. */
function boxEdges(): Float32Array {
  const corners = [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ] as const;
  return Float32Array.from(
    corners.flatMap(([x, y], k) => {
      const [nextX, nextY] = corners[(k + 1) % 4] ?? [0, 0];
      return [x, y, 0, x, y, 1, x, y, 1, nextX, nextY, 1];
    }),
  );
}
