import type { ReadonlySignal } from "@preact/signals";
import type { Scene } from "../document/scene";
import type { Selection } from "../document/selection";
import type { Planning, TieList } from "../engine/api";
import type { Playback } from "../playback/playback";
import type { Toolbox } from "../tools/toolbox";
import type { View } from "./view";

/** What the stage looks at. It changes none of it but the size of the view and, playing, the time. */
export interface StageInputs {
  readonly scene: ReadonlySignal<Scene>;
  /** False while the first scene is on its way: nobody is told to draw on a stage that is about to fill. */
  readonly isSettled: ReadonlySignal<boolean>;
  readonly selection: ReadonlySignal<Selection>;
  readonly segments: ReadonlySignal<readonly Planning[]>;
  readonly ties: ReadonlySignal<readonly (TieList | null)[]>;
  readonly playback: Playback;
  readonly view: View;
  readonly toolbox: Pick<Toolbox, "active" | "overlay" | "cursor">;
}
