// Writes the example scenes and the gallery's previews of them. Run by hand after a change; the files are committed.
import { execFileSync } from "node:child_process";
import { mkdirSync, writeFileSync } from "node:fs";
import { airshow } from "./examples/airshow.mjs";
import { band } from "./examples/band.mjs";
import { bird, fighters, runningMan } from "./examples/crowds.mjs";
import { fieldShow } from "./examples/field-show.mjs";
import { gridToRing, threeBlocks } from "./examples/figures.mjs";
import { flower } from "./examples/flower.mjs";
import { starToRings } from "./examples/large.mjs";
import { marchText, marchTimes } from "./examples/march.mjs";
import {
  aligned,
  clusters,
  clustersApart,
  fourAroundOne,
  polarOrSpectral,
  rotatedCopy,
  sixModes,
  smallAndLarge,
  winding,
} from "./examples/pairs.mjs";
import { previewOf, sampleTimes } from "./examples/preview.mjs";
import { offsideTrap } from "./examples/soccer.mjs";
import { sceneText } from "./examples/text.mjs";
import { thousand } from "./examples/thousand.mjs";
import { main, root, step } from "./steps/run.mjs";

/** By file name; `cover` is the transition that the gallery shows. */
const EXAMPLES = {
  band: { make: band, cover: 1 },
  "half-time": { make: fieldShow, cover: 0 },
  flower: { make: flower, cover: 0 },
  "star-to-five-rings": { make: starToRings, cover: 1 },
  "three-blocks": { make: threeBlocks, cover: 1 },
  "grid-to-ring": { make: gridToRing, cover: 0 },
  thousand: { make: thousand, cover: 1 },
  "six-modes": { make: sixModes, cover: 0 },
  "rotated-copy": { make: rotatedCopy, cover: 2 },
  alignment: { make: aligned, cover: 2 },
  "polar-or-spectral": { make: polarOrSpectral, cover: 2 },
  "four-around-one": { make: fourAroundOne, cover: 2 },
  "small-and-large": { make: smallAndLarge, cover: 1 },
  winding: { make: winding, cover: 0 },
  clusters: { make: clusters, cover: 2 },
  "clusters-apart": { make: clustersApart, cover: 0 },
  "offside-trap": { make: offsideTrap, cover: 2 },
  bird: { make: bird, cover: 2 },
  "running-man": { make: runningMan, cover: 0 },
  fighters: { make: fighters, cover: 1 },
  airshow: { make: airshow, cover: 0 },
};

const folder = `${root}/public/examples`;

main(async () => {
  mkdirSync(folder, { recursive: true });
  const previews = {};
  for (const [id, { make, cover }] of Object.entries(EXAMPLES)) {
    await step(id, () => {
      const scene = make();
      const file = `${folder}/${id}.eigenform.json`;
      writeFileSync(file, sceneText(scene));
      previews[id] = previewOf(scene, motionOf(file, sampleTimes(scene, cover)));
    });
  }
  await step("march", () => {
    // Recorded is the band's show, as somebody in the stands would have filmed it.
    const scene = EXAMPLES.band.make();
    const motion = motionOf(`${folder}/band.eigenform.json`, marchTimes(scene));
    writeFileSync(`${folder}/march.txt`, marchText(motion));
    previews.march = previews.band;
  });
  writeFileSync(`${folder}/previews.json`, `${JSON.stringify(previews, null, 1)}\n`);
});

/** The places of everybody at some times, by the engine's command line. */
function motionOf(file, times) {
  const words = ["run", "-q", "-p", "eigenform-cli", "--", "motion", file, "--at", times.join(","), "--json"];
  return JSON.parse(execFileSync("cargo", words, { cwd: `${root}/core-rs`, encoding: "utf8", maxBuffer: 1 << 28 }));
}
