import type { EngineProblem } from "./api";
import init, { Shapes } from "./pkg/shapes.js";
import wasmUrl from "./pkg/shapes_bg.wasm?url";
import type { ShapeAnswer, ShapeQuestion } from "./shape-protocol";

/** Places in shapes, in a worker: what is asked last is worked on, and it hears of more between two steps. */

/** Milliseconds of work between two looks at what was asked meanwhile. */
const STEP = 40;

let asked: ShapeQuestion | null = null;
let isAtWork = false;

const coming = init({ module_or_path: wasmUrl }).then(() => new Shapes());

self.onmessage = ({ data }: MessageEvent<ShapeQuestion>) => {
  asked = data;
  void work();
};

function post(answer: ShapeAnswer): void {
  self.postMessage(answer);
}

async function work(): Promise<void> {
  if (isAtWork) return;
  isAtWork = true;
  while (asked) {
    const question = asked;
    try {
      await answer(await coming, question);
    } catch (error) {
      post({ kind: "refused", id: question.id, problem: problemOf(error) });
    }
    if (asked === question) asked = null;
  }
  isAtWork = false;
}

async function answer(shapes: Shapes, question: ShapeQuestion): Promise<void> {
  const { id, request } = question;
  const { width, rgba, threshold, isInverted, room, count, leastDistance, isOutline, seed } = request;
  shapes.read(width, new Uint8Array(rgba.buffer), threshold, isInverted, Float64Array.from(room));
  shapes.begin(count, leastDistance, isOutline, seed);
  while (asked === question) {
    const end = performance.now() + STEP;
    let progress = shapes.step();
    while (progress < 1 && performance.now() < end) progress = shapes.step();
    if (progress === 1) {
      post({ kind: "slots", id, xy: shapes.slots() });
      return;
    }
    post({ kind: "progress", id, progress });
    await pause();
  }
}

/** Lets waiting messages in, without a timer's four milliseconds. */
const gate = new MessageChannel();
function pause(): Promise<void> {
  return new Promise((resolve) => {
    gate.port1.onmessage = () => resolve();
    gate.port2.postMessage(null);
  });
}

/** A refusal is the engine's JSON. */
function problemOf(error: unknown): EngineProblem {
  if (typeof error === "string") return JSON.parse(error) as EngineProblem;
  return { code: "unexpected", what: error instanceof Error ? error.message : String(error), where: "" };
}
