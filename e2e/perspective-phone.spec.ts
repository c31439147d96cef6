import { expectOpenToAll } from "./fixtures/axe";
import { picture } from "./fixtures/picture";
import { expect, test } from "./fixtures/studio";
import { touch } from "./fixtures/touch";

test("a phone goes around a show with one finger and nearer with two", async ({ studio, page }) => {
  await studio.openFirst();
  await studio.button("Menu").tap();
  await studio.button("Perspective").tap();
  await expect(page.getByRole("application")).toBeVisible();
  await page.keyboard.press("Escape");
  await expectOpenToAll(studio, "perspective on a phone");

  const seen = new Set([await picture(studio)]);
  await touch(studio, [
    [
      [0.3, 0.5],
      [0.6, 0.45],
    ],
  ]);
  seen.add(await picture(studio));
  await touch(studio, [
    [
      [0.4, 0.5],
      [0.2, 0.5],
    ],
    [
      [0.6, 0.5],
      [0.8, 0.5],
    ],
  ]);
  seen.add(await picture(studio));
  expect(seen.size).toBe(3);

  await studio.stage.getByRole("button", { name: "Plan", exact: true }).tap();
  await expect(page.getByRole("application")).toHaveCount(0);
  await expect(studio.tool("Select")).toBeVisible();
});
