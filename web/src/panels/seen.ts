import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { type Face, seenThrough } from "../document/face";
import type { DocumentStore } from "../document/store";
import type { Planner, Planning } from "../engine/api";
import type { View } from "../stage/view";

/** A face with its motions. */
export interface Front extends Face {
  planning(planning: Planning): Planning;
}

/** What the stage shows and tools touch: the document and its motions as they are seen. */
export interface Seen {
  readonly document: DocumentStore;
  readonly planner: { readonly segments: ReadonlySignal<readonly Planning[]> };
}

/** From above, or through a face. */
export function createSeen(
  document: DocumentStore,
  planner: Pick<Planner, "segments">,
  front: ReadonlySignal<Front | null>,
): Seen {
  return {
    document: seenThrough(document, front),
    planner: {
      segments: computed(() => {
        const face = front.value;
        return face ? planner.segments.value.map((planning) => face.planning(planning)) : planner.segments.value;
      }),
    },
  };
}

/** The front for as long as the person asks for it; `load` fetches it, and the plan shows until then. */
export function frontWhenAsked(
  projection: View["projection"],
  load: () => Promise<Front>,
  failed: () => void,
): ReadonlySignal<Front | null> {
  const front = signal<Front | null>(null);
  effect(() => {
    if (projection.value !== "front") {
      front.value = null;
      return;
    }
    load().then(
      (loaded) => {
        if (projection.peek() === "front") front.value = loaded;
      },
      () => {
        projection.value = "plan";
        failed();
      },
    );
  });
  return front;
}
