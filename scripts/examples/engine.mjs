import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { root } from "../steps/run.mjs";

// What the engine's command line answers.

/** The places of everybody at some times. */
export function motionOf(file, times) {
  return answered(["motion", file, "--at", times.join(","), "--json"]);
}

/** Least distance and mean distortion of every transition, to a thousandth. */
export function numbersOf(file) {
  const { segments } = answered(["measure", file, "--json"]);
  const rounded = (value) => Number(value.toFixed(3));
  return {
    leastDistances: segments.map(({ clearance }) => rounded(clearance.distance)),
    distortions: segments.map(({ distortion }) => rounded(distortion.mean)),
  };
}

/** `count` places in a drawing `width` meters wide (SVG, in a square of 100), evenly and no nearer than `apart`. */
export function placesIn(drawing, count, width, apart) {
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="-10 -10 120 120">${drawing}</svg>`;
  const sizes = ["--agents", count, "--width", width, "--minimum-distance", apart].map(String);
  return answeredOf("shape.svg", svg, (file) => ["shape", file, ...sizes]).keyframes[0].positions;
}

/** The targets, one a source: the one it takes where the sum of `cost` is least. */
export function assigned(sources, targets, cost) {
  const keyframes = [{ positions: sources }, { time: 1, positions: targets }];
  const scene = JSON.stringify({ format: "eigenform", version: 1, keyframes });
  const asked = ["--from", "0", "--to", "1", "--cost", cost, "--json"];
  const { assignment } = answeredOf("ends.json", scene, (file) => ["assign", file, ...asked]);
  return assignment.map((slot) => targets[slot]);
}

/** What it answers of a file that is there for so long. */
function answeredOf(name, text, words) {
  const folder = mkdtempSync(join(tmpdir(), "eigenform-"));
  const file = join(folder, name);
  try {
    writeFileSync(file, text);
    return answered(words(file));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

function answered(words) {
  const command = ["run", "-q", "-p", "eigenform-cli", "--", ...words];
  return JSON.parse(execFileSync("cargo", command, { cwd: `${root}/core-rs`, encoding: "utf8", maxBuffer: 1 << 28 }));
}
