import { settleHeights } from "./commands/heights";
import type { Face } from "./face";
import { Formation } from "./formation";
import type { Keyframe, Scene, Stage } from "./scene";

/**
 * A scene from the front: x and height are what x and y are from above, and the distance from the audience takes the place of
 * the height. Tools need to know nothing of it.
 */
export const front: Face = { shown, meant };

const formations = new WeakMap<Formation, Formation>();
const keyframes = new WeakMap<Keyframe, Keyframe>();
const scenes = new WeakMap<Scene, Scene>();
const stages = new WeakMap<Stage, Stage>();

/** Height and distance from the audience exchanged; exchanged twice it is the same object. */
function exchanged(formation: Formation): Formation {
  const known = formations.get(formation);
  if (known) return known;
  const xy = formation.xy.slice();
  const heights = Float64Array.from({ length: formation.agentCount }, (_, agent) => formation.y(agent));
  for (let agent = 0; agent < formation.agentCount; agent += 1) xy[2 * agent + 1] = formation.height(agent);
  return paired(formations, formation, new Formation(xy, heights));
}

function exchangedKeyframe(keyframe: Keyframe): Keyframe {
  const known = keyframes.get(keyframe);
  return known ?? paired(keyframes, keyframe, { ...keyframe, positions: exchanged(keyframe.positions) });
}

function paired<T extends object>(pairs: WeakMap<T, T>, one: T, other: T): T {
  pairs.set(one, other);
  pairs.set(other, one);
  return other;
}

function shown(scene: Scene): Scene {
  let seen = scenes.get(scene);
  if (!seen) {
    // Obstacles stand on the ground and have no height to show.
    seen = { ...scene, stage: upright(scene.stage), obstacles: [], tracks: exchangedTracks(scene) };
    scenes.set(scene, seen);
  }
  return seen;
}

function exchangedTracks({ tracks }: Scene): Scene["tracks"] {
  return tracks.map((track) => ({ ...track, keyframes: track.keyframes.map(exchangedKeyframe) }));
}

/** As high above the ground as below, since a stage lies about its middle; markings of a floor are not seen. */
function upright(stage: Stage): Stage {
  let seen = stages.get(stage);
  if (!seen) {
    seen = { ...stage, backdrop: "grid", depth: stage.height > 0 ? 2 * stage.height : stage.depth };
    stages.set(stage, seen);
  }
  return seen;
}

function meant(changed: Scene, before: Scene): Scene {
  const seen = shown(before);
  if (changed === seen) return before;
  return settleHeights({
    ...changed,
    stage: changed.stage === seen.stage ? before.stage : changed.stage,
    obstacles: before.obstacles,
    tracks: changed.tracks === seen.tracks ? before.tracks : exchangedTracks(changed),
  });
}
