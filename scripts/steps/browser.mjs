import { access } from "node:fs/promises";
import { ask, run, Stop, step } from "./run.mjs";

const NAMES = ["chromium", "chromium-browser", "google-chrome-stable", "google-chrome"];

async function installed() {
  for (const name of NAMES) {
    const path = await ask("which", [name]);
    if (path) return path;
  }
  return null;
}

/** Playwright's own browser, if it is downloaded. */
async function bundled() {
  const { chromium } = await import("@playwright/test");
  const path = chromium.executablePath();
  return access(path).then(
    () => path,
    () => null,
  );
}

async function attempt(command, words) {
  try {
    await run(command, words);
    return true;
  } catch (error) {
    if (error instanceof Stop) return false;
    throw error;
  }
}

/** The path of a Chromium for the end-to-end tests: an installed one, else Playwright's, else Debian's. */
export async function findBrowser() {
  const found = (await installed()) ?? (await bundled());
  if (found) return found;
  return step("Installing a browser for the end-to-end tests", async () => {
    if (await attempt("npx", ["playwright", "install", "chromium"])) {
      const path = await bundled();
      if (path) return path;
    }
    const mayInstall = process.getuid?.() === 0 || process.env.CI;
    const sudo = process.getuid?.() === 0 ? [] : ["sudo"];
    if (mayInstall && (await ask("which", ["apt-get"]))) {
      const apt = (...words) => attempt([...sudo, "apt-get"][0], [...sudo, "apt-get", ...words].slice(1));
      await apt("update", "-qq");
      if (await apt("install", "-y", "-qq", "chromium")) {
        const path = await installed();
        if (path) return path;
      }
    }
    throw new Stop(
      'No browser for the end-to-end tests: run "sudo apt-get install chromium" (or install Chromium your way), then again.',
    );
  });
}
