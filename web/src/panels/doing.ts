import type { ReadonlySignal, Signal } from "@preact/signals";
import type { Formation } from "../document/formation";
import type { Scene } from "../document/scene";
import type { Selection } from "../document/selection";
import type { Command, DocumentStore } from "../document/store";
import type { Engine, Planner } from "../engine/api";
import type { Playback } from "../playback/playback";
import type { View } from "../stage/view";
import type { Toolbox } from "../tools/toolbox";
import type { Aside } from "./aside";
import type { Messages } from "./messages";
import type { ActionId } from "./shortcuts";

/** What an action does; its words and keys are in the table of shortcuts. */
export interface Doing {
  /** Absent: always. */
  readonly isEnabled?: ReadonlySignal<boolean>;
  run(): void;
}

/** The doings of some actions: each named one, no other. */
export type Doings<Id extends ActionId> = { readonly [K in Id]: Doing };

/** What actions act through. */
export interface ActionParts {
  readonly document: DocumentStore;
  readonly playback: Playback;
  readonly view: View;
  readonly toolbox: Toolbox;
  readonly messages: Messages;
  readonly aside: Signal<Aside | null>;
  readonly engine: Pick<Engine, "open">;
  readonly planner: Pick<Planner, "segments" | "placesAt">;
  readonly clipboard: Pick<Clipboard, "readText" | "writeText">;
  /** Where everybody is at a time, scene seconds, as the stage shows it. */
  positionsAt(time: number): Formation;
  /** Gives up the gesture under way; whether there was one. */
  cancelGesture(): boolean;
  readonly files: Readonly<
    Record<
      "new" | "open" | "save" | "export" | "share" | "examples" | "help" | "palette" | "compare" | "picture" | "text",
      () => void
    >
  >;
}

/** The scene, the selection and the keyframe that a command is for, at the time it is asked for. */
export interface Here {
  readonly scene: Scene;
  readonly selection: Selection;
  readonly keyframe: number;
}

export function here(document: DocumentStore): Here {
  return {
    scene: document.scene.peek(),
    selection: document.selection.peek(),
    keyframe: document.activeKeyframe.peek(),
  };
}

/** Does a command, and says why when it can do nothing. */
export function performOrSay({ document, messages }: ActionParts, command: Command, whyNot: string): boolean {
  const before = document.scene.peek();
  document.perform(command);
  const isDone = document.scene.peek() !== before;
  if (!isDone) messages.say({ tone: "problem", title: `${command.label}: nothing changed.`, text: whyNot });
  return isDone;
}
