import { DRAWN_TIE_FACTOR } from "../../document/commands/ties";
import { updateTrack } from "../../document/edit";
import type { AdjacencySpec, Group, Scene } from "../../document/scene";

/** Which ties a way is tried with: the scene's own, those its formations propose, or those with every group ten times as firm. */
export type TieChoice = "own" | "proposed" | "grouped";

/** Choices that differ in this scene; its own come first. */
export function tieChoices(scene: Scene): readonly TieChoice[] {
  const isEdited = tiedScene(scene, "proposed") !== scene;
  const isGrouped = scene.groups.length > 0;
  return ["own", ...(isEdited ? (["proposed"] as const) : []), ...(isGrouped ? (["grouped"] as const) : [])];
}

/** The scene with other ties; the same scene where that changes nothing. */
export function tiedScene(scene: Scene, ties: TieChoice): Scene {
  if (ties === "own") return scene;
  const factor = ties === "grouped" ? DRAWN_TIE_FACTOR : null;
  return withGroupTies(withoutHandTies(scene), factor);
}

function withoutHandTies(scene: Scene): Scene {
  const bare = updateTrack(scene, (track) =>
    track.keyframes.every(({ adjacency }) => adjacency === null)
      ? track
      : { ...track, keyframes: track.keyframes.map((keyframe) => ({ ...keyframe, adjacency: null })) },
  );
  return isBare(scene.adjacency)
    ? bare
    : { ...bare, adjacency: { ...bare.adjacency, base: "delaunay", ties: [], cuts: [] } };
}

function isBare({ base, ties, cuts }: AdjacencySpec): boolean {
  return base === "delaunay" && ties.length === 0 && cuts.length === 0;
}

function withGroupTies(scene: Scene, factor: number | null): Scene {
  const groups = tied(scene.groups, factor);
  return groups === scene.groups ? scene : { ...scene, groups };
}

/** Only the innermost groups: ties of a group and of one around it multiply. */
function tied(groups: readonly Group[], factor: number | null): readonly Group[] {
  const changed = groups.map((group): Group => {
    const children = tied(group.children, factor);
    const tieWeight = children.length > 0 ? null : factor;
    return children === group.children && tieWeight === group.tieWeight ? group : { ...group, children, tieWeight };
  });
  return changed.every((group, index) => group === groups[index]) ? groups : changed;
}
