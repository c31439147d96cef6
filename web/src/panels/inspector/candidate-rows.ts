import type { Candidate } from "../../engine/api";
import { alignmentWord, methodWord, orderWord } from "./words";

/** A line of the table auto decided from. */
export interface CandidateRow {
  readonly candidate: Candidate;
  readonly name: string;
  /** What sets it apart from others of its method: `Hungarian, PCA, 0.5`. */
  readonly detail: string;
}

/** The best of each method, best first; the chosen one always stands for its own. */
export function bestOfEach(candidates: readonly Candidate[]): CandidateRow[] {
  const best = new Map<string, Candidate>();
  for (const candidate of byScore(candidates)) {
    if (!best.has(candidate.method) || candidate.isChosen) best.set(candidate.method, candidate);
  }
  return byScore([...best.values()]).map(rowOf);
}

/** Every candidate, best first. */
export function allOfThem(candidates: readonly Candidate[]): CandidateRow[] {
  return byScore(candidates).map(rowOf);
}

/** Stable: equal scores keep the order in which they were tried, as auto does. */
function byScore(candidates: readonly Candidate[]): Candidate[] {
  return [...candidates].sort((a, b) => a.score - b.score);
}

function rowOf(candidate: Candidate): CandidateRow {
  const details = {
    spectral: `${orderWord(candidate.order)}, ${alignmentWord(candidate.alignment)}, ${candidate.sharing}`,
    shared: alignmentWord(candidate.alignment),
    polar: alignmentWord(candidate.alignment),
    linear: "",
    crowd: "",
    auto: "",
  };
  return { candidate, name: methodWord(candidate.method), detail: details[candidate.method] };
}
