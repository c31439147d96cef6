import { beforeEach, expect, test, vi } from "vitest";
import type { Point } from "../document/formation";
import { toScreen, toStage } from "../stage/camera";
import { attachTools } from "./attach-tools";
import { type Bench, createBench, SQUARE } from "./test-bench";

/** As much of an element as the tools ask: it begins at (100, 50) of the page. */
class Stage extends EventTarget {
  readonly style = { cursor: "", touchAction: "", userSelect: "" };
  captured: number[] = [];
  getBoundingClientRect() {
    return { left: 100, top: 50 };
  }
  setPointerCapture(pointer: number) {
    this.captured.push(pointer);
  }
}

let bench: Bench;
let stage: Stage;
let now: number;
let detach: () => void;

beforeEach(() => {
  vi.stubGlobal("WheelEvent", { DOM_DELTA_PIXEL: 0 });
  bench = createBench(SQUARE);
  bench.view.size.value = { width: 1000, height: 800 };
  bench.view.camera.value = { scale: 40, left: 500, top: 400 };
  stage = new Stage();
  now = 0;
  detach = attachTools(stage as unknown as HTMLElement, bench.toolbox, bench.view, false);
});

function send(type: string, x: number, y: number, more: Record<string, unknown> = {}): Event {
  const event = new Event(type, { cancelable: true });
  now += 20;
  const fields = { clientX: x + 100, clientY: y + 50, button: 0, pointerId: 1, pointerType: "mouse", ...more };
  for (const [name, value] of Object.entries(fields)) Object.defineProperty(event, name, { value });
  Object.defineProperty(event, "timeStamp", { value: now });
  stage.dispatchEvent(event);
  return event;
}

const over = (at: Point): [number, number] => {
  const { x, y } = toScreen({ scale: 40, left: 500, top: 400 }, at);
  return [x, y];
};

const finger = (pointerId: number) => ({ pointerId, pointerType: "touch" });

test("a pointer on the stage works the tool in hand", () => {
  send("pointerdown", ...over([0, 0]));
  expect(stage.captured).toEqual([1]);
  send("pointermove", ...over([0, -1]));
  send("pointermove", ...over([-1.5, -2.5]));
  send("pointerup", ...over([-1.5, -2.5]));
  expect(bench.place(0)).toEqual([-1.5, -2.5]);
});

test("a capture that is lost gives the gesture up", () => {
  const start = bench.document.scene.value;
  send("pointerdown", ...over([0, 0]));
  send("pointermove", ...over([-1.5, -2.5]));
  send("pointercancel", ...over([-1.5, -2.5]));
  expect(bench.document.scene.value).toBe(start);
  expect(bench.document.isDragging.value).toBe(false);
});

test("the middle button pans under any tool, and so does Space held", () => {
  bench.toolbox.active.value = "draw";
  send("pointerdown", 10, 10, { button: 1 });
  send("pointermove", 40, 30);
  send("pointerup", 40, 30, { button: 1 });
  expect(bench.view.camera.value).toEqual({ scale: 40, left: 530, top: 420 });
  bench.toolbox.holdSpace();
  expect(stage.style.cursor).toBe("grab");
  send("pointerdown", 10, 10);
  send("pointermove", 0, 0);
  send("pointerup", 0, 0);
  expect(bench.toolbox.releaseSpace()).toBe(true);
  expect(bench.view.camera.value).toEqual({ scale: 40, left: 520, top: 410 });
  expect(bench.document.undoLabel.value).toBeNull();
});

test("Space that was only tapped did not pan", () => {
  bench.toolbox.holdSpace();
  expect(bench.toolbox.releaseSpace()).toBe(false);
});

test("the wheel zooms to the pointer and the page does not scroll", () => {
  const at = { x: 620, y: 310 };
  const before = toStage(bench.view.camera.value, at);
  const event = send("wheel", at.x, at.y, { deltaX: 0, deltaY: -400, deltaMode: 0 });
  expect(event.defaultPrevented).toBe(true);
  expect(bench.view.camera.value.scale).toBeCloseTo(80, 9);
  const after = toStage(bench.view.camera.value, at);
  expect(after[0]).toBeCloseTo(before[0], 9);
  expect(after[1]).toBeCloseTo(before[1], 9);
});

test("two fingers on a trackpad pan", () => {
  send("wheel", 300, 300, { deltaX: 12, deltaY: 7, deltaMode: 0 });
  expect(bench.view.camera.value).toEqual({ scale: 40, left: 488, top: 393 });
  send("wheel", 300, 300, { deltaX: 0, deltaY: 90, deltaMode: 0 });
  expect(bench.view.camera.value).toEqual({ scale: 40, left: 488, top: 303 });
});

test("a second finger gives the tool's gesture up, and the two pan and zoom", () => {
  const start = bench.document.scene.value;
  send("pointerdown", ...over([0, 0]), finger(1));
  send("pointermove", ...over([0, -2]), finger(1));
  expect(bench.document.scene.value).not.toBe(start);
  send("pointerdown", 700, 480, finger(2));
  expect(bench.document.scene.value).toBe(start);
  send("pointermove", 900, 480, finger(2));
  expect(bench.view.camera.value.scale).toBeCloseTo(80, 6);
  send("pointerup", 900, 480, finger(2));
  send("pointermove", ...over([3, 3]), finger(1));
  send("pointerup", ...over([3, 3]), finger(1));
  expect(bench.document.scene.value).toBe(start);
  expect(bench.document.isDragging.value).toBe(false);
});

test("two quick presses on one spot are a double one, two slow ones are not", () => {
  const sent = vi.spyOn(bench.toolbox, "send");
  const doubles = () => sent.mock.calls.flatMap(([event]) => (event.kind === "press" ? [event.isDouble] : []));
  for (let i = 0; i < 3; i += 1) {
    send("pointerdown", 300, 300);
    send("pointerup", 300, 300);
  }
  now += 1000;
  send("pointerdown", 300, 300);
  expect(doubles()).toEqual([false, true, false, false]);
});

test("a pointer that leaves hovers nobody", () => {
  send("pointermove", ...over([4, 0]));
  expect(bench.view.hovered.value).toBe(1);
  expect(stage.style.cursor).toBe("move");
  send("pointerleave", 0, 0);
  expect(bench.view.hovered.value).toBeNull();
});

test("once detached the stage is left alone", () => {
  detach();
  send("pointerdown", ...over([0, 0]));
  expect(bench.selected()).toEqual([]);
});
