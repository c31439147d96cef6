import type { Cost } from "../../../document/scene";
import type { ComparedWay } from "../../../engine/api";

/** A way as it is listed, and the agent's color that its curves have. */
export interface WayWord {
  readonly way: ComparedWay;
  readonly label: string;
  readonly color: number;
}

export const WAYS: readonly WayWord[] = [
  { way: "linear", label: "Linear", color: 10 },
  { way: "polar", label: "Polar", color: 3 },
  { way: "shared", label: "Shared", color: 9 },
  { way: "spectral", label: "Spectral", color: 2 },
  { way: "crowd", label: "Crowd", color: 1 },
  { way: "crowd-no-feedback", label: "Crowd, no feedback", color: 5 },
  { way: "crowd-no-groups", label: "Crowd, no subgroups", color: 7 },
  { way: "social-force-guide", label: "Social force on a way", color: 4 },
  { way: "social-force", label: "Social force alone", color: 8 },
  { way: "orca", label: "ORCA alone", color: 6 },
];

/** A cost as it is listed, the color that its curves have among others of one way, and their dashes among several ways. */
export interface CostWord {
  readonly cost: Cost;
  readonly label: string;
  readonly color: number;
  readonly dash: readonly number[];
}

export const COSTS: readonly CostWord[] = [
  { cost: "keep", label: "As they are", color: 10, dash: [] },
  { cost: "least-effort", label: "Least effort", color: 1, dash: [9, 4] },
  { cost: "squared", label: "Squared", color: 4, dash: [2, 3] },
  { cost: "euclidean", label: "Euclidean", color: 2, dash: [9, 3, 2, 3] },
  { cost: "manhattan", label: "Manhattan", color: 3, dash: [4, 3] },
];

/** What is compared, as a person chooses it. */
export interface RunChoice {
  readonly ways: readonly ComparedWay[];
  readonly costs: readonly Cost[];
  /** Everybody arrives when they do. */
  readonly isFree: boolean;
}

export interface RunPreset extends RunChoice {
  readonly id: string;
  readonly label: string;
}

/** What the papers compare. */
export const RUN_PRESETS: readonly RunPreset[] = [
  {
    id: "methods",
    label: "All methods",
    ways: ["linear", "polar", "spectral", "crowd", "crowd-no-feedback", "crowd-no-groups", "orca"],
    costs: ["keep"],
    isFree: false,
  },
  {
    id: "costs",
    label: "Three costs of who goes where (table 2)",
    ways: ["crowd"],
    costs: ["least-effort", "euclidean", "manhattan"],
    isFree: true,
  },
  {
    id: "feedback",
    label: "With and without feedback (figure 12)",
    ways: ["crowd", "crowd-no-feedback"],
    costs: ["least-effort"],
    isFree: false,
  },
  {
    id: "others",
    label: "A crowd and what others do (table 3)",
    ways: ["crowd", "social-force", "orca"],
    costs: ["least-effort"],
    isFree: true,
  },
];
