import type { Steering } from "./steering";

/** Radians and pixels a press of an arrow. */
const TURN_STEP = Math.PI / 24;
const SLIDE_STEP = 40;
const ZOOM_STEP = 1.25;

/** Where the eye goes: around to the right, and up. */
const WAYS: Readonly<Record<string, readonly [right: number, up: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** Arrows turn, with Shift they slide, + and − zoom; the element has the focus. Answers how to stop. */
export function attachKeys(element: HTMLElement, steering: Steering): () => void {
  function onKeyDown(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const middle = { x: element.clientWidth / 2, y: element.clientHeight / 2 };
    const way = WAYS[event.key];
    if (way && event.shiftKey) {
      steering.slide(middle, { x: middle.x - way[0] * SLIDE_STEP, y: middle.y + way[1] * SLIDE_STEP });
    } else if (way) steering.turn(way[0] * TURN_STEP, way[1] * TURN_STEP);
    else if (event.key === "+" || event.key === "=") steering.zoom(ZOOM_STEP, middle);
    else if (event.key === "-") steering.zoom(1 / ZOOM_STEP, middle);
    else return;
    event.preventDefault();
  }
  element.addEventListener("keydown", onKeyDown);
  return () => element.removeEventListener("keydown", onKeyDown);
}
