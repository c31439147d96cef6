import { expectOpenToAll } from "./fixtures/axe";
import type { SceneFile } from "./fixtures/scene-file";
import { expect, type Place, type Studio, test } from "./fixtures/studio";
import { smallTargets } from "./fixtures/targets";
import { touch } from "./fixtures/touch";

const LINE: readonly Place[] = [
  [0.3, 0.4],
  [0.7, 0.4],
];
const SLOPE: readonly Place[] = [
  [0.3, 0.4],
  [0.7, 0.6],
];

async function choose(studio: Studio, item: string): Promise<void> {
  await studio.button("Menu").tap();
  await studio.page.getByRole("dialog", { name: "Menu" }).getByRole("button", { name: item, exact: true }).tap();
}

async function startEmpty(studio: Studio): Promise<void> {
  await studio.openFirst();
  await choose(studio, "New");
  await expect(studio.keyframes).toHaveCount(1);
}

async function sceneFile(studio: Studio): Promise<SceneFile> {
  return studio.sceneFile(() => choose(studio, "Save"));
}

function widthOf(scene: SceneFile, keyframe: number): number {
  const xs = (scene.keyframes[keyframe]?.positions ?? []).map(([x]) => x);
  return Math.max(...xs) - Math.min(...xs);
}

test("a finger draws two formations and plays them", async ({ studio }) => {
  await startEmpty(studio);
  await studio.tool("Draw").tap();
  await touch(studio, [LINE]);
  await studio.button("Add keyframe").tap();
  await expect(studio.keyframes).toHaveCount(2);
  await touch(studio, [SLOPE]);
  const scene = await sceneFile(studio);
  expect(scene.keyframes.map(({ positions }) => positions.length)).toEqual([12, 12]);
  expect(scene.keyframes[1]?.positions).not.toEqual(scene.keyframes[0]?.positions);

  await studio.button("Play").tap();
  await expect.poll(() => studio.time()).toBeGreaterThan(0.2);
  await studio.button("Pause").tap();
});

test("two fingers zoom and pan under any tool, and draw nothing", async ({ studio }) => {
  await startEmpty(studio);
  await studio.tool("Draw").tap();
  await touch(studio, [LINE]);
  await studio.button("Add keyframe").tap();
  await expect(studio.keyframes).toHaveCount(2);
  await touch(studio, [
    [
      [0.45, 0.5],
      [0.3, 0.5],
    ],
    [
      [0.55, 0.5],
      [0.7, 0.5],
    ],
  ]);
  const pinched = await sceneFile(studio);
  expect(pinched.keyframes[1]?.positions).toEqual(pinched.keyframes[0]?.positions);

  // The fingers went from a tenth to four tenths apart: the same stroke is a quarter as wide on the stage now.
  await touch(studio, [LINE]);
  const drawn = await sceneFile(studio);
  const ratio = widthOf(drawn, 1) / widthOf(drawn, 0);
  expect(ratio).toBeGreaterThan(0.2);
  expect(ratio).toBeLessThan(0.3);
});

test("the inspector comes up as a sheet and goes down again", async ({ studio, page }) => {
  await studio.openFirst();
  await studio.planned();
  await expect(studio.inspector).not.toBeInViewport();
  await studio.transitions.first().tap();
  await expect(studio.inspector.getByRole("combobox", { name: "Method" })).toBeInViewport();
  await expectOpenToAll(studio, "transition in the sheet");
  await studio.inspector.getByRole("button", { name: "Close" }).tap();
  await expect(studio.inspector).not.toBeInViewport();

  await studio.button("Show inspector").tap();
  await studio.tab("Agents").tap();
  await expect(page.getByRole("grid", { name: "Agents" })).toBeInViewport();
});

test("nothing is out of reach on a narrow screen", async ({ studio, page }) => {
  await studio.openFirst();
  const overflow = () =>
    page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  expect(await overflow()).toBe(0);
  await expectOpenToAll(studio, "first page");
  await studio.button("Menu").tap();
  await expect(page.getByRole("dialog", { name: "Menu" })).toBeVisible();
  await expectOpenToAll(studio, "menu");
  await page.keyboard.press("Escape");
  await studio.button("Share").tap();
  await expect(studio.dialog).toContainText("characters");
  await expectOpenToAll(studio, "share");
  expect(await overflow()).toBe(0);
  await page.keyboard.press("Escape");
});

test("a thumb meets every control in sight", async ({ studio, page }) => {
  const expectWide = (where: string) => expect.poll(() => smallTargets(page), where).toEqual([]);
  /** All of what the open sheet holds, as far as it is scrolled. */
  async function expectWideSheet(where: string): Promise<void> {
    const panel = studio.inspector.getByRole("tabpanel");
    await panel.evaluate((element) => element.scrollTo(0, 0));
    for (let page = 0; page < 6; page += 1) {
      await expectWide(`${where}, ${page}`);
      await panel.evaluate((element) => element.scrollBy(0, element.clientHeight / 2));
    }
  }

  await page.setViewportSize({ width: 390, height: 844 });
  await studio.openFirst();
  await studio.planned();
  await expectWide("first page");
  for (const tool of ["Draw", "Shape"]) {
    await studio.tool(tool).tap();
    await expect(studio.stage.getByRole("spinbutton", { name: "Agents" })).toBeVisible();
    await expectWide(tool);
  }
  await studio.tool("Select").tap();
  for (const opener of ["More", "Menu"]) {
    await studio.button(opener).tap();
    await expect(page.getByRole("dialog", { name: opener })).toBeVisible();
    await expectWide(opener);
    await page.keyboard.press("Escape");
  }

  await page.keyboard.press("Control+a");
  await expect(page.getByRole("toolbar", { name: "Selection" })).toBeVisible();
  await expectWide("several agents");
  await studio.button("Show inspector").tap();
  await expectWideSheet("their sheet");
  await studio.inspector.getByRole("button", { name: "Close" }).tap();
  await studio.transitions.first().tap();
  await expectWideSheet("a transition's sheet");
});

test("a link that was sent opens on the phone", async ({ studio, visitor, page }) => {
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await visitor.makeShow();
  const link = await visitor.link();
  await studio.open(link);
  await expect(studio.keyframes).toHaveCount(2);
  await expect(studio.dialog).toHaveCount(0);
  await expect(studio.button("Pause")).toBeVisible();
});

test("what places a shape is in sight however much is asked before it", async ({ studio, page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await startEmpty(studio);
  await studio.tool("Shape").tap();
  await studio.button("Text…").tap();
  await studio.dialog.getByRole("textbox", { name: "Text", exact: true }).fill("GO");
  await expect(studio.button(/^Place \d+ agents$/)).toBeInViewport({ ratio: 1 });
});

test("what a tool can be told makes way for the sheet of a transition", async ({ studio }) => {
  await startEmpty(studio);
  await studio.tool("Draw").tap();
  await touch(studio, [LINE]);
  await studio.button("Add keyframe").tap();
  await expect(studio.keyframes).toHaveCount(2);
  const options = studio.stage.getByRole("group", { name: "Drawing" });
  await expect(options).toBeVisible();
  await studio.transitions.first().tap();
  await expect(studio.inspector.getByRole("combobox", { name: "Method" })).toBeVisible();
  await expect(options).toBeHidden();
});
