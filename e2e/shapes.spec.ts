import { expectOpenToAll } from "./fixtures/axe";
import { expect, type Studio, test } from "./fixtures/studio";

const svg = (inside: string) => `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 90 60">${inside}</svg>`;

/** Two discs beside each other: nobody stands in the 12 m between them. */
const TWO = svg('<g fill="gold"><circle cx="20" cy="30" r="18"/><circle cx="70" cy="30" r="18"/></g>');

/** The bytes of a PNG without its second half. */
function cutPicture({ page }: Studio): Promise<readonly number[]> {
  return page.evaluate(async () => {
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("2d");
    for (let x = 0; x < canvas.width; x += 2) context?.fillRect(x, (x * x) % canvas.height, 1, 40);
    const whole = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, "image/png"));
    return [...new Uint8Array((await whole?.arrayBuffer()) ?? [])].slice(0, (whole?.size ?? 0) / 2);
  });
}

async function place(studio: Studio): Promise<void> {
  await studio.dialog.getByRole("button", { name: /^Place \d+ agents$/ }).click();
  await expect(studio.dialog).toHaveCount(0);
}

test("text and a dropped picture become formations of exactly the agents there are", async ({ studio }) => {
  await studio.openEmpty();
  await studio.tool("Shape").click();
  await studio.button("Text…").click();
  await studio.dialog.getByRole("textbox", { name: "Text", exact: true }).fill("GO");
  await studio.dialog.getByRole("spinbutton", { name: "Agents" }).fill("70");
  await expect(studio.dialog.getByRole("img", { name: "70 places" })).toBeVisible();
  await expectOpenToAll(studio, "shape");
  await place(studio);
  await expect(studio.tab("Agents")).toContainText("70");

  await studio.button("Add keyframe").click();
  await expect(studio.keyframes).toHaveCount(2);
  const says = studio.dialog.getByRole("status");
  await studio.drop("script.svg", svg("<script>document.title = 'run'</script>"));
  await expect(says).toHaveText("script.svg has a script in it. Only shapes are drawn.");
  await studio.drop("blank.svg", svg('<path d="M 0 0 H 9" stroke="none" fill="none"/>'));
  await expect(says).toHaveText(
    "There is no shape in this picture: all of it is transparent; take one in which something can be seen.",
  );
  await studio.drop("broken.png", "no picture at all");
  await expect(says).toHaveText("broken.png is text, not a picture; a shape is read from PNG, JPEG, WebP and SVG.");
  await studio.drop("white.svg", svg('<path d="M -9 -9 H 99 V 99 H -9 Z" fill="white"/>'));
  await expect(says).toHaveText("There is no shape in this picture: all of it has one color.");
  await studio.drop("cut.png", await cutPicture(studio));
  await expect(says).toHaveText("cut.png cannot be decoded; it may be cut short.");
  await studio.dialog.getByRole("radio", { name: "Path" }).check();
  await studio.dialog.getByRole("textbox", { name: "Path" }).fill("garbage");
  await expect(says).toHaveText("This is no path; one is M 0 0 L 4 0 L 2 3 Z.");
  await studio.dialog.getByRole("textbox", { name: "Path" }).fill("M 0 0 L 10 10");
  await expect(says).toHaveText("This path has no inside; one that has is M 0 0 L 4 0 L 2 3 Z.");
  await studio.drop("two.svg", TWO);
  await expect(studio.dialog.getByRole("img", { name: "70 places" })).toBeVisible();
  await expect(studio.dialog.getByRole("spinbutton", { name: "Agents" })).toBeDisabled();
  await studio.dialog.getByRole("spinbutton", { name: "Longer side" }).fill("1");
  await studio.page.keyboard.press("Enter");
  await expect(says).toHaveText(
    /^70 agents do not fit \d\.\d\d m apart, with a little to spare; \d+ do\. Ask for fewer, a larger shape/,
  );
  await studio.dialog.getByRole("spinbutton", { name: "Longer side" }).fill("60");
  await studio.page.keyboard.press("Enter");
  await expect(studio.dialog.getByRole("img", { name: "70 places" })).toBeVisible();
  await place(studio);

  const { keyframes, minimumDistance = 0 } = await studio.sceneFile();
  const places = keyframes[1]?.positions ?? [];
  const xs = places.map(([x]) => x).sort((a, b) => a - b);
  const gap = Math.max(...xs.slice(1).map((x, i) => x - (xs[i] ?? x)));
  // Of 86 units of the drawing 14 lie between the discs.
  expect(gap).toBeGreaterThan((60 * 13) / 86);
  expect(places).toHaveLength(70);
  for (const [i, [x, y]] of places.entries()) {
    for (const [u, v] of places.slice(i + 1)) expect(Math.hypot(u - x, v - y)).toBeGreaterThanOrEqual(minimumDistance);
  }
});
