import { expect, test } from "vitest";
import { isPressed, type KeyPress } from "./key-match";
import { SHORTCUTS } from "./shortcuts";

function press(key: string, code: string, held: readonly ("ctrl" | "meta" | "shift" | "alt")[] = []): KeyPress {
  return {
    key,
    code,
    ctrlKey: held.includes("ctrl"),
    metaKey: held.includes("meta"),
    shiftKey: held.includes("shift"),
    altKey: held.includes("alt"),
  };
}

test("a letter is a shortcut alone, not with a modifier", () => {
  expect(isPressed(press("v", "KeyV"), "V", false)).toBe(true);
  expect(isPressed(press("V", "KeyV", ["shift"]), "V", false)).toBe(false);
  expect(isPressed(press("v", "KeyV", ["ctrl"]), "V", false)).toBe(false);
  expect(isPressed(press("v", "KeyV", ["alt"]), "V", false)).toBe(false);
});

test("Ctrl is Cmd on a Mac and nowhere else", () => {
  expect(isPressed(press("z", "KeyZ", ["ctrl"]), "Ctrl+Z", false)).toBe(true);
  expect(isPressed(press("z", "KeyZ", ["meta"]), "Ctrl+Z", true)).toBe(true);
  expect(isPressed(press("z", "KeyZ", ["ctrl"]), "Ctrl+Z", true)).toBe(false);
  expect(isPressed(press("z", "KeyZ", ["meta"]), "Ctrl+Z", false)).toBe(false);
});

test("undo is not redo", () => {
  expect(isPressed(press("Z", "KeyZ", ["ctrl", "shift"]), "Ctrl+Shift+Z", false)).toBe(true);
  expect(isPressed(press("Z", "KeyZ", ["ctrl", "shift"]), "Ctrl+Z", false)).toBe(false);
});

test("a letter is where the layout has it, and where it would be on a keyboard without Latin letters", () => {
  expect(isPressed(press("z", "KeyY", ["ctrl"]), "Ctrl+Z", false)).toBe(true);
  expect(isPressed(press("y", "KeyZ", ["ctrl"]), "Ctrl+Z", false)).toBe(false);
  expect(isPressed(press("я", "KeyZ", ["ctrl"]), "Ctrl+Z", false)).toBe(true);
});

test("a sign is found with Shift or without, a digit by its key", () => {
  expect(isPressed(press("?", "Slash", ["shift"]), "?", false)).toBe(true);
  expect(isPressed(press("?", "Minus", ["shift"]), "?", false)).toBe(true);
  expect(isPressed(press("+", "BracketRight"), "+", false)).toBe(true);
  expect(isPressed(press("!", "Digit1", ["shift"]), "Shift+1", false)).toBe(true);
});

test("no two actions have the same key", () => {
  const keys = Object.values(SHORTCUTS).flatMap((listed) => ("keys" in listed ? [...listed.keys] : []));
  expect(new Set(keys).size).toBe(keys.length);
});
