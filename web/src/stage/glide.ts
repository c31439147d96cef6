import type { Signal } from "@preact/signals";
import { between } from "./camera";
import type { FrameSource } from "./loop";
import type { Camera } from "./view";

/** The look's slow motion, for sheets and the camera, milliseconds. */
const DURATION = 280;

/** A camera that moves by itself, until the person takes over. */
export interface Glide {
  to(target: Camera): void;
  stop(): void;
}

/** Without frames the camera is there at once. */
export function createGlide(camera: Signal<Camera>, frames: FrameSource | null): Glide {
  let handle: number | null = null;

  function stop(): void {
    if (handle !== null) frames?.cancelAnimationFrame(handle);
    handle = null;
  }

  return {
    to(target) {
      stop();
      if (!frames) {
        camera.value = target;
        return;
      }
      const from = camera.peek();
      let start: number | null = null;
      const step = (now: number) => {
        start ??= now;
        const t = Math.min(1, (now - start) / DURATION);
        camera.value = between(from, target, 1 - (1 - t) ** 3);
        handle = t < 1 ? frames.requestAnimationFrame(step) : null;
      };
      handle = frames.requestAnimationFrame(step);
    },
    stop,
  };
}

/** The window's frames where there is a window and the person likes motion. */
export function framesForMotion(): FrameSource | null {
  if (typeof matchMedia !== "function" || matchMedia("(prefers-reduced-motion: reduce)").matches) return null;
  return globalThis;
}
