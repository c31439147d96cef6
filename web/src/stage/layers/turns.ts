import type { Camera } from "../camera";
import { createContext } from "../canvases";
import type { Frame } from "../frame";

/** A picture that can be drawn now and laid down again later. */
export type Part = (context: CanvasRenderingContext2D) => void;

/** Draws several parts one above the other: all of them, or one each frame and the others as they were. */
export interface Turns {
  draw(context: CanvasRenderingContext2D, frame: Frame, isSparing: boolean): void;
}

/** Turns of `parts`, back to front. Owns one canvas a part while it spares. */
export function createTurns(parts: readonly Part[]): Turns {
  let kept: readonly CanvasRenderingContext2D[] = [];
  let camera: Camera | null = null;
  let turn = 0;

  function keep(context: CanvasRenderingContext2D, frame: Frame): void {
    const { width, height } = context.canvas;
    kept = parts.map(() => {
      const own = createContext(width, height);
      own.setTransform(frame.density, 0, 0, frame.density, 0, 0);
      return own;
    });
    camera = null;
  }

  return {
    draw(context, frame, isSparing) {
      if (!isSparing) {
        kept = [];
        for (const part of parts) part(context);
        return;
      }
      const canvas = kept[0]?.canvas;
      if (canvas?.width !== context.canvas.width || canvas.height !== context.canvas.height) keep(context, frame);
      // Seen from elsewhere, no part is where it was.
      const isElsewhere = camera !== frame.camera;
      camera = frame.camera;
      turn = (turn + 1) % parts.length;
      for (let index = 0; index < parts.length; index += 1) {
        const own = kept[index];
        if (!own) continue;
        if (isElsewhere || index === turn) {
          own.clearRect(0, 0, frame.size.width, frame.size.height);
          parts[index]?.(own);
        }
        context.drawImage(own.canvas, 0, 0, frame.size.width, frame.size.height);
      }
    },
  };
}
