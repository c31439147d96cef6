// Format, lint, types and unit tests.
import { buildEngine } from "./steps/build.mjs";
import { checkPage, lintRust, testRust } from "./steps/check.mjs";
import { main } from "./steps/run.mjs";
import { prepare, prepareChecks } from "./steps/tools.mjs";

main(async () => {
  const toolchain = await prepare();
  await prepareChecks();
  await Promise.all([buildEngine(toolchain), lintRust()]);
  await Promise.all([testRust(), checkPage()]);
});
