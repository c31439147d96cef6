import { expect, test } from "vitest";
import { matchLabel } from "./palette-match";

const LABELS = [
  "Use method: Spectral",
  "Compare all methods side by side",
  "Add keyframe at the playhead",
  "Go to Smile",
];

function found(typed: string): string[] {
  return LABELS.flatMap((label) => {
    const match = matchLabel(label, typed);
    return match ? [{ label, score: match.score }] : [];
  })
    .sort((a, b) => a.score - b.score)
    .map(({ label }) => label);
}

test("nothing typed finds everything", () => {
  expect(found("")).toEqual(LABELS);
});

test("a word's start beats a word's middle", () => {
  expect(found("me")).toEqual([
    "Use method: Spectral",
    "Compare all methods side by side",
    "Add keyframe at the playhead",
  ]);
});

test("words are found in any order, and all of them must be there", () => {
  expect(found("spectral use")).toEqual(["Use method: Spectral"]);
  expect(found("spectral smile")).toEqual([]);
});

test("letter case does not matter", () => {
  expect(found("SMILE")).toEqual(["Go to Smile"]);
});

test.each(["me", "e", "use spec", "zz", ""])("the parts of a match for %j make the label again", (typed) => {
  for (const label of LABELS) {
    const match = matchLabel(label, typed);
    if (match) expect(match.parts.map((part) => part.text).join("")).toBe(label);
  }
});

test("what was typed is marked", () => {
  const match = matchLabel("Use method: Spectral", "me");
  expect(match?.parts.filter((part) => part.isMatch).map((part) => part.text)).toEqual(["me"]);
});
