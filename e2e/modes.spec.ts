import { expectOpenToAll } from "./fixtures/axe";
import { expect, test } from "./fixtures/studio";

test("a newcomer walks through the modes of a formation, and all of them together are the formation", async ({
  studio,
  page,
}) => {
  await studio.makeShow();
  await studio.keyframes.first().click();
  await studio.inspector.getByRole("button", { name: "Modes" }).click();
  const panel = page.getByRole("region", { name: "Modes", exact: true });
  const modes = panel.getByRole("slider", { name: "Modes" });
  await expect(panel).toContainText("Mode 2 of 12");
  await expect(panel).toContainText(/\d+ of \d+ ties/);
  await expect(panel).toContainText(/\d m off/);
  await modes.press("Home");
  await modes.press("ArrowLeft");
  await expect(panel).toContainText("Mode 1 of 12");
  await expect(panel).toContainText(/0 of \d+ ties/);
  for (let mode = 2; mode <= 12; mode += 1) await modes.press("ArrowRight");
  await expect(panel).toContainText("Mode 12 of 12");
  await expect(panel).toContainText("exact");
  await page.keyboard.press("Escape");
  await expect(panel).toHaveCount(0);
  await expect(studio.inspector).toBeVisible();
});

test("a transition shows its modes matched under every order, and their eigenvalues on the way", async ({
  studio,
  page,
}) => {
  await studio.openFirst();
  await studio.transitions.first().click();
  await studio.inspector.getByRole("button", { name: "Modes" }).click();
  const panel = page.getByRole("region", { name: "Modes", exact: true });
  for (const order of ["Eigenvalue", "Greedy", "Max-min", "Hungarian"]) {
    await expect(panel.getByRole("img", { name: new RegExp(`^${order}: .* on average`) })).toBeVisible();
  }
  await expect(panel).toContainText("Eigenvalues on the way");
});

test("neither the modes nor the comparison shut anybody out", async ({ studio, page }) => {
  await studio.openFirst();
  await studio.planned();
  await studio.transitions.first().click();
  await studio.inspector.getByRole("button", { name: "Modes" }).click();
  await expect(page.getByRole("img", { name: /^Hungarian/ })).toBeVisible();
  await expectOpenToAll(studio, "modes");
  await studio.button("Close Modes").click();
  await studio.inspector.getByRole("button", { name: "Compare side by side" }).click();
  await expect(page.getByRole("row", { name: /^Distortion .*better/ })).toBeVisible();
  await expectOpenToAll(studio, "compare");
});
