import { expect, test } from "vitest";
import { addAgents } from "../../document/commands/agents";
import { addTie, cutTie, WHOLE_SCENE } from "../../document/commands/ties";
import { emptyScene } from "../../document/defaults";
import type { Group, Scene } from "../../document/scene";
import { originWords, tieOrigin } from "./tie-origin";

const four = addAgents([
  [0, 0],
  [1, 0],
  [0, 1],
  [1, 1],
]).apply(emptyScene());

function group(name: string, members: number[], tieWeight: number | null, children: Group[] = []): Group {
  return { name, color: "", members, tieWeight, children };
}

const grouped: Scene = { ...four, groups: [group("Band", [0], 4, [group("Brass", [1, 2], null)])] };

test("a tie that nobody made comes from being neighbors", () => {
  expect(originWords(tieOrigin(four, 0, 0, 1, null))).toBe("Neighbors");
});

test("a tie is from you and from every group that ties both", () => {
  const tied = addTie(WHOLE_SCENE, 2, 0, 10).apply(grouped);
  const origin = tieOrigin(tied, 0, 0, 2, null);
  expect(originWords(origin)).toBe("You, Band");
  expect(origin.byHand).toBe(10);
});

test("a group without ties of its own ties nobody", () => {
  expect(tieOrigin(grouped, 0, 1, 2, null).groups).toEqual(["Band"]);
});

test("a cut says who cut", () => {
  expect(originWords(tieOrigin(cutTie(WHOLE_SCENE, 0, 1).apply(four), 0, 1, 0, null))).toBe("Cut by you");
});

test("all factors together are the engine's, whichever agent is named first", () => {
  const ties = { pairs: Uint32Array.from([0, 1, 1, 3]), factors: Float64Array.from([1, 40]) };
  expect(tieOrigin(four, 0, 3, 1, ties).total).toBe(40);
  expect(tieOrigin(four, 0, 0, 3, ties).total).toBeNull();
});
