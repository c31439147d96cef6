import { expect, type Studio, test } from "./fixtures/studio";

type Place = readonly [x: number, y: number];

/** Two agents for two seconds, of whom the first goes from one place to another; an obstacle is a circle or a box. */
function show(title: string, from: Place, to: Place, method: string, more: object = {}): string {
  return JSON.stringify({
    format: "eigenform",
    version: 1,
    title,
    minimumDistance: 0.5,
    keyframes: [{ positions: [from, [9.5, -9.5]] }, { time: 2, positions: [to, [9.5, -6.5]] }],
    segments: [{ method, avoidance: method === "linear" }],
    ...more,
  });
}

function box(left: number, bottom: number, right: number, top: number) {
  const points = [
    [left, bottom],
    [right, bottom],
    [right, top],
    [left, top],
  ];
  return { kind: "polygon", points };
}

/** Opens a show at its transition. */
async function look(studio: Studio, title: string, text: string): Promise<void> {
  await studio.drop(`${title}.json`, text);
  await expect(studio.title).toHaveValue(title);
  await studio.planned();
  await studio.transitions.first().click();
}

test("what a transition cannot do is said in a sentence, and on the timeline in a word", async ({ studio }) => {
  const { inspector } = studio;
  const ribbon = studio.transitions.first();
  await studio.openFirst();

  await test.step("who has to be faster than they can, and how long would do", async () => {
    await look(studio, "Hurried", show("Hurried", [0, 0], [0, 10], "crowd", { agents: [{ maxSpeed: 1 }, {}] }));
    await expect(inspector).toContainText(
      /Agent 1 moves at up to \d\.\d\d m\/s to arrive in time; its top speed is 1\.00 m\/s\./,
    );
    await inspector.getByRole("button", { name: /^Take 1\d(\.\d)? s$/ }).click();
    await studio.planned();
    await expect(inspector).not.toContainText("top speed is");
  });

  await test.step("whom an obstacle shuts off", async () => {
    const room = [box(-4, -4, 4, -3), box(-4, 3, 4, 4), box(-4, -4, -3, 4), box(3, -4, 4, 4)];
    await look(studio, "Shut", show("Shut", [0, 0], [0, 8], "linear", { obstacles: room }));
    await expect(inspector).toContainText(
      "No way leads agent 1 to its place, so it goes through: Obstacle 2 shuts it off.",
    );
    await expect(inspector).toContainText("Move the obstacle, or leave a gap of 1.00 m.");
    await expect(ribbon).toHaveAccessibleName(/clash, shut off at 0:0\d/);
    await expect(ribbon).toContainText("shut off");
  });

  await test.step("who stands in one", async () => {
    const pillar = [{ kind: "circle", center: [0, 0], radius: 1 }];
    await look(studio, "Inside", show("Inside", [0.75, 0], [6, 0], "linear", { obstacles: pillar }));
    await expect(inspector).toContainText(
      "Agent 1 stands 0.25 m inside Obstacle 1 in Keyframe 1. A keyframe is never changed: move them or the obstacle.",
    );
    await expect(ribbon).toContainText("inside");
  });

  await test.step("a number that does not fit is corrected, and that is said where it was typed", async () => {
    await studio.keyframes.first().click();
    const hold = inspector.getByRole("spinbutton", { name: "Hold" });
    await hold.fill("90");
    await hold.press("Enter");
    await expect(hold).toHaveValue("1.9");
    await expect(inspector.getByText("As near as it can be: 1.9 s")).toBeVisible();
    await hold.fill("0");
    await hold.press("Enter");
    await hold.press("ArrowDown");
    await expect(inspector.getByText("Between 0 and 3,600 s")).toBeVisible();
  });
});
