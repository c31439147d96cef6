import { expect, test } from "vitest";
import { addAgents } from "../../document/commands/agents";
import { addKeyframe } from "../../document/commands/keyframes";
import { setTitle } from "../../document/commands/scene";
import { createDocument } from "../../document/create-store";
import { DEFAULT_SEGMENT, emptyScene, keyframeAt } from "../../document/defaults";
import { Formation } from "../../document/formation";
import { mainTrack } from "../../document/scene";
import type { Salvage } from "../../engine/salvage";
import { createSpreading } from "./spreading";

const between = Formation.from([
  [1, 1],
  [2, -1],
]);

const FOUND: Salvage = {
  keyframes: [keyframeAt(2, between)],
  part: { ...DEFAULT_SEGMENT, method: "linear", avoidance: true },
  report: {
    clearance: null,
    deviation: { mean: 0, max: 1 },
    topSpeed: 1,
    guideTopSpeed: 1,
    isWild: false,
    unsolved: [],
  },
};

/** Two agents that change places; the engine answers when the test says so. */
function bench() {
  const [start, end]: [number, number][][] = [
    [
      [0, 0],
      [4, 0],
    ],
    [
      [4, 0],
      [0, 0],
    ],
  ];
  const document = createDocument(addAgents(start ?? []).apply(emptyScene()));
  document.perform(addKeyframe(4, Formation.from(end ?? [])));
  let answer: (found: Salvage | null) => void = () => {};
  let endCount = 0;
  const spreading = createSpreading({
    document,
    index: 0,
    search: () => ({
      found: new Promise((resolve) => {
        answer = resolve;
      }),
      end: () => {
        endCount += 1;
      },
    }),
    announce: () => {},
    onProblem: () => {},
  });
  return {
    document,
    spreading,
    answer: (found: Salvage | null) => {
      answer(found);
      return new Promise((resolve) => setTimeout(resolve, 0));
    },
    endCount: () => endCount,
  };
}

test("what was found shows at once, and accepting it is one undo entry", async () => {
  const { document, spreading, answer, endCount } = bench();
  const before = document.scene.value;
  spreading.start();
  await answer(FOUND);
  expect(endCount()).toBe(1);
  expect(mainTrack(document.scene.value).keyframes.map(({ positions }) => positions)[1]).toBe(between);
  expect(mainTrack(document.scene.value).segments.map(({ method }) => method)).toEqual(["linear", "linear"]);
  spreading.accept();
  expect(document.undoLabel.value).toBe("Let them spread out");
  document.undo();
  expect(document.scene.value).toBe(before);
});

test("discarded, the scene is the identical one", async () => {
  const { document, spreading, answer } = bench();
  const before = document.scene.value;
  spreading.start();
  await answer(FOUND);
  spreading.discard();
  expect(document.scene.value).toBe(before);
  expect(spreading.state.value.kind).toBe("idle");
});

test("a search that is given up, or whose scene has changed, shows nothing", async () => {
  const { document, spreading, answer, endCount } = bench();
  spreading.start();
  spreading.discard();
  expect(endCount()).toBe(1);
  await answer(FOUND);
  expect(mainTrack(document.scene.value).keyframes).toHaveLength(2);
  spreading.start();
  document.perform(setTitle("Another"));
  await answer(FOUND);
  expect(mainTrack(document.scene.value).keyframes).toHaveLength(2);
  expect(spreading.state.value.kind).toBe("idle");
});

test("where nothing helps, that is said and the scene stays", async () => {
  const { document, spreading, answer } = bench();
  const before = document.scene.value;
  spreading.start();
  await answer({ ...FOUND, keyframes: [] });
  expect(spreading.state.value.kind).toBe("helpless");
  expect(document.scene.value).toBe(before);
});
