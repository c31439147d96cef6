import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { Action, Actions } from "./actions";
import { attachKeyboard } from "./keyboard";
import { type ActionId, keysOf, SHORTCUTS } from "./shortcuts";

/** As much of an element as the keyboard asks: which selectors it is within. */
class Focus extends EventTarget {
  constructor(private readonly kinds: readonly string[]) {
    super();
  }
  closest(selector: string): Focus | null {
    const asked = selector.split(",").map((part) => part.trim());
    return this.kinds.some((kind) => asked.includes(kind)) ? this : null;
  }
}

const BODY = new Focus([]);
const TEXT = new Focus(["input"]);
const GRID = new Focus(["[role=grid]"]);
const BUTTON = new Focus(["button"]);
const SLIDER = new Focus(["input", "input[type=range]"]);
const DIALOG = new Focus(["dialog"]);

let page: EventTarget;
let done: string[];
let hasPanned: boolean;
let isAwaited: boolean;

beforeEach(() => {
  vi.stubGlobal("Element", Focus);
  page = new EventTarget();
  done = [];
  hasPanned = false;
  isAwaited = false;
  const all = (Object.keys(SHORTCUTS) as ActionId[]).map((id): Action => {
    return { id, label: id, section: "Edit", keys: keysOf(id), run: () => done.push(id) };
  });
  const actions: Actions = { all, get: (id) => all.find((action) => action.id === id) ?? all[0] ?? never() };
  attachKeyboard(page as Window, {
    actions,
    isMac: false,
    holdSpace: () => {},
    releaseSpace: () => hasPanned,
    typeAhead: () => isAwaited,
  });
});

afterEach(() => vi.unstubAllGlobals());

function never(): never {
  throw new Error("no actions");
}

function key(
  type: "keydown" | "keyup",
  name: string,
  target: Focus,
  held: { ctrl?: boolean; repeat?: boolean } = {},
): Event {
  const event = new Event(type, { cancelable: true });
  Object.defineProperties(event, {
    target: { value: target },
    key: { value: name },
    code: { value: name === " " ? "Space" : /^[a-z]$/.test(name) ? `Key${name.toUpperCase()}` : name },
    ctrlKey: { value: held.ctrl ?? false },
    metaKey: { value: false },
    shiftKey: { value: false },
    altKey: { value: false },
    repeat: { value: held.repeat ?? false },
  });
  page.dispatchEvent(event);
  return event;
}

test("a letter picks a tool on the stage, and is a letter in a text field and in the agents' table", () => {
  key("keydown", "d", BODY);
  key("keydown", "d", TEXT);
  key("keydown", "d", GRID);
  expect(done).toEqual(["tool-draw"]);
});

test("saving works from anywhere, undo belongs to a text field that has the focus", () => {
  expect(key("keydown", "s", TEXT, { ctrl: true }).defaultPrevented).toBe(true);
  expect(key("keydown", "z", TEXT, { ctrl: true }).defaultPrevented).toBe(false);
  key("keydown", "z", GRID, { ctrl: true });
  expect(done).toEqual(["save", "undo"]);
});

test("Space plays, and presses the button that has the focus", () => {
  key("keydown", " ", BODY);
  key("keydown", " ", BODY, { repeat: true });
  expect(done).toEqual([]);
  key("keyup", " ", BODY);
  expect(done).toEqual(["play"]);
  expect(key("keydown", " ", BUTTON).defaultPrevented).toBe(false);
  key("keyup", " ", BUTTON);
  expect(done).toEqual(["play"]);
});

test("Enter places the shape in hand, and presses the button that has the focus", () => {
  key("keydown", "Enter", BODY);
  expect(key("keydown", "Enter", BUTTON).defaultPrevented).toBe(false);
  expect(done).toEqual(["place-in-middle"]);
});

test("Space that was held to pan does not play", () => {
  key("keydown", " ", BODY);
  hasPanned = true;
  key("keyup", " ", BODY);
  expect(done).toEqual([]);
});

test("arrows steer a slider that has the focus and nudge otherwise", () => {
  key("keydown", "ArrowLeft", SLIDER);
  key("keydown", "d", SLIDER);
  key("keydown", "ArrowLeft", BODY);
  expect(done).toEqual(["tool-draw", "nudge-left"]);
});

test("a dialog has the keys to itself", () => {
  key("keydown", "d", DIALOG);
  key("keydown", "Escape", DIALOG);
  expect(done).toEqual([]);
});

test("copying and pasting is left to the browser, which brings the clipboard along", () => {
  expect(key("keydown", "c", BODY, { ctrl: true }).defaultPrevented).toBe(false);
  expect(key("keydown", "v", BODY, { ctrl: true }).defaultPrevented).toBe(false);
  expect(done).toEqual([]);
});

test("keys for a dialog that is on its way do nothing to the scene", () => {
  isAwaited = true;
  const typed = key("keydown", "k", BODY);
  key("keydown", "Delete", BODY);
  key("keydown", " ", BODY);
  key("keyup", " ", BODY);
  expect(done).toEqual([]);
  expect(typed.defaultPrevented).toBe(true);
});
