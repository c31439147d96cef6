import type { Palette } from "../palette";

/** A canvas font of the page's face. */
export function font(palette: Palette, pixels: number, weight: 400 | 500 | 600 = 600): string {
  return `${weight} ${pixels}px ${palette.sans}`;
}
