/** A part of a label, and whether it is what was typed. */
export interface Part {
  readonly text: string;
  readonly isMatch: boolean;
}

/** Words start here: what was typed counts most at a start. */
const BOUNDARY = /[\s:,+-]/;

/**
 * How a label answers what was typed, word by word in any order; null when a word is missing.
 *
 * @returns lower is better: matches at word starts come first, then early ones
 */
export function matchLabel(label: string, typed: string): { readonly score: number; readonly parts: Part[] } | null {
  const words = typed.toLowerCase().split(/\s+/).filter(Boolean);
  const lower = label.toLowerCase();
  const marked = new Array<boolean>(label.length).fill(false);
  let score = 0;
  for (const word of words) {
    const at = bestPlace(lower, word);
    if (at < 0) return null;
    marked.fill(true, at, at + word.length);
    score += (isStart(lower, at) ? 0 : 100) + at;
  }
  return { score, parts: partsOf(label, marked) };
}

function bestPlace(label: string, word: string): number {
  for (let at = label.indexOf(word); at >= 0; at = label.indexOf(word, at + 1)) {
    if (isStart(label, at)) return at;
  }
  return label.indexOf(word);
}

function isStart(label: string, at: number): boolean {
  return at === 0 || BOUNDARY.test(label[at - 1] ?? "");
}

function partsOf(label: string, marked: readonly boolean[]): Part[] {
  const parts: { text: string; isMatch: boolean }[] = [];
  for (const [index, isMatch] of marked.entries()) {
    const last = parts.at(-1);
    if (last?.isMatch === isMatch) last.text += label[index] ?? "";
    else parts.push({ text: label[index] ?? "", isMatch });
  }
  return parts;
}
