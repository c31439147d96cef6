// Timings: the engine natively and in Chromium beside numpy and scipy, and the page's frames. Medians; a ratio says more than a time.
import { fileURLToPath } from "node:url";
import { crowdTable, jupedsimRows, recastRows, walkRows } from "./bench/crowds.mjs";
import { perspectiveRows, playbackRows } from "./bench/frames.mjs";
import { median } from "./bench/median.mjs";
import { memoryRow } from "./bench/memory.mjs";
import { browserRows, nativeRows, peerRows } from "./bench/rows.mjs";
import { findBrowser } from "./steps/browser.mjs";
import { buildEngine, buildPage } from "./steps/build.mjs";
import { main, step } from "./steps/run.mjs";
import { prepare } from "./steps/tools.mjs";

/** What each row promises in Chromium: milliseconds, or so many times the peer. */
const PROMISES = {
  "eigenbasis 300": "≤ 4 × numpy",
  "eigenbasis 1260": "≤ 4 × numpy",
  "assignment 1260": "≤ 2 × scipy",
  "assignment 1936": "≤ 2 × scipy",
  "affinity of 1260": "≤ 5 s",
  "moved agent 60": "≤ 15 ms",
  "moved agent 300": "≤ 200 ms",
  "moved agent 25 auto": "≤ 30 ms",
  "moved group in 1260": "≤ 100 ms",
  "one transition of 1260": "≤ 6 s",
  "show of 200 x 23 auto": "≤ 6 s",
  "smooth join of 300 x 6": "≤ 1.5 s",
  "table 1: band 25 x 1211": "≤ 0.5 s",
  "table 1: soccer 14 x 238": "≤ 0.1 s",
  "table 1: figures 1260 x 991": "≤ 6 s",
  "table 1: airshow 10 x 540": "≤ 0.1 s",
  "blocks of 1936 kept apart": "≤ 4 s",
};

const cell = (value) => (value === undefined ? "–" : value < 10 ? value.toFixed(2) : value.toFixed(0));
const ratio = (value, peer) => (value === undefined || peer === undefined ? "–" : `${(value / peer).toFixed(2)}×`);

main(async () => {
  await buildEngine(await prepare());
  await buildPage();
  const browser = await findBrowser();
  const folder = fileURLToPath(new URL("./bench/", import.meta.url));
  const native = await step("Native", nativeRows);
  const chromium = await step("Chromium", () => browserRows(browser, folder));
  const peers = await step("numpy and scipy", peerRows);
  console.log(
    "\nmilliseconds (median)        native  chromium  peer   native/peer  chromium/peer  promise in Chromium",
  );
  for (const [name, promise] of Object.entries(PROMISES)) {
    const [a, b, c] = [native[name], chromium[name] && median(chromium[name]), peers?.[name] && median(peers[name])];
    const columns = [cell(a).padStart(7), cell(b).padStart(9), cell(c).padStart(5)];
    console.log(
      `${name.padEnd(27)} ${columns.join(" ")}  ${ratio(a, c).padStart(11)}  ${ratio(b, c).padStart(13)}  ${promise}`,
    );
  }
  if (!peers) console.log("numpy and scipy did not install: no peer.");
  const walks = await step("Crowds in Chromium", () => walkRows(browser, folder));
  const jupedsim = await step("JuPedSim", jupedsimRows);
  const recast = await step("Recast", () => recastRows(browser, folder));
  for (const line of crowdTable({ native, chromium: walks, jupedsim, recast })) console.log(line);
  console.log(await step("The page's memory", () => memoryRow(browser)));
  for (const line of await step("The page's frames", () => playbackRows(browser))) console.log(line);
  for (const line of await step("The perspective view's frames", () => perspectiveRows(browser))) console.log(line);
});
