import type { Cast } from "../cast";
import { drawPill } from "../layers/pill";
import type { Palette } from "../palette";
import type { Meetable } from "./finger";
import type { Sight } from "./sight";

/** Seen from the side, more names than this cover one another. */
const MOST_NAMES = 12;

/** Pixels between a head and its name. */
const GAP = 14;

/** What names are written with. */
export interface NamesLook {
  readonly cast: Cast;
  readonly palette: Palette;
  readonly bodies: Meetable;
  readonly sight: Sight;
}

/** Whether anybody's name is shown. */
export function hasNames(hovered: number | null, selected: ReadonlySet<number>): boolean {
  return hovered !== null || (selected.size > 0 && selected.size <= MOST_NAMES);
}

const at = new Float32Array(3);

/** Writes the names of who is hovered or selected over their heads; of many selected, none. */
export function drawNames(
  context: CanvasRenderingContext2D,
  look: NamesLook,
  hovered: number | null,
  selected: ReadonlySet<number>,
): void {
  if (selected.size <= MOST_NAMES) {
    for (const agent of selected) if (agent !== hovered) drawName(context, look, agent);
  }
  if (hovered !== null) drawName(context, look, hovered);
}

function drawName(context: CanvasRenderingContext2D, { cast, palette, bodies, sight }: NamesLook, agent: number): void {
  const { place, height, shares } = bodies;
  const k = 3 * agent;
  const head = (place[k + 2] ?? 0) + height * (shares[agent] ?? 1);
  sight.projectInto(place[k] ?? 0, place[k + 1] ?? 0, head, at, 0);
  if (at[2] === 0 || k >= place.length) return;
  drawPill(context, palette, cast.names[agent] ?? "", {
    x: at[0] ?? 0,
    y: (at[1] ?? 0) - GAP,
    align: "center",
    height: 18,
    fill: palette.raised,
    ink: palette.ink,
    edge: palette.lineStrong,
  });
}
