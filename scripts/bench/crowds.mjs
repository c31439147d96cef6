import { access, readFile } from "node:fs/promises";
import { join } from "node:path";
import { ask, root, run } from "../steps/run.mjs";
import { WASM_TARGET } from "../steps/tools.mjs";
import { median } from "./median.mjs";
import { pythonRows, withBench } from "./rows.mjs";

/** How many steps a second a crowd of so many promises in Chromium: all forces and feedback, 1/30 s each. */
const PROMISES = { 110: 5000, 306: 2500, 783: 1200, 1190: 700, 1936: 400, 10000: 50 };

const SIZES = Object.keys(PROMISES).map(Number);
const STEPS = 300;
const rowOf = (agentCount) => `crowd of ${agentCount}, ${STEPS} steps`;
const runsOf = (agentCount) => (agentCount > 5000 ? 1 : 5);
const RECAST = "0.43.1";

const CARGO = ["build", "--quiet", "--profile", "page", "--target", WASM_TARGET, "--package", "eigenform-bench"];

/** Measures milliseconds that the page's thread works, which what else runs on the machine makes little longer. */
async function processorTime(page) {
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  const now = async () => {
    const { metrics } = await session.send("Performance.getMetrics");
    return 1000 * metrics.find((metric) => metric.name === "ThreadTime").value;
  };
  return async (work) => {
    const start = await now();
    await work();
    return (await now()) - start;
  };
}

/** What our crowds' walk takes in Chromium beyond the straight guide that it follows, by row. */
export async function walkRows(executablePath, folder) {
  const cwd = join(root, "core-rs");
  await run("cargo", [...CARGO, "--example", "walk"], { cwd });
  const target = process.env.CARGO_TARGET_DIR ?? join(cwd, "target");
  const bytes = await readFile(join(target, WASM_TARGET, "page/examples/walk.wasm"));
  return withBench(executablePath, folder, async (page) => {
    await page.evaluate(async (text) => {
      const module = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
      window.walk = (await WebAssembly.instantiate(module)).instance.exports.walk;
      // Out of the compiler's slow tier.
      window.walk(1000, true);
    }, bytes.toString("base64"));
    const time = await processorTime(page);
    const timed = (...words) => time(() => page.evaluate((all) => window.walk(...all), words));
    const rows = {};
    for (const agentCount of SIZES) {
      rows[rowOf(agentCount)] = [];
      for (let k = 0; k < runsOf(agentCount); k += 1) {
        const guide = await timed(agentCount, false);
        rows[rowOf(agentCount)].push((await timed(agentCount, true)) - guide);
      }
    }
    return rows;
  });
}

/** JuPedSim's social force on the same blocks, by row; null where it does not install. */
export const jupedsimRows = () => pythonRows(["jupedsim"], "crowds.py");

/** Recast's crowd on the same blocks in Chromium, by row; null where it does not install. */
export async function recastRows(executablePath, folder) {
  const prefix = join(root, ".cache/bench-peers");
  const packages = ["core", "generators", "wasm"].map((name) => `@recast-navigation/${name}`);
  const fileOf = (name) => join(prefix, "node_modules", name);
  const areThere = () =>
    Promise.all(packages.map((name) => access(fileOf(name)))).then(
      () => true,
      () => false,
    );
  if (!(await areThere())) {
    const asked = packages.map((name) => `${name}@${RECAST}`);
    await ask("npm", ["install", "--prefix", prefix, "--no-audit", "--no-fund", "--loglevel=error", ...asked]);
    if (!(await areThere())) return null;
  }
  const measure = async (page) => {
    await page.evaluate(async () => {
      window.recast = await import("./recast.mjs");
      await window.recast.begin();
    });
    const time = await processorTime(page);
    const rows = {};
    for (const agentCount of SIZES) {
      await page.evaluate((count) => window.recast.stand(count), agentCount);
      rows[rowOf(agentCount)] = [await time(() => page.evaluate((steps) => window.recast.go(steps), STEPS))];
    }
    return rows;
  };
  return withBench(executablePath, folder, measure, Object.fromEntries(packages.map((name) => [name, fileOf(name)])));
}

/** Steps a second of everybody who was measured, a line each. */
export function crowdTable({ native, chromium, jupedsim, recast }) {
  const rate = (runs) => (runs ? ((STEPS * 1000) / (Array.isArray(runs) ? median(runs) : runs)).toFixed(0) : "–");
  const lines = Object.entries(PROMISES).map(([agentCount, promise]) => {
    const rates = [native, chromium, jupedsim, recast].map((rows) => rate(rows?.[rowOf(agentCount)]).padStart(9));
    return `${agentCount.padStart(6)} agents ${rates.join(" ")}   ≥ ${promise}`;
  });
  const missing = [!jupedsim && "JuPedSim", !recast && "Recast"].filter(Boolean);
  return [
    "\ncrowd steps/s    native  chromium  JuPedSim    Recast   promise in Chromium",
    ...lines,
    ...missing.map((name) => `${name} did not install: no peer.`),
  ];
}
