import { effect, useComputed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { fitCanvas } from "../fit-canvas";
import { useStudio } from "../studio";
import { useAgentColors, usePalette } from "../timeline/use-paint";
import { drawMode, sketchOf } from "./draw-modes";
import { picture } from "./picture";

/** The mode looked at, over the stage; the panel says the same in words. */
export function ModesOverlay() {
  const { view } = useStudio();
  const canvas = useRef<HTMLCanvasElement>(null);
  const palette = usePalette();
  const stored = useAgentColors();
  const sketch = useComputed(() => picture.value && sketchOf(picture.value));
  useEffect(
    () =>
      effect(() => {
        const [camera, size, shown] = [view.camera.value, view.size.value, sketch.value];
        const colors = shown?.picture.agents.map((agent) => palette.shown(stored.value[agent] ?? "")) ?? [];
        const context = canvas.current && fitCanvas(canvas.current, size);
        if (!context) return;
        if (shown) drawMode(context, shown, { camera, size, palette, colors });
        else context.clearRect(0, 0, size.width, size.height);
      }),
    [view, palette, stored, sketch],
  );
  return (
    <div aria-hidden="true">
      <canvas ref={canvas} class="stage-canvas" />
    </div>
  );
}
