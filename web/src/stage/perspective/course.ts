import { clamp } from "../spacing";

/** Meters that are no way yet: who moves less in `WINDOW` faces the audience. */
const STANDING = 0.04;

/** The audience is in front; a little to the side, so that who comes from there turns about and is not flipped. */
const FRONT_X = 0.35 * STANDING;
const FRONT_Y = -STANDING;

/** Seconds before and after now that a course is read from: a corner is turned in twice that. */
export const WINDOW = 0.25;

const GRAVITY = 9.81;

/** No airplane of ours rolls over. Radians. */
const STEEPEST_BANK = 1.1;

/** Where somebody heads who moves by dx, dy meters around now: radians from x, counterclockwise. */
export function headingOf(dx: number, dy: number): number {
  return Math.atan2(dy + FRONT_Y, dx + FRONT_X);
}

/** How steeply a way climbs, radians. */
export function pitchOf(dx: number, dy: number, dz: number): number {
  const way = Math.sqrt(dx * dx + dy * dy + dz * dz);
  return way > STANDING ? Math.asin(clamp(dz / way, -1, 1)) : 0;
}

/**
 * How far an airplane leans into the turn from one way to the next, each of `WINDOW` seconds: positive to the left.
 *
 * Weight and centrifugal force together press straight on its floor.
 */
export function bankOf(ax: number, ay: number, bx: number, by: number): number {
  const turn = Math.atan2(ax * by - ay * bx, ax * bx + ay * by);
  const speed = (Math.sqrt(ax * ax + ay * ay) + Math.sqrt(bx * bx + by * by)) / (2 * WINDOW);
  const bank = Math.atan((speed * turn) / WINDOW / GRAVITY);
  return clamp(bank, -STEEPEST_BANK, STEEPEST_BANK);
}
