import type { Signal } from "@preact/signals";
import type { FrameSource } from "./loop";

/** A value that moves by itself, until the person takes over. */
export interface Glide<Value> {
  to(target: Value): void;
  stop(): void;
}

/** How one value becomes another. */
export interface Course<Value> {
  /** Milliseconds. */
  readonly duration: number;
  /** Where it is at share `t` of the time, `to` itself at 1. */
  at(from: Value, to: Value, t: number): Value;
}

/** Without frames the value is there at once. */
export function createGlide<Value>(
  value: Signal<Value>,
  course: Course<Value>,
  frames: FrameSource | null,
): Glide<Value> {
  let handle: number | null = null;

  function stop(): void {
    if (handle !== null) frames?.cancelAnimationFrame(handle);
    handle = null;
  }

  return {
    to(target) {
      stop();
      if (!frames) {
        value.value = target;
        return;
      }
      const from = value.peek();
      let start: number | null = null;
      const step = (now: number) => {
        start ??= now;
        const t = Math.min(1, (now - start) / course.duration);
        value.value = course.at(from, target, t);
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
