import { mainTrack, type Scene } from "../document/scene";

/** All that a result depends on, by identity: equal inputs, same result. */
export type Inputs = readonly unknown[];

export function areSame(a: Inputs | undefined, b: Inputs): boolean {
  return a !== undefined && a.length === b.length && a.every((part, index) => Object.is(part, b[index]));
}

export function tieInputs(scene: Scene, keyframe: number): Inputs {
  const at = mainTrack(scene).keyframes[keyframe];
  return [at?.positions, at?.adjacency ?? scene.adjacency, scene.groups];
}

export function segmentInputs(scene: Scene, segment: number): Inputs {
  const { keyframes, segments } = mainTrack(scene);
  const from = keyframes[segment];
  const to = keyframes[segment + 1];
  return [
    ...tieInputs(scene, segment),
    ...tieInputs(scene, segment + 1),
    segments[segment],
    from && from.time + from.hold,
    to?.time,
    scene.frameRate,
    scene.minimumDistance,
  ];
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
