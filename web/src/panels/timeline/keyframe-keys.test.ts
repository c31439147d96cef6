import { expect, test, vi } from "vitest";
import { type KeyframeHands, pressKey } from "./keyframe-keys";

function hands(isDragging = false) {
  const calls: unknown[] = [];
  const note =
    (name: string) =>
    (...args: unknown[]): void => {
      calls.push([name, ...args]);
    };
  const all: KeyframeHands = {
    count: 5,
    choose: note("choose"),
    extend: note("extend"),
    reorder: note("reorder"),
    remove: note("remove"),
    play: note("play"),
    cancelDrag: vi.fn(() => isDragging),
  };
  return { all, calls };
}

function press(key: string, index: number, held: Partial<KeyboardEvent> = {}) {
  const { all, calls } = hands();
  const isTaken = pressKey({ key, ...held } as KeyboardEvent, index, all);
  return { isTaken, calls };
}

test.each([
  ["ArrowRight", {}, ["choose", 3]],
  ["ArrowLeft", {}, ["choose", 1]],
  ["Home", {}, ["choose", 0]],
  ["End", {}, ["choose", 4]],
  ["ArrowRight", { shiftKey: true }, ["extend", 3]],
  ["End", { shiftKey: true }, ["extend", 4]],
  ["ArrowLeft", { altKey: true }, ["reorder", 2, 1]],
  ["Enter", {}, ["choose", 2]],
  [" ", {}, ["play"]],
  ["Delete", {}, ["remove", 2]],
])("%s with %j on the third of five keyframes does %j", (key, held, call) => {
  expect(press(key, 2, held)).toEqual({ isTaken: true, calls: [call] });
});

test("at the end arrows stay, and nothing is reordered past it", () => {
  expect(press("ArrowRight", 4).calls).toEqual([["choose", 4]]);
  expect(press("ArrowRight", 4, { shiftKey: true }).calls).toEqual([["extend", 4]]);
  expect(press("ArrowRight", 4, { altKey: true })).toEqual({ isTaken: true, calls: [] });
});

test("commands and other keys go on to the page", () => {
  expect(press("ArrowRight", 2, { ctrlKey: true }).isTaken).toBe(false);
  expect(press("k", 2).isTaken).toBe(false);
  expect(pressKey({ key: "Escape" } as KeyboardEvent, 2, hands(false).all)).toBe(false);
  expect(pressKey({ key: "Escape" } as KeyboardEvent, 2, hands(true).all)).toBe(true);
});
