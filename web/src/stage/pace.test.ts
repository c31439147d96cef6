import { describe, expect, it } from "vitest";
import { createPace } from "./pace";

function sparesAfter(...frames: number[]): boolean {
  const pace = createPace();
  for (const seconds of frames) pace.note(seconds);
  return pace.isSparing;
}

describe("pace", () => {
  it("a screen that is kept up with is drawn in full", () => {
    expect(sparesAfter(0, ...Array(200).fill(1 / 60))).toBe(false);
    expect(sparesAfter(0, ...Array(200).fill(1 / 120))).toBe(false);
  });

  it("one late frame is forgiven", () => {
    expect(sparesAfter(0, ...Array(50).fill(1 / 60), 1 / 30, ...Array(50).fill(1 / 60))).toBe(false);
  });

  it("falling behind spares within half a second, until playing rests", () => {
    const behind = Array(15).fill(1 / 30);
    expect(sparesAfter(0, ...behind)).toBe(true);
    expect(sparesAfter(0, ...behind, ...Array(200).fill(1 / 60))).toBe(true);
    expect(sparesAfter(0, ...behind, 0)).toBe(false);
  });
});
