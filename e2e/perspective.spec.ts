import { expectOpenToAll } from "./fixtures/axe";
import { picture } from "./fixtures/picture";
import { expect, type Studio, test } from "./fixtures/studio";

const view = (studio: Studio) => studio.page.getByRole("application", { name: "The show in perspective" });

/** The first example, standing, in perspective. */
async function openInPerspective(studio: Studio): Promise<void> {
  await studio.openFirst();
  await studio.planned();
  await studio.button("Perspective").click();
  await expect(view(studio)).toBeFocused();
}

test("a show is watched from all around, from the audience's seat, as figures, cones and discs", async ({
  studio,
  page,
}) => {
  await studio.openFirst();
  await studio.planned();
  await studio.button("Perspective").click();
  await expect(studio.button("Perspective")).toHaveAttribute("aria-pressed", "true");
  await expect(view(studio)).toBeFocused();
  await expect(studio.tool("Select")).toBeHidden();

  const seen = new Set([await picture(studio)]);
  for (const key of ["ArrowRight", "ArrowUp", "+", "Shift+ArrowLeft"]) {
    await page.keyboard.press(key);
    seen.add(await picture(studio));
  }
  await studio.drag([
    [0.5, 0.5],
    [0.6, 0.4],
  ]);
  seen.add(await picture(studio));
  await studio.button("Audience's seat").click();
  seen.add(await picture(studio));
  for (const bodies of ["Cones", "Discs"]) {
    await page.getByRole("combobox", { name: "Show agents as" }).selectOption(bodies);
    seen.add(await picture(studio));
  }
  expect(seen.size).toBe(9);

  await studio.button("Reset view").click();
  await page.getByRole("combobox", { name: "Show agents as" }).selectOption("Figures");
  seen.add(await picture(studio));
  expect(seen.size).toBe(9);
});

test("the show plays on in perspective, with the same playhead, and the plan is as it was", async ({
  studio,
  page,
}) => {
  await studio.openFirst();
  await studio.planned();
  await studio.button("Zoom in").click();
  const zoom = await page.getByRole("group", { name: "Zoom" }).getByRole("status").textContent();
  await page.keyboard.press("p");
  await expect(view(studio)).toBeFocused();

  const before = await studio.time();
  await page.keyboard.press("Space");
  await expect.poll(() => studio.time()).toBeGreaterThan(before + 0.2);
  await page.keyboard.press("Space");
  await expect(studio.button("Play")).toBeVisible();
  await page.keyboard.press("+");
  const paused = await studio.time();

  await page.keyboard.press("p");
  await expect(view(studio)).toHaveCount(0);
  expect(await studio.time()).toBe(paused);
  await expect(page.getByRole("group", { name: "Zoom" }).getByRole("status")).toHaveText(zoom ?? "");
  await page.keyboard.press("Space");
  await expect.poll(() => studio.time()).toBeGreaterThan(paused);
});

test("who is pressed is selected, and taking a tool leads back to the plan", async ({ studio, page }) => {
  await studio.openEmpty();
  await studio.draw([
    [0.499, 0.5],
    [0.501, 0.5],
  ]);
  await studio.button("Perspective").click();
  await expect(view(studio)).toBeFocused();
  await studio.button("Reset view").click();
  await expect
    .poll(async () => {
      await studio.click([0.5, 0.5]);
      return studio.inspector.getByText("Agent", { exact: true }).count();
    })
    .toBe(1);
  await studio.click([0.06, 0.5]);
  await expect(studio.inspector.getByText("Agent", { exact: true })).toHaveCount(0);
  await page.keyboard.press("d");
  await expect(view(studio)).toHaveCount(0);
  await expect(studio.tool("Draw")).toHaveAttribute("aria-pressed", "true");
});

test("a flight in the air is watched as cones, which climb", async ({ studio, page }) => {
  await studio.openFirst();
  const places = (x: number, z: number) => [-4, 0, 4].map((y) => [x - Math.abs(y), y, z]);
  const stage = { width: 90, depth: 60, height: 35 };
  const keyframes = [
    { time: 0, positions: places(-20, 5) },
    { time: 6, positions: places(20, 20) },
  ];
  await studio.drop("loop.eigenform.json", JSON.stringify({ format: "eigenform", version: 1, stage, keyframes }));
  await expect(studio.keyframes).toHaveCount(2);
  await studio.button("Perspective").click();
  await expect(page.getByRole("combobox", { name: "Show agents as" })).toHaveValue("cones");
  await page.getByRole("slider", { name: "Time" }).fill("3");
  await expect(studio.button("Play")).toBeVisible();
  const halfway = await picture(studio);
  await page.getByRole("slider", { name: "Time" }).fill("6");
  expect(await picture(studio)).not.toBe(halfway);
});

test("no frame is drawn while nothing changes", async ({ studio, page }) => {
  await openInPerspective(studio);
  await studio.button("Reset view").click();
  // What was under way has come to rest when a second goes by without a frame asked for.
  const quiet = () =>
    page.evaluate(async () => {
      let asked = 0;
      const ask = globalThis.requestAnimationFrame;
      globalThis.requestAnimationFrame = (callback) => {
        asked += 1;
        return ask(callback);
      };
      await new Promise((done) => setTimeout(done, 1000));
      globalThis.requestAnimationFrame = ask;
      return asked;
    });
  await expect.poll(quiet).toBe(0);
});

test("the perspective shuts nobody out", async ({ studio }) => {
  await openInPerspective(studio);
  await expectOpenToAll(studio, "perspective");
});

test("where nothing draws in three dimensions, that is said and the plan stays", async ({ studio, page }) => {
  await page.addInitScript(() => {
    const draws = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
      return kind === "webgl2" ? null : Reflect.apply(draws, this, [kind, ...rest]);
    } as typeof draws;
  });
  await studio.openFirst();
  await studio.button("Perspective").click();
  await expect(studio.message("does not draw in perspective")).toBeVisible();
  await expect(view(studio)).toHaveCount(0);
  await expect(studio.button("Plan")).toHaveAttribute("aria-pressed", "true");
  await expect(studio.tool("Select")).toBeVisible();
});

test("a graphics device that goes away leaves the plan", async ({ studio }) => {
  await openInPerspective(studio);
  await view(studio)
    .locator("canvas")
    .first()
    .evaluate((canvas) =>
      (canvas as HTMLCanvasElement).getContext("webgl2")?.getExtension("WEBGL_lose_context")?.loseContext(),
    );
  await expect(studio.message("graphics device went away")).toBeVisible();
  await expect(view(studio)).toHaveCount(0);
  await expect(studio.tool("Select")).toBeVisible();
});
