import { readdirSync, readFileSync } from "node:fs";
import { join, relative } from "node:path";
import { expect, test } from "vitest";

/** Which folder may import which: the arrows of ARCHITECTURE.md. Types of what is drawn and asked may be named upward. */
const MAY_IMPORT: Readonly<Record<string, readonly string[]>> = {
  document: [],
  playback: ["document"],
  engine: ["document", "playback"],
  shapes: ["document"],
  stage: ["document", "playback"],
  tools: ["document", "playback", "shapes", "stage"],
  theme: [],
  panels: ["document", "engine", "playback", "shapes", "stage", "theme", "tools"],
  files: ["document", "engine", "panels"],
};

/** What is a type only costs no dependency at run time. */
const MAY_NAME_TYPES: Readonly<Record<string, readonly string[]>> = {
  stage: ["engine", "tools"],
  tools: ["engine"],
};

const root = import.meta.dirname;

function sources(folder: string): string[] {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) return entry.name === "pkg" ? [] : sources(path);
    return /\.tsx?$/.test(entry.name) && !/\.test\.tsx?$/.test(entry.name) ? [path] : [];
  });
}

const IMPORT = /^(?:import|export)( type)? [^;]*?from "((?:\.\.?\/)[^"]+)"/gm;

test.each(Object.keys(MAY_IMPORT))("%s imports only what lies below it", (folder) => {
  const files = sources(join(root, folder));
  expect(files.length).toBeGreaterThan(0);
  const strangers: string[] = [];
  for (const file of files) {
    for (const [, typeOnly, target = ""] of readFileSync(file, "utf8").matchAll(IMPORT)) {
      const other = relative(root, join(file, "..", target)).split("/")[0] ?? "";
      if (other === folder || MAY_IMPORT[folder]?.includes(other)) continue;
      if (typeOnly && MAY_NAME_TYPES[folder]?.includes(other)) continue;
      strangers.push(`${relative(root, file)} imports ${target}`);
    }
  }
  expect(strangers).toEqual([]);
});

test("every folder of the page is listed", () => {
  const folders = readdirSync(root, { withFileTypes: true }).filter((entry) => entry.isDirectory());
  expect(folders.map((entry) => entry.name).sort()).toEqual(Object.keys(MAY_IMPORT).sort());
});
