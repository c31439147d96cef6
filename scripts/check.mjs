// Format, lint, types and unit tests.
import { buildEngine } from "./steps/build.mjs";
import { check } from "./steps/check.mjs";
import { main } from "./steps/run.mjs";
import { prepare, prepareChecks } from "./steps/tools.mjs";

main(async () => {
  await buildEngine(await prepare());
  await prepareChecks();
  await check();
});
