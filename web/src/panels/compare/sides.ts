import { assignPlaces } from "../../document/commands/assign";
import { takePlaces } from "../../document/commands/swap";
import { setTransition, type TransitionOptions } from "../../document/commands/transitions";
import { mainTrack, type Scene, type Segment } from "../../document/scene";
import type { Command } from "../../document/store";
import { endsAround, stretchesOf } from "../../document/stretches";
import type { Counterpart } from "../../engine/api";
import { recipeOf, type Seating } from "./seating";
import { type TieChoice, tiedScene } from "./side-ties";

/** One of the ways to be compared: a transition of the scene, and what it is tried with. */
export interface Side {
  readonly segment: number;
  readonly spec: Segment;
  readonly ties: TieChoice;
  /** Places found for everybody; null: as they are in the scene. */
  readonly seating: Seating | null;
  /** What moves it in place of its method and avoidance; no scene has that. */
  readonly counterpart: Counterpart | null;
}

/** What changes about a side. */
export interface SideChange {
  readonly options?: TransitionOptions;
  readonly ties?: TieChoice;
  readonly seating?: Seating | null;
  readonly counterpart?: Counterpart | null;
}

/** A transition by itself, moved in time so that all sides leave at the same moment. */
export interface Trial {
  readonly scene: Scene;
  /** Which of the trial's transitions it is. */
  readonly segment: number;
}

/** Formations before and after the transition that have a say in it where motion runs through the keyframes. */
const REACH = 2;

/** When a transition leaves and arrives, scene seconds. */
export function spanOf(scene: Scene, segment: number): { readonly start: number; readonly end: number } {
  const track = mainTrack(scene);
  const [from, to] = endsAround(track, segment).map((end) => track.keyframes[end]);
  const start = from ? from.time + from.hold : 0;
  return { start, end: Math.max(start, to?.time ?? start) };
}

/** The moment that all sides leave at, scene seconds of their trials: late enough for whatever comes before. */
export function commonStart(scene: Scene, segments: readonly number[]): number {
  return Math.max(
    ...segments.map((segment) => {
      const whole = withoutBetweens(scene, segment);
      return spanOf(scene, segment).start - timeOf(whole.scene, windowOf(whole)[0]);
    }),
  );
}

/** What is planned for one side: its transition with its formations and as many neighbors as have a say in it. */
export function trialOf(show: Scene, { segment: part, spec, ties, seating }: Side, start: number): Trial {
  const { scene: whole, segment } = withoutBetweens(show, part);
  const scene = tiedScene(seating ? takePlaces(segment + 1, seating.slots).apply(whole) : whole, ties);
  const track = mainTrack(scene);
  const [first, last] = windowOf({ scene, segment });
  const shift = start - spanOf(scene, segment).start;
  const keyframes = track.keyframes
    .slice(first, last + 1)
    .map((keyframe) => ({ ...keyframe, time: keyframe.time + shift }));
  const segments = track.segments.slice(first, last).with(segment - first, spec);
  return { scene: { ...scene, tracks: [{ ...track, keyframes, segments }] }, segment: segment - first };
}

/** A changed option is the person's own choice: what auto took before is forgotten. */
export function changed(side: Side, { options, ...change }: SideChange): Side {
  return { ...side, ...change, spec: options ? { ...side.spec, ...options, chosen: null } : side.spec };
}

/** Takes a side over into the scene, its ties and places too. */
export function takeOver(side: Side): Command {
  const { segment, spec, ties, seating } = side;
  const { label, apply } = setTransition(segment, optionsOf(side));
  const seat = seating && assignPlaces(segment, seating.slots, recipeOf(spec, seating.cost));
  return {
    label,
    apply(scene) {
      const moved = apply(tiedScene(scene, ties));
      return seat ? seat.apply(moved) : moved;
    },
  };
}

/** Everything a side says of its transition. */
function optionsOf({ spec }: Side): TransitionOptions {
  const { kind: _, chosen: __, ...options } = spec;
  return options;
}

/** Whether the scene's own transition is made in just this way. */
export function isInUse(scene: Scene, side: Side): boolean {
  const own = mainTrack(scene).segments[side.segment];
  return (
    own !== undefined &&
    (side.seating?.slots.every((slot, agent) => slot === agent) ?? true) &&
    tiedScene(scene, side.ties) === scene &&
    Object.entries(optionsOf(side)).every(([key, value]) => own[key as keyof Segment] === value)
  );
}

/** The transition that a segment is, or is a part of, as it is without the keyframes that lie in it. */
function withoutBetweens(scene: Scene, segment: number): Trial {
  const track = mainTrack(scene);
  const { anchors, whole } = stretchesOf(track);
  return { scene: { ...scene, tracks: [whole] }, segment: anchors.indexOf(endsAround(track, segment)[0]) };
}

function windowOf({ scene, segment }: Trial): [first: number, last: number] {
  const reach = scene.join === "separate" ? 0 : REACH;
  return [Math.max(0, segment - reach), Math.min(mainTrack(scene).keyframes.length - 1, segment + 1 + reach)];
}

function timeOf(scene: Scene, keyframe: number): number {
  return mainTrack(scene).keyframes[keyframe]?.time ?? 0;
}
