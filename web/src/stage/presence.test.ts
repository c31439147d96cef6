import { expect, test } from "vitest";
import { DEFAULT_SEGMENT } from "../document/defaults";
import { Formation } from "../document/formation";
import type { Track } from "../document/scene";
import { Show } from "../playback/show";
import { presenceInto, traceOfGone } from "./presence";

const stand = (time: number, absent: readonly number[]) => ({
  name: "",
  time,
  hold: 1,
  corner: false,
  between: 0,
  positions: Formation.from([
    [0, 0],
    [1, 0],
    [2, 0],
    [3, 0],
  ]),
  absent,
  adjacency: null,
});

/** One stays, one leaves, one comes, and one is away. */
const track: Track = {
  agents: [],
  keyframes: [stand(0, [2, 3]), stand(5, [1, 3])],
  segments: [DEFAULT_SEGMENT],
};

function presenceAt(time: number): number[] {
  const out = new Float32Array(4);
  presenceInto(out, track, new Show(track, []), time);
  return [...out];
}

test("nobody appears or is gone from one moment to the next, and who stays is there throughout", () => {
  expect(presenceAt(0.5)).toEqual([1, 1, 0, 0]);
  expect(presenceAt(5.5)).toEqual([1, 0, 1, 0]);
  const step = 0.01;
  let before = presenceAt(0);
  for (let time = step; time <= 6; time += step) {
    const now = presenceAt(time);
    const most = Math.max(...now.map((share, agent) => Math.abs(share - (before[agent] ?? 0))));
    expect(most).toBeLessThan(0.02);
    expect(now[1]).toBeLessThanOrEqual(before[1] ?? 0);
    expect(now[2]).toBeGreaterThanOrEqual(before[2] ?? 0);
    expect([now[0], now[3]]).toEqual([1, 0]);
    before = now;
  }
});

test("the trace of who is absent at both ends goes and comes by and by, and is not there halfway", () => {
  expect(traceOfGone(null)).toBe(1);
  expect(traceOfGone(0.5)).toBe(0);
  const step = 0.01;
  let before = traceOfGone(null);
  for (let share = 0; share <= 1 + step / 2; share += step) {
    const now = traceOfGone(Math.min(share, 1));
    // The steepest place of a smoothstep is one and a half times as steep as the straight way over half of the time.
    expect(Math.abs(now - before)).toBeLessThan(1.5 * 2 * step + 1e-9);
    if (share <= 0.5) expect(now).toBeLessThanOrEqual(before + 1e-9);
    before = now;
  }
  expect(before).toBeCloseTo(1, 6);
});
