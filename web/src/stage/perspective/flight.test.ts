import { signal } from "@preact/signals";
import { describe, expect, it } from "vitest";
import type { FrameSource } from "../loop";
import { createFlight } from "./flight";
import type { Orbit } from "./orbit";

const HERE: Orbit = { x: 0, y: 0, z: 0, distance: 100, azimuth: 0, elevation: 1 };
const SEAT: Orbit = { x: 1, y: 2, z: 0, distance: 40, azimuth: 0.4, elevation: 0.2 };

/** Frames that come when the test says so. */
function clock(): FrameSource & { frame(now: number): void; readonly isWaiting: boolean } {
  let waiting: ((now: number) => void) | null = null;
  return {
    requestAnimationFrame(callback) {
      waiting = callback;
      return 1;
    },
    cancelAnimationFrame() {
      waiting = null;
    },
    frame(now) {
      const due = waiting;
      waiting = null;
      due?.(now);
    },
    get isWaiting() {
      return waiting !== null;
    },
  };
}

describe("flight", () => {
  it("takes off and lands softly, and then asks for no more frames", () => {
    const [orbit, frames] = [signal(HERE), clock()];
    createFlight(orbit, frames).to(SEAT);
    const heights: number[] = [];
    for (let now = 0; now <= 900; now += 90) {
      frames.frame(now);
      heights.push(orbit.value.elevation);
    }
    const steps = heights.slice(1).map((height, k) => (heights[k] ?? 0) - height);
    expect(Math.min(...steps)).toBeGreaterThan(0);
    expect(steps[0]).toBeLessThan((steps[4] ?? 0) / 3);
    expect(steps[9]).toBeLessThan((steps[5] ?? 0) / 3);
    expect(orbit.value).toBe(SEAT);
    expect(frames.isWaiting).toBe(false);
  });

  it("stops where it is when the person takes over", () => {
    const [orbit, frames] = [signal(HERE), clock()];
    const flight = createFlight(orbit, frames);
    flight.to(SEAT);
    frames.frame(0);
    frames.frame(450);
    const there = orbit.value;
    flight.stop();
    frames.frame(900);
    expect(orbit.value).toBe(there);
  });

  it("who asked for less motion is there at once", () => {
    const orbit = signal(HERE);
    createFlight(orbit, null).to(SEAT);
    expect(orbit.value).toBe(SEAT);
  });
});
