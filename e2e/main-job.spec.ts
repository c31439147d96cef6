import { expect, test } from "./fixtures/studio";

test("a newcomer draws two formations, plays, and sends a link that opens elsewhere", async ({
  studio,
  page,
  browser,
  baseURL,
}) => {
  await studio.makeShow();
  await studio.button("Play").click();
  await expect.poll(() => studio.time()).toBeGreaterThan(0.5);
  await studio.button("Pause").click();

  await studio.button("Share").click();
  const link = page.getByRole("textbox", { name: "Link" });
  await expect(link).toHaveValue(/#s=1\./);
  const address = await link.inputValue();
  expect(address.startsWith(baseURL ?? "")).toBe(true);

  const elsewhere = await browser.newContext();
  const there = await elsewhere.newPage();
  await there.goto(address);
  await expect(there.getByRole("listbox", { name: "Keyframes" }).getByRole("option")).toHaveCount(2);
  await elsewhere.close();
});
