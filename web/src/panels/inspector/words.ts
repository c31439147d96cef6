import type { Alignment, Join, MethodName, Order, Timing } from "../../document/scene";

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
];

export const ORDERS: readonly Word<Order>[] = [
  { value: "eigenvalue", label: "Eigenvalue" },
  { value: "greedy", label: "Greedy" },
  { value: "maxmin", label: "Max-min" },
  { value: "hungarian", label: "Hungarian" },
];

export const ALIGNMENTS: readonly Word<Alignment>[] = [
  { value: "none", label: "None" },
  { value: "pca", label: "PCA" },
  { value: "procrustes", label: "Procrustes" },
];

export const TIMINGS: readonly Word<Timing>[] = [
  { value: "smooth", label: "Smooth" },
  { value: "linear", label: "Linear" },
  { value: "even", label: "Even" },
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

export function alignmentWord(alignment: Alignment): string {
  return ALIGNMENTS.find((word) => word.value === alignment)?.label ?? alignment;
}
