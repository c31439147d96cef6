import type { Size } from "../camera";
import { drawPill } from "../layers/pill";
import type { Palette } from "../palette";
import { FEW_SELECTED } from "../subject";
import type { Meetable } from "./finger";
import type { Sight } from "./sight";

/** Pixels between a head and its name. */
const GAP = 14;

/** What names are written with. */
export interface NamesLook {
  readonly names: readonly string[];
  readonly palette: Palette;
  readonly bodies: Meetable;
  readonly sight: Sight;
}

const at = new Float32Array(3);

/** Writes the names of who is hovered or selected over their heads; of many selected, none. */
export function drawNames(
  context: CanvasRenderingContext2D,
  size: Size,
  look: NamesLook,
  hovered: number | null,
  selected: ReadonlySet<number>,
): void {
  const areFew = selected.size <= FEW_SELECTED;
  const isEmpty = hovered === null && (selected.size === 0 || !areFew);
  // An empty sheet laid over the other would cost every frame.
  context.canvas.hidden = isEmpty;
  if (isEmpty) return;
  context.clearRect(0, 0, size.width, size.height);
  if (areFew) for (const agent of selected) if (agent !== hovered) drawName(context, look, agent);
  if (hovered !== null) drawName(context, look, hovered);
}

function drawName(
  context: CanvasRenderingContext2D,
  { names, palette, bodies, sight }: NamesLook,
  agent: number,
): void {
  const { place, height } = bodies;
  const k = 3 * agent;
  sight.projectInto(place[k] ?? 0, place[k + 1] ?? 0, (place[k + 2] ?? 0) + height, at, 0);
  const [x = 0, y = 0, depth = 0] = at;
  if (depth === 0 || k >= place.length) return;
  drawPill(context, palette, names[agent] ?? "", {
    x,
    y: y - GAP,
    align: "center",
    height: 18,
    fill: palette.raised,
    ink: palette.ink,
    edge: palette.lineStrong,
  });
}
