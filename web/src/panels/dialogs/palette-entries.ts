import { setTransition } from "../../document/commands/transitions";
import { keyframeLabel } from "../../document/queries";
import { type MethodName, mainTrack } from "../../document/scene";
import type { ActionSection } from "../actions";
import type { Studio } from "../studio";
import { METHOD_WORDS } from "../timeline/transition-state";
import { matchLabel, type Part } from "./palette-match";

/** One line of the palette. */
export interface Entry {
  readonly id: string;
  readonly label: string;
  readonly section: ActionSection;
  readonly keys: string | undefined;
  run(): void;
}

export interface Found extends Entry {
  readonly parts: readonly Part[];
}

export interface FoundSection {
  readonly section: ActionSection;
  readonly entries: readonly Found[];
}

/** Everything a person can do now: the actions that are enabled, the keyframes to go to, the selected transition's methods. */
export function paletteEntries(studio: Studio): Entry[] {
  const actions = studio.actions.all
    .filter((action) => action.id !== "palette" && (action.isEnabled?.peek() ?? true))
    .map((action): Entry => ({ ...action, keys: action.keys[0], run: () => action.run() }));
  return [...actions, ...methodEntries(studio), ...keyframeEntries(studio)];
}

function methodEntries({ document }: Studio): Entry[] {
  const selection = document.selection.peek();
  if (selection.kind !== "transition") return [];
  const current = mainTrack(document.scene.peek()).segments[selection.index]?.method;
  const methods = Object.entries(METHOD_WORDS) as [MethodName, string][];
  return methods
    .filter(([method]) => method !== current)
    .map(([method, words]) => ({
      id: `method-${method}`,
      label: `Use method: ${words}`,
      section: "Transition",
      keys: undefined,
      run: () => document.perform(setTransition(selection.index, { method })),
    }));
}

function keyframeEntries({ document, playback }: Studio): Entry[] {
  return mainTrack(document.scene.peek()).keyframes.map((keyframe, index) => ({
    id: `go-to-${index}`,
    label: `Go to ${keyframeLabel(document.scene.peek(), index)}`,
    section: "Keyframes",
    keys: undefined,
    run() {
      document.selection.value = { kind: "keyframe", index };
      playback.seek(keyframe.time);
    },
  }));
}

/** What answers the words typed, in sections: the section with the best match first. */
export function findEntries(entries: readonly Entry[], typed: string): FoundSection[] {
  const scored = entries.flatMap((entry) => {
    const match = matchLabel(entry.label, typed);
    return match ? [{ entry: { ...entry, parts: match.parts }, score: match.score }] : [];
  });
  // Stable: equals keep the order of the help.
  scored.sort((a, b) => a.score - b.score);
  const sections = new Map<ActionSection, Found[]>();
  for (const { entry } of scored) sections.set(entry.section, [...(sections.get(entry.section) ?? []), entry]);
  return [...sections].map(([section, found]) => ({ section, entries: found }));
}
