import { expect, test } from "vitest";
import { emptyScene } from "../defaults";
import { groupWithSet } from "../group-with-set";
import { groupAt } from "../groups";
import { addAgents } from "./agents";
import { tieAgents } from "./tie-agents";

const four = addAgents([
  [0, 0],
  [1, 0],
  [0, 1],
  [1, 1],
]).apply(emptyScene());

test("agents without a group of their own get one, with the factor", () => {
  const agents = new Set([0, 1, 2]);
  const tied = tieAgents(agents, 10).apply(four);
  expect(groupAt(tied.groups, groupWithSet(tied.groups, agents) ?? [])?.tieWeight).toBe(10);
});

test("the group of exactly these agents gets the factor, and no second group is made", () => {
  const agents = new Set([1, 3]);
  const once = tieAgents(agents, 10).apply(four);
  const twice = tieAgents(agents, 50).apply(once);
  expect(twice.groups).toHaveLength(1);
  expect(twice.groups[0]?.tieWeight).toBe(50);
});

test("nobody tied leaves the scene as it was", () => {
  expect(tieAgents(new Set(), 10).apply(four)).toBe(four);
});
