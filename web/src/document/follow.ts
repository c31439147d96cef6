import { groupAt, groupPaths } from "./groups";
import { type GroupPath, mainTrack, type Scene } from "./scene";
import { NOTHING, type Selection } from "./selection";

/**
 * Where the item at `index` of `before` is in `after`: an unchanged item is the same object, a changed one keeps its
 * place. Null when it is gone.
 */
export function follow(before: readonly object[], after: readonly object[], index: number): number | null {
  const item = before[index];
  if (!item) return null;
  if (after.length === before.length) return index;
  const found = after.indexOf(item);
  if (found >= 0) return found;
  const candidate = after[index];
  return candidate && !before.includes(candidate) ? index : null;
}

/** What the selection of `before` means in `after`; nothing when what it pointed at is gone. */
export function followSelection(before: Scene, after: Scene, selection: Selection): Selection {
  const old = mainTrack(before);
  const now = mainTrack(after);
  switch (selection.kind) {
    case "none":
      return selection;
    case "agents":
      return old.agents.length === now.agents.length
        ? selection
        : followAgents(old.agents, now.agents, selection.agents);
    case "tie": {
      const a = follow(old.agents, now.agents, selection.a);
      const b = follow(old.agents, now.agents, selection.b);
      if (a === null || b === null) return NOTHING;
      return a === selection.a && b === selection.b ? selection : { kind: "tie", a, b };
    }
    case "group": {
      const path = followGroup(before, after, selection.path);
      if (path === null) return NOTHING;
      return path === selection.path ? selection : { kind: "group", path };
    }
    case "keyframe":
      if (old.keyframes.length === now.keyframes.length) return selection;
      // A run that lost or gained a keyframe is another run: only its moving end is followed.
      return followIndex(old.keyframes, now.keyframes, { kind: "keyframe", index: selection.index });
    case "transition":
      return followIndex(old.segments, now.segments, selection);
    case "obstacle":
      return followIndex(before.obstacles, after.obstacles, selection);
  }
}

/** The keyframe being edited, which always exists. */
export function followActiveKeyframe(before: Scene, after: Scene, active: number): number {
  const keyframes = mainTrack(after).keyframes;
  const followed = follow(mainTrack(before).keyframes, keyframes, active) ?? active;
  return Math.max(0, Math.min(keyframes.length - 1, followed));
}

function followIndex(
  before: readonly object[],
  after: readonly object[],
  selection: Extract<Selection, { readonly index: number }>,
): Selection {
  const index = follow(before, after, selection.index);
  if (index === null) return NOTHING;
  return index === selection.index ? selection : { ...selection, index };
}

function followAgents(before: readonly object[], after: readonly object[], agents: ReadonlySet<number>): Selection {
  const places = new Map(after.map((agent, index) => [agent, index]));
  const kept = [...agents].flatMap((agent) => {
    const place = places.get(before[agent] ?? before);
    return place === undefined ? [] : [place];
  });
  return kept.length > 0 ? { kind: "agents", agents: new Set(kept) } : NOTHING;
}

/** Where a group of `before` is in `after`; null when it is gone. */
export function followGroup(before: Scene, after: Scene, path: GroupPath): GroupPath | null {
  const group = groupAt(before.groups, path);
  if (!group) return null;
  const candidate = groupAt(after.groups, path);
  if (candidate === group) return path;
  const now = groupPaths(after.groups);
  const found = now.find((other) => groupAt(after.groups, other) === group);
  if (found) return found;
  const was = groupPaths(before.groups).map((other) => groupAt(before.groups, other));
  return candidate && !was.includes(candidate) ? path : null;
}
