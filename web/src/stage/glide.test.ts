import { signal } from "@preact/signals";
import { describe, expect, it } from "vitest";
import { type Course, createGlide } from "./glide";

interface Place {
  readonly x: number;
}

const FROM: Place = { x: 10 };
const TO: Place = { x: 20 };
const COURSE: Course<Place> = {
  duration: 280,
  at: (from, to, t) => (t === 1 ? to : { x: from.x + (to.x - from.x) * t }),
};

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
    const place = signal(FROM);
    const clock = manual();
    createGlide(place, COURSE, clock.frames).to(TO);
    for (const now of [0, 100, 200, 300]) clock.run(now);
    expect(place.value).toBe(TO);
    expect(clock.isResting).toBe(true);
  });

  it("is on its way in between", () => {
    const place = signal(FROM);
    const clock = manual();
    createGlide(place, COURSE, clock.frames).to(TO);
    clock.run(0);
    clock.run(60);
    expect(place.value.x).toBeGreaterThan(10);
    expect(place.value.x).toBeLessThan(20);
  });

  it("stops where it is when the person takes over", () => {
    const place = signal(FROM);
    const clock = manual();
    const glide = createGlide(place, COURSE, clock.frames);
    glide.to(TO);
    clock.run(0);
    clock.run(60);
    const there = place.value;
    glide.stop();
    clock.run(500);
    expect(place.value).toBe(there);
  });

  it("without motion it is there at once", () => {
    const place = signal(FROM);
    createGlide(place, COURSE, null).to(TO);
    expect(place.value).toBe(TO);
  });
});
