import { updateSegment, updateTrack } from "../edit";
import { followGroup } from "../follow";
import type { GroupPath, NodeSpec, Scene, Segment } from "../scene";
import type { Command } from "../store";

/** How a group moves within a hierarchy: its method and what it is blended with. */
export type NodeWay = Pick<NodeSpec, "method" | "blend">;

/** Give a group a way of its own in one transition, or none; an empty path is everybody. */
export function setNode(index: number, path: GroupPath, way: NodeWay | null): Command {
  return {
    label: way ? "Change group method" : "Use the transition's method",
    apply: (scene) =>
      updateSegment(scene, index, (was) => {
        const place = was.nodes.findIndex((node) => isAt(node, path));
        if (!way && place < 0) return was;
        const node = way && { group: path, ...way };
        const nodes = place < 0 ? was.nodes : was.nodes.toSpliced(place, 1, ...(node ? [node] : []));
        return { ...was, nodes: place < 0 && node ? [...nodes, node] : nodes, chosen: null };
      }),
  };
}

/** The way of a group of its own; null where it moves as the transition says. */
export function nodeAt(segment: Segment, path: GroupPath): NodeSpec | null {
  return segment.nodes.find((node) => isAt(node, path)) ?? null;
}

/** The scene with the ways of groups kept by their groups, wherever in the tree these are now. */
export function followNodes(
  before: Scene,
  after: Scene,
  find = (path: GroupPath): GroupPath | null => followGroup(before, after, path),
): Scene {
  if (before.groups === after.groups) return after;
  return updateTrack(after, (track) => {
    const segments = track.segments.map((segment) => {
      if (segment.nodes.length === 0) return segment;
      const nodes = segment.nodes.flatMap((node) => {
        const path = node.group.length === 0 ? node.group : find(node.group);
        return path ? [{ ...node, group: path }] : [];
      });
      return { ...segment, nodes };
    });
    return segments.every((segment, i) => segment === track.segments[i]) ? track : { ...track, segments };
  });
}

function isAt(node: NodeSpec, path: GroupPath): boolean {
  return node.group.length === path.length && node.group.every((step, depth) => step === path[depth]);
}
