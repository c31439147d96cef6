// Writes the example scenes and the gallery's previews of them: all, or those named. Run by hand after a change; the files are
// committed.
import { mkdirSync, writeFileSync } from "node:fs";
import { band } from "./examples/band.mjs";
import { motionOf, numbersOf } from "./examples/engine.mjs";
import { marchText, marchTimes } from "./examples/march.mjs";
import { previewOf, sampleTimes } from "./examples/preview.mjs";
import { CROWDS } from "./examples/room-crowds.mjs";
import { FORMATION_CONTROL } from "./examples/room-formation-control.mjs";
import { SHOWS } from "./examples/room-shows.mjs";
import { sceneText } from "./examples/text.mjs";
import { main, root, step } from "./steps/run.mjs";

const EXAMPLES = { ...SHOWS, ...FORMATION_CONTROL, ...CROWDS };
/** Whose march somebody in the stands has recorded. */
const MARCHES = "band";

const folder = `${root}/public/examples`;
const named = process.argv.slice(2);

main(async () => {
  mkdirSync(`${folder}/previews`, { recursive: true });
  const wanted = Object.entries(EXAMPLES).filter(([id]) => named.length === 0 || named.includes(id));
  for (const [id, { make, cover }] of wanted) {
    await step(id, () => {
      const scene = make();
      const file = `${folder}/${id}.eigenform.json`;
      writeFileSync(file, sceneText(scene));
      const preview = { ...previewOf(scene, motionOf(file, sampleTimes(scene, cover))), ...numbersOf(file) };
      writePreview(id, preview);
      if (id === MARCHES) writeMarch(file, preview);
    });
  }
});

function writeMarch(file, preview) {
  writeFileSync(`${folder}/march.txt`, marchText(motionOf(file, marchTimes(band()))));
  writePreview("march", { ...preview, leastDistances: [], distortions: [] });
}

function writePreview(id, preview) {
  writeFileSync(`${folder}/previews/${id}.json`, `${JSON.stringify(preview)}\n`);
}
