import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { bankOf, headingOf, pitchOf, WINDOW } from "./course";
import { shortestTurn } from "./orbit";

const step = fc.double({ min: -3, max: 3, noNaN: true });

describe("course", () => {
  it("who walks heads where the way goes", () => {
    expect(headingOf(2, 0)).toBeCloseTo(0, 1);
    expect(headingOf(0, 2)).toBeCloseTo(Math.PI / 2, 1);
    expect(headingOf(-2, -2)).toBeCloseTo((-3 * Math.PI) / 4, 1);
  });

  it("who stands faces the audience", () => {
    const facing = headingOf(0, 0);
    expect(Math.sin(facing)).toBeLessThan(-0.9);
  });

  it("who comes to rest turns about and is not flipped, wherever the way went", () => {
    for (let way = 0; way < 24; way += 1) {
      const angle = (way * Math.PI) / 12;
      let last = headingOf(Math.cos(angle), Math.sin(angle));
      for (let length = 1; length >= 0; length -= 0.002) {
        const next = headingOf(length * Math.cos(angle), length * Math.sin(angle));
        // Two millimeters less are at most an eighth of a turn, which it takes around the way straight from the front.
        expect(Math.abs(shortestTurn(next - last))).toBeLessThan(Math.PI / 4);
        last = next;
      }
    }
  });

  it("an airplane's nose points along its way, up and down", () => {
    expect(pitchOf(3, 0, 3)).toBeCloseTo(Math.PI / 4, 12);
    expect(pitchOf(0, 3, -3)).toBeCloseTo(-Math.PI / 4, 12);
    expect(pitchOf(0, 0, 0)).toBe(0);
  });

  it("it leans into its turn as weight and speed demand, and level ways are level", () => {
    expect(bankOf(1, 0, 1, 0)).toBe(0);
    const turn = 0.1;
    const [speed, rate] = [1 / WINDOW, turn / WINDOW];
    expect(Math.tan(bankOf(1, 0, Math.cos(turn), Math.sin(turn)))).toBeCloseTo((speed * rate) / 9.81, 9);
  });

  it("a turn to the right is the mirror of one to the left, and nobody rolls over", () => {
    fc.assert(
      fc.property(step, step, step, step, (ax, ay, bx, by) => {
        const left = bankOf(ax, ay, bx, by);
        expect(Math.abs(left)).toBeLessThan(Math.PI / 2);
        // A turn right about is either.
        if (Math.abs(ax * by - ay * bx) > 1e-9) expect(bankOf(ax, -ay, bx, -by)).toBeCloseTo(-left, 9);
      }),
    );
  });
});
