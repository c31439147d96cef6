import type { Frame } from "../frame";

/** A picture that can be drawn now and laid down again later. */
export type Part = (context: CanvasRenderingContext2D) => void;

/** Draws several parts one above the other: all of them, or one each frame and the others as they were. */
export interface Turns {
  draw(context: CanvasRenderingContext2D, frame: Frame, parts: readonly Part[], isSparing: boolean): void;
}

/** Owns one canvas a part once it spares. */
export function createTurns(): Turns {
  let kept: { readonly context: CanvasRenderingContext2D; isDrawn: boolean }[] = [];
  let turn = 0;

  function fits(frame: Frame, count: number): boolean {
    const canvas = kept[0]?.context.canvas;
    const { width, height } = sizeOf(frame);
    return kept.length === count && canvas?.width === width && canvas.height === height;
  }

  return {
    draw(context, frame, parts, isSparing) {
      if (!isSparing) {
        kept = [];
        for (const part of parts) part(context);
        return;
      }
      if (!fits(frame, parts.length)) kept = parts.map(() => ({ context: contextFor(frame), isDrawn: false }));
      turn = (turn + 1) % parts.length;
      parts.forEach((part, index) => {
        const own = kept[index];
        if (!own) return;
        if (index === turn || !own.isDrawn) {
          own.context.clearRect(0, 0, frame.size.width, frame.size.height);
          part(own.context);
          own.isDrawn = true;
        }
        context.drawImage(own.context.canvas, 0, 0, frame.size.width, frame.size.height);
      });
    },
  };
}

function sizeOf({ size, density }: Frame): { width: number; height: number } {
  return {
    width: Math.max(1, Math.round(size.width * density)),
    height: Math.max(1, Math.round(size.height * density)),
  };
}

function contextFor(frame: Frame): CanvasRenderingContext2D {
  const canvas = document.createElement("canvas");
  const { width, height } = sizeOf(frame);
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d");
  if (!context) throw new Error("this browser draws no 2D canvas");
  context.setTransform(frame.density, 0, 0, frame.density, 0, 0);
  return context;
}
