/** What a key on a keyframe of the list can bring about. */
export interface KeyframeHands {
  readonly count: number;
  choose(index: number): void;
  /** Draws the selected run to `index`. */
  extend(index: number): void;
  reorder(from: number, to: number): void;
  remove(index: number): void;
  play(): void;
  /** Gives up the drag under way; whether there was one. */
  cancelDrag(): boolean;
}

/** Does what a key means on keyframe `index`; whether it means anything. */
export function pressKey(event: KeyboardEvent, index: number, hands: KeyframeHands): boolean {
  const { key } = event;
  if (event.ctrlKey || event.metaKey) return false;
  if (key === "Escape") return hands.cancelDrag();
  if (key === "Enter") hands.choose(index);
  else if (key === " ") hands.play();
  else if (key === "Delete" || key === "Backspace") hands.remove(index);
  else return walk(event, index, hands);
  return true;
}

/** Arrows, Home and End walk; with Shift they draw a run, with Alt they bring the formation along. */
function walk(event: KeyboardEvent, index: number, hands: KeyframeHands): boolean {
  const to = destination(event.key, index, hands.count - 1);
  if (to === null) return false;
  const within = Math.max(0, Math.min(hands.count - 1, to));
  if (event.altKey) {
    if (!event.key.startsWith("Arrow")) return false;
    if (within === to) hands.reorder(index, to);
  } else if (event.shiftKey) hands.extend(within);
  else hands.choose(within);
  return true;
}

function destination(key: string, index: number, last: number): number | null {
  switch (key) {
    case "ArrowLeft":
      return index - 1;
    case "ArrowRight":
      return index + 1;
    case "Home":
      return 0;
    case "End":
      return last;
    default:
      return null;
  }
}
