import type { Signal } from "@preact/signals";
import type { FrameSource } from "../loop";
import { between, type Orbit } from "./orbit";

/** Longer than any other motion of the page: a whole stand is crossed. Milliseconds. */
const DURATION = 900;

/** An eye that flies by itself, until the person takes over. */
export interface Flight {
  to(target: Orbit): void;
  stop(): void;
}

/** Without frames the eye is there at once. */
export function createFlight(orbit: Signal<Orbit>, frames: FrameSource | null): Flight {
  let handle: number | null = null;

  function stop(): void {
    if (handle !== null) frames?.cancelAnimationFrame(handle);
    handle = null;
  }

  return {
    to(target) {
      stop();
      if (!frames) {
        orbit.value = target;
        return;
      }
      const from = orbit.peek();
      let start: number | null = null;
      const step = (now: number) => {
        start ??= now;
        const t = Math.min(1, (now - start) / DURATION);
        orbit.value = between(from, target, eased(t));
        handle = t < 1 ? frames.requestAnimationFrame(step) : null;
      };
      handle = frames.requestAnimationFrame(step);
    },
    stop,
  };
}

/** Takes off and lands softly. */
function eased(t: number): number {
  return t < 0.5 ? 4 * t ** 3 : 1 - 4 * (1 - t) ** 3;
}
