import type { Scene, Track } from "../document/scene";
import type { Selection } from "../document/selection";
import type { SegmentMotion } from "../playback/motion";
import type { Show } from "../playback/show";
import { ClashFinder } from "./clashes";
import type { Frame } from "./frame";
import { createAgentsLayer } from "./layers/agents";
import { drawClashes } from "./layers/clashes";
import { drawHullEdge, drawHulls } from "./layers/hulls";
import { drawNames } from "./layers/names";
import { drawPathsToCome, drawStraightPaths } from "./layers/paths";
import { drawCuts, drawTies } from "./layers/ties";
import { createTrailsLayer } from "./layers/trails";
import { createTurns, type Part } from "./layers/turns";
import type { Scenery } from "./scenery";
import { smoothstep } from "./spacing";
import type { Layers } from "./view";

/** Seconds that the trails of a transition stay after it. */
const LINGER = 0.4;

/** What the motion canvas shows at one time. */
export interface MotionPicture {
  readonly scene: Scene;
  readonly track: Track;
  readonly show: Show;
  readonly lastMotions: readonly (SegmentMotion | null)[];
  readonly scenery: Scenery;
  readonly layers: Layers;
  readonly selection: Selection;
  readonly isMarked: Uint8Array | null;
  /** The Tie tool shows every tie and the cuts. */
  readonly isTying: boolean;
  readonly time: number;
}

/**
 * Draws everything that moves. Owns what its layers keep.
 *
 * Sparing, the agents are where they are and what lies under them is half a step behind, by turns.
 */
export function createMotionPainter(): (
  context: CanvasRenderingContext2D,
  frame: Frame,
  picture: MotionPicture,
  scratch: CanvasRenderingContext2D,
  isSparing: boolean,
) => void {
  const turns = createTurns();
  const drawAgents = createAgentsLayer();
  const drawTrails = createTrailsLayer();
  const clashes = new ClashFinder();

  function drawAllTrails(context: CanvasRenderingContext2D, frame: Frame, picture: MotionPicture): void {
    const { show, lastMotions, time } = picture;
    const segment = show.segmentAt(time);
    const before = (segment ?? show.keyframeBefore(time)) - 1;
    const earlier = segment === null ? lastMotions[before] : show.motionOf(before);
    if (earlier && earlier.agentCount === frame.agentCount) {
      const since = segment === null ? 0 : time - show.startOf(segment);
      drawTrails(context, frame, { motion: earlier, now: earlier.end, strength: 1 - smoothstep(0, LINGER, since) });
    }
    const motion = segment === null ? null : show.motionOf(segment);
    if (motion) drawTrails(context, frame, { motion, now: time, strength: 1 });
  }

  function drawAllPaths(context: CanvasRenderingContext2D, frame: Frame, picture: MotionPicture): void {
    const { show, track, time } = picture;
    const next = show.keyframeBefore(time);
    const target = track.keyframes[next + 1]?.positions;
    const motion = show.motionOf(next);
    if (motion) drawPathsToCome(context, frame, motion, Math.max(time, motion.start));
    else if (target) drawStraightPaths(context, frame, target.xy);
  }

  function drawGround(
    context: CanvasRenderingContext2D,
    frame: Frame,
    picture: MotionPicture,
    scratch: CanvasRenderingContext2D,
  ): void {
    const { scene, track, show, scenery, layers, selection, time } = picture;
    if (layers.groups) drawHulls(context, frame, scenery.hulls);
    if (selection.kind === "group") {
      const place = frame.cast.groups.findIndex((group) => group.path.join() === selection.path.join());
      const hull = scenery.hulls[place];
      if (hull) drawHullEdge(context, frame, hull, scratch);
    }
    if (layers.ties || picture.isTying) {
      const segment = show.segmentAt(time);
      const t = segment === null ? 0 : (time - show.startOf(segment)) / (show.endOf(segment) - show.startOf(segment));
      drawTies(context, frame, scenery.ties, t, picture.isTying ? "all" : picture.isMarked);
    }
    if (picture.isTying) {
      drawCuts(context, frame, (track.keyframes[show.keyframeBefore(time)]?.adjacency ?? scene.adjacency).cuts);
    }
    if (layers.ghosts) drawAllPaths(context, frame, picture);
  }

  return (context, frame, picture, scratch, isSparing) => {
    const { scene, layers } = picture;
    context.clearRect(0, 0, frame.size.width, frame.size.height);
    const parts: Part[] = [(onto) => drawGround(onto, frame, picture, scratch)];
    if (layers.trails) parts.push((onto) => drawAllTrails(onto, frame, picture));
    turns.draw(context, frame, parts, isSparing);
    drawAgents(context, frame);
    if (layers.names) drawNames(context, frame);
    if (scene.minimumDistance > 0) {
      clashes.find(frame.places, scene.minimumDistance);
      drawClashes(context, frame, clashes, scene.minimumDistance, scene.stage.units);
    }
  };
}
