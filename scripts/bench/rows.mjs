import { readdir, readFile } from "node:fs/promises";
import { join } from "node:path";
import { ask, root, run } from "../steps/run.mjs";

export const BROWSER_FLAGS = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--disable-features=WebUIOmniboxPopup,WebUIOmniboxAimPopup",
];

/** Criterion's medians by name, milliseconds. */
export async function nativeRows() {
  const cwd = join(root, "core-rs");
  await run("cargo", ["bench", "--quiet", "--package", "eigenform-bench"], { cwd });
  const folder = join(process.env.CARGO_TARGET_DIR ?? join(cwd, "target"), "criterion");
  const rows = {};
  for (const name of await readdir(folder)) {
    const read = (file) => readFile(join(folder, name, "new", file), "utf8").then(JSON.parse, () => null);
    const [estimates, benchmark] = await Promise.all([read("estimates.json"), read("benchmark.json")]);
    if (estimates && benchmark) rows[benchmark.full_id] = estimates.median.point_estimate / 1e6;
  }
  return rows;
}

/** Hands the page of the bench's folder to `measure`, as Vite serves it; `alias` tells where packages are that are not the page's. */
export async function withBench(executablePath, folder, measure, alias = {}) {
  const [{ createServer }, { chromium }] = await Promise.all([import("vite"), import("@playwright/test")]);
  const server = await createServer({
    root: folder,
    configFile: false,
    logLevel: "error",
    resolve: { alias },
    optimizeDeps: { noDiscovery: true },
    server: { host: "127.0.0.1", fs: { allow: [root] } },
  });
  await server.listen();
  const browser = await chromium.launch({ executablePath, args: BROWSER_FLAGS });
  try {
    const page = await browser.newPage();
    await page.goto(server.resolvedUrls.local[0]);
    return await measure(page);
  } finally {
    await browser.close();
    await server.close();
  }
}

/** Every run of every row in Chromium, milliseconds. */
export function browserRows(executablePath, folder) {
  return withBench(executablePath, folder, async (page) => {
    await page.waitForFunction(() => window.benchRows);
    const rows = {};
    for (const name of await page.evaluate(() => window.benchRows)) {
      rows[name] = await page.evaluate((row) => window.benchRow(row), name);
      console.log(`  ${name}`);
    }
    return rows;
  });
}

/** What a script of the bench prints with some Python packages on one thread; null where they do not install. */
export async function pythonRows(packages, script) {
  const venv = join(root, ".cache/bench-venv");
  const python = join(venv, "bin/python");
  const isThere = (await ask(python, ["-c", `import ${packages.join(", ")}`])) !== null;
  if (!isThere) {
    await ask("python3", ["-m", "venv", venv]);
    if ((await ask(python, ["-m", "pip", "install", "--quiet", ...packages])) === null) return null;
  }
  const single = { OPENBLAS_NUM_THREADS: "1", OMP_NUM_THREADS: "1", MKL_NUM_THREADS: "1" };
  Object.assign(process.env, single);
  const text = await ask(python, [join(root, "scripts/bench", script)]);
  return text === null ? null : JSON.parse(text);
}

/** numpy's and scipy's runs. */
export const peerRows = () => pythonRows(["numpy", "scipy"], "peers.py");
