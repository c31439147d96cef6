import { signal } from "@preact/signals";
import { expect, test } from "vitest";
import { addAgents, moveAgents } from "../document/commands/agents";
import { addKeyframe } from "../document/commands/keyframes";
import { emptyScene } from "../document/defaults";
import { Formation } from "../document/formation";
import type { Scene } from "../document/scene";
import { createPlanner } from "./create-planner";
import type { WorkerLink } from "./link";
import type { PlanMessage } from "./protocol";

function twoFormations(): Scene {
  const scene = addAgents([
    [0, 0],
    [4, 0],
  ]).apply(emptyScene());
  return addKeyframe(
    0,
    Formation.from([
      [0, 4],
      [4, 4],
    ]),
  ).apply(scene);
}

/** A planner whose worker says what it is told to, of its newest errand. */
function planning() {
  const scene = signal(twoFormations());
  const isDragging = signal(false);
  let errand = 0;
  const link = {
    isDead: false,
    ledger: { message: () => "" },
    onPlan: (_: PlanMessage) => {},
    call() {
      errand += 1;
      return { id: errand, answer: new Promise(() => {}) };
    },
  };
  const crew = { planner: signal(link as unknown as WorkerLink), replacePlanner() {} };
  const planner = createPlanner({ scene, isDragging, time: signal(0), crew });
  return {
    scene,
    moved() {
      const motion = { times: Float64Array.of(0, 4), xy: new Float32Array(8), heights: null };
      link.onPlan({ kind: "moved", plan: errand, segment: 0, motion });
    },
    state() {
      const state = planner.segments.value[0];
      if (state?.kind !== "planning") throw new Error("it is still planning");
      return state;
    },
  };
}

test("a motion is current from when it is there, before its numbers, until the scene is another", () => {
  const { scene, moved, state } = planning();
  expect(state()).toMatchObject({ motion: null, isCurrent: false });
  moved();
  expect(state().motion).not.toBeNull();
  expect(state().isCurrent).toBe(true);
  scene.value = moveAgents(1, new Set([0]), [1, 0], "Move agents").apply(scene.value);
  expect(state().motion).not.toBeNull();
  expect(state().isCurrent).toBe(false);
  moved();
  expect(state().isCurrent).toBe(true);
});
