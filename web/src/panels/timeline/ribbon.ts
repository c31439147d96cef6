import type { Status } from "../status";

const FAINT_END = 2.4;
const FIRM_END = 20;
const PINCH_HALF_WIDTH = 20;
const PINCHED_HEIGHT = 1.6;
const CUT_HALF_WIDTH = 3.5;

/**
 * The wedge, thin where it comes from and firm where it goes: holds whole, tight pinched, clash cut at the moment.
 *
 * @param moment 0..1 along the ribbon; ignored by the shapes that have none
 * @returns an SVG path in a box of width × height, centered in the height; empty when there is no room
 */
export function ribbonPath(status: Status, width: number, height: number, moment: number): string {
  if (width < 2) return "";
  const middle = height / 2;
  const half = (x: number) => (FAINT_END + (FIRM_END - FAINT_END) * (x / width)) / 2;
  const piece = (from: number, to: number) => {
    if (to - from < 0.5) return "";
    return `M${at(from)} ${at(middle - half(from))}L${at(to)} ${at(middle - half(to))}V${at(middle + half(to))}L${at(from)} ${at(middle + half(from))}Z`;
  };
  if (status === "clash") {
    const cut = momentX(moment, width, CUT_HALF_WIDTH);
    return piece(0, cut - CUT_HALF_WIDTH) + piece(cut + CUT_HALF_WIDTH, width);
  }
  if (status === "tight") {
    const reach = Math.min(PINCH_HALF_WIDTH, width / 4);
    const pinch = momentX(moment, width, reach);
    return pinchedWedge(width, middle, half, pinch, reach);
  }
  return piece(0, width);
}

/** The whole wedge's first `share`, 0..1: what has been planned of it. */
export function ribbonStart(share: number, width: number, height: number): string {
  const x = width * Math.min(1, Math.max(0, share));
  if (x < 0.5) return "";
  const [thin, thick] = [FAINT_END / 2, (FAINT_END + (FIRM_END - FAINT_END) * (x / width)) / 2];
  const middle = height / 2;
  return `M0 ${at(middle - thin)}L${at(x)} ${at(middle - thick)}V${at(middle + thick)}L0 ${at(middle + thin)}Z`;
}

/** Where the mark of a moment stands: at its time, but whole inside the ribbon. */
export function momentX(moment: number, width: number, reach: number): number {
  return Math.min(Math.max(moment * width, Math.min(reach, width / 2)), Math.max(width - reach, width / 2));
}

function pinchedWedge(
  width: number,
  middle: number,
  half: (x: number) => number,
  pinch: number,
  reach: number,
): string {
  const edge = (sign: 1 | -1, x: number, amount = half(x)) => `${at(x)} ${at(middle + sign * amount)}`;
  const narrow = PINCHED_HEIGHT / 2;
  const bend = reach * 0.5;
  const before = pinch - reach;
  const after = pinch + reach;
  return [
    `M${edge(-1, 0)}`,
    `L${edge(-1, before)}`,
    `C${edge(-1, before + bend, half(before) * 0.7)} ${edge(-1, pinch - bend, narrow)} ${edge(-1, pinch, narrow)}`,
    `C${edge(-1, pinch + bend, narrow)} ${edge(-1, after - bend, half(after) * 0.7)} ${edge(-1, after)}`,
    `L${edge(-1, width)}`,
    `L${edge(1, width)}`,
    `L${edge(1, after)}`,
    `C${edge(1, after - bend, half(after) * 0.7)} ${edge(1, pinch + bend, narrow)} ${edge(1, pinch, narrow)}`,
    `C${edge(1, pinch - bend, narrow)} ${edge(1, before + bend, half(before) * 0.7)} ${edge(1, before)}`,
    `L${edge(1, 0)}Z`,
  ].join("");
}

function at(value: number): string {
  return String(Math.round(value * 100) / 100);
}
