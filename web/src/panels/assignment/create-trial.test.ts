import { expect, test } from "vitest";
import { emptyScene } from "../../document/defaults";
import { EngineError, type FoundPlaces } from "../../engine/api";
import { createTrial } from "./create-trial";

const RECIPE = { cost: "squared", lambda: 0.9, locks: [], keepGroups: false } as const;

const found = (slots: readonly number[]): FoundPlaces => ({ slots, bends: [], ownBends: [] });

/** The engine answers when the test says so. */
function bench() {
  const answers: ((found: FoundPlaces | null) => void)[] = [];
  let stops = 0;
  const trial = createTrial(0, RECIPE, {
    scene: emptyScene,
    find: () => new Promise((resolve) => answers.push(resolve)),
    stop: () => {
      stops += 1;
    },
  });
  const settled = () => new Promise((resolve) => setTimeout(resolve, 0));
  return { trial, answers, settled, stopCount: () => stops };
}

test("of two questions the later one is shown, whichever is answered last", async () => {
  const { trial, answers, settled } = bench();
  trial.ask();
  trial.setRecipe({ cost: "manhattan" });
  answers[1]?.(found([1, 0]));
  answers[0]?.(found([0, 1]));
  await settled();
  expect(trial.found.value?.slots).toEqual([1, 0]);
  expect(trial.progress.value).toBeNull();
});

test("an agent has one lock and so has a place; without any nothing is predicted", () => {
  const { trial } = bench();
  trial.lock(0, 5);
  trial.lock(1, 4);
  trial.setWay({ isPredicted: true });
  trial.lock(0, 4);
  expect(trial.question.value.recipe.locks).toEqual([[0, 4]]);
  expect(trial.question.value.isPredicted).toBe(true);
  trial.unlock(0);
  expect(trial.question.value.recipe.locks).toEqual([]);
  expect(trial.question.value.isPredicted).toBe(false);
});

test("a lock that gives way to another is told of, until the next is set or let go", () => {
  const { trial } = bench();
  trial.lock(0, 4);
  expect(trial.gaveWay.value).toBeNull();
  trial.lock(1, 4);
  expect(trial.question.value.recipe.locks).toEqual([[1, 4]]);
  expect(trial.gaveWay.value).toEqual({ agent: 0, to: 1 });
  // Who is locked elsewhere took that place from nobody.
  trial.lock(1, 5);
  expect(trial.gaveWay.value).toBeNull();
  trial.lock(2, 5);
  trial.unlock(2);
  expect(trial.gaveWay.value).toBeNull();
});

test("who is shut off is called as the page calls them", async () => {
  const scene = emptyScene();
  const trial = createTrial(0, RECIPE, {
    scene: () => ({ ...scene, obstacles: [{ name: "", shape: { kind: "circle", center: [0, 0], radius: 1 } }] }),
    find: () =>
      Promise.reject(
        new EngineError({
          code: "no-way",
          what: "no way leads agent 0 to a place: obstacle 0 shuts it off",
          where: "",
          noWay: { agent: 0, obstacle: 0, distance: 0.5 },
        }),
      ),
    stop: () => {},
  });
  trial.ask();
  await new Promise((resolve) => setTimeout(resolve, 0));
  expect(trial.problem.value).toContain("agent 1 ");
  expect(trial.problem.value).toContain("Obstacle 1 ");
  expect(trial.problem.value).not.toMatch(/ 0 /);
});

test("stopped, the answer before stays", async () => {
  const { trial, answers, settled, stopCount } = bench();
  trial.ask();
  answers[0]?.(found([0, 1]));
  await settled();
  trial.setWay({ isFlipped: true });
  trial.stop();
  answers[1]?.(null);
  await settled();
  expect(trial.found.value?.slots).toEqual([0, 1]);
  expect([trial.progress.value, stopCount()]).toEqual([null, 1]);
});
