import { type Color, ColorManagement, LinearSRGBColorSpace, PerspectiveCamera, type Scene, WebGLRenderer } from "three";
import type { Size } from "../camera";
import type { Orbit } from "./orbit";
import { FIELD_OF_VIEW, type Sight } from "./sight";

/** Canvas pixels a CSS pixel at most: edges are smoothed anyway, and every frame costs more. */
const DENSEST = 2;

/** Textures are no larger than this, and no sharper along a slope. */
const LARGEST_TEXTURE = 3072;
const SHARPEST = 8;

/** Without a graphics card edges are smoothed by drawing finer, which can be left off from one frame to the next. */
const FINER = 2;

/** Names of what draws on the processor. */
const PROCESSOR = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/** The browser draws nothing in three dimensions. */
export class NoGraphics extends Error {}

// The page's colors are meant for the screen as they are; nothing here is light to be computed with.
ColorManagement.enabled = false;

/** What draws in three dimensions, on a canvas of its own. */
export interface Device {
  /** Canvas pixels a CSS pixel. */
  readonly density: number;
  /** Pixels either way. */
  readonly largestTexture: number;
  /** Samples along a slope. */
  readonly sharpness: number;
  clearTo(color: Color): void;
  resize(size: Size): void;
  /** Sparing, a pixel of the canvas is one of the page, whatever the screen has. */
  draw(space: Scene, sight: Sight, orbit: Orbit, isSparing: boolean): void;
  dispose(): void;
}

/** A canvas in `host`, hidden from screen readers. Throws `NoGraphics`; `onLost` is told when the device goes away later. */
export function createDevice(host: HTMLElement, onLost: () => void): Device {
  const canvas = document.createElement("canvas");
  canvas.setAttribute("aria-hidden", "true");
  const isCard = !isDrawnByProcessor();
  const context = canvas.getContext("webgl2", {
    alpha: false,
    antialias: isCard,
    powerPreference: "high-performance",
  });
  if (!context) throw new NoGraphics("this browser has no WebGL 2");
  const renderer = new WebGLRenderer({ canvas, context });
  renderer.outputColorSpace = LinearSRGBColorSpace;
  const camera = new PerspectiveCamera((FIELD_OF_VIEW * 180) / Math.PI);
  camera.matrixAutoUpdate = false;
  canvas.addEventListener("webglcontextlost", onLost);
  host.append(canvas);
  let density = 1;
  /** Of the picture: canvas pixels a CSS pixel. */
  let fineness = 1;
  return {
    get density() {
      return density;
    },
    largestTexture: Math.min(renderer.capabilities.maxTextureSize, LARGEST_TEXTURE),
    sharpness: isCard ? Math.min(renderer.capabilities.getMaxAnisotropy(), SHARPEST) : 1,
    clearTo: (color) => renderer.setClearColor(color),
    resize({ width, height }) {
      density = Math.min(globalThis.devicePixelRatio || 1, DENSEST);
      fineness = density;
      renderer.setPixelRatio(density);
      renderer.setSize(width, height, false);
      camera.aspect = width / Math.max(height, 1);
    },
    draw(space, sight, orbit, isSparing) {
      const wanted = isSparing ? 1 : isCard ? density : FINER;
      // Even the same once more would make the canvas anew.
      if (wanted !== fineness) renderer.setPixelRatio(wanted);
      fineness = wanted;
      aim(camera, sight, orbit);
      renderer.render(space, camera);
    },
    dispose() {
      canvas.removeEventListener("webglcontextlost", onLost);
      renderer.dispose();
      // A browser lends out only so many devices, and takes them back late by itself.
      context.getExtension("WEBGL_lose_context")?.loseContext();
      canvas.remove();
    },
  };
}

function isDrawnByProcessor(): boolean {
  const context = document.createElement("canvas").getContext("webgl2");
  const names = context?.getExtension("WEBGL_debug_renderer_info");
  const name: unknown = names && context?.getParameter(names.UNMASKED_RENDERER_WEBGL);
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return typeof name === "string" && PROCESSOR.test(name);
}

/** The camera is told where it is and works out nothing itself. */
function aim(camera: PerspectiveCamera, { right, up, forward, eye }: Sight, { distance }: Orbit): void {
  // Depth has the most room near the eye: as much of it as the view allows.
  camera.near = distance / 50;
  camera.far = distance * 50;
  camera.updateProjectionMatrix();
  const into = camera.matrix.elements;
  for (let axis = 0; axis < 3; axis += 1) {
    into[axis] = right[axis] ?? 0;
    into[axis + 4] = up[axis] ?? 0;
    // A camera looks against its own third axis.
    into[axis + 8] = -(forward[axis] ?? 0);
    into[axis + 12] = eye[axis] ?? 0;
  }
  camera.matrixWorldNeedsUpdate = true;
}
