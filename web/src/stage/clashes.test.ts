import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { ClashFinder } from "./clashes";

function found(finder: ClashFinder): [number, number][] {
  return finder.found.slice(0, finder.count).map(({ a, b }) => [a, b]);
}

describe("clashes", () => {
  const coordinate = fc.double({ min: -5, max: 5, noNaN: true });
  const crowds = fc.array(fc.tuple(coordinate, coordinate), { minLength: 0, maxLength: 9 });

  it("are all pairs that are too close, worst first, frame after frame", () => {
    fc.assert(
      fc.property(fc.array(crowds, { minLength: 1, maxLength: 4 }), (frames) => {
        const finder = new ClashFinder();
        for (const agents of frames) {
          const places = Float32Array.from(agents.flat());
          finder.find(places, 2);
          const expected: number[] = [];
          for (let a = 0; a < agents.length; a += 1) {
            for (let b = a + 1; b < agents.length; b += 1) {
              const [dx, dy] = [0, 1].map((k) => (places[2 * a + k] ?? 0) - (places[2 * b + k] ?? 0));
              const distance = Math.hypot(dx ?? 0, dy ?? 0);
              if (distance < 2 * (1 - 1e-4)) expected.push(distance);
            }
          }
          expected.sort((x, y) => x - y);
          const distances = finder.found.slice(0, finder.count).map((clash) => clash.distance);
          expect(distances.length).toBe(expected.length);
          // Square roots may be rounded differently here and there.
          for (const [k, distance] of distances.entries()) expect(distance).toBeCloseTo(expected[k] ?? 0, 12);
        }
      }),
    );
  });

  it("agents exactly at the minimum distance do not clash", () => {
    const finder = new ClashFinder();
    finder.find(Float32Array.of(0.1, 0, 0.6, 0, 1.1, 0), 0.5);
    expect(found(finder)).toEqual([]);
  });

  it("without a minimum distance nobody clashes", () => {
    const finder = new ClashFinder();
    finder.find(new Float32Array(8), 0);
    expect(finder.count).toBe(0);
  });

  it("a heap shows its worst and no more than it can", () => {
    const finder = new ClashFinder();
    finder.find(
      Float32Array.from({ length: 200 }, (_, k) => (k % 2 === 0 ? k / 1000 : 0)),
      1,
    );
    expect(finder.count).toBe(finder.found.length);
    const distances = finder.found.map((clash) => clash.distance);
    expect(distances).toEqual([...distances].sort((a, b) => a - b));
  });
});

it("who is gone is too near to nobody", () => {
  const finder = new ClashFinder();
  const row = Float32Array.from([0, 0, 0.1, 0, 0.2, 0]);
  finder.find(row, 0.15, null, Uint8Array.from([0, 1, 0]));
  expect(finder.count).toBe(0);
  finder.find(row, 0.15, null, Uint8Array.from([0, 0, 1]));
  expect(finder.found[0]).toMatchObject({ a: 0, b: 1 });
});
