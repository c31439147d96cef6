import type { Bounds } from "../camera";
import type { Frame } from "../frame";
import { FOOTBALL } from "../sheet";
import { fade } from "../spacing";
import { crisp } from "./crisp";
import { font } from "./text";

/** Four steps of eight to five yards, the marcher's grid. */
const FOUR_STEPS = 2.286;
/** From a sideline to the middle of a number; numbers are 2.1 m high. */
const NUMBER_PLACE = 7.6;
const NUMBER_HEIGHT = 2.1;
/** Room between the two digits, which stand astride their line. */
const NUMBER_GAP = 0.35;
const HASH_LENGTH = 0.6;

/** Meters from the middle to the hash marks: 40 feet apart in college, thirds of the width in high school. */
const HASHES = { college: 6.096, "high-school": 8.128 } as const;

/** An American field: yard lines, hash marks and numbers, with the marcher's grid when there is room. */
export function drawFootball(
  context: CanvasRenderingContext2D,
  frame: Frame,
  sheet: Bounds,
  level: keyof typeof HASHES,
): void {
  const { palette, camera } = frame;
  const goal = FOOTBALL.goalToGoal / 2;
  const side = FOOTBALL.depth / 2;
  const left = frame.screenX(sheet.minX);
  const right = frame.screenX(sheet.maxX);
  const back = frame.screenY(side);
  const front = frame.screenY(-side);
  context.lineWidth = 1;

  const grid = fade(FOUR_STEPS * camera.scale, 18, 26);
  if (grid > 0) {
    context.globalAlpha = grid;
    context.strokeStyle = palette.fieldLineMinor;
    context.beginPath();
    for (let line = 1; line * FOUR_STEPS < 2 * goal; line += 2) {
      const x = crisp(frame.screenX(-goal + line * FOUR_STEPS));
      context.moveTo(x, back);
      context.lineTo(x, front);
    }
    for (let y = FOUR_STEPS; y < 2 * side; y += FOUR_STEPS) {
      const at = crisp(frame.screenY(-side + y));
      context.moveTo(left, at);
      context.lineTo(right, at);
    }
    context.stroke();
  }

  context.globalAlpha = 1;
  context.strokeStyle = palette.fieldLine;
  context.beginPath();
  for (let line = 0; line <= 20; line += 1) {
    const x = crisp(frame.screenX(-goal + line * 5 * FOOTBALL.yard));
    context.moveTo(x, back);
    context.lineTo(x, front);
  }
  context.stroke();
  drawHashes(context, frame, HASHES[level]);
  drawNumbers(context, frame);
}

function drawHashes(context: CanvasRenderingContext2D, frame: Frame, middle: number): void {
  const goal = FOOTBALL.goalToGoal / 2;
  const side = FOOTBALL.depth / 2;
  const isRoomy = fade(FOOTBALL.yard * frame.camera.scale, 3, 6);
  if (isRoomy === 0) return;
  context.globalAlpha = isRoomy;
  context.beginPath();
  for (let yard = 0; yard <= 100; yard += 1) {
    const x = crisp(frame.screenX(-goal + yard * FOOTBALL.yard));
    for (const from of [-side, -middle - HASH_LENGTH / 2, middle - HASH_LENGTH / 2, side - HASH_LENGTH]) {
      context.moveTo(x, frame.screenY(from));
      context.lineTo(x, frame.screenY(from + HASH_LENGTH));
    }
  }
  context.stroke();
  context.globalAlpha = 1;
}

function drawNumbers(context: CanvasRenderingContext2D, frame: Frame): void {
  const { palette, camera } = frame;
  const goal = FOOTBALL.goalToGoal / 2;
  const place = FOOTBALL.depth / 2 - NUMBER_PLACE;
  const gap = (NUMBER_GAP * camera.scale) / 2;
  context.fillStyle = palette.fieldNumber;
  context.font = font(palette, NUMBER_HEIGHT * camera.scale);
  context.textBaseline = "middle";
  for (let line = 2; line <= 18; line += 2) {
    const yards = String(50 - Math.abs(line - 10) * 5);
    const x = frame.screenX(-goal + line * 5 * FOOTBALL.yard);
    for (const y of [place, -place]) {
      context.textAlign = "right";
      context.fillText(yards.slice(0, 1), x - gap, frame.screenY(y));
      context.textAlign = "left";
      context.fillText(yards.slice(1), x + gap, frame.screenY(y));
    }
  }
}
