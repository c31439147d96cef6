import { describe, expect, it } from "vitest";
import { bodyAt } from "./pick";

/** Three bodies: one behind another, and one beside them behind the eye. */
const FEET = Float32Array.of(100, 200, 30, 104, 190, 50, 300, 200, 0);
const HEADS = Float32Array.of(100, 150, 30, 104, 155, 50, 300, 150, 0);
const WIDTHS = Float32Array.of(8, 6, 8);
const at = (x: number, y: number, slack = 6) => bodyAt(FEET, HEADS, WIDTHS, { x, y }, slack);

describe("pick", () => {
  it("of bodies under the pointer the one in front is meant", () => {
    expect(at(103, 170)).toBe(0);
  });

  it("a body that sticks out can be picked", () => {
    expect(at(109, 172)).toBe(1);
  });

  it("a near miss counts, a far one does not", () => {
    expect(at(88, 175)).toBe(0);
    expect(at(60, 175)).toBeNull();
  });

  it("nobody is picked behind the eye", () => {
    expect(at(300, 175)).toBeNull();
  });
});
