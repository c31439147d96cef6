import type { ReadonlySignal } from "@preact/signals";
import type { Branch } from "../document/commands/propose";
import type { Formation, Point } from "../document/formation";
import type { AssignmentSpec, Choice, Cost, MethodName, Scene } from "../document/scene";
import type { SegmentMotion } from "../playback/motion";
import type { AffinityRequest } from "./protocol";

/** What the engine says of input it refuses, or of its own failure. */
export interface EngineProblem {
  /** Stable, kebab-case. */
  readonly code: string;
  /** What happened and what is admissible, one sentence. */
  readonly what: string;
  /** Where: a row, a field, a keyframe; empty when it is the whole. */
  readonly where: string;
  /** Where obstacles leave somebody no way. */
  readonly noWay?: NoWay;
  /** Where a shape has no room for so many agents: how many it has room for. */
  readonly tooCrowded?: { readonly count: number; readonly largest: number };
}

/** An agent that an obstacle shuts off from its place, and what ways keep from obstacles, meters. */
export interface NoWay {
  readonly agent: number;
  readonly obstacle: number;
  readonly distance: number;
}

/** Rejections of every engine call. */
export class EngineError extends Error {
  constructor(readonly problem: EngineProblem) {
    super(problem.what);
  }
}

/** A scene that came through the door, and what the source could not say. */
export interface Opened {
  readonly scene: Scene;
  readonly source: "scene" | "csv" | "link";
  readonly notes: readonly string[];
}

export interface LinkReport {
  /** `#s=1.…` */
  readonly fragment: string;
  /** Largest displacement by rounding, meters; 0 when exact. */
  readonly rounding: number;
  /** Keyframes that break the minimum distance only after rounding. */
  readonly brokenKeyframes: readonly number[];
}

/** A motion recorded elsewhere, as the engine read it. */
export interface RecordingData {
  /** Frames a second. */
  readonly frameRate: number;
  /** Names of the agents, as the file calls them. */
  readonly agents: readonly string[];
  /** What was made of the file that it does not say itself. */
  readonly notes: readonly string[];
  /** Meters: x, y of every agent, frame by frame; NaN while an agent is absent. */
  readonly xy: Float32Array;
}

/** A tie of one keyframe as drawn: factor 1 is a proposed one. */
export interface TieList {
  /** a0, b0, a1, b1, … with a < b */
  readonly pairs: Uint32Array;
  readonly factors: Float64Array;
}

export interface Extreme {
  readonly mean: number;
  readonly max: number;
}

export interface Candidate extends Choice {
  readonly distortion: number;
  readonly turning: number;
  /** Meters; null for one agent. */
  readonly clearance: number | null;
  readonly score: number;
  readonly isChosen: boolean;
}

/** How near two agents come, and when. */
export interface Approach {
  /** Meters. */
  readonly distance: number;
  /** Scene seconds. */
  readonly time: number;
  readonly agents: readonly [number, number];
}

/** An agent at its nearest to an obstacle. */
export interface ObstacleApproach {
  /** Meters; at most 0 where the way crosses it. */
  readonly distance: number;
  /** Scene seconds. */
  readonly time: number;
  readonly agent: number;
  readonly obstacle: number;
}

/** An agent that is too near at an end of a transition. */
export interface KeyframeBreach {
  /** The keyframe it leaves, or the one it comes to. */
  readonly end: 0 | 1;
  readonly agent: number;
  readonly other: { readonly agent: number } | { readonly obstacle: number };
  /** Meters; negative inside an obstacle. */
  readonly distance: number;
}

/** An agent that is faster than it can be, meters a second, and the seconds that the transition would take without. */
export interface Hurry {
  readonly agent: number;
  readonly speed: number;
  readonly maxSpeed: number;
  readonly duration: number;
}

/** A next step where a transition does not keep the minimum distance. */
export type Suggestion =
  /** These two take each other's places in the target. */
  | { readonly kind: "swap"; readonly agents: readonly [number, number] }
  /** Everybody takes the place that makes the sum of squared ways least. */
  | { readonly kind: "assign" }
  | { readonly kind: "straight" }
  | { readonly kind: "sharing"; readonly sharing: number }
  /** Meters. */
  | { readonly kind: "distance"; readonly distance: number }
  /** Scene seconds. */
  | { readonly kind: "keyframe"; readonly time: number };

/** The measures of one transition (units as on the command line: m, s, rad). */
export interface SegmentReport {
  readonly choice: Choice;
  readonly distortion: Extreme;
  readonly turning: Extreme;
  /** The nearest that anybody comes to another; null for fewer than two agents. */
  readonly clearance: Approach | null;
  /** Before avoidance; absent without it, as what follows. */
  readonly guideClearance?: Approach | null;
  /** How far avoidance moves agents from the method's own motion, meters. */
  readonly deviation?: Extreme;
  /** Meetings that avoidance leaves too near; empty when it is proved that there are none. */
  readonly unsolved?: readonly Approach[];
  /** Agents that avoidance leaves too near to an obstacle, each at the nearest. */
  readonly blocked?: readonly ObstacleApproach[];
  /** Whom no way leads around obstacles, so that they go through; absent where nobody is shut off. */
  readonly shutOff?: readonly NoWay[];
  /** Who is too near in one of its keyframes already. */
  readonly breaches?: readonly KeyframeBreach[];
  /** What may help where it is not solved, the likeliest first. */
  readonly suggestions?: readonly Suggestion[];
  /** The nearest that anybody comes to an obstacle that they are tied to; absent where nobody is. */
  readonly heldClearance?: ObstacleApproach;
  /** How far forces lead agents from their guide, meters; absent where there are none, as what follows. */
  readonly guideDeviation?: Extreme;
  /** How far forces alone leave them from the target, meters. */
  readonly arrivalError?: Extreme;
  /** Who has to be faster than their top speed to arrive in time; absent where nobody has. */
  readonly hurried?: readonly Hurry[];
  readonly nearCollisions: number;
  readonly pathLength: Extreme;
  readonly topSpeed: { readonly speed: number; readonly time: number; readonly agent: number };
  readonly rmsRadius: { readonly min: number; readonly max: number };
  /** Empty unless the method is auto. */
  readonly candidates: readonly Candidate[];
}

/** One value a sample of the segment's motion. */
export interface SegmentCurves {
  readonly clearance: Float32Array;
  readonly distortion: Float32Array;
  readonly turning: Float32Array;
  readonly topSpeed: Float32Array;
  readonly pathLength: Float32Array;
}

/**
 * Ways to keep apart that no scene has, for comparison: social forces on the method's way, or toward the target alone, or optimal
 * reciprocal collision avoidance toward the target.
 */
export type Counterpart = "social-force-guide" | "social-force" | "orca";

export interface SegmentPlan {
  readonly motion: SegmentMotion;
  readonly report: SegmentReport;
  readonly curves: SegmentCurves;
}

export type Planning =
  | {
      readonly kind: "planning";
      /** 0..1 */
      readonly progress: number;
      /** The new motion before its numbers are there, else the last one. */
      readonly motion: SegmentMotion | null;
      /** Whether that is a motion of the scene as it is, which plays. */
      readonly isCurrent: boolean;
      /** The last motion with its numbers, while there are none of the new scene. */
      readonly stale: SegmentPlan | null;
    }
  | { readonly kind: "ready"; readonly plan: SegmentPlan }
  | { readonly kind: "canceled" }
  | { readonly kind: "failed"; readonly problem: EngineProblem };

/** Motions of the scene as it is, kept up to date as it changes; nearest the playhead first, latest wins. */
export interface Planner {
  /** By segment. */
  readonly segments: ReadonlySignal<readonly Planning[]>;
  /** By keyframe; null until known. */
  readonly ties: ReadonlySignal<readonly (TieList | null)[]>;
  /** 0..1 over all segments, null when nothing is under way. */
  readonly progress: ReadonlySignal<number | null>;
  /** Where everybody is at an instant of a segment that is planned, to the last digit; what is shown runs straight from frame to frame. */
  placesAt(scene: Scene, segment: number, time: number): Promise<Formation>;
  cancel(): void;
  /** Plan what was canceled or failed again. */
  resume(): void;
}

/** How groups are sought: halves of halves, so many side by side, or whom ties of at least a factor connect. */
export interface GroupingWay {
  readonly kind: "bisect" | "parts" | "connected";
  /** Levels, groups, or the factor. */
  readonly amount: number;
}

/** How far apart two agents are: as the crow flies, or along the axes. */
export type Metric = "euclidean" | "manhattan";

/** Who goes where in a transition, as a recipe says. */
export interface AssignmentQuestion {
  readonly segment: number;
  readonly recipe: AssignmentSpec;
  /** As if everybody stood mirrored end to end. */
  readonly isFlipped: boolean;
  /** As if everybody were carried as the locked agents are. */
  readonly isPredicted: boolean;
  /** What becomes of those who take the places of the absent; they leave where it is not said. */
  readonly rest?: Rest;
}

/** They are absent from the formation, stay where they are, or wait at the places of the absent. */
export type Rest = "leave" | "stay" | "bench";

/** Who takes which place, and how they get there around what stands in the way. */
export interface FoundPlaces {
  readonly slots: readonly number[];
  /** By agent, where its way to that place bends; nowhere where it is straight. */
  readonly bends: Bends;
  /** The same on the way to the place that is its own now. */
  readonly ownBends: Bends;
}

export type Bends = readonly (readonly Point[])[];

/** How a transition may be moved to be compared. */
export type ComparedWay = Exclude<MethodName, "auto"> | "crowd-no-feedback" | "crowd-no-groups" | Counterpart;

/** One way to move a transition, whatever the scene says of it. */
export interface ComparisonQuestion {
  readonly segment: number;
  readonly way: ComparedWay;
  /** By what places are given first; `keep`: as they are. */
  readonly cost: Cost;
  /** Meters a second of everybody who arrives when they do; null: at the keyframe's time. */
  readonly pace: number | null;
}

/** Questions to the engine, each answered once. */
export interface Engine {
  /** Any text: scene JSON, keyframe CSV or link. */
  open(text: string): Promise<Opened>;
  /** A motion CSV, or the text format of JuPedSim. */
  openRecording(text: string): Promise<RecordingData>;
  writeScene(scene: Scene): Promise<string>;
  writeKeyframes(scene: Scene): Promise<{ readonly text: string; readonly notes: readonly string[] }>;
  writeMotion(scene: Scene, format: "csv" | "json"): Promise<string>;
  link(scene: Scene, precision: "exact" | "short"): Promise<LinkReport>;
  /** `slots[agent]` is the slot of each agent; least total squared distance. */
  assign(source: Formation, target: Formation): Promise<Uint32Array>;
  /** Groups of some agents by the ties of a keyframe: nobody is in two. */
  proposeGroups(scene: Scene, keyframe: number, agents: Uint32Array, way: GroupingWay): Promise<readonly Branch[]>;
  /** The least assignment, exactly; null when a later errand or a stop took its place. `tell` hears how far it is, 0..1. */
  findPlaces(scene: Scene, question: AssignmentQuestion, tell: (progress: number) => void): Promise<FoundPlaces | null>;
  /** Groups of those who keep their distances from a keyframe to the next; `times` below 1, more of them. Null as above. */
  findAlike(
    scene: Scene,
    question: Omit<AffinityRequest, "scene">,
    tell: (progress: number) => void,
  ): Promise<readonly Branch[] | null>;
  /** Drops the errand under way. */
  stopErrand(): void;
  /** Says what happened to the engine itself: restarting, back. */
  readonly health: ReadonlySignal<"starting" | "ready" | "restarting" | "failed">;
}
