import { airshow } from "./airshow.mjs";
import {
  aligned,
  clusters,
  clustersApart,
  fourAroundOne,
  polarOrSpectral,
  rotatedCopy,
  sixModes,
  smallAndLarge,
  winding,
} from "./pairs.mjs";
import { offsideTrap } from "./soccer.mjs";
import { thousand } from "./thousand.mjs";

/** After "Spectral-Based Group Formation Control" (2009): by file name; `cover` is the transition that the gallery shows. */
export const FORMATION_CONTROL = {
  "six-modes": { make: sixModes, cover: 0 },
  "rotated-copy": { make: rotatedCopy, cover: 2 },
  alignment: { make: aligned, cover: 2 },
  "polar-or-spectral": { make: polarOrSpectral, cover: 2 },
  "four-around-one": { make: fourAroundOne, cover: 2 },
  "small-and-large": { make: smallAndLarge, cover: 1 },
  winding: { make: winding, cover: 0 },
  clusters: { make: clusters, cover: 2 },
  "clusters-apart": { make: clustersApart, cover: 0 },
  "offside-trap": { make: offsideTrap, cover: 2 },
  thousand: { make: thousand, cover: 1 },
  airshow: { make: airshow, cover: 0 },
};
