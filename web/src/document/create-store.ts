import { batch, computed, effect, signal } from "@preact/signals";
import { followActiveKeyframe, followSelection } from "./follow";
import { type History, record, startHistory, stepBack, stepForward } from "./history";
import type { Scene } from "./scene";
import { NOTHING, type Selection } from "./selection";
import type { Command, DocumentStore, Gesture } from "./store";

/** A document that starts with `initial` and nothing to undo. */
export function createDocument(initial: Scene): DocumentStore {
  const history = signal<History>(startHistory(initial));
  const preview = signal<Scene | null>(null);
  const isDragging = signal(false);
  const accepted = computed(() => history.value.present);
  const scene = computed(() => preview.value ?? accepted.value);
  const selection = signal<Selection>(NOTHING);
  const activeKeyframe = signal(0);
  let open: Gesture | null = null;

  /** Changes what the scene is, and keeps what points into it pointing at the same things. */
  function change(apply: () => void): void {
    const before = scene.peek();
    batch(() => {
      apply();
      const after = scene.value;
      if (after === before) return;
      selection.value = followSelection(before, after, selection.peek());
      activeKeyframe.value = followActiveKeyframe(before, after, activeKeyframe.peek());
    });
  }

  function beginGesture(): Gesture {
    open?.commit();
    const start = history.peek().present;
    let label = "";
    const gesture: Gesture = {
      preview(command: Command) {
        if (open !== gesture) return;
        label = command.label;
        change(() => {
          preview.value = command.apply(start);
        });
      },
      commit() {
        end((shown) => {
          history.value = record(history.peek(), { label }, shown);
        });
      },
      cancel() {
        end(() => {});
      },
    };
    function end(settle: (shown: Scene) => void): void {
      if (open !== gesture) return;
      open = null;
      change(() => {
        settle(scene.peek());
        preview.value = null;
        isDragging.value = false;
      });
    }
    open = gesture;
    isDragging.value = true;
    return gesture;
  }

  /** What was under way becomes a step of its own, so that nothing shown is lost. */
  function step(next: (history: History) => History): void {
    open?.commit();
    change(() => {
      history.value = next(history.peek());
    });
  }

  effect(() => {
    const selected = selection.value;
    if (selected.kind === "keyframe") activeKeyframe.value = selected.index;
  });

  return {
    scene,
    accepted,
    undoLabel: computed(() => history.value.past.at(-1)?.label ?? null),
    redoLabel: computed(() => history.value.future.at(-1)?.label ?? null),
    isDragging,
    selection,
    activeKeyframe,
    beginGesture,
    start(first) {
      open?.cancel();
      step(() => startHistory(first));
    },
    perform(command) {
      step((past) => record(past, command, command.apply(past.present)));
    },
    undo() {
      step(stepBack);
    },
    redo() {
      step(stepForward);
    },
  };
}
