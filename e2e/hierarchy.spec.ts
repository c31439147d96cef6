import { expect, type Place, type Studio, test } from "./fixtures/studio";

/** Three lines of twelve, far apart: agents 0–11, 12–23, 24–35. */
const BLOCKS: readonly (readonly [Place, Place])[] = [
  [
    [0.2, 0.3],
    [0.3, 0.3],
  ],
  [
    [0.45, 0.3],
    [0.55, 0.3],
  ],
  [
    [0.65, 0.6],
    [0.75, 0.6],
  ],
];

const range = (from: number, to: number): number[] => Array.from({ length: to - from }, (_, i) => from + i);

async function drawBlocks(studio: Studio): Promise<void> {
  await studio.openEmpty();
  for (const stroke of BLOCKS) await studio.draw(stroke);
  await studio.tool("Select").click();
  await studio.click([0.5, 0.85]);
}

async function acceptThree(studio: Studio): Promise<void> {
  await studio.inspector.getByRole("button", { name: "Propose groups" }).click();
  await expect(studio.inspector.getByText("3 groups", { exact: true })).toBeVisible();
  await studio.inspector.getByRole("button", { name: "Accept" }).click();
}

/** How far each agent is from where it stood, whole centimeters across. */
async function shifts(studio: Studio, before: readonly (readonly number[])[]): Promise<number[]> {
  const [keyframe] = (await studio.sceneFile()).keyframes;
  return (keyframe?.positions ?? []).map(([x = 0], agent) => Math.round(100 * (x - (before[agent]?.[0] ?? 0))));
}

test("three blocks are proposed as groups, accepted, and taken back as one step", async ({ studio, page }) => {
  await drawBlocks(studio);
  const propose = studio.inspector.getByRole("button", { name: "Propose groups" });
  await propose.click();
  await expect(studio.inspector.getByText("3 groups", { exact: true })).toBeVisible();
  const parts = studio.inspector.getByRole("spinbutton", { name: "Parts" });
  await parts.fill("4");
  await parts.press("Enter");
  await expect(studio.inspector.getByText("4 groups", { exact: true })).toBeVisible();
  await studio.inspector.getByRole("radio", { name: "Halves" }).check();
  await expect(studio.inspector.getByText("2 groups", { exact: true })).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(propose).toBeVisible();
  expect((await studio.sceneFile()).groups ?? []).toEqual([]);

  await acceptThree(studio);
  const groups = (await studio.sceneFile()).groups ?? [];
  expect(groups.map((group) => group.members)).toEqual([range(0, 12), range(12, 24), range(24, 36)]);
  await studio.button("Undo").click();
  expect((await studio.sceneFile()).groups ?? []).toEqual([]);
});

test("a file and a link leave out the groups that nobody accepted, and say so", async ({ studio, page, visitor }) => {
  await drawBlocks(studio);
  await studio.inspector.getByRole("button", { name: "Propose groups" }).click();
  await expect(studio.inspector.getByText("3 groups", { exact: true })).toBeVisible();
  expect((await studio.sceneFile()).groups ?? []).toEqual([]);
  await expect(studio.message("until you accept it")).toBeVisible();
  expect((await studio.sceneFile(() => page.keyboard.press("Control+s"))).groups ?? []).toEqual([]);

  await studio.button("Share").click();
  await expect(studio.dialog.getByText("until you accept it")).toBeVisible();
  const field = page.getByRole("textbox", { name: "Link", exact: true });
  await expect(field).toHaveValue(/#s=1\./);
  const link = await field.inputValue();
  await page.keyboard.press("Escape");
  await expect(studio.dialog).toHaveCount(0);
  await visitor.open(link);
  await expect(visitor.keyframes).toHaveCount(1);
  expect((await visitor.sceneFile()).groups ?? []).toEqual([]);

  await studio.inspector.getByRole("button", { name: "Accept" }).click();
  expect((await studio.sceneFile()).groups ?? []).toHaveLength(3);
});

test("a group is dragged as one, an agent within it alone, and Escape comes out", async ({ studio, page }) => {
  await drawBlocks(studio);
  await acceptThree(studio);
  const before = (await studio.sceneFile()).keyframes[0]?.positions ?? [];
  await studio.drag([
    [0.2, 0.3],
    [0.22, 0.4],
  ]);
  await expect(studio.inspector.getByText("12 agents")).toBeVisible();
  const moved = await shifts(studio, before);
  expect(new Set(moved.slice(0, 12)).size).toBe(1);
  expect(moved[0]).toBeGreaterThan(0);
  expect(new Set(moved.slice(12))).toEqual(new Set([0]));

  const { x, y } = await studio.onScreen([0.22, 0.4]);
  await page.mouse.dblclick(x, y);
  await page.waitForTimeout(600);
  await studio.drag([
    [0.22, 0.4],
    [0.18, 0.5],
  ]);
  const alone = await shifts(studio, before);
  expect(alone[0]).toBeLessThan(moved[0] ?? 0);
  expect(alone.slice(1)).toEqual(moved.slice(1));
  await page.keyboard.press("Escape");
  await expect(studio.inspector.getByText("12 agents")).toBeVisible();
  await studio.button("Undo").click();
  await studio.button("Undo").click();
  expect(new Set(await shifts(studio, before))).toEqual(new Set([0]));
});

test("ties between two groups are cut to split them, and brought back", async ({ studio }) => {
  await drawBlocks(studio);
  await acceptThree(studio);
  await studio.click([0.2, 0.3]);
  await studio.inspector.getByRole("combobox", { name: "Ties to" }).selectOption({ label: "Group 2" });
  await studio.inspector.getByRole("button", { name: "Split" }).click();
  const cuts = (await studio.sceneFile()).adjacency?.cuts ?? [];
  expect(cuts.length).toBeGreaterThan(0);
  expect(cuts.every(([a, b]) => a < 12 && b >= 12 && b < 24)).toBe(true);
  await studio.inspector.getByRole("button", { name: "As proposed" }).click();
  expect((await studio.sceneFile()).adjacency?.cuts ?? []).toEqual([]);
});

test("groups move as wholes once hierarchy is on, one of them by a way of its own", async ({ studio }) => {
  await drawBlocks(studio);
  await acceptThree(studio);
  await studio.button("Add keyframe").click();
  await studio.drag([
    [0.2, 0.3],
    [0.25, 0.7],
  ]);
  await studio.planned();
  await studio.transitions.first().click();
  const hierarchy = studio.inspector.getByRole("checkbox", { name: /Hierarchy/ });
  await hierarchy.check();
  await studio.inspector.getByRole("combobox", { name: "Another way for" }).selectOption({ label: "Group 2" });
  await studio.inspector.getByRole("combobox", { name: "Method of Group 2" }).selectOption({ label: "Polar" });
  await studio.inspector.getByRole("combobox", { name: "Blend of Group 2" }).selectOption({ label: "Linear" });
  const amount = studio.inspector.getByRole("spinbutton", { name: "Amount of Group 2" });
  await amount.fill("0.3");
  await amount.press("Enter");
  await studio.planned();
  const [segment] = (await studio.sceneFile()).segments ?? [];
  const node = { group: [1], method: "polar", blend: { method: "linear", amount: 0.3 } };
  expect(segment).toMatchObject({ hierarchy: true, nodes: [node] });

  for (let step = 0; step < 4; step += 1) await studio.button("Undo").click();
  await expect(hierarchy).toBeChecked();
  await studio.button("Undo").click();
  await expect(hierarchy).not.toBeChecked();
});
