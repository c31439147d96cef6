import { expectOpenToAll } from "./fixtures/axe";
import { expect, test } from "./fixtures/studio";

/** The left end of the first line that `makeShow` draws. */
const LEFT = [0.25, 0.35] as const;

test("who is absent is hollow, comes back, and a link keeps it", async ({ studio, visitor, page }) => {
  await studio.makeShow();
  const { inspector } = studio;
  await studio.keyframes.first().click();
  await studio.tool("Select").click();
  await studio.click(LEFT);
  const absent = inspector.getByRole("checkbox", { name: /^Absent here/ });
  await absent.check();
  expect((await studio.sceneFile()).keyframes[0]?.absent).toEqual([0]);
  await expectOpenToAll(studio, "an absent agent");

  await studio.tab("Agents").click();
  await expect(page.getByRole("grid", { name: "Agents" }).getByRole("row", { name: /absent/ })).toHaveCount(1);
  await studio.tab("Inspector").click();

  await visitor.open(await studio.link());
  await expect(visitor.keyframes).toHaveCount(2);
  expect((await visitor.sceneFile()).keyframes[0]?.absent).toEqual([0]);
  await page.keyboard.press("Escape");

  await studio.keyframes.first().click();
  await expect(inspector.getByText(/^Agent 1 is absent here/)).toBeVisible();
  await studio.planned();
  await inspector.getByRole("button", { name: "Bring all back" }).click();
  expect((await studio.sceneFile()).keyframes[0]?.absent).toBeUndefined();
  await studio.button("Undo").click();
  expect((await studio.sceneFile()).keyframes[0]?.absent).toEqual([0]);
});

test("who is absent from both formations is not seen on the way", async ({ studio, page }) => {
  await studio.makeShow();
  const absent = studio.inspector.getByRole("checkbox", { name: /^Absent here/ });
  for (const keyframe of [0, 1]) {
    await studio.keyframes.nth(keyframe).click();
    await page.keyboard.press("ControlOrMeta+a");
    await absent.check();
  }
  await studio.planned().catch(() => {});
  const file = await studio.sceneFile();
  expect(file.keyframes.map((keyframe) => keyframe.absent?.length)).toEqual([12, 12]);
  await studio.button("Undo").click();
  await studio.button("Undo").click();
  expect((await studio.sceneFile()).keyframes.map((keyframe) => keyframe.absent)).toEqual([undefined, undefined]);
});

test("a formation with fewer places leaves a rest, who stay as the person says", async ({ studio, page }) => {
  await studio.makeShow();
  const { inspector } = studio;
  await studio.keyframes.nth(1).click();
  await studio.tool("Select").click();
  // The left foot of the gable: some of its places are for nobody.
  await studio.drag([
    [0.3, 0.5],
    [0.45, 0.9],
  ]);
  await inspector.getByRole("checkbox", { name: /^Absent here/ }).check();
  const gone = (await studio.sceneFile()).keyframes[1]?.absent?.length ?? 0;
  expect(gone).toBeGreaterThan(0);
  await page.keyboard.press("Escape");

  await studio.transitions.first().click();
  await inspector.getByRole("combobox", { name: "Assignment" }).selectOption("Squared");
  await inspector.getByRole("radio", { name: "Stay" }).check();
  await expect(inspector.getByText(/^\d+\.\d m in all, the longest walk \d/)).toBeVisible();
  await inspector.getByRole("button", { name: "Accept" }).click();
  await expect(inspector.getByRole("button", { name: "Accept" })).toHaveCount(0);
  const { keyframes } = await studio.sceneFile();
  expect(keyframes[1]?.absent).toBeUndefined();
  const stays = keyframes[1]?.positions.filter(([x, y], agent) => {
    const was = keyframes[0]?.positions[agent];
    return was?.[0] === x && was[1] === y;
  });
  expect(stays).toHaveLength(gone);
});

test("modes are of who stands there", async ({ studio, page }) => {
  await studio.makeShow();
  await studio.keyframes.first().click();
  await studio.tool("Select").click();
  await studio.click(LEFT);
  await studio.inspector.getByRole("checkbox", { name: /^Absent here/ }).check();
  await page.keyboard.press("Escape");
  await studio.keyframes.first().click();
  await studio.inspector.getByRole("button", { name: "Modes" }).click();
  const panel = page.getByRole("region", { name: "Modes", exact: true });
  await expect(panel).toContainText("Mode 2 of 11");
  await panel.getByRole("slider", { name: "Modes" }).press("End");
  await expect(panel).toContainText("Mode 11 of 11");
  await expect(panel).toContainText("exact");
});
