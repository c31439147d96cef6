import type { Course } from "../glide";
import { between, type Orbit } from "./orbit";

/** How an eye flies by itself: it takes off and lands softly, and longer than any other motion of the page, since a whole stand is crossed. */
export const FLIGHT: Course<Orbit> = {
  duration: 900,
  at: (from, to, t) => between(from, to, t < 0.5 ? 4 * t ** 3 : 1 - 4 * (1 - t) ** 3),
};
