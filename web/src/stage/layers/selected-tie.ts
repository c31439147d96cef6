import type { Frame } from "../frame";

/** The tie that is selected, in the person's color, from disc to disc. */
export function drawSelectedTie(
  context: CanvasRenderingContext2D,
  frame: Frame,
  a: number,
  b: number,
  width: number,
): void {
  const { points, radius } = frame;
  const x = points[2 * a] ?? 0;
  const y = points[2 * a + 1] ?? 0;
  const dx = (points[2 * b] ?? 0) - x;
  const dy = (points[2 * b + 1] ?? 0) - y;
  const length = Math.hypot(dx, dy);
  if (length <= 2 * radius) return;
  const inset = radius / length;
  context.lineWidth = width + 1;
  context.lineCap = "round";
  context.strokeStyle = frame.palette.you;
  context.beginPath();
  context.moveTo(x + dx * inset, y + dy * inset);
  context.lineTo(x + dx * (1 - inset), y + dy * (1 - inset));
  context.stroke();
}
