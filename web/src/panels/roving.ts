const STEPS: Readonly<Record<string, number>> = { ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1 };

/** Moves the focus among the enabled controls of a toolbar, menu or tab list by arrows, Home and End. */
export function moveFocus(event: KeyboardEvent, controls: string): void {
  const container = event.currentTarget;
  if (!(container instanceof HTMLElement) || event.altKey || event.ctrlKey || event.metaKey) return;
  const stops = [...container.querySelectorAll<HTMLElement>(controls)].filter((stop) => !stop.matches(":disabled"));
  const focused = document.activeElement;
  const here = focused instanceof HTMLElement ? stops.indexOf(focused) : -1;
  const next = nextStop(event.key, here, stops.length);
  if (next === null) return;
  event.preventDefault();
  event.stopPropagation();
  stops[next]?.focus();
}

/** The stop a key leads to, around the ends; null for keys that do not move. */
export function nextStop(key: string, here: number, count: number): number | null {
  if (count === 0) return null;
  if (key === "Home") return 0;
  if (key === "End") return count - 1;
  const step = STEPS[key];
  if (step === undefined) return null;
  return here < 0 ? (step > 0 ? 0 : count - 1) : (here + step + count) % count;
}
