import { AGENT_COLORS } from "../document/palette";
import { withContrast } from "./contrast";

/** Contrast with the sheet that every agent's color has. */
const AGENT_CONTRAST = 3;

/** The look's values as the canvas needs them, read once a theme change. Colors are CSS. */
export interface Palette {
  readonly isDark: boolean;
  readonly ground: string;
  readonly sheet: string;
  readonly raised: string;
  readonly ink: string;
  readonly ink2: string;
  readonly ink3: string;
  readonly lineStrong: string;
  readonly you: string;
  readonly onYou: string;
  readonly clash: string;
  readonly onClash: string;
  readonly fieldLine: string;
  readonly fieldLineMinor: string;
  readonly fieldNumber: string;
  /** Opaque; the canvas adds alpha. */
  readonly tie: string;
  readonly trailAlpha: number;
  readonly hullAlpha: number;
  readonly onionAlpha: number;
  /** Font family. */
  readonly sans: string;
  /** How a stored agent color is shown in this theme, `#rrggbb`. */
  shown(stored: string): string;
}

/** Reads the look from custom properties; `read` answers the value of one, e.g. `--sheet`. */
export function readPalette(read: (name: string) => string): Palette {
  const value = (name: string) => read(name).trim();
  const sheet = value("--sheet");
  const known = new Map<string, string>();
  return {
    isDark: value("color-scheme") === "dark",
    ground: value("--ground"),
    sheet,
    raised: value("--raised"),
    ink: value("--ink"),
    ink2: value("--ink-2"),
    ink3: value("--ink-3"),
    lineStrong: value("--line-strong"),
    you: value("--you"),
    onYou: value("--on-you"),
    clash: value("--clash"),
    onClash: sheet,
    fieldLine: value("--field-line"),
    fieldLineMinor: value("--field-line-minor"),
    fieldNumber: value("--field-number"),
    tie: `rgb(${value("--tie").split(/\s+/).join(", ")})`,
    trailAlpha: Number.parseFloat(value("--trail-alpha")),
    hullAlpha: Number.parseFloat(value("--hull-alpha")),
    onionAlpha: Number.parseFloat(value("--onion-alpha")),
    sans: value("--sans"),
    shown(stored) {
      let color = known.get(stored);
      if (color === undefined) {
        const hex = stored.toLowerCase();
        const place = (AGENT_COLORS as readonly string[]).indexOf(hex);
        color = place < 0 ? withContrast(hex, sheet, AGENT_CONTRAST) : value(`--agent-${place + 1}`);
        known.set(stored, color);
      }
      return color;
    },
  };
}

/** The look as `element` inherits it now. */
export function paletteOf(element: Element): Palette {
  const style = getComputedStyle(element);
  return readPalette((name) => style.getPropertyValue(name));
}
