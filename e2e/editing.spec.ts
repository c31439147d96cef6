import { expect, FIRST_STROKE, type Place, type Studio, test } from "./fixtures/studio";

/** Where agent `index` of twelve stands on the first stroke; halves are between two. */
function agent(index: number): Place {
  return [0.25 + (0.5 * index) / 11, 0.35];
}

test("a tie is pulled, weighed and cut", async ({ studio, page }) => {
  await studio.openEmpty();
  await studio.draw(FIRST_STROKE);
  await studio.tool("Tie").click();
  await studio.drag([agent(0), [0.35, 0.5], agent(4)]);
  const weight = studio.inspector.getByRole("spinbutton", { name: "Weight" });
  await weight.fill("10");
  await weight.press("Enter");
  expect((await studio.sceneFile()).adjacency?.ties).toEqual([[0, 4, 10]]);

  await studio.click(agent(8.5));
  await expect(studio.inspector.getByRole("button", { name: "Cut tie" })).toBeVisible();
  await page.keyboard.press("Delete");
  expect((await studio.sceneFile()).adjacency?.cuts).toEqual([[8, 9]]);
  await studio.button("Undo").click();
  expect((await studio.sceneFile()).adjacency?.cuts ?? []).toEqual([]);
});

/** Twelve agents, of whom a marquee takes the first four. */
async function pickFirstFour(studio: Studio): Promise<void> {
  await studio.openEmpty();
  await studio.draw(FIRST_STROKE);
  await studio.tool("Select").click();
  await studio.drag([
    [0.2, 0.25],
    [0.4, 0.45],
  ]);
}

test("a group is made of a marquee, named, tied and dissolved", async ({ studio, page }) => {
  await pickFirstFour(studio);
  const bar = page.getByRole("toolbar", { name: "Selection" });
  await bar.getByRole("button", { name: "Make group" }).dblclick();
  await expect(bar.getByRole("button", { name: "Make group" })).toBeDisabled();
  const name = studio.inspector.getByRole("textbox", { name: "Name" });
  await name.fill("Brass");
  await name.press("Enter");
  await studio.inspector.getByRole("checkbox", { name: "Ties inside" }).check();
  const [group] = (await studio.sceneFile()).groups ?? [];
  expect(group).toMatchObject({ name: "Brass", members: [0, 1, 2, 3], tieWeight: 10 });

  await studio.inspector.getByRole("button", { name: "Dissolve" }).click();
  expect((await studio.sceneFile()).groups ?? []).toEqual([]);
  await studio.button("Undo").click();
  expect((await studio.sceneFile()).groups).toHaveLength(1);
});

test("bodies have a size and a top speed, each in one step", async ({ studio, page }) => {
  await pickFirstFour(studio);
  const { inspector } = studio;
  const radius = inspector.getByRole("spinbutton", { name: "Radius" });
  await radius.fill("0.4");
  await radius.press("Enter");
  await inspector.getByRole("checkbox", { name: /^Limit speed/ }).check();
  const speed = inspector.getByRole("spinbutton", { name: "Top speed" });
  await speed.fill("1.5");
  await speed.press("Enter");
  const bodies = async () => (await studio.sceneFile()).agents?.map(({ radius, maxSpeed }) => [radius, maxSpeed]) ?? [];
  expect((await bodies()).slice(0, 5)).toEqual([...Array(4).fill([0.4, 1.5]), [undefined, undefined]]);

  await page.keyboard.press("Control+a");
  await expect(inspector.getByText("0.25 to 0.40")).toBeVisible();
  await expect(inspector.getByText("of some of them")).toBeVisible();
  for (let step = 0; step < 3; step += 1) await studio.button("Undo").click();
  expect((await bodies()).flat().every((value) => value === undefined)).toBe(true);
});

test("keyframes are retimed, held, duplicated and deleted", async ({ studio }) => {
  await studio.makeShow();
  const times = async (): Promise<number[]> => (await studio.sceneFile()).keyframes.map(({ time }) => time ?? 0);
  expect(await times()).toEqual([0, 4]);
  await studio.keyframes.nth(1).click();
  const at = studio.inspector.getByRole("spinbutton", { name: "Keyframe time" });
  await at.fill("0:06");
  await at.press("Enter");
  expect(await times()).toEqual([0, 6]);
  const hold = studio.inspector.getByRole("spinbutton", { name: "Hold" });
  await hold.fill("2");
  await hold.press("Enter");
  expect((await studio.sceneFile()).keyframes[1]?.hold).toBe(2);

  await studio.button("Duplicate keyframe").click();
  await expect(studio.keyframes).toHaveCount(3);
  const [, original, copy] = (await studio.sceneFile()).keyframes;
  expect(copy?.positions).toEqual(original?.positions);
  await studio.button("Delete keyframe").click();
  await expect(studio.keyframes).toHaveCount(2);
});

test("the playhead comes around when it loops, and stops at the end when it does not", async ({ studio, page }) => {
  await studio.makeShow();
  const time = page.getByRole("slider", { name: "Time" });
  await time.press("End");
  await studio.button("Play").click();
  await expect.poll(() => studio.time()).toBeLessThan(4);
  await expect(studio.button("Play")).toBeVisible();
  expect(await studio.time()).toBe(4);

  await studio.button("Loop").click();
  await expect(studio.button("Loop")).toHaveAttribute("aria-pressed", "true");
  await time.press("End");
  await time.press("ArrowLeft");
  await studio.button("Play").click();
  await expect.poll(() => studio.time()).toBeLessThan(2);
  await expect(studio.button("Pause")).toBeVisible();
});

test("before a stroke it is said whom it places where, and a number out of bounds is corrected with its bounds", async ({
  studio,
  page,
}) => {
  await studio.makeShow();
  const options = page.getByRole("group", { name: "Drawing" });
  await expect(options).toContainText("Every keyframe has the same 12 agents");
  await studio.keyframes.first().click();
  await expect(options).toContainText("12 new agents come into every keyframe");
  await studio.transitions.first().click();
  await page.getByRole("slider", { name: "Time" }).fill("1");
  await expect(options).toContainText("Goes to Keyframe 1. 12 new agents come into every keyframe");

  const count = options.getByRole("spinbutton", { name: "Agents" });
  await count.fill("5001");
  await count.press("Enter");
  await expect(count).toHaveValue("5000");
  await expect(options).toContainText("Between 1 and 5,000");
  const correction = await options.getByText("Between 1 and 5,000").boundingBox();
  const panel = await options.boundingBox();
  // It stands over none of the fields.
  expect(correction?.x ?? 0).toBeGreaterThanOrEqual((panel?.x ?? 0) + (panel?.width ?? 0));
  await count.fill("3");
  await expect(options).not.toContainText("Between");
  await expect(options).toContainText("3 new agents come into every keyframe");
});
