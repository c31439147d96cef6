import type { TransitionOptions } from "../../document/commands/transitions";
import { CROWD_DEFAULTS } from "../../document/generated";
import type { Cost, Scene } from "../../document/scene";
import { tieChoices } from "./side-ties";
import { changed, type Side, type SideChange } from "./sides";

/** Ways worth seeing beside each other. */
export interface Preset {
  readonly id: string;
  readonly label: string;
  readonly ways: readonly PresetWay[];
}

export interface PresetWay extends SideChange {
  /** By what places are to be found; absent: they are as in the scene. */
  readonly cost?: Cost;
}

const LINEAR: TransitionOptions = { method: "linear" };
const POLAR: TransitionOptions = { method: "polar", alignment: "pca" };
const SPECTRAL: TransitionOptions = { method: "spectral", order: "greedy", alignment: "pca", sharing: 0 };

const CROWD: TransitionOptions = { method: "crowd" };
const HEEDLESS: TransitionOptions = {
  ...CROWD,
  crowd: { ...CROWD_DEFAULTS, directionFeedback: false, speedFeedback: false },
};

const AVOIDING = [false, true] as const;

/** The comparisons that the paper's figures make, on whatever transition is at hand; without those that `scene` has no ties for. */
export function presetsFor(scene: Scene): readonly Preset[] {
  return [
    preset("figure-3", "Straight or turning (figure 3)", LINEAR, POLAR),
    preset("figure-4", "Without and with alignment (figure 4)", { ...SPECTRAL, alignment: "none" }, SPECTRAL),
    preset("figure-5", "Polar or spectral (figure 5)", POLAR, SPECTRAL),
    ...firmer(scene),
    preset("figure-8", "Modes by eigenvalue or by likeness (figure 8)", { ...SPECTRAL, order: "eigenvalue" }, SPECTRAL),
    preset("figure-9-above", "Straight or spectral (figure 9)", ...without(LINEAR, SPECTRAL)),
    {
      id: "figure-9",
      label: "Before and after avoidance (figure 9)",
      ways: AVOIDING.flatMap((avoidance) => [LINEAR, SPECTRAL].map((way) => ({ options: { ...way, avoidance } }))),
    },
    {
      id: "social-force",
      label: "Social force, with and without a guide (section 4.3)",
      ways: [
        { options: SPECTRAL, counterpart: "social-force-guide" },
        { options: SPECTRAL, counterpart: "social-force" },
      ],
    },
    {
      id: "avoidance",
      label: "One way, before and after avoidance",
      ways: AVOIDING.map((avoidance) => ({ options: { avoidance } })),
    },
    {
      id: "costs",
      label: "A crowd under three costs (crowds, figure 10)",
      ways: (["least-effort", "euclidean", "manhattan"] as const).map((cost) => ({ options: CROWD, cost })),
    },
    {
      id: "feedback",
      label: "With and without feedback (crowds, figure 12)",
      ways: [CROWD, HEEDLESS].map((options) => ({ options, cost: "least-effort" })),
    },
    {
      id: "others",
      label: "A crowd and what others do (crowds, figure 14)",
      ways: ([null, "social-force", "orca"] as const).map((counterpart) => ({
        options: CROWD,
        cost: "least-effort",
        counterpart,
      })),
    },
  ];
}

/** The ways of a preset for the transitions at hand, in turn. */
export function sidesOf({ ways }: Preset, hand: readonly Side[]): readonly Side[] {
  return ways.flatMap((way, index) => {
    const side = hand[index % hand.length];
    const { cost: _, ...change } = way;
    return side ? [changed({ ...side, ties: "own", seating: null, counterpart: null }, change)] : [];
  });
}

/** Ties as they are proposed, beside those a person made firmer; where nobody did, beside groups tied ten times as firmly. */
function firmer(scene: Scene): readonly Preset[] {
  const choices = tieChoices(scene);
  const firm = choices.includes("proposed") ? "own" : choices.includes("grouped") ? "grouped" : null;
  if (firm === null) return [];
  const ways = (["proposed", firm] as const).map((ties) => ({ options: SPECTRAL, ties }));
  return [{ id: "figure-6", label: "Ties as proposed, or firmer (figure 6)", ways }];
}

function preset(id: string, label: string, ...ways: readonly TransitionOptions[]): Preset {
  return { id, label, ways: ways.map((options) => ({ options })) };
}

function without(...ways: readonly TransitionOptions[]): TransitionOptions[] {
  return ways.map((way) => ({ ...way, avoidance: false }));
}
