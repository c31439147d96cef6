import type { Scene } from "../document/scene";
import type { Extreme } from "./api";
import type { Solo } from "./solo";

/** How a transition's movement looks as a whole: found on request, for it takes longer than all other numbers. */
export interface Movement {
  readonly measures: {
    /** I_d and I_v, bits: how much place tells of direction and of speed. */
    readonly mutualInformation: Extreme;
    readonly speedInformation: Extreme;
    /** Standard deviations of nearest distances and of ways from the source, and the mean distance to the target's places, meters. */
    readonly structureDeviation: Extreme;
    readonly effortDeviation: Extreme;
    readonly targetDeviation: Extreme;
    /** The median jerk, m/s³. */
    readonly roughness: number;
  };
  /** One value an instant. */
  readonly curves: {
    /** Scene seconds. */
    readonly times: readonly number[];
    readonly mutualInformation: readonly number[];
    readonly speedInformation: readonly number[];
    readonly structureDeviation: readonly number[];
    readonly effortDeviation: readonly number[];
    readonly targetDeviation: readonly number[];
  };
}

export async function askMovement(solo: Solo, scene: Scene, segment: number): Promise<Movement> {
  const text = await solo.ask("movement", (link) => ({ scene: link.ledger.message(scene), segment }));
  const [measures, curves] = JSON.parse(text) as [Movement["measures"], Movement["curves"]];
  return { measures, curves };
}
