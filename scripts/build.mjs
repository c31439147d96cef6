// Builds the engine and the page in release mode, into web/dist.
import { buildEngine, buildPage } from "./steps/build.mjs";
import { main } from "./steps/run.mjs";
import { prepare } from "./steps/tools.mjs";

main(async () => {
  await buildEngine(await prepare());
  await buildPage();
});
