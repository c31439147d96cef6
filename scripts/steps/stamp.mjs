import { createHash } from "node:crypto";
import { mkdir, readdir, readFile, writeFile } from "node:fs/promises";
import { join, relative } from "node:path";
import { root } from "./run.mjs";

const CACHE = join(root, ".cache");

async function* filesUnder(path, skip) {
  const entries = await readdir(path, { withFileTypes: true });
  for (const entry of entries.sort((a, b) => (a.name < b.name ? -1 : 1))) {
    const child = join(path, entry.name);
    if (skip.has(relative(root, child))) continue;
    if (entry.isDirectory()) yield* filesUnder(child, skip);
    else yield child;
  }
}

/** A hash of file contents and words, never of file times. Paths are relative to the checkout; folders count whole. */
export async function hashOf(paths, words = [], skip = []) {
  const hash = createHash("sha256");
  const skipped = new Set(skip);
  for (const word of words) hash.update(`${word}\0`);
  for (const path of paths) {
    const full = join(root, path);
    const files = path.endsWith("/") ? filesUnder(full, skipped) : [full];
    for await (const file of files) {
      hash.update(`${relative(root, file)}\0`);
      hash.update(await readFile(file));
    }
  }
  return hash.digest("hex");
}

/** Does the work unless it was done for this very hash and its results are still there. */
export async function once(name, hash, areResultsThere, work) {
  const file = join(CACHE, `${name}.sha256`);
  const last = await readFile(file, "utf8").catch(() => "");
  if (last === hash && (await areResultsThere())) return false;
  await work();
  await mkdir(CACHE, { recursive: true });
  await writeFile(file, hash);
  return true;
}
