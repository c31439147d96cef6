import { expect, test } from "vitest";
import { emptyScene } from "../defaults";
import { Formation } from "../formation";
import { mainTrack, type Scene } from "../scene";
import { addAgents, deleteAgents } from "./agents";
import { dissolveGroup, makeGroup, nestGroup, renameGroup } from "./groups";
import { addKeyframe } from "./keyframes";
import { nodeAt, setNode } from "./nodes";

const PLACES = Array.from({ length: 6 }, (_, agent) => [agent, 0] as const);
const LINEAR = { method: "linear", blend: null } as const;
const POLAR = { method: "polar", blend: { method: "linear", amount: 0.3 } } as const;

/** Groups of agents 0–1, 2–3 and 4–5; the second moves straight, everybody as polar says. */
function scene(): Scene {
  const commands = [
    addAgents(PLACES),
    addKeyframe(0, Formation.from(PLACES)),
    ...[0, 2, 4].map((agent) => makeGroup(new Set([agent, agent + 1]))),
    setNode(0, [1], LINEAR),
    setNode(0, [], POLAR),
  ];
  return commands.reduce((made, command) => command.apply(made), emptyScene());
}

const paths = (of: Scene) => mainTrack(of).segments[0]?.nodes.map((node) => node.group);

test("a group's way is set, changed and taken back", () => {
  const changed = setNode(0, [1], POLAR).apply(scene());
  const [segment] = mainTrack(changed).segments;
  expect(segment && nodeAt(segment, [1])).toEqual({ group: [1], ...POLAR });
  expect(paths(setNode(0, [1], null).apply(changed))).toEqual([[]]);
  expect(setNode(0, [2], null).apply(changed)).toBe(changed);
});

test("a group keeps its way wherever it goes in the tree", () => {
  expect(paths(dissolveGroup([0]).apply(scene()))).toEqual([[0], []]);
  expect(paths(nestGroup([1], [2]).apply(scene()))).toEqual([[1, 0], []]);
  expect(paths(renameGroup([1], "Brass").apply(scene()))).toEqual([[1], []]);
  expect(paths(deleteAgents(new Set([0, 1])).apply(scene()))).toEqual([[0], []]);
});

test("the way of a group that is gone goes with it", () => {
  expect(paths(dissolveGroup([1]).apply(scene()))).toEqual([[]]);
  expect(paths(deleteAgents(new Set([2, 3])).apply(scene()))).toEqual([[]]);
});
