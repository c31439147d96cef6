import { expectOpenToAll } from "./fixtures/axe";
import { expect, test } from "./fixtures/studio";

test("modes are a sheet on a phone, and two methods stand one above the other", async ({ studio, page }) => {
  await studio.openFirst();
  await studio.planned();
  await studio.transitions.first().tap();
  await studio.inspector.getByRole("button", { name: "Modes" }).tap();
  const panel = page.getByRole("region", { name: "Modes", exact: true });
  await expect(panel.getByRole("img", { name: /^Hungarian/ })).toBeVisible();
  await expectOpenToAll(studio, "modes");
  await studio.button("Close Modes").tap();
  await studio.inspector.getByRole("button", { name: "Compare side by side" }).tap();
  const [left, right] = ["Left", "Right"].map((name) => page.getByRole("group", { name }));
  await expect(page.getByRole("row", { name: /^Distortion .*better/ })).toBeVisible();
  const boxes = [await left?.boundingBox(), await right?.boundingBox()];
  expect((boxes[1]?.y ?? 0) - (boxes[0]?.y ?? 0)).toBeGreaterThan(100);
  expect(await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth)).toBe(
    0,
  );
  await expectOpenToAll(studio, "compare");

  await studio.dialog.getByRole("radio", { name: "Table and plots" }).check();
  await expect(studio.dialog.getByRole("table", { name: "Averages over time of all ways" })).toBeInViewport({
    ratio: 0.5,
  });
});
