import type { Scene } from "../document/scene";
import type { ComparisonQuestion, Extreme, SegmentReport } from "./api";
import type { Movement } from "./movement";
import type { Solo } from "./solo";

/** The numbers of one way to move a transition, and the movement over time. */
export interface Compared
  extends Pick<SegmentReport, "clearance" | "distortion" | "turning" | "pathLength" | "topSpeed">,
    Readonly<Movement["measures"]> {
  /** Seconds until everybody is there; null where some never are. */
  readonly time: number | null;
  /** How far forces alone leave agents from the target, meters; absent where there are none. */
  readonly arrivalError?: Extreme;
  readonly curves: Movement["curves"];
}

/** Null when it was stopped. */
export async function askComparison(solo: Solo, scene: Scene, question: ComparisonQuestion): Promise<Compared | null> {
  const text = await solo.ask("comparison", (link) => ({ ...question, scene: link.ledger.message(scene) }));
  return text === null ? null : (JSON.parse(text) as Compared);
}
