import type { Size } from "./camera";

/** Canvas pixels a CSS pixel at most: beyond it nobody sees more, and every frame costs more. */
const DENSEST = 3;

/** The three sheets of the stage, back to front. */
export interface Canvases {
  readonly backdrop: CanvasRenderingContext2D;
  readonly motion: CanvasRenderingContext2D;
  readonly handles: CanvasRenderingContext2D;
  /** For pictures that are put together before they are laid down; not in the page. */
  readonly scratch: CanvasRenderingContext2D;
  readonly density: number;
  /** Takes a size in CSS pixels; drawing is in CSS pixels from then on. All canvases are empty after. */
  resize(size: Size): void;
}

/** Canvases that fill `host`, hidden from screen readers: the agents table tells the same in words. */
export function createCanvases(host: HTMLElement): Canvases {
  const backdrop = createContext(1, 1, true);
  const motion = createContext(1, 1);
  const handles = createContext(1, 1);
  const scratch = createContext(1, 1);
  for (const { canvas } of [backdrop, motion, handles]) {
    canvas.className = "stage-canvas";
    canvas.setAttribute("aria-hidden", "true");
    host.append(canvas);
  }
  let density = 1;
  return {
    backdrop,
    motion,
    handles,
    scratch,
    get density() {
      return density;
    },
    resize({ width, height }) {
      density = Math.min(globalThis.devicePixelRatio || 1, DENSEST);
      for (const context of [backdrop, motion, handles, scratch]) {
        context.canvas.width = Math.max(1, Math.round(width * density));
        context.canvas.height = Math.max(1, Math.round(height * density));
        context.setTransform(density, 0, 0, density, 0, 0);
      }
    },
  };
}

/** A canvas of its own, in canvas pixels. */
export function createContext(width: number, height: number, isOpaque = false): CanvasRenderingContext2D {
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d", { alpha: !isOpaque });
  if (!context) throw new Error("this browser draws no 2D canvas");
  return context;
}
