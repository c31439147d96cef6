import { groupOf } from "../document/groups";
import type { GroupPath, Scene, Track } from "../document/scene";
import type { Selection } from "../document/selection";
import type { SegmentMotion } from "../playback/motion";
import type { Show } from "../playback/show";
import { ClashFinder } from "./clashes";
import type { Frame } from "./frame";
import { later } from "./later";
import { createAgentsLayer } from "./layers/agents";
import { drawHulls } from "./layers/hulls";
import { drawNames } from "./layers/names";
import { drawPathsToCome, drawStraightPaths } from "./layers/paths";
import { drawCuts, drawTies } from "./layers/ties";
import { createTrailsLayer } from "./layers/trails";
import { createTurns } from "./layers/turns";
import type { Scenery } from "./scenery";
import { smoothstep } from "./spacing";
import type { Layers } from "./view";

/** Seconds that the trails of a transition stay after it. */
const LINGER = 0.4;

/** What the motion canvas shows at one time; one is kept and refilled. */
export interface MotionPicture {
  scene: Scene;
  track: Track;
  show: Show;
  lastMotions: readonly (SegmentMotion | null)[];
  scenery: Scenery;
  layers: Layers;
  /** The group whose hull has an edge. */
  outlined: GroupPath | null;
  isMarked: Uint8Array | null;
  /** The Tie tool shows every tie and the cuts. */
  isTying: boolean;
  areHeightsShown: boolean;
  time: number;
}

/** The group that is selected, or hovered with the Group tool in hand. */
export function outlinedGroup(
  scene: Scene,
  selection: Selection,
  hovered: number | null,
  isGrouping: boolean,
): GroupPath | null {
  if (selection.kind === "group") return selection.path;
  return isGrouping && hovered !== null ? groupOf(scene.groups, hovered) : null;
}

/** A good show has no clash to mark, and at first no group is pointed at. */
const marks = later(() => import("./layers/clashes"));
const inTheWay = later(() => import("./layers/obstacles"));
/** Mostly everybody is there. */
const absent = later(() => import("./layers/absent"));
/** Mostly nobody has a size of their own. */
const bodies = later(() => import("./layers/bodies"));
/** Nothing is planned anew before something is changed. */
const formerPaths = later(() => import("./layers/former-paths"));
const edges = later(() => import("./layers/hull-edge"));
/** Most shows are on the plane. */
const heights = later(() => import("./layers/heights"));

/**
 * Draws everything that moves. Owns what its layers keep.
 *
 * Sparing, the agents are where they are and what lies under them is drawn by turns, a frame behind.
 */
export function createMotionPainter(
  frame: Frame,
  picture: MotionPicture,
  scratch: CanvasRenderingContext2D,
): (context: CanvasRenderingContext2D, isSparing: boolean) => void {
  const drawAgents = createAgentsLayer();
  const drawTrails = createTrailsLayer();
  const clashes = new ClashFinder();
  const turns = createTurns([drawGround, drawAllTrails]);

  function drawGround(context: CanvasRenderingContext2D): void {
    const { scene, track, show, scenery, layers, outlined, time } = picture;
    if (layers.groups) drawHulls(context, frame, scenery.hulls);
    if (outlined) {
      const place = frame.cast.groups.findIndex((group) => group.path.join() === outlined.join());
      const hull = scenery.hulls[place];
      if (hull) edges()?.drawHullEdge(context, frame, hull, scratch);
    }
    if (layers.ties || picture.isTying) {
      drawTies(context, frame, scenery.ties, show.progressAt(time) ?? 0, picture.isTying ? "all" : picture.isMarked);
      const { cuts, obstacleTies } = track.keyframes[show.keyframeBefore(time)]?.adjacency ?? scene.adjacency;
      if (picture.isTying) drawCuts(context, frame, cuts);
      if (obstacleTies.length > 0) inTheWay()?.drawObstacleTies(context, frame, scene.obstacles, obstacleTies);
    }
    if (layers.ghosts) drawAllPaths(context);
  }

  function drawAllPaths(context: CanvasRenderingContext2D): void {
    const { show, track, lastMotions, time } = picture;
    const next = show.keyframeBefore(time);
    const from = track.keyframes[next]?.positions;
    const target = track.keyframes[next + 1]?.positions;
    const motion = show.motionOf(next);
    const former = show.segmentAt(time) === null ? lastMotions[next] : null;
    // Whoever selects something may move it.
    const part = (former && !motion) || picture.isMarked ? formerPaths() : null;
    if (motion) drawPathsToCome(context, frame, motion, Math.max(time, motion.start));
    else if (part && from && target && former?.agentCount === frame.agentCount) {
      part.drawFormerPaths(context, frame, former, from.xy, target.xy);
    } else if (target) drawStraightPaths(context, frame, target.xy);
  }

  /** Of the transition under way, and of the one before while it lingers; standing, of the one that led here. */
  function drawAllTrails(context: CanvasRenderingContext2D): void {
    const { show, lastMotions, layers, time } = picture;
    if (!layers.trails) return;
    const segment = show.segmentAt(time);
    const before = (segment ?? show.keyframeBefore(time)) - 1;
    const earlier = segment === null ? lastMotions[before] : show.motionOf(before);
    if (earlier && earlier.agentCount === frame.agentCount) {
      const since = segment === null ? 0 : time - show.startOf(segment);
      drawTrails(context, frame, earlier, earlier.end, 1 - smoothstep(0, LINGER, since));
    }
    const motion = segment === null ? null : show.motionOf(segment);
    if (motion) drawTrails(context, frame, motion, time, 1);
  }

  return (context, isSparing) => {
    const { scene, show, layers, time } = picture;
    context.clearRect(0, 0, frame.size.width, frame.size.height);
    turns.draw(context, frame, isSparing);
    if (frame.cast.bodies) bodies()?.drawBodies(context, frame, picture.isMarked);
    drawAgents(context, frame);
    if (frame.presence) absent()?.drawAbsent(context, frame, show.progressAt(time));
    if (frame.cast.bodies) bodies()?.drawCores(context, frame, picture.isMarked);
    if (layers.names) drawNames(context, frame);
    if (frame.heights && picture.areHeightsShown) heights()?.drawHeights(context, frame, scene.stage.units);
    if (scene.minimumDistance > 0 && !show.isBlendedAt(time)) {
      clashes.find(frame.places, scene.minimumDistance, frame.heights, frame.isGone);
      if (clashes.count > 0) marks()?.drawClashes(context, frame, clashes, scene.minimumDistance, scene.stage.units);
    }
  };
}
