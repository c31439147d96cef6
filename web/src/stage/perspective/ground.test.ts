import { describe, expect, it } from "vitest";
import { toScreen } from "../camera";
import { groundPicture } from "./ground";

const SHEETS = {
  field: { minX: -54.864, maxX: 54.864, minY: -24.384, maxY: 24.384 },
  theater: { minX: -6, maxX: 6, minY: -4, maxY: 4 },
  corridor: { minX: -1, maxX: 1, minY: -80, maxY: 80 },
};

describe("the ground's picture", () => {
  it.each(Object.entries(SHEETS))("holds all of the sheet with a margin and fits the device: %s", (_, sheet) => {
    const { camera, size, density, bounds } = groundPicture(sheet, 2048);
    const back = toScreen(camera, [sheet.minX, sheet.maxY]);
    const front = toScreen(camera, [sheet.maxX, sheet.minY]);
    for (const margin of [back.x, back.y, size.width - front.x, size.height - front.y])
      expect(margin).toBeCloseTo(48, 6);
    expect(Math.max(size.width, size.height) * density).toBeCloseTo(2048, 6);
    expect(bounds.minX).toBeLessThan(sheet.minX);
  });

  it.each(Object.entries(SHEETS))("lies where its lines belong: %s", (_, sheet) => {
    const { camera, size, bounds } = groundPicture(sheet, 2048);
    // A place's share of the picture is its share of the ground that the picture covers.
    const at = toScreen(camera, [sheet.maxX / 2, sheet.minY / 3]);
    expect(at.x / size.width).toBeCloseTo((sheet.maxX / 2 - bounds.minX) / (bounds.maxX - bounds.minX), 9);
    expect(1 - at.y / size.height).toBeCloseTo((sheet.minY / 3 - bounds.minY) / (bounds.maxY - bounds.minY), 9);
  });
});
