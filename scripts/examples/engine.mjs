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
  const folder = mkdtempSync(join(tmpdir(), "eigenform-"));
  const file = join(folder, "shape.svg");
  try {
    writeFileSync(file, `<svg xmlns="http://www.w3.org/2000/svg" viewBox="-10 -10 120 120">${drawing}</svg>`);
    const sizes = ["--agents", count, "--width", width, "--minimum-distance", apart].map(String);
    return answered(["shape", file, ...sizes]).keyframes[0].positions;
  } finally {
    rmSync(folder, { recursive: true });
  }
}

function answered(words) {
  const command = ["run", "-q", "-p", "eigenform-cli", "--", ...words];
  return JSON.parse(execFileSync("cargo", command, { cwd: `${root}/core-rs`, encoding: "utf8", maxBuffer: 1 << 28 }));
}
