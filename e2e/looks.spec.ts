import { expectOpenToAll } from "./fixtures/axe";
import { expect, test } from "./fixtures/studio";

test("the first page, the empty stage and what tools ask shut nobody out", async ({ studio, page }) => {
  await studio.openFirst();
  await studio.planned();
  await expectOpenToAll(studio, "first page");

  await studio.tab("Agents").click();
  await expect(page.getByRole("grid", { name: "Agents" })).toBeVisible();
  await expectOpenToAll(studio, "agents table");
  await studio.tab("Inspector").click();

  await studio.button("New").click();
  await expect(page.getByRole("note")).toBeVisible();
  await expectOpenToAll(studio, "empty stage with its hint");
  for (const tool of ["Draw", "Shape"]) {
    await studio.tool(tool).click();
    await expect(studio.stage.getByRole("spinbutton", { name: "Agents" })).toBeVisible();
    await expectOpenToAll(studio, `options of ${tool}`);
  }
  await studio.drop("broken.json", "{");
  await expect(studio.message("broken.json was not opened")).toBeVisible();
  await expectOpenToAll(studio, "a message");
});

test("no panel of the inspector shuts anybody out", async ({ studio, page }) => {
  await studio.makeShow();
  await studio.planned();
  const kind = (name: string) => studio.inspector.getByText(name, { exact: true }).first();

  await expect(kind("Keyframe")).toBeVisible();
  await expectOpenToAll(studio, "keyframe");

  await studio.transitions.first().click();
  await expect(page.getByRole("region", { name: "Measures" })).toBeVisible();
  await expectOpenToAll(studio, "transition");

  await studio.keyframes.first().click();
  await studio.tool("Select").click();
  await studio.click([0.25, 0.35]);
  await expect(kind("Agent")).toBeVisible();
  await expectOpenToAll(studio, "agent");

  // Halfway between the first two of twelve on a line from 0.25 to 0.75.
  await studio.tool("Tie").click();
  await studio.click([0.25 + 0.25 / 11, 0.35]);
  await expect(kind("Tie")).toBeVisible();
  await expectOpenToAll(studio, "tie");

  await page.keyboard.press("v");
  await page.keyboard.press("Control+a");
  await expect(page.getByRole("toolbar", { name: "Selection" })).toBeVisible();
  await expectOpenToAll(studio, "several agents");

  await page.keyboard.press("Control+g");
  await expect(kind("Group")).toBeVisible();
  await studio.inspector.getByRole("checkbox", { name: "Ties inside" }).check();
  await expectOpenToAll(studio, "group");
});

test("no dialog shuts anybody out", async ({ studio, page }) => {
  await studio.makeShow();
  const own = await studio.link();
  for (const [button, ready] of [
    ["Examples", /Flower/],
    ["Help", /Draw a formation/],
    ["Commands", /Undo/],
    ["Share", /characters/],
    ["Export", /Keyframes, CSV/],
  ] as const) {
    await studio.button(button).click();
    await expect(studio.dialog).toContainText(ready);
    await expectOpenToAll(studio, button);
    await page.keyboard.press("Escape");
    await expect(studio.dialog).toHaveCount(0);
  }
  await page.goto(own);
  await expect(studio.dialog).toContainText("Keep mine");
  await expectOpenToAll(studio, "the question about a link");
});
