import type { Formation, Point } from "../../document/formation";
import type { Obstacle } from "../../document/scene";
import type { Bends } from "../../engine/api";
import { type Camera, type Size, toScreen } from "../../stage/camera";
import { drawObstacles } from "../../stage/layers/obstacles";
import type { Palette } from "../../stage/palette";
import { discRadius, neighborSpacing, screenSpacing } from "../../stage/spacing";
import { walksOf } from "./walks";

/** How much of the show behind still shows through. */
const VEIL = 0.94;

/** From so many agents on lines are drawn faint, or they would be one surface. */
const MANY = 300;

/** What is drawn of a trial: ways from where the agents are to the places they would take. */
export interface TrialSketch {
  readonly from: Formation;
  readonly to: Formation;
  /** By agent, the place it would take; null while it is not known. */
  readonly slots: readonly number[] | null;
  /** By agent, where its way there bends. */
  readonly bends: Bends;
  /** The same of the ways as they are drawn, which a motion may lead elsewhere. */
  readonly ways: Bends;
  /** What they bend around. */
  readonly obstacles: readonly Obstacle[];
  readonly locks: readonly (readonly [agent: number, slot: number])[];
  /** An agent being dragged, where to, and the place it would be locked to. */
  readonly drag: { readonly agent: number; readonly at: Point; readonly slot: number | null } | null;
}

export interface Look {
  readonly camera: Camera;
  readonly size: Size;
  readonly palette: Palette;
  /** By agent, as shown. */
  readonly colors: readonly string[];
}

/** Discs where the agents are, rings where they go, a line each; locked ones firm, the longest walk marked. */
export function drawTrial(context: CanvasRenderingContext2D, sketch: TrialSketch, look: Look): void {
  const { from, to, slots, bends, ways, locks, drag } = sketch;
  const { camera, size, palette, colors } = look;
  const radius = discRadius(screenSpacing(neighborSpacing(from), camera.scale));
  context.clearRect(0, 0, size.width, size.height);
  context.globalAlpha = VEIL;
  context.fillStyle = palette.sheet;
  context.fillRect(0, 0, size.width, size.height);
  context.globalAlpha = 1;
  drawObstacles(context, { ...look, ...screenOf(camera) }, sketch.obstacles, null);
  context.lineCap = "round";
  const line = (agent: number, end: Point, way: readonly Point[] = []) => {
    context.beginPath();
    for (const place of [from.point(agent), ...way, end]) {
      const { x, y } = toScreen(camera, place);
      context.lineTo(x, y);
    }
    context.stroke();
  };
  context.globalAlpha = from.agentCount > MANY ? 0.35 : 0.7;
  context.lineWidth = from.agentCount > MANY ? 0.8 : 1.4;
  slots?.forEach((slot, agent) => {
    context.strokeStyle = colors[agent] ?? palette.ink2;
    line(agent, to.point(slot), ways[agent]);
  });
  drawDiscs(context, sketch, look, radius);
  context.globalAlpha = 1;
  context.strokeStyle = palette.ink;
  context.lineWidth = 2;
  const longest = slots ? walksOf(from, to, bends, slots).who : -1;
  if (slots && longest >= 0) {
    context.setLineDash([6, 4]);
    line(longest, to.point(slots[longest] ?? longest), ways[longest]);
    context.setLineDash([]);
  }
  context.lineWidth = 2.5;
  for (const [agent, slot] of locks) line(agent, to.point(slot), slots?.[agent] === slot ? ways[agent] : []);
  if (drag) {
    context.strokeStyle = palette.you;
    line(drag.agent, drag.slot === null ? drag.at : to.point(drag.slot));
  }
}

function screenOf(camera: Camera) {
  return {
    screenX: (x: number) => toScreen(camera, [x, 0]).x,
    screenY: (y: number) => toScreen(camera, [0, y]).y,
  };
}

function drawDiscs(context: CanvasRenderingContext2D, sketch: TrialSketch, look: Look, radius: number): void {
  const { from, to, slots, drag } = sketch;
  const { camera, palette, colors } = look;
  const circle = (place: Point, size: number) => {
    const { x, y } = toScreen(camera, place);
    context.beginPath();
    context.arc(x, y, size, 0, 2 * Math.PI);
  };
  context.globalAlpha = 0.55;
  for (let agent = 0; agent < from.agentCount; agent += 1) {
    context.fillStyle = colors[agent] ?? palette.ink2;
    circle(from.point(agent), 0.75 * radius);
    context.fill();
  }
  context.globalAlpha = 1;
  context.lineWidth = Math.max(1.2, 0.2 * radius);
  const taker = new Map(slots?.map((slot, agent) => [slot, agent]));
  for (let slot = 0; slot < to.agentCount; slot += 1) {
    const isAimedAt = drag !== null && drag.slot === slot;
    context.strokeStyle = isAimedAt ? palette.you : (colors[taker.get(slot) ?? -1] ?? palette.ink2);
    circle(to.point(slot), isAimedAt ? 1.25 * radius : radius);
    context.stroke();
  }
}
