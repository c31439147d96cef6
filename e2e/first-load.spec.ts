import { gzipSync } from "node:zlib";
import { expect, test } from "./fixtures/studio";

/** Bytes: the 60 kB that draw the scene (scripts/steps/budget.mjs), and what comes behind them so that it can be touched. */
const UNASKED = 76_000;
/** Of what a person does, not of what they see. */
const ASKED_FOR = /workshop|shapes|edits|workbench|handiwork|dialogs|host-/;

/** Says how long planning takes, where it takes long: a slow or busy machine fetches it, and no other. */
const WHERE_IT_TAKES_LONG = /^planning-toast/;

test.use({ contextOptions: { reducedMotion: "no-preference" } });

test("a visit that only looks fetches no more than promised, and nothing that waits for a hand", async ({
  studio,
  page,
}) => {
  const scripts = new Map<string, Promise<number>>();
  const others: string[] = [];
  page.on("response", (response) => {
    const name = new URL(response.url()).pathname.split("/").at(-1) ?? "";
    if (WHERE_IT_TAKES_LONG.test(name)) return;
    if (name.endsWith(".js"))
      scripts.set(
        name,
        response.body().then((body) => gzipSync(body, { level: 9 }).length),
      );
    else others.push(name);
  });
  await studio.openFirst();
  await studio.planned();
  await expect.poll(() => studio.time()).toBeGreaterThan(0.2);
  await page.waitForLoadState("networkidle");
  const sizes = await Promise.all(scripts.values());
  const sum = sizes.reduce((total, size) => total + size, 0);
  expect(sizes.length).toBeGreaterThan(5);
  expect(sum, `${sum} bytes in ${[...scripts.keys()].join(", ")}`).toBeLessThan(UNASKED);
  expect([...scripts.keys(), ...others].filter((name) => ASKED_FOR.test(name))).toEqual([]);
});
