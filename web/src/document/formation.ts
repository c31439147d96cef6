/** A place on the stage: meters, x to the right, y away from the audience. */
export type Point = readonly [x: number, y: number];

/** Where every agent stands at one keyframe, by agent index. Immutable by convention: an edit makes a new one. */
export class Formation {
  /** @param xy x0, y0, x1, y1, … in meters */
  constructor(readonly xy: Float64Array) {
    if (xy.length % 2 !== 0) throw new Error(`a formation has two numbers an agent, not ${xy.length} in all`);
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

  point(agent: number): Point {
    return [this.x(agent), this.y(agent)];
  }

  points(): Point[] {
    return Array.from({ length: this.agentCount }, (_, agent) => this.point(agent));
  }

  /** The same formation with the places of some agents changed. */
  with(places: Iterable<readonly [agent: number, place: Point]>): Formation {
    const xy = this.xy.slice();
    for (const [agent, [x, y]] of places) {
      xy[2 * agent] = x;
      xy[2 * agent + 1] = y;
    }
    return new Formation(xy);
  }
}
