import type { Formation } from "./formation";
import type { Segment } from "./scene";

type Path = Segment["path"];

/** A path in two where it comes nearest to a formation's barycenter; null for a part without a length. */
export function cutPath(path: NonNullable<Path>, { xy, agentCount }: Formation): readonly [Path, Path] {
  const mean = (axis: number) => xy.reduce((sum, value, k) => (k % 2 === axis ? sum + value : sum), 0) / agentCount;
  const [x, y] = [mean(0), mean(1)];
  let best = { piece: 0, share: 0, distance: Number.POSITIVE_INFINITY };
  path.slice(1).forEach((end, piece) => {
    const start = path[piece] ?? end;
    const [dx, dy] = [end[0] - start[0], end[1] - start[1]];
    const along = ((x - start[0]) * dx + (y - start[1]) * dy) / (dx * dx + dy * dy || 1);
    const share = Math.min(1, Math.max(0, along));
    const distance = Math.hypot(start[0] + share * dx - x, start[1] + share * dy - y);
    if (distance < best.distance) best = { piece, share, distance };
  });
  const [start, end] = [path[best.piece], path[best.piece + 1]];
  if (!start || !end) return [path, null];
  // Of as many numbers as the others.
  const at = start.map((value, axis) => value + ((end[axis] ?? value) - value) * best.share) as unknown as typeof start;
  return [
    [...path.slice(0, best.piece + 1), at],
    [at, ...path.slice(best.piece + 1)],
  ].map(withLength) as [Path, Path];
}

function withLength(path: NonNullable<Path>): Path {
  const [first] = path;
  return path.some((point) => point.some((value, axis) => value !== first?.[axis])) ? path : null;
}
