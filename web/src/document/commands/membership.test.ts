import { expect, test } from "vitest";
import { emptyScene } from "../defaults";
import type { Group, Scene } from "../scene";
import { addAgents } from "./agents";
import { membershipOf, memberships, moveToGroup } from "./membership";

function group(name: string, members: number[], children: Group[] = []): Group {
  return { name, color: "", members, tieWeight: null, children };
}

const scene: Scene = {
  ...addAgents(Array.from({ length: 4 }, (_, agent) => [agent, 0] as const)).apply(emptyScene()),
  groups: [group("Band", [0], [group("Brass", [1])]), group("Guard", [2])],
};

test("a group within another is listed with the one around it", () => {
  expect(memberships(scene).map((entry) => entry.label)).toEqual(["None", "Band", "Band / Brass", "Guard"]);
});

test("agents from several groups leave them all at once, and groups left empty go", () => {
  const left = moveToGroup(null, new Set([1, 2])).apply(scene);
  expect([0, 1, 2].map((agent) => membershipOf(left, agent))).toEqual(["0", "none", "none"]);
  expect(left.groups.map((top) => top.name)).toEqual(["Band"]);
});

test("an agent without a group joins one", () => {
  const path = memberships(scene).find((entry) => entry.label === "Guard")?.path ?? null;
  expect(membershipOf(moveToGroup(path, new Set([3])).apply(scene), 3)).toBe("1");
});
