import type { Locator, Page } from "@playwright/test";
import { expect, test } from "./fixtures/studio";

/** Tab until it is there, as a person would; the page has fewer stops than this. */
async function tabTo(page: Page, target: Locator): Promise<void> {
  for (let stops = 0; stops < 60; stops += 1) {
    if (await target.evaluate((element) => element.contains(document.activeElement))) return;
    await page.keyboard.press("Tab");
  }
  await expect(target).toBeFocused();
}

test("a show is made, played and shared without a pointer", async ({ studio, page }) => {
  await studio.openFirst();
  await test.step("an empty scene, by its name", async () => {
    await page.keyboard.press("Control+k");
    await page.getByRole("combobox", { name: "Search commands" }).fill("new");
    await page.keyboard.press("Enter");
    await expect(studio.keyframes).toHaveCount(1);
  });

  await test.step("tools by arrows; Enter takes one, Enter again places", async () => {
    await tabTo(page, page.getByRole("toolbar", { name: "Tools" }));
    await expect(studio.tool("Select")).toBeFocused();
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("ArrowDown");
    await expect(studio.tool("Shape")).toBeFocused();
    await page.keyboard.press("Enter");
    await expect(studio.tool("Shape")).toHaveAttribute("aria-pressed", "true");
    await page.keyboard.press("Enter");
    await expect(studio.tab("Agents")).toContainText("12");
  });

  await test.step("the next keyframe, and another shape in it", async () => {
    await page.keyboard.press("k");
    await expect(studio.keyframes).toHaveCount(2);
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("Enter");
    await page.keyboard.press("Enter");
    const [first, second] = (await studio.sceneFile(() => page.keyboard.press("Control+s"))).keyframes;
    expect(second?.positions).toHaveLength(12);
    expect(second?.positions).not.toEqual(first?.positions);
  });

  await test.step("Space plays and pauses", async () => {
    await tabTo(page, studio.button("Play"));
    await page.keyboard.press("Space");
    await expect(studio.button("Pause")).toBeFocused();
    await expect.poll(() => studio.time()).toBeGreaterThan(0.2);
    await page.keyboard.press("Space");
    await expect(studio.button("Play")).toBeFocused();
  });

  await test.step("help opens and gives the focus back", async () => {
    await page.keyboard.press("?");
    await expect(page.getByRole("dialog", { name: "How it works" })).toBeVisible();
    await page.keyboard.press("Escape");
    await expect(studio.dialog).toHaveCount(0);
    await expect(studio.button("Play")).toBeFocused();
  });

  await test.step("sharing from the palette gives the focus back, too", async () => {
    await page.keyboard.press("Control+k");
    await page.getByRole("combobox", { name: "Search commands" }).fill("share");
    await page.keyboard.press("Enter");
    await expect(page.getByRole("textbox", { name: "Link", exact: true })).toHaveValue(/#s=1\./);
    await expect(studio.button("Copy link")).toBeFocused();
    await page.keyboard.press("Escape");
    await expect(studio.dialog).toHaveCount(0);
    await expect(studio.button("Play")).toBeFocused();
  });
});

test("after a press of New, and after a closed dialog, keys reach the tools", async ({ studio, page }) => {
  await studio.openFirst();
  await studio.button("New").click();
  await expect(studio.keyframes).toHaveCount(1);
  await page.keyboard.press("d");
  await page.keyboard.press("Enter");
  await expect(studio.tab("Agents")).toContainText("12");
  await studio.button("Share").click();
  await expect(page.getByRole("textbox", { name: "Link", exact: true })).toHaveValue(/#s=1\./);
  await page.keyboard.press("Escape");
  await expect(studio.dialog).toHaveCount(0);
  await page.keyboard.press("Enter");
  await expect(studio.tab("Agents")).toContainText("24");
  await expect(studio.dialog).toHaveCount(0);
});

test("keyframes are walked, put in another order and deleted by keys", async ({ studio, page }) => {
  await studio.openFirst();
  const names = (): Promise<(string | null)[]> =>
    studio.keyframes.evaluateAll((options) => options.map((option) => option.getAttribute("aria-label")));
  const before = await names();
  const [a = "", b = "", ...rest] = before;
  await tabTo(page, page.getByRole("listbox", { name: "Keyframes" }));
  await page.keyboard.press("Home");
  await expect(studio.keyframes.first()).toBeFocused();
  await page.keyboard.press("ArrowRight");
  await expect(studio.keyframes.nth(1)).toHaveAttribute("aria-selected", "true");
  await page.keyboard.press("Alt+ArrowLeft");
  await expect.poll(names).toEqual([b, a, ...rest]);
  await expect(studio.keyframes.first()).toBeFocused();
  await page.keyboard.press("Delete");
  await expect.poll(names).toEqual([a, ...rest]);
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await expect.poll(names).toEqual(before);
});

test("an agent is moved by numbers in the table, and everybody by arrows on the stage", async ({ studio, page }) => {
  await studio.makeShow();
  await page.keyboard.press("Home");
  await tabTo(page, studio.tab("Inspector"));
  await page.keyboard.press("ArrowRight");
  await expect(studio.tab("Agents")).toBeFocused();
  const grid = page.getByRole("grid", { name: "Agents" });
  await tabTo(page, grid);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await expect(grid.getByRole("textbox")).toBeFocused();
  await page.keyboard.type("-20");
  await page.keyboard.press("Enter");
  await expect(grid.getByRole("textbox")).toHaveCount(0);
  const save = () => page.keyboard.press("Control+s");
  const [moved] = (await studio.sceneFile(save)).keyframes;
  expect(moved?.positions[0]?.[0]).toBe(-20);

  await tabTo(page, studio.button("Play"));
  await page.keyboard.press("Control+a");
  await page.keyboard.press("ArrowUp");
  const [nudged] = (await studio.sceneFile(save)).keyframes;
  const [from, to] = [moved?.positions ?? [], nudged?.positions ?? []];
  const steps = new Set(to.map(([, y], agent) => Math.round((y - (from[agent]?.[1] ?? 0)) * 1000)));
  expect(steps.size).toBe(1);
  expect([...steps][0]).toBeGreaterThan(0);
});

test("letters that are typed into a field are no shortcuts", async ({ studio, page }) => {
  await studio.makeShow();
  await studio.tool("Select").click();
  await studio.title.focus();
  await page.keyboard.type("kd dusk");
  await page.keyboard.press("Space");
  await expect(studio.title).toHaveValue("kd dusk ");
  await expect(studio.keyframes).toHaveCount(2);
  await expect(studio.tool("Select")).toHaveAttribute("aria-pressed", "true");
  await expect(studio.button("Play")).toBeVisible();
});

test("what is typed before the commands are there is looked for, and changes nothing", async ({ studio, page }) => {
  await studio.openFirst();
  await studio.planned();
  const count = await studio.keyframes.count();
  await page.route(/(palette|host)-.*\.js$/, async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 400));
    await route.continue();
  });
  await page.keyboard.press("Control+k");
  await page.keyboard.type("keyframe", { delay: 60 });
  await expect(page.getByRole("combobox", { name: "Search commands" })).toHaveValue("keyframe");
  await page.keyboard.press("Escape");
  await expect(studio.keyframes).toHaveCount(count);
});
