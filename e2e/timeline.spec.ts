import type { Page } from "@playwright/test";
import { expect, test } from "./fixtures/studio";

const names = (page: Page): Promise<(string | null)[]> =>
  page
    .getByRole("listbox", { name: "Keyframes" })
    .getByRole("option")
    .evaluateAll((options) => options.map((option) => option.getAttribute("aria-label")));

test("who counts reads counts: in the clock, by dragging and by typing", async ({ studio, page }) => {
  await studio.makeShow();
  await studio.button("Counts").click();
  await expect(studio.button("Counts")).toHaveAttribute("aria-pressed", "true");

  await test.step("the clock says bar and count", async () => {
    await page.getByRole("slider", { name: "Time" }).focus();
    await page.keyboard.press("End");
    await expect(studio.timeline.getByTitle("Bar and count")).toHaveText("3.1");
  });

  await test.step("lengths are typed in counts and bars", async () => {
    await studio.transitions.first().focus();
    await page.keyboard.press("Enter");
    const duration = studio.inspector.getByRole("spinbutton", { name: "Duration" });
    await duration.fill("4 bars");
    await duration.press("Enter");
    await expect(duration).toHaveValue("16");
    await duration.fill("12 c");
    await duration.press("Enter");
    await expect(duration).toHaveValue("12");
    await duration.fill("3 s");
    await duration.press("Enter");
    await expect(duration).toHaveValue("6");
    await expect.poll(async () => (await studio.sceneFile()).keyframes[1]?.time).toBe(3);
  });

  await test.step("a dragged keyframe goes from count to count", async () => {
    const box = await studio.keyframes.nth(1).boundingBox();
    if (!box) throw new Error("the keyframe is not shown");
    const [x, y] = [box.x + box.width / 2, box.y + 20];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 30, y, { steps: 4 });
    await page.mouse.move(x + 47, y, { steps: 4 });
    await page.mouse.up();
    const time = (await studio.sceneFile()).keyframes[1]?.time ?? 0;
    expect(time).not.toBe(3);
    expect(time * 2).toBe(Math.round(time * 2));
  });

  await test.step("the choice is the viewer's: it is there again after a reload, and not in the scene", async () => {
    await page.reload();
    await expect(studio.button("Counts")).toHaveAttribute("aria-pressed", "true");
    await studio.button("Counts").click();
    await page.reload();
    await expect(studio.button("Counts")).toHaveAttribute("aria-pressed", "false");
  });
});

test("a run of keyframes is drawn by keys, reversed and repeated, each one undo away", async ({ studio, page }) => {
  await studio.openFirst();
  const before = await names(page);
  const [a = "", b = "", c = "", ...rest] = before;
  await studio.keyframes.first().focus();
  await page.keyboard.press("Home");
  await page.keyboard.press("Shift+ArrowRight");
  await page.keyboard.press("Shift+ArrowRight");
  await expect(studio.keyframes.and(page.getByRole("option", { selected: true }))).toHaveCount(3);

  await test.step("the palette reverses it", async () => {
    await page.keyboard.press("Control+k");
    await page.getByRole("combobox", { name: "Search commands" }).fill("reverse run");
    await page.keyboard.press("Enter");
    await expect.poll(() => names(page)).toEqual([c, b, a, ...rest]);
    await page.keyboard.press("Control+z");
    await expect.poll(() => names(page)).toEqual(before);
  });

  await test.step("the inspector repeats it", async () => {
    await studio.inspector.getByRole("button", { name: "Repeat run" }).click();
    await expect.poll(() => names(page)).toEqual([a, b, c, a, b, c, ...rest]);
    await expect(studio.keyframes.and(page.getByRole("option", { selected: true }))).toHaveCount(3);
    await studio.planned();
    await page.keyboard.press("Control+z");
    await expect.poll(() => names(page)).toEqual(before);
  });

  await test.step("so does the menu of a keyframe in it", async () => {
    await studio.keyframes.first().click();
    await studio.keyframes.nth(1).click({ modifiers: ["Shift"] });
    await studio.keyframes.nth(1).click({ button: "right" });
    await page.getByRole("menuitem", { name: "Reverse run" }).click();
    await expect.poll(() => names(page)).toEqual([b, a, c, ...rest]);
  });
});

test("whoever drags past what the show allows is told where it stopped", async ({ studio, page }) => {
  await studio.makeShow();
  await studio.keyframes.first().click();
  const hold = page.getByRole("slider", { name: /^Hold of/ });
  const box = await hold.boundingBox();
  if (!box) throw new Error("the handle of the hold is not shown");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(1400, y, { steps: 6 });
  await expect(studio.timeline.getByText("As near as it can be: 3.9 s")).toBeVisible();
  await page.mouse.move(x + 20, y, { steps: 3 });
  await expect(studio.timeline.getByText("As near as it can be")).toHaveCount(0);
  await page.mouse.move(x, y);
  await page.mouse.up();
  await hold.press("Home");
  await hold.press("ArrowLeft");
  await expect(page.getByRole("status").filter({ hasText: "Hold: As near as it can be: 0 s" })).toBeAttached();
});

test("the tip of the leftmost button is in the window", async ({ studio, page }) => {
  await studio.makeShow();
  const button = studio.button("To start");
  await button.hover();
  const { from, width } = await button.evaluate((element) => {
    const tip = getComputedStyle(element, "::after");
    const shift = tip.translate === "none" ? 0 : Number.parseFloat(tip.translate) / 100;
    const width = Number.parseFloat(tip.width);
    return { from: element.getBoundingClientRect().left + Number.parseFloat(tip.left) + shift * width, width };
  });
  expect(from).toBeGreaterThanOrEqual(0);
  expect(from + width).toBeLessThanOrEqual(page.viewportSize()?.width ?? 0);
});
