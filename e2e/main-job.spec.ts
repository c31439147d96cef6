import { unchosen } from "./fixtures/scene-file";
import { expect, test } from "./fixtures/studio";

test("a newcomer draws two formations, plays, and sends a link that opens elsewhere", async ({
  studio,
  visitor,
  baseURL,
}) => {
  await studio.makeShow();
  await studio.title.fill("Gable");
  await studio.title.press("Enter");
  await studio.planned();

  await studio.button("Play").click();
  await expect.poll(() => studio.time()).toBeGreaterThan(0.5);
  await studio.button("Pause").click();

  const link = await studio.link();
  expect(link.startsWith(`${baseURL}/`)).toBe(true);
  const sent = await studio.sceneFile();
  expect(sent.keyframes.map(({ positions }) => positions.length)).toEqual([12, 12]);

  await visitor.open(link);
  await expect(visitor.keyframes).toHaveCount(2);
  await expect(visitor.title).toHaveValue("Gable");
  expect(await visitor.sceneFile()).toEqual(sent);
});

test("drawing a second formation asks nothing, and the first play is one key away", async ({ studio, page }) => {
  await studio.makeShow();
  await expect(studio.dialog).toHaveCount(0);
  await page.keyboard.press("Space");
  await expect(studio.button("Pause")).toBeVisible();
  await expect.poll(() => studio.time()).toBeGreaterThan(0.2);

  const [first, second] = (await studio.sceneFile()).keyframes;
  expect(second?.positions).toHaveLength(first?.positions.length ?? 0);
  expect(second?.positions).not.toEqual(first?.positions);
});

test("agents take the new places by the least total squared distance", async ({ studio }) => {
  await studio.openEmpty();
  await studio.draw([
    [0.3, 0.4],
    [0.7, 0.4],
  ]);
  await studio.button("Add keyframe").click();
  // The same line from its other end: who kept the order of the stroke would cross the whole stage.
  await studio.draw([
    [0.7, 0.6],
    [0.3, 0.6],
  ]);
  await expect
    .poll(async () => {
      const [first, second] = unchosen(await studio.sceneFile()).keyframes;
      return first?.positions.every(([x], agent) => Math.abs((second?.positions[agent]?.[0] ?? 1e9) - x) < 0.5);
    })
    .toBe(true);
});
