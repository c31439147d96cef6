import type { Choice } from "../document/scene";
import type {
  AssignmentQuestion,
  ComparisonQuestion,
  Counterpart,
  EngineProblem,
  GroupingWay,
  LinkReport,
  Metric,
  RecordingData,
  SegmentReport,
} from "./api";

/**
 * A scene as it crosses to a worker: formations once each, by number; all else as JSON text, only when it changed.
 */
export interface SceneMessage {
  /** The scene without positions; null: as last sent to this worker. */
  readonly rest: string | null;
  /** Number of each keyframe's formation. */
  readonly formations: readonly number[];
  /** Formations this worker has not seen: number, x, y an agent and, in space, their heights. */
  readonly added: readonly (readonly [id: number, xy: Float64Array, heights: Float64Array | null])[];
  /** Formations it may forget. */
  readonly dropped: readonly number[];
}

export interface PlanRequest {
  readonly scene: SceneMessage;
  /** Segments in the order they are wanted. */
  readonly order: readonly number[];
  /** By segment: the choice to keep although the method is auto (while dragging). */
  readonly held: readonly (Choice | null)[];
  /** Keyframes whose ties are wanted. */
  readonly ties: readonly number[];
  /** What moves the segments in place of what the scene says of them. */
  readonly counterpart: Counterpart | null;
}

export interface GroupingRequest {
  readonly scene: SceneMessage;
  readonly keyframe: number;
  readonly agents: Uint32Array;
  readonly way: GroupingWay;
}

export interface AffinityRequest {
  readonly scene: SceneMessage;
  readonly keyframe: number;
  readonly agents: Uint32Array;
  readonly metric: Metric;
  /** Of the usual preference: fewer than 1, more groups. */
  readonly times: number;
}

/** Every question to a worker and its answer. */
export interface Calls {
  /** Null for a text that is neither a scene file nor a link. */
  open: { ask: { readonly text: string }; answer: OpenedMessage | null };
  openAny: { ask: { readonly text: string }; answer: OpenedMessage };
  openRecording: { ask: { readonly text: string }; answer: RecordingData };
  writeScene: { ask: { readonly scene: SceneMessage }; answer: string };
  writeKeyframes: { ask: { readonly scene: SceneMessage }; answer: { text: string; notes: string[] } };
  writeMotion: { ask: { readonly scene: SceneMessage; readonly format: "csv" | "json" }; answer: string };
  link: { ask: { readonly scene: SceneMessage; readonly isShort: boolean }; answer: LinkReport };
  assign: { ask: { readonly source: Float64Array; readonly target: Float64Array }; answer: Uint32Array };
  /** Answers JSON of the slots; null when another errand or a cancel took its place. */
  assignment: { ask: { readonly scene: SceneMessage } & AssignmentQuestion; answer: string | null };
  /** Answers JSON of the groups, or null as above. */
  affinity: { ask: AffinityRequest; answer: string | null };
  modes: {
    ask: { readonly scene: SceneMessage; readonly keyframe: number; readonly most: number };
    /** All eigenvalues, then the modes beside the constant one, an entry an agent. */
    answer: Float64Array;
  };
  modesBetween: {
    ask: { readonly scene: SceneMessage; readonly segment: number; readonly most: number; readonly steps: number };
    /** Rows of likeness and pairings; eigenvalues at each of the steps, none for 0. */
    answer: { readonly match: Float32Array; readonly eigenvalues: Float64Array };
  };
  /** Answers JSON of the numbers and curves of one way; null as above. */
  comparison: { ask: { readonly scene: SceneMessage } & ComparisonQuestion; answer: string | null };
  /** Answers JSON of measures and curves. */
  movement: { ask: { readonly scene: SceneMessage; readonly segment: number }; answer: string };
  /** A slice of the work of letting them spread out; without a scene it goes on with the work under way. */
  salvage: {
    ask: { readonly scene: SceneMessage | null; readonly segment: number };
    /** JSON of what was found; null until the work is done. */
    answer: { readonly progress: number; readonly found: string | null };
  };
  /** Answers JSON of the groups. */
  proposeGroups: { ask: GroupingRequest; answer: string };
  /** Where everybody is at an instant of a segment: x, y an agent, then in space their heights. */
  places: {
    ask: { readonly scene: SceneMessage; readonly segment: number; readonly time: number };
    answer: Float64Array;
  };
  /** Answered when the request is taken over; results follow as plan messages. */
  plan: { ask: PlanRequest; answer: null };
  /** Answered between two steps of the work that stops. */
  cancel: { ask: null; answer: null };
}

export interface OpenedMessage {
  /** JSON of the scene in the page's shape, positions as `{xy, heights}`: x0, y0, x1, y1, … and z0, z1, … or null. */
  readonly scene: string;
  readonly source: "scene" | "csv" | "link";
  readonly notes: readonly string[];
}

export type CallName = keyof Calls;

/** Page to worker. */
export type Question =
  | { readonly kind: "start"; readonly module: WebAssembly.Module; readonly lock: string }
  | {
      [Name in CallName]: {
        readonly kind: "call";
        readonly id: number;
        readonly name: Name;
        readonly ask: Calls[Name]["ask"];
      };
    }[CallName];

/** Worker to page. */
export type Answer =
  | { readonly kind: "started" }
  | { readonly kind: "answer"; readonly id: number; readonly value: Calls[CallName]["answer"] }
  | { readonly kind: "refusal"; readonly id: number; readonly problem: EngineProblem }
  /** The engine trapped; this worker is dead. */
  | { readonly kind: "crashed"; readonly message: string }
  | PlanMessage;

/** What a plan request brings, one by one; `plan` is the id of the request. */
export type PlanMessage =
  | { readonly kind: "progress"; readonly plan: number; readonly segment: number; readonly progress: number }
  /** Always before the numbers. */
  | { readonly kind: "moved"; readonly plan: number; readonly segment: number; readonly motion: MotionData }
  | { readonly kind: "measured"; readonly plan: number; readonly segment: number; readonly numbers: NumbersData }
  | { readonly kind: "unplanned"; readonly plan: number; readonly segment: number; readonly problem: EngineProblem }
  | {
      readonly kind: "ties";
      readonly plan: number;
      readonly keyframe: number;
      readonly pairs: Uint32Array;
      readonly factors: Float64Array;
    }
  | { readonly kind: "idle"; readonly plan: number };

export interface MotionData {
  readonly times: Float64Array;
  /** x, y of every agent, sample by sample. */
  readonly xy: Float32Array;
  /** z of every agent, sample by sample; null in a plane scene. */
  readonly heights: Float32Array | null;
}

export interface NumbersData {
  /** Five curves of one value a sample, in the order of `SegmentCurves`. */
  readonly curves: Float32Array;
  readonly report: SegmentReport;
}
