import type { ReadonlySignal } from "@preact/signals";

/** Where an action is listed in the help and the palette. */
export type ActionSection =
  | "File"
  | "Edit"
  | "Tools"
  | "View"
  | "Play"
  | "Keyframes"
  | "Transition"
  | "Groups"
  | "Help";

/** One thing a person can do, by button, key or palette. */
export interface Action {
  /** Stable, e.g. `undo`. */
  readonly id: string;
  readonly label: string;
  readonly section: ActionSection;
  /** As in the shortcut table, e.g. `Ctrl+Z` (Ctrl means Cmd on a Mac); the first is shown. */
  readonly keys: readonly string[];
  /** Absent: always. */
  readonly isEnabled?: ReadonlySignal<boolean>;
  run(): void;
}

/** Every action, in the order of the help. */
export interface Actions {
  readonly all: readonly Action[];
  get(id: string): Action;
}
