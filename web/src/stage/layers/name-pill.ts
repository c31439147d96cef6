import type { Frame } from "../frame";
import { ROOMY_RADIUS } from "./names";
import { drawPill } from "./pill";

/** Whether an agent's whole name is not already inside its disc. */
export function needsPill(frame: Frame, agent: number, areNamesShown: boolean): boolean {
  const isInside = areNamesShown && frame.radius >= ROOMY_RADIUS;
  return !isInside || frame.cast.names[agent] !== frame.cast.shortNames[agent];
}

/** The name of an agent beside its disc, for those hovered and selected. */
export function drawNamePill(context: CanvasRenderingContext2D, frame: Frame, agent: number): void {
  const { palette, radius, points } = frame;
  const x = points[2 * agent] ?? 0;
  const y = points[2 * agent + 1] ?? 0;
  if (!frame.sees(x, y, radius)) return;
  drawPill(context, palette, frame.cast.names[agent] ?? "", {
    x: x + radius + 6,
    y,
    align: "left",
    height: 18,
    fill: palette.raised,
    ink: palette.ink,
    edge: palette.lineStrong,
  });
}
