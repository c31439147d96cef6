import { expect, test } from "./fixtures/studio";

/** Scripts and screen readers rely on these names and roles; each is looked for where a person would meet it. */

test("the page has its regions, tools and buttons", async ({ studio, page }) => {
  await studio.openFirst();
  for (const name of ["Stage", "Timeline", "Inspector"]) {
    await expect(page.getByRole("region", { name, exact: true })).toBeVisible();
  }
  for (const name of ["Select", "Draw", "Shape", "Tie", "Group", "Obstacle", "Pan"]) {
    await expect(studio.tool(name)).toBeVisible();
  }
  const commands = ["New", "Undo", "Redo", "Examples", "Open", "Save", "Share", "Export", "Help"];
  const keyframes = ["Add keyframe", "Duplicate keyframe", "Delete keyframe"];
  for (const name of [...commands, ...keyframes]) await expect(studio.button(name)).toBeVisible();

  await expect(studio.title).toBeVisible();
  await expect(page.getByRole("listbox", { name: "Keyframes", exact: true })).toBeVisible();
  await expect(studio.button("Loop")).toHaveAttribute("aria-pressed", /true|false/);
  await expect(page.getByRole("slider", { name: "Time", exact: true })).toHaveCount(1);
  await expect(page.getByRole("status").first()).toBeAttached();
});

test("Play becomes Pause and back", async ({ studio }) => {
  await studio.makeShow();
  await studio.button("Play").click();
  await studio.button("Pause").click();
  await expect(studio.button("Play")).toBeVisible();
});

test("a transition has its method, order, alignment, sharing and measures", async ({ studio, page }) => {
  await studio.openFirst();
  await studio.planned();
  await studio.transitions.first().click();
  for (const name of ["Method", "Order", "Alignment", "Assignment"]) {
    await expect(studio.inspector.getByRole("combobox", { name, exact: true })).toBeVisible();
  }
  for (const name of ["Sharing", "Minimum distance"]) {
    await expect(studio.inspector.getByRole("slider", { name, exact: true })).toHaveCount(1);
    await expect(studio.inspector.getByRole("spinbutton", { name, exact: true })).toBeVisible();
  }
  await expect(page.getByRole("region", { name: "Measures", exact: true })).toBeVisible();
});

test("a group's ties have a weight", async ({ studio }) => {
  await studio.openFirst();
  await studio.inspector.getByRole("listitem").getByRole("button").first().click();
  await studio.inspector.getByRole("checkbox", { name: "Ties inside" }).check();
  await expect(studio.inspector.getByRole("slider", { name: "Weight", exact: true })).toHaveCount(1);
  await expect(studio.inspector.getByRole("spinbutton", { name: "Weight", exact: true })).toBeVisible();
});

test("draw and shape say how many agents they make, and fix it where the agents are given", async ({ studio }) => {
  await studio.openEmpty();
  const agents = studio.stage.getByRole("spinbutton", { name: "Agents", exact: true });
  for (const tool of ["Draw", "Shape"]) {
    await studio.tool(tool).click();
    await expect(agents).toBeEnabled();
  }
  await studio.drag([
    [0.4, 0.4],
    [0.6, 0.6],
  ]);
  await studio.button("Add keyframe").click();
  await expect(agents).toBeDisabled();
  await expect(agents).toHaveAccessibleDescription(/\S/);
});

test("the share dialog has the link to copy", async ({ studio, page }) => {
  await studio.openFirst();
  await studio.button("Share").click();
  const link = page.getByRole("textbox", { name: "Link", exact: true });
  await expect(link).toHaveValue(/#s=1\./);
  await expect(link).not.toBeEditable();
  await expect(studio.button("Copy link")).toBeVisible();
});

test("everybody is in the grid of agents, with live coordinates", async ({ studio, page }) => {
  await studio.makeShow();
  await studio.tab("Agents").click();
  const grid = page.getByRole("grid", { name: "Agents", exact: true });
  await expect(grid).toHaveAttribute("aria-rowcount", "13");
  const rows = grid.getByRole("row");
  await expect(rows).toHaveCount(13);
  await page.getByRole("slider", { name: "Time" }).press("Home");
  const first = rows.nth(1);
  const before = await first.textContent();
  await studio.button("Play").click();
  await expect(first).not.toHaveText(before ?? "");
});
