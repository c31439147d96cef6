import type { Point } from "../../document/formation";
import type { Recording } from "../../engine/recording";
import type { Camera } from "../../stage/camera";
import type { Palette } from "../../stage/palette";
import { discRadius, screenSpacing } from "../../stage/spacing";

/** Seconds of a trail, and frames of it that are drawn at most. */
const TRAIL = 2;
const TRAIL_PIECES = 24;
/** Fainter toward its end, in so many steps. */
const STEPS = 3;

export interface RecordingLook {
  readonly camera: Camera;
  readonly palette: Palette;
  readonly shift: Point;
  /** As shown, by agent. */
  readonly colors: readonly string[];
  /** How firm it is drawn, 0..1. */
  readonly strength: number;
  /** Of its discs, beside those of agents. */
  readonly size: number;
  /** Meters between neighbors. */
  readonly spacing: number;
}

/** Draws a recording at a time, its trails faint to firm. */
export function drawRecording(
  context: CanvasRenderingContext2D,
  recording: Recording,
  time: number,
  look: RecordingLook,
): void {
  const { camera, shift, colors, strength } = look;
  const radius = look.size * discRadius(screenSpacing(look.spacing, camera.scale));
  const frame = recording.frameAt(time);
  const start = recording.frameAt(time - TRAIL);
  const stride = Math.max(1, Math.ceil((frame - start) / TRAIL_PIECES));
  const x = (place: Point) => (place[0] + shift[0]) * camera.scale + camera.left;
  const y = (place: Point) => camera.top - (place[1] + shift[1]) * camera.scale;
  context.lineCap = "round";
  context.lineJoin = "round";
  for (let agent = 0; agent < recording.agentCount; agent += 1) {
    const color = colors[agent] ?? look.palette.ink3;
    context.strokeStyle = color;
    for (let step = 1; step <= STEPS; step += 1) {
      const from = start + Math.floor(((frame - start) * (step - 1)) / STEPS);
      const to = start + Math.floor(((frame - start) * step) / STEPS);
      context.globalAlpha = (0.32 * strength * step) / STEPS;
      context.lineWidth = Math.max(0.75, (1.2 * radius * step) / STEPS);
      context.beginPath();
      let isDown = false;
      for (let at = from; at <= to; at = at < to ? Math.min(to, at + stride) : to + 1) {
        if (!recording.isPresent(at, agent)) {
          isDown = false;
          continue;
        }
        const place = recording.place(at, agent);
        if (isDown) context.lineTo(x(place), y(place));
        else context.moveTo(x(place), y(place));
        isDown = true;
      }
      context.stroke();
    }
    if (!recording.isPresent(frame, agent)) continue;
    const place = recording.place(frame, agent);
    context.globalAlpha = strength;
    context.fillStyle = color;
    context.beginPath();
    context.arc(x(place), y(place), radius, 0, 2 * Math.PI);
    context.fill();
  }
  context.globalAlpha = 1;
}
