import { expect, test } from "./fixtures/studio";

/** Six below a wall that leaves a gap at its end, and six places above it. */
function besideAWall(gap: number) {
  const row = (y: number) => Array.from({ length: 6 }, (_, k) => [k - 2.5, y]);
  const wall = [
    [-30, -0.2],
    [8, -0.2],
    [8, 0.2],
    [-30, 0.2],
  ];
  const end = wall.map(([x = 0, y = 0]) => [x < 0 ? 8 + gap : 30, y]);
  return JSON.stringify({
    format: "eigenform",
    version: 1,
    title: "Beside a wall",
    minimumDistance: 0.5,
    obstacles: [
      { kind: "polygon", points: wall },
      { kind: "polygon", points: end },
    ],
    keyframes: [{ positions: row(-3) }, { time: 6, positions: row(3).reverse() }],
    segments: [{ method: "linear", avoidance: true }],
  });
}

/** The ends of the first line and the right foot of the gable that `makeShow` draws. */
const LEFT = [0.25, 0.35] as const;
const RIGHT = [0.75, 0.35] as const;
const FAR_FOOT = [0.65, 0.7] as const;

test("who goes where is tried, locked by a drag, accepted as one step and kept as a recipe", async ({ studio }) => {
  await studio.makeShow();
  const { inspector } = studio;
  await studio.transitions.first().click();
  const cost = inspector.getByRole("combobox", { name: "Assignment" });
  await expect(cost).toHaveValue("keep");
  await cost.selectOption("Least effort");
  const lambda = inspector.getByRole("spinbutton", { name: "Lambda" });
  await lambda.fill("0.5");
  await lambda.press("Enter");
  await expect(inspector.getByText(/^\d+\.\d m in all, the longest walk \d/)).toBeVisible();

  await studio.drag([RIGHT, FAR_FOOT]);
  await expect(inspector.getByRole("list", { name: "Locks" }).getByRole("listitem")).toHaveCount(1);
  await studio.drag([LEFT, FAR_FOOT]);
  await expect(inspector.getByText(/^\d+'s lock gave way: 1 has that place now\.$/)).toBeVisible();
  await expect(inspector.getByRole("list", { name: "Locks" }).getByRole("listitem")).toHaveText(/^1 → place of/);
  const before = (await studio.sceneFile()).keyframes[1]?.positions ?? [];
  await expect(inspector.getByRole("button", { name: "Accept" })).toBeEnabled();
  await inspector.getByRole("button", { name: "Accept" }).click();
  await expect(inspector.getByRole("button", { name: "Accept" })).toHaveCount(0);

  const file = await studio.sceneFile();
  const after = file.keyframes[1]?.positions ?? [];
  expect(after[0]?.[0]).toBe(Math.max(...before.map(([x]) => x)));
  expect([...after].sort()).toEqual([...before].sort());
  expect(file.segments?.[0]?.assignment).toEqual({ cost: "least-effort", lambda: 0.5, locks: [[0, 0]] });
  await studio.button("Undo").click();
  const undone = await studio.sceneFile();
  expect(undone.keyframes[1]?.positions).toEqual(before);
  expect(undone.segments?.[0]?.assignment).toBeUndefined();
});

test("who goes where goes around obstacles, not through", async ({ studio }) => {
  await studio.openEmpty();
  const { inspector } = studio;
  const totals: number[] = [];
  for (const gap of [2, 0.5]) {
    await studio.drop("wall.eigenform.json", besideAWall(gap));
    await expect(studio.title).toHaveValue("Beside a wall");
    await studio.transitions.first().click();
    await inspector.getByRole("combobox", { name: "Assignment" }).selectOption("Euclidean");
    const walks = inspector.getByText(/^\d+\.\d m in all, the longest walk \d/);
    await expect(walks).toBeVisible();
    totals.push(Number.parseFloat((await walks.textContent()) ?? ""));
    await inspector.getByRole("button", { name: "Cancel" }).click();
  }
  const [through = 0, around = 0] = totals;
  // Straight it would be 36 m; through the gap each goes some 20 m, around the far end of the wall 60 and more.
  expect(through).toBeGreaterThan(80);
  expect(through).toBeLessThan(150);
  expect(around).toBeGreaterThan(300);
});

test("a number that is nobody's locks nobody, and that is said", async ({ studio }) => {
  await studio.makeShow();
  const { inspector } = studio;
  await studio.transitions.first().click();
  await inspector.getByRole("combobox", { name: "Assignment" }).selectOption("Least effort");
  const agent = inspector.getByRole("spinbutton", { name: "Agent to lock" });
  const lock = inspector.getByRole("button", { name: "Lock", exact: true });
  const locks = inspector.getByRole("list", { name: "Locks" }).getByRole("listitem");
  await inspector.getByRole("spinbutton", { name: "Place of agent" }).fill("5");
  await agent.fill("99");
  await lock.click();
  await expect(inspector.getByText("Nobody is locked: there is no agent 99.")).toBeVisible();
  await expect(agent).toHaveValue("99");
  await expect(locks).toHaveCount(0);
  await agent.fill("7");
  await lock.click();
  await expect(locks).toHaveText(["7 → place of 5"]);
  await expect(inspector.getByText("Nobody is locked")).toHaveCount(0);
});
