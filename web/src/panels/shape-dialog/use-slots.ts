import { useEffect, useState } from "preact/hooks";
import type { EngineProblem } from "../../engine/api";
import { createShaper } from "../../engine/create-shaper";
import type { ShapeAnswer, ShapeRequest } from "../../engine/shape-protocol";

/** Places in a shape. */
export type Slots =
  | { readonly kind: "none" }
  /** 0..1; the places before them are still shown. */
  | { readonly kind: "working"; readonly progress: number; readonly last: Float64Array | null }
  /** x, y each, about the origin; meters. */
  | { readonly kind: "here"; readonly xy: Float64Array }
  | { readonly kind: "refused"; readonly problem: EngineProblem };

/** The places asked for; a newer request takes the place of an older one. */
export function useSlots(request: ShapeRequest | null): Slots {
  const [shaper] = useState(createShaper);
  const [slots, setSlots] = useState<Slots>({ kind: "none" });
  useEffect(() => () => shaper.end(), [shaper]);
  useEffect(() => {
    if (!request) {
      setSlots({ kind: "none" });
      return;
    }
    let isWanted = true;
    setSlots((before) => ({ kind: "working", progress: 0, last: shownOf(before) }));
    shaper.ask(request, (answer) => isWanted && setSlots((before) => slotsAfter(before, answer)));
    return () => {
      isWanted = false;
    };
  }, [shaper, request]);
  return slots;
}

/** The places there are to see. */
export function shownOf(slots: Slots): Float64Array | null {
  if (slots.kind === "here") return slots.xy;
  return slots.kind === "working" ? slots.last : null;
}

function slotsAfter(before: Slots, answer: ShapeAnswer): Slots {
  switch (answer.kind) {
    case "progress":
      return { kind: "working", progress: answer.progress, last: shownOf(before) };
    case "slots":
      return { kind: "here", xy: answer.xy };
    case "refused":
      return { kind: "refused", problem: answer.problem };
  }
}
