import type { Formation } from "../document/formation";
import type { Track } from "../document/scene";
import type { TieList } from "../engine/api";
import type { Cast } from "./cast";
import type { HullShape } from "./layers/hulls";
import { neighborSpacing, transitionSpacing } from "./spacing";
import { bundleTies, pairsWithin, type TieBundle, trianglesOf } from "./ties";

/** What a stretch of the show is drawn with, beside the places of its agents. */
export interface Scenery {
  /** Empty while the ties are not known. */
  readonly ties: readonly TieBundle[];
  /** One a group, in the cast's order. */
  readonly hulls: readonly HullShape[];
}

/** Only where there is much room does a hull not cover the inside of a triangle; then there are not many agents. */
const FEW_TO_FILL = 60;
const NO_TRIANGLES = new Uint32Array(0);

/** Scenery of a segment, or of a keyframe where the agents stand; kept until what it is made of changes. */
export function createSceneryKeeper(): (
  track: Track,
  cast: Cast,
  ties: readonly (TieList | null)[],
  index: number,
  isMoving: boolean,
) => Scenery {
  let key: readonly unknown[] = [];
  let kept: Scenery = { ties: [], hulls: [] };
  return (track, cast, ties, index, isMoving) => {
    const from = track.keyframes[index]?.positions ?? null;
    const to = isMoving ? (track.keyframes[index + 1]?.positions ?? null) : null;
    const nextKey = [from, to, ties[index], isMoving ? ties[index + 1] : null, cast];
    if (nextKey.every((part, k) => part === key[k]) && key.length > 0) return kept;
    key = nextKey;
    const bundles = from ? bundle(track, ties, index, from, to) : [];
    kept = {
      ties: bundles,
      hulls: cast.groups.map(({ color, agents }) => {
        const pairs = pairsWithin(bundles, agents);
        return { color, agents, pairs, triangles: agents.length <= FEW_TO_FILL ? trianglesOf(pairs) : NO_TRIANGLES };
      }),
    };
    return kept;
  };
}

function bundle(
  track: Track,
  ties: readonly (TieList | null)[],
  index: number,
  from: Formation,
  to: Formation | null,
): TieBundle[] {
  const here = ties[index];
  const there = ties[index + 1];
  const end = to && there ? { ties: there, formation: to } : null;
  const spacing = to ? transitionSpacing(track, index) : neighborSpacing(from);
  if (here) return bundleTies({ ties: here, formation: from }, end, spacing);
  return end ? bundleTies(end, null, spacing) : [];
}
