import { alongACurve } from "./along-a-curve.mjs";
import { apeToHuman } from "./ape-to-human.mjs";
import { roundAnObstacle, twoGroupsCrossing } from "./around.mjs";
import { bird } from "./bird.mjs";
import { besideOthers, threeCosts } from "./compared.mjs";
import { feedback } from "./feedback.mjs";
import { fighters } from "./fighters.mjs";
import { martialArts } from "./martial-arts.mjs";
import { runningMan } from "./running-man.mjs";

/** After "Collective Crowd Formation Transform" (2015): by file name; `cover` is the transition that the gallery shows. */
export const CROWDS = {
  bird: { make: bird, cover: 2 },
  "running-man": { make: runningMan, cover: 0 },
  "martial-arts": { make: martialArts, cover: 2 },
  fighters: { make: fighters, cover: 1 },
  "along-a-curve": { make: alongACurve, cover: 0 },
  "ape-to-human": { make: apeToHuman, cover: 0 },
  "round-an-obstacle": { make: roundAnObstacle, cover: 0 },
  "two-groups-crossing": { make: twoGroupsCrossing, cover: 0 },
  "three-costs": { make: threeCosts, cover: 4 },
  feedback: { make: feedback, cover: 2 },
  "beside-others": { make: besideOthers, cover: 0 },
};
