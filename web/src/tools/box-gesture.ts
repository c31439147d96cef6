import { rotateAgents, scaleAgents } from "../document/commands/transform";
import type { Point } from "../document/formation";
import type { Command } from "../document/store";
import type { Bounds } from "../stage/camera";
import { type Handle, type ScaleHandle, scaleAnchor } from "../stage/handles";
import type { Pointing } from "./tool";

/** Turns and stretches agents by the handles of their box. */
export interface BoxGesture {
  readonly handle: Exclude<Handle, "lift">;
  /** Where the handle was taken, meters. */
  readonly origin: Point;
  readonly bounds: Bounds;
  readonly keyframe: number;
  readonly agents: ReadonlySet<number>;
}

/** Shift turns by these steps. */
const TURN_STEP = Math.PI / 12;

/** Nobody is squeezed onto one spot: pulled through itself, a box turns inside out beyond this. */
const LEAST_FACTOR = 0.02;

/** Shift turns in steps of 15° and keeps the proportions of a corner, Alt stretches about the middle. */
export function boxCommand(gesture: BoxGesture, pointing: Pointing): Command {
  const { handle, keyframe, agents } = gesture;
  if (handle === "rotate") return rotateAgents(keyframe, agents, middleOf(gesture.bounds), turnOf(gesture, pointing));
  const anchor = pointing.alt ? middleOf(gesture.bounds) : scaleAnchor(gesture.bounds, handle);
  return scaleAgents(keyframe, agents, anchor, factorOf(gesture, handle, anchor, pointing));
}

function turnOf({ origin, bounds }: BoxGesture, { at, shift }: Pointing): number {
  const [x, y] = middleOf(bounds);
  const turn = Math.atan2(at[1] - y, at[0] - x) - Math.atan2(origin[1] - y, origin[0] - x);
  return shift ? Math.round(turn / TURN_STEP) * TURN_STEP : turn;
}

function factorOf({ origin, bounds }: BoxGesture, handle: ScaleHandle, anchor: Point, pointing: Pointing): Point {
  const edge: Point = [
    handle.includes("w") ? bounds.minX : bounds.maxX,
    handle.includes("s") ? bounds.minY : bounds.maxY,
  ];
  const pulls: readonly [boolean, boolean] = [/[we]/.test(handle), /[ns]/.test(handle)];
  const along = (axis: 0 | 1): number => {
    const reach = edge[axis] - anchor[axis];
    if (!pulls[axis] || reach === 0) return 1;
    return stretch((reach + pointing.at[axis] - origin[axis]) / reach);
  };
  const [x, y] = [along(0), along(1)];
  if (!pointing.shift || !pulls[0] || !pulls[1]) return [x, y];
  const both = Math.abs(x - 1) > Math.abs(y - 1) ? x : y;
  return [both, both];
}

function stretch(factor: number): number {
  if (Math.abs(factor) >= LEAST_FACTOR) return factor;
  return factor < 0 ? -LEAST_FACTOR : LEAST_FACTOR;
}

function middleOf({ minX, minY, maxX, maxY }: Bounds): Point {
  return [(minX + maxX) / 2, (minY + maxY) / 2];
}
