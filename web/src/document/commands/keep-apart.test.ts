import { expect, test } from "vitest";
import { emptyScene } from "../defaults";
import { Formation } from "../formation";
import { mainTrack, type Scene } from "../scene";
import { keepApart } from "./keep-apart";
import { addKeyframe } from "./keyframes";

function table(minimumDistance: number): Scene {
  const one = Formation.from([]);
  const scene = { ...emptyScene(), minimumDistance };
  const show = addKeyframe(4, one).apply(addKeyframe(2, one).apply(scene));
  return {
    ...show,
    tracks: [{ ...mainTrack(show), segments: mainTrack(show).segments.map((was) => ({ ...was, avoidance: false })) }],
  };
}

test("a table's agents keep apart on every way, at the distance asked", () => {
  const kept = keepApart(0.5).apply(table(0));
  expect(kept.minimumDistance).toBe(0.5);
  expect(mainTrack(kept).segments.map(({ avoidance }) => avoidance)).toEqual([true, true]);
});

test("a scene with a distance of its own keeps it, and one formation needs none", () => {
  const own = table(1.2);
  expect(keepApart(0.5).apply(own)).toBe(own);
  const still = { ...emptyScene(), minimumDistance: 0 };
  expect(keepApart(0.5).apply(still)).toBe(still);
});
