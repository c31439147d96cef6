import { expect, test } from "vitest";
import { brokenWords, fitWords, isPast, LINK_LIMITS, meterPlace, roundingWords, savingWords } from "./share-words";

test.each([
  [1200, "Pastes whole anywhere and fits a QR code."],
  [1201, "Pastes whole into Discord and Slack. Too long for a QR code."],
  [2000, "Pastes whole into Discord and Slack. Too long for a QR code."],
  [2001, "Pastes whole into Slack. Discord would cut it."],
  [4000, "Pastes whole into Slack. Discord would cut it."],
  [4001, "Any browser opens it. Discord and Slack would cut it, so send it by mail or save a file."],
])("a link of %d characters: %s", (characters, words) => {
  expect(fitWords(characters)).toBe(words);
});

test("no length is too long for a browser", () => {
  const browsers = LINK_LIMITS.find((limit) => limit.characters === null);
  expect(browsers && isPast(browsers, 10_000_000)).toBe(false);
});

test("a longer link stands further along the meter, and never beyond its ends", () => {
  const places = [1, 300, 900, 1200, 2000, 4000, 33_000, 500_000].map(meterPlace);
  expect(places).toEqual([...places].sort((a, b) => a - b));
  expect(places.at(0)).toBe(0);
  expect(places.at(-1)).toBe(1);
});

test.each([
  [1000, 999, null],
  [500, 401, null],
  [4000, 3650, null],
  [300, 400, null],
  [500, 400, "saves 100 characters by rounding positions"],
  [4000, 2500, "saves 1,500 characters by rounding positions"],
])("a shorter link is offered when it is worth it: %d and %d characters", (exact, short, words) => {
  expect(savingWords(exact, short)).toBe(words);
});

test.each([
  [0, "Positions are exact."],
  [0.0004, "Positions are rounded by less than 1 mm."],
  [0.0031, "Positions are rounded by up to 4 mm."],
  [0.017, "Positions are rounded by up to 2 cm."],
  [1.22, "Positions are rounded by up to 1.3 m."],
])("rounding by %d m is never understated", (meters, words) => {
  expect(roundingWords(meters)).toBe(words);
});

test("keyframes that rounding breaks are named, a few of them", () => {
  expect(brokenWords([], 0.5, "m")).toBe("");
  expect(brokenWords(["Opener"], 0.5, "m")).toBe("Rounded, agents come nearer than 0.50 m in Opener.");
  expect(brokenWords(["A", "B", "C", "D", "E"], 0.5, "m")).toBe(
    "Rounded, agents come nearer than 0.50 m in A, B, C and 2 more.",
  );
});
