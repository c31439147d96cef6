import { expect, test } from "vitest";
import { addAgents, renameAgent } from "./commands/agents";
import { makeGroup } from "./commands/groups";
import { duplicateKeyframe } from "./commands/keyframes";
import { emptyScene } from "./defaults";
import { brokenLimit, LIMITS, mostAgents } from "./limits";
import { placementAt } from "./placement";
import { agentLabel, groupLabel, selectedAgents } from "./queries";
import { mainTrack, type Scene } from "./scene";
import { NOTHING } from "./selection";

const show: Scene = [
  addAgents([
    [0, 0],
    [1, 0],
    [2, 0],
  ]),
  duplicateKeyframe(0),
  renameAgent(1, "Ada"),
  makeGroup(new Set([0, 1])),
].reduce((scene, command) => command.apply(scene), emptyScene());

test("people read names, and numbers from 1 where there are none", () => {
  expect([0, 1, 2].map((agent) => agentLabel(show, agent))).toEqual(["1", "Ada", "3"]);
  expect(groupLabel(show, [0])).toBe("Group 1");
});

test("agents are made at the first keyframe; later ones place the selected, else all, and say so", () => {
  expect(placementAt(show, 0, NOTHING)).toEqual({ kind: "add" });
  expect(placementAt(emptyScene(), 0, NOTHING)).toEqual({ kind: "add" });
  expect(placementAt(show, 1, NOTHING)).toMatchObject({ kind: "place", agents: [0, 1, 2] });
  expect(placementAt(show, 1, { kind: "group", path: [0] })).toMatchObject({ kind: "place", agents: [0, 1] });
  expect(placementAt(show, 1, { kind: "keyframe", index: 1 })).toMatchObject({ agents: [0, 1, 2] });
});

test("a selection stands for its agents", () => {
  expect(selectedAgents(show, { kind: "group", path: [0] })).toEqual(new Set([0, 1]));
  expect(selectedAgents(show, { kind: "tie", a: 1, b: 2 })).toEqual(new Set([1, 2]));
  expect(selectedAgents(show, { kind: "transition", index: 0 }).size).toBe(0);
});

test("as many agents as there is room for break no limit, one more does", () => {
  const cases: readonly Partial<Scene>[] = [{}, { frameRate: 120 }];
  for (const change of cases) {
    for (const keyframeCount of [1, 2, 60]) {
      const track = mainTrack(emptyScene());
      const keyframes = Array.from({ length: keyframeCount }, (_, i) => ({
        ...(track.keyframes[0] ?? never()),
        time: i,
      }));
      const scene = { ...emptyScene(), ...change, tracks: [{ ...track, keyframes }] };
      const most = mostAgents(scene);
      const withAgents = (count: number): Scene => ({
        ...scene,
        tracks: [
          {
            ...track,
            keyframes,
            agents: Array.from({ length: count }, () => ({ name: "", color: "", radius: 0.25, maxSpeed: null })),
          },
        ],
      });
      expect(most).toBeLessThanOrEqual(LIMITS.agents);
      expect(brokenLimit(withAgents(most))).toBeNull();
      expect(brokenLimit(withAgents(most + 1))).not.toBeNull();
    }
  }
});

function never(): never {
  throw new Error("a scene has a keyframe");
}
