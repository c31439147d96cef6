import { describe, expect, it } from "vitest";
import { keyframePlaces, nameWidths, transitionPlaces } from "./layout";

const SCALE = { origin: 62, pixelsPerSecond: 20 };
const PILE = [0, 0.2, 0.2, 0.5, 0.9, 1.5, 12, 20, 24, 40];

const placesAt = (times: readonly number[]) =>
  keyframePlaces(
    times.map((time) => ({ time, hold: 0 }) as Parameters<typeof keyframePlaces>[0][number]),
    SCALE,
  );

describe("the timeline's places", () => {
  it("every transition can be hit, whatever lies over its thumbnails", () => {
    const places = transitionPlaces(placesAt(PILE));
    expect(places).toHaveLength(PILE.length - 1);
    for (const { width } of places) expect(width).toBeGreaterThanOrEqual(8);
    const marks = places.filter((place) => place.isMark);
    expect(marks).toHaveLength(6);
    marks.slice(1).forEach(({ left }, k) => {
      expect(left).toBeGreaterThanOrEqual((marks[k]?.left ?? 0) + (marks[k]?.width ?? 0));
    });
  });

  it("no name is printed over another, and that of the chosen keyframe stays", () => {
    const places = placesAt(PILE);
    for (const first of PILE.keys()) {
      const widths = nameWidths(places, first);
      expect(widths[first]).toBeGreaterThanOrEqual(44);
      const shown = places.flatMap(({ x }, k) => {
        const half = (widths[k] ?? 0) / 2;
        return half > 0 ? [{ from: x - half, to: x + half }] : [];
      });
      shown.slice(1).forEach(({ from }, k) => {
        expect(from).toBeGreaterThan(shown[k]?.to ?? 0);
      });
    }
  });

  it("names with room are whole", () => {
    expect(nameWidths(placesAt([0, 6, 12]), 0)).toEqual([104, 104, 104]);
  });
});
