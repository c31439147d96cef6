import { expect, test } from "vitest";
import { type Entry, findEntries } from "./palette-entries";

function entry(label: string, section: Entry["section"]): Entry {
  return { id: label, label, section, keys: undefined, run() {} };
}

const ENTRIES = [
  entry("Select", "Tools"),
  entry("Add keyframe", "Keyframes"),
  entry("Go to Smile", "Keyframes"),
  entry("Use method: Spectral", "Transition"),
  entry("Use method: Linear", "Transition"),
];

test("with nothing typed everything is listed, in the order of the help", () => {
  const found = findEntries(ENTRIES, "");
  expect(found.map(({ section }) => section)).toEqual(["Tools", "Keyframes", "Transition"]);
  expect(found.flatMap(({ entries }) => entries.map(({ label }) => label))).toEqual(ENTRIES.map(({ label }) => label));
});

test("the section with the best match comes first", () => {
  const found = findEntries(ENTRIES, "me");
  expect(found.map(({ section }) => section)).toEqual(["Transition", "Keyframes"]);
});

test("sections without a match are not shown", () => {
  expect(findEntries(ENTRIES, "smile").map(({ section }) => section)).toEqual(["Keyframes"]);
  expect(findEntries(ENTRIES, "nothing like it")).toEqual([]);
});
