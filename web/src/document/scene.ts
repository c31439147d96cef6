import type { Formation } from "./formation";
import type * as generated from "./generated";

/** The document is readonly all the way down; an unchanged part keeps its identity. */
type Immutable<T> = T extends Formation ? T : T extends object ? { readonly [K in keyof T]: Immutable<T[K]> } : T;

export type Scene = Immutable<generated.Scene>;
export type Track = Immutable<generated.Track>;
export type Stage = Immutable<generated.Stage>;
export type Backdrop = generated.Backdrop;
export type Units = generated.Units;
export type Agent = Immutable<generated.Agent>;
export type Group = Immutable<generated.Group>;
export type AdjacencySpec = Immutable<generated.AdjacencySpec>;
export type AssignmentSpec = Immutable<generated.AssignmentSpec>;
export type Cost = generated.Cost;
export type Keyframe = Immutable<generated.Keyframe>;
export type Segment = Immutable<generated.Segment>;
/** What a formation travels along: its points as they are kept, with heights where somebody gave them. */
export type TravelPath = NonNullable<Segment["path"]>;
export type CrowdSpec = Immutable<generated.CrowdSpec>;
export type NodeSpec = Immutable<generated.NodeSpec>;
export type Obstacle = Immutable<generated.Obstacle>;
export type ObstacleShape = Immutable<generated.ObstacleShape>;
export type Choice = Immutable<generated.Choice>;
export type MethodName = generated.MethodName;
export type Join = generated.Join;
export type Order = generated.Order;
export type Alignment = generated.Alignment;
export type Timing = generated.Timing;

/** Child indices from the root: which group of the tree. */
export type GroupPath = readonly number[];

/** Version 1 has one track, of all agents. */
export function mainTrack(scene: Scene): Track {
  const track = scene.tracks[0];
  if (!track) throw new Error("a scene has a track");
  return track;
}
