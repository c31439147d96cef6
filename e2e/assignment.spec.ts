import { expect, test } from "./fixtures/studio";

/** The left end of the first line and the right foot of the gable that `makeShow` draws. */
const LEFT = [0.25, 0.35] as const;
const FAR_FOOT = [0.65, 0.7] as const;

test("who goes where is tried, locked by a drag, accepted as one step and kept as a recipe", async ({ studio }) => {
  await studio.makeShow();
  const { inspector } = studio;
  await studio.transitions.first().click();
  const cost = inspector.getByRole("combobox", { name: "Assignment" });
  await expect(cost).toHaveValue("keep");
  await cost.selectOption("Least effort");
  const lambda = inspector.getByRole("spinbutton", { name: "Lambda" });
  await lambda.fill("0.5");
  await lambda.press("Enter");
  await expect(inspector.getByText(/^\d+\.\d m in all, the longest walk \d/)).toBeVisible();

  await studio.drag([LEFT, FAR_FOOT]);
  await expect(inspector.getByRole("list", { name: "Locks" }).getByRole("listitem")).toHaveText(/^1 → place of/);
  const before = (await studio.sceneFile()).keyframes[1]?.positions ?? [];
  await expect(inspector.getByRole("button", { name: "Accept" })).toBeEnabled();
  await inspector.getByRole("button", { name: "Accept" }).click();
  await expect(inspector.getByRole("button", { name: "Accept" })).toHaveCount(0);

  const file = await studio.sceneFile();
  const after = file.keyframes[1]?.positions ?? [];
  expect(after[0]?.[0]).toBe(Math.max(...before.map(([x]) => x)));
  expect([...after].sort()).toEqual([...before].sort());
  expect(file.segments?.[0]?.assignment).toEqual({ cost: "least-effort", lambda: 0.5, locks: [[0, 0]] });
  await studio.button("Undo").click();
  const undone = await studio.sceneFile();
  expect(undone.keyframes[1]?.positions).toEqual(before);
  expect(undone.segments?.[0]?.assignment).toBeUndefined();
});
