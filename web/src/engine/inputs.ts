import { mainTrack, type Scene, type Segment } from "../document/scene";
import { isStop } from "../document/stops";
import { endsAround, stretchesOf } from "../document/stretches";

/** All that a result depends on, by identity: equal inputs, same result. */
export type Inputs = readonly unknown[];

export function areSame(a: Inputs | undefined, b: Inputs): boolean {
  return a !== undefined && a.length === b.length && a.every((part, index) => Object.is(part, b[index]));
}

export function tieInputs(scene: Scene, keyframe: number): Inputs {
  const at = mainTrack(scene).keyframes[keyframe];
  return [at?.positions, at?.absent, at?.adjacency ?? scene.adjacency, scene.groups];
}

/**
 * A transition's two keyframes and, where the agents pass them without a stop, those beyond: one on either side, two
 * where bases may be shared. So one moved agent changes two transitions, or four, or six.
 */
export function segmentInputs(scene: Scene, segment: number): Inputs {
  const track = mainTrack(scene);
  const { anchors, whole } = stretchesOf(track);
  if (whole === track) return wholeInputs(scene, segment);
  const [from, to] = endsAround(track, segment);
  const inputs = wholeInputs({ ...scene, tracks: [whole] }, anchors.indexOf(from));
  return to - from > 1 ? [...inputs, segment - from, ...partInputs(scene, from, to)] : inputs;
}

/** What bends a part of a transition: all that lies in it. */
function partInputs(scene: Scene, from: number, to: number): Inputs {
  const inputs: unknown[] = [];
  for (let keyframe = from; keyframe <= to; keyframe += 1) {
    inputs.push(
      ...tieInputs(scene, keyframe),
      mainTrack(scene).keyframes[keyframe]?.time,
      mainTrack(scene).keyframes[keyframe]?.between,
    );
  }
  return inputs;
}

function wholeInputs(scene: Scene, segment: number): Inputs {
  const track = mainTrack(scene);
  const passes = (keyframe: number) => !isStop(track, scene.join, keyframe);
  const beside = [passes(segment) ? segment - 1 : null, passes(segment + 1) ? segment + 1 : null];
  const specs = [segment, ...beside].map((index) => (index === null ? null : track.segments[index]));
  const reach = scene.join === "smooth" && specs.some((spec) => spec && mayShare(spec)) ? 2 : 1;
  let [first, last] = [segment, segment + 1];
  for (let step = 0; step < reach; step += 1) {
    if (passes(first)) first -= 1;
    if (passes(last)) last += 1;
  }
  const bodies = track.segments[segment]?.method === "crowd" ? [track.agents] : [];
  const inputs: unknown[] = [...specs, ...bodies, scene.frameRate, scene.minimumDistance, scene.obstacles, scene.seed];
  for (let keyframe = first; keyframe <= last; keyframe += 1) {
    const { time = 0, hold = 0 } = track.keyframes[keyframe] ?? {};
    // When the first and the last were reached and left does not matter, only how long it takes from one to the next.
    const moments = [keyframe > first ? time : null, keyframe < last ? time + hold : null];
    inputs.push(...tieInputs(scene, keyframe), ...moments);
  }
  if (last - first > 1) inputs.push(scene.join, scene.tension);
  return inputs;
}

/** Whether a transition's bases may move toward those of the keyframes beside. */
function mayShare({ method, sharing, chosen, crowd }: Segment): boolean {
  const choice = method === "auto" ? chosen : { method: method === "crowd" ? crowd.guide : method, sharing };
  return choice === null || (choice.method === "spectral" && choice.sharing > 0);
}

/** Segments by their distance from `time`, nearest first. */
export function nearestFirst(scene: Scene, time: number): number[] {
  const { keyframes, segments } = mainTrack(scene);
  const distance = (segment: number): number => {
    const from = keyframes[segment]?.time ?? 0;
    const to = keyframes[segment + 1]?.time ?? 0;
    return Math.max(0, from - time, time - to);
  };
  return segments.map((_, index) => index).sort((a, b) => distance(a) - distance(b) || a - b);
}
