import { expect, test } from "vitest";
import { emptyScene } from "../defaults";
import { groupLabel } from "../queries";
import { addAgents } from "./agents";
import { makeGroup } from "./groups";
import { takeProposal } from "./propose";

const leaf = (...members: number[]) => ({ members, children: [] });
const six = addAgents(Array.from({ length: 6 }, (_, agent) => [agent, 0] as const)).apply(emptyScene());
const sets = (groups: readonly { readonly members: readonly number[] }[]) => groups.map((group) => group.members);

test("proposed groups take the place of those their agents were in", () => {
  const before = makeGroup(new Set([0, 1, 2])).apply(makeGroup(new Set([4, 5])).apply(six));
  const after = takeProposal([], [leaf(0, 1), leaf(2, 3)]).apply(before);
  expect(sets(after.groups)).toEqual([
    [4, 5],
    [0, 1],
    [2, 3],
  ]);
  expect(groupLabel(after, [1])).toBe("Group 2");
});

test("a group is divided within, and keeps whom nobody took", () => {
  const before = makeGroup(new Set([0, 1, 2, 3, 4]), "Brass").apply(six);
  const after = takeProposal([0], [{ members: [], children: [leaf(0), leaf(3)] }, leaf(1, 2)]).apply(before);
  const [brass] = after.groups;
  expect(brass).toMatchObject({ name: "Brass", members: [4] });
  expect(sets(brass?.children ?? [])).toEqual([[], [1, 2]]);
  expect(sets(brass?.children[0]?.children ?? [])).toEqual([[0], [3]]);
});

test("a proposal of nobody, or of agents of another group, changes nothing", () => {
  const before = makeGroup(new Set([0, 1])).apply(six);
  expect(takeProposal([], []).apply(before)).toBe(before);
  expect(takeProposal([0], [leaf(1, 2)]).apply(before)).toBe(before);
});
