import { updateSegment, updateTrack } from "../edit";
import { mainTrack, type Segment } from "../scene";
import type { Command } from "../store";

/** What the person decides about a transition. */
export type TransitionOptions = Partial<Omit<Segment, "kind" | "chosen" | "path" | "assignment">>;

/** Change how one formation becomes the next. Whatever auto took before is forgotten. */
export function setTransition(index: number, options: TransitionOptions): Command {
  return { label: labelOf(options), apply: (scene) => updateSegment(scene, index, (was) => withOptions(was, options)) };
}

/** The same for every transition of the show. */
export function setAllTransitions(options: TransitionOptions): Command {
  return {
    label: `${labelOf(options)} everywhere`,
    apply: (scene) =>
      updateTrack(scene, (track) => {
        const segments = track.segments.map((segment) => withOptions(segment, options));
        const isSame = segments.every((segment, i) => segment === mainTrack(scene).segments[i]);
        return isSame ? track : { ...track, segments };
      }),
  };
}

function withOptions(segment: Segment, options: TransitionOptions): Segment {
  if (options.sharing !== undefined && !(options.sharing >= 0 && options.sharing <= 1)) return segment;
  const isSame = Object.entries(options).every(([key, value]) => segment[key as keyof Segment] === value);
  return isSame && segment.chosen === null ? segment : { ...segment, ...options, chosen: null };
}

function labelOf(options: TransitionOptions): string {
  const words: Record<keyof TransitionOptions, string> = {
    method: "Change method",
    order: "Change order",
    alignment: "Change alignment",
    sharing: "Change sharing",
    keepSize: "Change keep size",
    timing: "Change timing",
    avoidance: "Change avoidance",
    hierarchy: "Change hierarchy",
    nodes: "Change group methods",
    crowd: "Change crowd",
  };
  const keys = Object.keys(options) as (keyof TransitionOptions)[];
  const [only] = keys;
  return keys.length === 1 && only ? words[only] : "Change transition";
}
