// Builds what changed and serves the page on this machine.
import { buildEngine, buildPage } from "./steps/build.mjs";
import { main, root, Stop } from "./steps/run.mjs";
import { prepare } from "./steps/tools.mjs";

const PORT = 4173;

main(async () => {
  const start = performance.now();
  await buildEngine(await prepare());
  await buildPage();
  const { preview } = await import("vite");
  const server = await preview({
    root: `${root}/web`,
    configFile: `${root}/vite.config.ts`,
    preview: { host: "127.0.0.1", port: PORT },
  });
  const url = server.resolvedUrls?.local[0];
  if (!url) throw new Stop("The page could not be served on this machine.");
  console.log(
    `\n  Eigenform is at ${url} (ready in ${((performance.now() - start) / 1000).toFixed(1)} s; Ctrl+C ends it)\n`,
  );
});
