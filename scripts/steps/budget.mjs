import { readdir, readFile } from "node:fs/promises";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { root, Stop } from "./run.mjs";

const DIST = join(root, "web/dist");
const JAVASCRIPT_LIMIT = 60_000;
const WASM_LIMIT = 400_000;

/**
 * What a first visit needs before its scene is drawn and planned: the entry, what it imports at once, and the worker.
 * What comes behind that by itself, so that the page can be touched, is held by a story (e2e/first-load.spec.ts).
 */
async function firstLoad() {
  const manifest = JSON.parse(await readFile(join(DIST, ".vite/manifest.json"), "utf8"));
  const page = await readFile(join(DIST, "index.html"), "utf8");
  const files = new Set();
  const visit = (name) => {
    const chunk = manifest[name];
    if (!chunk || files.has(chunk.file)) return;
    files.add(chunk.file);
    for (const imported of chunk.imports ?? []) visit(imported);
  };
  for (const [name, chunk] of Object.entries(manifest))
    if (chunk.file.endsWith(".js") && page.includes(chunk.file)) visit(name);
  const assets = await readdir(join(DIST, "assets"));
  for (const asset of assets) if (/^worker-.*\.js$/.test(asset)) files.add(`assets/${asset}`);
  return {
    scripts: [...files],
    wasm: assets.filter((asset) => /^engine_bg-.*\.wasm$/.test(asset)).map((asset) => `assets/${asset}`),
  };
}

async function gzipped(files) {
  const sizes = await Promise.all(
    files.map(async (file) => gzipSync(await readFile(join(DIST, file)), { level: 9 }).length),
  );
  return sizes.reduce((sum, size) => sum + size, 0);
}

/** Fails when the first load outgrows its promise. */
export async function checkBudget() {
  const { scripts, wasm } = await firstLoad();
  if (scripts.length < 2 || wasm.length !== 1)
    throw new Stop("The build has no entry, no worker or not one engine: the sizes cannot be judged.");
  const sizes = [
    ["JavaScript", await gzipped(scripts), JAVASCRIPT_LIMIT],
    ["wasm", await gzipped(wasm), WASM_LIMIT],
  ];
  for (const [what, size, limit] of sizes) {
    console.log(`  ${what}: ${(size / 1000).toFixed(1)} of ${limit / 1000} kB gzipped`);
    if (size > limit) throw new Stop(`The first load's ${what} is over its limit.`);
  }
}
