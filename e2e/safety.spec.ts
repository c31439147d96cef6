import { mutated, seeded } from "./fixtures/mutate";
import { crowdTable } from "./fixtures/scene-file";
import { expect, type Studio, test } from "./fixtures/studio";

/** Milliseconds within which the page must have said what became of a file: a second of an idle machine, and patience. */
const LONGEST = 10_000;

test("five hundred mutated links and files each end in a message or a scene", async ({ studio }, info) => {
  test.slow();
  await studio.openFirst();
  await studio.planned();
  const scene = JSON.stringify(await studio.sceneFile());
  const link = await studio.link();
  await studio.button("New").click();

  const random = seeded(2024);
  const sources: readonly (readonly [ending: string, text: string])[] = [
    ["txt", link],
    ["json", scene],
    ["csv", crowdTable(9, 3)],
  ];
  const files = Array.from({ length: 500 }, (_, index): [string, string] => {
    const [ending, text] = sources[index % sources.length] ?? ["txt", link];
    return [`m${index}.${ending}`, mutated(text, random)];
  });
  const ends = await openAll(studio, files);
  expect(ends.filter(({ words }) => !/ (was not opened|is open)\./.test(words))).toEqual([]);
  expect(ends.filter(({ words }) => /engine stopped|unexpected|panicked|unreachable/i.test(words))).toEqual([]);
  const slowest = Math.max(...ends.map(({ milliseconds }) => milliseconds));
  const refused = ends.filter(({ words }) => words.includes("was not opened")).length;
  info.annotations.push({ type: "mutations", description: `${refused} refused, the slowest took ${slowest} ms` });
  // Neither all nor none: else the mutations would try nothing.
  expect(refused).toBeGreaterThan(100);
  expect(refused).toBeLessThan(500);

  await studio.button("New").click();
  await studio.draw([
    [0.3, 0.3],
    [0.7, 0.3],
  ]);
  await expect(studio.tab("Agents")).toContainText("12");
});

test("a link cut anywhere is recognized as cut", async ({ studio }) => {
  await studio.openFirst();
  const link = await studio.link();
  await studio.button("New").click();
  const start = link.indexOf("#s=1.") + "#s=1.".length;
  const lengths = Array.from({ length: 60 }, (_, index) => start + Math.floor(((link.length - start) * index) / 60));
  const ends = await openAll(
    studio,
    [...lengths, link.length - 1].map((length) => [`cut at ${length}.txt`, link.slice(0, length)]),
  );
  expect(ends.filter(({ words }) => !words.includes("end of the link is missing"))).toEqual([]);
});

test("names with markup are shown as text", async ({ studio, page }) => {
  const markup = (what: string): string => `<img src=x onerror="document.title='${what}'">`;
  await studio.openFirst();
  const hostile = {
    format: "eigenform",
    version: 1,
    title: markup("title"),
    agents: [{ name: markup("agent") }, { name: "<b>bold</b>" }],
    groups: [{ name: markup("group"), members: [0] }],
    keyframes: [
      { name: markup("keyframe"), positions: [[0, 0], [4, 0]] }, // biome-ignore format: a formation on a line
      { time: 4, positions: [[0, 2], [4, 2]] }, // biome-ignore format: a formation on a line
    ],
  };
  await studio.drop(`${markup("file")}.json`, JSON.stringify(hostile));
  await expect(studio.message(markup("file"))).toBeVisible();
  await expect(studio.title).toHaveValue(markup("title"));
  await expect(studio.keyframes.first()).toHaveAccessibleName(markup("keyframe"));
  await studio.tab("Agents").click();
  await expect(studio.inspector.getByRole("gridcell", { name: markup("agent"), exact: true })).toBeVisible();
  await expect(studio.inspector.getByRole("gridcell", { name: markup("group"), exact: true })).toBeVisible();
  await studio.keyframes.first().click();
  await studio.tab("Inspector").click();
  await expect(studio.inspector.getByText(markup("keyframe"))).toBeVisible();
  await studio.button("Share").click();
  await expect(studio.dialog.getByRole("heading")).toContainText(markup("title"));
  await expect(page.locator("img")).toHaveCount(0);
  await expect(page).toHaveTitle(/Eigenform/);
});

test("the page allows itself nothing but its own files", async ({ studio, page, request }) => {
  const html = await (await request.get("/")).text();
  const policy = /http-equiv="Content-Security-Policy"\s+content="([^"]+)"/.exec(html)?.[1] ?? "";
  const directives = new Map(
    policy.split(";").map((directive) => {
      const [name = "", ...sources] = directive.trim().split(/\s+/);
      return [name, sources] as const;
    }),
  );
  expect(directives.get("default-src")).toEqual(["'none'"]);
  expect(directives.get("script-src")).toEqual(["'self'", "'wasm-unsafe-eval'"]);
  expect(directives.get("style-src")).toEqual(["'self'"]);
  expect(directives.get("connect-src")).toEqual(["'self'"]);
  expect(directives.get("object-src")).toEqual(["'none'"]);
  expect(directives.get("base-uri")).toEqual(["'none'"]);
  expect(policy).not.toMatch(/unsafe-inline|'unsafe-eval'|https?:|\*/);
  // The policy speaks before anything that it is about.
  expect(html.indexOf("Content-Security-Policy")).toBeLessThan(html.search(/<script|<link/));
  expect(html).not.toMatch(/<script(?![^>]*\ssrc=)|\sstyle=|\son[a-z]+=/i);

  await studio.openFirst();
  await page.keyboard.press("Control+k");
  await expect(studio.dialog).toBeVisible();
});

interface End {
  readonly name: string;
  /** What the page said of it; empty when it said nothing in time. */
  readonly words: string;
  readonly milliseconds: number;
}

/** Drops the files one after another, each as soon as the page has said what became of the last. */
async function openAll(studio: Studio, files: readonly (readonly [name: string, text: string])[]): Promise<End[]> {
  return studio.stage.evaluate(
    async (stage, [toOpen, limit]) => {
      const ends: End[] = [];
      const said = () => [...document.querySelectorAll("[role=status] > *")].map(({ textContent }) => textContent);
      for (const [name, text] of toOpen) {
        const transfer = new DataTransfer();
        transfer.items.add(new File([text], name));
        const start = performance.now();
        stage.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
        let words = "";
        while (words === "" && performance.now() - start < limit) {
          await new Promise((resolve) => setTimeout(resolve, 1));
          words = said().find((text) => text.startsWith(`${name} `)) ?? "";
        }
        ends.push({ name, words, milliseconds: Math.round(performance.now() - start) });
      }
      return ends;
    },
    [files, LONGEST] as const,
  );
}

/** A part of the page that cannot be drawn the first time. */
const FAILS_ONCE = `
  let count = 0;
  export const HelpDialog = () => {
    count += 1;
    if (count === 1) throw new Error("a dialog that fails once");
    return null;
  };
`;

test("a dialog that cannot be drawn says so, and can be tried again", async ({ studio, page, troubles }) => {
  await page.route(/\/help-[^/]*\.js$/, (route) => route.fulfill({ contentType: "text/javascript", body: FAILS_ONCE }));
  await studio.openFirst();
  await studio.button("Help").click();
  await expect(page.getByRole("dialog", { name: "Something went wrong here." })).toContainText("Your scene is safe.");
  await studio.dialog.getByRole("button", { name: "Try again" }).click();
  await expect(studio.dialog).toHaveCount(0);
  expect(troubles.splice(0).join()).toContain("a dialog that fails once");
});

test("what does not load is said once, and comes at the next wish", async ({ studio, page, troubles }) => {
  await studio.openFirst();
  await studio.planned();
  await page.waitForLoadState("networkidle");
  let asked = 0;
  await page.route("**/assets/*.js", (route) => {
    asked += 1;
    return route.abort();
  });
  await studio.button("Share").click();
  await expect(studio.message("A part of the page did not load.")).toBeVisible();
  const first = asked;
  await studio.button("Share").click();
  await expect.poll(() => asked).toBeGreaterThan(first);
  await expect(studio.dialog).toHaveCount(0);
  await page.unroute("**/assets/*.js");
  const before = asked;
  expect(await studio.link()).toMatch(/#s=1\./);
  expect(asked).toBe(before);
  expect(before).toBeLessThan(10);
  troubles.length = 0;
});
