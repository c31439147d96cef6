/** Hands on the built page. */

import { root } from "../steps/run.mjs";

/** Serves the built page to a browser while `measure` looks at it. */
export async function withPage(executablePath, flags, measure) {
  const [{ preview }, { chromium }] = await Promise.all([import("vite"), import("@playwright/test")]);
  const server = await preview({
    root: `${root}/web`,
    configFile: `${root}/vite.config.ts`,
    logLevel: "error",
    preview: { host: "127.0.0.1", port: 4190 },
  });
  const browser = await chromium.launch({ executablePath, args: flags });
  try {
    return await measure(async () => {
      const page = await browser.newPage({ viewport: { width: 1440, height: 900 }, reducedMotion: "reduce" });
      await page.goto(server.resolvedUrls.local[0]);
      return page;
    });
  } finally {
    await browser.close();
    await new Promise((resolve) => server.httpServer.close(resolve));
  }
}

/** As if a file were dropped on the page. */
export async function dropFile(page, name, type, text) {
  const data = await page.evaluateHandle(
    (file) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([file.text], file.name, { type: file.type }));
      return transfer;
    },
    { name, type, text },
  );
  await page.dispatchEvent("html", "drop", { dataTransfer: data });
}

/** Until every motion is there. */
export async function planned(page) {
  await page.waitForFunction(() => !/Planning/.test(document.body.textContent ?? ""), null, { timeout: 120_000 });
}

export const press = (page, name) => page.getByRole("button", { name, exact: true }).click();
