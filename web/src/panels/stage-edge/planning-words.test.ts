import { expect, test } from "vitest";
import { emptyScene } from "../../document/defaults";
import type { Planning } from "../../engine/api";
import { transitionState } from "../timeline/transition-state";
import { planningWords } from "./planning-words";

const canceled: Planning = { kind: "canceled" };

function planning(progress: number): Planning {
  return { kind: "planning", progress, motion: null, isCurrent: false, stale: null };
}

test("one transition is as far here as on its ribbon, whatever else is ready", () => {
  const only = planning(0.309);
  const { progress, percent } = planningWords(emptyScene(), [canceled, only], 0.65);
  expect([progress, percent]).toEqual([0.309, "30 %"]);
  expect(transitionState(only, 1).words).toContain(percent);
});

test("several say that theirs is the progress of all", () => {
  expect(planningWords(emptyScene(), [planning(0.1), canceled, planning(0.2)], 0.43)).toEqual({
    what: "2 transitions",
    progress: 0.43,
    percent: "43 % of all",
  });
});
