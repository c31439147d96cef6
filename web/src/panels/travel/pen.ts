import { signal } from "@preact/signals";

/** The transition whose path is being drawn; null when none is. */
export const penOn = signal<number | null>(null);
