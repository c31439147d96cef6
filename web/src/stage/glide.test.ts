import { signal } from "@preact/signals";
import { describe, expect, it } from "vitest";
import { createGlide } from "./glide";
import type { Camera } from "./view";

const FROM: Camera = { scale: 10, left: 0, top: 0 };
const TO: Camera = { scale: 20, left: 100, top: 50 };

function manual() {
  let pending: ((now: number) => void) | null = null;
  return {
    frames: {
      requestAnimationFrame(callback: (now: number) => void) {
        pending = callback;
        return 1;
      },
      cancelAnimationFrame() {
        pending = null;
      },
    },
    run(now: number) {
      const due = pending;
      pending = null;
      due?.(now);
    },
    get isResting() {
      return pending === null;
    },
  };
}

describe("glide", () => {
  it("arrives exactly and rests", () => {
    const camera = signal(FROM);
    const clock = manual();
    createGlide(camera, clock.frames).to(TO);
    for (const now of [0, 100, 200, 300]) clock.run(now);
    expect(camera.value).toBe(TO);
    expect(clock.isResting).toBe(true);
  });

  it("is on its way in between", () => {
    const camera = signal(FROM);
    const clock = manual();
    createGlide(camera, clock.frames).to(TO);
    clock.run(0);
    clock.run(60);
    expect(camera.value.scale).toBeGreaterThan(10);
    expect(camera.value.scale).toBeLessThan(20);
  });

  it("stops where it is when the person takes over", () => {
    const camera = signal(FROM);
    const clock = manual();
    const glide = createGlide(camera, clock.frames);
    glide.to(TO);
    clock.run(0);
    clock.run(60);
    const there = camera.value;
    glide.stop();
    clock.run(500);
    expect(camera.value).toBe(there);
  });

  it("without motion it is there at once", () => {
    const camera = signal(FROM);
    createGlide(camera, null).to(TO);
    expect(camera.value).toBe(TO);
  });
});
