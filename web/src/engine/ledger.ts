import { Formation } from "../document/formation";
import { mainTrack, type Scene } from "../document/scene";
import type { SceneMessage } from "./protocol";

/** A worker keeps this many formations beyond those of the scene at hand, so that undo and drag find theirs again. */
const SPARE_FORMATIONS = 64;

const formationNumbers = new WeakMap<Formation, number>();
let lastNumber = 0;

function numberOf(formation: Formation): number {
  let number = formationNumbers.get(formation);
  if (number === undefined) {
    lastNumber += 1;
    number = lastNumber;
    formationNumbers.set(formation, number);
  }
  return number;
}

const texts = new WeakMap<object, string>();

/** JSON of an immutable part, made once. */
function textOf(part: object): string {
  let text = texts.get(part);
  if (text === undefined) {
    text = JSON.stringify(part);
    texts.set(part, text);
  }
  return text;
}

/** The scene as a scene file without its head and positions; large unchanged parts cost a look-up. */
export function restOf(scene: Scene): string {
  const { groups, adjacency, tracks, obstacles, ...scalars } = scene;
  const track = mainTrack(scene);
  const keyframes = track.keyframes.map(({ positions: _, adjacency: own, ...keyframe }) => {
    const text = JSON.stringify(keyframe);
    return `${text.slice(0, -1)},"adjacency":${own ? textOf(own) : "null"}}`;
  });
  const head = JSON.stringify(scalars).slice(0, -1);
  const segments = track.segments.map(textOf);
  const flat = JSON.stringify(obstacles.map(({ name, shape }) => ({ name, ...shape })));
  return `${head},"groups":${textOf(groups)},"adjacency":${textOf(adjacency)},"obstacles":${flat},"agents":${textOf(track.agents)},"keyframes":[${keyframes}],"segments":[${segments}]}`;
}

/** What one worker was told, so that nothing is sent twice. */
export class Ledger {
  #rest: string | null = null;
  /** Numbers this worker holds, least recently used first. */
  readonly #held = new Set<number>();

  message(scene: Scene): SceneMessage {
    const rest = restOf(scene);
    const formations: number[] = [];
    const added: [number, Float64Array, Float64Array | null][] = [];
    for (const { positions } of mainTrack(scene).keyframes) {
      const number = numberOf(positions);
      formations.push(number);
      if (!this.#held.delete(number)) added.push([number, positions.xy, positions.heights]);
      this.#held.add(number);
    }
    const message = { rest: rest === this.#rest ? null : rest, formations, added, dropped: this.#forget(formations) };
    this.#rest = rest;
    return message;
  }

  #forget(used: readonly number[]): number[] {
    const limit = new Set(used).size + SPARE_FORMATIONS;
    const dropped: number[] = [];
    for (const number of this.#held) {
      if (this.#held.size <= limit) break;
      this.#held.delete(number);
      dropped.push(number);
    }
    return dropped;
  }
}

interface FlatPositions {
  readonly xy: number[];
  readonly heights: number[] | null;
}

interface SceneText {
  tracks: { keyframes: { positions: FlatPositions | Formation }[] }[];
}

/** A scene from the engine's own text: trusted, since it came through the door. */
export function sceneFrom(text: string): Scene {
  const scene = JSON.parse(text) as SceneText;
  for (const track of scene.tracks) {
    for (const keyframe of track.keyframes) {
      const { xy, heights } = keyframe.positions;
      keyframe.positions = new Formation(Float64Array.from(xy), heights && Float64Array.from(heights));
    }
  }
  return scene as unknown as Scene;
}
