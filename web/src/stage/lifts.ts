import type { Projection } from "./view";

/** Which selections can be pulled up: all, those with a box, or none where up on the screen is height already. */
export type Lifts = "everybody" | "boxes" | "nobody";

/** A plane show keeps single agents free of a handle: most are never lifted. */
export function liftsOf(projection: Projection, isSpatial: boolean): Lifts {
  if (projection === "front") return "nobody";
  return isSpatial ? "everybody" : "boxes";
}
