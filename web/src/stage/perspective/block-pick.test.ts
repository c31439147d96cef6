import { expect, test } from "vitest";
import type { Obstacle } from "../../document/scene";
import { blockAt } from "./block-pick";
import { Sight } from "./sight";

const circle: Obstacle = { name: "", shape: { kind: "circle", center: [0, 0], radius: 2 } };
const corner: Obstacle = {
  name: "",
  shape: {
    kind: "polygon",
    points: [
      [8, 6],
      [14, 6],
      [14, 12],
      [8, 12],
    ],
  },
};
const HEIGHT = 1;

const sight = new Sight();
sight.look({ x: 0, y: 0, z: 0, distance: 60, azimuth: 0.3, elevation: 0.4 }, { width: 1000, height: 600 });

function pick(x: number, y: number, z: number, obstacles: readonly Obstacle[] = [circle, corner]): number | null {
  const out = new Float32Array(3);
  sight.projectInto(x, y, z, out, 0);
  return blockAt(sight, obstacles, HEIGHT, { x: out[0] ?? 0, y: out[1] ?? 0 });
}

test("a block is met on its top and on the wall toward the eye", () => {
  expect(pick(0, 0, HEIGHT)).toBe(0);
  expect(pick(0.3 * 1.9, -1.9, HEIGHT / 2)).toBe(0);
  expect(pick(11, 9, HEIGHT)).toBe(1);
  expect(pick(4, -4, 0)).toBeNull();
});

test("of blocks one behind the other the nearer is met", () => {
  const behind: Obstacle = { name: "", shape: { kind: "circle", center: [0, 3], radius: 2 } };
  expect(pick(0, 0.5, HEIGHT, [behind, circle])).toBe(1);
});

test("there is nothing in the sky", () => {
  expect(blockAt(sight, [circle], HEIGHT, { x: 500, y: -4000 })).toBeNull();
});
