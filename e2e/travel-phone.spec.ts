import { expect, test } from "./fixtures/studio";

test("on a phone the inspector makes way for the path, and buttons stand for keys", async ({ studio, page }) => {
  await studio.openFirst();
  await studio.transitions.first().tap();
  await studio.inspector.getByRole("button", { name: "Draw a path" }).tap();
  await expect(studio.inspector).not.toBeInViewport();
  const bar = page.getByRole("group", { name: "Path" });
  await bar.getByRole("button", { name: "Cancel" }).tap();
  await expect(bar).toHaveCount(0);
  await studio.button("Show inspector").tap();
  await studio.inspector.getByRole("button", { name: "Draw a path" }).tap();
  await bar.getByRole("button", { name: "Make a bow" }).tap();
  await expect(page.getByRole("button", { name: "Point 1 of the path" })).toBeVisible();
});
