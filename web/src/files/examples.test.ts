import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { describe, expect, test } from "vitest";
import { FIRST_EXAMPLE } from "./examples";
import { type StoredPreview, unpack } from "./gallery/previews";
import { SECTIONS } from "./gallery/sections";

type Place = readonly [x: number, y: number, height?: number];

interface SceneFile {
  readonly title: string;
  readonly minimumDistance: number;
  readonly groups?: readonly { readonly members: readonly number[] }[];
  readonly keyframes: readonly { readonly time: number; readonly positions: readonly Place[] }[];
}

function publicFile(name: string): string {
  return readFileSync(fileURLToPath(new URL(`../../../public/examples/${name}`, import.meta.url)), "utf8");
}

function least(places: readonly Place[]): number {
  let nearest = Number.POSITIVE_INFINITY;
  for (const [index, [x, y, z = 0]] of places.entries()) {
    for (const [u, v, w = 0] of places.slice(index + 1)) nearest = Math.min(nearest, Math.hypot(u - x, v - y, w - z));
  }
  return nearest;
}

const EXAMPLES = SECTIONS.flatMap(({ cards }) => cards);
const SCENES = EXAMPLES.filter(({ view }) => view?.kind !== "recording");

describe.each(SCENES)("the example $id", ({ id, title, agentCount, keyframeCount }) => {
  const scene = JSON.parse(publicFile(`${id}.eigenform.json`)) as SceneFile;

  test("is what the gallery says of it", () => {
    expect(scene.title.startsWith(title)).toBe(true);
    expect(scene.keyframes).toHaveLength(keyframeCount);
    for (const { positions } of scene.keyframes) expect(positions).toHaveLength(agentCount);
  });

  test("keeps its own minimum distance in every keyframe", () => {
    expect(scene.minimumDistance).toBeGreaterThan(0);
    for (const { positions } of scene.keyframes) {
      expect(least(positions)).toBeGreaterThanOrEqual(scene.minimumDistance);
    }
  });
});

test.each(EXAMPLES)("$id has a preview of all its agents", ({ id, agentCount }) => {
  const preview = unpack(JSON.parse(publicFile(`previews/${id}.json`)) as StoredPreview);
  expect(preview.colors).toHaveLength(agentCount);
  expect(preview.xy).toHaveLength(preview.sampleCount * agentCount * 2);
});

test("the first example is a band of 25 in sections of 3, 5, 5, 5, 4 and 3", () => {
  const scene = JSON.parse(publicFile(`${FIRST_EXAMPLE}.eigenform.json`)) as SceneFile;
  expect(scene.groups?.map((group) => group.members.length)).toEqual([3, 5, 5, 5, 4, 3]);
});
