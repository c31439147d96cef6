import type { Point } from "./formation";
import type { ObstacleShape, Scene } from "./scene";

/** What an obstacle is called when nobody named it. */
export function obstacleLabel(scene: Scene, index: number): string {
  return scene.obstacles[index]?.name || `Obstacle ${index + 1}`;
}

export function shapeMoved(shape: ObstacleShape, [dx, dy]: Point): ObstacleShape {
  const moved = ([x, y]: Point): Point => [x + dx, y + dy];
  return shape.kind === "circle"
    ? { ...shape, center: moved(shape.center) }
    : { ...shape, points: shape.points.map(moved) };
}

/** The place an obstacle is moved by: a circle's center, the middle of a polygon's corners. */
export function middleOf(shape: ObstacleShape): Point {
  if (shape.kind === "circle") return shape.center;
  const count = Math.max(1, shape.points.length);
  const sum = shape.points.reduce<Point>(([x, y], [px, py]) => [x + px, y + py], [0, 0]);
  return [sum[0] / count, sum[1] / count];
}

/** How far a place is from an outline, meters; 0 inside. */
export function distanceTo(shape: ObstacleShape, at: Point): number {
  const [x, y] = nearestOn(shape, at);
  return isInside(shape, at) ? 0 : Math.hypot(at[0] - x, at[1] - y);
}

/** The place of an outline that is nearest to another place. */
export function nearestOn(shape: ObstacleShape, at: Point): Point {
  if (shape.kind === "circle") {
    const [dx, dy] = [at[0] - shape.center[0], at[1] - shape.center[1]];
    const away = Math.hypot(dx, dy);
    const [ux, uy] = away > 0 ? [dx / away, dy / away] : [1, 0];
    return [shape.center[0] + ux * shape.radius, shape.center[1] + uy * shape.radius];
  }
  let best: Point = shape.points[0] ?? at;
  let least = Number.POSITIVE_INFINITY;
  for (const [from, to] of sidesOf(shape.points)) {
    const candidate = nearestOnLine(from, to, at);
    const distance = Math.hypot(candidate[0] - at[0], candidate[1] - at[1]);
    if (distance < least) [best, least] = [candidate, distance];
  }
  return best;
}

/** Whether any two sides of a polygon cross. */
export function crossesItself(points: readonly Point[]): boolean {
  const sides = sidesOf(points);
  return sides.some((side, index) =>
    sides.slice(index + 2).some((other) => arePartedBy(side, other) && arePartedBy(other, side)),
  );
}

/** Whether a line's ends lie on either side of another. */
function arePartedBy([a, b]: readonly [Point, Point], [from, to]: readonly [Point, Point]): boolean {
  const turn = (p: Point) => (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
  return turn(from) * turn(to) < 0;
}

function isInside(shape: ObstacleShape, [x, y]: Point): boolean {
  if (shape.kind === "circle") return Math.hypot(x - shape.center[0], y - shape.center[1]) < shape.radius;
  let isOdd = false;
  for (const [[ax, ay], [bx, by]] of sidesOf(shape.points)) {
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) isOdd = !isOdd;
  }
  return isOdd;
}

function sidesOf(points: readonly Point[]): (readonly [from: Point, to: Point])[] {
  return points.map((point, index) => [point, points[(index + 1) % points.length] ?? point]);
}

function nearestOnLine([ax, ay]: Point, [bx, by]: Point, [x, y]: Point): Point {
  const [dx, dy] = [bx - ax, by - ay];
  const length = dx * dx + dy * dy;
  const t = length > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / length)) : 0;
  return [ax + t * dx, ay + t * dy];
}
