import { readFile } from "node:fs/promises";
import { beforeAll, expect, test } from "vitest";
import { Ledger, sceneFrom } from "./ledger";
import init, { Engine } from "./pkg/workshop.js";

/** What the native engine answers, checked there by `engine/tests/perform.rs`; a place a frame and agent, meters. */
interface Case {
  readonly name: string;
  readonly scene: unknown;
  readonly positions: readonly (readonly (readonly number[])[])[];
}

const CASES = JSON.parse(
  await readFile(new URL("../../../core-rs/engine/tests/agreement.json", import.meta.url), "utf8"),
) as readonly Case[];

beforeAll(async () => {
  await init({ module_or_path: await readFile(new URL("./pkg/workshop_bg.wasm", import.meta.url)) });
});

test.each(CASES)("the browser's engine moves everybody as the native one: $name", ({ scene: file, positions }) => {
  const engine = new Engine();
  const opened = JSON.parse(engine.open(JSON.stringify(file)) ?? "null") as { readonly scene: string };
  const message = new Ledger().message(sceneFrom(opened.scene));
  for (const [id, xy, heights] of message.added) engine.put_formation(id, xy, heights);
  engine.set_scene(message.rest ?? undefined, Uint32Array.from(message.formations));
  const motion = JSON.parse(engine.write_motion("json")) as Case;

  const places = positions.flat(2);
  const extent = 2 * Math.max(...places.map(Math.abs));
  const far = motion.positions.flat(2).map((value, index) => Math.abs(value - (places[index] ?? Number.NaN)));
  expect(far).toHaveLength(places.length);
  // What the architecture promises between machines; the places on record are rounded to a hundredth of it.
  expect(Math.max(...far)).toBeLessThan(1e-8 * extent);
  engine.free();
});
