import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { formatCount } from "../../document/units";
import { usePalette } from "../timeline/use-paint";
import { numbersOf } from "./example-numbers";
import { focusLate } from "./frame";
import { drawPreview } from "./preview-drawing";
import type { ExampleCard, Preview } from "./services";
import { usePreview } from "./use-preview";

/** Where a card that does not play stands: late enough to show the way, early enough to show the motion. */
const RESTING_PLACE = 0.75;
/** Seconds a playing card stands at its end before it starts over. */
const PAUSE_AT_END = 0.8;
/** A long transition plays faster, so that nobody waits for the point of it. */
const LONGEST_LOOP = 5;

export interface ExampleTileProps {
  readonly example: ExampleCard;
  loadPreview(id: string): Promise<Preview>;
  /** The focus starts here. */
  readonly isFirst: boolean;
  onOpen(): void;
}

/** A card of the gallery; it plays while it has the focus or the pointer. */
export function ExampleTile({ example, loadPreview, isFirst, onOpen }: ExampleTileProps) {
  const button = useRef<HTMLButtonElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const bar = useRef<HTMLElement>(null);
  const palette = usePalette();
  const answer = usePreview(canvas, () => loadPreview(example.id));
  const preview = answer.kind === "here" ? answer.value : null;
  const [isPointed, setPointed] = useState(false);
  const [isFocused, setFocused] = useState(false);
  const isPlaying = (isPointed || isFocused) && preview !== null && !prefersStill();

  useLayoutEffect(() => {
    if (isFirst) focusLate(button.current);
  }, [isFirst]);

  useLayoutEffect(() => {
    if (canvas.current && preview) drawPreview(canvas.current, preview, RESTING_PLACE, palette);
  }, [preview, palette]);

  useEffect(() => {
    if (!isPlaying || !preview) return;
    const length = Math.min(preview.duration, LONGEST_LOOP);
    let start = performance.now() - RESTING_PLACE * length * 1000;
    let frame = 0;
    const draw = (now: number) => {
      const elapsed = (now - start) / 1000;
      if (elapsed > length + PAUSE_AT_END) start = now;
      const t = Math.min(1, Math.max(0, elapsed / length));
      if (canvas.current) drawPreview(canvas.current, preview, t, palette);
      if (bar.current) bar.current.style.transform = `scaleX(${t})`;
      frame = requestAnimationFrame(draw);
    };
    frame = requestAnimationFrame(draw);
    return () => {
      cancelAnimationFrame(frame);
      if (canvas.current) drawPreview(canvas.current, preview, RESTING_PLACE, palette);
    };
  }, [isPlaying, preview, palette]);

  return (
    <button
      ref={button}
      type="button"
      class="example"
      onClick={onOpen}
      onPointerEnter={(event) => setPointed(event.pointerType === "mouse")}
      onPointerLeave={() => setPointed(false)}
      onFocus={() => setFocused(true)}
      onBlur={() => setFocused(false)}
    >
      <span class="example-picture">
        <canvas ref={canvas} />
        {answer.kind === "refused" && <small class="example-problem">{answer.problem.what}</small>}
        {isPlaying && (
          <i class="example-progress">
            <i ref={bar} />
          </i>
        )}
      </span>
      <span class="example-words">
        <b>{example.title}</b>
        <small class="number">
          {formatCount(example.agentCount)} agents{example.keyframeCount > 2 && `, ${example.keyframeCount} keyframes`}
        </small>
        <span>{example.description}</span>
        <small class="example-numbers number">{preview && numbersOf(preview, example.view)}</small>
      </span>
    </button>
  );
}

function prefersStill(): boolean {
  return matchMedia("(prefers-reduced-motion: reduce)").matches;
}
