import { goneIn } from "../absence";
import { depthBetween, partedAt, reshapeKeyframe } from "../between";
import { DEFAULT_SEGMENT, keyframeAt } from "../defaults";
import { chooseAgain, updateKeyframe, updateTrack } from "../edit";
import type { Formation } from "../formation";
import { clipText, LIMITS, withinLimits } from "../limits";
import { type Choice, type Keyframe, mainTrack, type Scene, type Track } from "../scene";
import { slotAfter } from "../slot";
import type { Command } from "../store";
import { endsAround, liesBetween } from "../stretches";
import { momentAt } from "../timing";

/**
 * A keyframe with the formation seen at `time`; where that is follows from `slotAfter`. While agents move it lies between
 * others: the motion stays as it is seen.
 *
 * @param taken what made the motion there: a transition that is split goes on with it, so that auto does not choose
 *   another motion than the one the formation was seen in
 */
export function addKeyframe(time: number, positions: Formation, taken: Choice | null = null): Command {
  return {
    label: "Add keyframe",
    apply: (scene) => {
      const slot = slotAfter(scene, time);
      const moment = momentAt(scene, time);
      const track = mainTrack(scene);
      const isOnTheWay = moment.kind === "moving" || liesBetween(track, moment.keyframe);
      if (!slot) return scene;
      const between = isOnTheWay ? depthBetween(track, slot.index - 1, slot.index) : 0;
      return insert(scene, slot.index, { ...keyframeAt(slot.time, positions), between }, taken);
    },
  };
}

/** The same formation once more, after the keyframe. */
export function duplicateKeyframe(index: number): Command {
  return {
    label: "Duplicate keyframe",
    apply: (scene) => {
      const keyframe = mainTrack(scene).keyframes[index];
      const slot = keyframe && slotAfter(scene, keyframe.time + keyframe.hold);
      if (!keyframe || !slot) return scene;
      return insert(scene, slot.index, { ...keyframe, time: slot.time, hold: 0, between: 0 }, null);
    },
  };
}

/** A scene keeps at least one keyframe. The transition into the deleted one now leads to the next. */
export function deleteKeyframe(index: number): Command {
  return {
    label: "Delete keyframe",
    apply: (scene) => {
      const { keyframes: all } = mainTrack(scene);
      if (!all[index] || all.length === 1) return scene;
      // What becomes an end of the show ends the transition that it lies in first, and divides its path.
      const neighbor = index === 0 ? 1 : index === all.length - 1 ? index - 1 : null;
      return updateTrack(neighbor === null ? scene : setBetween(neighbor, false).apply(scene), (track) => {
        const keyframes = track.keyframes.toSpliced(index, 1);
        const segments = track.segments.toSpliced(Math.min(index, track.segments.length - 1), 1);
        return { ...track, keyframes, segments: chooseAgain(segments, [index - 1]) };
      });
    },
  };
}

export function renameKeyframe(index: number, name: string): Command {
  return {
    label: "Rename keyframe",
    apply: (scene) =>
      updateKeyframe(scene, index, (was) => {
        const clipped = clipText(name.trim(), LIMITS.name);
        return clipped === was.name ? was : { ...was, name: clipped };
      }),
  };
}

/** A keyframe between others bends the transition it lies in, without a stop; else it ends it, and another begins. */
export function setBetween(index: number, between: boolean): Command {
  return {
    label: between ? "Make an in-between" : "End the transition here",
    apply: (scene) =>
      reshapeKeyframe(scene, index, (was) => {
        if (!between) return was.between > 0 ? { ...was, between: 0 } : was;
        return { ...was, between: depthBetween(mainTrack(scene), index - 1, index + 1), corner: false, hold: 0 };
      }),
  };
}

/** A corner is a stop, although transitions join there. */
export function setCorner(index: number, corner: boolean): Command {
  return {
    label: corner ? "Make a corner" : "Smooth the corner",
    apply: (scene) => reshapeKeyframe(scene, index, (was) => (was.corner === corner ? was : { ...was, corner })),
  };
}

/**
 * Bring a formation to another place in the order: those between move up, the times stay.
 *
 * Name, positions and own adjacency travel; time and hold belong to the place. All of them are formations of their own
 * then: what bent one transition does not belong in another.
 */
export function reorderKeyframe(from: number, to: number): Command {
  return {
    label: "Reorder keyframes",
    apply: (scene) => {
      const before = mainTrack(scene);
      if (!before.keyframes[from] || !before.keyframes[to] || from === to) return scene;
      const [low, high] = [Math.min(from, to), Math.max(from, to)];
      const isMoved = (index: number) => index >= low && index <= high;
      const bends = [...before.keyframes.keys()].filter(
        (index) => liesBetween(before, index) && [index, ...endsAround(before, index)].some(isMoved),
      );
      const parted = bends.reduce((parting, index) => setBetween(index, false).apply(parting), scene);
      return updateTrack(parted, (track) => {
        const moved = track.keyframes[from];
        if (!moved) return track;
        const order = track.keyframes.toSpliced(from, 1).toSpliced(to, 0, moved);
        const keyframes = track.keyframes.map(({ time, hold }, i) => ({ ...(order[i] ?? moved), time, hold }));
        const touched = Array.from({ length: high - low + 2 }, (_, i) => low - 1 + i);
        return { ...track, keyframes, segments: chooseAgain(track.segments, touched) };
      });
    },
  };
}

function insert(scene: Scene, index: number, keyframe: Keyframe, taken: Choice | null): Scene {
  if (keyframe.positions.agentCount !== mainTrack(scene).agents.length) return scene;
  const next = updateTrack(scene, (track: Track) => {
    // A transition that is split keeps its options on both sides; a new one after the end follows the last.
    const split = track.segments[index - 1];
    const template = split ?? track.segments.at(-1) ?? DEFAULT_SEGMENT;
    const chosen = split?.method === "auto" ? taken : null;
    const parts = split
      ? [split, split].map((part) => ({ ...part, chosen }))
      : [{ ...template, chosen, path: null, assignment: null }];
    const longer = {
      ...track,
      // Who is not there on the way that is split is not there in the middle of it.
      keyframes: track.keyframes.toSpliced(
        index,
        0,
        split ? { ...keyframe, absent: goneIn(track, index - 1) } : keyframe,
      ),
      segments: track.segments.toSpliced(index - 1, split ? 1 : 0, ...parts),
    };
    return split && !liesBetween(longer, index) ? partedAt(longer, index) : longer;
  });
  return withinLimits(scene, next);
}
