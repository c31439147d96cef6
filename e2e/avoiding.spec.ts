import { expect, test } from "./fixtures/studio";

type Place = readonly [x: number, y: number];

function show(
  title: string,
  minimumDistance: number,
  formations: readonly (readonly Place[])[],
  segment: object,
): string {
  return JSON.stringify({
    format: "eigenform",
    version: 1,
    title,
    minimumDistance,
    keyframes: formations.map((positions, index) => ({ time: 6 * index, positions })),
    segments: formations.slice(1).map(() => segment),
  });
}

/** Rows of agents, `gap` meters apart, about a middle. */
function block(across: number, deep: number, gap: number, [x, y]: Place): Place[] {
  return Array.from({ length: across * deep }, (_, agent) => [
    x + ((agent % across) - (across - 1) / 2) * gap,
    y + (Math.floor(agent / across) - (deep - 1) / 2) * gap,
  ]);
}

const CROSSING = [
  [...block(6, 1, 1.5, [0, 4]), ...block(6, 1, 1.5, [0, -4])],
  [...block(6, 1, 1.5, [0, -4]), ...block(6, 1, 1.5, [0, 4])],
];

test("two lines pass through each other, and the page says what it took", async ({ studio, page }) => {
  await studio.openFirst();
  await studio.drop("lines.json", show("Lines", 0.5, CROSSING, { method: "linear", avoidance: true }));
  await expect(studio.title).toHaveValue("Lines");
  await studio.planned();
  const ribbon = studio.transitions.first();
  await expect(ribbon).toHaveAccessibleName(/holds|tight/);
  await expect(ribbon).toHaveAccessibleDescription(/Before avoidance: .* at 0:03/);
  await ribbon.focus();
  await page.keyboard.press("Enter");
  const avoid = studio.inspector.getByRole("checkbox", { name: "Avoid collisions" });
  await expect(avoid).toBeChecked();
  const measures = studio.inspector.getByRole("region", { name: "Measures" });
  await expect(measures).toContainText("Deviation");
  await expect(measures).toContainText(/before 0\.0\d m/);

  await test.step("without avoidance they clash, which says who and when, and leads there", async () => {
    await avoid.uncheck();
    await expect(ribbon).toHaveAccessibleName(/clash, clearance 0\.0\d m/);
    await studio.inspector.getByRole("button", { name: "Go there" }).click();
    await expect.poll(() => studio.time()).toBeCloseTo(3, 0);
  });

  await test.step("the first thing proposed is to avoid", async () => {
    await studio.inspector
      .getByRole("group", { name: "What may help" })
      .getByRole("button", { name: "Avoid collisions" })
      .click();
    await expect(ribbon).toHaveAccessibleName(/holds|tight/);
    await page.keyboard.press("Control+z");
    await expect(avoid).not.toBeChecked();
  });
});

test("what is not solved says so, and each step that may help is one undo away", async ({ studio }) => {
  const [west, east] = [block(6, 6, 1, [-8, 0]), block(6, 6, 1, [8, 0])];
  // Each turned upside down on its way: nobody's file is anybody's.
  const dense = [
    [...west, ...east],
    [...east.toReversed(), ...west.toReversed()],
  ];
  await studio.openFirst();
  await studio.drop("blocks.json", show("Blocks", 0.95, dense, { method: "linear", avoidance: true }));
  await expect(studio.title).toHaveValue("Blocks");
  await studio.planned();
  const ribbon = studio.transitions.first();
  await expect(ribbon).toHaveAccessibleName(/clash/);
  await ribbon.click();
  const steps = studio.inspector.getByRole("group", { name: "What may help" });
  await expect(steps.getByRole("button").first()).toBeVisible();

  await test.step("the nearest places need nobody to cross", async () => {
    await steps.getByRole("button", { name: "Nearest places" }).click();
    await expect(ribbon).toHaveAccessibleName(/holds|tight/);
    await studio.button("Undo").click();
    await expect(ribbon).toHaveAccessibleName(/clash/);
  });

  await test.step("a keyframe between is made where they meet", async () => {
    await steps.getByRole("button", { name: "A keyframe between" }).click();
    await expect(studio.keyframes).toHaveCount(3);
    await studio.button("Undo").click();
    await expect(studio.keyframes).toHaveCount(2);
  });
});

test("those who are stuck spread out on the stage, and it stays only when it is accepted", async ({ studio }) => {
  const [west, south] = [block(3, 3, 1, [-6, 0]), block(3, 3, 1, [0, -6])];
  const across = [...block(3, 3, 1, [6, 0]).toReversed(), ...block(3, 3, 1, [0, 6]).toReversed()];
  await studio.openFirst();
  const segment = { method: "linear", avoidance: true };
  await studio.drop("crossing.json", show("Crossing", 0.8, [[...west, ...south], across], segment));
  await expect(studio.title).toHaveValue("Crossing");
  await studio.planned();
  await expect(studio.transitions.first()).toHaveAccessibleName(/clash/);
  await studio.transitions.first().click();
  const spread = studio.inspector.getByRole("button", { name: "Let them spread out" });
  const shown = studio.inspector.getByRole("group", { name: "Spread out" });

  await test.step("it plays with its numbers beside those before, and goes without a trace", async () => {
    await spread.click();
    await expect(shown.getByRole("row", { name: /^Nearest 0\.\d+ m 0\.8\d m/ })).toBeVisible();
    await expect(shown.getByRole("row", { name: /^Farthest aside/ })).toBeVisible();
    await expect(studio.keyframes).not.toHaveCount(2);
    await expect.poll(() => studio.time()).toBeGreaterThan(0.5);
    await shown.getByRole("button", { name: "Discard" }).click();
    await expect(studio.keyframes).toHaveCount(2);
    await expect(studio.transitions.first()).toHaveAccessibleName(/clash/);
  });

  await test.step("accepted it is one step, and everybody keeps apart", async () => {
    await spread.click();
    await shown.getByRole("button", { name: /^Accept/ }).click();
    await studio.planned();
    await expect(studio.keyframes).not.toHaveCount(2);
    for (const transition of await studio.transitions.all()) {
      await expect(transition).toHaveAccessibleName(/holds|tight/);
    }
    await studio.button("Undo").click();
    await expect(studio.keyframes).toHaveCount(2);
  });
});

test("a keyframe in which two stand too near says who, and nobody is moved", async ({ studio, page }) => {
  const near: readonly Place[] = [
    [0, 0],
    [0.3, 0],
    [4, 0],
  ];
  const apart: readonly Place[] = near.map(([x, y]) => [2 * x, y + 5]);
  await studio.openFirst();
  await studio.drop("near.json", show("Near", 0.5, [near, apart], { method: "linear", avoidance: true }));
  await expect(studio.title).toHaveValue("Near");
  const keyframe = studio.keyframes.first();
  await expect(keyframe).toHaveAccessibleDescription(/1 too near/);
  await expect(studio.keyframes.nth(1)).not.toHaveAccessibleDescription(/too near/);
  await keyframe.focus();
  await page.keyboard.press("Enter");
  const list = studio.inspector.getByRole("list", { name: "Too near" });
  await expect(list).toContainText("0.30 m");
  await list.getByRole("button").click();
  await expect(studio.inspector.getByRole("heading", { name: "2 agents" })).toBeVisible();
  expect((await studio.sceneFile()).keyframes[0]?.positions).toEqual(near);
});
