import type { TestInfo } from "@playwright/test";
import { crowdTable, unchosen } from "./fixtures/scene-file";
import { expect, FIRST_STROKE, type Place, SECOND_STROKE, type Studio, test } from "./fixtures/studio";

/** Written beside the story's result; what is asserted leaves a busy machine its time. */
function note(info: TestInfo, type: string, milliseconds: number): void {
  info.annotations.push({ type, description: `${Math.round(milliseconds)} ms` });
}

test("a killed engine is back with the scene intact and playable", async ({ studio, page }, info) => {
  await studio.makeShow();
  await studio.planned();
  const before = unchosen(await studio.sceneFile());
  await studio.transitions.first().click();
  const method = studio.inspector.getByRole("combobox", { name: "Method" });
  await expect(method).toBeVisible();

  for (const [label, word] of [
    ["Polar", "Polar"],
    ["Linear", "Linear"],
  ] as const) {
    const [planner] = page.workers();
    if (!planner) throw new Error("there is no worker to kill");
    // Something to plan at the moment of death, so that a new motion proves the engine is back.
    const recovery = watchRibbon(studio, word);
    const start = await page.evaluate(() => performance.now());
    await planner.evaluate(() => self.close());
    await method.selectOption({ label });
    const milliseconds = (await recovery) - start;
    note(info, "recovery", milliseconds);
    expect(milliseconds).toBeLessThan(5000);
  }
  await expect(studio.message("The engine stopped and is starting again.").first()).toBeVisible();

  await studio.button("Undo").click();
  await studio.button("Undo").click();
  await studio.planned();
  expect(unchosen(await studio.sceneFile())).toEqual(before);
  await studio.button("Play").click();
  await expect.poll(() => studio.time()).toBeGreaterThan(0.2);
});

test("with every worker killed at once questions are answered all the same", async ({ studio, page }) => {
  await studio.makeShow();
  await studio.planned();
  const before = unchosen(await studio.sceneFile());
  await Promise.all(page.workers().map((worker) => worker.evaluate(() => self.close())));
  expect(unchosen(await studio.sceneFile())).toEqual(before);
  expect(await studio.link()).toMatch(/#s=1\./);
});

test("a moved agent changes both its transitions while it is dragged, as one step to undo", async ({
  studio,
  page,
}) => {
  await studio.makeShow();
  await studio.button("Add keyframe").click();
  await expect(studio.keyframes).toHaveCount(3);
  await studio.draw(FIRST_STROKE);
  await studio.planned();
  await studio.keyframes.nth(1).click();
  const before = unchosen(await studio.sceneFile());
  const names = await ribbonNames(studio);
  expect(names).toHaveLength(2);

  await studio.tool("Select").click();
  const [corner] = SECOND_STROKE;
  const beside: Place = [0.374, 0.676];
  await studio.point(corner ?? beside);
  await page.mouse.down();
  await studio.point([0.36, 0.6]);
  await studio.point(beside);
  await expect
    .poll(async () => {
      const now = await ribbonNames(studio);
      return now.length === 2 && now.every((name, index) => name !== names[index] && name.includes("clash"));
    })
    .toBe(true);
  await page.mouse.up();

  await studio.planned();
  expect(unchosen(await studio.sceneFile())).not.toEqual(before);
  await studio.button("Undo").click();
  expect(unchosen(await studio.sceneFile())).toEqual(before);
});

test("a show of 300 is watchable at once, gets planned, and the page goes on drawing", async ({
  studio,
  page,
}, info) => {
  test.slow();
  await studio.openEmpty();
  await studio.drop("crowd.csv", crowdTable(300, 3));
  await expect(studio.keyframes).toHaveCount(3);
  const gaps = longestFrameGap(studio);
  await studio.button("Play").click();
  await expect.poll(() => studio.time()).toBeGreaterThan(0.2);
  await studio.planned();
  await page.evaluate(() => dispatchEvent(new Event("enough")));
  const gap = await gaps;
  note(info, "longest gap between frames", gap);
  expect(gap).toBeLessThan(2000);
});

test("long work is shown, can be canceled and taken up again", async ({ studio, page }, info) => {
  await studio.openEmpty();
  await studio.drop("crowd.csv", crowdTable(1000, 3));
  await expect(studio.keyframes).toHaveCount(3);
  await expect(page.getByRole("progressbar", { name: "Planning" })).toBeVisible();

  const start = performance.now();
  await studio.button("Cancel").click();
  await expect(studio.transitions.filter({ hasText: "Canceled" })).toHaveCount(2);
  note(info, "cancel", performance.now() - start);
  await expect(page.getByRole("progressbar", { name: "Planning" })).toHaveCount(0);

  await studio.button("Play").click();
  await expect.poll(() => studio.time()).toBeGreaterThan(0.2);
  await studio.button("Pause").click();

  await studio.transitions.first().click();
  await studio.inspector.getByRole("button", { name: "Plan it" }).click();
  await expect(page.getByRole("progressbar", { name: "Planning" })).toBeVisible();
  await studio.button("Cancel").click();
  await expect(studio.transitions.filter({ hasText: "Canceled" })).toHaveCount(2);
});

async function ribbonNames(studio: Studio): Promise<string[]> {
  const names = await studio.transitions.evaluateAll((ribbons) => ribbons.map((r) => r.getAttribute("aria-label")));
  return names.map((name) => name ?? "");
}

/** When the first ribbon says `word`, on the page's own clock. */
function watchRibbon(studio: Studio, word: string): Promise<number> {
  return studio.transitions.first().evaluate(
    (ribbon, wanted) =>
      new Promise<number>((resolve) => {
        const look = (): void => {
          const name = ribbon.getAttribute("aria-label") ?? "";
          if (name.includes(wanted) && name.includes("clearance")) resolve(performance.now());
          else setTimeout(look, 5);
        };
        look();
      }),
    word,
  );
}

/** The longest time between two frames of the page until it hears "enough", milliseconds. */
function longestFrameGap(studio: Studio): Promise<number> {
  return studio.page.evaluate(
    () =>
      new Promise<number>((resolve) => {
        let [last, longest, isOver] = [performance.now(), 0, false];
        addEventListener("enough", () => {
          isOver = true;
        });
        const tick = (now: number): void => {
          longest = Math.max(longest, now - last);
          last = now;
          if (isOver) resolve(longest);
          else requestAnimationFrame(tick);
        };
        requestAnimationFrame(tick);
      }),
  );
}
