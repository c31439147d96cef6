import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { advance, playedSpan, startFrom, within } from "./playhead";

const SHOW = { from: 0, to: 10 };

describe("playhead", () => {
  it("stops exactly at the end", () => {
    expect(advance(9.9, 0.2, SHOW, false)).toBe(10);
    expect(advance(9, 0.5, SHOW, false)).toBe(9.5);
  });

  it("a loop comes round without losing time, however long the frame was", () => {
    fc.assert(
      fc.property(
        fc.double({ min: 2, max: 6, noNaN: true, maxExcluded: true }),
        fc.double({ min: 0, max: 1000, noNaN: true }),
        (time, elapsed) => {
          const after = advance(time, elapsed, { from: 2, to: 6 }, true);
          expect(after).toBeGreaterThanOrEqual(2);
          expect(after).toBeLessThan(6);
          const rounds = (time + elapsed - after) / 4;
          // Rounding of the remainder, relative to the thousand seconds that went by.
          expect(Math.abs(rounds - Math.round(rounds))).toBeLessThan(1e-9);
        },
      ),
    );
  });

  it("a loop without length goes nowhere", () => {
    expect(advance(0, 0.1, { from: 0, to: 0 }, true)).toBe(0);
  });

  it("a clock that runs backward does not", () => {
    expect(advance(3, -1, SHOW, false)).toBe(3);
  });

  it("play at the end starts over", () => {
    expect(startFrom(10, SHOW, false)).toBe(0);
    expect(startFrom(4, SHOW, false)).toBe(4);
  });

  it("a loop is entered at its start unless the playhead is inside", () => {
    const loop = { from: 2, to: 6 };
    expect(startFrom(0, loop, true)).toBe(2);
    expect(startFrom(8, loop, true)).toBe(2);
    expect(startFrom(5, loop, true)).toBe(5);
  });

  it("a range shows as far as the show reaches", () => {
    expect(playedSpan({ from: 8, to: 3 }, 5)).toEqual({ from: 3, to: 5 });
    expect(playedSpan({ from: 7, to: 9 }, 5)).toEqual({ from: 0, to: 5 });
    expect(playedSpan(null, 5)).toEqual({ from: 0, to: 5 });
  });

  it("no time is the beginning", () => {
    expect(within(Number.NaN, SHOW)).toBe(0);
    expect(within(Number.POSITIVE_INFINITY, SHOW)).toBe(10);
  });
});
