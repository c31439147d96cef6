import { match } from "./matching.mjs";
import { leastDistance, turned } from "./places.mjs";

/** Widths a page's link writes without loss. */
const METRIC_GRID = 0.05;

/**
 * A scene under construction: agents in sections, keyframes given section by section.
 *
 * A section is `{ name, count, prefix, color, tieWeight }`; without a name it makes no group.
 */
export class Show {
  constructor({ grid = METRIC_GRID, sections, ...scene }) {
    this.grid = grid;
    this.scene = scene;
    this.sections = sections;
    this.keyframes = [];
  }

  /**
   * Adds a formation. Each section takes the places given for it so that it keeps its arrangement; where the whole
   * turns on the way, by `turn` degrees, its arrangement turns along. `isInOrder` keeps the order given.
   *
   * @param {Record<string, [number, number][]>} places by section name
   */
  keyframe({ name, time, hold, adjacency, turn = 0, isInOrder = false }, places) {
    const before = this.keyframes.at(-1)?.bySection;
    const bySection = {};
    for (const { name: section, count } of this.sections) {
      const wanted = places[section].map((place) => place.map((value) => this.snapped(value)));
      if (wanted.length !== count) throw new Error(`${name}: ${section} has ${wanted.length} places for ${count}`);
      bySection[section] = before && !isInOrder ? match(turned(before[section], turn), wanted) : wanted;
    }
    const positions = this.sections.flatMap((section) => bySection[section.name]);
    const least = leastDistance(positions);
    if (least < this.scene.minimumDistance) {
      throw new Error(`${this.scene.title}, ${name}: agents ${least.toFixed(3)} m apart`);
    }
    this.keyframes.push({ name, time, hold, adjacency, positions, bySection });
    return this;
  }

  /** The scene file's value; what has its default is left out. */
  toScene(segments) {
    const agents = this.sections.flatMap((section) =>
      Array.from({ length: section.count }, (_, index) =>
        compact({
          name: section.prefix ? `${section.prefix}${index + 1}` : undefined,
          color: section.colors?.[index],
        }),
      ),
    );
    let first = 0;
    const groups = this.sections.flatMap((section) => {
      const members = Array.from({ length: section.count }, (_, index) => first + index);
      first += section.count;
      if (section.isLoose) return [];
      return [compact({ name: section.name, color: section.color, members, tieWeight: section.tieWeight })];
    });
    return compact({
      format: "eigenform",
      version: 1,
      ...this.scene,
      agents: agents.some((agent) => Object.keys(agent).length > 0) ? agents : undefined,
      groups: groups.length > 0 ? groups : undefined,
      keyframes: this.keyframes.map(({ name, time, hold, positions, adjacency }) =>
        compact({ name, time, hold, positions, adjacency }),
      ),
      segments,
    });
  }

  snapped(value) {
    // Six decimals hold every grid used here exactly enough for the link, and keep the files short.
    const on = Number((Math.round(value / this.grid) * this.grid).toFixed(6));
    return on === 0 ? 0 : on;
  }
}

function compact(object) {
  return Object.fromEntries(Object.entries(object).filter(([, value]) => value !== undefined));
}
