import type { Palette } from "../../stage/palette";
import { clamp } from "../../stage/spacing";
import type { Preview } from "./services";

const PADDING = 14;
/** Steps from faint to firm; each is one path a color. */
const TRAIL_STEPS = 10;
/** Above this the ribbons are too fine for bends within a step. */
const MANY_AGENTS = 500;
/** Alpha of the faintest step, and how firm the nearest is beside the stage's trails. */
const FAINTEST = 0.03;
const FIRMEST = 0.75;

interface Fit {
  readonly scale: number;
  readonly left: number;
  readonly top: number;
  readonly radius: number;
}

const fits = new WeakMap<Preview, { readonly width: number; readonly height: number; readonly fit: Fit }>();

/** Draws a transition at `t` of its way, 0..1, with the trails that led there. */
export function drawPreview(canvas: HTMLCanvasElement, preview: Preview, t: number, palette: Palette): void {
  const context = canvas.getContext("2d");
  const { clientWidth: width, clientHeight: height } = canvas;
  if (!context || width === 0) return;
  const density = globalThis.devicePixelRatio || 1;
  const [pixelsAcross, pixelsDown] = [Math.round(width * density), Math.round(height * density)];
  if (canvas.width !== pixelsAcross || canvas.height !== pixelsDown) {
    canvas.width = pixelsAcross;
    canvas.height = pixelsDown;
  }
  context.setTransform(density, 0, 0, density, 0, 0);
  context.clearRect(0, 0, width, height);
  const fit = fitOf(preview, width, height);
  const byColor = agentsByColor(preview);
  for (const [color, agents] of byColor) {
    context.fillStyle = palette.shown(color);
    drawTrails(context, preview, agents, t, fit, palette.trailAlpha * FIRMEST);
  }
  for (const [color, agents] of byColor) {
    context.fillStyle = palette.shown(color);
    context.beginPath();
    for (const agent of agents) {
      const [x, y] = placeAt(preview, agent, t, fit);
      context.moveTo(x + fit.radius, y);
      context.arc(x, y, fit.radius, 0, 2 * Math.PI);
    }
    context.fill();
  }
}

/** Ribbons from faint to firm, thin to thick; each step of alpha is one path. */
function drawTrails(
  context: CanvasRenderingContext2D,
  preview: Preview,
  agents: readonly number[],
  t: number,
  fit: Fit,
  firmest: number,
): void {
  const pieces = preview.agentCount > MANY_AGENTS ? 1 : 3;
  for (let step = 0; step < TRAIL_STEPS; step += 1) {
    const share = (step + 0.5) / TRAIL_STEPS;
    context.globalAlpha = FAINTEST + (firmest - FAINTEST) * share ** 1.6;
    context.beginPath();
    for (const agent of agents) {
      for (let piece = 0; piece < pieces; piece += 1) {
        const from = (step + piece / pieces) / TRAIL_STEPS;
        const to = (step + (piece + 1) / pieces) / TRAIL_STEPS;
        addPiece(context, placeAt(preview, agent, t * from, fit), placeAt(preview, agent, t * to, fit), from, to, fit);
      }
    }
    context.fill();
  }
  context.globalAlpha = 1;
}

type Place = readonly [x: number, y: number];

/** A stretch of a ribbon; `from` and `to` are where it lies along it, 0..1. */
function addPiece(context: CanvasRenderingContext2D, a: Place, b: Place, from: number, to: number, fit: Fit): void {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const length = Math.hypot(dx, dy);
  if (length < 0.05) return;
  const [across, up] = [-dy / length, dx / length];
  const widest = fit.radius * 0.95;
  const [thin, thick] = [0.2 + (widest - 0.2) * from, 0.2 + (widest - 0.2) * to];
  context.moveTo(a[0] + across * thin, a[1] + up * thin);
  context.lineTo(b[0] + across * thick, b[1] + up * thick);
  context.lineTo(b[0] - across * thick, b[1] - up * thick);
  context.lineTo(a[0] - across * thin, a[1] - up * thin);
}

function placeAt(preview: Preview, agent: number, t: number, fit: Fit): Place {
  const at = clamp(t, 0, 1) * (preview.sampleCount - 1);
  const sample = Math.min(Math.floor(at), preview.sampleCount - 2);
  const share = at - sample;
  const from = (sample * preview.agentCount + agent) * 2;
  const to = from + preview.agentCount * 2;
  const x = (preview.xy[from] ?? 0) * (1 - share) + (preview.xy[to] ?? 0) * share;
  const y = (preview.xy[from + 1] ?? 0) * (1 - share) + (preview.xy[to + 1] ?? 0) * share;
  return [fit.left + x * fit.scale, fit.top - y * fit.scale];
}

/** The whole way fits, so that a card does not move its camera. */
function fitOf(preview: Preview, width: number, height: number): Fit {
  const known = fits.get(preview);
  if (known && known.width === width && known.height === height) return known.fit;
  let [left, right, bottom, top] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let index = 0; index < preview.xy.length; index += 2) {
    const [x, y] = [preview.xy[index] ?? 0, preview.xy[index + 1] ?? 0];
    left = Math.min(left, x);
    right = Math.max(right, x);
    bottom = Math.min(bottom, y);
    top = Math.max(top, y);
  }
  const scale = Math.min(
    (width - 2 * PADDING) / Math.max(right - left, 1),
    (height - 2 * PADDING) / Math.max(top - bottom, 1),
  );
  const fit: Fit = {
    scale,
    left: width / 2 - ((left + right) / 2) * scale,
    top: height / 2 + ((bottom + top) / 2) * scale,
    radius: clamp(0.34 * Math.sqrt(((right - left) * (top - bottom)) / preview.agentCount / 4) * scale, 1.1, 4.5),
  };
  fits.set(preview, { width, height, fit });
  return fit;
}

function agentsByColor(preview: Preview): Map<string, number[]> {
  const byColor = new Map<string, number[]>();
  for (const [agent, color] of preview.colors.entries()) {
    const agents = byColor.get(color);
    if (agents) agents.push(agent);
    else byColor.set(color, [agent]);
  }
  return byColor;
}
