import type { TransitionOptions } from "../../document/commands/transitions";

/** Two ways worth seeing beside each other. */
export interface Preset {
  readonly id: string;
  readonly label: string;
  readonly sides: readonly [left: TransitionOptions, right: TransitionOptions];
}

const SPECTRAL: TransitionOptions = { method: "spectral", order: "greedy", alignment: "pca", sharing: 0 };

/** The comparisons that the paper's figures make, on whatever transition is at hand. */
export const PRESETS: readonly Preset[] = [
  {
    id: "figure-3",
    label: "Straight or turning (figure 3)",
    sides: [{ method: "linear" }, { method: "polar", alignment: "pca" }],
  },
  {
    id: "figure-4",
    label: "Without and with alignment (figure 4)",
    sides: [{ ...SPECTRAL, alignment: "none" }, SPECTRAL],
  },
  {
    id: "figure-5",
    label: "Polar or spectral (figure 5)",
    sides: [{ method: "polar", alignment: "pca" }, SPECTRAL],
  },
  {
    id: "figure-8",
    label: "Modes by eigenvalue or by likeness (figure 8)",
    sides: [{ ...SPECTRAL, order: "eigenvalue" }, SPECTRAL],
  },
  {
    id: "figure-9",
    label: "Straight or spectral (figure 9)",
    sides: [{ method: "linear" }, SPECTRAL],
  },
];
