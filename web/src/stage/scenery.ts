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

/** What scenery was made of. */
interface Ingredients {
  readonly from: Formation | null;
  readonly to: Formation | null;
  readonly here: TieList | null;
  readonly there: TieList | null;
  readonly cast: Cast;
}

/** Only where there is much room does a hull not cover the inside of a triangle; then there are not many agents. */
const FEW_TO_FILL = 60;
const NO_TRIANGLES = new Uint32Array(0);

/** Scenery of a segment, or of a keyframe where the agents stand; each is kept until what it is made of changes. */
export function createSceneryKeeper(): (
  track: Track,
  cast: Cast,
  ties: readonly (TieList | null)[],
  index: number,
  isMoving: boolean,
) => Scenery {
  const standing: (Scenery & Ingredients)[] = [];
  const moving: (Scenery & Ingredients)[] = [];
  return (track, cast, ties, index, isMoving) => {
    const from = track.keyframes[index]?.positions ?? null;
    const to = isMoving ? (track.keyframes[index + 1]?.positions ?? null) : null;
    const here = ties[index] ?? null;
    const there = isMoving ? (ties[index + 1] ?? null) : null;
    const all = isMoving ? moving : standing;
    const kept = all[index];
    const isSameWay = kept?.from === from && kept.to === to;
    if (isSameWay && kept.here === here && kept.there === there && kept.cast === cast) return kept;
    const bundles = from ? bundle(track, ties, index, from, to) : [];
    const hulls = cast.groups.map(({ color, agents }) => {
      const pairs = pairsWithin(bundles, agents);
      return { color, agents, pairs, triangles: agents.length <= FEW_TO_FILL ? trianglesOf(pairs) : NO_TRIANGLES };
    });
    const made = { from, to, here, there, cast, ties: bundles, hulls };
    all[index] = made;
    return made;
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
