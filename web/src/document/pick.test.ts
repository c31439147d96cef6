import { expect, test } from "vitest";
import { addAgents } from "./commands/agents";
import { makeGroup } from "./commands/groups";
import { emptyScene } from "./defaults";
import { outside, picked, pickedInside } from "./pick";
import { NOTHING, type Selection } from "./selection";

/** Agents 0–3 in a group, of whom 0 and 1 in a group within; 4 and 5 in another; 6 alone. */
function scene() {
  const places = Array.from({ length: 7 }, (_, agent) => [agent, 0] as const);
  const groups = [
    [0, 1, 2, 3],
    [0, 1],
    [4, 5],
  ].map((agents) => makeGroup(new Set(agents)));
  return groups.reduce((made, command) => command.apply(made), addAgents(places).apply(emptyScene()));
}

const agents = (...list: number[]): Selection => ({ kind: "agents", agents: new Set(list) });
const group = (...path: number[]): Selection => ({ kind: "group", path });

test("from outside a click picks the outermost group, and an agent that is in none", () => {
  for (const before of [NOTHING, group(1), agents(6), agents(0, 6), agents(4, 5)]) {
    expect(picked(scene(), before, 1)).toEqual(group(0));
    expect(picked(scene(), before, 6)).toEqual(agents(6));
  }
});

test("each double click goes a step inside, down to the agent", () => {
  const steps = [group(0)];
  for (let step = 0; step < 3; step += 1) steps.push(pickedInside(scene(), steps[step] ?? NOTHING, 1));
  expect(steps).toEqual([group(0), group(0, 0), agents(1), agents(1)]);
});

test("inside a group a click picks among what is beside the selection", () => {
  expect(picked(scene(), group(0, 0), 2)).toEqual(agents(2));
  expect(picked(scene(), agents(2), 1)).toEqual(group(0, 0));
  expect(picked(scene(), agents(1), 0)).toEqual(agents(0));
  expect(picked(scene(), agents(1), 4)).toEqual(group(1));
});

test("stepping out selects the group around, then nothing", () => {
  expect(outside(scene(), agents(1))).toEqual(group(0, 0));
  expect(outside(scene(), group(0, 0))).toEqual(group(0));
  expect(outside(scene(), group(0))).toEqual(NOTHING);
  expect(outside(scene(), agents(6))).toEqual(NOTHING);
  expect(outside(scene(), { kind: "transition", index: 0 })).toEqual(NOTHING);
});
