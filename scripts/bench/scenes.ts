import { emptyScene, keyframeAt } from "../../web/src/document/defaults";
import { Formation } from "../../web/src/document/formation";
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

/** A show whose agents are strewn anew at every keyframe, `seconds` apart. */
export function strewnShow(agentCount: number, keyframeCount: number, seconds: number, method: MethodName): Scene {
  const scene = emptyScene();
  const keyframes = Array.from({ length: keyframeCount }, (_, k) => keyframeAt(k * seconds, strewn(agentCount, k + 1)));
  const agents = Array.from({ length: agentCount }, () => ({ name: "", color: "", radius: 0.25 }));
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
  } as const;
  const segments = Array.from({ length: keyframeCount - 1 }, () => segment);
  return { ...scene, tracks: [{ ...mainTrack(scene), agents, keyframes, segments }] };
}
