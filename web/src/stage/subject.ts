import { computed, type ReadonlySignal } from "@preact/signals";
import { selectedAgents } from "../document/queries";
import { mainTrack, type Scene, type Track } from "../document/scene";
import type { Selection } from "../document/selection";
import type { Planning, TieList } from "../engine/api";
import type { SegmentMotion } from "../playback/motion";
import { Show } from "../playback/show";

/** The stage draws names and all ties of a selection up to this many agents. */
export const FEW_SELECTED = 60;

/** What there is to draw, from the document and the planner; each part keeps its identity until it changes. */
export interface Subject {
  readonly track: ReadonlySignal<Track>;
  readonly show: ReadonlySignal<Show>;
  /** By segment: also a motion that is being planned anew, as it was. */
  readonly lastMotions: ReadonlySignal<readonly (SegmentMotion | null)[]>;
  /** By keyframe: while ties are being found anew, as they were. */
  readonly ties: ReadonlySignal<readonly (TieList | null)[]>;
  readonly selected: ReadonlySignal<ReadonlySet<number>>;
  /** 1 for agents whose ties always show; null when too many are selected, or none. */
  readonly isMarked: ReadonlySignal<Uint8Array | null>;
}

export function createSubject(
  scene: ReadonlySignal<Scene>,
  selection: ReadonlySignal<Selection>,
  segments: ReadonlySignal<readonly Planning[]>,
  planned: ReadonlySignal<readonly (TieList | null)[]>,
): Subject {
  const track = computed(() => mainTrack(scene.value));
  const join = computed(() => scene.value.join);
  const selected = computed(() => selectedAgents(scene.value, selection.value));
  let lastTies: readonly (TieList | null)[] = [];
  return {
    track,
    show: computed(() => new Show(track.value, segments.value.map(motionNow), join.value)),
    lastMotions: computed(() => segments.value.map(lastMotion)),
    ties: computed(() => {
      const count = track.value.agents.length;
      lastTies = planned.value.map((ties, keyframe) => ties ?? usable(lastTies[keyframe] ?? null, count));
      return lastTies;
    }),
    selected,
    isMarked: computed(() => {
      const agents = selected.value;
      if (agents.size === 0 || agents.size > FEW_SELECTED) return null;
      const marks = new Uint8Array(track.value.agents.length);
      for (const agent of agents) marks[agent] = 1;
      return marks;
    }),
  };
}

/** What a transition is drawn from: a motion of the scene as it is, be its numbers there or not. */
export function motionNow(planning: Planning): SegmentMotion | null {
  return planning.kind === "planning" && !planning.isCurrent ? null : lastMotion(planning);
}

function lastMotion(planning: Planning): SegmentMotion | null {
  if (planning.kind === "planning") return planning.motion;
  return planning.kind === "ready" ? planning.plan.motion : null;
}

function usable(ties: TieList | null, agentCount: number): TieList | null {
  return ties?.pairs.every((agent) => agent < agentCount) ? ties : null;
}
