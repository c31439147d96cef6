import { Color, Group } from "three";
import type { Track } from "../../document/scene";
import type { SegmentMotion } from "../../playback/motion";
import type { Show } from "../../playback/show";
import type { Cast } from "../cast";
import type { Palette } from "../palette";
import { presenceInto } from "../presence";
import type { Scenery } from "../scenery";
import { createDrops } from "./air";
import { type BodyKind, createBodies } from "./bodies";
import { createHulls } from "./hulls";
import { Instances } from "./instances";
import { createMarks } from "./marks";
import { Movement } from "./movement";
import type { BodySizes } from "./sizes";
import { createTieLines } from "./tie-lines";
import { createTrails } from "./trails";

/** Shadows on paper and at night, where there is little to take away. */
const DARKNESS = { light: 0.2, dark: 0.55 } as const;

/** Marks of a figure are as wide as a disc of this share of its height. */
const FIGURE_RADIUS = 0.17;

/** Who belongs together, as it is to be seen: each strength is 0 for not at all. */
export interface Togetherness {
  scenery: Scenery;
  /** How far through the transition. */
  share: number;
  /** How firmly ties show, 0..1, beside those of marked agents (1), which show in any case. */
  tieStrength: number;
  isMarked: Uint8Array | null;
  hullAlpha: number;
  /** Meters about an agent, and between neighbors. */
  hullReach: number;
  spacing: number;
}

/** Everybody of a show, with what lies on the ground around them. */
export interface Crowd {
  readonly count: number;
  readonly group: Group;
  /** x, y, z an agent; and apart from each other x, y, and z. */
  readonly place: Float32Array;
  readonly xy: Float32Array;
  readonly heights: Float32Array;
  /** By agent, how large it is beside most. */
  readonly shares: Float32Array;
  /** Everybody at `time`; allocates nothing. */
  pose(track: Track, show: Show, time: number, kind: BodyKind, sizes: BodySizes): void;
  /** Trails of `motion` at `time`, of bodies of `radius` meters; none without one. */
  trail(motion: SegmentMotion | null, time: number, strength: number, radius: number): void;
  /** Ties and hulls among everybody as they were posed last. */
  relate(how: Readonly<Togetherness>): void;
  paint(palette: Palette, cast: Cast): void;
  choose(agents: ReadonlySet<number>): void;
  dispose(): void;
}

export function createCrowd(count: number): Crowd {
  const instances = new Instances(count);
  const movement = new Movement(count);
  const bodies = createBodies(instances);
  const marks = createMarks(instances);
  const trails = createTrails(instances);
  const drops = createDrops(instances);
  const hulls = createHulls();
  const ties = createTieLines();
  let grown: Float32Array | null = null;
  const group = new Group();
  group.add(hulls.mesh, ties.lines, trails.mesh, marks.mesh, drops.lines, ...bodies.meshes);
  return {
    count,
    group,
    place: instances.place,
    xy: movement.now,
    heights: movement.high,
    shares: instances.share,
    pose(track, show, time, kind, sizes) {
      if (sizes.shares !== grown) instances.grow(sizes.shares);
      grown = sizes.shares;
      presenceInto(instances.presence, track, show, time);
      movement.poseInto(show, time, kind, sizes, instances);
      instances.moved(kind === "figures");
      bodies.show(kind, sizes);
      drops.lines.visible = show.isSpatial;
      marks.setRadius(markRadius(kind, sizes));
    },
    trail(motion, time, strength, radius) {
      if (motion && motion.agentCount === count) trails.update(motion, time, radius, strength);
      else trails.mesh.visible = false;
    },
    relate({ scenery, share, tieStrength, isMarked, hullAlpha, hullReach, spacing }) {
      ties.update(scenery.ties, instances.place, share, tieStrength, isMarked);
      hulls.update(scenery.hulls, instances.place, hullReach, spacing, hullAlpha);
    },
    paint(palette, { colors }) {
      instances.paint(colors);
      const darkness = palette.isDark ? DARKNESS.dark : DARKNESS.light;
      marks.setTheme(new Color(palette.isDark ? "#000000" : palette.ink), darkness, new Color(palette.you));
      bodies.setTheme(palette.isDark);
      drops.setColor(new Color(palette.ink3));
      ties.setColor(new Color(palette.tie));
      trails.paint(palette.trailAlpha);
    },
    choose: (agents) => instances.choose(agents),
    dispose() {
      bodies.dispose();
      marks.dispose();
      trails.dispose();
      drops.dispose();
      hulls.dispose();
      ties.dispose();
    },
  };
}

/** Of the shadow and the ring of one body, meters. */
export function markRadius(kind: BodyKind, sizes: BodySizes): number {
  return kind === "figures" ? sizes.figure * FIGURE_RADIUS : sizes.disc;
}
