import { expect, test } from "./fixtures/studio";

const EXAMPLES: readonly (readonly [title: string, agents: string, keyframes: number])[] = [
  ["Autumn opener", "25", 4],
  ["Half-time", "200", 4],
  ["Flower", "208", 3],
  ["Star to five rings", "1,260", 3],
  ["Three blocks", "36", 4],
  ["Grid to ring", "49", 3],
  ["Four around one", "17", 4],
  ["Rotated copy", "9", 3],
  ["With and without alignment", "6", 4],
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
    await studio.dialog.getByRole("button", { name: title }).click();
    await expect(studio.title).toHaveValue(new RegExp(`^${title}`));
    await expect(studio.tab("Agents")).toContainText(agents);
    await expect(studio.keyframes).toHaveCount(keyframes);
    // At once, planned or not: until the motion is there, agents go straight.
    await expect.poll(() => studio.time()).toBeGreaterThan(0);
  }
  await studio.planned();
  await studio.button("Undo").click();
  await expect(studio.title).toHaveValue(/^Rotated copy/);
  await studio.button("Undo").click();
  await expect(studio.title).toHaveValue(/^Four around one/);
});
