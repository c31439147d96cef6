// Generated from the engine's types by `cargo xtask types`. Do not edit.

import type { Formation } from "./formation";

export type Scene = { 
/**
 * At most 200 characters.
 */
title: string, 
/**
 * Of every random choice made for this scene.
 */
seed: number, 
/**
 * The place it is shown on.
 */
stage: Stage, 
/**
 * How seconds read as counts.
 */
tempo: Tempo, 
/**
 * Frames per second, 1–120.
 */
frameRate: number, 
/**
 * Agents nearer than this clash; meters, 0 for no limit.
 */
minimumDistance: number, 
/**
 * How segments meet.
 */
join: Join, 
/**
 * Tension τ of smooth joins, 0–1; 0.5 is that of Catmull and Rom.
 */
tension: number, 
/**
 * The tree of groups; siblings share no agent.
 */
groups: Array<Group>, 
/**
 * Who belongs together throughout the show.
 */
adjacency: AdjacencySpec, 
/**
 * Version 1 has exactly one, of all agents.
 */
tracks: Array<Track>, 
/**
 * What agents go around.
 */
obstacles: Array<Obstacle>, };

export type Track = { 
/**
 * One entry an agent.
 */
agents: Array<Agent>, 
/**
 * By rising time; at least one.
 */
keyframes: Array<Keyframe>, 
/**
 * `segments[i]` runs from keyframe i to keyframe i + 1.
 */
segments: Array<Segment>, };

export type Stage = { 
/**
 * Along x, meters.
 */
width: number, 
/**
 * Along y, meters.
 */
depth: number, 
/**
 * Along z, meters.
 */
height: number, 
/**
 * What is painted on it.
 */
backdrop: Backdrop, 
/**
 * What lengths are shown in; the scene itself is in meters.
 */
units: Units, };

export type Backdrop = "none" | "grid" | "football-college" | "football-hs" | "soccer" | "stage";

export type Units = "m" | "ft" | "yd" | "steps";

export type Tempo = { 
/**
 * Counts a minute.
 */
beatsPerMinute: number, 
/**
 * Counts a bar.
 */
beatsPerBar: number, 
/**
 * The time of the first count, seconds.
 */
start: number, };

export type Agent = { 
/**
 * At most 64 characters; empty: shown by number.
 */
name: string, 
/**
 * `#rrggbb`, or empty for its group's color.
 */
color: string, 
/**
 * Body radius, meters.
 */
radius: number, 
/**
 * The fastest it moves in a crowd, meters a second; none: no limit.
 */
maxSpeed: number | null, };

export type Group = { 
/**
 * At most 64 characters.
 */
name: string, 
/**
 * `#rrggbb`, or empty for the next of the palette.
 */
color: string, 
/**
 * Agents of its own, beside its children's.
 */
members: Array<number>, 
/**
 * Factor of the ties among its set; none: no ties of its own.
 */
tieWeight: number | null, 
/**
 * Groups within.
 */
children: Array<Group>, };

export type AdjacencySpec = { 
/**
 * Where the ties start from.
 */
base: Base, 
/**
 * How a factor becomes a weight.
 */
weights: Weights, 
/**
 * Ties by hand: two agents and a factor.
 */
ties: Array<[number, number, number]>, 
/**
 * Pairs that are not tied, whatever came before.
 */
cuts: Array<[number, number]>, 
/**
 * Agents that keep their clearance to an obstacle: agent, obstacle and a factor.
 */
obstacleTies: Array<[number, number, number]>, };

export type Base = "delaunay" | "none";

export type Weights = "inverse" | "unit";

export type AssignmentSpec = { 
/**
 * What is least in sum.
 */
cost: Cost, 
/**
 * 0–1: how much the way counts in least effort, beside how densely agents stand at both ends.
 */
lambda: number, 
/**
 * Agents and the slots they have whatever it costs.
 */
locks: Array<[number, number]>, 
/**
 * Groups get regions of slots first, and their agents slots within them.
 */
keepGroups: boolean, };

export type Cost = "squared" | "least-effort" | "euclidean" | "manhattan" | "keep";

export type Keyframe = { 
/**
 * At most 64 characters; empty: shown by number.
 */
name: string, 
/**
 * Seconds.
 */
time: number, 
/**
 * How long the agents stand from `time` on, seconds.
 */
hold: number, 
/**
 * Stop here although segments join smoothly.
 */
corner: boolean, 
/**
 * How deep it lies in a transition, which it bends instead of ending it; 0 where it ends one: see [`Track::depths`].
 */
between: number, 
/**
 * `positions[i]` is always agent i.
 */
positions: Formation, 
/**
 * Who is not there while the others stand here, ascending: their positions are where they leave to and come from.
 */
absent: Array<number>, 
/**
 * Replaces the scene's adjacency here.
 */
adjacency: AdjacencySpec | null, };

export type Segment = { "kind": "transition" } & TransitionSpec;

export type TransitionSpec = { 
/**
 * The method asked for.
 */
method: MethodName, 
/**
 * What `auto` took when the person saved or shared; when present nothing is chosen again.
 */
chosen: Choice | null, 
/**
 * How modes are paired (spectral).
 */
order: Order, 
/**
 * Which turn is taken out before the modes interpolate (spectral, shared, polar).
 */
alignment: Alignment, 
/**
 * Sharing ρ, 0–1: how much the two bases meet halfway (spectral).
 */
sharing: number, 
/**
 * Scale the mode coefficients so that the formation keeps its size (spectral, shared).
 */
keepSize: boolean, 
/**
 * How the parameter runs with time.
 */
timing: Timing, 
/**
 * Keep the minimum distance on the way.
 */
avoidance: boolean, 
/**
 * Let the groups move as wholes.
 */
hierarchy: boolean, 
/**
 * Groups that move by a method of their own, each once.
 */
nodes: Array<NodeSpec>, 
/**
 * What the formation travels along, turning with it.
 */
path: Array<[number, number] | [number, number, number]> | null, 
/**
 * What the forces are told (crowd).
 */
crowd: CrowdSpec, 
/**
 * How it was found who goes where; the positions have it already.
 */
assignment: AssignmentSpec | null, };

export type CrowdSpec = { 
/**
 * The interpolation that agents follow, with the segment's own options: never `auto` nor `crowd`.
 */
guide: MethodName, 
/**
 * Feedback of direction, by `I_d`.
 */
directionFeedback: boolean, 
/**
 * Feedback of speed, by `I_v`.
 */
speedFeedback: boolean, 
/**
 * τ, seconds: how fast agents take up the velocity they want (equation 8).
 */
reactionTime: number, 
/**
 * Seconds that agents look ahead on their way; where that is, they aim. Not of the paper, whose aim is the target itself.
 */
lookAhead: number, 
/**
 * A: repulsion of agents and of obstacles (equations 9 and 10).
 */
strength: number, 
/**
 * B: the length over which that falls to 1/e.
 */
reach: number, 
/**
 * A′: attraction within a subgroup and repulsion between them (equations 21 and 22).
 */
groupStrength: number, 
/**
 * B′: the length over which those change.
 */
groupReach: number, 
/**
 * ξ: the greatest random acceleration along each axis (equation 7).
 */
fluctuation: number, 
/**
 * R: the side of the bins within which agents share direction and speed (equations 12 and 13).
 */
binSize: number, 
/**
 * K: sectors of a full turn (equation 14); whoever rests has one more.
 */
sectors: number, };

export type NodeSpec = { 
/**
 * The group, as child indices from the root; empty: the root.
 */
group: Array<number>, 
/**
 * Never `auto`.
 */
method: MethodName, 
/**
 * A second method beside it.
 */
blend: Blend | null, };

export type Obstacle = { 
/**
 * At most 64 characters.
 */
name: string, 
/**
 * Its outline.
 */
shape: ObstacleShape, };

export type ObstacleShape = { "kind": "circle", 
/**
 * Its center.
 */
center: [number, number], 
/**
 * Greater than 0.
 */
radius: number, } | { "kind": "polygon", 
/**
 * Its corners in either direction, the first not repeated.
 */
points: Array<[number, number]>, };

export type Choice = { 
/**
 * Never `auto`.
 */
method: MethodName, 
/**
 * Used by spectral.
 */
order: Order, 
/**
 * Used by spectral, shared, polar.
 */
alignment: Alignment, 
/**
 * Used by spectral.
 */
sharing: number, };

export type Blend = { 
/**
 * Never `auto`.
 */
method: MethodName, 
/**
 * 0–1: how much of the motion is the second method's.
 */
amount: number, };

export type MethodName = "auto" | "spectral" | "shared" | "polar" | "linear" | "crowd";

export type Join = "separate" | "smooth" | "product";

export type Order = "eigenvalue" | "greedy" | "maxmin" | "hungarian";

export type Alignment = "none" | "pca" | "procrustes";

export type Timing = "linear" | "smooth" | "even";

/** What a crowd is told where nothing is said. */
export const CROWD_DEFAULTS: CrowdSpec = {"guide":"linear","directionFeedback":true,"speedFeedback":true,"reactionTime":0.5,"lookAhead":0.5,"strength":5.0,"reach":0.3,"groupStrength":0.5,"groupReach":2.0,"fluctuation":0.0,"binSize":4.0,"sectors":8};
