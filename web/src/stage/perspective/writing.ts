import type { Units } from "../../document/scene";
import type { Size } from "../camera";
import { createContext } from "../canvases";
import type { ClashFinder } from "../clashes";
import { drawClashMarks } from "./clash-marks";
import { drawNames, hasNames, type NamesLook } from "./names";

/** What is written over the world in one frame. */
export interface WritingPicture {
  readonly hovered: number | null;
  readonly selected: ReadonlySet<number>;
  /** Meters; 0 marks nobody. */
  readonly minimumDistance: number;
  readonly units: Units;
}

/** Names and marks of clashes, on a sheet laid over what the graphics card draws. */
export interface Writing {
  resize(size: Size, density: number): void;
  draw(look: NamesLook, picture: WritingPicture, clashes: ClashFinder): void;
  dispose(): void;
}

export function createWriting(host: HTMLElement): Writing {
  const context = createContext(1, 1);
  const { canvas } = context;
  canvas.setAttribute("aria-hidden", "true");
  host.append(canvas);
  let size: Size = { width: 0, height: 0 };
  return {
    resize(next, density) {
      size = next;
      canvas.width = Math.max(1, Math.round(size.width * density));
      canvas.height = Math.max(1, Math.round(size.height * density));
      context.setTransform(density, 0, 0, density, 0, 0);
    },
    draw(look, { hovered, selected, minimumDistance, units }, clashes) {
      const areNamed = hasNames(hovered, selected);
      // An empty sheet laid over the other would cost every frame.
      canvas.hidden = !areNamed && clashes.count === 0;
      if (canvas.hidden) return;
      context.clearRect(0, 0, size.width, size.height);
      drawClashMarks(context, size, look, clashes, minimumDistance, units);
      if (areNamed) drawNames(context, look, hovered, selected);
    },
    dispose: () => canvas.remove(),
  };
}
