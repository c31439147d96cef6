import { type Bounds, type Camera, type Size, toStage } from "../camera";
import type { Orbit } from "./orbit";
import { FIELD_OF_VIEW } from "./sight";

/** What is to be in sight: a place on the ground and the air over it, meters. */
export interface Box extends Bounds {
  readonly height: number;
}

/** Share of the screen that is filled: pills float at its edges. From a seat one turns the head. */
const FILLED = { overview: 0.86, seat: 1.12 } as const;

/** How steeply all of it is looked down at, radians, and how much more on a screen that is all height. */
const OVERVIEW = { wide: 0.62, tall: 0.6 } as const;

/** How steeply somebody in a stand looks down, radians. */
const STAND = 0.22;

/** Nobody sits on the stage: meters in front of it. */
const AISLE = 3;

/** Steps toward the middle; each leaves a tenth of the way or less. */
const CENTERING = 8;

/** All of `box` from the front and above. */
export function overview(box: Box, size: Size): Orbit {
  const slimness = Math.max(0, 1 - size.width / Math.max(size.height, 1));
  return fitted(box, size, OVERVIEW.wide + OVERVIEW.tall * slimness, FILLED.overview);
}

/** All of `box` as the middle of the stand sees it, in front of the sheet. */
export function audienceSeat(box: Box, sheet: Bounds, size: Size): Orbit {
  const seat = fitted(box, size, STAND, FILLED.seat);
  const distance = Math.max(seat.distance, (seat.y - sheet.minY + AISLE) / Math.cos(STAND));
  return { ...seat, distance };
}

/** Straight down, with the ground where the plan has it. */
export function overPlan(camera: Camera, size: Size): Orbit {
  const [x, y] = toStage(camera, { x: size.width / 2, y: size.height / 2 });
  const distance = Math.max(size.height, 1) / camera.scale / 2 / Math.tan(FIELD_OF_VIEW / 2);
  return { x, y, z: 0, distance, azimuth: 0, elevation: Math.PI / 2 };
}

/** The nearest eye in front of `box` that has all of it in the middle of the screen and fills a share of it. */
function fitted(box: Box, size: Size, elevation: number, filled: number): Orbit {
  const tall = Math.tan(FIELD_OF_VIEW / 2) * filled;
  const wide = (tall * Math.max(size.width, 1)) / Math.max(size.height, 1);
  const [rise, run] = [Math.sin(elevation), Math.cos(elevation)];
  const x = (box.minX + box.maxX) / 2;
  const z = box.height / 2;
  let y = (box.minY + box.maxY) / 2;
  let distance = 0;
  // What is near looks larger, so the middle of the picture is not the middle of the box.
  for (let step = 0; step < CENTERING; step += 1) {
    distance = 0;
    const seen = cornersOf(box).map(([cx, cy, cz]) => {
      const [above, depth] = [(cy - y) * rise + (cz - z) * run, (cy - y) * run - (cz - z) * rise];
      distance = Math.max(distance, Math.abs(cx - x) / wide - depth, Math.abs(above) / tall - depth);
      return { above, depth };
    });
    distance = Math.max(distance, 1);
    const slopes = seen.map(({ above, depth }) => above / (distance + depth));
    y += ((Math.min(...slopes) + Math.max(...slopes)) / 2) * (distance / rise);
  }
  return { x, y, z, distance, azimuth: 0, elevation };
}

function cornersOf(box: Box): (readonly [x: number, y: number, z: number])[] {
  return [box.minX, box.maxX].flatMap((x) =>
    [box.minY, box.maxY].flatMap((y) => [0, box.height].map((z) => [x, y, z] as const)),
  );
}
