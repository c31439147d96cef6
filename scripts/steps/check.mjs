import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { root, run, Stop, step } from "./run.mjs";

const cwd = join(root, "core-rs");
const TYPES = "web/src/document/generated.ts";

async function checkTypes() {
  const fresh = join(root, ".cache/generated.ts");
  await run("cargo", ["xtask", "types", fresh], { cwd });
  const [now, then] = await Promise.all([readFile(fresh, "utf8"), readFile(join(root, TYPES), "utf8")]);
  if (now !== then)
    throw new Stop(`${TYPES} is not what the engine's types say: run "cargo xtask types ../${TYPES}" in core-rs.`);
}

/** Needs nothing of the browser's package, which compiles for minutes on one core: both go side by side. */
export async function lintRust() {
  await step("Rust format", () => run("cargo", ["fmt", "--all", "--check"], { cwd }));
  await step("Rust lint", () =>
    run("cargo", ["clippy", "--quiet", "--workspace", "--all-targets", "--", "-D", "warnings"], { cwd }),
  );
}

/** The engine's types as the page has them, and the engine's own tests. */
export async function testRust() {
  await step("Types across the seam", checkTypes);
  // The bench has no tests and the documentation no examples, but compiling for them takes its time.
  const targets = ["--exclude", "eigenform-bench", "--lib", "--bins", "--tests"];
  await step("Rust tests", () => run("cargo", ["test", "--quiet", "--workspace", ...targets], { cwd }));
}

/** The page's format and lint, types and unit tests; needs the engine's package. */
export async function checkPage() {
  await step("Page format and lint", () => run("npx", ["biome", "check", "--error-on-warnings", "."]));
  await step("Page types", () => run("npx", ["tsc"]));
  await step("Page tests", () => run("npx", ["vitest", "run"]));
}
