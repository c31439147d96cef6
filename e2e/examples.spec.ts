import { formatCount } from "../web/src/document/units";
import { SECTIONS } from "../web/src/files/gallery/sections";
import { expect, test } from "./fixtures/studio";

/** A recording opens otherwise: a story of its own. */
const EXAMPLES = SECTIONS.flatMap(({ cards }) => cards).filter(({ view }) => view?.kind !== "recording");

test("the first visit sees an example play", async ({ studio, page }) => {
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await studio.openFirst();
  await expect(studio.button("Pause")).toBeVisible();
  await expect.poll(() => studio.time()).toBeGreaterThan(0.2);
});

test("nothing moves by itself for who asked for less motion", async ({ studio }) => {
  await studio.openFirst();
  await studio.planned();
  await expect(studio.button("Play")).toBeVisible();
  expect(await studio.time()).toBe(0);
});

test("every example of the gallery opens and plays, the last one undone step by step", async ({ studio, page }) => {
  test.slow();
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await studio.openFirst();
  for (const { title, agentCount, keyframeCount } of EXAMPLES) {
    await studio.button("Examples").click();
    await studio.dialog.getByRole("button", { name: new RegExp(`^${title}`) }).click();
    await expect(studio.title).toHaveValue(new RegExp(`^${title}`));
    await expect(studio.tab("Agents")).toContainText(formatCount(agentCount));
    await expect(studio.keyframes).toHaveCount(keyframeCount);
    // At once, planned or not: until the motion is there, agents go straight.
    await expect.poll(() => studio.time()).toBeGreaterThan(0);
  }
  await studio.planned();
  for (const { title } of EXAMPLES.slice(-3, -1).reverse()) {
    await studio.button("Undo").click();
    await expect(studio.title).toHaveValue(new RegExp(`^${title}`));
  }
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

test("a figure of three costs opens with all three in step, and its table at once", async ({ studio, page }) => {
  await studio.openFirst();
  await studio.button("Examples").click();
  const title = "Who goes where, by three costs";
  await studio.dialog.getByRole("button", { name: `Compare all ways: ${title}` }).click();
  const structure = page.getByRole("table", { name: "Measures of all ways" }).getByRole("row", { name: /^Distortion/ });
  await expect(structure.getByRole("cell").first()).toContainText("better");
  await page.keyboard.press("Escape");

  await studio.button("Examples").click();
  await studio.dialog.getByRole("button", { name: `Table and plots: ${title}` }).click();
  await expect(page.getByRole("combobox", { name: "What to compare" })).toHaveValue("costs");
  const rows = studio.dialog.getByRole("table").getByRole("row");
  await expect(rows).toHaveCount(4);
  for (const cost of ["Least effort", "Euclidean", "Manhattan"]) {
    await expect(rows.filter({ hasText: cost })).toContainText(/\d\.\d/);
  }
  await expect(studio.dialog.getByRole("figure", { name: "Effort σ" })).toBeVisible();
});

test("a figure of others opens with them beside ours", async ({ studio, page }) => {
  await studio.openFirst();
  await studio.button("Examples").click();
  await studio.dialog.getByRole("button", { name: "Compare side by side: A crowd and what others do" }).click();
  for (const name of ["First", "Second", "Third"]) await expect(page.getByRole("group", { name })).toBeVisible();
  await expect(page.getByRole("row", { name: /^Missed by/ })).toContainText(/\d/);
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
