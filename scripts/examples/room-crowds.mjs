import { bird, fighters, runningMan } from "./crowds.mjs";

/** After "Collective Crowd Formation Transform" (2016): by file name; `cover` is the transition that the gallery shows. */
export const CROWDS = {
  bird: { make: bird, cover: 2 },
  "running-man": { make: runningMan, cover: 0 },
  fighters: { make: fighters, cover: 1 },
};
