import { describe, expect, it } from "vitest";
import { keyframeAt } from "../document/defaults";
import { Formation } from "../document/formation";
import type { Keyframe, Track } from "../document/scene";
import { Show } from "../playback/show";
import { Onion } from "./onion";

function keyframe(time: number, hold: number): Keyframe {
  return { ...keyframeAt(time, Formation.from([[time, 0]])), hold };
}

const track: Track = {
  agents: [{ name: "", color: "", radius: 0.25, maxSpeed: null }],
  keyframes: [keyframe(0, 0), keyframe(4, 2), keyframe(8, 0)],
  segments: [],
};
const show = new Show(track, []);

/** Times of the keyframes that the onion skin shows at `time`. */
function skinAt(time: number): [from: number | undefined, to: number | undefined] {
  const onion = new Onion();
  onion.take(track, show, time);
  return [onion.from?.positions.x(0), onion.to?.positions.x(0)];
}

describe("onion skin", () => {
  it("under way shows where the agents come from and go to", () => {
    expect(skinAt(1)).toEqual([0, 4]);
    expect(skinAt(7)).toEqual([4, 8]);
  });

  it("standing shows the formations before and after", () => {
    expect(skinAt(0)).toEqual([undefined, 4]);
    expect(skinAt(5)).toEqual([0, 8]);
    expect(skinAt(9)).toEqual([4, undefined]);
  });

  it("tells when it changed, so that it is drawn only then", () => {
    const onion = new Onion();
    expect(onion.take(track, show, 1)).toBe(true);
    expect(onion.take(track, show, 3)).toBe(false);
    expect(onion.take(track, show, 5)).toBe(true);
  });
});
