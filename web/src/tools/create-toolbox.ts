import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import type { ToolParts } from "./create-editor";
import { NO_OVERLAY, type ToolEvent } from "./tool";
import type { ShapeName, Spacing, Toolbox, ToolName } from "./toolbox";
import type { createWorkbench, Workbench } from "./workbench";

/** A toolbox that hears the pointer. */
export interface ToolboxAtWork extends Toolbox {
  /** Fetches the tools, if they are not there yet; what is sent meanwhile waits for them. */
  wake(): Promise<void>;
  send(event: ToolEvent): void;
  /** Gives up the gesture under way; whether there was one. */
  cancel(): boolean;
  /** While it is held, the stage pans under any tool. */
  holdSpace(): void;
  /** Whether it was held to pan. */
  releaseSpace(): boolean;
  readonly isSpaceHeld: ReadonlySignal<boolean>;
  /** Called when a pan with Space held begins. */
  notePan(): void;
}

/** What was asked of the tools before they came, with the tool that was in hand. */
interface Wish {
  readonly tool: ToolName;
  ask(bench: Workbench): void;
}

/** Agents that a first stroke or shape makes. */
const FIRST_COUNT = 12;

/**
 * The tool in hand from the first moment; the tools themselves come when the pointer or a key first wants one,
 * unless `tools` brings them along.
 */
export function createToolbox(parts: ToolParts, tools?: typeof createWorkbench): ToolboxAtWork {
  const active = signal<ToolName>("select");
  const shape = signal<ShapeName>("circle");
  const spacing = signal<Spacing>({ by: "count", count: FIRST_COUNT });
  const tieScope = signal<"scene" | "keyframe">("scene");
  const isSpaceHeld = signal(false);
  const settings = { active, shape, spacing, tieScope };
  const bench = signal<Workbench | null>(tools?.(parts, settings) ?? null);
  let loading: Promise<void> | null = null;
  let waiting: Wish[] = [];
  let hasPanned = false;

  function wake(): Promise<void> {
    if (bench.peek()) return Promise.resolve();
    loading ??= import("./workbench").then((chunk) => {
      const ready = chunk.createWorkbench(parts, settings);
      bench.value = ready;
      const inHand = active.peek();
      for (const { tool, ask } of waiting) {
        active.value = tool;
        ask(ready);
      }
      active.value = inHand;
      waiting = [];
    }, retry);
    return loading;
  }

  function retry(error: unknown): void {
    loading = null;
    waiting = [];
    const why = error instanceof Error ? error.message : String(error);
    parts.warn("The tools could not be loaded.", `Check the connection and try again. (${why})`);
  }

  function whenReady(ask: (bench: Workbench) => void): void {
    const ready = bench.peek();
    if (ready) {
      ask(ready);
      return;
    }
    waiting.push({ tool: active.peek(), ask });
    void wake();
  }

  effect(() => {
    if (active.value !== "select") void wake();
  });

  return {
    ...settings,
    overlay: computed(() => bench.value?.overlay.value ?? NO_OVERLAY),
    cursor: computed(() => (isSpaceHeld.value ? "grab" : (bench.value?.cursor.value ?? "default"))),
    isSpaceHeld,
    wake,
    send(event) {
      // A pointer that only passes by leaves nothing to be done later.
      if (event.kind === "move" && !bench.peek() && waiting.length === 0) void wake();
      else whenReady((ready) => ready.send(event));
    },
    cancel() {
      const ready = bench.peek();
      const isAwaited = waiting.length > 0;
      if (isAwaited) whenReady((later) => later.cancel());
      return ready?.cancel() ?? isAwaited;
    },
    placeInMiddle: () => whenReady((ready) => ready.placeInMiddle()),
    placeInView: (places, label) => whenReady((ready) => ready.placeInView(places, label)),
    holdSpace() {
      isSpaceHeld.value = true;
      hasPanned = false;
    },
    releaseSpace() {
      isSpaceHeld.value = false;
      return hasPanned;
    },
    notePan() {
      hasPanned = true;
    },
  };
}
