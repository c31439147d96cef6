import { expect, test, textOf } from "./fixtures/studio";

test("an obstacle is placed, measured, named and deleted by keys alone", async ({ studio, page }) => {
  await studio.openEmpty();
  const invitation = page.getByRole("heading", { name: "Draw a formation here" });
  await expect(invitation).toBeVisible();
  await page.keyboard.press("o");
  await expect(studio.tool("Obstacle")).toHaveAttribute("aria-pressed", "true");
  await studio.tool("Obstacle").focus();
  await page.keyboard.press("Enter");
  const radius = studio.inspector.getByRole("spinbutton", { name: "Radius" });
  await expect(radius).toHaveValue("2");
  await expect(invitation).toBeHidden();
  await radius.fill("1.25");
  await radius.press("Enter");
  const name = studio.inspector.getByRole("textbox", { name: "Name" });
  await name.fill("Fountain");
  await name.press("Enter");
  await expect(studio.inspector.getByRole("heading", { name: "Fountain" })).toBeVisible();
  const { obstacles } = await studio.sceneFile();
  expect(obstacles).toMatchObject([{ name: "Fountain", kind: "circle", radius: 1.25 }]);
  await studio.inspector.getByRole("button", { name: /^Delete/ }).press("Enter");
  await expect(studio.inspector.getByRole("heading", { name: "Fountain" })).toHaveCount(0);
  await page.keyboard.press("Control+z");
  await expect.poll(async () => (await studio.sceneFile()).obstacles?.length).toBe(1);
});

test("a drag makes a circle, clicks a polygon, and agents go around", async ({ studio, page }) => {
  await studio.makeShow();
  await studio.tool("Obstacle").click();
  await studio.drag([
    [0.5, 0.47],
    [0.5, 0.5],
  ]);
  for (const corner of [
    [0.1, 0.8],
    [0.2, 0.8],
    [0.2, 0.9],
  ] as const) {
    await studio.click(corner);
  }
  await page.keyboard.press("Enter");
  const file = await studio.sceneFile();
  expect(file.obstacles?.map(({ kind }) => kind)).toEqual(["circle", "polygon"]);

  await test.step("both are there again after a reload", async () => {
    await expect(page.getByText("Saved on this device")).toBeVisible();
    await page.reload();
    await expect.poll(async () => (await studio.sceneFile()).obstacles).toEqual(file.obstacles);
  });

  await test.step("the clearance is kept at every frame", async () => {
    await studio.planned();
    await studio.button("Export").click();
    const text = await textOf(await studio.downloadOf(() => studio.button("Download Motion, JSON").click()));
    const { positions } = JSON.parse(text) as { positions: [number, number][][] };
    const circle = file.obstacles?.[0];
    if (circle?.kind !== "circle") throw new Error("the first obstacle is a circle");
    const [x, y] = circle.center;
    const distances = positions.flat().map((at) => Math.hypot(at[0] - x, at[1] - y) - circle.radius);
    expect(Math.min(...distances)).toBeGreaterThanOrEqual(0.5 - 1e-3);
  });
});

test("an agent tied to an obstacle by hand goes around it and holds its clearance", async ({ studio, page }) => {
  await studio.makeShow();
  await studio.tool("Obstacle").click();
  await studio.drag([
    [0.3, 0.525],
    [0.3, 0.55],
  ]);
  // The first agent, whose way leads straight through it.
  await studio.tool("Tie").click();
  await studio.drag([
    [0.35, 0.7],
    [0.33, 0.6],
    [0.3, 0.525],
  ]);
  await expect(studio.inspector.getByRole("heading", { name: "Tied to it" })).toBeVisible();
  const { adjacency, obstacles } = await studio.sceneFile();
  const [agent] = adjacency?.obstacleTies?.[0] ?? [];
  const circle = obstacles?.[0];
  if (agent === undefined || circle?.kind !== "circle") throw new Error("an agent is tied to a circle");

  await studio.planned();
  await studio.transitions.first().click();
  const measures = studio.inspector.getByRole("region", { name: "Measures" });
  await expect(measures.getByRole("term").filter({ hasText: "Held clearance" })).toBeVisible();
  await studio.button("Export").click();
  const text = await textOf(await studio.downloadOf(() => studio.button("Download Motion, JSON").click()));
  await page.keyboard.press("Escape");
  const { positions } = JSON.parse(text) as { positions: [number, number][][] };
  const [x, y] = circle.center;
  const clearances = positions.map((places) => {
    const at = places[agent] ?? [Number.NaN, Number.NaN];
    return Math.hypot(at[0] - x, at[1] - y) - circle.radius;
  });
  const ends = Math.min(clearances[0] ?? Number.NaN, clearances.at(-1) ?? Number.NaN);
  expect(ends).toBeGreaterThan(0.5);
  expect(Math.min(...clearances)).toBeGreaterThanOrEqual(ends - 1e-3);
});
