import { access } from "node:fs/promises";
import { join } from "node:path";
import { root, run, step } from "./run.mjs";
import { hashOf, once } from "./stamp.mjs";

const PACKAGE = "web/src/engine/pkg";
const ENGINE_SOURCES = ["core-rs/"];
/** What of it is not in the browser's engine. */
const NOT_ENGINE = ["target", "bench", "cli", "fuzz", "engine/tests"].map((folder) => `core-rs/${folder}`);
const PAGE_SOURCES = ["package.json", "package-lock.json", "vite.config.ts", "tsconfig.json", "public/", "web/"];

const isThere = (path) =>
  access(join(root, path)).then(
    () => true,
    () => false,
  );

/** The engine's wasm package for the page. */
export async function buildEngine(toolchain) {
  const hash = await hashOf([...ENGINE_SOURCES, "scripts/steps/build.mjs"], [toolchain], NOT_ENGINE);
  const results = () => isThere(join(PACKAGE, "shapes_bg.wasm"));
  const isNew = await once("engine", hash, results, async () => {
    await step("Compiling the engine for the browser (minutes the first time)", () =>
      run("cargo", ["xtask", "wasm", join(root, PACKAGE)], { cwd: join(root, "core-rs") }),
    );
  });
  if (!isNew) console.log("▸ The engine is up to date");
}

/** The page, in web/dist. */
export async function buildPage() {
  const hash = await hashOf(PAGE_SOURCES, [], ["web/dist"]);
  const isNew = await once(
    "page",
    hash,
    () => isThere("web/dist/index.html"),
    () => step("Building the page", () => run("npx", ["vite", "build", "--logLevel", "warn"])),
  );
  if (!isNew) console.log("▸ The page is up to date");
}
