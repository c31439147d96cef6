import { band } from "./band.mjs";
import { fieldShow } from "./field-show.mjs";
import { gridToRing, threeBlocks } from "./figures.mjs";
import { flower } from "./flower.mjs";
import { starToRings } from "./large.mjs";

/** What bands do on a field: by file name; `cover` is the transition that the gallery shows. */
export const SHOWS = {
  band: { make: band, cover: 1 },
  "half-time": { make: fieldShow, cover: 0 },
  flower: { make: flower, cover: 0 },
  "star-to-five-rings": { make: starToRings, cover: 1 },
  "three-blocks": { make: threeBlocks, cover: 1 },
  "grid-to-ring": { make: gridToRing, cover: 0 },
};
