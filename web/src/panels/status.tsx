import type { ComponentChildren } from "preact";

export type Status = "holds" | "tight" | "clash" | "none";

/** Up to this many minimum distances it is tight. */
const TIGHT_UP_TO = 1.1;

/** Whether a transition keeps the minimum distance; `none` when there is no pair or no limit. Meters. */
export function status(clearance: number | null, minimum: number): Status {
  if (clearance === null || minimum <= 0) return "none";
  if (clearance < minimum) return "clash";
  return clearance < minimum * TIGHT_UP_TO ? "tight" : "holds";
}

/** Whole, pinched, or cut by a bar: read without its color. */
const OUTLINES: Record<Status, string> = {
  none: "M0 4.6 14 2.4V7.6L0 5.4z",
  holds: "M0 4.7 14 2.2V7.8L0 5.3z",
  tight:
    "M0 4.5C2.6 4.4 3.4 3.5 5 3.5 6.4 3.5 6.7 4.7 7.6 4.7 8.6 4.7 9 2 14 1.9V8.1C9 8 8.6 5.3 7.6 5.3 6.7 5.3 6.4 6.5 5 6.5 3.4 6.5 2.6 5.6 0 5.5z",
  clash: "M0 4.5 4.7 3.6V6.4L0 5.5zM6.3.3H7.8V9.7H6.3zM9.3 2.6 14 1.8V8.2L9.3 7.4z",
};

/** The shape of a status; the words or number beside it say the same. */
export function StatusWedge({ status: shown }: { status: Status }) {
  return (
    <svg class={`wedge ${shown}`} viewBox="0 0 14 10" aria-hidden="true">
      <path d={OUTLINES[shown]} />
    </svg>
  );
}

/** A status in a pill with its number or words. */
export function StatusPill({ status: shown, children }: { status: Status; children: ComponentChildren }) {
  return (
    <span class={`status-pill ${shown}`}>
      <StatusWedge status={shown} />
      {children}
      <span class="unseen">{WORDS[shown]}</span>
    </span>
  );
}

const WORDS: Record<Status, string> = {
  none: "",
  holds: ", the minimum distance holds",
  tight: ", tight",
  clash: ", nearer than the minimum distance",
};
