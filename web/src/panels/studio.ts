import type { Signal } from "@preact/signals";
import { createContext } from "preact";
import { useContext } from "preact/hooks";
import type { DocumentStore } from "../document/store";
import type { Engine, Planner } from "../engine/api";
import type { Playback } from "../playback/playback";
import type { View } from "../stage/view";
import type { Toolbox } from "../tools/toolbox";
import type { Actions } from "./actions";
import type { Aside } from "./aside";
import type { Messages } from "./messages";
import type { Seen } from "./seen";

/** What the panels act through. Wired in main.ts; holds no logic of its own. */
export interface Studio {
  readonly document: DocumentStore;
  /** As the stage shows it: from above or from the front. */
  readonly seen: Seen;
  readonly playback: Playback;
  readonly view: View;
  readonly planner: Planner;
  readonly engine: Engine;
  readonly toolbox: Toolbox;
  readonly actions: Actions;
  readonly messages: Messages;
  readonly aside: Signal<Aside | null>;
}

export const StudioContext = createContext<Studio | null>(null);

export function useStudio(): Studio {
  const studio = useContext(StudioContext);
  if (!studio) throw new Error("panels live inside a StudioContext");
  return studio;
}
