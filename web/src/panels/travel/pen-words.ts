import { computed, signal } from "@preact/signals";

/** Whether the last stroke was a click, or hardly more. */
export const isTooShort = signal(false);

/** What to do with the pen, over the stage and in the inspector. */
export const penWords = computed(() =>
  isTooShort.value
    ? "Too short for a path: press, and pull to where they go."
    : "Draw from where they stand to where they go.",
);
