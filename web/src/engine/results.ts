import { mainTrack, type Scene } from "../document/scene";
import { SegmentMotion } from "../playback/motion";
import type { Planning, SegmentPlan } from "./api";
import type { MotionData, NumbersData } from "./protocol";

/** What a worker sends, as the page reads it, and what serves of an earlier scene. */

type Meanwhile = Pick<Extract<Planning, { kind: "planning" }>, "motion" | "stale">;

export function planOf(result: Planning): SegmentPlan | null {
  if (result.kind === "ready") return result.plan;
  return result.kind === "planning" ? result.stale : null;
}

/** The last motion and its numbers serve meanwhile only if they are of the same agents. */
export function meanwhile(result: Planning | undefined, scene: Scene): Meanwhile {
  const stale = result ? planOf(result) : null;
  const motion = result?.kind === "planning" ? result.motion : (stale?.motion ?? null);
  return {
    motion: motion && movesAll(motion, scene) ? motion : null,
    stale: stale && movesAll(stale.motion, scene) ? stale : null,
  };
}

export function movesAll(motion: SegmentMotion, scene: Scene): boolean {
  return motion.agentCount === mainTrack(scene).agents.length;
}

export function motionFrom({ times, xy, heights }: MotionData): SegmentMotion {
  return new SegmentMotion(times, xy, times.length === 0 ? 0 : xy.length / 2 / times.length, heights);
}

export function numbersFrom({ curves, report }: NumbersData, motion: SegmentMotion): Omit<SegmentPlan, "motion"> {
  const sampleCount = motion.times.length;
  const curve = (row: number): Float32Array => curves.subarray(row * sampleCount, (row + 1) * sampleCount);
  return {
    report,
    curves: {
      clearance: curve(0),
      distortion: curve(1),
      turning: curve(2),
      topSpeed: curve(3),
      pathLength: curve(4),
    },
  };
}
