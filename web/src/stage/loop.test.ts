import { describe, expect, it } from "vitest";
import { createLoop, type FrameSource } from "./loop";

/** Frames on demand. */
function manualFrames() {
  let pending: ((now: number) => void)[] = [];
  const source: FrameSource = {
    requestAnimationFrame: (callback) => pending.push(callback),
    cancelAnimationFrame: () => {
      pending = [];
    },
  };
  return {
    source,
    get count() {
      return pending.length;
    },
    run(now: number) {
      const due = pending;
      pending = [];
      for (const callback of due) callback(now);
    },
  };
}

describe("loop", () => {
  it("nothing changes, nothing is drawn", () => {
    const frames = manualFrames();
    createLoop(() => false, frames.source);
    expect(frames.count).toBe(0);
  });

  it("many changes make one frame", () => {
    const frames = manualFrames();
    let drawn = 0;
    const loop = createLoop(() => {
      drawn += 1;
      return false;
    }, frames.source);
    loop.invalidate();
    loop.invalidate();
    expect(frames.count).toBe(1);
    frames.run(0);
    expect([drawn, frames.count]).toEqual([1, 0]);
  });

  it("goes on while it plays, telling the time that went by, and rests after", () => {
    const frames = manualFrames();
    const elapsed: number[] = [];
    const loop = createLoop((seconds) => elapsed.push(seconds) < 3, frames.source);
    loop.invalidate();
    for (const now of [1000, 1016, 1033]) frames.run(now);
    expect(elapsed).toEqual([0, 0.016, 0.017]);
    expect(frames.count).toBe(0);
  });

  it("a rest does not count as time that went by", () => {
    const frames = manualFrames();
    const elapsed: number[] = [];
    const loop = createLoop((seconds) => {
      elapsed.push(seconds);
      return false;
    }, frames.source);
    loop.invalidate();
    frames.run(1000);
    loop.invalidate();
    frames.run(9000);
    expect(elapsed).toEqual([0, 0]);
  });

  it("a hidden tab does not skip the show", () => {
    const frames = manualFrames();
    const elapsed: number[] = [];
    const loop = createLoop((seconds) => elapsed.push(seconds) < 2, frames.source);
    loop.invalidate();
    frames.run(0);
    frames.run(60_000);
    expect(elapsed).toEqual([0, 0.25]);
  });

  it("what changes within a frame is drawn in it", () => {
    const frames = manualFrames();
    const loop = createLoop(() => {
      loop.invalidate();
      return false;
    }, frames.source);
    loop.invalidate();
    frames.run(0);
    expect(frames.count).toBe(0);
  });
});
