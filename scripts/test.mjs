// Everything: the checks, then the built page in a browser.
import { findBrowser } from "./steps/browser.mjs";
import { checkBudget } from "./steps/budget.mjs";
import { buildEngine, buildPage } from "./steps/build.mjs";
import { checkPage, lintRust, testRust } from "./steps/check.mjs";
import { main, run, step } from "./steps/run.mjs";
import { prepare, prepareChecks } from "./steps/tools.mjs";

main(async () => {
  const toolchain = await prepare();
  await prepareChecks();
  const browser = await findBrowser();
  await Promise.all([buildEngine(toolchain), lintRust()]);
  await Promise.all([testRust(), checkPage().then(buildPage)]);
  await step("Size of the first load", checkBudget);
  await step("End-to-end tests", () =>
    run("npx", ["playwright", "test", "--config", "e2e/playwright.config.ts"], { env: { EIGENFORM_BROWSER: browser } }),
  );
});
