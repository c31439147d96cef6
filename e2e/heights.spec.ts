import { expect, type Studio, test } from "./fixtures/studio";

/** Heights of everybody at a keyframe; empty on the plane. */
async function heights(studio: Studio, keyframe: number): Promise<number[]> {
  const positions: readonly (readonly number[])[] = (await studio.sceneFile()).keyframes[keyframe]?.positions ?? [];
  return positions.flatMap((place) => place.slice(2));
}

test("agents are lifted by a number, by keys and from the front; the show plays in space and comes down again", async ({
  studio,
  page,
}) => {
  await studio.makeShow();
  await studio.tool("Select").click();
  await page.keyboard.press("Control+a");
  const z = studio.inspector.getByRole("spinbutton", { name: "z" });
  await z.fill("5");
  await z.press("Enter");
  expect(new Set(await heights(studio, 1))).toEqual(new Set([5]));
  expect(new Set(await heights(studio, 0))).toEqual(new Set([0]));
  await studio.planned();

  await studio.stage.click({ position: { x: 5, y: 5 }, trial: true });
  await z.blur();
  await page.keyboard.press("PageUp");
  expect(new Set(await heights(studio, 1))).toEqual(new Set([5.1]));
  await studio.button("Undo").click();
  expect(new Set(await heights(studio, 1))).toEqual(new Set([5]));

  // From the front up is up.
  await studio.button("Front").click();
  await expect(studio.button("Front")).toHaveAttribute("aria-pressed", "true");
  const before = (await studio.sceneFile()).keyframes[1]?.positions.map(([x, y]) => [x, y]);
  await page.keyboard.press("Shift+ArrowUp");
  expect(new Set(await heights(studio, 1))).toEqual(new Set([6]));
  expect((await studio.sceneFile()).keyframes[1]?.positions.map(([x, y]) => [x, y])).toEqual(before);
  await studio.planned();

  await studio.button("Plan").click();
  await z.fill("0");
  await z.press("Enter");
  expect(await heights(studio, 1)).toEqual([]);
  expect(await heights(studio, 0)).toEqual([]);
});

test("a formation is drawn upright from the front", async ({ studio }) => {
  await studio.openEmpty();
  await studio.button("Front").click();
  await studio.draw([
    [0.3, 0.4],
    [0.5, 0.25],
    [0.7, 0.4],
  ]);
  const lifted = await heights(studio, 0);
  expect(lifted.length).toBeGreaterThan(5);
  expect(Math.max(...lifted)).toBeGreaterThan(Math.min(...lifted) + 1);
  const positions = (await studio.sceneFile()).keyframes[0]?.positions ?? [];
  expect(positions.every(([, y]) => y === 0)).toBe(true);
});
