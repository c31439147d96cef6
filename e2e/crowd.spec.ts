import { expectOpenToAll } from "./fixtures/axe";
import { expect, type Studio, test } from "./fixtures/studio";

const svg = (inside: string) => `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 90 60">${inside}</svg>`;

const TWO = svg('<g fill="gold"><circle cx="20" cy="30" r="18"/><circle cx="70" cy="30" r="18"/></g>');
const BAR = svg('<rect x="5" y="20" width="80" height="20" fill="navy"/>');

const AGENT_COUNT = 48;

async function placePicture(studio: Studio, name: string, content: string): Promise<void> {
  await studio.drop(name, content);
  const agents = studio.dialog.getByRole("spinbutton", { name: "Agents" });
  if (await agents.isEnabled()) await agents.fill(String(AGENT_COUNT));
  // Pressed while they are still being arranged, too.
  await studio.dialog.getByRole("button", { name: `Place ${AGENT_COUNT} agents` }).click();
  await expect(studio.dialog).toHaveCount(0);
}

test("from two pictures to a crowd and the numbers to judge it by", async ({ studio, page, context }) => {
  const { inspector, dialog } = studio;
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await studio.openEmpty();
  await placePicture(studio, "two.svg", TWO);
  await studio.button("Add keyframe").click();
  await expect(studio.keyframes).toHaveCount(2);
  await placePicture(studio, "bar.svg", BAR);

  await studio.transitions.first().click();
  await inspector.getByRole("combobox", { name: "Assignment" }).selectOption("Least effort");
  await expect(inspector.getByText(/^\d+\.\d m in all, the longest walk \d/)).toBeVisible();
  await inspector.getByRole("button", { name: "Accept" }).click();
  await expect(inspector.getByRole("button", { name: "Accept" })).toHaveCount(0);

  await page.keyboard.press("Escape");
  await inspector.getByRole("button", { name: "Propose groups" }).click();
  await inspector.getByRole("radio", { name: "Alike" }).check();
  await expect(inspector.getByText(/^\d+ groups/)).toBeVisible();
  await inspector.getByRole("button", { name: "Accept" }).click();

  await studio.transitions.first().click();
  await inspector.getByRole("combobox", { name: "Method" }).selectOption("Crowd");
  await studio.planned();
  await studio.button("Play").click();
  await expect.poll(() => studio.time()).toBeGreaterThan(0.5);
  const scene = await studio.sceneFile();
  expect(scene.segments?.[0]).toMatchObject({ method: "crowd", assignment: { cost: "least-effort" } });
  expect(scene.groups?.length).toBeGreaterThan(1);

  await inspector.getByRole("button", { name: "Compare side by side" }).click();
  await dialog.getByRole("radio", { name: "Table and plots" }).check();
  await dialog.getByRole("combobox", { name: "What to compare" }).selectOption("A crowd and what others do (table 3)");
  const rows = dialog.getByRole("table", { name: "Averages over time of all ways" }).getByRole("row");
  await expect(rows).toHaveCount(1 + 3);
  await expect(dialog.getByRole("button", { name: "Stop" })).toHaveCount(0);
  for (const way of ["Crowd", "Social force alone", "ORCA alone"]) {
    await expect(rows.filter({ hasText: way }).getByRole("cell").nth(2)).toHaveText(/^\d\.\d{3}/);
  }
  for (const plot of ["Direction told by place, I_d", "Structure σ", "Effort σ", "To the target"]) {
    await expect(dialog.getByRole("figure", { name: plot })).toBeVisible();
  }

  await expectOpenToAll(studio, "comparison");

  await dialog.getByRole("button", { name: "Copy the table" }).click();
  const copied = (await page.evaluate(() => navigator.clipboard.readText())).trim().split("\n");
  expect(copied.map((line) => line.split("\t").slice(0, 2))).toEqual([
    ["Who goes where", "Method"],
    ["Least effort", "Crowd"],
    ["Least effort", "Social force alone"],
    ["Least effort", "ORCA alone"],
  ]);

  await dialog.getByRole("checkbox", { name: "Manhattan" }).check();
  await expect(rows).toHaveCount(1 + 6);
  await page.keyboard.press("Escape");
  await expect(dialog).toHaveCount(0);
  expect(await studio.sceneFile()).toEqual(scene);
});
