import { effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { Formation } from "../document/formation";
import { mainTrack, type Scene } from "../document/scene";
import type { SegmentMotion } from "../playback/motion";
import type { Counterpart, Planner, Planning, TieList } from "./api";
import type { Crew } from "./crew";
import { areSame, type Inputs, nearestFirst, segmentInputs, tieInputs } from "./inputs";
import type { WorkerLink } from "./link";
import type { PlanMessage, PlanRequest } from "./protocol";
import { meanwhile, motionFrom, movesAll, numbersFrom, planOf } from "./results";

/** A worker that has not heard a cancel after this many milliseconds is in one long step: it is replaced. */
const CANCEL_PATIENCE = 300;

export interface PlannerInputs {
  readonly scene: ReadonlySignal<Scene>;
  readonly isDragging: ReadonlySignal<boolean>;
  readonly time: ReadonlySignal<number>;
  readonly crew: Pick<Crew, "planner" | "replacePlanner">;
  /** What moves all segments in place of what the scene says; none by default. */
  readonly counterpart?: Counterpart | null;
}

/** What is known of a segment or keyframe, and of which inputs. */
interface Known<Result> {
  readonly inputs: Inputs;
  readonly result: Result;
  /** Planned while dragging, with auto's earlier choice: to be chosen again on release. */
  readonly isProvisional?: boolean;
}

/** One request to the worker, until it is idle or replaced. */
interface Errand {
  readonly link: WorkerLink;
  id: number;
  readonly held: PlanRequest["held"];
  readonly segments: ReadonlyMap<number, Inputs>;
  readonly ties: ReadonlyMap<number, Inputs>;
  /** Motions whose numbers are to come. */
  readonly moved: Map<number, SegmentMotion>;
}

/** A segment that takes the engine down with it so many times is not tried again by itself. */
const CRASH_LIMIT = 2;

const WAITING: Planning = { kind: "planning", progress: 0, motion: null, isCurrent: false, stale: null };

export function createPlanner({ scene, isDragging, time, crew, counterpart = null }: PlannerInputs): Planner {
  const segments = signal<readonly Planning[]>([]);
  const ties = signal<readonly (TieList | null)[]>([]);
  const progress = signal<number | null>(null);
  let knownSegments: readonly (Known<Planning> | undefined)[] = [];
  let knownTies: readonly (Known<TieList> | undefined)[] = [];
  let errand: Errand | null = null;
  /** While dragging the errand under way ends before the newest scene is sent: else none would ever end. */
  let isBehind = false;
  /** Crashes by the inputs of the segment that was under way. */
  const crashes = new Map<number, { readonly inputs: Inputs; count: number }>();

  function publish(): void {
    segments.value = knownSegments.map((known) => known?.result ?? WAITING);
    ties.value = knownTies.map((known) => known?.result ?? null);
    const open = segments.peek().filter((state) => state.kind === "planning");
    const share = open.reduce((sum, state) => sum + 1 - (state.kind === "planning" ? state.progress : 0), 0);
    progress.value = open.length === 0 ? null : 1 - share / Math.max(1, segments.peek().length);
  }

  /** Keep what still holds; what changed is planned anew, its last motion shown meanwhile. */
  function compare(to: Scene): void {
    const { keyframes, segments: wanted } = mainTrack(to);
    knownSegments = wanted.map((_, index) => {
      const known = knownSegments[index];
      const inputs = segmentInputs(to, index);
      const isCurrent = known !== undefined && areSame(known.inputs, inputs);
      const isFinal = isDragging.peek() || !known?.isProvisional;
      if (isCurrent && isFinal) return known;
      return { inputs, result: { kind: "planning", progress: 0, isCurrent, ...meanwhile(known?.result, to) } };
    });
    knownTies = keyframes.map((_, index) => {
      const known = knownTies[index];
      return known && areSame(known.inputs, tieInputs(to, index)) ? known : undefined;
    });
  }

  function refresh(): void {
    const link = crew.planner.peek();
    const to = scene.peek();
    compare(to);
    if (!link) {
      if (errand) blame(errand);
      errand = null;
      publish();
      return;
    }
    if (errand && isDragging.peek()) {
      isBehind = true;
      publish();
      return;
    }
    send(link, to);
    publish();
  }

  /** The engine died on an errand: the segment it was at is given up when it happens again. */
  function blame(lost: Errand): void {
    for (const [index, inputs] of lost.segments) {
      if (knownSegments[index]?.result.kind !== "planning") continue;
      const known = crashes.get(index);
      const count = known && areSame(known.inputs, inputs) ? known.count + 1 : 1;
      crashes.set(index, { inputs, count });
      if (count >= CRASH_LIMIT) {
        const what = "The engine stopped twice while it planned this transition.";
        settle(index, inputs, { kind: "failed", problem: { code: "engine-stopped", what, where: "" } });
      }
      return;
    }
  }

  function send(link: WorkerLink, to: Scene): void {
    isBehind = false;
    const open = nearestFirst(to, time.peek()).filter((index) => knownSegments[index]?.result.kind === "planning");
    const unknownTies = knownTies.flatMap((known, index) => (known ? [] : [index]));
    if (open.length === 0 && unknownTies.length === 0) {
      errand = null;
      return;
    }
    const held = isDragging.peek() ? heldChoices() : [];
    const next: Errand = {
      link,
      id: 0,
      held,
      segments: new Map(open.map((index) => [index, segmentInputs(to, index)])),
      ties: new Map(unknownTies.map((index) => [index, tieInputs(to, index)])),
      moved: new Map(),
    };
    const request: PlanRequest = {
      scene: link.ledger.message(to),
      order: open,
      held,
      ties: unknownTies,
      counterpart,
    };
    const call = link.call("plan", request);
    next.id = call.id;
    errand = next;
    call.answer.catch((error: unknown) => {
      // A refused scene cannot come from the page's own commands; a dead worker is replaced and asked again.
      if (errand === next) errand = null;
      if (!link.isDead) fail(next, error);
    });
  }

  function fail(of: Errand, error: unknown): void {
    const what = error instanceof Error ? error.message : String(error);
    for (const [index, inputs] of of.segments) {
      settle(index, inputs, { kind: "failed", problem: { code: "refused", what, where: "" } });
    }
    publish();
  }

  /** While dragging, auto keeps what it chose; it chooses again on release. */
  function heldChoices(): PlanRequest["held"] {
    return knownSegments.map((known) => {
      const plan = known && planOf(known.result);
      return plan && plan.report.candidates.length > 0 ? plan.report.choice : null;
    });
  }

  function settle(index: number, inputs: Inputs, result: Planning, isProvisional = false): void {
    const known = knownSegments[index];
    if (!known || !areSame(known.inputs, inputs)) return;
    knownSegments = knownSegments.with(index, { inputs, result, isProvisional });
  }

  function hear(link: WorkerLink, message: PlanMessage): void {
    if (!errand || errand.link !== link || errand.id !== message.plan) return;
    if (message.kind === "idle") {
      errand = null;
      if (isBehind) refresh();
    } else if (message.kind === "ties") {
      const inputs = errand.ties.get(message.keyframe);
      if (!inputs || !areSame(tieInputs(scene.peek(), message.keyframe), inputs)) return;
      knownTies = knownTies.with(message.keyframe, {
        inputs,
        result: { pairs: message.pairs, factors: message.factors },
      });
    } else {
      hearSegment(errand, message);
    }
    publish();
  }

  function hearSegment(of: Errand, message: Exclude<PlanMessage, { kind: "idle" | "ties" }>): void {
    const inputs = of.segments.get(message.segment);
    const known = knownSegments[message.segment];
    if (!inputs || !known) return;
    switch (message.kind) {
      case "progress":
        if (known.result.kind === "planning") {
          settle(message.segment, inputs, { ...known.result, progress: message.progress });
        }
        break;
      case "unplanned":
        settle(message.segment, inputs, { kind: "failed", problem: message.problem });
        break;
      case "moved": {
        const motion = motionFrom(message.motion);
        of.moved.set(message.segment, motion);
        // Dragged on since, its ways are shown until the newest arrives.
        if (known.result.kind === "planning" && movesAll(motion, scene.peek())) {
          replace(message.segment, { ...known.result, motion, isCurrent: areSame(known.inputs, inputs) });
        }
        break;
      }
      case "measured": {
        const motion = of.moved.get(message.segment);
        if (!motion) return;
        of.moved.delete(message.segment);
        const plan = { motion, ...numbersFrom(message.numbers, motion) };
        if (areSame(known.inputs, inputs)) {
          // Its neighbors' choices bend it where they meet.
          const isHeld = [-1, 0, 1].some((beside) => Boolean(of.held[message.segment + beside]));
          settle(message.segment, inputs, { kind: "ready", plan }, isHeld);
        } else if (known.result.kind === "planning" && movesAll(motion, scene.peek())) {
          replace(message.segment, { ...known.result, stale: plan });
        }
        break;
      }
    }
  }

  /** Another state of what is still to be planned. */
  function replace(index: number, result: Planning): void {
    const known = knownSegments[index];
    if (known) knownSegments = knownSegments.with(index, { inputs: known.inputs, result });
  }

  effect(() => {
    const link = crew.planner.value;
    if (link) link.onPlan = (message) => hear(link, message);
    scene.value;
    isDragging.value;
    untracked(refresh);
  });

  return {
    segments,
    ties,
    progress,
    async placesAt(of, segment, at) {
      const link = crew.planner.peek();
      if (!link) throw new Error("no engine is there");
      const found = await link.call("places", { scene: link.ledger.message(of), segment, time: at }).answer;
      const count = 2 * mainTrack(of).agents.length;
      return new Formation(found.slice(0, count), found.length > count ? found.slice(count) : null);
    },
    cancel() {
      errand = null;
      isBehind = false;
      knownSegments = knownSegments.map((known) =>
        known?.result.kind === "planning" ? { inputs: known.inputs, result: { kind: "canceled" } } : known,
      );
      publish();
      const link = crew.planner.peek();
      if (!link) return;
      const timer = setTimeout(() => crew.replacePlanner(), CANCEL_PATIENCE);
      link.call("cancel", null).answer.then(
        () => clearTimeout(timer),
        () => clearTimeout(timer),
      );
    },
    resume() {
      knownSegments = knownSegments.map((known) =>
        known && (known.result.kind === "canceled" || known.result.kind === "failed")
          ? { inputs: known.inputs, result: WAITING }
          : known,
      );
      refresh();
    },
  };
}
