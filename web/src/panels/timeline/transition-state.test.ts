import { expect, test } from "vitest";
import type { SegmentPlan } from "../../engine/api";
import { SegmentMotion } from "../../playback/motion";
import { ribbonName } from "./ribbon-name";
import { transitionState } from "./transition-state";

function plan(distance: number | null): SegmentPlan {
  const curve = new Float32Array(2);
  const none = { mean: 0, max: 0 };
  return {
    motion: new SegmentMotion(new Float64Array([0, 1]), new Float32Array(4), 1),
    curves: { clearance: curve, distortion: curve, turning: curve, topSpeed: curve, pathLength: curve },
    report: {
      choice: { method: "polar", order: "greedy", alignment: "pca", sharing: 0.5 },
      distortion: none,
      turning: none,
      clearance: distance === null ? null : { distance, time: 0.5, agents: [0, 1] },
      nearCollisions: 0,
      pathLength: none,
      topSpeed: { speed: 0, time: 0, agent: 0 },
      rmsRadius: { min: 0, max: 0 },
      candidates: [],
    },
  };
}

test.each([
  [1.2, "holds"],
  [1.05, "tight"],
  [0.9, "clash"],
])("a planned transition with %d m of 1 m clearance says its method and %s", (distance, status) => {
  const state = transitionState({ kind: "ready", plan: plan(distance) }, 1);
  expect(state).toMatchObject({ status, words: "Polar", progress: null });
});

test("while it is planned anew a transition keeps its last shape and says how far the planning is", () => {
  const state = transitionState(
    { kind: "planning", progress: 0.629, motion: null, isCurrent: false, stale: plan(0.9) },
    1,
  );
  expect(state).toMatchObject({ status: "clash", words: "Planning, 62 %", progress: 0.629 });
});

test("a transition never planned before has no status yet", () => {
  const state = transitionState({ kind: "planning", progress: 0, motion: null, isCurrent: false, stale: null }, 1);
  expect(state).toMatchObject({ status: "none", plan: null, words: "Planning, 0 %" });
});

test("a canceled and a failed transition say so", () => {
  const problem = { code: "engine-stopped", what: "The engine stopped.", where: "" };
  expect(transitionState({ kind: "canceled" }, 1).words).toBe("Canceled");
  expect(transitionState({ kind: "failed", problem }, 1).words).toBe("Not planned");
});

test("what clashed before avoidance is remembered, and what did not is not", () => {
  const now = plan(1.3);
  const guide = (distance: number) => ({
    ...now,
    report: { ...now.report, guideClearance: { distance, time: 0.4, agents: [0, 1] as const } },
  });
  expect(transitionState({ kind: "ready", plan: guide(0.2) }, 1).before).toMatchObject({ distance: 0.2, time: 0.4 });
  expect(transitionState({ kind: "ready", plan: guide(1.2) }, 1).before).toBeNull();
  expect(transitionState({ kind: "ready", plan: now }, 1).before).toBeNull();
});

test("whoever could not be led around an obstacle is what comes nearest", () => {
  const now = plan(1.3);
  const blocked = [{ distance: -0.2, time: 0.7, agent: 0, obstacle: 0 }];
  const state = transitionState({ kind: "ready", plan: { ...now, report: { ...now.report, blocked } } }, 1);
  expect(state).toMatchObject({ status: "clash", closest: { distance: -0.2, time: 0.7 } });
});

test.each([
  [1, "Transition A to B: Polar, holds, clearance 1.14 m"],
  [2, "Transition A to B: Polar, clash, clearance 1.14 m at 0:00.5"],
  [0, "Transition A to B: Polar, clearance 1.14 m at 0:00.5"],
])("with a minimum distance of %d m a ribbon is called %s", (minimum, name) => {
  expect(ribbonName("A to B", transitionState({ kind: "ready", plan: plan(1.14) }, minimum), "1.14 m")).toBe(name);
});

test("agents who meet have a clearance of nothing; who is within an obstacle has none", () => {
  const met = transitionState({ kind: "ready", plan: plan(0) }, 1);
  expect(ribbonName("A to B", met, "0.00 m")).toBe("Transition A to B: Polar, clash, clearance 0.00 m at 0:00.5");
  const now = plan(1.3);
  const blocked = [{ distance: -0.2, time: 0.7, agent: 0, obstacle: 0 }];
  const within = transitionState({ kind: "ready", plan: { ...now, report: { ...now.report, blocked } } }, 1);
  expect(ribbonName("A to B", within, "inside")).toBe("Transition A to B: Polar, clash, inside at 0:00.7");
});
