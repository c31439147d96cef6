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
