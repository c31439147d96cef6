import { chooseAgain, updateTrack } from "../edit";
import { brokenLimit, withinLimits } from "../limits";
import { tidyTime } from "../round-time";
import type { Run } from "../run";
import { type Keyframe, mainTrack, type Scene, type Segment, type Track } from "../scene";
import type { Command } from "../store";
import { liesBetween } from "../stretches";

const CUTS_A_TRANSITION = "It begins or ends at an in-between, in the middle of a transition: take the whole of it.";

/**
 * A run of keyframes backward in the same time: formations, holds and transitions in the opposite order, as far apart
 * as they were.
 */
export function reverseRun(run: Run): Command {
  return {
    label: "Reverse run",
    apply: (scene) =>
      updateTrack(scene, (track) => {
        const within = keyframesOf(track, run);
        const [head, tail] = [within[0], within.at(-1)];
        if (!head || !tail || within.length < 2 || !isOfTransitions(track, run)) return track;
        const sum = head.time + tail.time + tail.hold;
        const reversed = within.map((was) => ({ ...was, time: tidyTime(sum - was.time - was.hold) })).reverse();
        const transitions = track.segments
          .slice(run.first, run.last)
          .reverse()
          .map((was) => (was.path ? { ...was, path: was.path.toReversed() } : was));
        return {
          ...track,
          keyframes: track.keyframes.toSpliced(run.first, reversed.length, ...reversed),
          segments: chooseAgain(
            track.segments.toSpliced(run.first, transitions.length, ...transitions),
            around(run.first, run.last),
          ),
        };
      }),
  };
}

/**
 * The same run once more, right after itself; what comes later moves on.
 *
 * A run that ends in the formation it began with goes round: its first keyframe is not doubled. Otherwise the way back
 * takes as long as its last transition.
 */
export function repeatRun(run: Run): Command {
  return { label: "Repeat run", apply: (scene) => withinLimits(scene, repeated(scene, run)) };
}

/** Why a run cannot be repeated, in a sentence; null when it can. */
export function whyNotRepeated(scene: Scene, run: Run): string | null {
  return whyNotReversed(scene, run) ?? brokenLimit(repeated(scene, run));
}

/** The same for reversing it. */
export function whyNotReversed(scene: Scene, run: Run): string | null {
  return isOfTransitions(mainTrack(scene), run) ? null : CUTS_A_TRANSITION;
}

/** Where a repeated run's copy is. */
export function copyOfRun(scene: Scene, run: Run): Run {
  const length = run.last - run.first + (goesRound(mainTrack(scene), run) ? 0 : 1);
  return { first: run.last + 1, last: run.last + length };
}

function repeated(scene: Scene, run: Run): Scene {
  return updateTrack(scene, (track) => {
    const within = keyframesOf(track, run);
    const [head, tail] = [within[0], within.at(-1)];
    const beforeTail = within.at(-2);
    if (!head || !tail || !beforeTail || !isOfTransitions(track, run)) return track;
    const isRound = goesRound(track, run);
    const end = tail.time + tail.hold;
    const wayBack = tail.time - (beforeTail.time + beforeTail.hold);
    // Round, the copy leaves from the last keyframe as the run left from its first.
    const by = isRound ? end - (head.time + head.hold) : end + wayBack - head.time;
    const copies = within.slice(isRound ? 1 : 0).map((was) => moved(was, by));
    const segments = track.segments.slice(run.first, run.last);
    const way: readonly Segment[] = isRound
      ? []
      : segments.slice(-1).map((last) => ({ ...last, chosen: null, path: null }));
    return {
      ...track,
      keyframes: [
        ...track.keyframes.slice(0, run.last + 1),
        ...copies,
        ...track.keyframes.slice(run.last + 1).map((later) => moved(later, by)),
      ],
      segments: track.segments.toSpliced(run.last, 0, ...way, ...segments),
    };
  });
}

/** Whether a run begins and ends where transitions do. */
function isOfTransitions(track: Track, { first, last }: Run): boolean {
  return !liesBetween(track, first) && !liesBetween(track, last);
}

function keyframesOf(track: Track, { first, last }: Run): readonly Keyframe[] {
  return track.keyframes.slice(first, last + 1);
}

function goesRound(track: Track, { first, last }: Run): boolean {
  const [start, end] = [track.keyframes[first]?.positions, track.keyframes[last]?.positions];
  if (last - first < 2 || !start || !end) return false;
  return start === end || (start.xy.length === end.xy.length && start.xy.every((value, i) => value === end.xy[i]));
}

function moved(keyframe: Keyframe, by: number): Keyframe {
  return { ...keyframe, time: tidyTime(keyframe.time + by) };
}

/** The transitions of a run, into it and out of it. */
function around(first: number, last: number): number[] {
  return Array.from({ length: last - first + 2 }, (_, i) => first - 1 + i);
}
