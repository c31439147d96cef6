/** A place on the stage: meters, x to the right, y away from the audience. */
export type Point = readonly [x: number, y: number];

/** Where every agent stands at one keyframe, by agent index. Immutable by convention: an edit makes a new one. */
export class Formation {
  /**
   * @param xy x0, y0, x1, y1, … in meters
   * @param heights z0, z1, … in meters; null in a plane scene
   */
  constructor(
    readonly xy: Float64Array,
    readonly heights: Float64Array | null = null,
  ) {
    if (xy.length % 2 !== 0) throw new Error(`a formation has two numbers an agent, not ${xy.length} in all`);
    if (heights && heights.length * 2 !== xy.length)
      throw new Error(`${heights.length} heights of ${xy.length / 2} agents`);
  }

  static from(points: Iterable<Point>): Formation {
    return new Formation(Float64Array.from([...points].flat()));
  }

  get agentCount(): number {
    return this.xy.length / 2;
  }

  x(agent: number): number {
    return this.xy[2 * agent] ?? Number.NaN;
  }

  y(agent: number): number {
    return this.xy[2 * agent + 1] ?? Number.NaN;
  }

  /** 0 in a plane scene. */
  height(agent: number): number {
    return this.heights?.[agent] ?? 0;
  }

  point(agent: number): Point {
    return [this.x(agent), this.y(agent)];
  }

  points(): Point[] {
    return Array.from({ length: this.agentCount }, (_, agent) => this.point(agent));
  }

  /** Some of its agents, in the order given. */
  select(agents: readonly number[]): Formation {
    const heights = this.heights && Float64Array.from(agents, (agent) => this.height(agent));
    return new Formation(Float64Array.from(agents.flatMap((agent) => this.point(agent))), heights);
  }

  /** With more agents after its own, on the ground. */
  add(points: readonly Point[]): Formation {
    const heights = this.heights && Float64Array.from([...this.heights, ...points.map(() => 0)]);
    return new Formation(Float64Array.from([...this.xy, ...points.flat()]), heights);
  }

  /** The same places as seen from above at other heights; null on the ground. */
  withHeights(heights: Float64Array | null): Formation {
    return new Formation(this.xy, heights);
  }

  /** The same formation with the places of some agents changed; everybody keeps their height. */
  with(places: Iterable<readonly [agent: number, place: Point]>): Formation {
    const xy = this.xy.slice();
    for (const [agent, [x, y]] of places) {
      xy[2 * agent] = x;
      xy[2 * agent + 1] = y;
    }
    return new Formation(xy, this.heights);
  }
}

/** The mean place of a formation. */
export function barycenterOf({ xy, agentCount }: Formation): Point {
  let [x, y] = [0, 0];
  for (let k = 0; k < xy.length; k += 2) {
    x += xy[k] ?? 0;
    y += xy[k + 1] ?? 0;
  }
  return [x / Math.max(1, agentCount), y / Math.max(1, agentCount)];
}
