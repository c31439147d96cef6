import type { Alignment, Join, MethodName, Order, Timing } from "../../document/scene";

export type PlainMethod = Exclude<MethodName, "auto" | "crowd">;

interface Word<T extends string> {
  readonly value: T;
  readonly label: string;
}

export const METHODS: readonly Word<MethodName>[] = [
  { value: "auto", label: "Auto" },
  { value: "spectral", label: "Spectral" },
  { value: "shared", label: "Shared" },
  { value: "polar", label: "Polar" },
  { value: "linear", label: "Linear" },
  { value: "crowd", label: "Crowd" },
];

/** Methods that need no choosing and follow no other: of groups, and of a crowd's guide. */
export const PLAIN_METHODS = METHODS.filter(
  (word): word is Word<PlainMethod> => word.value !== "auto" && word.value !== "crowd",
);

/** A word that needs a few more, which stand by the control. */
type NotedWord<T extends string> = Word<T> & { readonly note: string };

/** How the modes of one formation are paired with those of the next. */
export const ORDERS: readonly NotedWord<Order>[] = [
  { value: "eigenvalue", label: "Eigenvalue", note: "coarse to fine" },
  { value: "greedy", label: "Greedy", note: "likest modes first" },
  { value: "maxmin", label: "Max-min", note: "no pair unlike" },
  { value: "hungarian", label: "Hungarian", note: "likest in all" },
];

/** Which turn is taken out before the modes find their own. */
export const ALIGNMENTS: readonly NotedWord<Alignment>[] = [
  { value: "none", label: "None", note: "no common turn" },
  { value: "pca", label: "PCA", note: "turn by main axes" },
  { value: "procrustes", label: "Procrustes", note: "turn by best fit" },
];

export const TIMINGS: readonly NotedWord<Timing>[] = [
  { value: "smooth", label: "Smooth", note: "soft at stops" },
  { value: "linear", label: "Linear", note: "no easing" },
  { value: "even", label: "Even", note: "steady, may step at keyframes" },
];

export const JOINS: readonly (Word<Join> & { readonly text: string })[] = [
  {
    value: "separate",
    label: "Separate",
    text: "Every keyframe is a stop: agents slow down into it and start anew.",
  },
  {
    value: "smooth",
    label: "Smooth",
    text: "Agents pass keyframes in one sweep and stop only where one holds or is a corner.",
  },
  {
    value: "product",
    label: "Product",
    text: "The published formula: transitions act one upon the other, all at once.",
  },
];

export function methodWord(method: MethodName): string {
  return METHODS.find((word) => word.value === method)?.label ?? method;
}

export function orderWord(order: Order): string {
  return ORDERS.find((word) => word.value === order)?.label ?? order;
}

export function orderNote(order: Order): string {
  return noteOf(ORDERS, order);
}

export function alignmentNote(alignment: Alignment): string {
  return noteOf(ALIGNMENTS, alignment);
}

export function timingNote(timing: Timing): string {
  return noteOf(TIMINGS, timing);
}

function noteOf<T extends string>(words: readonly NotedWord<T>[], value: T): string {
  return words.find((word) => word.value === value)?.note ?? "";
}

export function alignmentWord(alignment: Alignment): string {
  return ALIGNMENTS.find((word) => word.value === alignment)?.label ?? alignment;
}
