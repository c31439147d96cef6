import { computed, type Signal, signal } from "@preact/signals";
import { beforeEach, expect, test } from "vitest";
import { addAgents } from "../document/commands/agents";
import { createDocument } from "../document/create-store";
import { emptyScene } from "../document/defaults";
import { Formation, type Point } from "../document/formation";
import { durationOf } from "../document/limits";
import { openScene } from "../document/open-scene";
import { mainTrack, type Scene } from "../document/scene";
import type { DocumentStore } from "../document/store";
import { createPlayback, type Playback } from "../playback/playback";
import { createView } from "../stage/create-view";
import type { Toolbox } from "../tools/toolbox";
import type { Actions } from "./actions";
import type { Aside } from "./aside";
import type { AgentClipboard } from "./clipboard-events";
import { createActions } from "./create-actions";
import { followPlayhead } from "./follow-playhead";
import { createHandiwork } from "./handiwork";
import { handiworkThrough } from "./later-handiwork";
import { createMessages, type Messages } from "./messages";

const FOUR: readonly Point[] = [
  [0, 0],
  [4, 0],
  [4, 3],
  [0, 3],
];

let document: DocumentStore;
let playback: Playback;
let messages: Messages;
let actions: Actions;
let clipboard: AgentClipboard;
let onClipboard: string;
let aside: Signal<Aside | null>;
let isComparing: boolean;
let fits: number;

/** The engine's answer to a keyframe CSV, by the book and no further. */
async function openCsv(text: string) {
  const rows = text.trim().split("\n").slice(1);
  const cells = rows.map((row) => row.split(",").map((cell) => cell.replaceAll('"', "")));
  const added = addAgents(
    cells.map((row): Point => [Number(row[5]), Number(row[6])]),
    "",
    cells.map((row) => ({ name: row[4] ?? "" })),
  );
  return { scene: added.apply(emptyScene()), source: "csv" as const, notes: [] };
}

beforeEach(() => {
  document = createDocument(addAgents(FOUR).apply(emptyScene()));
  playback = createPlayback(computed(() => durationOf(document.scene.value)));
  messages = createMessages();
  onClipboard = "";
  aside = signal(null);
  isComparing = false;
  fits = 0;
  const toolbox: Toolbox = {
    active: signal("select"),
    shape: signal("circle"),
    spacing: signal({ by: "count", count: 12 }),
    tieScope: signal("scene"),
    overlay: signal({ kind: "none" }),
    cursor: signal("default"),
    placeInMiddle: () => {},
    placeInView: () => {},
  };
  const nothing = () => {};
  const parts = {
    document,
    playback,
    view: {
      ...createView(document.scene),
      fit() {
        fits += 1;
      },
    },
    toolbox,
    messages,
    aside,
    engine: { open: openCsv },
    planner: { segments: signal([]), placesAt: () => Promise.reject(new Error("no engine is there")) },
    clipboard: {
      readText: async () => onClipboard,
      writeText: async (text: string) => {
        onClipboard = text;
      },
    },
    positionsAt: (time: number) => Formation.from(FOUR.map(([x, y]): Point => [x + time, y])),
    cancelGesture: () => false,
    files: {
      new: nothing,
      open: nothing,
      save: nothing,
      export: nothing,
      share: nothing,
      examples: nothing,
      help: nothing,
      palette: nothing,
      picture: nothing,
      text: nothing,
      compare: () => {
        isComparing = true;
      },
    },
  };
  const handiwork = createHandiwork(parts);
  clipboard = handiwork.clipboard;
  actions = createActions(
    parts,
    handiworkThrough(signal(handiwork), async () => handiwork, parts),
  );
  followPlayhead(document, playback);
});

const run = (id: string) => actions.get(id).run();
const isEnabled = (id: string) => actions.get(id).isEnabled?.value ?? true;
const keyframes = (scene: Scene = document.scene.value) => mainTrack(scene).keyframes;

test("adding keyframes by one key builds a show, and the playhead stands on the new one", () => {
  run("add-keyframe");
  run("add-keyframe");
  expect(keyframes().map((keyframe) => keyframe.time)).toEqual([0, 4, 8]);
  expect(playback.time.value).toBe(8);
  expect(document.selection.value).toEqual({ kind: "keyframe", index: 2 });
  expect(document.activeKeyframe.value).toBe(2);
});

test("a keyframe added under way captures what is seen there", () => {
  run("add-keyframe");
  playback.seek(1);
  run("add-keyframe");
  expect(keyframes().map((keyframe) => keyframe.time)).toEqual([0, 1, 4]);
  expect(keyframes()[1]?.positions.x(1)).toBe(5);
});

test("the playhead edits where it stands, and undoing a keyframe takes it back", () => {
  run("add-keyframe");
  playback.seek(0);
  expect(document.activeKeyframe.value).toBe(0);
  playback.seek(2);
  expect(document.activeKeyframe.value).toBe(0);
  playback.seek(4);
  expect(document.activeKeyframe.value).toBe(1);
  run("undo");
  expect(document.activeKeyframe.value).toBe(0);
  expect(playback.time.value).toBe(0);
});

test("the last keyframe cannot be deleted", () => {
  expect(isEnabled("delete-keyframe")).toBe(false);
  run("duplicate-keyframe");
  expect(isEnabled("delete-keyframe")).toBe(true);
  run("delete-keyframe");
  expect(keyframes()).toHaveLength(1);
});

test("undo and redo look at another scene as a whole, and leave the view where it is after an edit", () => {
  run("select-all");
  run("nudge-right");
  run("undo");
  expect(fits).toBe(0);
  const other = addAgents(FOUR.slice(1)).apply(emptyScene());
  openScene(document, { ...other, stage: { ...other.stage, width: 20 } }, "Open another");
  run("undo");
  expect(fits).toBe(1);
  run("redo");
  expect(fits).toBe(2);
});

test("holding an arrow key is one undo entry", () => {
  const start = document.scene.value;
  run("select-all");
  for (let i = 0; i < 7; i += 1) run("nudge-right");
  expect(keyframes()[0]?.positions.x(0)).toBeCloseTo(0.7, 12);
  run("undo");
  expect(document.scene.value).toBe(start);
});

test("copies are selected and stand beside what they were made of", () => {
  document.selection.value = { kind: "agents", agents: new Set([1]) };
  run("duplicate");
  expect(mainTrack(document.scene.value).agents).toHaveLength(5);
  expect(document.selection.value).toEqual({ kind: "agents", agents: new Set([4]) });
});

test("what is deleted depends on what is selected", () => {
  run("select-all");
  run("make-group");
  expect(document.selection.value).toEqual({ kind: "group", path: [0] });
  run("delete");
  expect(document.scene.value.groups).toEqual([]);
  expect(mainTrack(document.scene.value).agents).toHaveLength(4);
  document.selection.value = { kind: "tie", a: 0, b: 1 };
  run("delete");
  expect(document.scene.value.adjacency.cuts).toEqual([[0, 1]]);
  document.selection.value = { kind: "agents", agents: new Set([0, 1]) };
  run("delete");
  expect(mainTrack(document.scene.value).agents).toHaveLength(2);
  expect(isEnabled("delete")).toBe(false);
});

test("two selected agents are tied by key alone", () => {
  document.selection.value = { kind: "agents", agents: new Set([2, 0]) };
  run("tie-selected");
  expect(document.scene.value.adjacency.ties).toEqual([[0, 2, 10]]);
  expect(document.selection.value).toEqual({ kind: "tie", a: 0, b: 2 });
});

test("a formation copied at one keyframe is pasted into another", async () => {
  run("add-keyframe");
  document.selection.value = { kind: "agents", agents: new Set([0, 1, 2, 3]) };
  run("flip-horizontal");
  const text = clipboard.copied();
  run("add-keyframe");
  document.selection.value = { kind: "agents", agents: new Set([0, 1, 2, 3]) };
  run("rotate-left");
  await clipboard.paste(text);
  expect([...(keyframes()[2]?.positions.xy ?? [])]).toEqual([...(keyframes()[1]?.positions.xy ?? [])]);
  expect(document.undoLabel.value).toBe("Paste places");
});

test("pasting at the first keyframe brings new agents, named as they were", async () => {
  await clipboard.paste("Ada\t1\t2\n7\t3\t4");
  expect(mainTrack(document.scene.value).agents.map((agent) => agent.name)).toEqual(["", "", "", "", "Ada", ""]);
  expect(document.selection.value).toEqual({ kind: "agents", agents: new Set([4, 5]) });
});

test("pasting what is no table says what would be one", async () => {
  const scene = document.scene.value;
  await clipboard.paste("just words");
  expect(document.scene.value).toBe(scene);
  expect(messages.shown.value[0]?.text).toContain("tabs");
});

test("places for more agents than there are selected are refused with the reason", async () => {
  run("add-keyframe");
  await clipboard.paste("1\t2\n3\t4");
  expect(messages.shown.value[0]?.text).toContain("2 places were copied for 4 agents");
});

test("modes and a recording open beside the show, and comparing waits for a transition", () => {
  run("modes");
  expect(aside.value).toEqual({ kind: "modes" });
  run("recording");
  expect(aside.value).toEqual({ kind: "recording" });
  expect(actions.get("compare").isEnabled?.value).toBe(false);
  run("add-keyframe");
  expect(actions.get("compare").isEnabled?.value).toBe(true);
  run("compare");
  expect(isComparing).toBe(true);
});
