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
  await expect(inspector.getByText(/^1 is absent here/)).toBeVisible();
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
