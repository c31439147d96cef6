import { expectOpenToAll } from "./fixtures/axe";
import { expect, test, textOf } from "./fixtures/studio";

/** From the first line of `makeShow` around to the right and down to its second formation. */
const AROUND = [
  [0.5, 0.35],
  [0.62, 0.34],
  [0.74, 0.4],
  [0.78, 0.52],
  [0.7, 0.62],
  [0.5, 0.6],
] as const;

test("a formation travels along a path that is drawn, bent, and taken away", async ({ studio, page }) => {
  await studio.makeShow();
  const { inspector } = studio;
  await studio.transitions.first().click();
  await inspector.getByRole("button", { name: "Draw a path" }).click();
  await studio.drag(AROUND);
  await expect(inspector.getByText(/^The formation turns with it, in all \d+° to the right/)).toBeVisible();
  const drawn = (await studio.sceneFile()).segments?.[0]?.path ?? [];
  expect(drawn.length).toBeGreaterThan(2);
  await studio.planned();
  await expectOpenToAll(studio, "a path");

  const point = page.getByRole("button", { name: "Point 1 of the path" });
  await point.focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  const bent = (await studio.sceneFile()).segments?.[0]?.path ?? [];
  expect(bent[1]?.[0]).toBeCloseTo((drawn[1]?.[0] ?? 0) + 0.2, 6);

  const box = await point.boundingBox();
  if (!box) throw new Error("the point is not shown");
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, box.y - 60, { steps: 4 });
  await page.mouse.up();
  const pulled = (await studio.sceneFile()).segments?.[0]?.path ?? [];
  expect(pulled[1]?.[1]).toBeGreaterThan((bent[1]?.[1] ?? 0) + 0.5);

  // The pull, both presses, the stroke: a step each.
  await studio.button("Undo").click();
  expect((await studio.sceneFile()).segments?.[0]?.path).toEqual(bent);
  await studio.button("Undo").click();
  expect((await studio.sceneFile()).segments?.[0]?.path).toEqual(drawn);

  await inspector.getByRole("button", { name: "Remove the path" }).click();
  expect((await studio.sceneFile()).segments?.[0]?.path).toBeUndefined();
  await expect(point).toHaveCount(0);
});

test("a click is too short for a path, and a path that crosses itself is told of", async ({
  studio,
  visitor,
  page,
}) => {
  await studio.makeShow();
  await studio.transitions.first().click();
  await studio.inspector.getByRole("button", { name: "Draw a path" }).click();
  // Where the inspector has made way, the same is said over the stage, once the pen is there.
  await page.setViewportSize({ width: 960, height: 900 });
  await expect(studio.stage.getByRole("group", { name: "Path" })).toContainText("Draw from where they stand");
  await page.setViewportSize({ width: 1440, height: 900 });
  await studio.click([0.5, 0.5]);
  await expect(studio.inspector.getByText("Too short for a path")).toBeVisible();
  await studio.drag([
    [0.5, 0.35],
    [0.7, 0.6],
    [0.8, 0.45],
    [0.7, 0.38],
    [0.5, 0.6],
  ]);
  await expect(studio.message("It crosses itself")).toBeVisible();
  await expect(studio.inspector.getByText("It crosses itself")).toBeVisible();

  const download = await studio.downloadOf(() => studio.button("Save").click());
  await visitor.openFirst();
  await visitor.drop("loop.json", await textOf(download));
  await expect(visitor.message("crosses itself")).toBeVisible();
});

test("without a pointer a path is a bow, and a link carries it", async ({ studio, visitor, page }) => {
  await studio.makeShow();
  const { inspector } = studio;
  await studio.transitions.first().click();
  await inspector.getByRole("button", { name: "Draw a path" }).press("Enter");
  await expect(inspector.getByText(/^Draw from where they stand/)).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(inspector.getByText(/^Draw from where they stand/)).toHaveCount(0);
  await inspector.getByRole("button", { name: "Draw a path" }).press("Enter");
  await expect(inspector.getByText(/^Draw from where they stand/)).toBeVisible();
  await page.keyboard.press("Enter");
  await expect(page.getByRole("button", { name: "Point 3 of the path" })).toBeVisible();
  const { path } = (await studio.sceneFile()).segments?.[0] ?? {};
  expect(path).toHaveLength(5);

  await visitor.open(await studio.link());
  await expect(visitor.keyframes).toHaveCount(2);
  expect((await visitor.sceneFile()).segments?.[0]?.path).toEqual(path);
});
