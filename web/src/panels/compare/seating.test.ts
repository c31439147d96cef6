import { expect, test } from "vitest";
import { DEFAULT_SEGMENT, emptyScene } from "../../document/defaults";
import { updateTrack } from "../../document/edit";
import type { FoundPlaces } from "../../engine/api";
import { createSeater } from "./seating";

const SCENE = updateTrack(emptyScene(), (track) => ({
  ...track,
  segments: [{ ...DEFAULT_SEGMENT, assignment: { cost: "squared", lambda: 0.4, locks: [], keepGroups: true } }],
}));

/** The engine answers when the test says so. */
function bench() {
  const asked: { cost: string; lambda: number; answer(places: FoundPlaces | null): void; fail(error: Error): void }[] =
    [];
  const seat = createSeater(
    (_, { recipe }) =>
      new Promise((answer, fail) => asked.push({ cost: recipe.cost, lambda: recipe.lambda, answer, fail })),
  );
  const settled = () => new Promise((resolve) => setTimeout(resolve, 0));
  return { seat, asked, settled };
}

const places = (slots: readonly number[]): FoundPlaces => ({ slots, bends: [], ownBends: [] });

test("several costs are asked one after the other, by the transition's own recipe, and a refusal holds nobody up", async () => {
  const { seat, asked, settled } = bench();
  const refused = seat(SCENE, 0, "euclidean");
  const found = seat(SCENE, 0, "manhattan");
  await settled();
  expect(asked.map(({ cost, lambda }) => [cost, lambda])).toEqual([["euclidean", 0.4]]);
  asked[0]?.fail(new Error("contradictory locks"));
  await expect(refused).rejects.toThrow("contradictory locks");
  await settled();
  asked[1]?.answer(places([1, 0]));
  expect(await found).toEqual({ cost: "manhattan", slots: [1, 0] });
});

test("to keep all places is no question, and an answer that was stopped is none", async () => {
  const { seat, asked, settled } = bench();
  expect(await seat(SCENE, 0, "keep")).toBeNull();
  const stopped = seat(SCENE, 0, "squared");
  await settled();
  asked[0]?.answer(null);
  expect(await stopped).toBeNull();
  expect(asked).toHaveLength(1);
});
