import { expect, test } from "vitest";
import { SegmentMotion } from "../playback/motion";
import { motionNow } from "./subject";

const motion = new SegmentMotion(Float64Array.of(0, 1), new Float32Array(4), 1);
const planning = { kind: "planning", progress: 0.5, motion, stale: null } as const;

test("a motion plays as soon as it is there; that of a scene before is no motion of this one", () => {
  expect(motionNow({ ...planning, isCurrent: true })).toBe(motion);
  expect(motionNow({ ...planning, isCurrent: false })).toBeNull();
  expect(motionNow({ kind: "canceled" })).toBeNull();
});
