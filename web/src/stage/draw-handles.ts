import type { Selection } from "../document/selection";
import type { TieList } from "../engine/api";
import type { Overlay } from "../tools/toolbox";
import type { Frame } from "./frame";
import { handlePlace, type SelectionBox, selectionBounds, selectionBox } from "./handles";
import { drawNamePill, needsPill } from "./layers/name-pill";
import { drawOverlay } from "./layers/overlay";
import { drawReadout } from "./layers/readout";
import { drawSelectedTie } from "./layers/selected-tie";
import { drawBox, drawHoverRing, drawRings } from "./layers/selection";
import type { Lifts } from "./lifts";
import { FEW_SELECTED } from "./subject";
import { tieStrength, tieWidth } from "./ties";

/** What the handles canvas shows; one is kept and refilled. */
export interface HandlesPicture {
  selection: Selection;
  selected: ReadonlySet<number>;
  hovered: number | null;
  overlay: Overlay;
  areNamesShown: boolean;
  /** A box with handles about the selection, rather than rings only. */
  hasBox: boolean;
  lifts: Lifts;
  /** Of the keyframe at hand, for the weight of a selected tie. */
  ties: TieList | null;
}

/** Draws what the person does: selection, handles and the tool at work. */
export function drawHandles(context: CanvasRenderingContext2D, frame: Frame, picture: HandlesPicture): void {
  const { selection, selected, hovered, overlay } = picture;
  context.clearRect(0, 0, frame.size.width, frame.size.height);
  if (selection.kind === "tie") {
    const { a, b } = selection;
    drawSelectedTie(context, frame, a, b, tieWidth(tieStrength(factorOf(picture.ties, a, b))));
  }
  if (selected.size > 0) drawRings(context, frame, selected);
  if (hovered !== null && hovered < frame.agentCount && !selected.has(hovered)) drawHoverRing(context, frame, hovered);
  if (picture.hasBox) {
    const bounds = selectionBounds(frame.places, selected);
    if (bounds) drawBoxed(context, frame, picture, selectionBox(bounds, frame.camera, frame.radius));
  }
  drawNamePills(context, frame, picture);
  drawOverlay(context, frame, overlay);
}

function drawNamePills(context: CanvasRenderingContext2D, frame: Frame, picture: HandlesPicture): void {
  const { selected, hovered, areNamesShown, overlay } = picture;
  if (overlay.kind !== "none") return;
  if (selected.size <= FEW_SELECTED && areNamesShown) {
    for (const agent of selected) {
      if (agent !== hovered && needsPill(frame, agent, areNamesShown)) drawNamePill(context, frame, agent);
    }
  }
  if (hovered !== null && hovered < frame.agentCount && needsPill(frame, hovered, areNamesShown)) {
    drawNamePill(context, frame, hovered);
  }
}

/** The box, and how high its agents are while the handle to lift is in hand. */
function drawBoxed(
  context: CanvasRenderingContext2D,
  frame: Frame,
  { overlay, lifts }: HandlesPicture,
  box: SelectionBox,
): void {
  const lifted = overlay.kind === "lift" ? overlay.by * frame.camera.scale : 0;
  drawBox(context, frame, box, lifts, lifted);
  if (overlay.kind !== "lift") return;
  const { x, y } = handlePlace(box, "lift");
  drawReadout(context, frame, overlay.words, x, y - lifted - 22);
}

function factorOf(ties: TieList | null, a: number, b: number): number {
  if (!ties) return 1;
  for (let tie = 0; tie < ties.factors.length; tie += 1) {
    const [x, y] = [ties.pairs[2 * tie], ties.pairs[2 * tie + 1]];
    if ((x === a && y === b) || (x === b && y === a)) return ties.factors[tie] ?? 1;
  }
  return 1;
}
