import { describe, expect, it } from "vitest";
import { type Camera, toScreen } from "./camera";
import { handleAt, handlePlace, handlesOf, SCALE_HANDLES, scaleAnchor, selectionBounds, selectionBox } from "./handles";
import { liftsOf } from "./lifts";

const camera: Camera = { scale: 20, left: 400, top: 300 };
const xy = [0, 0, 4, 2, -3, 5, 100, 100];
const bounds = selectionBounds(xy, [0, 1, 2]) ?? { minX: 0, minY: 0, maxX: 0, maxY: 0 };
const box = selectionBox(bounds, camera, 8);

describe("handles", () => {
  it("the box surrounds every selected disc and no more than 12 px beyond, give or take the rounding", () => {
    const [left, front] = [toScreen(camera, [-3, 0]).x, toScreen(camera, [-3, 0]).y];
    expect(Math.abs(box.left - (left - 20))).toBeLessThanOrEqual(0.5);
    expect(Math.abs(box.bottom - (front + 20))).toBeLessThanOrEqual(0.5);
    expect(box.right).toBeGreaterThan(toScreen(camera, [4, 2]).x + 8);
    expect(box.top).toBeLessThan(toScreen(camera, [-3, 5]).y - 8);
  });

  it("nobody selected has no bounds, and agents that are gone do not count", () => {
    expect(selectionBounds(xy, [])).toBeNull();
    expect(selectionBounds(xy, [17])).toBeNull();
  });

  it("every handle is found where it is drawn", () => {
    const handles = handlesOf(box, "boxes");
    expect(handles).toContain("lift");
    for (const handle of handles) expect(handleAt(box, handles, handlePlace(box, handle), 9)).toBe(handle);
  });

  it("one agent can be pulled up where the show has heights, and from the front nobody need be", () => {
    const alone = selectionBox({ minX: 1, minY: 1, maxX: 1, maxY: 1 }, camera, 8);
    expect(handlesOf(alone, liftsOf("plan", true))).toEqual(["lift"]);
    expect(handlesOf(alone, liftsOf("plan", false))).toEqual([]);
    expect(handlesOf(box, liftsOf("front", true))).not.toContain("lift");
  });

  it("the middle of the box is no handle", () => {
    expect(
      handleAt(box, handlesOf(box, "boxes"), { x: (box.left + box.right) / 2, y: (box.top + box.bottom) / 2 }, 9),
    ).toBeNull();
  });

  it("what a handle scales about lies across the box from it", () => {
    for (const handle of SCALE_HANDLES) {
      const place = handlePlace(box, handle);
      const anchor = toScreen(camera, scaleAnchor(bounds, handle));
      const middle = { x: (box.left + box.right) / 2, y: (box.top + box.bottom) / 2 };
      const across = (place.x - middle.x) * (anchor.x - middle.x) + (place.y - middle.y) * (anchor.y - middle.y);
      expect(across).toBeLessThan(0);
    }
  });
});
