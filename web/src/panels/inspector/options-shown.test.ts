import { expect, test } from "vitest";
import { DEFAULT_SEGMENT } from "../../document/defaults";
import type { Choice, MethodName, Segment } from "../../document/scene";
import { optionsShown, takenOver } from "./options-shown";

const auto: Segment = { ...DEFAULT_SEGMENT, method: "auto", order: "greedy", alignment: "pca", sharing: 0.5 };
const took = (method: MethodName): Choice => ({ method, order: "hungarian", alignment: "procrustes", sharing: 0 });

test("under auto the options read what auto took", () => {
  expect(optionsShown(auto, took("spectral"))).toMatchObject({
    order: "hungarian",
    alignment: "procrustes",
    sharing: 0,
  });
});

test("an option that auto's method does not use reads as the person left it", () => {
  expect(optionsShown(auto, took("polar"))).toMatchObject({ order: "greedy", alignment: "procrustes", sharing: 0.5 });
});

test("a method shows no option that it does not listen to", () => {
  const heard = (method: MethodName) => {
    const { hasOrder, hasAlignment, hasSharing, hasKeepSize } = optionsShown({ ...auto, method }, null);
    return [hasOrder, hasAlignment, hasSharing, hasKeepSize];
  };
  expect(heard("linear")).toEqual([false, false, false, false]);
  expect(heard("polar")).toEqual([false, true, false, false]);
  expect(heard("shared")).toEqual([false, true, false, true]);
  expect(heard("spectral")).toEqual([true, true, true, true]);
});

test("changing an option under auto takes over what auto took", () => {
  expect(takenOver(auto, took("spectral"), { sharing: 0.3 })).toEqual({ ...took("spectral"), sharing: 0.3 });
});

test("changing the alignment keeps the method that listens to it, an order asks for spectral", () => {
  expect(takenOver(auto, took("polar"), { alignment: "none" })).toMatchObject({ method: "polar", alignment: "none" });
  expect(takenOver(auto, took("polar"), { order: "maxmin" })).toMatchObject({ method: "spectral", order: "maxmin" });
});

test("a method of one's own keeps every other option", () => {
  expect(takenOver({ ...auto, method: "spectral" }, null, { order: "maxmin" })).toEqual({ order: "maxmin" });
});
