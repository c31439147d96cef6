import { spawn } from "node:child_process";
import { fileURLToPath } from "node:url";

/** The checkout. */
export const root = fileURLToPath(new URL("../..", import.meta.url));

/** A missing tool or a failed step: one sentence and, where there is one, the cure. No stack: it is no bug of ours. */
export class Stop extends Error {}

/** Runs a command in the checkout with its output shown; rejects when it fails. */
export function run(command, words, { cwd = root, env = {} } = {}) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, words, { cwd, env: { ...process.env, ...env }, stdio: "inherit" });
    child.on("error", (error) => reject(new Stop(`${command} did not start: ${error.message}`)));
    child.on("exit", (code, signal) => {
      if (code === 0) resolve();
      else reject(new Stop(`${[command, ...words].join(" ")} failed (${signal ?? `exit ${code}`}).`));
    });
  });
}

/** What a command prints, or null when it does not start or fails. */
export function ask(command, words) {
  return new Promise((resolve) => {
    const child = spawn(command, words, { cwd: root, stdio: ["ignore", "pipe", "ignore"] });
    let text = "";
    child.stdout.on("data", (chunk) => {
      text += chunk;
    });
    child.on("error", () => resolve(null));
    child.on("exit", (code) => resolve(code === 0 ? text.trim() : null));
  });
}

/** Says what is done and how long it took. */
export async function step(title, work) {
  const start = performance.now();
  console.log(`▸ ${title}`);
  const result = await work();
  console.log(`  ${title}: ${((performance.now() - start) / 1000).toFixed(1)} s`);
  return result;
}

/** Runs a script's main function; a Stop ends it with its sentence, anything else with its stack. */
export function main(work) {
  work().catch((error) => {
    console.error(error instanceof Stop ? `\n✗ ${error.message}` : error);
    process.exitCode = 1;
  });
}
