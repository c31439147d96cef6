import type { EngineProblem, SegmentReport } from "./api";
import type { Engine, InitInput, InitOutput } from "./pkg/engine.js";
import type { Answer, CallName, Calls, OpenedMessage, Question, SceneMessage } from "./protocol";

/** One engine in a worker: takes questions between the steps of the work at hand. */

/** Measuring waits for the motions of so many segments: one moved agent changes up to six. */
const MOVED_TOGETHER = 6;

interface Plan {
  readonly id: number;
  readonly held: string | undefined;
  readonly counterpart: string | undefined;
  readonly ties: number[];
  /** Segments to move, in order. */
  readonly unmoved: number[];
  /** Segments to measure, in order. */
  readonly unmeasured: number[];
}

let engine: Engine | null = null;
/** The plan under way; a newer one replaces it between two steps. */
let plan: Plan | null = null;
let isTurning = false;

export function post(answer: Answer, transfer: Transferable[] = []): void {
  self.postMessage(answer, { transfer });
}

/** A refusal carries its JSON; anything else is a trap and ends this worker. */
function problemOf(error: unknown): EngineProblem {
  if (typeof error === "string") return JSON.parse(error) as EngineProblem;
  throw error;
}

export function take(message: SceneMessage, to: Engine): void {
  for (const id of message.dropped) to.drop_formation(id);
  for (const [id, xy, heights] of message.added) to.put_formation(id, xy, heights);
  to.set_scene(message.rest ?? undefined, Uint32Array.from(message.formations));
}

type Answered<T> = T | Promise<T>;

/** What a worker answers, by name. */
export type Handlers<Own extends Engine> = {
  readonly [Name in CallName]?: (ask: Calls[Name]["ask"], to: Own, id: number) => Answered<Calls[Name]["answer"]>;
};

/** What every engine answers. */
export const basic: Handlers<Engine> & { cancel(ask: null, to: Engine): null } = {
  open: ({ text }, to) => JSON.parse(to.open(text) ?? "null") as OpenedMessage | null,
  writeScene: ({ scene }, to) => {
    take(scene, to);
    return to.write_scene();
  },
  link: ({ scene, isShort }, to) => {
    take(scene, to);
    return JSON.parse(to.link(isShort)) as Calls["link"]["answer"];
  },
  assign: ({ source, target }, to) => to.assign(source, target),
  places: ({ scene, segment, time }, to) => {
    take(scene, to);
    while (to.step(segment) < 1);
    return to.segment_places(time);
  },
  plan: (request, to, id) => {
    plan = null;
    take(request.scene, to);
    const { ties, order, held, counterpart } = request;
    const heldText = held.some(Boolean) ? JSON.stringify(held) : undefined;
    plan = {
      id,
      held: heldText,
      counterpart: counterpart ?? undefined,
      ties: [...ties],
      unmoved: [...order],
      unmeasured: [],
    };
    void turn();
    return null;
  },
  cancel: (_, to) => {
    plan = null;
    to.stop();
    return null;
  },
};

/** Lets waiting messages in, without a timer's four milliseconds. */
const gate = new MessageChannel();
gate.port1.start();
export function pause(): Promise<void> {
  return new Promise((resolve) => {
    gate.port1.addEventListener("message", () => resolve(), { once: true });
    gate.port2.postMessage(null);
  });
}

async function turn(): Promise<void> {
  if (isTurning) return;
  isTurning = true;
  try {
    while (plan && engine) {
      advance(plan, engine);
      await pause();
    }
  } catch (error) {
    crash(error);
  } finally {
    isTurning = false;
  }
}

/** One step of the plan: ties first, they are quick; then segments in the wanted order, a few motions before their numbers. */
function advance(at: Plan, to: Engine): void {
  const keyframe = at.ties.shift();
  if (keyframe !== undefined) {
    sendTies(at.id, keyframe, to);
    return;
  }
  const isMoving = at.unmoved.length > 0 && at.unmeasured.length < MOVED_TOGETHER;
  const queue = isMoving ? at.unmoved : at.unmeasured;
  const segment = queue[0];
  if (segment === undefined) {
    plan = null;
    post({ kind: "idle", plan: at.id });
    return;
  }
  try {
    const progress = to.step(segment, at.held, at.counterpart);
    if (isMoving && to.is_moved()) {
      sendMotion(at.id, segment, to);
      queue.shift();
      at.unmeasured.push(segment);
    }
    if (progress === 1) {
      sendNumbers(at.id, segment, to);
      at.unmeasured.splice(at.unmeasured.indexOf(segment), 1);
    } else {
      post({ kind: "progress", plan: at.id, segment, progress });
    }
  } catch (error) {
    queue.shift();
    post({ kind: "unplanned", plan: at.id, segment, problem: problemOf(error) });
  }
}

function sendTies(id: number, keyframe: number, to: Engine): void {
  try {
    const pairs = to.tie_pairs(keyframe);
    const factors = to.tie_factors(keyframe);
    post({ kind: "ties", plan: id, keyframe, pairs, factors }, [pairs.buffer, factors.buffer]);
  } catch (error) {
    // The segments at this keyframe report the same refusal, with their place.
    problemOf(error);
  }
}

function sendMotion(id: number, segment: number, to: Engine): void {
  const times = to.segment_times();
  const xy = to.segment_positions();
  const heights = to.segment_heights() ?? null;
  const transfer = [times.buffer, xy.buffer, ...(heights ? [heights.buffer] : [])];
  post({ kind: "moved", plan: id, segment, motion: { times, xy, heights } }, transfer);
}

function sendNumbers(id: number, segment: number, to: Engine): void {
  const curves = to.segment_curves();
  const report = JSON.parse(to.segment_report()) as SegmentReport;
  post({ kind: "measured", plan: id, segment, numbers: { curves, report } }, [curves.buffer]);
}

function crash(error: unknown): void {
  engine = null;
  plan = null;
  post({ kind: "crashed", message: error instanceof Error ? error.message : String(error) });
}

async function answer<Name extends CallName, Own extends Engine>(
  handlers: Handlers<Own>,
  to: Own,
  id: number,
  name: Name,
  ask: Calls[Name]["ask"],
): Promise<void> {
  try {
    try {
      const handler = handlers[name];
      if (!handler) throw new Error(`this engine does not answer ${name}`);
      post({ kind: "answer", id, value: await handler(ask, to, id) });
    } catch (error) {
      post({ kind: "refusal", id, problem: problemOf(error) });
    }
  } catch (error) {
    crash(error);
  }
}

/**
 * Holds a lock until this worker dies, however it dies: the page waits for the same one.
 *
 * The page asks as soon as it hears of the start, so the start waits for the lock: on a busy machine the page's
 * question would overtake this one, and a lock that comes free reads as a death.
 */
function hold(lock: string): Promise<void> {
  return new Promise((resolve) => {
    if (!navigator.locks) {
      resolve();
      return;
    }
    const held = () => {
      resolve();
      return new Promise<never>(() => {});
    };
    // A browser that blocks storage refuses locks, too; the page then hears of a crash, but not of a silent end.
    navigator.locks.request(lock, held).catch(() => resolve());
  });
}

/** Answers as an engine of one of the packages does. */
export function serve<Own extends Engine>(
  init: (input: { module_or_path: InitInput }) => Promise<InitOutput>,
  create: () => Own,
  handlers: Handlers<Own>,
): void {
  let own: Own | null = null;
  self.onmessage = async ({ data }: MessageEvent<Question>) => {
    if (data.kind === "call") {
      if (engine && own) void answer(handlers, own, data.id, data.name, data.ask);
      return;
    }
    try {
      await Promise.all([hold(data.lock), init({ module_or_path: data.module })]);
      own = create();
      engine = own;
      post({ kind: "started" });
    } catch (error) {
      crash(error);
    }
  };
}
