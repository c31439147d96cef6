import { expect, test } from "vitest";
import { emptyScene } from "../defaults";
import type { Point } from "../formation";
import { groupAt, groupOf, groupSet } from "../groups";
import { GROUP_COLORS } from "../palette";
import type { Scene } from "../scene";
import { addAgents, deleteAgents, duplicateAgents } from "./agents";
import { addToGroup, dissolveGroup, makeGroup, nestGroup, removeFromGroup, setGroupTieWeight } from "./groups";

const EIGHT = Array.from({ length: 8 }, (_, i): Point => [i, 0]);

function sceneWith(...groups: readonly (readonly number[])[]): Scene {
  return groups.reduce(
    (scene, members) => makeGroup(new Set(members)).apply(scene),
    addAgents(EIGHT).apply(emptyScene()),
  );
}

const sets = (scene: Scene) => scene.groups.map((group) => [...groupSet(group)].sort());

test("groups get names and colors of their own", () => {
  const scene = sceneWith([0, 1], [2, 3]);
  expect(scene.groups.map((group) => group.name)).toEqual(["Group 1", "Group 2"]);
  expect(scene.groups.map((group) => group.color)).toEqual(GROUP_COLORS.slice(0, 2));
});

test("the others keep name and color when a group is dissolved", () => {
  const scene = dissolveGroup([0]).apply(sceneWith([0, 1], [2, 3], [4, 5]));
  expect(scene.groups.map((group) => group.name)).toEqual(["Group 2", "Group 3"]);
  expect(scene.groups.map((group) => group.color)).toEqual(GROUP_COLORS.slice(1, 3));
  expect(makeGroup(new Set([6])).apply(scene).groups[2]).toMatchObject({ name: "Group 1", color: GROUP_COLORS[0] });
});

test("agents taken into a new group leave their old one", () => {
  expect(sets(sceneWith([0, 1, 2], [2, 3]))).toEqual([
    [0, 1],
    [2, 3],
  ]);
});

test("a group that loses all agents goes", () => {
  expect(sets(sceneWith([0, 1], [4, 5], [1, 4, 5]))).toEqual([[0], [1, 4, 5]]);
  expect(sets(deleteAgents(new Set([0, 1])).apply(sceneWith([0, 1], [4, 5])))).toEqual([[2, 3]]);
});

test("a part of a group becomes a group within it", () => {
  const scene = sceneWith([0, 1, 2, 3], [1, 2]);
  expect(sets(scene)).toEqual([[0, 1, 2, 3]]);
  expect(groupOf(scene.groups, 1)).toEqual([0, 0]);
  expect(groupAt(scene.groups, [0])?.members).toEqual([0, 3]);
});

test("whole groups stay groups within a new one", () => {
  const scene = sceneWith([0, 1], [2, 3], [0, 1, 2, 3, 4]);
  expect(sets(scene)).toEqual([[0, 1, 2, 3, 4]]);
  expect(groupAt(scene.groups, [0])?.members).toEqual([4]);
  expect(scene.groups[0]?.children.map((group) => group.name)).toEqual(["Group 1", "Group 2"]);
});

test("the agents of a group are a group already", () => {
  const scene = sceneWith([0, 1]);
  expect(makeGroup(new Set([1, 0])).apply(scene)).toBe(scene);
});

test("nesting and bringing to the top are each other's opposite", () => {
  const scene = sceneWith([0, 1], [2, 3]);
  const nested = nestGroup([1], [0]).apply(scene);
  expect(sets(nested)).toEqual([[0, 1, 2, 3]]);
  expect(nestGroup([0, 0], []).apply(nested)).toEqual(scene);
});

test("a group does not go inside itself or what is within it", () => {
  const scene = nestGroup([1], [0]).apply(sceneWith([0, 1], [2, 3]));
  expect(nestGroup([0], [0]).apply(scene)).toBe(scene);
  expect(nestGroup([0], [0, 0]).apply(scene)).toBe(scene);
});

test("dissolving gives agents and groups to the parent", () => {
  const scene = dissolveGroup([0, 0]).apply(sceneWith([0, 1, 2, 3], [1, 2, 3], [2, 3]));
  expect(groupAt(scene.groups, [0])?.members).toEqual([0, 1]);
  expect(groupAt(scene.groups, [0, 0])?.members).toEqual([2, 3]);
});

test("joining moves agents even when their old group vanishes", () => {
  const scene = addToGroup([1], new Set([0, 1])).apply(sceneWith([0, 1], [2, 3]));
  expect(scene.groups.map((group) => group.name)).toEqual(["Group 2"]);
  expect(sets(scene)).toEqual([[0, 1, 2, 3]]);
});

test("who leaves a group within another stays in the outer one", () => {
  const scene = removeFromGroup([0, 0], new Set([1])).apply(sceneWith([0, 1, 2], [1, 2]));
  expect(groupOf(scene.groups, 1)).toEqual([0]);
  expect(groupOf(removeFromGroup([0], new Set([1])).apply(scene).groups, 1)).toBeNull();
});

test("a copy of an agent is in its group", () => {
  const scene = duplicateAgents(new Set([1, 2]), [1, 1]).apply(sceneWith([0, 1], [2, 3]));
  expect(sets(scene)).toEqual([
    [0, 1, 8],
    [2, 3, 9],
  ]);
});

test("a group's ties have a factor within the format's bounds, or none", () => {
  const scene = setGroupTieWeight([0], 10).apply(sceneWith([0, 1]));
  expect(scene.groups[0]?.tieWeight).toBe(10);
  expect(setGroupTieWeight([0], 1e7).apply(scene)).toBe(scene);
  expect(setGroupTieWeight([0], null).apply(scene).groups[0]?.tieWeight).toBeNull();
});
