import { expect, test } from "vitest";
import type { ComparisonQuestion } from "../../../engine/api";
import type { Compared } from "../../../engine/comparison";
import { createRun, outcomeOf } from "./create-run";

function question(way: ComparisonQuestion["way"]): ComparisonQuestion {
  return { segment: 0, way, cost: "keep", pace: null };
}

/** The engine answers when the test says so. */
function bench() {
  const asked: { way: string; answer: (compared: Compared | null) => void; fail: (error: Error) => void }[] = [];
  let cancels = 0;
  const run = createRun({
    ask: ({ way }) => new Promise((answer, fail) => asked.push({ way, answer, fail })),
    cancel: () => {
      cancels += 1;
    },
  });
  const settled = () => new Promise((resolve) => setTimeout(resolve, 0));
  const kinds = (...ways: ComparisonQuestion["way"][]) =>
    ways.map((way) => outcomeOf(run.known.value, question(way)).kind);
  return { run, asked, settled, kinds, cancelCount: () => cancels };
}

const NUMBERS = {} as Compared;

test("one way is moved after the other, and one that cannot be says why and holds nobody up", async () => {
  const { run, asked, settled, kinds } = bench();
  run.want([question("linear"), question("polar"), question("crowd")]);
  expect(asked.map(({ way }) => way)).toEqual(["linear"]);
  asked[0]?.answer(NUMBERS);
  await settled();
  asked[1]?.fail(new Error("There is no way."));
  await settled();
  expect(kinds("linear", "polar", "crowd")).toEqual(["done", "failed", "waiting"]);
  asked[2]?.answer(NUMBERS);
  await settled();
  expect(kinds("linear", "polar", "crowd")).toEqual(["done", "failed", "done"]);
  expect(run.isWorking.value).toBe(false);
});

test("what is known is not asked again, and what comes to be wanted meanwhile is", async () => {
  const { run, asked, settled } = bench();
  run.want([question("linear")]);
  run.want([question("polar"), question("linear")]);
  asked[0]?.answer(NUMBERS);
  await settled();
  asked[1]?.answer(NUMBERS);
  await settled();
  run.want([question("linear"), question("polar")]);
  expect(asked.map(({ way }) => way)).toEqual(["linear", "polar"]);
});

test("stopped, the rest waits until something is wanted again", async () => {
  const { run, asked, settled, kinds, cancelCount } = bench();
  run.want([question("linear"), question("polar")]);
  run.stop();
  asked[0]?.answer(null);
  await settled();
  expect([kinds("linear", "polar"), run.isWorking.value, cancelCount()]).toEqual([["waiting", "waiting"], false, 1]);
  run.want([question("linear"), question("polar")]);
  expect(asked).toHaveLength(2);
});

test("an answer that comes after the stop is none", async () => {
  const { run, asked, settled, kinds } = bench();
  run.want([question("linear")]);
  run.stop();
  run.want([question("linear")]);
  asked[0]?.answer(NUMBERS);
  await settled();
  expect(kinds("linear")).toEqual(["waiting"]);
  asked[1]?.answer(NUMBERS);
  await settled();
  expect(kinds("linear")).toEqual(["done"]);
});
