import type { TransitionOptions } from "../../document/commands/transitions";
import type { Alignment, Choice, MethodName, Order, Segment } from "../../document/scene";

/** What the options of a transition read, and which of them its method listens to. */
export interface OptionsShown {
  readonly order: Order;
  readonly alignment: Alignment;
  readonly sharing: number;
  readonly hasOrder: boolean;
  readonly hasAlignment: boolean;
  readonly hasSharing: boolean;
  readonly hasKeepSize: boolean;
}

/** @param choice what the motion was made by; null until it is known */
export function optionsShown(segment: Segment, choice: Choice | null): OptionsShown {
  const isAuto = segment.method === "auto";
  const source = isAuto && choice ? optionsOf(segment, choice) : segment;
  const method = guideOf(segment);
  const hears = (...methods: MethodName[]) => isAuto || methods.includes(method);
  return {
    order: source.order,
    alignment: source.alignment,
    sharing: source.sharing,
    hasOrder: hears("spectral"),
    hasAlignment: hears("spectral", "shared", "polar"),
    hasSharing: hears("spectral"),
    hasKeepSize: hears("spectral", "shared"),
  };
}

/** The method that reads the options: a crowd's is that of its guide. */
function guideOf(segment: Segment): MethodName {
  return segment.method === "crowd" ? segment.crowd.guide : segment.method;
}

/**
 * A changed option under auto makes the choice the person's: the method auto took if it listens to the option, else
 * spectral, with auto's other options.
 */
export function takenOver(
  segment: Segment,
  choice: Choice | null,
  change: Pick<TransitionOptions, "order" | "alignment" | "sharing">,
): TransitionOptions {
  if (segment.method !== "auto") return change;
  const isHeard = change.alignment !== undefined && choice !== null && choice.method !== "linear";
  return {
    method: isHeard ? choice.method : "spectral",
    ...(choice ? optionsOf(segment, choice) : {}),
    ...change,
  };
}

/** What a choice says of each option, and the segment's own word where its method does not use it. */
function optionsOf(segment: Segment, choice: Choice): Pick<Segment, "order" | "alignment" | "sharing"> {
  const isSpectral = choice.method === "spectral";
  return {
    order: isSpectral ? choice.order : segment.order,
    alignment: choice.method === "linear" ? segment.alignment : choice.alignment,
    sharing: isSpectral ? choice.sharing : segment.sharing,
  };
}
