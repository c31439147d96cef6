import {
  BufferAttribute,
  type BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  InstancedBufferGeometry,
  Mesh,
  ShaderMaterial,
} from "three";
import { BODY_FRAGMENT, FIGURE_VERTEX, SOLID_VERTEX } from "./body-shader";
import { figureShape } from "./figure";
import type { Instances } from "./instances";
import type { BodySizes } from "./sizes";

/** What an agent looks like in the perspective view. */
export type BodyKind = "discs" | "cones" | "figures";

/** A disc is this high, in radii. */
export const DISC_HEIGHT = 0.45;

/** A cone in radii of a disc: its length, and its breadth and height at the rear, flat enough to be seen leaning. */
export const CONE = { length: 2.7, breadth: 1.05, height: 0.62 } as const;

/** In a crowd nobody sees how round a limb is, and the graphics card draws the sooner. */
const CROWD = 300;

/** How dark the side away from the light is, on paper and at night. */
const SHADE = { light: 0.62, dark: 0.46 } as const;

/** The agents as bodies: one kind at a time, each a single draw. */
export interface Bodies {
  readonly meshes: readonly Mesh[];
  show(kind: BodyKind, sizes: BodySizes): void;
  setTheme(isDark: boolean): void;
  dispose(): void;
}

export function createBodies(instances: Instances): Bodies {
  const meshes: Readonly<Record<BodyKind, Mesh<InstancedBufferGeometry, ShaderMaterial>>> = {
    discs: bodyMesh(discGeometry(instances.count), SOLID_VERTEX, instances),
    cones: bodyMesh(coneGeometry(instances.count), SOLID_VERTEX, instances),
    figures: bodyMesh(figureGeometry(instances.count), FIGURE_VERTEX, instances),
  };
  const all = Object.values(meshes);
  return {
    meshes: all,
    show(kind, sizes) {
      for (const mesh of all) mesh.visible = mesh === meshes[kind];
      uniform(meshes.discs, "size", sizes.disc);
      uniform(meshes.cones, "size", sizes.disc);
      // A cone's axis is as high as it is thick: it lies on the ground.
      uniform(meshes.cones, "lift", CONE.height);
      uniform(meshes.figures, "size", sizes.figure);
    },
    setTheme(isDark) {
      for (const mesh of all) uniform(mesh, "shade", isDark ? SHADE.dark : SHADE.light);
    },
    dispose() {
      for (const { geometry, material } of all) {
        geometry.dispose();
        material.dispose();
      }
    },
  };
}

/** `shape` once for every instance. */
export function instanced(shape: BufferGeometry, { attributes, count }: Instances): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.setIndex(shape.getIndex());
  for (const [name, attribute] of Object.entries(shape.attributes)) geometry.setAttribute(name, attribute);
  for (const [name, attribute] of Object.entries(attributes)) geometry.setAttribute(name, attribute);
  geometry.instanceCount = count;
  return geometry;
}

function bodyMesh(
  shape: BufferGeometry,
  vertexShader: string,
  instances: Instances,
): Mesh<InstancedBufferGeometry, ShaderMaterial> {
  const uniforms = { size: { value: 1 }, lift: { value: 0 }, shade: { value: 1 } };
  const material = new ShaderMaterial({ vertexShader, fragmentShader: BODY_FRAGMENT, uniforms });
  const mesh = new Mesh(instanced(shape, instances), material);
  // Its bounds are those of one body; where the others are only the shader knows.
  mesh.frustumCulled = false;
  mesh.visible = false;
  return mesh;
}

function uniform({ material }: Mesh<InstancedBufferGeometry, ShaderMaterial>, name: string, value: number): void {
  const found = material.uniforms[name];
  if (found) found.value = value;
}

function discGeometry(count: number): BufferGeometry {
  const geometry = new CylinderGeometry(0.94, 1, DISC_HEIGHT, count > CROWD ? 14 : 28, 1);
  return geometry.rotateX(Math.PI / 2).translate(0, 0, DISC_HEIGHT / 2);
}

/** Its tip along x. */
function coneGeometry(count: number): BufferGeometry {
  const geometry = new ConeGeometry(1, CONE.length, count > CROWD ? 10 : 24, 1);
  return geometry.rotateZ(-Math.PI / 2).scale(1, CONE.breadth, CONE.height);
}

function figureGeometry(count: number): BufferGeometry {
  const { corners, parts, triangles } = figureShape(count > CROWD ? 4 : 9);
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(corners, 3));
  geometry.setAttribute("part", new BufferAttribute(parts, 2));
  geometry.setIndex(new BufferAttribute(triangles, 1));
  geometry.computeVertexNormals();
  return geometry;
}
