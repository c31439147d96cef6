import type { Page } from "@playwright/test";
import { expect, type Studio, test, textOf } from "./fixtures/studio";

interface Motion {
  readonly times: readonly number[];
  readonly positions: readonly (readonly (readonly [x: number, y: number])[])[];
}

/** The motion as other tools get it. */
async function motionOf(studio: Studio, page: Page): Promise<Motion> {
  await studio.planned();
  await studio.button("Export").click();
  const text = await textOf(await studio.downloadOf(() => studio.button("Download Motion, JSON").click()));
  await page.keyboard.press("Escape");
  await expect(studio.dialog).toHaveCount(0);
  return JSON.parse(text) as Motion;
}

/** Meters a second of the first agent across one frame at `time`. */
function speedAt({ times, positions }: Motion, time: number): number {
  const frame = times.findIndex((at) => at >= time - 1e-9);
  const [before, after] = [positions[frame - 1]?.[0], positions[frame + 1]?.[0]];
  if (!before || !after) throw new Error(`there are no frames around ${time} s`);
  return Math.hypot(after[0] - before[0], after[1] - before[1]) / ((times[frame + 1] ?? 0) - (times[frame - 1] ?? 0));
}

/** Round-off of a formation of some tens of meters. */
const UNSEEN = 1e-9;

/** How far anybody is from where they were, meters a frame. */
function differences(before: Motion, after: Motion): number[] {
  return before.positions.map((places, frame) =>
    Math.max(
      ...places.map(([x, y], agent) => {
        const [px, py] = after.positions[frame]?.[agent] ?? [Number.NaN, Number.NaN];
        return Math.hypot(px - x, py - y);
      }),
    ),
  );
}

/** Brings the playhead to a whole second. */
async function goTo(page: Page, seconds: number): Promise<void> {
  await page.getByRole("slider", { name: "Time" }).focus();
  await page.keyboard.press("Home");
  for (let step = 0; step < seconds; step += 1) await page.keyboard.press("PageUp");
}

/** Twelve agents in rows that turn and widen on their way across; the joints are no stops. */
function turningShow(segment: object, frameRate = 30): string {
  const formation = (angle: number, stretch: number, dx: number) =>
    Array.from({ length: 12 }, (_, agent) => {
      const [u, v] = [((agent % 4) - 1.5) * 2 * stretch, (Math.floor(agent / 4) - 1) * 2];
      return [u * Math.cos(angle) - v * Math.sin(angle) + dx, u * Math.sin(angle) + v * Math.cos(angle)];
    });
  return JSON.stringify({
    format: "eigenform",
    version: 1,
    title: "Turning",
    join: "smooth",
    frameRate,
    keyframes: [
      { time: 0, positions: formation(0, 1, -8) },
      { time: 4, positions: formation(0.7, 1.3, -1) },
      { time: 9, positions: formation(1.6, 0.9, 5) },
      { time: 13, positions: formation(2, 1, 12) },
    ],
    segments: [segment, segment, segment],
  });
}

test("a new show runs through its keyframes, and stops where one is a corner", async ({ studio, page }) => {
  await studio.makeShow();
  await studio.button("Add keyframe").click();
  await expect(studio.keyframes).toHaveCount(3);
  await studio.draw([
    [0.2, 0.2],
    [0.6, 0.3],
  ]);
  const joint = (await studio.sceneFile()).keyframes[1]?.time ?? 0;
  const speed = async () => speedAt(await motionOf(studio, page), joint);
  expect(await speed()).toBeGreaterThan(0.2);

  await test.step("a corner is a stop", async () => {
    await studio.keyframes.nth(1).click();
    await studio.inspector.getByRole("checkbox", { name: "Corner" }).check();
    await expect(studio.keyframes.nth(1)).toHaveAccessibleDescription(/corner/);
    expect(await speed()).toBeLessThan(0.05);
    await studio.button("Undo").click();
    await expect(studio.inspector.getByRole("checkbox", { name: "Corner" })).not.toBeChecked();
  });

  await test.step("so is every keyframe of a show whose transitions are separate", async () => {
    await page.keyboard.press("Escape");
    await studio.inspector.getByRole("combobox", { name: "Join" }).selectOption("Separate");
    expect(await speed()).toBeLessThan(0.05);
    await expect(studio.inspector.getByRole("slider", { name: "Tension" })).toHaveCount(0);
    await studio.button("Undo").click();
    await expect(studio.inspector.getByRole("slider", { name: "Tension" })).toBeVisible();
  });

  await test.step("without tension the pace at keyframes is lost", async () => {
    const tension = studio.inspector.getByRole("spinbutton", { name: "Tension" });
    await tension.fill("0");
    await tension.press("Enter");
    expect(await speed()).toBeLessThan(0.05);
  });
});

for (const [name, segment] of [
  ["linear", { method: "linear" }],
  ["spectral", { method: "spectral" }],
  ["what auto took", {}],
  ["a crowd kept apart", { method: "crowd", avoidance: true }],
] as const) {
  test(`a keyframe at the playhead leaves the motion where it was: ${name}`, async ({ studio, page }) => {
    await studio.openFirst();
    await studio.drop("turning.eigenform.json", turningShow(segment));
    await expect(studio.title).toHaveValue("Turning");
    const before = await motionOf(studio, page);
    await goTo(page, 6);
    await studio.button("Add keyframe").click();
    await expect(studio.keyframes).toHaveCount(5);
    const after = await motionOf(studio, page);
    expect(after.times).toEqual(before.times);
    expect(Math.max(...differences(before, after))).toBeLessThan(UNSEEN);
  });
}

test("between two frames a keyframe takes the formation of that instant", async ({ studio, page }) => {
  await studio.openFirst();
  await studio.drop("turning.eigenform.json", turningShow({ method: "spectral", avoidance: true }, 5));
  await expect(studio.title).toHaveValue("Turning");
  const before = await motionOf(studio, page);
  // Straight from frame to frame it would be centimeters beside.
  await page.getByRole("slider", { name: "Time" }).fill("5.678");
  await studio.button("Add keyframe").click();
  await expect(studio.keyframes).toHaveCount(5);
  expect((await studio.sceneFile()).keyframes[2]?.time).toBe(5.678);
  const { times, positions } = await motionOf(studio, page);
  const isFrame = times.map((time) => before.times.includes(time));
  const frames = { times: before.times, positions: positions.filter((_, index) => isFrame[index]) };
  expect(frames.positions).toHaveLength(before.times.length);
  expect(Math.max(...differences(before, frames))).toBeLessThan(UNSEEN);
});

test("an in-between bends the transition it lies in, and ends it when it is told to", async ({
  studio,
  visitor,
  page,
}) => {
  await studio.openFirst();
  await studio.drop("turning.eigenform.json", turningShow({ method: "spectral" }));
  await expect(studio.title).toHaveValue("Turning");
  const before = await motionOf(studio, page);
  await goTo(page, 6);
  await studio.button("Add keyframe").click();
  await expect(studio.keyframes.nth(2)).toHaveAccessibleDescription(/in-between/);

  await test.step("who is moved there comes from where they were and goes back there", async () => {
    await page.keyboard.press("ControlOrMeta+a");
    for (let step = 0; step < 4; step += 1) await page.keyboard.press("ArrowRight");
    const bent = differences(before, await motionOf(studio, page));
    const within = before.times.map((time) => time > 4 && time < 9);
    expect(Math.max(...bent.filter((_, frame) => !within[frame]))).toBeLessThan(UNSEEN);
    expect(Math.max(...bent)).toBeGreaterThan(0.1);
    expect(bent.indexOf(Math.max(...bent))).toBe(before.times.findIndex((time) => time >= 6 - 1e-9));
  });

  await test.step("a part is told what the whole transition is", async () => {
    await studio.transitions.nth(2).click();
    await expect(studio.inspector).toContainText("A part of Keyframe 2 → Keyframe 4");
    await studio.inspector.getByRole("combobox", { name: "Method" }).selectOption("Linear");
    const segments = (await studio.sceneFile()).segments?.map((segment) => segment.method);
    expect(segments).toEqual(["spectral", "linear", "linear", "spectral"]);
    await studio.button("Undo").click();
  });

  await test.step("it goes with the link", async () => {
    await visitor.open(await studio.link());
    await expect(visitor.keyframes.nth(2)).toHaveAccessibleDescription(/in-between/);
  });

  await test.step("told to, it ends the transition: another begins", async () => {
    await studio.keyframes.nth(2).click();
    await studio.inspector.getByRole("checkbox", { name: "In-between" }).uncheck();
    await expect(studio.keyframes.nth(2)).not.toHaveAccessibleDescription(/in-between/);
    expect((await studio.sceneFile()).keyframes[2]?.between).toBeUndefined();
    const parted = differences(before, await motionOf(studio, page));
    expect(Math.max(...parted.filter((_, frame) => (before.times[frame] ?? 0) > 9))).toBeGreaterThan(UNSEEN);
  });
});
