import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures/studio";

function side(page: Page, name: "Left" | "Right") {
  const group = page.getByRole("group", { name, exact: true });
  return { group, method: group.getByRole("combobox", { name: "Method" }) };
}

function row(page: Page, measure: string) {
  return page
    .getByRole("table", { name: "Measures of both ways" })
    .getByRole("row", { name: new RegExp(`^${measure}`) });
}

test("two methods are measured side by side, and the better one is taken over in one step", async ({
  studio,
  page,
}) => {
  await studio.openFirst();
  await studio.planned();
  await studio.transitions.first().click();
  await studio.inspector.getByRole("button", { name: "Compare side by side" }).click();
  const [left, right] = [side(page, "Left"), side(page, "Right")];
  await expect(left.group.getByRole("button", { name: "Use left" })).toBeDisabled();
  await expect(row(page, "Distortion")).toContainText(/better/);

  await left.method.selectOption("Linear");
  await right.method.selectOption("Spectral");
  await right.group.getByRole("combobox", { name: "Order" }).selectOption("Hungarian");
  await expect(row(page, "Clearance").getByRole("cell").nth(1)).toContainText(/better/);

  await right.group.getByRole("button", { name: "Use right" }).click();
  await expect(studio.dialog).toHaveCount(0);
  await expect(studio.inspector.getByRole("combobox", { name: "Method" })).toHaveValue("spectral");
  await expect(studio.inspector.getByRole("combobox", { name: "Order" })).toHaveValue("hungarian");
  await studio.button("Undo").click();
  await expect(studio.inspector.getByRole("combobox", { name: "Method" })).toHaveValue("auto");
});

test("both play in step, and the paper's pairs are at hand", async ({ studio, page }) => {
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await studio.openFirst();
  await page.keyboard.press("Control+k");
  await page.getByRole("combobox", { name: "Search commands" }).fill("compare");
  await page.keyboard.press("Enter");
  const time = studio.dialog.getByRole("slider", { name: "Time" });
  const now = () => time.evaluate((slider) => (slider as HTMLInputElement).valueAsNumber);
  await expect.poll(now).toBeGreaterThan(0.2);
  await page.keyboard.press("Space");
  await expect(studio.dialog.getByRole("button", { name: "Play" })).toBeVisible();
  await page.getByRole("combobox", { name: "What to compare" }).selectOption("Straight or turning (figure 3)");
  await expect(side(page, "Left").method).toHaveValue("linear");
  await expect(side(page, "Right").method).toHaveValue("polar");
  await page.keyboard.press("Escape");
  await expect(studio.dialog).toHaveCount(0);
});

test("one crowd under three costs: places are found for each way and taken over with it", async ({ studio, page }) => {
  await studio.makeShow();
  await studio.planned();
  await studio.transitions.first().click();
  const before = await studio.sceneFile();
  await studio.inspector.getByRole("button", { name: "Compare side by side" }).click();
  await page
    .getByRole("combobox", { name: "What to compare" })
    .selectOption("A crowd under three costs (crowds, figure 10)");
  const way = (name: string) => studio.dialog.getByRole("group", { name, exact: true });
  for (const [name, cost] of [
    ["First", "least-effort"],
    ["Second", "euclidean"],
    ["Third", "manhattan"],
  ] as const) {
    await expect(way(name).getByRole("combobox", { name: "Assignment" })).toHaveValue(cost);
  }
  await way("Third").getByRole("button", { name: "Use third" }).click();
  await expect(studio.dialog).toHaveCount(0);
  const after = await studio.sceneFile();
  expect(after.segments?.[0]).toMatchObject({ method: "crowd", assignment: { cost: "manhattan" } });
  await studio.button("Undo").click();
  expect(await studio.sceneFile()).toEqual(before);
});
