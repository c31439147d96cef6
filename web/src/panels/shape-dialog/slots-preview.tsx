import { useLayoutEffect, useRef } from "preact/hooks";
import { fitCanvas } from "../fit-canvas";
import { useIsDark } from "../use-is-dark";

/** The side of the preview, CSS pixels. */
const SIDE = 232;
/** Pixels around the shape. */
const MARGIN = 14;

/** The places as the stage will show them, as large as the preview allows. */
export function SlotsPreview({ xy, isOld }: { xy: Float64Array | null; isOld: boolean }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const isDark = useIsDark();
  useLayoutEffect(() => {
    const element = canvas.current;
    const context = element && fitCanvas(element, { width: SIDE, height: SIDE });
    if (!element || !context) return;
    context.clearRect(0, 0, SIDE, SIDE);
    context.fillStyle = getComputedStyle(element).color;
    if (xy) drawPlaces(context, xy);
  }, [xy, isDark]);
  const count = (xy?.length ?? 0) / 2;
  return (
    <canvas
      ref={canvas}
      class="slots-preview"
      role="img"
      aria-label={count === 0 ? "No places yet" : `${count} places`}
      data-old={isOld ? "" : undefined}
    />
  );
}

function drawPlaces(context: CanvasRenderingContext2D, xy: Float64Array): void {
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let k = 0; k + 1 < xy.length; k += 2) {
    const [x, y] = [xy[k] ?? 0, xy[k + 1] ?? 0];
    [left, right] = [Math.min(left, x), Math.max(right, x)];
    [low, high] = [Math.min(low, y), Math.max(high, y)];
  }
  const scale = (SIDE - 2 * MARGIN) / Math.max(right - left, high - low, 1e-9);
  const share = ((right - left) * (high - low) * scale * scale) / (xy.length / 2);
  const radius = Math.min(7, Math.max(0.8, 0.2 * Math.sqrt(share)));
  context.beginPath();
  for (let k = 0; k + 1 < xy.length; k += 2) {
    const x = SIDE / 2 + ((xy[k] ?? 0) - (left + right) / 2) * scale;
    const y = SIDE / 2 - ((xy[k + 1] ?? 0) - (low + high) / 2) * scale;
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
  }
  context.fill();
}
