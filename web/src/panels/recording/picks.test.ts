import { describe, expect, test } from "vitest";
import { mainTrack } from "../../document/scene";
import { Recording } from "../../engine/recording";
import { presentInAll, sceneOf, shiftOf, whyNot, withPick } from "./picks";

/** Three agents at ten frames a second: one walks, one comes in frame 2, one goes after frame 2. */
function recorded(): Recording {
  const numbers: number[] = [];
  for (let frame = 0; frame < 5; frame += 1) {
    numbers.push(10 + frame, 4);
    numbers.push(...(frame < 2 ? [Number.NaN, Number.NaN] : [12, 6.1234]));
    numbers.push(...(frame > 2 ? [Number.NaN, Number.NaN] : [14, 8]));
  }
  return new Recording(10, ["Ada", "Bo", "Cy"], Float32Array.from(numbers), []);
}

describe("picking frames", () => {
  test("keeps them in the order of time, each once", () => {
    expect(withPick(withPick([3], 1), 3)).toEqual([1, 3]);
  });

  test("takes only those who are there in all of them", () => {
    expect(presentInAll(recorded(), [0, 2])).toEqual([0, 2]);
    expect(presentInAll(recorded(), [0, 4])).toEqual([0]);
    expect(presentInAll(recorded(), [2])).toEqual([0, 1, 2]);
  });

  test("says why no scene can be made", () => {
    const recording = recorded();
    expect(whyNot(recording, [])).toContain("at least one");
    expect(whyNot(recording, [0, 2])).toBeNull();
    const fast = new Recording(50, ["Ada"], new Float32Array(20), []);
    expect(whyNot(fast, [0, 1])).toContain("apart");
    const gone = new Recording(1, ["Ada"], Float32Array.of(Number.NaN, Number.NaN), []);
    expect(whyNot(gone, [0])).toContain("Nobody");
  });
});

describe("the scene of picked frames", () => {
  const scene = sceneOf(recorded(), [1, 2], "walk.txt");
  const { agents, keyframes, segments } = mainTrack(scene);

  test("has a keyframe a frame, counted from the first one picked", () => {
    expect(keyframes.map(({ time }) => time)).toEqual([0, 0.1]);
    expect(segments).toHaveLength(1);
    expect(scene.frameRate).toBe(10);
  });

  test("calls agents as the recording does", () => {
    expect(agents.map(({ name }) => name)).toEqual(["Ada", "Cy"]);
  });

  test("stands in the middle of a stage that holds all of the recording", () => {
    expect(shiftOf(recorded())).toEqual([-12, -6]);
    expect([...(keyframes[0]?.positions.xy ?? [])]).toEqual([-1, -2, 2, 2]);
    expect(scene.stage.width).toBeGreaterThanOrEqual(4);
  });
});

test("a recording finds its frames by time and never leaves its ends", () => {
  const recording = recorded();
  expect(recording.frameCount).toBe(5);
  expect(recording.duration).toBeCloseTo(0.4);
  expect([-1, 0.16, 99].map((time) => recording.frameAt(time))).toEqual([0, 2, 4]);
});
