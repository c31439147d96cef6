import { expect, test } from "./fixtures/studio";

const EXAMPLES: readonly (readonly [title: string, agents: string, keyframes: number])[] = [
  ["Autumn opener", "25", 4],
  ["Half-time", "200", 4],
  ["Flower", "208", 3],
  ["Star to five rings", "1,260", 3],
  ["Three blocks", "36", 4],
  ["Grid to ring", "49", 3],
  ["Six and their modes", "6", 2],
  ["Rotated copy", "9", 4],
  ["With and without alignment", "6", 4],
  ["Polar or spectral", "8", 4],
  ["Four around one", "17", 4],
  ["A small and a large change", "9", 3],
  ["Winding and smooth", "9", 4],
  ["Clusters passing", "24", 4],
  ["Clusters kept apart", "24", 4],
  ["Offside trap", "14", 4],
  ["Twelve hundred and sixty", "1,260", 4],
  ["Bird in four hands", "400", 4],
  ["Running man", "600", 3],
  ["Awl, goose, hook and round", "300", 4],
  ["The end", "10", 6],
];

test("the first visit sees an example play", async ({ studio }) => {
  await studio.openFirst();
  await expect(studio.button("Pause")).toBeVisible();
  await expect.poll(() => studio.time()).toBeGreaterThan(0.2);
});

test("nothing moves by itself for who asked for less motion", async ({ studio, page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await studio.openFirst();
  await studio.planned();
  await expect(studio.button("Play")).toBeVisible();
  expect(await studio.time()).toBe(0);
});

test("every example of the gallery opens and plays, the last one undone step by step", async ({ studio }) => {
  test.slow();
  await studio.openFirst();
  for (const [title, agents, keyframes] of EXAMPLES) {
    await studio.button("Examples").click();
    await studio.dialog.getByRole("button", { name: new RegExp(`^${title}`) }).click();
    await expect(studio.title).toHaveValue(new RegExp(`^${title}`));
    await expect(studio.tab("Agents")).toContainText(agents);
    await expect(studio.keyframes).toHaveCount(keyframes);
    // At once, planned or not: until the motion is there, agents go straight.
    await expect.poll(() => studio.time()).toBeGreaterThan(0);
  }
  await studio.planned();
  await studio.button("Undo").click();
  await expect(studio.title).toHaveValue(/^Awl, goose/);
  await studio.button("Undo").click();
  await expect(studio.title).toHaveValue(/^Running man/);
});

test("a figure's pair opens in the comparison, and its numbers say what the figure shows", async ({ studio, page }) => {
  await studio.openFirst();
  await studio.button("Examples").click();
  await studio.dialog.getByRole("button", { name: "Compare both ways: Winding and smooth" }).click();
  await expect(page.getByRole("group", { name: "Left" }).getByRole("combobox", { name: "Order" })).toHaveValue(
    "eigenvalue",
  );
  await expect(page.getByRole("group", { name: "Right" }).getByRole("combobox", { name: "Order" })).toHaveValue(
    "greedy",
  );
  const length = page.getByRole("row", { name: /^Path length/ }).getByRole("cell");
  await expect(length.nth(1)).toContainText("better");
});

test("a figure of modes opens with them beside it", async ({ studio, page }) => {
  await studio.openFirst();
  await studio.button("Examples").click();
  await studio.dialog.getByRole("button", { name: "See its modes: Six and their modes" }).click();
  const panel = page.getByRole("region", { name: "Modes", exact: true });
  // The paper's figure bisects six agents by three cuts.
  await expect(panel).toContainText("3 of 9 ties");
  await expect(panel.getByRole("img", { name: /^Greedy/ })).toBeVisible();
});
