import { useRef } from "preact/hooks";
import type { Point } from "../../document/formation";

/** A pull under way. */
export interface Pull {
  /** How far from where it began, meters. */
  to(by: Point): void;
  commit(): void;
  cancel(): void;
}

interface Props {
  readonly number: number;
  /** CSS pixels on the stage. */
  readonly at: { readonly x: number; readonly y: number };
  /** Pixels a meter. */
  readonly scale: number;
  readonly steps: { readonly near: number; readonly far: number };
  begin(): Pull;
  nudge(by: Point): void;
  remove(): void;
}

const WAYS: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** A point of a path, pulled by the pointer, moved by arrow keys, taken out by Delete. */
export function PathPoint({ number, at, scale, steps, begin, nudge, remove }: Props) {
  const pull = useRef<{ readonly pull: Pull; readonly x: number; readonly y: number } | null>(null);

  function end(isKept: boolean): void {
    const now = pull.current;
    pull.current = null;
    if (isKept) now?.pull.commit();
    else now?.pull.cancel();
  }

  function onKeyDown(event: KeyboardEvent): void {
    const way = WAYS[event.key];
    if (event.key === "Escape" && pull.current) end(false);
    else if (event.key === "Delete" || event.key === "Backspace") remove();
    else if (way && !event.ctrlKey && !event.metaKey && !event.altKey) {
      const step = event.shiftKey ? steps.far : steps.near;
      nudge([way[0] * step, way[1] * step]);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  return (
    <button
      type="button"
      class="travel-point"
      aria-label={`Point ${number} of the path`}
      style={{ left: `${at.x}px`, top: `${at.y}px` }}
      onKeyDown={onKeyDown}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        pull.current = { pull: begin(), x: event.clientX, y: event.clientY };
      }}
      onPointerMove={({ clientX, clientY }) => {
        const now = pull.current;
        if (now) now.pull.to([(clientX - now.x) / scale, (now.y - clientY) / scale]);
      }}
      onPointerUp={() => end(true)}
      onPointerCancel={() => end(false)}
    />
  );
}
