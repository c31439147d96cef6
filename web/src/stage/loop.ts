/** After a rest or a hidden tab, a frame counts as no longer than this, seconds. */
const LONGEST_FRAME = 0.25;

/** Where frames come from: the window, or a test. */
export interface FrameSource {
  requestAnimationFrame(callback: (now: number) => void): number;
  cancelAnimationFrame(handle: number): void;
}

/** Frames while something changes and none otherwise. */
export interface Loop {
  /** Asks for a frame, if none is coming. */
  invalidate(): void;
  stop(): void;
}

/**
 * Calls `step` once a frame with the seconds since the last one, 0 after a rest.
 *
 * It goes on while `step` answers true. What changes within a step is drawn in it and asks for no other.
 */
export function createLoop(step: (elapsed: number) => boolean, frames: FrameSource): Loop {
  let handle: number | null = null;
  let last: number | null = null;
  let isStepping = false;

  function request(): void {
    handle ??= frames.requestAnimationFrame(run);
  }

  function run(now: number): void {
    handle = null;
    const elapsed = last === null ? 0 : Math.min((now - last) / 1000, LONGEST_FRAME);
    isStepping = true;
    const goesOn = step(elapsed);
    isStepping = false;
    last = goesOn ? now : null;
    if (goesOn) request();
  }

  return {
    invalidate() {
      if (!isStepping) request();
    },
    stop() {
      if (handle !== null) frames.cancelAnimationFrame(handle);
      handle = null;
    },
  };
}
