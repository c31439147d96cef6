import { expect, test } from "vitest";
import { barAndCount, timeOfCount } from "./counts";
import { parseInstant, parseSpan } from "./parse";

const WALTZ = { beatsPerMinute: 180, beatsPerBar: 3, start: 2 };
const MARCH = { beatsPerMinute: 120, beatsPerBar: 4, start: 0 };

test.each([
  ["the first count", 2, "1.1"],
  ["just before the second", 2.33, "1.1"],
  ["the first of bar 2", 3, "2.1"],
  ["the third of bar 2", 3 + 2 / 3, "2.3"],
  ["the count before the first", 1.9, "0.3"],
  ["bars before that", 0, "−1.1"],
])("%s reads as bar and count", (_, time, expected) => {
  expect(barAndCount(WALTZ, time)).toBe(expected);
});

test("a time that was set to a count reads as that count, whatever its last bits", () => {
  for (let count = 0; count < 500; count += 1) {
    const time = Math.round(timeOfCount(WALTZ, count) * 1000) / 1000;
    expect(barAndCount({ ...WALTZ }, time)).toBe(`${1 + Math.floor(count / 3)}.${1 + (count % 3)}`);
  }
});

test.each([
  ["16 counts", 8],
  ["8 c", 4],
  ["1 count", 0.5],
  ["2 bars", 4],
  ["1 bar 2 counts", 3],
  ["1.5 bars", 3],
  ["8", 8],
  ["8 s", 8],
  ["1:02", 62],
])("%s is so long", (text, seconds) => {
  expect(parseSpan(text, MARCH)).toBeCloseTo(seconds, 9);
});

test.each(["", "many", "3 bars long", "−2 counts", "counts", "2 hours"])("%j is no length", (text) => {
  expect(parseSpan(text, MARCH)).toBeNull();
});

test.each([
  ["bar 1", 2],
  ["bar 2", 3],
  ["bar 2.3", 3 + 2 / 3],
  ["3 counts", 3],
  ["1 bar", 3],
  ["5.5", 5.5],
  ["0:05.5", 5.5],
])("%s is an instant", (text, seconds) => {
  expect(parseInstant(text, WALTZ)).toBeCloseTo(seconds, 9);
});

test.each(["bar", "bar 0", "bar 1.0", "bar 1.4", "later"])("%j is no instant", (text) => {
  expect(parseInstant(text, WALTZ)).toBeNull();
});
