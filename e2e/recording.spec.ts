import { expectOpenToAll } from "./fixtures/axe";
import { expect, type Studio, test } from "./fixtures/studio";

const FRAMES = 61;
const RATE = 10;

/** Where an agent is in a frame: eight on a circle that turns and opens; the last one has gone after frame 40. */
function place(frame: number, agent: number): readonly [x: number, y: number] | null {
  if (agent === 7 && frame > 40) return null;
  const angle = (agent * Math.PI) / 4 + frame * 0.03;
  const radius = 4 + frame * 0.05;
  return [20 + radius * Math.cos(angle), 10 + radius * Math.sin(angle)];
}

function rows(write: (frame: number, agent: number, x: string, y: string) => string): string[] {
  const lines: string[] = [];
  for (let frame = 0; frame < FRAMES; frame += 1) {
    for (let agent = 0; agent < 8; agent += 1) {
      const at = place(frame, agent);
      if (at) lines.push(write(frame, agent, at[0].toFixed(3), at[1].toFixed(3)));
    }
  }
  return lines;
}

const MOTION_CSV = `frame,time,agent,x,y,z\n${rows((f, a, x, y) => `${f},${f / RATE},W${a + 1},${x},${y},0`).join("\n")}\n`;
const JUPEDSIM = `# framerate: 10.00 fps\n# id\tframe\tx/m\ty/m\tz/m\n${rows((f, a, x, y) => `${a + 1}\t${f}\t${x}\t${y}\t0`).join("\n")}\n`;

function panel(studio: Studio) {
  return studio.page.getByRole("region", { name: "Recording", exact: true });
}

async function pickAt(studio: Studio, pages: number): Promise<void> {
  const frame = panel(studio).getByRole("slider", { name: "Frame" });
  await frame.press("Home");
  for (let page = 0; page < pages; page += 1) await frame.press("PageUp");
  await panel(studio).getByRole("button", { name: "Pick this frame as keyframe" }).click();
}

for (const [format, name, text] of [
  ["a motion CSV", "walk.csv", MOTION_CSV],
  ["a text file of JuPedSim", "walk.txt", JUPEDSIM],
] as const) {
  test(`frames of ${format} become a scene that plays beside the recording`, async ({ studio }) => {
    await studio.openFirst();
    await studio.drop(name, text);
    await expect(panel(studio)).toContainText("8 agents, 61 frames, 6 s at 10 frames a second");
    await pickAt(studio, 0);
    await pickAt(studio, 3);
    await expect(panel(studio)).not.toContainText("left out");
    await pickAt(studio, 6);
    await expect(panel(studio)).toContainText("1 of 8 agents is absent in a picked frame and left out");
    await expectOpenToAll(studio, "recording");
    await panel(studio).getByRole("button", { name: "Make scene" }).click();

    await expect(studio.keyframes).toHaveCount(3);
    await expect(studio.title).toHaveValue("walk");
    const scene = await studio.sceneFile();
    expect(scene.keyframes.map(({ time = 0, positions }) => [time, positions.length])).toEqual([
      [0, 7],
      [3, 7],
      [6, 7],
    ]);
    await expect(panel(studio).getByRole("checkbox", { name: "Show original" })).toBeChecked();
    await studio.button("Play").click();
    await expect.poll(() => studio.time()).toBeGreaterThan(0.2);
    await studio.button("Undo").click();
    await expect(studio.title).toHaveValue("Autumn opener");
  });
}

test("a scene that is opened puts the recording away", async ({ studio }) => {
  await studio.openFirst();
  await studio.drop("walk.csv", MOTION_CSV);
  await expect(panel(studio)).toBeVisible();
  await studio.button("New").click();
  await expect(panel(studio)).toHaveCount(0);
  await expect(studio.inspector).toBeVisible();
  await studio.button("Undo").click();
  await expect(studio.title).toHaveValue("Autumn opener");
  await expect(panel(studio)).toHaveCount(0);
});

test("a recording that is cut short says where, and what is on the page stays", async ({ studio }) => {
  await studio.openFirst();
  const before = await studio.title.inputValue();
  await studio.drop("cut.csv", `${MOTION_CSV.slice(0, 400)}\n12,1.2,W1`);
  await expect(studio.message("cut.csv was not opened")).toBeVisible();
  await expect(panel(studio)).toHaveCount(0);
  await expect(studio.title).toHaveValue(before);
});

test("the gallery has a recording to try it with", async ({ studio }) => {
  await studio.openFirst();
  await studio.button("Examples").click();
  await studio.dialog.getByRole("button", { name: /^A march, recorded/ }).click();
  await expect(panel(studio)).toContainText("25 agents");
  for (const pages of [0, 4, 8, 11]) await pickAt(studio, pages);
  await panel(studio).getByRole("button", { name: "Make scene" }).click();
  await expect(studio.keyframes).toHaveCount(4);
  await studio.planned();
});
