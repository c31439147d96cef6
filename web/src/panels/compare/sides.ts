import type { TransitionOptions } from "../../document/commands/transitions";
import { mainTrack, type Scene, type Segment } from "../../document/scene";

/** One of two ways to be compared: a transition of the scene, and what it is tried with. */
export interface Side {
  readonly segment: number;
  readonly spec: Segment;
}

/** A transition by itself, moved in time so that both sides leave at the same moment. */
export interface Trial {
  readonly scene: Scene;
  /** Which of the trial's transitions it is. */
  readonly segment: number;
}

/** Formations before and after the transition that have a say in it where motion runs through the keyframes. */
const REACH = 2;

/** When a transition leaves and arrives, scene seconds. */
export function spanOf(scene: Scene, segment: number): { readonly start: number; readonly end: number } {
  const { keyframes } = mainTrack(scene);
  const [from, to] = [keyframes[segment], keyframes[segment + 1]];
  const start = from ? from.time + from.hold : 0;
  return { start, end: Math.max(start, to?.time ?? start) };
}

/** The moment that both sides leave at, scene seconds of their trials: late enough for whatever comes before. */
export function commonStart(scene: Scene, segments: readonly number[]): number {
  return Math.max(
    ...segments.map((segment) => spanOf(scene, segment).start - timeOf(scene, windowOf(scene, segment)[0])),
  );
}

/** What is planned for one side: its transition with its formations and as many neighbors as have a say in it. */
export function trialOf(scene: Scene, { segment, spec }: Side, start: number): Trial {
  const track = mainTrack(scene);
  const [first, last] = windowOf(scene, segment);
  const shift = start - spanOf(scene, segment).start;
  const keyframes = track.keyframes
    .slice(first, last + 1)
    .map((keyframe) => ({ ...keyframe, time: keyframe.time + shift }));
  const segments = track.segments.slice(first, last).with(segment - first, spec);
  return { scene: { ...scene, tracks: [{ ...track, keyframes, segments }] }, segment: segment - first };
}

/** A changed option is the person's own choice: what auto took before is forgotten. */
export function withOptions(side: Side, options: TransitionOptions): Side {
  return { ...side, spec: { ...side.spec, ...options, chosen: null } };
}

/** Everything a side says of its transition, to be taken over into the scene. */
export function optionsOf({ spec }: Side): TransitionOptions {
  const { kind: _, chosen: __, ...options } = spec;
  return options;
}

/** Whether the scene's own transition is made in just this way. */
export function isInUse(scene: Scene, side: Side): boolean {
  const own = mainTrack(scene).segments[side.segment];
  return (
    own !== undefined && Object.entries(optionsOf(side)).every(([key, value]) => own[key as keyof Segment] === value)
  );
}

function windowOf(scene: Scene, segment: number): [first: number, last: number] {
  const reach = scene.join === "separate" ? 0 : REACH;
  return [Math.max(0, segment - reach), Math.min(mainTrack(scene).keyframes.length - 1, segment + 1 + reach)];
}

function timeOf(scene: Scene, keyframe: number): number {
  return mainTrack(scene).keyframes[keyframe]?.time ?? 0;
}
