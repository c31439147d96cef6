import { emptyScene, keyframeAt } from "../../web/src/document/defaults";
import { Formation } from "../../web/src/document/formation";
import { CROWD_DEFAULTS } from "../../web/src/document/generated";
import { type MethodName, mainTrack, type Scene } from "../../web/src/document/scene";

/** The same numbers as core-rs/bench: Numerical Recipes' linear congruential generator. */
function numbers(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    return state / 0xffff_ffff;
  };
}

/** Agents strewn over a square that leaves each about a square meter. */
export function strewn(agentCount: number, seed: number): Formation {
  const next = numbers(seed);
  const side = Math.sqrt(agentCount);
  return new Formation(Float64Array.from({ length: 2 * agentCount }, () => next() * side));
}

/** Two blocks of 44 × 22 agents that go through each other in 20 s and keep half a meter apart. */
export function crossingBlocks(): Scene {
  const [columns, rows, spacing] = [44, 22, 1.143];
  const gap = columns * spacing + 4;
  const block = (x: number) =>
    Array.from({ length: columns * rows }, (_, k) => [
      x + (k % columns) * spacing,
      Math.floor(k / columns) * spacing,
    ]).flat();
  const formation = (...from: number[]) => new Formation(Float64Array.from(from.flatMap(block)));
  const show = strewnShow(2 * columns * rows, 2, 20, "linear");
  const track = mainTrack(show);
  const keyframes = [keyframeAt(0, formation(0, gap)), keyframeAt(20, formation(gap, 0))];
  const segments = track.segments.map((segment) => ({ ...segment, avoidance: true }));
  return { ...show, minimumDistance: 0.5, tracks: [{ ...track, keyframes, segments }] };
}

/** A show whose agents are strewn anew at every keyframe, `seconds` apart, and stop there. */
export function strewnShow(agentCount: number, keyframeCount: number, seconds: number, method: MethodName): Scene {
  const scene = emptyScene();
  const keyframes = Array.from({ length: keyframeCount }, (_, k) => keyframeAt(k * seconds, strewn(agentCount, k + 1)));
  const agents = Array.from({ length: agentCount }, () => ({ name: "", color: "", radius: 0.25, maxSpeed: null }));
  const segment = {
    kind: "transition",
    method,
    chosen: null,
    order: "greedy",
    alignment: "procrustes",
    sharing: 0.5,
    keepSize: false,
    timing: "smooth",
    avoidance: false,
    hierarchy: false,
    nodes: [],
    path: null,
    crowd: CROWD_DEFAULTS,
    assignment: null,
  } as const;
  const segments = Array.from({ length: keyframeCount - 1 }, () => segment);
  return { ...scene, join: "separate", tracks: [{ ...mainTrack(scene), agents, keyframes, segments }] };
}

/** The same show so long that it takes `frameCount` frames, joined smoothly and kept apart: planned, avoided, measured. */
export function lasting(scene: Scene, frameCount: number): Scene {
  const track = mainTrack(scene);
  const last = track.keyframes.at(-1);
  const factor = (frameCount - 1) / scene.frameRate / (last ? last.time + last.hold : 1);
  const keyframes = track.keyframes.map((keyframe) => ({
    ...keyframe,
    time: keyframe.time * factor,
    hold: keyframe.hold * factor,
  }));
  const segments = track.segments.map((segment) => ({ ...segment, avoidance: true }));
  const minimumDistance = scene.minimumDistance > 0 ? scene.minimumDistance : 0.5;
  return { ...scene, join: "smooth", minimumDistance, tracks: [{ ...track, keyframes, segments }] };
}
